"""Places of vertices that no triangle has: how the map goes on beyond the surface."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator

import numpy as np

from solver.align.cells import Quads, transitions
from solver.align.cut import Cut
from solver.align.seamless import GRID, Map
from solver.align.seams import TURNS
from solver.align.triangle_mesh import TriangleMesh
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
        """Points (N, 3) and their coordinates (N, 2) from the target, in the seed's chart."""
        reach = float(np.linalg.norm(self._corners[seed] - target, axis=1).min()) + _REACH
        seen = {seed: (np.eye(2), np.zeros(2))}
        todo, found = deque([seed]), dict[int, FloatArray]()
        while todo:
            triangle = todo.popleft()
            turn, shift = seen[triangle]
            local = self._corners[triangle] @ turn.T + shift - target
            far = np.linalg.norm(local, axis=1)
            for k, vertex in enumerate(self._triangles[triangle].tolist()):
                if far[k] < reach:
                    found.setdefault(vertex, local[k])
            if far.min() < reach:
                for other, turned, shifted in self._neighbours(triangle, turn, shift):
                    if other not in seen:
                        seen[other] = turned, shifted
                        todo.append(other)
        return self._points[list(found)], np.array(list(found.values()))

    def _neighbours(
        self, triangle: int, turn: FloatArray, shift: FloatArray
    ) -> Iterator[tuple[int, FloatArray, FloatArray]]:
        for half in range(3 * triangle, 3 * triangle + 3):
            twin = int(self._twins[half])
            if twin < 0:
                continue
            edge = int(self._edge[half])
            by, step = TURNS[self._turns[edge]], self._shift[edge]
            if self._first[edge] == half:
                back = turn @ by.T
                yield twin // 3, back, shift - back @ step
            else:
                yield twin // 3, turn @ by, shift + turn @ step


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
