"""Points of a mesh that may be so far from a surface and no farther."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, coordinates_of, points_of
from solver.terms.stencils import Elements


@dataclass(frozen=True, eq=False)
class BeyondSurface(Elements):
    """One-sided: what is farther from a triangle surface than a limit is drawn back.

        r = max(0, |d| - limit) sign d,   d = n . (mean(v) - foot)

    One row a group of vertices, for whose mean it counts: ``groups`` is (n, k), of single vertices
    or of the corners of faces. Foot and normal are looked up anew after every step.
    """

    groups: IntArray
    surface: TriangleSurface
    limit: float
    feet: FloatArray | None = None
    normals: FloatArray | None = None
    name: str = "beyond surface"

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 3 k) coordinates of the vertices of each group."""
        return coordinates_of(self.groups)

    def follow(self, x: FloatArray) -> BeyondSurface:
        """Look up the closest points at the current shape."""
        feet, normals = self.surface.closest(self._centres(x))
        return replace(self, feet=feet, normals=normals)

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 3 k)."""
        if self.feet is None or self.normals is None:
            return self.follow(x).linearise(x)
        count = self.groups.shape[1]
        far = np.einsum("ni,ni->n", self._centres(x) - self.feet, self.normals)
        residual = np.sign(far) * np.maximum(np.abs(far) - self.limit, 0.0)
        felt = np.where(residual == 0.0, 0.0, 1.0 / count)[:, None] * self.normals
        return Linearisation(residual[:, None], np.tile(felt, count)[:, None, :])

    def _centres(self, x: FloatArray) -> FloatArray:
        return np.asarray(points_of(x, self.unknowns).mean(axis=1))
