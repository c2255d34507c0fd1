"""Where a mesh meets itself without being joined: vertices at one place, or on another's edge."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from solver.mesh.connectivity import IntArray
from solver.mesh.merge import merged
from solver.mesh.quadmesh import FloatArray, QuadMesh

# What is nearer than this part of the mesh's size meets: files are written with so many digits.
MEETING = 1e-5
# Vertices further apart than this part of the shortest edge there stay two: none can take both ends
# of an edge, so that no face collapses.
_OF_EDGE = 0.45


@dataclass(frozen=True, eq=False)
class Seams:
    """What meets and is not joined.

    Attributes:
        pairs: (K, 2) border vertices at the same place, the smaller number first.
        junctions: (J, 3) a border vertex and the ends of the border edge that it lies on.
        doubles: (D, 2) faces at the same place, the smaller number first.
        apart: (K,) distances of the pairs, as parts of the mesh's size.
    """

    pairs: IntArray
    junctions: IntArray
    doubles: IntArray
    apart: FloatArray

    def remarks(self) -> list[str]:
        """What is to be said about them and done, in plain words; nothing where nothing meets."""
        said = []
        if len(self.doubles):
            two, one = self.doubles[0].tolist()
            said.append(
                f"{_lie(len(self.doubles), 'face')} on another (first: faces {two} and {one}); "
                f"{self._weld()} leaves one of each"
            )
        elif len(self.pairs):
            one, two = self.pairs[0].tolist()
            count = len(np.unique(self.pairs))
            said.append(
                f"{count} border vertices lie where another does without being joined (first: "
                f"{one} and {two}), the net comes apart there; {self._weld()} joins them"
            )
        if len(self.junctions):
            vertex, start, end = self.junctions[0].tolist()
            said.append(
                f"{_lie(len(np.unique(self.junctions[:, 0])), 'border vertex', 'border vertices')} "
                f"on the edge of a face without being joined to it (first: {vertex} on edge "
                f"{start} - {end}), the net comes apart there; give both sides the same vertices: "
                "split that face, or refine its side with 'subdivide'"
            )
        return said

    def opened(self, start: QuadMesh, end: QuadMesh) -> float:
        """How far apart they are after the vertices have moved, in mean edges of the start."""
        points = end.vertices
        gaps = [points[self.pairs[:, 0]] - points[self.pairs[:, 1]]]
        vertex, one, two = (points[self.junctions[:, k]] for k in range(3))
        gaps.append(vertex - _feet(vertex, one, two))
        distances = np.linalg.norm(np.concatenate(gaps), axis=1)
        return float(distances.max(initial=0.0)) / start.mean_edge

    def _weld(self) -> str:
        """The command that joins all pairs."""
        widest = max(float(self.apart.max(initial=0.0)), 1e-9)
        digit = 10.0 ** math.floor(math.log10(widest))
        return f"'weld --tolerance {math.ceil(widest / digit * 1.001) * digit:.0e}' (FreeCAD: Weld)"


def seams(mesh: QuadMesh) -> Seams:
    """Find where borders meet within 1e-5 of the mesh's size without being joined."""
    net, points = mesh.connectivity, mesh.vertices
    reach = _reach(points, net.edges, MEETING)
    pairs, distances = _pairs(points, reach)
    rim = net.boundary_vertices[pairs].all(axis=1)
    used = points[net.referenced]
    size = float(np.linalg.norm(used.max(axis=0) - used.min(axis=0)))
    return Seams(
        pairs[rim],
        _junctions(mesh, reach),
        np.zeros((0, 2), np.int64) if net.mixed else _doubles(mesh.faces, pairs, len(points)),
        distances[rim] / size,
    )


def meeting(vertices: FloatArray, faces: IntArray, part: float) -> IntArray:
    """(K, 2) vertices of faces (F, 4) that are the same within a part of the size of the whole."""
    sides = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
    return _pairs(vertices, _reach(vertices, sides, part))[0]


