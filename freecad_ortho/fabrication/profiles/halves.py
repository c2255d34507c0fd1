"""A section cut along its upright: how its left and its right half are bounded.

Where the end of a beam is cut by two planes they meet in the upright. A corner is a place on an
outline: where two sides meet, or where one crosses the upright.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freecad_ortho.fabrication.pattern import polygon_area
from freecad_ortho.fabrication.profiles.outline import Side, along, moments
from freecad_ortho.fabrication.profiles.profile import Profile
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# Nodes nearer to the upright than this, mm, are on it.
_ON_UPRIGHT = 1e-9

# Numbers of corners around something, one after the other.
Loop = tuple[int, ...]


@dataclass(frozen=True, eq=False)
class Halves:
    """Outlines whose sides end at the upright.

    Attributes:
        sides: of all rings, each wholly on one side of the upright.
        ends: (n, 2) numbers of the corners where each begins and ends.
        corners: (m, 2) y and z, mm.
        rings: corners around each ring.
        side_of: (n,) 1 for sides on the right, -1 on the left.
    """

    sides: tuple[Side, ...]
    ends: IntArray
    corners: FloatArray
    rings: tuple[Loop, ...]
    side_of: IntArray

    @classmethod
    def of(cls, profile: Profile) -> Halves:
        """Those of a profile."""
        sides: list[Side] = []
        ends: list[tuple[int, int]] = []
        rings: list[Loop] = []
        for ring in profile.rings:
            pieces = [piece for side in ring.sides for piece in side.upright_split()]
            numbers = range(len(sides), len(sides) + len(pieces))
            ends += zip(numbers, [*numbers[1:], numbers[0]], strict=True)
            sides += pieces
            rings.append(tuple(numbers))
        corners = np.array([side.start for side in sides])
        corners[np.abs(corners[:, 0]) < _ON_UPRIGHT, 0] = 0.0
        middles = np.array([side.at(np.array([0.5]))[0, 0] for side in sides])
        # What lies on the upright bounds what is on its left.
        rising = np.array([side.end[1] - side.start[1] for side in sides])
        on = np.abs(middles) < _ON_UPRIGHT
        right = np.where(on, rising < 0, middles > 0)
        return cls(tuple(sides), np.array(ends), corners, tuple(rings), np.where(right, 1, -1))

    @cached_property
    def areas(self) -> FloatArray:
        """(2, 3) integrals of 1, y and z over the right half, then over the left one."""
        made = [moments(self._half(half)) for half in (1, -1)]
        return np.array([[half.area, half.y, half.z] for half in made])

    @cached_property
    def rims(self) -> FloatArray:
        """(2, 3) the same along the outer outline of each half."""
        made = np.zeros((2, 3))
        for number in self.rings[0]:
            row = 0 if self.side_of[number] > 0 else 1
            made[row] += along(self.sides[number])
        return made

    def _half(self, half: int) -> list[Side]:
        pairs = zip(self.sides, self.side_of, strict=True)
        return [side for side, where in pairs if where == half]

    @cached_property
    def loops(self) -> dict[int, tuple[Loop, ...]]:
        """Nodes around each piece of the right half, 1, and of the left one, -1.

        Loops are counter-clockwise, those of holes that do not reach the upright clockwise.
        """
        return {half: tuple(self._loops(half)) for half in (1, -1)}

    def _loops(self, half: int) -> list[Loop]:
        """Chains of sides from the upright to the upright are joined along it."""
        onward = {
            start: end
            for (start, end), where in zip(self.ends.tolist(), self.side_of, strict=True)
            if where == half
        }
        begins = set(onward) - set(onward.values())
        onward |= {end: self._along_upright(end, begins, half) for end in _dead_ends(onward)}
        found = []
        while onward:
            loop = [next(iter(onward))]
            while (following := onward.pop(loop[-1])) != loop[0]:
                loop.append(following)
            found.append(tuple(loop))
        return found

    def _along_upright(self, here: int, begins: set[int], half: int) -> int:
        """The corner where the next chain begins: on the right below, on the left above."""
        height = self.corners[here, 1]
        ways = {corner: half * float(height - self.corners[corner, 1]) for corner in begins}
        return min((way, corner) for corner, way in ways.items() if way > -_ON_UPRIGHT)[1]

    def holes(self, loops: Sequence[Loop]) -> list[tuple[Loop, list[Loop]]]:
        """Each outline among loops with the holes that lie in it."""
        outer = [loop for loop in loops if polygon_area(self.corners[list(loop)]) > 0]
        inner = [loop for loop in loops if loop not in outer]
        found: list[tuple[Loop, list[Loop]]] = [(loop, []) for loop in outer]
        for hole in inner:
            home = next(
                entry
                for entry in found
                if _inside(self.corners[hole[0]], self.corners[list(entry[0])])
            )
            home[1].append(hole)
        return found


def _dead_ends(onward: dict[int, int]) -> list[int]:
    return [end for end in onward.values() if end not in onward]


def _inside(point: FloatArray, polygon: FloatArray) -> bool:
    """Whether a point lies in a polygon (n, 2), by crossings of a ray to the right."""
    start, end = polygon, np.roll(polygon, -1, axis=0)
    spans = (start[:, 1] > point[1]) != (end[:, 1] > point[1])
    with np.errstate(divide="ignore", invalid="ignore"):
        share = (point[1] - start[:, 1]) / (end[:, 1] - start[:, 1])
        crossing = start[:, 0] + share * (end[:, 0] - start[:, 0])
    return bool((spans & (crossing > point[0])).sum() % 2)
