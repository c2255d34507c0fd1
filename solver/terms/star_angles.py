"""Conical, geodesic and developable stars: relations between the four angles at a vertex."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.angles import angles, cosines
from solver.terms.base import Linearisation, Size, coordinates_of, points_of


@dataclass(frozen=True, eq=False)
class _Star:
    """Stencil of all star terms: centre and four neighbours in cyclic order, (n, 5)."""

    stars: IntArray
    linear: bool = False

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 15) coordinates of centre and neighbours."""
        return coordinates_of(self.stars)

    def _spokes(self, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        v = points_of(x, self.unknowns)
        spokes = v[:, 1:] - v[:, :1]
        return spokes, np.roll(spokes, -1, axis=1)


@dataclass(frozen=True, eq=False)
class ConicalStar(_Star):
    """The two sums of opposite angles agree; with planar faces, they touch a common cone.

        r = (t12 + t34 - t23 - t41) / 2

    One row a star. The angle sums have no second branch, unlike equal angles with an axis.

    Source: Liu et al. (2006), Geometric modeling with conical meshes and developable surfaces.
    """

    name: str = "conical"

    @property
    def size(self) -> Size:
        """An axis a star; four equal angles and its unit length."""
        return Size(3 * len(self.stars), 5 * len(self.stars))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 15)."""
        combination = np.array([[0.5, -0.5, 0.5, -0.5]])
        return _combined(combination, *angles(*self._spokes(x)))


@dataclass(frozen=True, eq=False)
class GeodesicStar(_Star):
    """Opposite angles are equal: both parameter lines run straight on the surface.

        r1 = cos t12 - cos t34,   r2 = cos t23 - cos t41

    Two rows a star. The paper adds the unit edge vectors as unknowns; here they are eliminated.

    Source: Wunderlich (1951), via Dellinger, Li, Wang (2023), definition 6 and E_Gnet.
    """

    name: str = "geodesic"

    @property
    def size(self) -> Size:
        """Four unit vectors a star; two equations and their twelve definitions."""
        return Size(12 * len(self.stars), 14 * len(self.stars))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 2) and (n, 2, 15)."""
        combination = np.array([[1.0, 0.0, -1.0, 0.0], [0.0, 1.0, 0.0, -1.0]])
        return _combined(combination, *cosines(*self._spokes(x)))


@dataclass(frozen=True, eq=False)
class EqualAngleStar(_Star):
    """All four angles are equal: a discrete orthogonal geodesic net of the stricter kind.

        r1 = cos t12 - cos t34,   r2 = cos t23 - cos t41,
        r3 = (cos t12 + cos t34 - cos t23 - cos t41) / 2

    Three rows a star.

    Source: Rabinovich, Hoffmann, Sorkine-Hornung (2018), Discrete geodesic nets for modeling
    developable surfaces.
    """

    name: str = "equal angles"

    @property
    def size(self) -> Size:
        """Four unit vectors a star; three equations and their twelve definitions."""
        return Size(12 * len(self.stars), 15 * len(self.stars))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 3) and (n, 3, 15)."""
        combination = np.array(
            [[1.0, 0.0, -1.0, 0.0], [0.0, 1.0, 0.0, -1.0], [0.5, -0.5, 0.5, -0.5]]
        )
        return _combined(combination, *cosines(*self._spokes(x)))


def _combined(
    combination: FloatArray, value: FloatArray, by_one: FloatArray, by_two: FloatArray
) -> Linearisation:
    """Linear combinations (m, 4) of values between each spoke and the next, by all five points."""
    by_spokes = combination[None, :, :, None] * by_one[:, None]
    by_spokes += np.roll(combination[None, :, :, None] * by_two[:, None], 1, axis=2)
    by_centre = -by_spokes.sum(axis=2, keepdims=True)
    jacobian = np.concatenate([by_centre, by_spokes], axis=2)
    return Linearisation(value @ combination.T, jacobian.reshape(len(value), len(combination), 15))
