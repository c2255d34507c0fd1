"""E_iso: faces keep the shape they have in a reference mesh."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, dot, points_of
from solver.terms.stencils import OnFaces


@dataclass(frozen=True, eq=False)
class Isometry(OnFaces):
    """Each face keeps both diagonal lengths and the dot product of its diagonals.

        r1 = (|d1|^2 - |D1|^2) / (2 s),   r2 = (|d2|^2 - |D2|^2) / (2 s),
        r3 = (d1 . d2 - D1 . D2) / s,   s = (|D1|^2 + |D2|^2) / 2,
        d1 = v3 - v1,   d2 = v4 - v2,   D the same in the reference

    Three rows a face; ``faces`` is (n, 4), ``reference`` the (V, 3) reference positions in the same
    units as the unknowns.

    Source: Jiang et al. (2021), Using isometries for computational design and fabrication.
    """

    reference: FloatArray
    name: str = "isometry"
    linear: bool = False

    @property
    def size(self) -> Size:
        """Three equations a face."""
        return Size(0, 3 * len(self.faces))

    @cached_property
    def _kept(self) -> tuple[FloatArray, FloatArray]:
        """(n, 3) products of the reference's diagonals, and (n,) their size."""
        v = self.reference[self.faces]
        products = _products(v[:, 2] - v[:, 0], v[:, 3] - v[:, 1])
        return products, 0.5 * (products[:, 0] + products[:, 1])

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 3) and (n, 3, 12)."""
        v = points_of(x, self.unknowns)
        d1, d2 = v[:, 2] - v[:, 0], v[:, 3] - v[:, 1]
        kept, size = self._kept
        scale = np.array([0.5, 0.5, 1.0]) / size[:, None]
        residual = (_products(d1, d2) - kept) * scale
        zero = np.zeros_like(d1)
        by_d1 = np.stack([d1, zero, d2], axis=1) / size[:, None, None]
        by_d2 = np.stack([zero, d2, d1], axis=1) / size[:, None, None]
        return Linearisation(residual, np.concatenate([-by_d1, -by_d2, by_d1, by_d2], axis=2))


def _products(d1: FloatArray, d2: FloatArray) -> FloatArray:
    return np.stack([dot(d1, d1), dot(d2, d2), dot(d1, d2)], axis=1)
