"""Faces that are flat to a length: the largest gap of a panel is bounded, not asked to vanish."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, coordinates_of, length, points_of
from solver.terms.planarity import Planarity
from solver.terms.stencils import Elements

# Part of the limit with which faces that lie beyond it begin.
_INSIDE = 0.9


@dataclass(frozen=True, eq=False)
class FlatWithin(Elements):
    """Distance between the two diagonals of a face, below a limit by an unknown of its own.

        r = g - t / sqrt(1 + (t / limit)^2),   g the distance, signed

    One row a face; ``faces`` is (n, 4), ``slack`` (n,) the positions of the unknowns t in the flat
    vector. Whatever t is, what is taken from g lies between -limit and limit: an inequality as an
    equation that is smooth, so that what moves along nets moves along these. Lengths are in mean
    edges.

    Source: Nocedal, Wright (2006), Numerical Optimization, section 15.3 (elimination by a change of
    variables).
    """

    faces: IntArray
    slack: IntArray
    limit: float
    name: str = "flatness"

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 13) coordinates of the four corners, and the slack."""
        return np.hstack([coordinates_of(self.faces), self.slack[:, None]])

    @property
    def size(self) -> Size:
        """A slack and an equation a face."""
        return Size(len(self.faces), len(self.faces))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 13)."""
        relative = Planarity(self.faces)
        part = relative.linearise(x)
        v = points_of(x, relative.unknowns)
        d1, d2 = v[:, 2] - v[:, 0], v[:, 3] - v[:, 1]
        length_1, length_2 = length(d1), length(d2)
        mean = 0.5 * (length_1 + length_2)[:, None]
        by_d1, by_d2 = 0.5 * d1 / length_1[:, None], 0.5 * d2 / length_2[:, None]
        by_corners = np.hstack([-by_d1, -by_d2, by_d1, by_d2])
        gap = part.residual * mean
        by_gap = part.jacobian[:, 0] * mean + part.residual * by_corners
        t = x[self.slack][:, None]
        root = np.sqrt(1 + (t / self.limit) ** 2)
        return Linearisation(gap - t / root, np.hstack([by_gap, -(root**-3)])[:, None, :])


def slack_of(gaps: FloatArray, limit: float) -> FloatArray:
    """(n,) slacks at which signed distances stand, or the nearest that lie well within the limit.

    At the limit itself a slack would be infinite and could not come back.
    """
    inside = np.clip(gaps / limit, -_INSIDE, _INSIDE)
    return np.asarray(limit * inside / np.sqrt(1 - inside**2))
