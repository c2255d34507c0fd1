"""Where lamellas cross: half-lap slots that the other one passes, or bolt holes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.assembly import SlotWay, lean, turning
from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.outline import Slot, notch
from freecad_ortho.fabrication.systems.lamellas.ribbon import Ribbon
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, unit_rows

# Sine of the angle below which lamellas run along each other rather than cross.
_CROSSING = 0.2
# Room between a slot's corner and a bend line beyond the mitre, mm, and how many thicknesses a slot
# may be widened for it.
_GRAZING = 0.01
# Points along and across the floor of a slot at which it is held against the other lamella.
_ON_FLOOR = 33
_WIDEST = 3.0
# Two lamellas at a vertex: number and station of each.
_Pair = tuple[tuple[int, int], tuple[int, int]]


@dataclass(frozen=True, eq=False)
class Crossing:
    """A lamella at a vertex where another one crosses it.

    Attributes:
        vertex: of the net.
        station: of the lamella.
        other: name of the other one.
        angle_deg: between the two plates.
        slot: cut for the other one, None in two layers.
        bolted: whether a bolt holds both: lying ones in two layers.
    """

    vertex: int
    station: int
    other: str
    angle_deg: float
    slot: Slot | None
    bolted: bool = False


def crossings(lamellas: Sequence[Lamella], settings: LamellaSettings) -> list[list[Crossing]]:
    """Crossings of each lamella, in the order of its stations.

    Raises:
        InputError: lamellas cross at too flat an angle, or a slot would cut one through.
    """
    at_vertex: dict[int, list[tuple[int, int]]] = {}
    for index, lamella in enumerate(lamellas):
        for vertex, station in zip(lamella.vertices, lamella.stations, strict=True):
            if 0 < station < len(lamella.ribbon.strip.points) - 1:
                at_vertex.setdefault(vertex, []).append((index, station))
    met = [
        (vertex, (pair[0], pair[1]))
        for vertex, pair in sorted(at_vertex.items())
        if len(pair) == 2 and pair[0][0] != pair[1][0]
    ]
    angles = [_angle(lamellas, pair, vertex, settings) for vertex, pair in met]
    depths = _depths(lamellas, [pair for _, pair in met], settings)
    found: list[list[Crossing]] = [[] for _ in lamellas]
    for (vertex, pair), angle in zip(met, angles, strict=True):
        for (one, station), (two, there) in (pair, pair[::-1]):
            slot = None
            if settings.layers == 1:
                crossed = lamellas[one], station, lamellas[two], there
                slot = _slot(*crossed, _opens_above(lamellas, one, two), depths[one], settings)
            name, bolted = lamellas[two].name, not settings.standing
            found[one].append(Crossing(vertex, station, name, angle, slot, bolted))
    return [sorted(row, key=lambda crossing: crossing.station) for row in found]


def slot_ways(
    lamellas: Sequence[Lamella],
    met: Sequence[Sequence[Crossing]],
    settings: LamellaSettings,
    material: Material,
) -> dict[str, list[SlotWay]]:
    """How others are pushed into the slots of each lamella, by its name."""
    by_name = {lamella.name: lamella for lamella in lamellas}
    ways: dict[str, list[SlotWay]] = {}
    for lamella, row in zip(lamellas, met, strict=True):
        before = 0
        for crossing in row:
            if crossing.slot is None:
                continue
            own = float(lamella.ribbon.strip.lengths[before : crossing.station].sum())
            before = crossing.station
            other = by_name[crossing.other]
            there = other.stations[other.vertices.index(crossing.vertex)]
            length = float(other.ribbon.strip.lengths[there - 1 : there + 1].min())
            way = SlotWay(
                crossing.other,
                crossing.slot.direction,
                settings.width / 2,
                settings.clearance,
                lean(material, settings.thickness, length),
                turning(material, settings.thickness, own, settings.width / 2),
            )
            ways.setdefault(lamella.name, []).append(way)
    return ways


def _opens_above(lamellas: Sequence[Lamella], one: int, two: int) -> bool:
    """Family u opens above; where families cannot be told apart, the lamella that comes first."""
    families = lamellas[one].family, lamellas[two].family
    return families[0] == "u" if families[0] != families[1] else one < two


def _depths(
    lamellas: Sequence[Lamella],
    pairs: Sequence[_Pair],
    settings: LamellaSettings,
) -> list[float]:
    """By how much the slots of each lamella are deeper than to its axis, mm.

    Half of the clearance; more where lamellas that bend away from each other would meet at the
    corners of their slots' floors: half of it is left there, and each takes half of the rest.

    Raises:
        InputError: slots deeper than three quarters of the width.
    """
    depths = [settings.clearance / 2] * len(lamellas)
    if settings.layers == 2:
        return depths
    for one, two in pairs:
        first, second = ((lamellas[index], station) for index, station in (one, two))
        upward = 1 if _opens_above(lamellas, one[0], two[0]) else -1
        overlap = max(_overlap(first, second, upward), _overlap(second, first, -upward))
        depth = overlap / 2 + settings.clearance / 4
        if depth >= settings.width / 4:
            raise InputError(
                f"lamellas: {first[0].name} and {second[0].name} bend so sharply where they "
                f"cross that their slots would be deeper than three quarters of "
                f"{settings.width:g} mm; take thinner or wider ones"
            )
        for index, _ in (one, two):
            depths[index] = max(depths[index], depth)
    return depths


def _overlap(one: tuple[Lamella, int], two: tuple[Lamella, int], upward: int) -> float:
    """How far the floor of one's slot reaches into the other beyond the other's floor, mm.

    With both floors at the axes, and where both plates are. ``upward`` is 1 where the slot opens
    upwards, -1 where it opens downwards.
    """
    (lamella, station), (other, other_station) = one, two
    direction = _flat_axis(lamella, station, other, other_station)
    across = np.array([direction[1], -direction[0]])
    strip, theirs = lamella.ribbon.strip, other.ribbon.strip
    normal = theirs.normals[other_station]
    sine = np.linalg.norm(np.cross(strip.normals[station], normal))
    steps = other.ribbon.thickness / sine * np.linspace(-1, 1, _ON_FLOOR)[:, None]
    flat = strip.flat_points[station] + steps * across
    if lamella.twisted:
        edges = np.diff(strip.flat_points[station - 1 : station + 2], axis=0)
        before, after = unit_rows(edges)
        flat = strip.flat_points[station] + steps * np.where(steps < 0, before, after)
    middle, side = placed_near(lamella.ribbon, station, flat)
    points = np.concatenate([middle + share * side for share in np.linspace(-1, 1, _ON_FLOOR)])
    arms = points - theirs.points[other_station]
    inside = np.abs(arms @ normal) <= other.ribbon.thickness / 2
    their_direction = _flat_axis(other, other_station, lamella, station)
    heights = _heights(other, other_station, their_direction, arms)
    return float((upward * heights[inside]).max(initial=0.0))


def _heights(lamella: Lamella, station: int, direction: FloatArray, arms: FloatArray) -> FloatArray:
    """(N,) heights above a slot's floor through a station, of points (N, 3) from there."""
    ribbon, strip = lamella.ribbon, lamella.ribbon.strip
    found = []
    for face in (station - 1, station):
        along, across = strip.along[face], strip.across[0 if face == station else 1][face]
        flat_across = ribbon.flat_across[face]
        flat_along = np.array([flat_across[1], -flat_across[0]])
        if lamella.twisted:
            found.append(arms @ across)
            continue
        flat = (arms @ along)[:, None] * flat_along + (arms @ across)[:, None] * flat_across
        found.append(flat @ direction)
    behind = arms @ strip.along[station] < 0
    return np.asarray(np.where(behind, *found))


