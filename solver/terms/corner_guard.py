"""A barrier that keeps faces from turning into triangles and is silent while none is near."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.angles import angles
from solver.terms.base import Linearisation, Size, points_of
from solver.terms.stencils import OnFaces


@dataclass(frozen=True, eq=False)
class CornerGuard(OnFaces):
    """One-sided: corners of faces stay neither sharp nor straight.

        r = max(0, |angle - pi / 2| - limit)

    Four rows a face; ``faces`` is (n, 4), ``limits`` (n, 4) in radians, see :meth:`of`.
    """

    limits: FloatArray
    name: str = "corner guard"
    linear: bool = False

    @classmethod
    def of(cls, faces: IntArray, points: FloatArray, slant: float) -> CornerGuard:
        """Corners that are farther from upright than ``slant`` already may stay so."""
        slants = np.abs(_corners(points[faces])[0] - 0.5 * np.pi)
        return cls(faces, np.maximum(slants, slant))

    @property
    def size(self) -> Size:
        """Four equations a face."""
        return Size(0, 4 * len(self.faces))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 4) and (n, 4, 12)."""
        v = points_of(x, self.unknowns)
        angle, by_next, by_last = _corners(v)
        off = angle - 0.5 * np.pi
        residual = np.maximum(0.0, np.abs(off) - self.limits)
        sign = np.where(residual > 0, np.sign(off), 0.0)[..., None]
        jacobian = np.zeros((len(v), 4, 4, 3))
        for corner in range(4):
            by_one, by_two = (
                sign[:, corner] * by_next[:, corner],
                sign[:, corner] * by_last[:, corner],
            )
            jacobian[:, corner, (corner + 1) % 4] = by_one
            jacobian[:, corner, corner - 1] = by_two
            jacobian[:, corner, corner] = -(by_one + by_two)
        return Linearisation(residual, jacobian.reshape(len(v), 4, 12))


def _corners(v: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """(n, 4) angles of (n, 4, 3) corners; derivatives by the edges to the next and the last."""
    return angles(np.roll(v, -1, axis=1) - v, np.roll(v, 1, axis=1) - v)
