"""Pseudo-geodesic lines: the osculating plane keeps one angle to the surface normal."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.angles import unit_and_length
from solver.terms.base import Linearisation, Size, coordinates_of, points_of


@dataclass(frozen=True, eq=False)
class TiltedLine:
    """A line bends at a vertex towards one side of the surface normal, at a given angle.

    With unit vectors e from the vertex before and f to the vertex after, the line bends by
    k = f - e, and w = 2 (e x f) / |e + f| is k turned by a right angle about the line. Of the
    normal n of the star, the one square to both differences of its opposite spokes,

        r = n . (sin(tilt) k - cos(tilt) w)

    vanishes where the strip along the line that unrolls straight (its rectifying plane) stands at
    ``tilt`` to the surface: 0 for geodesics, a right angle for asymptotic lines. The sign of a
    tilt is that of the line's direction. Where a line does not bend r vanishes whatever the tilt.

    One row a star.

    Args:
        stars: (n, 5) centre and four neighbours in cyclic order, of which n is made.
        ends: (n, 2) the vertices before and after on the line.
        tilt: in radians.
        shared: position of one unknown tilt in the flat vector, in place of ``tilt``.

    Source: Wunderlich (1950), Pseudogeodaetische Linien auf Zylinderflaechen; Wang et al. (2023),
    Rectifying strip patterns. The form of the equation is this project's own.
    """

    stars: IntArray
    ends: IntArray
    tilt: float = 0.0
    shared: int | None = None
    name: str = "tilt"
    linear: bool = False

    @cached_property
    def _own(self) -> bool:
        """Whether the line runs through neighbours of the star."""
        return bool((self.ends[:, :, None] == self.stars[:, None, 1:]).any(axis=2).all())

    @cached_property
    def _places(self) -> IntArray:
        """(n, 2) places of the ends among the points of an element."""
        if not self._own:
            return np.tile([5, 6], (len(self.stars), 1))
        return np.asarray(1 + np.argmax(self.ends[:, :, None] == self.stars[:, None, 1:], axis=2))

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 15) coordinates, (n, 21) of a line beside the star's; a shared tilt last."""
        points = self.stars if self._own else np.hstack([self.stars, self.ends])
        coordinates = coordinates_of(points)
        if self.shared is None:
            return coordinates
        shared = np.full((len(self.stars), 1), self.shared, dtype=np.int64)
        return np.hstack([coordinates, shared])

    @property
    def size(self) -> Size:
        """A normal and a binormal a star; their eight definitions and the angle."""
        return Size(6 * len(self.stars), 9 * len(self.stars))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, k), k as ``unknowns``."""
        count = 5 if self._own else 7
        v = points_of(x, self.unknowns[:, : 3 * count])
        rows = np.arange(len(v))
        before, after = self._places.T
        tilt = self.tilt if self.shared is None else float(x[self.shared])
        sine, cosine = np.sin(tilt), np.cos(tilt)
        e, length_e = unit_and_length(v[:, 0] - v[rows, before])
        f, length_f = unit_and_length(v[rows, after] - v[:, 0])
        a, b = v[:, 1] - v[:, 3], v[:, 2] - v[:, 4]
        n, size = unit_and_length(np.cross(a, b))
        s, both = unit_and_length(e + f)
        k, w = f - e, 2 * np.cross(e, f) / both[:, None]
        q = sine * k - cosine * w
        residual, upright = _dot(n, q), _dot(n, w)

        drift = cosine * (upright / both)[:, None] * s
        by_f = sine * n - 2 * cosine * np.cross(n, e) / both[:, None] + drift
        by_e = -sine * n - 2 * cosine * np.cross(f, n) / both[:, None] + drift
        by_after = (by_f - _dot(by_f, f)[:, None] * f) / length_f[:, None]
        by_before = -(by_e - _dot(by_e, e)[:, None] * e) / length_e[:, None]
        p = (q - residual[:, None] * n) / size[:, None]
        by_a, by_b = np.cross(b, p), np.cross(p, a)

        jacobian = np.zeros((len(v), count, 3))
        jacobian[:, 1], jacobian[:, 3] = by_a, -by_a
        jacobian[:, 2], jacobian[:, 4] = by_b, -by_b
        jacobian[rows, before] += by_before
        jacobian[rows, after] += by_after
        jacobian[:, 0] -= by_before + by_after
        flat = jacobian.reshape(len(v), 1, 3 * count)
        if self.shared is not None:
            by_tilt = _dot(n, cosine * k + sine * w)
            flat = np.concatenate([flat, by_tilt[:, None, None]], axis=2)
        return Linearisation(residual[:, None], flat)


def _dot(one: FloatArray, two: FloatArray) -> FloatArray:
    return np.asarray(np.einsum("ij,ij->i", one, two))