def _angle(
    lamellas: Sequence[Lamella], pair: _Pair, vertex: int, settings: LamellaSettings
) -> float:
    """Angle between two plates that cross, degrees."""
    one, two = pair
    lamella, other = lamellas[one[0]], lamellas[two[0]]
    normals = [lamella.ribbon.strip.normals[one[1]], other.ribbon.strip.normals[two[1]]]
    plates = np.linalg.norm(np.cross(*normals)) if settings.standing else 1.0
    if plates < _CROSSING:
        raise InputError(
            f"lamellas: {lamella.name} and {other.name} cross at vertex {vertex} at an angle of "
            f"{np.degrees(np.arcsin(plates)):.0f} degrees; leave one out or optimise the net"
        )
    return float(np.degrees(np.arccos(np.clip(abs(normals[0] @ normals[1]), 0, 1))))


def _slot(
    lamella: Lamella,
    station: int,
    other: Lamella,
    other_station: int,
    upward: bool,
    depth: float,
    settings: LamellaSettings,
) -> Slot:
    ribbon = lamella.ribbon
    sign = 1.0 if upward else -1.0
    direction = sign * _flat_axis(lamella, station, other, other_station)
    reach = max(abs(ribbon.lower), abs(ribbon.upper))
    half = _half_width(lamella, station, other, other_station, sign * direction, sign * reach)
    width = 2 * half + settings.clearance
    slot = Slot(station, direction, -depth, width, upward)
    if lamella.twisted:
        return slot
    return clear_of_bend(ribbon, slot, lamella.name, other.name)


