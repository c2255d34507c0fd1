"""E_PQ: the four corners of a face lie in a plane."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, dot, length, points_of
from solver.terms.stencils import OnFaces


@dataclass(frozen=True, eq=False)
class Planarity(OnFaces):
    """Distance between the two diagonals of a face, relative to their mean length.

        r = c . n / (|n| s),   c = (v1 + v3 - v2 - v4) / 2,   n = d1 x d2,
        d1 = v3 - v1,   d2 = v4 - v2,   s = (|d1| + |d2|) / 2

    One row a face; ``faces`` is (n, 4). The normal n is a function of the corners, so the normals
    that the paper adds as unknowns, and their unit length constraint, are eliminated.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4.1 (E_PQ) and
    figure 8 (the measure).
    """

    name: str = "planarity"
    linear: bool = False

    @property
    def size(self) -> Size:
        """A normal a face; four edges in the plane and unit length of the normal."""
        return Size(3 * len(self.faces), 5 * len(self.faces))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 12)."""
        v = points_of(x, self.unknowns)
        d1, d2 = v[:, 2] - v[:, 0], v[:, 3] - v[:, 1]
        c = 0.5 * (v[:, 0] + v[:, 2] - v[:, 1] - v[:, 3])
        n = np.cross(d1, d2)
        length_1, length_2, length_n = length(d1), length(d2), length(n)
        s = 0.5 * (length_1 + length_2)
        unit = n / length_n[:, None]
        r = dot(c, unit) / s
        by_c = unit / s[:, None]
        # r changes with n only through the part of c that lies in the plane of the diagonals.
        by_n = (c / s[:, None] - r[:, None] * unit) / length_n[:, None]
        by_d1 = np.cross(d2, by_n) - (0.5 * r / (s * length_1))[:, None] * d1
        by_d2 = np.cross(by_n, d1) - (0.5 * r / (s * length_2))[:, None] * d2
        half = 0.5 * by_c
        jacobian = np.concatenate([half - by_d1, -half - by_d2, half + by_d1, by_d2 - half], axis=1)
        return Linearisation(r[:, None], jacobian[:, None, :])
