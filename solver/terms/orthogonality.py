"""E_ortho: the two diagonals of a face are equally long."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, dot, points_of
from solver.terms.stencils import OnFaces


@dataclass(frozen=True, eq=False)
class Orthogonality(OnFaces):
    """Equal diagonals, relative to their own length so that shrinking a face gains nothing.

        r = (p - q) / (p + q),   p = |v1 - v3|^2,   q = |v2 - v4|^2

    One row a face; ``faces`` is (n, 4). Near zero, r is the relative difference of the lengths.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 3; there the
    difference is not divided by the sum.
    """

    name: str = "orthogonality"
    linear: bool = False

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 12)."""
        v = points_of(x, self.unknowns)
        d1, d2 = v[:, 0] - v[:, 2], v[:, 1] - v[:, 3]
        p, q = dot(d1, d1), dot(d2, d2)
        by_d1 = (4 * q / (p + q) ** 2)[:, None] * d1
        by_d2 = (-4 * p / (p + q) ** 2)[:, None] * d2
        jacobian = np.concatenate([by_d1, by_d2, -by_d1, -by_d2], axis=1)
        return Linearisation(((p - q) / (p + q))[:, None], jacobian[:, None, :])
