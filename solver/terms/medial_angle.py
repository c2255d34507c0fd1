"""Angle between the medial lines of a face, given or the same for all."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.angles import cosines
from solver.terms.base import Linearisation, coordinates_of, points_of
from solver.terms.stencils import OnFaces


@dataclass(frozen=True, eq=False)
class MedialAngle(OnFaces):
    """The lines through midpoints of opposite edges meet at a given angle, or at a free one.

        r = cos(m1, m2) - cos(angle),   m1 = v2 + v3 - v1 - v4,   m2 = v3 + v4 - v1 - v2

    One row a face; ``faces`` is (n, 4), ``angle`` in radians. A right angle is orthogonality. With
    ``shared``, the position in the flat vector of one unknown angle of all faces, that is meant.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, lemma 4 and the remark
    after it.
    """

    angle: float = np.pi / 2
    shared: int | None = None
    name: str = "medial angle"
    linear: bool = False

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 12) coordinates of the corners, or (n, 13) with the shared angle last."""
        coordinates = coordinates_of(self.faces)
        if self.shared is None:
            return coordinates
        shared = np.full((len(self.faces), 1), self.shared, dtype=np.int64)
        return np.hstack([coordinates, shared])

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 12), with a shared angle (n, 1, 13)."""
        v = points_of(x, self.unknowns[:, :12])
        first = v[:, 1] + v[:, 2] - v[:, 0] - v[:, 3]
        second = v[:, 2] + v[:, 3] - v[:, 0] - v[:, 1]
        cosine, by_first, by_second = cosines(first, second)
        plus, minus = by_first + by_second, by_first - by_second
        by_corners = [-plus, minus, plus, -minus]
        angle = self.angle
        if self.shared is not None:
            angle = float(x[self.shared])
            by_corners.append(np.full((len(v), 1), np.sin(angle)))
        jacobian = np.concatenate(by_corners, axis=1)
        return Linearisation((cosine - np.cos(angle))[:, None], jacobian[:, None, :])
