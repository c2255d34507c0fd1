"""Places of vertices that no triangle has: how the map goes on beyond the surface."""

from __future__ import annotations

import numpy as np

from solver.align.cells import Quads, transitions
from solver.align.cut import Cut
from solver.align.seamless import GRID, Map
from solver.align.seams import TURNS
from solver.align.triangle_mesh import TriangleMesh
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# How far round a vertex, in edges of the net, the surface is looked at.
_REACH = 2.2
# Exponents of the polynomial, and how much each is held down.
_POWERS = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)]
_HELD = 1e-3 * np.array([0, *[1e-6] * 2, *[1e-3] * 3, *[1e-2] * 4])


def carried_on(mesh: TriangleMesh, cut: Cut, made: Map, found: Quads) -> FloatArray:
    """Places (V, 3) of all vertices of a net.

    Those beyond the triangles come from a polynomial in the map's coordinates, fitted to the points
    of the surface that are near in the map.
    """
    places = found.places.copy()
    chart = _Chart(mesh, cut, made)
    for vertex in np.flatnonzero(found.beyond).tolist():
        points, coordinates = chart.near(
            int(found.triangles[vertex]), found.coordinates[vertex] / GRID
        )
        places[vertex] = _value_at_zero(coordinates, points)
    return places


class _Chart:
    """The map unrolled round a place, over its cut."""

    def __init__(self, mesh: TriangleMesh, cut: Cut, made: Map) -> None:
        self._points, self._triangles = mesh.points, mesh.triangles
        self._corners = made.corners / GRID
        self._shift = transitions(mesh, cut, made.corners) / GRID
        self._turns = cut.turns
        self._edge = np.full(len(mesh.twins), -1)
        self._edge[mesh.edges[:, 0]] = self._edge[mesh.edges[:, 1]] = np.arange(len(mesh.edges))
        self._first = mesh.edges[:, 0]
        self._twins = mesh.twins

    def near(self, seed: int, target: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Points (N, 3) and their coordinates (N, 2) from the target, in the seed's chart.

        Triangles are looked at in rings round the seed, each ring at once: there are thousands.
        """
        reach = float(np.linalg.norm(self._corners[seed] - target, axis=1).min()) + _REACH
        seen = np.zeros(len(self._triangles), dtype=bool)
        seen[seed] = True
        ring, turn, shift = np.array([seed]), np.eye(2)[None], np.zeros((1, 2))
        vertices, places = [], []
        while len(ring):
            local = self._corners[ring] @ turn.transpose(0, 2, 1) + shift[:, None] - target
            close = np.linalg.norm(local, axis=2) < reach
            vertices.append(self._triangles[ring][close])
            places.append(local[close])
            on = close.any(axis=1)
            ring, turn, shift = self._next_ring(ring[on], turn[on], shift[on], seen)
            seen[ring] = True
        # Round a singular vertex charts differ: a vertex is where it was first met.
        found, coordinates = np.concatenate(vertices), np.concatenate(places)
        first = np.sort(np.unique(found, return_index=True)[1])
        return self._points[found[first]], coordinates[first]

    def _next_ring(
        self, ring: IntArray, turn: FloatArray, shift: FloatArray, seen: BoolArray
    ) -> tuple[IntArray, FloatArray, FloatArray]:
        """Neighbours not seen yet (N,), turns (N, 2, 2) and shifts (N, 2) of their charts."""
        half = (3 * ring[:, None] + np.arange(3)).ravel()
        over = np.repeat(np.arange(len(ring)), 3)
        other = self._twins[half] // 3
        new = np.flatnonzero((self._twins[half] >= 0) & ~seen[other])
        new = new[np.sort(np.unique(other[new], return_index=True)[1])]
        half, over, other = half[new], over[new], other[new]
        edge = self._edge[half]
        by, step = TURNS[self._turns[edge]], self._shift[edge][..., None]
        forth = (self._first[edge] == half)[:, None, None]
        turned = turn[over] @ np.where(forth, by.transpose(0, 2, 1), by)
        moved = np.where(forth, -turned @ step, turn[over] @ step)[..., 0]
        return other, turned, shift[over] + moved


def _value_at_zero(coordinates: FloatArray, points: FloatArray) -> FloatArray:
    reach = float(np.linalg.norm(coordinates, axis=1).max())
    first, second = coordinates.T / reach
    terms = np.stack([first**a * second**b for a, b in _POWERS], axis=1)
    weight = np.exp(-2.25 * (first**2 + second**2))[:, None]
    middle = points.mean(axis=0)
    normal = terms.T @ (weight * terms)
    normal += np.diag(_HELD) * np.trace(normal) / len(_POWERS)
    solved = np.linalg.solve(normal, terms.T @ (weight * (points - middle)))
    value: FloatArray = middle + solved[0]
    return value
