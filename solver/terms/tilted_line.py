"""Pseudo-geodesic lines: the osculating plane keeps one angle to the surface normal."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, cross_rows
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

    One row a line of a star.

    Args:
        stars: (n, 5) centre and four neighbours in cyclic order, of which n is made.
        ends: (n, L, 2) the vertices before and after on each line, or (n, 2) of one line.
        tilts: of the lines, in radians.
        shared: of the lines whose tilt is free its position in the flat vector, None of others.

    Source: Wunderlich (1950), Pseudogeodaetische Linien auf Zylinderflaechen; Wang et al. (2023),
    Rectifying strip patterns. The form of the equation is this project's own.
    """

    stars: IntArray
    ends: IntArray
    tilts: tuple[float, ...] = (0.0,)
    shared: tuple[int | None, ...] = (None,)
    name: str = "tilt"
    linear: bool = False

    @cached_property
    def _lines(self) -> IntArray:
        return self.ends.reshape(len(self.stars), len(self.tilts), 2)

    @cached_property
    def _own(self) -> bool:
        """Whether the lines run through neighbours of the star."""
        ends = self.ends.reshape(len(self.stars), -1)
        return bool((ends[:, :, None] == self.stars[:, None, 1:]).any(axis=2).all())

    @cached_property
    def _places(self) -> IntArray:
        """(n, L, 2) places of the ends among the points of an element."""
        if not self._own:
            beside = 5 + np.arange(2 * len(self.tilts)).reshape(-1, 2)
            return np.tile(beside, (len(self.stars), 1, 1))
        same = self._lines[:, :, :, None] == self.stars[:, None, None, 1:]
        return np.asarray(1 + np.argmax(same, axis=3))

    @cached_property
    def _columns(self) -> list[tuple[Any, Any]]:
        """Where the points before and after stand: places of a line that are all alike at once."""
        found: list[tuple[Any, Any]] = []
        for before, after in self._places.transpose(1, 2, 0):
            if (before == before[:1]).all() and (after == after[:1]).all() and len(before):
                found.append(((slice(None), int(before[0])), (slice(None), int(after[0]))))
            else:
                rows = np.arange(len(before))
                found.append(((rows, before), (rows, after)))
        return found

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, k) coordinates of the star, and of lines beside it; shared tilts last."""
        ends = self.ends.reshape(len(self.stars), -1)
        points = self.stars if self._own else np.hstack([self.stars, ends])
        free = [number for number in self.shared if number is not None]
        tilts = np.tile(np.array(free, dtype=np.int64), (len(self.stars), 1))
        return np.hstack([coordinates_of(points), tilts])

    @property
    def size(self) -> Size:
        """A normal a star and a binormal a line; their definitions and the angles."""
        lines = len(self.tilts)
        return Size((3 + 3 * lines) * len(self.stars), (4 + 5 * lines) * len(self.stars))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, L) and (n, L, k), k as ``unknowns``."""
        free = sum(number is not None for number in self.shared)
        count = (self.unknowns.shape[1] - free) // 3
        v = points_of(x, self.unknowns[:, : 3 * count])
        a, b = v[:, 1] - v[:, 3], v[:, 2] - v[:, 4]
        n, size = unit_and_length(cross_rows(a, b))
        residual = np.empty((len(v), len(self.tilts)))
        jacobian = np.zeros((len(v), len(self.tilts), 3 * count + free))
        column = 3 * count
        for line, number in enumerate(self.shared):
            tilt = self.tilts[line] if number is None else float(x[number])
            # A view: what is added to it is in the Jacobian.
            by_points = jacobian[:, line, : 3 * count].reshape(len(v), count, 3)
            residual[:, line], p, by_tilt = _bend(v, self._columns[line], n, tilt, by_points)
            p = p / size[:, None]
            by_a, by_b = cross_rows(b, p), cross_rows(p, a)
            by_points[:, 1] += by_a
            by_points[:, 3] -= by_a
            by_points[:, 2] += by_b
            by_points[:, 4] -= by_b
            if number is not None:
                jacobian[:, line, column] = by_tilt
                column += 1
        return Linearisation(residual, jacobian)


def _bend(
    v: FloatArray, places: tuple[Any, Any], n: FloatArray, tilt: float, jacobian: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """One line: (n,) residuals, (n, 3) their derivatives by the normal and (n,) by the tilt.

    Those by the points are added to a jacobian (n, points, 3).
    """
    before, after = places
    sine, cosine = np.sin(tilt), np.cos(tilt)
    e, length_e = unit_and_length(v[:, 0] - v[before])
    f, length_f = unit_and_length(v[after] - v[:, 0])
    s, both = unit_and_length(e + f)
    k, w = f - e, 2 * cross_rows(e, f) / both[:, None]
    q = sine * k - cosine * w
    residual, upright = _dot(n, q), _dot(n, w)
    drift = cosine * (upright / both)[:, None] * s
    by_f = sine * n - 2 * cosine * cross_rows(n, e) / both[:, None] + drift
    by_e = -sine * n - 2 * cosine * cross_rows(f, n) / both[:, None] + drift
    by_after = (by_f - _dot(by_f, f)[:, None] * f) / length_f[:, None]
    by_before = -(by_e - _dot(by_e, e)[:, None] * e) / length_e[:, None]
    jacobian[before] += by_before
    jacobian[after] += by_after
    jacobian[:, 0] -= by_before + by_after
    return residual, q - residual[:, None] * n, _dot(n, cosine * k + sine * w)


def _dot(one: FloatArray, two: FloatArray) -> FloatArray:
    return np.asarray(np.einsum("ij,ij->i", one, two))
