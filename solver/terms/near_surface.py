"""Vertices that are drawn to a surface, and back over its border."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from solver.mesh.closest import TriangleSurface
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation
from solver.terms.stencils import OnVertices


@dataclass(frozen=True, eq=False)
class NearSurface(OnVertices):
    """Distance of vertices from a triangle surface, across it and beyond its border.

        r1 = d sqrt(1 + (d / peak)^2),   d = n . (v - foot - lift)
        r2 = b . (v - foot)

    Its square is the one of the distance where that is small, and grows with its fourth power
    beyond ``peak``: what is farthest counts most. Without one, r1 = d.

    Two rows a vertex; ``lifts`` is (n, 3), how far beside the surface vertices are wanted, in the
    solver's units. Foot, normal n and b, which leads from the border to vertices beyond it and is
    zero elsewhere, are looked up anew after every step. Beyond the border a vertex resists in both
    directions, which a distance from the nearest point alone would not tell.
    """

    surface: TriangleSurface
    lifts: FloatArray
    peak: float | None = None
    feet: FloatArray | None = None
    normals: FloatArray | None = None
    outwards: FloatArray | None = None
    name: str = "close to surface"
    linear: bool = False

    def follow(self, x: FloatArray) -> NearSurface:
        """Look up the closest points at the current shape."""
        feet, normals, outwards = self.surface.beside(x[self.unknowns])
        return replace(self, feet=feet, normals=normals, outwards=outwards)

    def peaked(self, x: FloatArray, part: float) -> NearSurface:
        """The same with a peak that is so many times the root mean square of the distances at x."""
        across = replace(self, peak=None).linearise(x).residual[:, 0]
        typical = float(np.sqrt(np.mean(across**2)))
        return replace(self, peak=part * typical) if typical > 0 else self

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 2) and (n, 2, 3)."""
        if self.feet is None or self.normals is None or self.outwards is None:
            return self.follow(x).linearise(x)
        away = x[self.unknowns] - self.feet
        across = np.einsum("ni,ni->n", away - self.lifts, self.normals)
        beyond = np.einsum("ni,ni->n", away, self.outwards)
        jacobian = np.stack([self.normals, self.outwards], axis=1)
        if self.peak is not None:
            beyond_peak = (across / self.peak) ** 2
            growth = np.sqrt(1.0 + beyond_peak)
            jacobian[:, 0] *= ((1.0 + 2.0 * beyond_peak) / growth)[:, None]
            across = across * growth
        return Linearisation(np.stack([across, beyond], axis=1), jacobian)
