"""Closeness: vertices stay near given points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size
from solver.terms.stencils import OnVertices


@dataclass(frozen=True, eq=False)
class Closeness(OnVertices):
    """Distance of vertices from target points, in mean edges.

        r = v - target

    Three rows a vertex; ``vertices`` is (n,), ``targets`` (n, 3) in the solver's units. Linear.
    """

    targets: FloatArray
    name: str = "closeness"
    linear: bool = True

    @property
    def size(self) -> Size:
        """Three equations a vertex."""
        return Size(0, 3 * len(self.vertices))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 3) and (n, 3, 3)."""
        identity = np.broadcast_to(np.eye(3), (len(self.vertices), 3, 3))
        return Linearisation(x[self.unknowns] - self.targets, identity)
