"""Where lamellas are joined by cleats: at their last crossings, and above feet."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from freecad_ortho.fabrication.cleat import Cleat, CleatSizes, Leg, corner_of
from freecad_ortho.fabrication.part import part_names
from freecad_ortho.fabrication.systems.lamellas.arm import Arm
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.cleat_fit import (
    LIFTED,
    Slots,
    fits,
    off_leg,
    off_middle,
    twist_gap,
)
from freecad_ortho.fabrication.systems.lamellas.cleat_sizes import sizes_of
from freecad_ortho.fabrication.systems.lamellas.crossings import Crossing
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from solver.mesh.quadmesh import FloatArray, unit_rows

# Ways to place the bolts of a leg, see ``sizes_of``.
_SPREADS = (0, 1, 2)
# Most that a leg rises beside its fold.
_STEEP = 1.5
# Most that one leg may lean to another, as the cosine of their angle.
_FLAT = 0.94
# Rounds in which the places of the legs and their distances from twisted plates come to agree.
_ROUNDS = 4


def ends_of(lamellas: Sequence[Lamella]) -> set[int]:
    """The last vertices of those that are not closed."""
    return {lamella.vertices[k] for lamella in lamellas if not lamella.closed for k in (0, -1)}


def around(
    lamellas: Sequence[Lamella], vertices: Collection[int], settings: LamellaSettings
) -> dict[int, FloatArray]:
    """By each of the vertices (N, 3) corners of the lamellas there, within the reach of a cap."""
    reach = 2.0 * sizes_of(settings, math.radians(60.0)).beside
    found: dict[int, list[FloatArray]] = {}
    for lamella in lamellas:
        strip, ribbon = lamella.ribbon.strip, lamella.ribbon
        for vertex, station in zip(lamella.vertices, lamella.stations, strict=True):
            if vertex not in vertices:
                continue
            for face, sign in ((station, 1.0), (station - 1, -1.0)):
                if not 0 <= face < len(strip.lengths):
                    continue
                away = min(reach, float(strip.lengths[face]))
                up = unit_rows(strip.across[0 if sign > 0 else 1][face][None])[0]
                aside = ribbon.thickness / 2 * np.cross(strip.along[face], up)
                found.setdefault(vertex, []).extend(
                    strip.points[station] + along * sign * strip.along[face] + level * up + off
                    for along in (0.0, away)
                    for level in (ribbon.lower, ribbon.upper)
                    for off in (aside, -aside)
                )
    return {vertex: np.array(points) for vertex, points in found.items()}


def cleats_of(
    lamellas: Sequence[Lamella],
    met: Sequence[Sequence[Crossing]],
    wanted: Collection[int],
    settings: LamellaSettings,
    count: int,
) -> tuple[dict[int, Cleat], list[Lamella], list[str]]:
    """Cleats by their vertices, the lamellas with holes for them, and where there was no room.

    Args:
        lamellas: pieces, without holes for cleats.
        met: their crossings.
        wanted: vertices that shall have one.
        settings: of the lamellas.
        count: of the vertices of the net.
    """
    at_vertex: dict[int, list[tuple[int, int]]] = {}
    for index, row in enumerate(met):
        for crossing in row:
            at_vertex.setdefault(crossing.vertex, []).append((index, crossing.station))
    slots = {
        (lamella.name, crossing.vertex): crossing.slot.width
        for lamella, row in zip(lamellas, met, strict=True)
        for crossing in row
        if crossing.slot is not None
    }
    names, found, left_out = part_names("C", count), dict[int, Cleat](), list[str]()
    drilled: dict[int, list[tuple[int, FloatArray]]] = {}
    legs: dict[int, list[float]] = {}
    ways = _ways(settings)
    for vertex in sorted(wanted):
        there = at_vertex.get(vertex, [])
        if len(there) != 2:
            continue
        pairs = _arms(lamellas, there)
        pairs = [pair for pair in pairs for _ in ways]
        made = [
            _cleat(pair, vertex, names[vertex], settings, slots, ways[k % len(ways)])
            for k, pair in enumerate(pairs)
        ]
        fitting = [
            k
            for k, each in enumerate(made)
            if each is not None and fits(pairs[k], each, wanted, slots, settings)
        ]
        best = max(
            fitting, key=lambda k: (-(k % len(ways)), round(_angle(made[k]), 6)), default=None
        )
        if best is None:
            left_out.append(names[vertex])
            continue
        cleat = made[best]
        assert cleat is not None
        found[vertex] = cleat
        for leg, ((index, _), arm) in enumerate(zip(there, pairs[best], strict=True)):
            drilled.setdefault(index, []).append((arm.face, arm.pattern(cleat.bolts(leg))))
            legs.setdefault(index, []).append(arm.place(cleat.sizes.reach))
    bored = [
        replace(
            lamella,
            bolts=(*lamella.bolts, *drilled.get(index, [])),
            legs=tuple(legs.get(index, [])),
        )
        for index, lamella in enumerate(lamellas)
    ]
    return found, bored, left_out


def _ways(settings: LamellaSettings) -> list[tuple[int, bool]]:
    """How bolts are spread, and whether legs rise with their lamellas, the best first.

    Fins of feet are as high as legs that are square to the corner.
    """
    square = [] if settings.position == "tilted" else [(spread, False) for spread in _SPREADS]
    return square + ([] if settings.feet else [(spread, True) for spread in _SPREADS])


def _angle(cleat: Cleat | None) -> float:
    return 0.0 if cleat is None else cleat.angle


def _arms(lamellas: Sequence[Lamella], there: Sequence[tuple[int, int]]) -> list[tuple[Arm, Arm]]:
    """Pairs of arms of two lamellas at a vertex, each to the next vertex of its own."""
    sides = []
    for index, station in there:
        lamella = lamellas[index]
        known = set(lamella.stations)
        ways = [ahead for ahead in (True, False) if station + (1 if ahead else -1) in known]
        sides.append([Arm(lamella, station, ahead) for ahead in ways])
    return [(one, two) for one, two in product(*sides)]


def _cleat(
    pair: tuple[Arm, Arm],
    vertex: int,
    name: str,
    settings: LamellaSettings,
    slots: Slots,
    way: tuple[int, bool],
) -> Cleat | None:
    """The cleat between two arms, one of ``_ways``; None where they are nearly in line."""
    spread, askew = way
    cosine, slot = float(pair[0].way @ pair[1].way), 0.0
    if askew:
        # Plates that lean over each other make another angle than their edges, in wide slots.
        cosine = -float(_inwards(*pair, 0.0)[1] @ _inwards(*pair[::-1], 0.0)[1])
        slot = max(slots.get((arm.lamella.name, vertex), 0.0) for arm in pair)
    if abs(cosine) > _FLAT:
        return None
    sizes = sizes_of(settings, math.acos(cosine), spread=spread, slot=slot)
    places = [_inwards(*arms, sizes.reach / 2) for arms in (pair, pair[::-1])]
    seen, outs = [point for point, _ in places], [out for _, out in places]
    if askew:
        slopes = [
            abs(_slope(arm, out, np.cross(outs[0], outs[1])))
            for arm, out in zip(pair, outs, strict=True)
        ]
        if max(slopes) > _STEEP:
            return None
        sizes = sizes_of(settings, math.acos(cosine), spread=spread, slot=slot, slope=max(slopes))
    lifts = [0.0, 0.0]
    for _ in range(_ROUNDS):
        made = _between(pair, vertex, name, (seen, outs), sizes, lifts, askew)
        if not askew:
            return made
        # Where a leg passes the bend line at the crossing, it stands off what lies beyond that.
        off = [off_leg(arm, made, number) for number, arm in enumerate(pair)]
        lifts = [max(0.0, lift + more) for lift, more in zip(lifts, off, strict=True)]
    return made if max(lifts) <= LIFTED else None


def _between(
    pair: tuple[Arm, Arm],
    vertex: int,
    name: str,
    planes: tuple[Sequence[FloatArray], Sequence[FloatArray]],
    sizes: CleatSizes,
    lifts: Sequence[float],
    askew: bool,
) -> Cleat:
    """The cleat between two arms by points (3,) and inward normals of their planes.

    Legs are off their lamellas by what these twist over their width and by ``lifts``, mm.
    """
    seen, outs = planes
    vertex_point = pair[0].lamella.ribbon.strip.points[pair[0].station]
    # How far twisted plates leave their planes depends on where the legs are, and these on that.
    legs = [Leg(arm.lamella.name, arm.way, out, 0.0) for arm, out in zip(pair, outs, strict=True)]
    for _ in range(_ROUNDS):
        halves = [sizes.plate / 2 + leg.gap for leg in legs]
        points = [point + half * out for point, half, out in zip(seen, halves, outs, strict=True)]
        corner, up = corner_of((points[0], points[1]), (outs[0], outs[1]), vertex_point)
        for k, (arm, point, out) in enumerate(zip(pair, seen, outs, strict=True)):
            way = np.cross(up, out)
            way = np.copysign(1.0, float(way @ arm.way)) * way
            ends = np.array([corner, corner + sizes.reach * way])
            gap = twist_gap(arm, point, out, ends, up) + lifts[k]
            legs[k] = replace(legs[k], way=way, gap=gap)
    # The first leg, the way into the corner and the line turn like x, y and z.
    if float(np.cross(legs[0].way, legs[0].out) @ up) < 0:
        up = -up
    legs = [
        replace(leg, side=_side(arm, up), slope=_slope(arm, leg.out, up) if askew else 0.0)
        for arm, leg in zip(pair, legs, strict=True)
    ]
    made = Cleat(name, vertex, corner, up, (legs[0], legs[1]), sizes)
    return replace(made, corner=corner - off_middle(pair, made) * up)


def _inwards(arm: Arm, other: Arm, distance: float) -> tuple[FloatArray, FloatArray]:
    """Point of an axis so far from the vertex, mm, and normal of its plate to the other arm."""
    length = float(arm.lamella.ribbon.strip.lengths[arm.face])
    point, normal = arm.at(min(distance, length / 2))
    return point, np.copysign(1.0, float(normal @ other.way)) * normal


def _slope(arm: Arm, out: FloatArray, up: FloatArray) -> float:
    """How far a lamella rises along a corner per length square to it in its plane."""
    up = unit_rows(up[None])[0]
    way = np.cross(up, out)
    return float(arm.way @ up) / abs(float(arm.way @ way))


def _side(arm: Arm, up: FloatArray) -> float:
    """1 where one of two layers lies on the side of the net that ``up`` points to, else -1."""
    ribbon = arm.lamella.ribbon
    rises = float(ribbon.strip.across[0][arm.face] @ up)
    return math.copysign(1.0, (ribbon.lower + ribbon.upper) * rises)
