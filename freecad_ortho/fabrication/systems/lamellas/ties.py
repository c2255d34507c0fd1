"""Angles that hold a lying lamella on standing ones: one leg below it, one on a plate.

An angle stands in the corner of two standing lamellas through which the lying one leaves their
crossing, beside one plate and clear of the other, its bolts in the middle of the lying one as
nearly as that allows.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.cleat import Cleat, CleatSizes, Leg, corner_of
from freecad_ortho.fabrication.part import part_names
from freecad_ortho.fabrication.systems.lamellas.arm import Arm
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.cleat_sizes import cleat_bolt, leg_thickness
from freecad_ortho.fabrication.systems.lamellas.crossings import at_vertices
from freecad_ortho.fabrication.systems.lamellas.settings import EDGE_DISTANCE, LamellaSettings
from solver.mesh.quadmesh import FloatArray, unit_rows

# Least sine of the angle between a lying lamella and the plate that it is tied to.
_FLAT = 0.25


@dataclass(frozen=True, eq=False)
class _Tie:
    """An angle with the two arms that it joins, and how far its bolt is off the middle, mm."""

    cleat: Cleat
    upright: Arm
    lying: Arm
    off: float


def tie_sizes(settings: LamellaSettings, level: float) -> CleatSizes:
    """Of all angles below a layer whose middle is at a level above the net, mm."""
    hole, bolt = settings.hole, cleat_bolt(settings)
    edge, thickness = EDGE_DISTANCE * hole, leg_thickness(settings)
    above = level - settings.thickness / 2 - settings.width / 2
    wrench = 0.0 if bolt is None else bolt.wrench + thickness
    back = float(math.ceil(max(edge + above, wrench)))
    height, reach = 2.0 * math.ceil(edge), back + math.ceil(edge)
    return CleatSizes(bolt, hole, thickness, height, (0.0,), back, reach, settings.thickness)


def ties_of(
    pieces: Sequence[Lamella],
    grid: Sequence[Lamella],
    taken: frozenset[int],
    settings: LamellaSettings,
    count: int,
) -> tuple[list[Cleat], list[Lamella], list[Lamella], list[str]]:
    """The angles at all crossings, both kinds of lamellas with holes, and where is no room.

    Args:
        pieces: lying lamellas along diagonals.
        grid: standing ones.
        taken: vertices that have cleats of their own.
        settings: of the layer.
        count: of the vertices of the net.
    """
    sizes, names = tie_sizes(settings, settings.lifted), part_names("T", count)
    below, found, lost = at_vertices(grid), list[Cleat](), list[str]()
    drilled: list[dict[int, list[tuple[int, FloatArray]]]] = [{}, {}]
    legs: list[dict[int, list[float]]] = [{}, {}]
    for vertex, here in sorted(at_vertices(pieces).items()):
        there = below.get(vertex, [])
        if not there:
            continue
        number, station = here[0]
        made = (
            []
            if vertex in taken
            else [
                (index, tie)
                for index, at in there
                for tie in _ties(
                    (pieces[number], station),
                    (grid[index], at),
                    [(grid[k], s) for k, s in there if k != index],
                    vertex,
                    names[vertex],
                    sizes,
                    settings,
                )
            ]
        )
        if not made:
            lost.append(names[vertex])
            continue
        index, best = min(made, key=lambda each: (round(each[1].off, 6), each[0]))
        found.append(best.cleat)
        for leg, (kind, which, arm) in enumerate(
            ((0, index, best.upright), (1, number, best.lying))
        ):
            place = arm.face, arm.pattern(best.cleat.bolts(leg))
            drilled[kind].setdefault(which, []).append(place)
            legs[kind].setdefault(which, []).extend(_leg_ends(arm, best.cleat, leg))
    return (
        found,
        _bored(pieces, drilled[1], legs[1]),
        _bored(grid, drilled[0], legs[0]),
        lost,
    )


def _bored(
    lamellas: Sequence[Lamella],
    drilled: dict[int, list[tuple[int, FloatArray]]],
    legs: dict[int, list[float]],
) -> list[Lamella]:
    return [
        replace(
            lamella,
            bolts=(*lamella.bolts, *drilled.get(index, [])),
            legs=(*lamella.legs, *legs.get(index, [])),
        )
        for index, lamella in enumerate(lamellas)
    ]


def _ties(
    lying: tuple[Lamella, int],
    upright: tuple[Lamella, int],
    others: Sequence[tuple[Lamella, int]],
    vertex: int,
    name: str,
    sizes: CleatSizes,
    settings: LamellaSettings,
) -> list[_Tie]:
    """The angles that fit between a lying and a standing lamella at a vertex."""
    arms = [
        [Arm(lamella, station, ahead) for ahead in (True, False)]
        for lamella, station in (upright, lying)
    ]
    made = [
        _tie(one, two, others, (vertex, name), sizes, settings)
        for one in arms[0]
        for two in arms[1]
    ]
    return [tie for tie in made if tie is not None]


def _tie(
    upright: Arm,
    lying: Arm,
    others: Sequence[tuple[Lamella, int]],
    named: tuple[int, str],
    sizes: CleatSizes,
    settings: LamellaSettings,
) -> _Tie | None:
    half = settings.thickness / 2
    cosine = float(upright.way @ lying.way)
    sine = math.sqrt(max(1 - cosine**2, 0.0))
    if sine < _FLAT:
        return None
    beside = sizes.back + half
    _, normal = upright.at(0.0)
    out = np.copysign(1.0, float(normal @ lying.way)) * normal
    along = max(beside * cosine / sine, _clear(upright, out, others, sizes, settings))
    off = abs(along * sine - beside * cosine)
    if off > settings.width / 2 - EDGE_DISTANCE * settings.hole:
        return None
    cleat = _placed(upright, lying, along, (out, sizes.back), named, sizes, settings)
    if cleat is None or not _fits(upright, lying, cleat, settings.clearance):
        return None
    return _Tie(cleat, upright, lying, off)


def _clear(
    upright: Arm,
    out: FloatArray,
    others: Sequence[tuple[Lamella, int]],
    sizes: CleatSizes,
    settings: LamellaSettings,
) -> float:
    """How far along its plate an angle stands to be clear of the other standing lamellas, mm."""
    half, least = settings.thickness / 2, 0.0
    for lamella, station in others:
        for ahead in (True, False):
            way = Arm(lamella, station, ahead).way
            if float(way @ out) <= 0:
                continue
            cosine = float(way @ upright.way)
            sine = math.sqrt(max(1 - cosine**2, _FLAT**2))
            aside = max(cosine, 0.0) / sine * (sizes.reach + half)
            least = max(least, half / sine + 2 * settings.clearance + aside)
    bend = float(upright.lamella.ribbon.strip.bends[upright.station])
    return max(least, settings.thickness * abs(math.tan(bend / 2))) + sizes.height / 2


def _placed(
    upright: Arm,
    lying: Arm,
    along: float,
    side: tuple[FloatArray, float],
    named: tuple[int, str],
    sizes: CleatSizes,
    settings: LamellaSettings,
) -> Cleat | None:
    """The angle so far along its plate; None where an edge is too short for it."""
    out, back = side
    half = settings.thickness / 2
    cosine = float(upright.way @ lying.way)
    reached = along * cosine + (back + half) * math.sqrt(1 - cosine**2)
    if reached >= _length(lying) or along + sizes.height / 2 >= _length(upright):
        return None
    point, normal = upright.at(along)
    out = np.copysign(1.0, float(normal @ out)) * normal
    over, top = lying.at(reached)
    strip = upright.lamella.ribbon.strip
    start = strip.points[upright.station]
    down = -np.copysign(1.0, float(top @ (over - start))) * top
    gaps = [_gap(arm, sizes, settings.width) for arm in (upright, lying)]
    planes = point + (half + gaps[0]) * out, over + (half + gaps[1]) * down
    near = point + float((over - point) @ down) * down
    corner, up = corner_of(planes, (out, down), near)
    ways = []
    for plane, other in ((out, down), (down, out)):
        way = np.cross(up, plane)
        ways.append(np.copysign(1.0, float(way @ other)) * way)
    if float(np.cross(ways[0], out) @ up) < 0:
        up = -up
    names = upright.lamella.name, lying.lamella.name
    legs = (Leg(names[0], ways[0], out, gaps[0]), Leg(names[1], ways[1], down, gaps[1]))
    return Cleat(named[1], named[0], corner, up, legs, sizes)


def _length(arm: Arm) -> float:
    return float(arm.lamella.ribbon.strip.lengths[arm.face])


def _gap(arm: Arm, sizes: CleatSizes, width: float) -> float:
    """How far a face that twists leaves its plane below a leg, mm."""
    strip = arm.lamella.ribbon.strip
    turn = abs(float(strip.twists[arm.face])) / _length(arm) * sizes.reach
    return width / 2 * math.sin(min(turn, math.pi / 2))


def _corners(arm: Arm, cleat: Cleat, leg: int) -> FloatArray:
    """(4, 2) corners of a leg in the pattern of what it lies on."""
    sizes, way = cleat.sizes, cleat.legs[leg].way
    return arm.pattern(
        np.array(
            [
                cleat.corner + out * way + up * cleat.up
                for out in (0.0, sizes.reach)
                for up in (-sizes.height / 2, sizes.height / 2)
            ]
        )
    )


def _fits(upright: Arm, lying: Arm, cleat: Cleat, clearance: float) -> bool:
    """Whether both legs lie in plane faces, and their bolts have their distance from edges."""
    edge = EDGE_DISTANCE * cleat.sizes.hole
    for leg, arm in enumerate((upright, lying)):
        ribbon, face = arm.lamella.ribbon, arm.face
        flat = _corners(arm, cleat, leg)
        mitres = ribbon.thickness * np.abs(np.tan(ribbon.strip.bends[[face, face + 1]] / 2))
        if ribbon.ahead(face, flat).min() < mitres[0]:
            return False
        if ribbon.ahead(face + 1, flat).max() > -mitres[1] - clearance:
            return False
        bolts = arm.pattern(cleat.bolts(leg))
        level = (bolts - ribbon.strip.flat_points[face]) @ ribbon.flat_across[face]
        if level.min() < ribbon.lower + edge or level.max() > ribbon.upper - edge:
            return False
    return True


def _leg_ends(arm: Arm, cleat: Cleat, leg: int) -> list[float]:
    """Places, as in ``Grid``, between which a leg lies."""
    ribbon, face = arm.lamella.ribbon, arm.face
    steps = unit_rows(np.diff(ribbon.strip.flat_points[face : face + 2], axis=0))[0]
    arms = _corners(arm, cleat, leg) - ribbon.strip.flat_points[face]
    share = (arms @ steps) / float(ribbon.strip.lengths[face])
    return [face + float(share.min()), face + float(share.max())]
