"""Bodies of straight members with the section of a catalogue, cut by planes at both ends.

Every plane that cuts an end is a height above the section: what it cuts of a straight side is a
straight line, what it cuts of a rounded corner an arc of an ellipse. So corners, areas and volume
follow by formula, and rounded corners are cylinders, exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Loops, Polyhedron, prism_sides
from freecad_ortho.fabrication.plate_bodies import triangles_in
from freecad_ortho.fabrication.profiled_solid import profiled_solid
from freecad_ortho.fabrication.profiles.end import End
from freecad_ortho.fabrication.profiles.halves import Halves, Loop
from freecad_ortho.fabrication.profiles.outline import Side
from freecad_ortho.fabrication.profiles.profile import Profile
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

# Corners of what stands in for a quarter of a circle when bodies are looked into for clashes.
_CHORDS = 4


@lru_cache(maxsize=32)
def halves_of(profile: Profile) -> Halves:
    """The halves of a profile, worked out once."""
    return Halves.of(profile)


@dataclass(frozen=True, eq=False)
class ProfiledBody(Body):
    """A member along x, its section's z up along y and the section's y along z.

    Attributes:
        profile: its section, whose box has its middle on the x axis.
        first: where it begins.
        last: where it ends.
    """

    profile: Profile
    first: End
    last: End

    quick: ClassVar[bool] = True

    @property
    def halves(self) -> Halves:
        """The section, cut along its upright."""
        return halves_of(self.profile)

    @cached_property
    def points(self) -> FloatArray:
        """(2 M, 3) corners of the outlines at the beginning, then at the end."""
        corners = self.halves.corners
        return np.concatenate([self.raised(corners, end) for end in (self.first, self.last)])

    def raised(self, corners: FloatArray, end: End) -> FloatArray:
        """(n, 3) points of the section (n, 2) in the planes of an end."""
        return np.column_stack([end.at(corners), corners[:, 1], corners[:, 0]])

    @cached_property
    def volume(self) -> float:
        """Area times length, and moments of the area times slopes."""
        return self._between(self.halves.areas)

    @property
    def skin(self) -> float:
        """Outer surface without its ends, mm2."""
        return self._between(self.halves.rims)

    def _between(self, integrals: FloatArray) -> float:
        """Integral of the length over both halves, from integrals (2, 3) of 1, y and z."""
        reach = self.last.planes - self.first.planes
        return float((integrals * reach).sum())

    def solid(self) -> cadquery.Solid:
        """Build the closed solid; no boolean operation, no sewing."""
        return profiled_solid(self.halves, self.points, (self.first, self.last))

    def pieces(self) -> tuple[Polyhedron, ...]:
        """The hull of its outline, cut as it is."""
        return (self._prism(_hull(self.profile)),)

    def filling(self, finer: int = 1) -> tuple[Polyhedron, ...]:
        """Prisms that are the body where it has no rounded corners and its holes reach the upright.

        Otherwise they are a little more.
        """
        made = []
        for corners, triangles in _triangles(self.profile):
            made += [self._prism(corners[triangle]) for triangle in triangles]
        return tuple(made)

    def _prism(self, outline: FloatArray) -> Polyhedron:
        corners = [self.raised(outline, end) for end in (self.last, self.first)]
        return Polyhedron(np.concatenate(corners), _sides(outline))


@lru_cache(maxsize=32)
def _hull(profile: Profile) -> FloatArray:
    """(n, 2) the convex outline around a section, with corners on its upright."""
    from scipy.spatial import ConvexHull

    halves = halves_of(profile)
    points = np.concatenate([_around(halves.sides[number]) for number in halves.rings[0]])
    corners = points[ConvexHull(points).vertices]
    after = np.roll(corners, -1, axis=0)
    made = []
    for corner, following in zip(corners, after, strict=True):
        made.append(corner)
        if corner[0] * following[0] < 0:
            share = corner[0] / (corner[0] - following[0])
            made.append(np.array([0.0, corner[1] + share * (following[1] - corner[1])]))
    return np.array(made)


@lru_cache(maxsize=32)
def _triangles(profile: Profile) -> tuple[tuple[FloatArray, IntArray], ...]:
    """Corners and triangles of each piece of both halves, without holes that lie within one."""
    halves = halves_of(profile)
    made = []
    for half, loops in halves.loops.items():
        for loop, _ in halves.holes(loops):
            corners = _straightened(halves, loop, half)
            made.append((corners, triangles_in(corners)))
    return tuple(made)


def _sides(outline: FloatArray) -> Loops:
    """Sides of a prism over an outline (n, 2), its ends in two where it is on both sides."""
    over, under, *around = prism_sides(len(outline))
    ends: list[Loop] = []
    for loop in (over, under):
        across = outline[np.array(loop) % len(outline), 0]
        if across.min() < 0 < across.max():
            ends += [_in_a_row(loop, (half * across >= 0).tolist()) for half in (1, -1)]
        else:
            ends.append(loop)
    return (*ends, *around)


def _in_a_row(loop: Loop, chosen: Sequence[bool]) -> Loop:
    """The chosen numbers of a loop, from the first one after those that are not."""
    count = len(loop)
    begin = next((k for k in range(count) if chosen[k] and not chosen[k - 1]), 0)
    return tuple(loop[k % count] for k in range(begin, begin + count) if chosen[k % count])


def _straightened(halves: Halves, loop: Loop, half: int) -> FloatArray:
    """(n, 2) a polygon around a piece of a half, with chords or tangents in place of its arcs."""
    points = []
    for corner, following in zip(loop, (*loop[1:], loop[0]), strict=True):
        is_side = halves.side_of[corner] == half and halves.ends[corner, 1] == following
        points.append(_around(halves.sides[corner]) if is_side else halves.corners[[corner]])
    return np.concatenate(points)


def _around(side: Side) -> FloatArray:
    """(n, 2) corners from the start of a side on, before its end, that leave nothing outside."""
    if side.centre is None:
        return side.start[None]
    if side.sweep < 0:
        return side.at(np.arange(_CHORDS) / _CHORDS)
    step = side.sweep / _CHORDS
    arms = side.at((np.arange(_CHORDS) + 0.5) / _CHORDS) - side.centre
    return np.concatenate([side.start[None], side.centre + arms / np.cos(step / 2)])
