"""Where lamellas cross: half-lap slots that the other one passes, or bolt holes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.assembly import SlotWay, lean, turning
from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.laps import flat_axis, floors_overlap, half_width
from freecad_ortho.fabrication.systems.lamellas.outline import Slot, notch
from freecad_ortho.fabrication.systems.lamellas.ribbon import Ribbon
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from solver.errors import InputError

# Sine of the angle below which lamellas run along each other rather than cross.
_CROSSING = 0.2
# Room between a slot's corner and a bend line beyond the mitre, mm, and how many thicknesses a slot
# may be widened for it.
_GRAZING = 0.01
# Least cosine of the angle between the rulings of two lamellas that is reckoned with.
_ALONG = 0.5
_WIDEST = 3.0
# Times as wide as the plate and its play from which on a slot is said to be wide.
_LOOSE = 3.0
# Two lamellas at a vertex: number and station of each.
_Pair = tuple[tuple[int, int], tuple[int, int]]
# By vertex the lamellas there: number and station of each.
At = dict[int, list[tuple[int, int]]]


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
        also: names of further ones that cross there.
    """

    vertex: int
    station: int
    other: str
    angle_deg: float
    slot: Slot | None
    bolted: bool = False
    also: tuple[str, ...] = ()

    @property
    def words(self) -> str:
        """What is written beside it in the pattern."""
        return " ".join((self.other, *self.also))


def at_vertices(lamellas: Sequence[Lamella]) -> At:
    """By vertex the lamellas that run through it and go on beyond it on both sides."""
    found: At = {}
    for index, lamella in enumerate(lamellas):
        for vertex, station in zip(lamella.vertices, lamella.stations, strict=True):
            if 0 < station < len(lamella.ribbon.strip.points) - 1:
                found.setdefault(vertex, []).append((index, station))
    return found


def crossings(lamellas: Sequence[Lamella], settings: LamellaSettings) -> list[list[Crossing]]:
    """Crossings of each lamella, in the order of its stations.

    Raises:
        InputError: lamellas cross at too flat an angle, or a slot would cut one through.
    """
    met = [
        (vertex, (pair[0], pair[1]))
        for vertex, pair in sorted(at_vertices(lamellas).items())
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


def said_of_wide(
    lamellas: Sequence[Lamella], met: Sequence[Sequence[Crossing]], settings: LamellaSettings
) -> list[str]:
    """What a user should know about slots that are far wider than the plate that passes them."""
    wide = [
        (crossing.slot.width, lamella.name, crossing.other)
        for lamella, row in zip(lamellas, met, strict=True)
        for crossing in row
        if crossing.slot is not None
        and crossing.slot.width > _LOOSE * (settings.thickness + settings.clearance)
    ]
    if not wide:
        return []
    width, name, other = max(wide)
    return [
        f"lamellas: {len(wide)} slots are wide for plates of {settings.thickness:g} mm, as both "
        f"lean differently where they cross: up to {width:.3g} mm, that of {name} for {other}; "
        "there the slot alone does not hold the other one upright"
    ]


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
        overlap = max(floors_overlap(first, second, upward), floors_overlap(second, first, -upward))
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
    direction = sign * flat_axis(lamella, station, other, other_station, sign)
    # As far as the edge that the slot opens to, which a slanted ruling reaches later.
    reach = abs(ribbon.upper if upward else ribbon.lower) * float(ribbon.stretch[station])
    along = abs(float(ribbon.strip.rulings[station] @ other.ribbon.strip.rulings[other_station]))
    reach /= max(along, _ALONG)
    half = half_width(lamella, station, other, other_station, sign * direction, sign * reach)
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
