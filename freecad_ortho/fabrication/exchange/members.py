"""Straight members: parts of one section along a line, cut by planes at both ends."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freecad_ortho.fabrication.bodies import Polyhedron
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.profiled import ProfiledBody
from freecad_ortho.fabrication.profiles.end import End
from freecad_ortho.fabrication.round_tube import RoundTube
from solver.mesh.quadmesh import FloatArray

# Component of a unit normal along the member up to which a side is one of its long ones.
_ALONG = 1e-9
# Places that are as near, mm, and slopes that differ by as little per mm, are one.
_SAME = 1e-6
# Points on a quarter of a circle.
_STEPS = 64


@dataclass(frozen=True, eq=False)
class Member:
    """A convex piece of a section's box, and what of it the section fills.

    Coordinates are those of the part: x along it, y up, z to the right; mm. A plane is a row of
    three: where it crosses the x axis, and by how much x grows per mm up and per mm to the right.
    What is left lies beyond all planes at the start and before all at the end.

    Attributes:
        outline: (n, 2) corners around the section, y and z.
        starts: (1 or 2, 3) planes that cut the start; of two the first cuts the right half, of a
            flange that lies in its pattern the upper one.
        ends: (1 or 2, 3) planes that cut the end, in the same order.
    """

    outline: FloatArray
    starts: FloatArray
    ends: FloatArray

    @cached_property
    def low(self) -> FloatArray:
        """(2,) least y and z."""
        return np.asarray(self.outline.min(axis=0))

    @cached_property
    def high(self) -> FloatArray:
        """(2,) largest y and z."""
        return np.asarray(self.outline.max(axis=0))

    def start_at(self, points: FloatArray) -> FloatArray:
        """(n,) where it begins above points (n, 2) of the section."""
        return np.asarray(_along(self.starts, points).max(axis=0))

    def end_at(self, points: FloatArray) -> FloatArray:
        """(n,) where it ends above points (n, 2) of the section."""
        return np.asarray(_along(self.ends, points).min(axis=0))

    @property
    def reach(self) -> tuple[float, float]:
        """Least and largest x."""
        start, end = self.start_at(self.outline), self.end_at(self.outline)
        return float(start.min()), float(end.max())

    @property
    def longest(self) -> tuple[float, FloatArray]:
        """Length of the longest line along it, and where (2,) in the section that is."""
        lengths = self.end_at(self.outline) - self.start_at(self.outline)
        place = int(np.argmax(np.round(lengths, 6)))
        return float(lengths[place]), self.outline[place]


def mitre_deg(plane: FloatArray) -> float:
    """Angle from square at which a saw crosses, the member lying on its lower side.

    Positive where the cut is further along on the right.
    """
    return float(np.degrees(np.arctan(plane[2])))


def bevel_deg(plane: FloatArray) -> float:
    """Angle by which the saw's blade leaves the upright, positive where its cut goes on upwards."""
    return float(np.degrees(np.arctan(plane[1] / np.hypot(1.0, plane[2]))))


def member_of(part: Part) -> Member | None:
    """The straight member that a part is, None where it is something else."""
    body = part.body
    if isinstance(body, ProfiledBody):
        outline = np.concatenate(
            [body.halves.corners, _arcs(body)] if _is_round(body) else [body.halves.corners]
        )
        return _checked(Member(outline[:, ::-1], _planes(body.first), _planes(body.last)))
    if isinstance(body, RoundTube):
        return _round(body)
    if isinstance(body, Polyhedron):
        return _polyhedron(body)
    return None


def _along(planes: FloatArray, points: FloatArray) -> FloatArray:
    """(p, n) x of planes (p, 3) above points (n, 2)."""
    return np.asarray(planes[:, :1] + planes[:, 1:] @ points.T)


def _is_round(body: ProfiledBody) -> bool:
    return any(side.centre is not None for side in body.halves.sides)


def _arcs(body: ProfiledBody) -> FloatArray:
    """(n, 2) points on the rounded corners of the outer outline."""
    shares = np.linspace(0, 1, _STEPS, endpoint=False)
    sides = [body.halves.sides[number] for number in body.halves.rings[0]]
    rounded = [side.at(shares) for side in sides if side.centre is not None]
    return np.concatenate([np.empty((0, 2)), *rounded])


def _planes(end: End) -> FloatArray:
    """(1 or 2, 3) planes of an end, that of the right half first."""
    rows = [[end.place, end.up, end.slope(half)] for half in (1, -1)]
    return np.array(rows if end.folded else rows[:1])


def _checked(member: Member) -> Member | None:
    """The member, unless two planes meet in a notch."""
    for planes, sign in ((member.starts, 1), (member.ends, -1)):
        if len(planes) == 2 and sign * (planes[0, 2] - planes[1, 2]) < 0:
            return None
    return member


def _round(body: RoundTube) -> Member:
    angles = np.linspace(0, 2 * np.pi, 4 * _STEPS, endpoint=False)
    ring = body.diameter / 2 * np.column_stack([np.cos(angles), np.sin(angles)])
    slopes = -body.ends[:, 1:] / body.ends[:, :1]
    places = body.stations - slopes @ body.middle[1:]
    planes = np.column_stack([places, slopes])
    return Member(ring + body.middle[1:], planes[:1], planes[1:])


def _polyhedron(body: Polyhedron) -> Member | None:
    """A prism along x with one or two planes at each end; None for any other body."""
    found: tuple[list[FloatArray], list[FloatArray]] = ([], [])
    for loop in body.loops:
        corners = body.corners[list(loop)]
        arms = corners - corners[0]
        normal = np.cross(arms[1:-1], arms[2:]).sum(axis=0)
        normal = normal / np.linalg.norm(normal)
        if abs(normal[0]) <= _ALONG:
            continue
        slopes = -normal[1:] / normal[0]
        plane = np.array([corners[0, 0] - slopes @ corners[0, 1:], *slopes])
        planes = found[int(normal[0] > 0)]
        if not any(np.allclose(plane, other, rtol=0, atol=_SAME) for other in planes):
            planes.append(plane)
    if not all(1 <= len(planes) <= 2 for planes in found):
        return None
    starts, ends = (
        np.array(sorted(planes, key=lambda plane: (-sign * plane[2], -sign * plane[1])))
        for planes, sign in zip(found, (1, -1), strict=True)
    )
    member = Member(np.unique(np.round(body.corners[:, 1:], 9), axis=0), starts, ends)
    inside = body.corners[:, 0] >= member.start_at(body.corners[:, 1:]) - _SAME
    inside &= body.corners[:, 0] <= member.end_at(body.corners[:, 1:]) + _SAME
    return member if inside.all() else None
