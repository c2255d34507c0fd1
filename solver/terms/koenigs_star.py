"""Koenigs nets: around a vertex the diagonals cut each other in ratios whose product is one."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, cross_rows
from solver.terms.base import Linearisation, Size, coordinates_of, points_of

# Squared areas below this, in mean edges, are those of faces without one.
_NOTHING = 1e-24


@dataclass(frozen=True, eq=False)
class KoenigsStar:
    """The net has a Christoffel dual around a vertex.

    In a face with corners A, B, C, D, A the vertex, the diagonals BD and AC meet in M. Then

        r = sum log(|MD| / |MB|) = sum log(|AC x AD| / |AC x AB|)

    over the four faces in cyclic order vanishes. It may be asked of faces that are not yet plane.

    One row a star; ``stars`` (n, 5) are centre and neighbours in cyclic order, ``corners`` (n, 4)
    the opposite corners of the faces, the first between the first two neighbours.

    Source: Bobenko, Suris (2009), Discrete Koenigs nets and discrete isothermic surfaces.
    """

    stars: IntArray
    corners: IntArray
    name: str = "koenigs"
    linear: bool = False

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 27) coordinates of the star, then of the corners."""
        return coordinates_of(np.hstack([self.stars, self.corners]))

    @property
    def size(self) -> Size:
        """One equation a star."""
        return Size(0, len(self.stars))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 27)."""
        v = points_of(x, self.unknowns)
        residual = np.zeros(len(v))
        jacobian = np.zeros((len(v), 9, 3))
        for k in range(4):
            c = v[:, 5 + k] - v[:, 0]
            for place, sign in ((1 + k, -1.0), (1 + (k + 1) % 4, 1.0)):
                b = v[:, place] - v[:, 0]
                area = cross_rows(c, b)
                squared = np.maximum(np.einsum("ij,ij->i", area, area), _NOTHING)
                residual += 0.5 * sign * np.log(squared)
                normal = sign * area / squared[:, None]
                by_c, by_b = cross_rows(b, normal), cross_rows(normal, c)
                jacobian[:, 5 + k] += by_c
                jacobian[:, place] += by_b
                jacobian[:, 0] -= by_c + by_b
        return Linearisation(residual[:, None], jacobian.reshape(len(v), 1, 27))
