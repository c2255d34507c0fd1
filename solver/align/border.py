"""The border of a surface inside of what it is carried on by: its edges and how they run."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from solver.align.triangle_mesh import TriangleMesh
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, unit_rows

# A border that turns by more has a corner.
_CORNER = np.radians(50.0)


@dataclass(frozen=True, eq=False)
class Border:
    """Edges of a border.

    Attributes:
        edges: (K,) numbers of inner edges of the mesh.
        along: (K, 3) unit vectors: how the border runs there. Teeth shorter than the span that was
            asked for do not count.
    """

    edges: IntArray
    along: FloatArray

    @classmethod
    def of(cls, mesh: TriangleMesh, inner: int, span: float) -> Border:
        """The border between the first ``inner`` triangles and the others.

        Args:
            mesh: the surface, with its apron.
            inner: how many of its triangles are the surface's own.
            span: length over which the border's direction is taken.
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
        return cls(edges, along)


def _directions(points: FloatArray, span: float) -> FloatArray:
    """(N, 3) direction of a closed polyline at the middle of each of its edges."""
    steps = np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1)
    total = float(steps.sum())
    starts = np.concatenate([[0.0], steps.cumsum()])
    closed = np.concatenate([points, points[:1]])
    reach = min(span, total / 4) / 2

    def at(places: FloatArray) -> FloatArray:
        return np.stack([np.interp(places % total, starts, closed[:, k]) for k in range(3)], axis=1)

    corners = _corners(starts[:-1], total, reach, at)
    middle = (starts[1:] + starts[:-1]) / 2
    low, high = middle - reach, middle + reach
    if len(corners):
        # Directions are taken on one side of a corner.
        round_ = np.concatenate([corners - total, corners, corners + total])
        behind = np.searchsorted(round_, middle)
        low = np.maximum(low, round_[behind - 1])
        high = np.minimum(high, round_[behind])
    return unit_rows(at(high) - at(low))


def _corners(
    places: FloatArray, total: float, reach: float, at: Callable[[FloatArray], FloatArray]
) -> FloatArray:
    """Which of the places (N,) along a closed polyline are corners: where it turns most."""
    here = at(places)
    came, goes = unit_rows(here - at(places - reach)), unit_rows(at(places + reach) - here)
    turn = np.arccos(np.clip((came * goes).sum(axis=1), -1, 1))
    found: list[float] = []
    for k in np.argsort(-turn).tolist():
        if turn[k] < _CORNER:
            break
        apart = np.abs(np.array(found) - places[k])
        if (np.minimum(apart, total - apart) > reach).all():
            found.append(float(places[k]))
    return np.sort(found)
