"""Contours of the faces of bars and plates, as NC1 has them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.exchange.members import Member
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import FlatPattern, polygon_area
from solver.mesh.quadmesh import FloatArray

# An angle, degrees, and how far it goes in, mm; one from the face that is seen, one from behind.
Couple = tuple[float, float]
Couples = tuple[Couple, Couple]
SQUARE: Couples = ((0.0, 0.0), (0.0, 0.0))
# Distance, mm, up to which a bevel belongs to a side of the outline beside it, in thicknesses.
_NEAR = 1.5


@dataclass(frozen=True, eq=False)
class Contour:
    """A closed line on a face.

    Attributes:
        face: v, o, u or h.
        points: (n, 2) corners, mm; counter-clockwise, an inner contour clockwise.
        bevels: of the side that follows each corner: angle and depth from the face that is seen and
            from behind; positive where the cut goes back at that face.
        inner: whether it is that of an opening.
    """

    face: str
    points: FloatArray
    bevels: tuple[Couples, ...]
    inner: bool = False


@dataclass(frozen=True)
class Nc1Mark:
    """A text on the front, its lower left corner and height in mm."""

    text: str
    x: float
    y: float
    angle_deg: float
    height: int


def plate_contours(part: Part, pattern: FlatPattern) -> tuple[Contour, ...]:
    """The outline of a plate with its bevels, and its openings."""
    outline = pattern.outline
    bevels = tuple(
        _bevels(outline[k], outline[(k + 1) % len(outline)], part.thickness, pattern)
        for k in range(len(outline))
    )
    found = [Contour("v", outline, bevels)]
    for cutout in pattern.cutouts:
        ring = cutout[::-1] if polygon_area(cutout) > 0 else cutout
        found.append(Contour("v", ring, (SQUARE,) * len(ring), inner=True))
    return tuple(found)


def _bevels(start: FloatArray, end: FloatArray, thickness: float, pattern: FlatPattern) -> Couples:
    """How the side of an outline leans: from the face seen, and from behind."""
    step = (end - start) / np.linalg.norm(end - start)
    found: dict[bool, float] = {}
    for bevel in pattern.bevels:
        arms = bevel.points - start
        off = arms[:, 0] * step[1] - arms[:, 1] * step[0]
        middle = float(arms.mean(axis=0) @ step) / float(np.linalg.norm(end - start))
        beside = np.abs(off).max() <= _NEAR * thickness and 0 < middle < 1
        if beside and abs(off[0] - off[1]) <= 1e-6 * (1 + np.abs(off).max()):
            found[bevel.hidden] = abs(bevel.angle_deg)
    depth = thickness / max(len(found), 1)
    seen, behind = ((found[k], depth) if k in found else (0.0, 0.0) for k in (False, True))
    return seen, behind


def plate_marks(name: str, pattern: FlatPattern) -> tuple[Nc1Mark, ...]:
    """The name and the other texts, which the pattern has by their middles."""
    texts = [(name, pattern.label, pattern.label_size, pattern.label_angle)]
    texts += [
        (mark.text, mark.points[0], mark.size, mark.angle) for mark in pattern.marks if mark.text
    ]
    return tuple(_mark(*text) for text in texts)


def _mark(text: str, middle: FloatArray, size: float, angle_deg: float) -> Nc1Mark:
    height = max(1, int(size))
    turn = np.radians(angle_deg)
    along, up = np.array([np.cos(turn), np.sin(turn)]), np.array([-np.sin(turn), np.cos(turn)])
    corner = middle - 0.5 * height * (0.8 * len(text) * along + up)
    return Nc1Mark(text, float(corner[0]), float(corner[1]), angle_deg, height)


def upright_face(
    face: str, member: Member, right: float, thickness: float, reach: tuple[float, float]
) -> Contour:
    """A web or an upright wall, cut at both ends.

    Args:
        face: v or h.
        member: that it belongs to.
        right: where its line is that runs furthest, z.
        thickness: mm.
        reach: of the section, y.
    """
    sides = [np.array([[y, right]]) for y in reach]
    base = member.reach[0]
    low, high = reach
    corners = [(member.start_at(sides[0]), low), (member.end_at(sides[0]), low)]
    corners += [(member.end_at(sides[1]), high), (member.start_at(sides[1]), high)]
    points = np.array([[float(x[0]) - base, y - member.low[0]] for x, y in corners])
    if abs(right) < thickness / 2:
        leans = [_lean(planes, (0, -1), 2, sign, thickness / 2) for planes, sign in _ends(member)]
    else:
        half = 0 if right > 0 else -1
        leans = [_lean(planes, (half, half), 2, sign, thickness) for planes, sign in _ends(member)]
    if face == "h":
        leans = [(behind, seen) for seen, behind in leans]
    return Contour(face, points, (SQUARE, leans[1], SQUARE, leans[0]))


def level_face(face: str, member: Member, up: float, thickness: float) -> Contour:
    """A flange or a level wall, o from above and u from below, cut by one or two planes an end."""
    base, width = member.reach[0], float(member.high[1] - member.low[1])
    places = sorted({float(member.low[1]), 0.0, float(member.high[1])}, reverse=face == "o")
    section = np.array([[up, z] for z in places])
    starts, ends = member.start_at(section) - base, member.end_at(section) - base
    # From above the front is below, from below it is above.
    across = [member.high[1] - z if face == "o" else z - member.low[1] for z in places]
    across = [min(max(float(value), 0.0), width) for value in across]
    points = [(starts[0], across[0])]
    points += list(zip(ends, across, strict=True))
    points += list(zip(starts[:0:-1], across[:0:-1], strict=True))
    # The first half on the way is that in front from above, the one behind from below.
    halves = (0, -1) if face == "o" else (-1, 0)
    bevels: list[Couples] = []
    for planes, sign, order in ((member.ends, -1, halves), (member.starts, 1, halves[::-1])):
        bevels.append(SQUARE)
        for half in order[: len(places) - 1]:
            above, below = _lean(planes, (half, half), 1, sign, thickness)
            bevels.append((above, below) if face == "o" else (below, above))
    return Contour(face, np.array(points), tuple(bevels))


def _ends(member: Member) -> tuple[tuple[FloatArray, int], tuple[FloatArray, int]]:
    return (member.starts, 1), (member.ends, -1)


def _lean(
    planes: FloatArray, halves: tuple[int, int], column: int, sign: int, depth: float
) -> Couples:
    """How far the cuts of two halves go back towards a column's direction, and away from it."""
    found = []
    for half, way in zip(halves, (sign, -sign), strict=True):
        slope = way * float(planes[half, column])
        found.append((float(np.degrees(np.arctan(slope))), depth) if slope > 1e-9 else (0.0, 0.0))
    return found[0], found[1]