def clear_of_bend(ribbon: Ribbon, slot: Slot, name: str, other: str) -> Slot:
    """The slot, widened until no bend line grazes its corners.

    On both sides of the plate a bend line lies off its place in the middle by the mitre, so a
    corner nearer than that would lie in one face on one side and in the other on the other.

    Args:
        ribbon: that the slot is cut from.
        slot: where and how wide.
        name: of the lamella, for the message.
        other: of the one that crosses.

    Raises:
        InputError: the bend line runs along the slot, or a side of it misses the edge.
    """
    station = slot.station
    mitre = ribbon.thickness * abs(np.tan(ribbon.strip.bends[station] / 2)) + _GRAZING
    widest = slot.width + _WIDEST * ribbon.thickness
    while slot.width <= widest:
        made = notch(ribbon, slot, name, other)
        corners = np.concatenate([made.floor, made.mouth])
        if np.abs(ribbon.ahead(station, corners)).min() > mitre:
            return slot
        slot = replace(slot, width=slot.width + 0.5 * mitre)
    raise InputError(
        f"lamellas: a bend line of {name} runs along its slot for {other}; take strip "
        "twisted or auto, or a smaller thickness"
    )


def _flat_axis(lamella: Lamella, station: int, other: Lamella, other_station: int) -> FloatArray:
    """(2,) direction of the line in which the two plates meet, upwards in the pattern."""
    strip = lamella.ribbon.strip
    ruling: FloatArray = strip.flat_rulings[station]
    if lamella.twisted:
        return ruling
    normal = strip.normals[station]
    line = np.cross(normal, other.ribbon.strip.normals[other_station])
    up, ahead = strip.rulings[station], np.cross(strip.rulings[station], normal)
    flat = (line @ up) * ruling + (line @ ahead) * np.array([ruling[1], -ruling[0]])
    return np.asarray(flat / np.linalg.norm(flat) * (1.0 if flat @ ruling > 0 else -1.0))


def _half_width(
    lamella: Lamella,
    station: int,
    other: Lamella,
    other_station: int,
    axis: FloatArray,
    reach: float,
) -> float:
    """Largest distance of the other plate from the slot's axis, where it passes this plate.

    Measured in this plate's plane at the crossing, at the axis and at the mouth, on all four lines
    in which the sides of the two plates meet: thickness over the sine of the crossing angle, what
    a skew crossing adds, and what the other plate bends and twists on its way.
    """
    strip, theirs = lamella.ribbon.strip, other.ribbon.strip
    normal, up = strip.normals[station], strip.rulings[station]
    ahead = np.cross(up, normal)
    ruling = strip.flat_rulings[station]
    flat_ahead = np.array([ruling[1], -ruling[0]])
    away = np.array([axis[1], -axis[0]])
    their_axis = _flat_axis(other, other_station, lamella, station)
    slope = theirs.normals[other_station] @ normal
    run = lamella.ribbon.thickness / 2 / np.sqrt(1 - slope**2)
    skew = other.ribbon.thickness / 2 * abs(slope) / np.sqrt(1 - slope**2)
    across = np.array([their_axis[1], -their_axis[0]])
    heights = np.array([0.0, 0.5, 1.0]) * reach
    line = theirs.flat_points[other_station] + heights[:, None] * their_axis
    # Where the other plate leans, its axis leaves this plane: start from where it meets it.
    (middle, _), (ahead_of, _) = (
        placed_near(other.ribbon, other_station, points) for points in (line, line + run * across)
    )
    off = (middle - strip.points[station]) @ normal
    met = -run * off / ((ahead_of - middle) @ normal)
    offsets = np.array([-1, 0, 1])[:, None] * (run + skew) + met
    flat = (line + offsets[..., None] * across).reshape(-1, 2)
    middle, half = placed_near(other.ribbon, other_station, flat)
    worst = 0.0
    for side in (-1, 1):
        arms = middle + side * half - strip.points[station]
        inside = np.abs(arms @ normal) <= run * 1.5 + skew
        local = (arms @ ahead)[:, None] * flat_ahead + (arms @ up)[:, None] * ruling
        if inside.any():
            worst = max(worst, float(np.abs(local[inside] @ away).max()))
    return worst


def placed_near(ribbon: Ribbon, station: int, flat: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Points of the pattern around a station in space, each with the face that it lies in.

    Returns:
        (N, 3) points in the middle of the plate and (N, 3) from there to its upper side.
    """
    middle, half = ribbon.placed(station, flat)
    behind = ribbon.ahead(station, flat) < 0
    middle[behind], half[behind] = ribbon.placed(station - 1, flat[behind])
    return middle, half
