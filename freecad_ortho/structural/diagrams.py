"""Diagrams of forces: ordinates across the members, exact along them.

Where a member carries nothing but even loads, each force along it is a parabola at most, which its
values at both ends and in the middle say.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.structural.check import CombinationResult, StructuralCheck
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

FORCES = ("N", "Vy", "Vz", "T", "My", "Mz")
UNITS = dict(zip(FORCES, ("kN", "kN", "kN", "kNm", "kNm", "kNm"), strict=True))
# Which axis of the section ordinates lie along where positive: moments at the side that they pull
# at.
_AXES = {"N": (2, 1), "Vy": (1, 1), "Vz": (2, 1), "T": (2, 1), "My": (2, 1), "Mz": (1, -1)}
# From N and Nmm.
_KILO = np.array([1e-3, 1e-3, 1e-3, 1e-6, 1e-6, 1e-6])
# Even parts of a member between which a curve is drawn straight.
_PARTS = 4
# The largest ordinate by a usual member and by the longest side of the frame, the less of both.
_OF_MEMBER, _OF_FRAME = 0.9, 0.08


@dataclass(frozen=True, eq=False)
class Diagram:
    """One force along all members, with every section where it is zero or turns.

    Attributes:
        parts: (M, K) sections by the length of the member, ascending from 0 to 1.
        values: (M, K) force in them.
    """

    parts: FloatArray
    values: FloatArray

    @classmethod
    def through(cls, values: FloatArray) -> Diagram:
        """That of forces (M, 3) at both ends and in the middle."""
        start, middle, end = values.T
        square = 2.0 * (start - 2.0 * middle + end)
        linear = end - start - square
        size = np.abs(values).max(axis=1)
        straight = np.abs(square) <= 1e-9 * size
        square = np.where(straight, 0.0, square)
        with np.errstate(divide="ignore", invalid="ignore"):
            turn = -linear / (2.0 * square)
            half = np.sqrt(turn**2 - start / square)
            zeros = [np.where(straight, -start / linear, turn - half), turn + half]
        more = np.stack([turn, *zeros], axis=1)
        # What is outside is drawn at the start once more.
        more = np.where((more > 0.0) & (more < 1.0), more, 0.0)
        even = np.tile(np.linspace(0.0, 1.0, _PARTS + 1), (len(values), 1))
        parts = np.sort(np.concatenate([even, more], axis=1), axis=1)
        found = (square[:, None] * parts + linear[:, None]) * parts + start[:, None]
        found[:, -1] = end
        return cls(parts, np.where(np.abs(found) < 1e-9 * size[:, None], 0.0, found))

    @property
    def largest(self) -> float:
        """Size of the largest value."""
        return float(np.abs(self.values).max())

    def extremes(self) -> list[tuple[int, int]]:
        """Member and section of the largest value, and of the least where one is negative."""
        at = [int(self.values.argmax())] if self.values.max() > 0 else []
        at += [int(self.values.argmin())] if self.values.min() < 0 else []
        return [divmod(number, self.values.shape[1]) for number in at]

    def along(self, start: FloatArray, end: FloatArray) -> FloatArray:
        """(M, K, 3) where the sections are, between ends (M, 3) of the members."""
        return np.asarray(start[:, None] + self.parts[:, :, None] * (end - start)[:, None])


def fitting(diagram: Diagram, ends: FloatArray) -> float:
    """How long an ordinate of 1 is drawn, in the unit of the ends (M, 2, 3) of the members."""
    if not diagram.largest:
        return 0.0
    usual = float(np.median(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)))
    whole = float(np.ptp(ends.reshape(-1, 3), axis=0).max())
    return min(_OF_MEMBER * usual, _OF_FRAME * whole) / diagram.largest


def across(force: str, axes: FloatArray) -> FloatArray:
    """(M, 3) where positive ordinates point to, of axes (M, 3, 3) of the members."""
    axis, sign = _AXES[force]
    return np.asarray(sign * axes[:, axis])


def strips(members: int, sections: int) -> IntArray:
    """(M (K - 1), 4) corners of the areas between sections, of points on members, then of tips."""
    at = np.arange(members * sections).reshape(members, sections)
    one, two = at[:, :-1].ravel(), at[:, 1:].ravel()
    tip = members * sections
    return np.stack([one, two, two + tip, one + tip], axis=1)


def drawn_combination(check: StructuralCheck) -> CombinationResult:
    """The combination that uses a member most, whose forces are drawn."""
    return check.strength[int(check.governing[int(check.utilisation.argmax())])]


def forces_along(check: StructuralCheck, one: CombinationResult | None = None) -> FloatArray:
    """(M, 3, 6) forces of first order at start, middle and end of the members, kN and kNm.

    Args:
        check: what was found.
        one: of its combinations, by default the one that is drawn.
    """
    found, count = (one or drawn_combination(check)).response, len(check.model.families)
    parts = [found.forces_at(check.model.frame, part)[:count] for part in (0.0, 0.5, 1.0)]
    return np.asarray(np.stack(parts, axis=1) * _KILO)
