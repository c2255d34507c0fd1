"""Prescribed angle between the medial lines of a face."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.terms.angles import cosines
from solver.terms.base import Linearisation, points_of
from solver.terms.stencils import OnFaces


@dataclass(frozen=True, eq=False)
class MedialAngle(OnFaces):
    """The lines through midpoints of opposite edges meet at a given angle.

        r = cos(m1, m2) - cos(angle),   m1 = v2 + v3 - v1 - v4,   m2 = v3 + v4 - v1 - v2

    One row a face; ``faces`` is (n, 4), ``angle`` in radians. A right angle is orthogonality.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, lemma 4 and the remark
    after it.
    """

    angle: float
    name: str = "medial angle"
    linear: bool = False

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 12)."""
        v = points_of(x, self.unknowns)
        first = v[:, 1] + v[:, 2] - v[:, 0] - v[:, 3]
        second = v[:, 2] + v[:, 3] - v[:, 0] - v[:, 1]
        cosine, by_first, by_second = cosines(first, second)
        plus, minus = by_first + by_second, by_first - by_second
        jacobian = np.concatenate([-plus, minus, plus, -minus], axis=1)
        return Linearisation((cosine - np.cos(self.angle))[:, None], jacobian[:, None, :])
