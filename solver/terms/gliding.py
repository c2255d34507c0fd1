"""Vertices that may move along a plane, a curve or a surface, and mirrored pairs."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from solver.mesh.closest import Polyline, TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, coordinates_of
from solver.terms.stencils import OnVertices


@dataclass(frozen=True, eq=False)
class OnPlane(OnVertices):
    """Vertices stay on a plane.

        r = n . v - d

    One row a vertex; ``vertices`` is (n,), ``normal`` a unit vector. Linear.
    """

    normal: FloatArray
    offset: float
    name: str = "glide"
    linear: bool = True

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 3)."""
        residual = x[self.unknowns] @ self.normal - self.offset
        jacobian = np.broadcast_to(self.normal, (len(self.vertices), 1, 3))
        return Linearisation(residual[:, None], jacobian)


@dataclass(frozen=True, eq=False)
class OnSurface(OnVertices):
    """Vertices stay on a triangle surface, measured from the tangent plane at the closest point.

        r = n . (v - foot - lift)

    One row a vertex. Foot and normal are looked up anew after every step. ``lifts`` (n, 3) says how
    far beside the surface vertices are to lie, in the solver's units; on it by default.
    """

    surface: TriangleSurface
    feet: FloatArray | None = None
    normals: FloatArray | None = None
    name: str = "glide"
    linear: bool = False
    lifts: FloatArray | None = None

    def follow(self, x: FloatArray) -> OnSurface:
        """Look up the closest points at the current shape."""
        feet, normals = self.surface.closest(x[self.unknowns])
        return replace(self, feet=feet, normals=normals)

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 3)."""
        if self.feet is None or self.normals is None:
            return self.follow(x).linearise(x)
        places = self.feet if self.lifts is None else self.feet + self.lifts
        residual = np.einsum("ni,ni->n", x[self.unknowns] - places, self.normals)
        return Linearisation(residual[:, None], self.normals[:, None, :])


@dataclass(frozen=True, eq=False)
class OnCurve(OnVertices):
    """Vertices stay on a polyline, measured across its tangent at the closest point.

        r = (I - t t^T) (v - foot)

    Three rows a vertex. Foot and tangent are looked up anew after every step.
    """

    curve: Polyline
    feet: FloatArray | None = None
    tangents: FloatArray | None = None
    name: str = "glide"
    linear: bool = False

    @property
    def size(self) -> Size:
        """Two independent equations a vertex."""
        return Size(0, 2 * len(self.vertices))

    def follow(self, x: FloatArray) -> OnCurve:
        """Look up the closest points at the current shape."""
        feet, tangents = self.curve.closest(x[self.unknowns])
        return replace(self, feet=feet, tangents=tangents)

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 3) and (n, 3, 3)."""
        if self.feet is None or self.tangents is None:
            return self.follow(x).linearise(x)
        across = np.eye(3) - self.tangents[:, :, None] * self.tangents[:, None, :]
        residual = np.einsum("nij,nj->ni", across, x[self.unknowns] - self.feet)
        return Linearisation(residual, across)


@dataclass(frozen=True, eq=False)
class Mirrored:
    """Pairs of vertices stay mirror images of each other in a coordinate plane.

        r = v_i - M v_j,   M v = v - 2 (v_axis - place) e_axis

    Three rows a pair; ``pairs`` is (n, 2). Linear.
    """

    pairs: IntArray
    axis: int
    place: float
    name: str = "symmetry"
    linear: bool = True

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 6) coordinates of both vertices."""
        return coordinates_of(self.pairs)

    @property
    def size(self) -> Size:
        """Three equations a pair."""
        return Size(0, 3 * len(self.pairs))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 3) and (n, 3, 6)."""
        sign = np.ones(3)
        sign[self.axis] = -1.0
        v = x[self.unknowns]
        residual = v[:, :3] - sign * v[:, 3:]
        residual[:, self.axis] -= 2 * self.place
        jacobian = np.hstack([np.eye(3), -np.diag(sign)])
        return Linearisation(residual, np.broadcast_to(jacobian, (len(self.pairs), 3, 6)))
