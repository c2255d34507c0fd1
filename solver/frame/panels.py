"""Panels that stiffen a frame against shear: springs on the difference of their two diagonals.

Where a panel stretches evenly both diagonals change alike, so it takes no part of that: it carries
shear in its plane and nothing else, however far the frame moves and turns.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, row_lengths

# Ends of the two diagonals among the corners.
_DIAGONALS = ((0, 2), (1, 3))


@dataclass(frozen=True, eq=False)
class ShearPanels:
    """Shear panels between four nodes each.

    Args:
        corners: (P, 4) nodes, in order around.
        stiffness: (P,) force along each diagonal for a unit by which one of them has become longer
            than the other.
    """

    corners: IntArray = field(default_factory=lambda: np.empty((0, 4), dtype=np.int64))
    stiffness: FloatArray = field(default_factory=lambda: np.empty(0))

    @classmethod
    def of_shear(cls, nodes: FloatArray, corners: IntArray, stiffness: float) -> ShearPanels:
        """Panels of a shear stiffness G t each, by their size.

        A rectangle a x b with diagonals d is sheared by q along a as G t asks where the spring has
        G t d2 / (4 a b); of other quads the area and the mean square of the diagonals count.

        Args:
            nodes: (N, 3) positions.
            corners: (P, 4) nodes of the panels.
            stiffness: G t, force by length.
        """
        one, two = (nodes[corners[:, b]] - nodes[corners[:, a]] for a, b in _DIAGONALS)
        area = 0.5 * row_lengths(np.cross(one, two))
        square = 0.5 * ((one**2).sum(axis=1) + (two**2).sum(axis=1))
        return cls(corners, stiffness * square / (4 * area))

    def forces(self, nodes: FloatArray, moved: FloatArray) -> FloatArray:
        """(P, 12) forces with which panels resist at their corners.

        Args:
            nodes: (N, 3) where nodes were, free of stress.
            moved: (N, 3) how far they have moved, any distance.
        """
        slope = self.slopes(nodes + moved)
        return np.asarray((self.stiffness * self.sheared(nodes, moved))[:, None] * slope)

    def sheared(self, nodes: FloatArray, moved: FloatArray) -> FloatArray:
        """(P,) by how much the first diagonal has become longer than the second."""
        now, then = (self._lengths(points) for points in (nodes + moved, nodes))
        return np.asarray((now[0] - then[0]) - (now[1] - then[1]))

    def sheared_a_little(self, nodes: FloatArray, moved: FloatArray) -> FloatArray:
        """(P,) the same for movements so small that it is in proportion to them."""
        slope = self.slopes(nodes)
        return np.asarray((slope * moved[self.corners].reshape(-1, 12)).sum(axis=1))

    def shear_flows(self, nodes: FloatArray, moved: FloatArray) -> FloatArray:
        """(P,) shear by the length of the sides under small movements, as in a rectangle."""
        sides = [nodes[self.corners[:, (k + 1) % 4]] - nodes[self.corners[:, k]] for k in range(4)]
        a, b = (0.5 * (row_lengths(sides[k]) + row_lengths(sides[k + 2])) for k in (0, 1))
        # The spring's force has a part a / d along the side a, to both sides of each diagonal.
        force = self.stiffness * self.sheared_a_little(nodes, moved)
        return np.asarray(2 * force / np.hypot(a, b))

    def elastic(self, nodes: FloatArray) -> FloatArray:
        """(P, 12, 12) stiffness at the nodes' own places."""
        slope = self.slopes(nodes)
        return np.asarray(self.stiffness[:, None, None] * slope[:, :, None] * slope[:, None, :])

    def geometric(self, nodes: FloatArray, longer: FloatArray) -> FloatArray:
        """(P, 12, 12) what the forces add to the stiffness.

        Args:
            nodes: (N, 3) where the nodes are.
            longer: (P,) by how much the first diagonal has become longer than the second.
        """
        result = np.zeros((len(self.corners), 4, 3, 4, 3))
        for sign, (a, b) in zip((1.0, -1.0), _DIAGONALS, strict=True):
            unit, length = self._unit(nodes, a, b)
            across = np.eye(3) - unit[:, :, None] * unit[:, None, :]
            block = (sign * self.stiffness * longer / length)[:, None, None] * across
            for one, other, way in ((a, a, 1), (b, b, 1), (a, b, -1), (b, a, -1)):
                result[:, one, :, other, :] += way * block
        return result.reshape(-1, 12, 12)

    def tangent(self, nodes: FloatArray, moved: FloatArray) -> FloatArray:
        """(P, 12, 12) derivative of the forces."""
        longer = self.sheared(nodes, moved)
        return self.elastic(nodes + moved) + self.geometric(nodes + moved, longer)

    def slopes(self, points: FloatArray) -> FloatArray:
        """(P, 12) derivative of the first diagonal's length less the second's by the corners."""
        slope = np.zeros((len(self.corners), 4, 3))
        for sign, (a, b) in zip((1.0, -1.0), _DIAGONALS, strict=True):
            unit, _ = self._unit(points, a, b)
            slope[:, a], slope[:, b] = -sign * unit, sign * unit
        return slope.reshape(-1, 12)

    def _unit(self, points: FloatArray, a: int, b: int) -> tuple[FloatArray, FloatArray]:
        way = points[self.corners[:, b]] - points[self.corners[:, a]]
        length = row_lengths(way)
        return way / length[:, None], length

    def _lengths(self, points: FloatArray) -> list[FloatArray]:
        return [self._unit(points, a, b)[1] for a, b in _DIAGONALS]
