"""Edges keep their direction and length: the gentlest guard against collapse."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, points_of
from solver.terms.stencils import OnEdges

_DIFFERENCE = np.hstack([-np.eye(3), np.eye(3)])


@dataclass(frozen=True, eq=False)
class EdgeVectors(OnEdges):
    """Change of each edge vector against a reference shape.

        r = (v_j - v_i) - (v_j - v_i at rest)

    Three rows an edge; ``edges`` is (n, 2), ``rest`` the flat vector of the reference. Linear.
    """

    rest: FloatArray
    name: str = "edge vectors"
    linear: bool = True

    @property
    def size(self) -> Size:
        """Three equations an edge."""
        return Size(0, 3 * len(self.edges))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 3) and (n, 3, 6)."""
        v = points_of(x - self.rest, self.unknowns)
        return Linearisation(
            v[:, 1] - v[:, 0], np.broadcast_to(_DIFFERENCE, (len(self.edges), 3, 6))
        )
