"""A triangle mesh with what a direction field and a map need: half-edges, frames, a border."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike
from scipy.sparse import coo_array
from scipy.sparse.csgraph import breadth_first_order, connected_components

from solver.errors import InputError
from solver.mesh.connectivity import IntArray, cycles
from solver.mesh.quadmesh import FloatArray, unit_rows


def components(count: int, one: IntArray, two: IntArray) -> IntArray:
    """Label (count,) of what is joined by the pairs ``one[k]``, ``two[k]``."""
    graph = coo_array((np.ones(len(one)), (one, two)), shape=(count, count))
    label: IntArray = connected_components(graph, directed=False)[1]
    return label


class TriangleMesh:
    """Triangles that are oriented alike and meet two at an edge, with a frame in each.

    Half-edge ``3 t + k`` runs from corner k of triangle t to the next; corner ``3 t + k`` is where
    it starts.

    Args:
        points: (V, 3) coordinates; every one is used.
        triangles: (T, 3) vertex numbers, oriented alike.

    Attributes:
        twins: (3 T,) the half-edge on the other side, -1 at the border.
        edges: (E, 2) both half-edges of each inner edge.
        rim: half-edges of the border; the surface lies on their left.
        on_rim: (V,) whether a vertex is on the border.
        normals: (T, 3); ``axes`` (T, 2, 3): the frame of each triangle, first along its first edge.
        areas: (T,).
        vertex_normals: (V, 3), weighted by area.
    """

    def __init__(self, points: FloatArray, triangles: IntArray) -> None:
        self.points, self.triangles = points, triangles
        self.half_edges = np.stack([triangles, np.roll(triangles, -1, axis=1)], -1).reshape(-1, 2)
        self.twins, self.edges = _twins(self.half_edges)
        self.rim = np.flatnonzero(self.twins < 0)
        self.on_rim = np.zeros(len(points), dtype=bool)
        self.on_rim[self.half_edges[self.rim].ravel()] = True
        corners = points[triangles]
        first = corners[:, 1] - corners[:, 0]
        crossed = np.cross(first, corners[:, 2] - corners[:, 0])
        self.areas = 0.5 * np.linalg.norm(crossed, axis=1)
        self.normals = unit_rows(crossed)
        along = unit_rows(first)
        self.axes = np.stack([along, np.cross(self.normals, along)], axis=1)
        summed = np.zeros_like(points)
        for k in range(3):
            np.add.at(summed, triangles[:, k], crossed)
        self.vertex_normals = unit_rows(summed)

    @property
    def centres(self) -> FloatArray:
        """(T, 3) means of the corners."""
        middle: FloatArray = self.points[self.triangles].mean(axis=1)
        return middle

    @property
    def ends(self) -> tuple[IntArray, IntArray]:
        """Both vertices of each inner edge, as its first half-edge runs."""
        first = self.half_edges[self.edges[:, 0]]
        return first[:, 0], first[:, 1]

    def next_rim(self) -> dict[int, int]:
        """The vertex that follows each border vertex along the border."""
        run = self.half_edges[self.rim]
        return dict(zip(run[:, 0].tolist(), run[:, 1].tolist(), strict=True))

    def loops(self) -> list[list[int]]:
        """Vertices of each border loop, the surface on its left."""
        return cycles(self.next_rim())

    def gradients(self) -> FloatArray:
        """(T, 3, 2) gradients of the corners' hat functions, in each triangle's frame."""
        corners = self.points[self.triangles]
        found = np.empty((len(self.triangles), 3, 2))
        for k in range(3):
            opposite = corners[:, (k + 2) % 3] - corners[:, (k + 1) % 3]
            height = np.cross(self.normals, opposite) / (2 * self.areas)[:, None]
            found[:, k] = np.einsum("tij,tj->ti", self.axes, height)
        return found


def one_surface(points: ArrayLike, triangles: ArrayLike) -> TriangleMesh:
    """Orient triangles alike and part them where they meet in a vertex only.

    Args:
        points: (V, 3) coordinates.
        triangles: (T, 3) vertex numbers, at most two at an edge.

    Raises:
        InputError: several pieces, a one-sided or a closed surface.
    """
    places = np.asarray(points, dtype=np.float64)
    turned = _oriented(np.asarray(triangles, dtype=np.int64))
    mesh = TriangleMesh(*_parted(places, turned))
    if not len(mesh.rim):
        raise InputError(
            "surface: it is closed, and a net needs a border to run out to; cut it open where a "
            "border may be"
        )
    return mesh


def _twins(half_edges: IntArray) -> tuple[IntArray, IntArray]:
    inverse = np.unique(np.sort(half_edges, axis=1), axis=0, return_inverse=True)[1].ravel()
    order = np.argsort(inverse, kind="stable")
    shared = np.flatnonzero(np.diff(inverse[order]) == 0)
    one, two = order[shared], order[shared + 1]
    twins = np.full(len(half_edges), -1)
    twins[one], twins[two] = two, one
    return twins, np.stack([one, two], axis=1)


def _oriented(triangles: IntArray) -> IntArray:
    """Turn triangles round until neighbours agree; most stay as they are."""
    half_edges = np.stack([triangles, np.roll(triangles, -1, axis=1)], -1).reshape(-1, 2)
    one, two = _twins(half_edges)[1].T
    agree = half_edges[one, 0] != half_edges[two, 0]
    count = len(triangles)
    pieces = components(count, one // 3, two // 3)
    if pieces.max() > 0:
        sizes = np.sort(np.bincount(pieces))[::-1].tolist()
        raise InputError(
            f"surface: {len(sizes)} pieces that are not joined, of {sizes[0]} and {sizes[1]} "
            "triangles and less; weld what belongs together, or give one at a time"
        )
    graph = coo_array((np.ones(len(one)), (one // 3, two // 3)), shape=(count, count)).tocsr()
    order, before = breadth_first_order(graph + graph.T, 0, directed=False)
    same = {
        pair: bool(fits)
        for pair, fits in zip(
            zip((one // 3).tolist(), (two // 3).tolist(), strict=True), agree, strict=True
        )
    }
    flipped = np.zeros(count, dtype=bool)
    for triangle in order[1:].tolist():
        back = int(before[triangle])
        fits = same[(back, triangle) if (back, triangle) in same else (triangle, back)]
        flipped[triangle] = flipped[back] == fits
    if ((flipped[one // 3] == flipped[two // 3]) != agree).any():
        raise InputError("surface: it has one side only; cut it open across the band")
    if 2 * flipped.sum() > count:
        flipped = ~flipped
    return np.where(flipped[:, None], triangles[:, ::-1], triangles)


def _parted(points: FloatArray, triangles: IntArray) -> tuple[FloatArray, IntArray]:
    """Give each fan of triangles round a vertex a vertex of its own."""
    half_edges = np.stack([triangles, np.roll(triangles, -1, axis=1)], -1).reshape(-1, 2)
    one, two = _twins(half_edges)[1].T
    after = following(np.arange(3 * len(triangles)))
    fans = components(
        3 * len(triangles), np.concatenate([one, after[one]]), np.concatenate([after[two], two])
    )
    of_fan = np.empty(fans.max() + 1, dtype=np.int64)
    of_fan[fans] = triangles.ravel()
    return points[of_fan], fans.reshape(-1, 3).astype(np.int64)


def spanning(mesh: TriangleMesh) -> Iterator[tuple[int, int, int, bool]]:
    """A tree of all triangles, from the middle outwards.

    Yields:
        a triangle, the one from which it is reached, the number of the inner edge between them, and
        whether that goes from the edge's first triangle to its second.
    """
    one, two = (mesh.edges // 3).T
    count = len(mesh.triangles)
    graph = coo_array((np.ones(len(one)), (one, two)), shape=(count, count)).tocsr()
    centres = mesh.centres
    middle = int(np.argmin(((centres - centres.mean(axis=0)) ** 2).sum(axis=1)))
    order, before = breadth_first_order(graph + graph.T, middle, directed=False)
    pairs = {pair: edge for edge, pair in enumerate(zip(one.tolist(), two.tolist(), strict=True))}
    for triangle in order[1:].tolist():
        back = int(before[triangle])
        forwards = (back, triangle) in pairs
        edge = pairs[(back, triangle) if forwards else (triangle, back)]
        yield triangle, back, edge, forwards


def following(half_edges: IntArray) -> IntArray:
    """The next half-edge in the same triangle."""
    return half_edges - half_edges % 3 + (half_edges + 1) % 3
