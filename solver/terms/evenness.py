"""Evenness: parameter lines bend evenly, however much they bend."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, coordinates_of, points_of

_THIRD_DIFFERENCE = np.hstack([-np.eye(3), 3 * np.eye(3), -3 * np.eye(3), np.eye(3)])


@dataclass(frozen=True, eq=False)
class Evenness:
    """Third differences along parameter lines.

        r = v4 - 3 v3 + 3 v2 - v1

    Three rows a quadruple; ``quadruples`` is (n, 4), consecutive on a line. Linear. Noise costs
    much, a circle nearly nothing: where fairness would unroll a sheet, this leaves it bent.
    """

    quadruples: IntArray
    name: str = "evenness"
    linear: bool = True

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 12) coordinates of the four vertices."""
        return coordinates_of(self.quadruples)

    @property
    def size(self) -> Size:
        """Three equations a quadruple."""
        return Size(0, 3 * len(self.quadruples))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 3) and (n, 3, 12)."""
        v = points_of(x, self.unknowns)
        residual = v[:, 3] - 3 * v[:, 2] + 3 * v[:, 1] - v[:, 0]
        shared = np.broadcast_to(_THIRD_DIFFERENCE, (len(self.quadruples), 3, 12))
        return Linearisation(residual, shared)
