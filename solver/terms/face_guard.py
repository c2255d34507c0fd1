"""A barrier that keeps faces from crossing over and is silent while none is near."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.terms.angles import cosines
from solver.terms.base import Linearisation, Size, points_of
from solver.terms.stencils import OnFaces


@dataclass(frozen=True, eq=False)
class FaceGuard(OnFaces):
    """One-sided: opposite edges of a face keep pointing the same way.

        r1 = max(0, limit - cos(v2 - v1, v3 - v4)),   r2 = max(0, limit - cos(v4 - v1, v3 - v2))

    Two rows a face; ``faces`` is (n, 4). A face whose diagonals are equal may be crossed like a bow
    tie: then one of the cosines is near -1.
    """

    limit: float
    name: str = "face guard"
    linear: bool = False

    @property
    def size(self) -> Size:
        """Two equations a face."""
        return Size(0, 2 * len(self.faces))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 2) and (n, 2, 12)."""
        v = points_of(x, self.unknowns)
        one = np.stack([v[:, 1] - v[:, 0], v[:, 3] - v[:, 0]], axis=1)
        two = np.stack([v[:, 2] - v[:, 3], v[:, 2] - v[:, 1]], axis=1)
        cosine, by_one, by_two = cosines(one, two)
        near = (cosine < self.limit)[..., None]
        by_one, by_two = np.where(near, -by_one, 0.0), np.where(near, -by_two, 0.0)
        jacobian = np.zeros((len(v), 2, 4, 3))
        jacobian[:, :, 0], jacobian[:, :, 2] = -by_one, by_two
        jacobian[:, 0, 1], jacobian[:, 0, 3] = by_one[:, 0], -by_two[:, 0]
        jacobian[:, 1, 3], jacobian[:, 1, 1] = by_one[:, 1], -by_two[:, 1]
        return Linearisation(np.maximum(0.0, self.limit - cosine), jacobian.reshape(len(v), 2, 12))
