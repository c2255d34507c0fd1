"""Closed outlines of straight sides and arcs, and integrals over what they enclose."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray, unit_rows

# Points of Gauss' rule a side: exact on straight ones, to the last digit on quarters of a circle.
_KNOTS, _WEIGHTS = np.polynomial.legendre.leggauss(16)
_SHARE, _WEIGHTS = (_KNOTS + 1) / 2, _WEIGHTS / 2


@dataclass(frozen=True, eq=False)
class Side:
    """A straight side or an arc of an outline, mm.

    Attributes:
        start: (2,) to the right and up.
        end: (2,)
        centre: (2,) of the arc, None for a straight side.
        sweep: angle of the arc, counter-clockwise positive, radians.
    """

    start: FloatArray
    end: FloatArray
    centre: FloatArray | None = None
    sweep: float = 0.0

    @property
    def radius(self) -> float:
        """Of the arc, mm; 0 for a straight side."""
        return 0.0 if self.centre is None else float(np.linalg.norm(self.start - self.centre))

    def at(self, share: FloatArray) -> FloatArray:
        """(n, 2) points at parts of the way (n,) from the start, 0 to 1."""
        if self.centre is None:
            return np.asarray(self.start + np.outer(share, self.end - self.start))
        angle = self.sweep * share
        arm = self.start - self.centre
        turned = np.outer(np.cos(angle), arm) + np.outer(np.sin(angle), [-arm[1], arm[0]])
        return np.asarray(self.centre + turned)

    def slope(self, share: FloatArray) -> FloatArray:
        """(n, 2) derivative of ``at``."""
        if self.centre is None:
            return np.tile(self.end - self.start, (len(share), 1))
        arm = self.at(share) - self.centre
        return np.asarray(self.sweep * np.column_stack([-arm[:, 1], arm[:, 0]]))

    def upright_split(self) -> tuple[Side, ...]:
        """The side in pieces that do not cross the upright through the origin."""
        crossings = [share for share in self._crossings() if 1e-9 < share < 1 - 1e-9]
        bounds = [0.0, *sorted(crossings), 1.0]
        if len(bounds) == 2:
            return (self,)
        points = self.at(np.array(bounds))
        points[0], points[-1] = self.start, self.end
        points[1:-1, 0] = 0.0
        return tuple(
            Side(points[k], points[k + 1], self.centre, self.sweep * (bounds[k + 1] - bounds[k]))
            for k in range(len(bounds) - 1)
        )

    def _crossings(self) -> list[float]:
        """Where it meets the upright through the origin, as parts of its way."""
        if self.centre is None:
            step = float(self.end[0] - self.start[0])
            return [-float(self.start[0]) / step] if step else []
        if abs(self.centre[0]) >= self.radius:
            return []
        first = math.atan2(*(self.start - self.centre)[::-1].tolist())
        angle = math.acos(-float(self.centre[0]) / self.radius)
        turns = ((sign * angle - first) % math.copysign(math.tau, self.sweep) for sign in (1, -1))
        return [turn / self.sweep for turn in turns]


@dataclass(frozen=True)
class Moments:
    """Integrals over an area; y to the right, z up.

    Attributes:
        area: of 1, mm2.
        y: of y, mm3.
        z: of z, mm3.
        yy: of y2, mm4.
        zz: of z2, mm4.
        yz: of y z, mm4.
    """

    area: float
    y: float
    z: float
    yy: float
    zz: float
    yz: float


def along(side: Side) -> FloatArray:
    """(3,) integrals of 1, y and z along a side, mm and mm2."""
    points, speed = side.at(_SHARE), np.linalg.norm(side.slope(_SHARE), axis=1)
    return np.asarray((speed * _WEIGHTS) @ np.column_stack([np.ones(len(points)), points]))


def moments(sides: Sequence[Side]) -> Moments:
    """Integrals over what sides enclose, by Green's theorem; holes run clockwise."""
    if not sides:
        return Moments(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    points = np.concatenate([side.at(_SHARE) for side in sides])
    rise = np.concatenate([side.slope(_SHARE)[:, 1] * _WEIGHTS for side in sides])
    y, z = points.T
    powers = ((0, 0), (1, 0), (0, 1), (2, 0), (0, 2), (1, 1))
    return Moments(*(float(rise @ (y ** (p + 1) * z**q)) / (p + 1) for p, q in powers))


def rounded(corners: FloatArray, radii: FloatArray) -> tuple[Side, ...]:
    """The sides of a closed polygon (n, 2) whose corners are rounded by radii (n,), 0 for sharp.

    A square whose corners have half its size as radius is a circle.
    """
    before, after = np.roll(corners, 1, axis=0), np.roll(corners, -1, axis=0)
    into, out = unit_rows(corners - before), unit_rows(after - corners)
    turn = np.arctan2(into[:, 0] * out[:, 1] - into[:, 1] * out[:, 0], (into * out).sum(axis=1))
    back = radii * np.abs(np.tan(turn / 2))
    starts, ends = corners - back[:, None] * into, corners + back[:, None] * out
    sides = []
    for k in range(len(corners)):
        if radii[k] > 0:
            inward = np.sign(turn[k]) * np.array([-into[k, 1], into[k, 0]])
            sides.append(Side(starts[k], ends[k], starts[k] + radii[k] * inward, float(turn[k])))
        following = starts[(k + 1) % len(corners)]
        if np.linalg.norm(following - ends[k]) > 1e-9 * np.linalg.norm(corners[k] - after[k]):
            sides.append(Side(ends[k], following))
    return tuple(sides)
