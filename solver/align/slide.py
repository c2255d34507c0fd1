"""Vertices slid along a surface until faces are as flat and right-angled as it lets them be.

A map follows directions that were smoothed, most of all near the border and beside places where the
surface is round. On the surface each vertex has two ways to go, and each face two equations: equal
diagonals, and diagonals that meet. A few Gauss-Newton steps in the tangent planes meet them, as far
as the lines stay as even as they were; after each, vertices are set back onto the surface.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csr_array, diags_array, eye_array, kron, vstack
from scipy.sparse.linalg import spsolve
from scipy.spatial import cKDTree

from solver.align.triangle_mesh import TriangleMesh
from solver.analysis.measures import edge_ratio, flipped, smoothness
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# How much more flat faces count than right angles: a surface bends little within a face.
_FLAT = 20.0
# How much it counts that neighbours move alike, and that motions change evenly along lines: the
# next ones where edges would get too short or lines less even. Without the second, lines take on
# the facets of the surface.
_ALIKE = ((0.03, 0.1), (0.05, 0.2), (0.1, 0.2), (0.2, 0.2), (0.4, 0.4))
# How much it counts that a vertex stays; and one of a face at an irregular vertex, where the lines
# of a smooth net do not cross at right angles.
_STAYS, _SINGULAR = 0.01, 0.5
# And that vertices at the border of the net stay along lines across it: it goes on overhanging.
_RIM = 0.05
_STEPS = 3
# The shortest edge may become no shorter than this part of what it was.
_KEPT = 0.85
# Lines that bend less evenly (``smoothness``) are left to the optimisation, which evens them out;
# right angles would keep them as they are.
_EVEN = 0.25
# As much of their evenness may be lost.
_LOST = 0.05
# In edges, how near to a surface a vertex is on it, and to a line.
_ON, _HELD = 1e-6, 1e-2
# Points of a surface whose normals make that of a vertex.
_AROUND = 3


def slid(net: QuadMesh, surface: TriangleMesh, lines: IntArray) -> QuadMesh:
    """Make a net along curvature more exact without leaving its surface.

    Args:
        net: quads, all along lines of curvature, more or less.
        surface: on which they are; vertices beyond it keep to its tangent planes.
        lines: (L, 2) numbers of points of the surface: vertices on these edges stay.

    Returns:
        the net with other places; as it was, where its edges would get too short or faces fold, or
        where its lines are not even or would be so no longer.
    """
    even = smoothness(net)
    if even < _EVEN:
        return net
    slide = _Slide.of(net, surface, lines)
    least, folded = _KEPT * edge_ratio(net), int(flipped(net).sum())
    for alike in _ALIKE:
        moved = slide.moved(*alike)
        sound = edge_ratio(moved) >= least and int(flipped(moved).sum()) <= folded
        if sound and smoothness(moved) >= even - _LOST:
            return moved
    return net


@dataclass(frozen=True, eq=False)
class _Slide:
    """What moves where.

    Attributes:
        net: at its start.
        surface: where closest points are.
        normals: (P, 3) of its vertices.
        on: (V,) which vertices are on it, and neither beyond nor held.
        stays: (V,) how much it counts that a vertex stays.
        regular: (F,) faces without irregular vertices.
    """

    net: QuadMesh
    surface: TriangleSurface
    normals: FloatArray
    on: BoolArray
    stays: FloatArray
    regular: BoolArray

    @classmethod
    def of(cls, net: QuadMesh, surface: TriangleMesh, lines: IntArray) -> _Slide:
        """Find what is on the surface, and what has to stay."""
        edge, places = net.mean_edge, net.vertices
        irregular = ~net.connectivity.regular & ~net.connectivity.boundary_vertices
        regular = np.asarray(~irregular[net.faces].any(axis=1))
        stays = np.full(len(places), _STAYS)
        stays[net.faces[~regular]] = _SINGULAR
        # They stand where the surface is round, or where they were wanted.
        stays[irregular] = np.inf
        if len(lines):
            held = TriangleSurface(surface.points, lines[:, [0, 1, 1]])
            near = np.linalg.norm(held.closest(places)[0] - places, axis=1)
            stays[near < _HELD * edge] = np.inf
        ground = TriangleSurface(surface.points, surface.triangles)
        off = np.linalg.norm(ground.closest(places)[0] - places, axis=1)
        on = np.asarray((off < _ON * edge) & np.isfinite(stays))
        return cls(net, ground, surface.vertex_normals, on, stays, regular)

    def moved(self, alike: float, even: float) -> QuadMesh:
        """The net after some steps.

        Args:
            alike: how much it counts that neighbours move alike,
            even: and that motions change evenly along lines.
        """
        net, edge = self.net, self.net.mean_edge
        free = np.flatnonzero(np.isfinite(self.stays))
        count = len(net.vertices)
        apart = _differences(net.connectivity.edges, (1.0, -1.0), count)
        bends = _differences(net.connectivity.line_triples, (1.0, -2.0, 1.0), count)
        stays = np.where(np.isfinite(self.stays), self.stays, 0.0)
        held = vstack([alike * apart, even * bends, diags_array(stays)]) / edge
        motion = vstack([kron(held, eye_array(3)), _RIM / edge * self._across_border()])
        places = net.vertices.copy()
        for _ in range(_STEPS):
            tangents = self._tangents(places)
            spread = _spread(tangents[free], free, count)
            value, slope = _equations(places, net.faces, self.regular)
            value = np.concatenate([value, motion @ (places - net.vertices).ravel()])
            matrix = vstack([slope, motion]) @ spread
            step = spsolve((matrix.T @ matrix).tocsc(), -(matrix.T @ value))
            places = places + (spread @ step).reshape(-1, 3)
            places[self.on] = self.surface.closest(places[self.on])[0]
        return net.with_vertices(places)

    def _across_border(self) -> csr_array:
        """(B, 3 V) how far vertices at the border of the net move across it."""
        net, loops = self.net, self.net.connectivity.boundary_loops
        along = [np.roll(loop, -1) for loop in loops], [np.roll(loop, 1) for loop in loops]
        rim, after, before = (np.concatenate(part) for part in (loops, *along))
        across = net.vertices[after] - net.vertices[before]
        across = unit_rows(np.cross(across, net.vertex_normals[rim]))
        row, column = np.repeat(np.arange(len(rim)), 3), 3 * rim[:, None] + np.arange(3)
        shape = (len(rim), net.vertices.size)
        return csr_array(coo_array((across.ravel(), (row, column.ravel())), shape=shape))

    def _tangents(self, places: FloatArray) -> FloatArray:
        """(V, 2, 3) two directions in the tangent plane at each place."""
        far, near = cKDTree(self.surface.vertices).query(places, k=_AROUND)
        weight = 1 / (far + _ON * self.net.mean_edge)
        up = unit_rows((weight[:, :, None] * self.normals[near]).sum(axis=1))
        first = unit_rows(np.cross(up, np.eye(3)[np.argmin(np.abs(up), axis=1)]))
        return np.stack([first, np.cross(up, first)], axis=1)


def _differences(groups: IntArray, factors: tuple[float, ...], count: int) -> csr_array:
    """(N, count) sums of N groups (N, k) of vertices, each with its factor."""
    row = np.repeat(np.arange(len(groups)), len(factors))
    value = np.tile(factors, len(groups))
    return csr_array(coo_array((value, (row, groups.ravel())), shape=(len(groups), count)))


def _spread(tangents: FloatArray, free: IntArray, count: int) -> csr_array:
    """(3 count, 2 N) from motions of free vertices along their two tangents to coordinates."""
    row = np.broadcast_to((3 * free[:, None] + np.arange(3))[:, None], tangents.shape)
    column = 2 * np.arange(len(free))[:, None, None] + np.arange(2)[:, None]
    column = np.broadcast_to(column, tangents.shape)
    return csr_array(
        coo_array(
            (tangents.ravel(), (row.ravel(), column.ravel())), shape=(3 * count, 2 * len(free))
        )
    )


def _equations(
    places: FloatArray, faces: IntArray, regular: BoolArray
) -> tuple[FloatArray, csr_array]:
    """Right angles (F,) and flatness (F,) of faces, and their derivatives (2 F, 3 V).

    With diagonals c - a and d - b of lengths l and m and mean length n: (l - m) / n, for regular
    faces, and the distance between the diagonals over n. How that changes follows from the points
    where the diagonals are nearest to each other; n is taken as it is.
    """
    a, b, c, d = (places[faces[:, k]] for k in range(4))
    first, second = c - a, d - b
    lengths = np.linalg.norm([first, second], axis=2)
    mean = lengths.mean(axis=0)
    first, second = first / lengths[0, :, None], second / lengths[1, :, None]
    right = np.where(regular, (lengths[0] - lengths[1]) / mean, 0.0)
    turned = np.stack([-first, second, first, -second], axis=1)
    turned *= np.where(regular, 1 / mean, 0.0)[:, None, None]
    across, between = unit_rows(np.cross(first, second)), b - a
    flat = _FLAT * (between * across).sum(axis=1) / mean
    # Nearest points a + s first, b + t second.
    cosine = (first * second).sum(axis=1)
    along, back = (between * first).sum(axis=1), (between * second).sum(axis=1)
    sine = 1 - cosine**2
    s = (along - cosine * back) / sine / lengths[0]
    t = (cosine * along - back) / sine / lengths[1]
    parts = np.stack([s - 1, 1 - t, -s, t], axis=1)
    lifted = _FLAT * parts[:, :, None] * (across / mean[:, None])[:, None]
    count = len(faces)
    row = np.repeat(np.arange(2 * count), 12)
    column = np.tile((3 * faces[:, :, None] + np.arange(3)).reshape(-1), 2)
    slope = coo_array(
        (np.concatenate([turned.ravel(), lifted.ravel()]), (row, column)),
        shape=(2 * count, places.size),
    )
    return np.concatenate([right, flat]), csr_array(slope)
