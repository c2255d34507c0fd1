"""Koenigs nets: around a vertex the diagonals cut each other in ratios whose product is one."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, coordinates_of, points_of

# Squared areas below this, in mean edges, are those of faces without one.
_NOTHING = 1e-24
# The next one and the one before of four neighbours.
_NEXT, _LAST = [1, 2, 3, 0], [3, 0, 1, 2]


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
    name: str = "dual ratio"
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
        # Coordinates first and stars last, so that each operation runs over many at once.
        v = np.ascontiguousarray(points_of(x, self.unknowns).transpose(2, 1, 0))
        arms = v[:, 1:] - v[:, :1]
        before, opposite = arms[:, :4], arms[:, 4:]
        after = before[:, _NEXT]
        log_before, c_before, by_before = _log_area(opposite, before)
        log_after, c_after, by_after = _log_area(opposite, after)
        jacobian = np.empty((3, 9, v.shape[2]))
        np.subtract(c_after, c_before, out=jacobian[:, 5:])
        np.subtract(by_after[:, _LAST], by_before, out=jacobian[:, 1:5])
        np.negative(jacobian[:, 1:].sum(axis=1), out=jacobian[:, 0])
        rows = np.ascontiguousarray(jacobian.transpose(2, 1, 0))
        residual = (log_after - log_before).sum(axis=0)
        return Linearisation(residual[:, None], rows.reshape(-1, 1, 27))


def _log_area(c: FloatArray, b: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Log |c x b| of vectors (3, k, n), (k, n), and its derivatives by c and by b, (3, k, n)."""
    area = _cross(c, b)
    squared = np.maximum(np.einsum("ikn,ikn->kn", area, area), _NOTHING)
    normal = area / squared
    return 0.5 * np.log(squared), _cross(b, normal), _cross(normal, c)


def _cross(a: FloatArray, b: FloatArray) -> FloatArray:
    """Cross products of vectors (3, k, n)."""
    made = np.empty(a.shape)
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        np.multiply(a[j], b[k], out=made[i])
        made[i] -= a[k] * b[j]
    return made
