"""Circular faces: opposite angles have equal sums."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.terms.angles import angles
from solver.terms.base import Linearisation, Size, points_of
from solver.terms.stencils import OnFaces

_SIGNS = np.array([0.5, -0.5, 0.5, -0.5])


@dataclass(frozen=True, eq=False)
class CircularFace(OnFaces):
    """Sums of opposite angles of a face agree; with a planar face, its corners lie on a circle.

        r = (t1 + t3 - t2 - t4) / 2

    One row a face; ``faces`` is (n, 4).

    Source: Bobenko, Suris (2008), Discrete Differential Geometry, circular nets.
    """

    name: str = "circular"
    linear: bool = False

    @property
    def size(self) -> Size:
        """A circle's centre a face; its four equal distances."""
        return Size(3 * len(self.faces), 4 * len(self.faces))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 12)."""
        v = points_of(x, self.unknowns)
        ahead = np.roll(v, -1, axis=1) - v
        back = np.roll(v, 1, axis=1) - v
        angle, by_ahead, by_back = angles(ahead, back)
        by_ahead *= _SIGNS[:, None]
        by_back *= _SIGNS[:, None]
        jacobian = np.roll(by_ahead, 1, axis=1) + np.roll(by_back, -1, axis=1) - by_ahead - by_back
        return Linearisation((angle @ _SIGNS)[:, None], jacobian.reshape(len(v), 1, 12))
