"""Feature lines of a surface, along which a net has to have lines: creases, and its border.

They are edges of the mesh on which the surface is carried on beyond its border.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from solver.align.triangle_mesh import TriangleMesh, components
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, unit_rows

# A border that turns by more has a corner.
_CORNER = np.radians(50.0)
# A surface has a crease where it turns by more at an edge, and by more than so many times what it
# turns by at others.
_CREASE, _OTHERS = np.radians(25.0), 5.0
# In edges of the net, the shortest crease.
_SHORTEST = 2.0
# In edges of the net, how far from a line the net may still be turning to it.
_LAST, _BESIDE = 4.0, 1.5


@dataclass(frozen=True, eq=False)
class Features:
    """Edges of feature lines.

    Attributes:
        edges: (K,) numbers of inner edges of the mesh.
        along: (K, 3) unit vectors: how the line runs there.
        reach: (K,) how far from it, in edges of the net, the net may still be turning to it.
        across: (K,) whether diagonals of the net may run along it in place of lines.
    """

    edges: IntArray
    along: FloatArray
    reach: FloatArray
    across: BoolArray

    @classmethod
    def creases(cls, mesh: TriangleMesh, inner: int, edge: float) -> Features:
        """The creases between the first ``inner`` triangles, for a net with edges of a length."""
        sharp = creased(mesh, edge)
        edges = np.flatnonzero(sharp & (mesh.edges // 3 < inner).all(axis=1))
        start, end = (mesh.points[side[edges]] for side in mesh.ends)
        return cls(edges, unit_rows(end - start), np.full(len(edges), _BESIDE), _none(edges))

    def ends(self, mesh: TriangleMesh) -> IntArray:
        """(K, 2) points at both ends of the edges."""
        return np.stack([side[self.edges] for side in mesh.ends], axis=1)

    def and_others(self, others: Features) -> Features:
        """Both."""
        return Features(
            np.concatenate([self.edges, others.edges]),
            np.concatenate([self.along, others.along]),
            np.concatenate([self.reach, others.reach]),
            np.concatenate([self.across, others.across]),
        )

    @classmethod
    def border(cls, mesh: TriangleMesh, inner: int, span: float) -> Features:
        """The border between the first ``inner`` triangles and the others.

        Args:
            mesh: the surface, with its apron.
            inner: how many of its triangles are the surface's own.
            span: length over which the border's direction is taken; shorter teeth do not count.
        """
        half = mesh.edges // 3
        owned = half < inner
        edges = np.flatnonzero(owned[:, 0] != owned[:, 1])
        own = np.where(owned[edges, 0], mesh.edges[edges, 0], mesh.edges[edges, 1])
        start, end = mesh.half_edges[own].T
        row_from = {vertex: row for row, vertex in enumerate(start.tolist())}
        after = [row_from[vertex] for vertex in end.tolist()]
        along, seen = np.empty((len(edges), 3)), np.zeros(len(edges), dtype=bool)
        for first in range(len(edges)):
            loop: list[int] = []
            row = first
            while not seen[row]:
                seen[row] = True
                loop.append(row)
                row = after[row]
            if loop:
                along[loop] = _directions(mesh.points[start[loop]], span)
        return cls(edges, along, np.full(len(edges), _LAST), _none(edges))


def _none(edges: IntArray) -> BoolArray:
    return np.zeros(len(edges), dtype=bool)


def creased(mesh: TriangleMesh, edge: float) -> BoolArray:
    """(E,) which inner edges are creases.

    Args:
        mesh: the surface.
        edge: edge length of the net; what is shorter than two of them is a dent.
    """
    first, second = (mesh.edges // 3).T
    cosine = (mesh.normals[first] * mesh.normals[second]).sum(axis=1)
    turn = np.arccos(np.clip(cosine, -1, 1))
    sharp = np.flatnonzero(turn > max(_CREASE, _OTHERS * float(np.median(turn))))
    start, end = (side[sharp] for side in mesh.ends)
    label = components(len(mesh.points), start, end)[start]
    lengths = np.linalg.norm(mesh.points[end] - mesh.points[start], axis=1)
    runs = np.bincount(label, lengths, minlength=len(mesh.points))
    found = np.zeros(len(turn), dtype=bool)
    found[sharp] = runs[label] >= _SHORTEST * edge
    return found


def _directions(points: FloatArray, span: float) -> FloatArray:
    """(N, 3) direction of a closed polyline at the middle of each of its edges."""
    starts, at = _walked(points)
    total = float(starts[-1])
    reach = min(span, total / 4) / 2
    corners = starts[corners_of(points, span)]
    middle = (starts[1:] + starts[:-1]) / 2
    low, high = middle - reach, middle + reach
    if len(corners):
        # Directions are taken on one side of a corner.
        round_ = np.concatenate([corners - total, corners, corners + total])
        behind = np.searchsorted(round_, middle)
        low = np.maximum(low, round_[behind - 1])
        high = np.minimum(high, round_[behind])
    return unit_rows(at(high) - at(low))


def _walked(points: FloatArray) -> tuple[FloatArray, Callable[[FloatArray], FloatArray]]:
    """(N + 1,) lengths along a closed polyline up to its points; points at such lengths."""
    steps = np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1)
    starts = np.concatenate([[0.0], steps.cumsum()])
    closed = np.concatenate([points, points[:1]])

    def at(places: FloatArray) -> FloatArray:
        round_ = places % starts[-1]
        return np.stack([np.interp(round_, starts, closed[:, k]) for k in range(3)], axis=1)

    return starts, at


def corners_of(points: FloatArray, span: float) -> IntArray:
    """Which points (N, 3) of a closed polyline are corners: where it turns most.

    Args:
        points: of the polyline.
        span: length over which its direction is taken; shorter teeth do not count.
    """
    starts, at = _walked(points)
    total, places = float(starts[-1]), starts[:-1]
    reach = min(span, total / 4) / 2
    here = at(places)
    came, goes = unit_rows(here - at(places - reach)), unit_rows(at(places + reach) - here)
    turn = np.arccos(np.clip((came * goes).sum(axis=1), -1, 1))
    found: list[int] = []
    for k in np.argsort(-turn).tolist():
        if turn[k] < _CORNER:
            break
        apart = np.abs(places[found] - places[k])
        if (np.minimum(apart, total - apart) > reach).all():
            found.append(k)
    return np.sort(np.array(found, dtype=np.int64))