def _reach(vertices: FloatArray, edges: IntArray, part: float) -> FloatArray:
    """(V,) how near other vertices are the same, by the size and the edges there; -1: no face."""
    shortest = np.full(len(vertices), np.inf)
    length = np.linalg.norm(vertices[edges[:, 1]] - vertices[edges[:, 0]], axis=1)
    for k in (0, 1):
        np.minimum.at(shortest, edges[:, k], length)
    used = np.isfinite(shortest)
    low, high = vertices[used].min(axis=0), vertices[used].max(axis=0)
    size = float(np.linalg.norm(high - low))
    return np.where(used, np.minimum(part * size, _OF_EDGE * shortest), -1.0)


def _pairs(vertices: FloatArray, reach: FloatArray) -> tuple[IntArray, FloatArray]:
    """(K, 2) vertices within reach of each other, ascending, and (K,) their distances."""
    used = np.flatnonzero(reach >= 0)
    tree = cKDTree(vertices[used])
    pairs = used[np.sort(tree.query_pairs(float(reach.max()), output_type="ndarray"), axis=1)]
    apart = np.linalg.norm(vertices[pairs[:, 0]] - vertices[pairs[:, 1]], axis=1)
    near = apart <= reach[pairs].min(axis=1)
    order = np.lexsort(pairs[near].T[::-1])
    return pairs[near][order], apart[near][order]


def _junctions(mesh: QuadMesh, reach: FloatArray) -> IntArray:
    """(J, 3) border vertices between the ends of another face's border edge, and these ends."""
    net, points = mesh.connectivity, mesh.vertices
    edges = net.edges[net.boundary_edges]
    rim = np.flatnonzero(net.boundary_vertices)
    if not len(rim):
        return np.zeros((0, 3), dtype=np.int64)
    start, end = points[edges[:, 0]], points[edges[:, 1]]
    radius = 0.5 * np.linalg.norm(end - start, axis=1) + reach[rim].max()
    near = cKDTree(points[rim]).query_ball_point(0.5 * (start + end), radius)
    edge = np.repeat(np.arange(len(edges)), [len(found) for found in near])
    vertex = rim[np.concatenate([np.asarray(found, dtype=np.int64) for found in near])]
    ends = edges[edge]
    gap = points[vertex] - _feet(points[vertex], points[ends[:, 0]], points[ends[:, 1]])
    on = np.linalg.norm(gap, axis=1) <= reach[vertex]
    for k in (0, 1):
        apart = np.linalg.norm(points[vertex] - points[ends[:, k]], axis=1)
        on &= apart > np.maximum(reach[vertex], reach[ends[:, k]])
    owner = net.edge_faces[net.boundary_edges].max(axis=1)
    # No corner of the edge's own face lies on it.
    corners = net.half_faces * len(points) + net.half_edges[:, 0]
    on &= ~np.isin(owner[edge] * len(points) + vertex, corners)
    return np.asarray(np.column_stack([vertex, ends])[on])


def _doubles(faces: IntArray, pairs: IntArray, count: int) -> IntArray:
    """(D, 2) faces whose corners are all at the places of those of an earlier face."""
    if not len(pairs):
        return np.zeros((0, 2), dtype=np.int64)
    corners = np.sort(merged(pairs, count)[1][faces], axis=1)
    _, first, same = np.unique(corners, axis=0, return_index=True, return_inverse=True)
    earlier = first[same.ravel()]
    later = np.flatnonzero(earlier != np.arange(len(faces)))
    return np.column_stack([earlier[later], later])


def _feet(points: FloatArray, start: FloatArray, end: FloatArray) -> FloatArray:
    """(N, 3) closest points of one segment a point."""
    along = end - start
    square = np.einsum("ij,ij->i", along, along)
    part = np.einsum("ij,ij->i", points - start, along) / np.where(square > 0, square, 1.0)
    return np.asarray(start + np.clip(part, 0.0, 1.0)[:, None] * along)


def _lie(count: int, noun: str, plural: str = "") -> str:
    return f"1 {noun} lies" if count == 1 else f"{count} {plural or noun + 's'} lie"
