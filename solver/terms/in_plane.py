"""Points of a line lie in one plane, which is an unknown of its own."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, coordinates_of


@dataclass(frozen=True, eq=False)
class InPlane:
    """A vertex lies in the plane of its line, n . v = d, whose numbers all of the line share.

        r1 = n . v - d,   r2 = (|n|^2 - 1) / 2

    Two rows for each vertex of each line; the second keeps the normal from vanishing.

    Args:
        vertices: (n,) of the lines.
        planes: (n, 4) positions of n and d in the flat vector.

    Source: Wang et al. (2022), Computational design of freeform structures with planar panels and
    planar supporting beams, names the condition.
    """

    vertices: IntArray
    planes: IntArray
    name: str = "line planes"
    linear: bool = False

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 7) coordinates of the vertex, then its plane."""
        return np.hstack([coordinates_of(self.vertices[:, None]), self.planes])

    @property
    def size(self) -> Size:
        """One equation a vertex and one a plane; the planes are counted as unknowns already."""
        return Size(0, len(self.vertices) + len(np.unique(self.planes[:, 0])))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 2) and (n, 2, 7)."""
        values = x[self.unknowns]
        v, n, d = values[:, :3], values[:, 3:6], values[:, 6]
        residual = np.stack(
            [np.einsum("ij,ij->i", n, v) - d, 0.5 * (np.einsum("ij,ij->i", n, n) - 1.0)], axis=1
        )
        jacobian = np.zeros((len(v), 2, 7))
        jacobian[:, 0, :3], jacobian[:, 0, 3:6], jacobian[:, 0, 6] = n, v, -1.0
        jacobian[:, 1, 3:6] = n
        return Linearisation(residual, jacobian)
