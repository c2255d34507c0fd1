"""A barrier that keeps edges from collapsing and is silent while none is near."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, length, points_of
from solver.terms.stencils import OnEdges


@dataclass(frozen=True, eq=False)
class EdgeGuard(OnEdges):
    """One-sided: edges shorter than a limit are pushed back, longer ones feel nothing.

        r = max(0, limit / |v_j - v_i| - 1)

    One row an edge; ``edges`` is (n, 2), ``limit`` in mean edges.
    """

    limit: float
    name: str = "edge guard"
    linear: bool = False

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 6)."""
        v = points_of(x, self.unknowns)
        d = v[:, 1] - v[:, 0]
        size = np.maximum(length(d), 1e-12)
        residual = np.maximum(0.0, self.limit / size - 1.0)
        by_end = np.where(residual > 0, -self.limit / size**3, 0.0)[:, None] * d
        return Linearisation(residual[:, None], np.hstack([-by_end, by_end])[:, None, :])
