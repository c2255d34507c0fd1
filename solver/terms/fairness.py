"""E_fair: parameter lines bend as little as possible, or as they bent at the start."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, coordinates_of, points_of

_SECOND_DIFFERENCE = np.hstack([-np.eye(3), 2 * np.eye(3), -np.eye(3)])


@dataclass(frozen=True, eq=False)
class Fairness:
    """Second differences along parameter lines.

        r = (2 v - v_left - v_right) - (the same at rest)

    Three rows a triple; ``triples`` is (n, 3) with left, centre, right. Linear. Without ``rest``
    the lines are drawn straight, as in the paper; with ``rest``, the flat vector of a reference
    shape, it is the motion away from that shape that has to be smooth, and the shape's own bends
    cost nothing.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4 (E_fair).
    """

    triples: IntArray
    rest: FloatArray | None = None
    name: str = "fairness"
    linear: bool = True

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 9) coordinates of left, centre, right."""
        return coordinates_of(self.triples)

    @property
    def size(self) -> Size:
        """Three equations a triple."""
        return Size(0, 3 * len(self.triples))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 3) and (n, 3, 9)."""
        v = points_of(x if self.rest is None else x - self.rest, self.unknowns)
        residual = 2 * v[:, 1] - v[:, 0] - v[:, 2]
        return Linearisation(
            residual, np.broadcast_to(_SECOND_DIFFERENCE, (len(self.triples), 3, 9))
        )
