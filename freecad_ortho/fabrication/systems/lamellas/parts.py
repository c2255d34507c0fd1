"""Lamellas as parts: bodies, flat patterns with their marks, measures."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_ortho.fabrication.bodies import Body
from freecad_ortho.fabrication.drilled import Drill, DrilledBody
from freecad_ortho.fabrication.part import Measures, Part
from freecad_ortho.fabrication.pattern import (
    Bend,
    FlatPattern,
    Hole,
    Mark,
    fitted_text_size,
    longest_within,
    overlaps_itself,
    polygon_area,
)
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.bolts import half_length
from freecad_ortho.fabrication.systems.lamellas.cells import hulls
from freecad_ortho.fabrication.systems.lamellas.crossings import Crossing
from freecad_ortho.fabrication.systems.lamellas.facets import folded_body
from freecad_ortho.fabrication.systems.lamellas.outline import Slot, notch, outline
from freecad_ortho.fabrication.systems.lamellas.reliefs import relieved
from freecad_ortho.fabrication.systems.lamellas.ribbon import FLAT, Ribbon
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from freecad_ortho.fabrication.systems.lamellas.spans import Drilled, span_body
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, unit_rows

# Length of the marks at crossings, in widths.
_TICK = 0.3


@dataclass(frozen=True, eq=False)
class CutLamella:
    """A lamella with what is cut from it.

    Attributes:
        lamella: that is cut.
        crossings: with others, in order.
        outline: (N, 2) of the flat pattern, in the strip's own plane.
        holes: bolt holes in the same plane: at crossings where layers are bolted, then at spliced
            ends.
        body: solid in the model's coordinates near the origin, without holes.
        drilled: the same with holes.
    """

    lamella: Lamella
    crossings: Sequence[Crossing]
    outline: FloatArray
    holes: tuple[Drilled, ...]
    body: RuledBody
    drilled: RuledBody


def cut(lamella: Lamella, crossings: Sequence[Crossing], settings: LamellaSettings) -> CutLamella:
    """Cut slots and holes.

    Raises:
        InputError: slots that run into each other or out at an end, or a pattern that overlaps
            itself.
    """
    ribbon = lamella.ribbon
    slotted = [crossing for crossing in crossings if crossing.slot is not None]
    slots = [crossing.slot for crossing in slotted if crossing.slot is not None]
    notches = [
        notch(ribbon, slot, lamella.name, crossing.other)
        for slot, crossing in zip(slots, slotted, strict=True)
    ]
    edge = outline(ribbon, slots, notches, lamella.name)
    if overlaps_itself(edge):
        raise InputError(
            f"lamellas: the flat pattern of {lamella.name} overlaps itself; build its "
            "two families apart, or cut the mesh"
        )
    holes = _holes(lamella, crossings, settings)
    body, drilled = _bodies(lamella, slots, edge, holes, settings)
    if settings.cutter is not None:
        edge = relieved(edge, [made.floor for made in notches], settings.cutter, lamella.name)
    return CutLamella(lamella, crossings, edge, holes, body, drilled)


def _holes(
    lamella: Lamella, crossings: Sequence[Crossing], settings: LamellaSettings
) -> tuple[Drilled, ...]:
    """Holes at crossings where layers are bolted, then those at spliced ends."""
    ribbon = lamella.ribbon
    middle = ribbon.edge(0.5 * (ribbon.lower + ribbon.upper))
    bolted = [each.station for each in crossings if each.bolted]
    return (
        *(Drilled(None, station, middle[station], settings.hole) for station in bolted),
        *(
            Drilled(face, None, place, settings.hole)
            for face, points in lamella.bolts
            for place in points
        ),
    )


def _bodies(
    lamella: Lamella,
    slots: Sequence[Slot],
    edge: FloatArray,
    holes: Sequence[Drilled],
    settings: LamellaSettings,
) -> tuple[RuledBody, RuledBody]:
    """The solid without its holes and with them."""
    ribbon = lamella.ribbon
    if not lamella.twisted:
        whole = folded_body(ribbon, edge)
        return whole, folded_body(ribbon, edge, holes) if holes else whole
    smooth, name = settings.smooth, lamella.name
    plated = half_length(settings) - settings.clearance / 2 if lamella.bolts else 0.0
    blocks = hulls(ribbon, slots, smooth, plated, lamella.legs)
    whole = span_body(ribbon, slots, (), smooth, name, blocks)
    # Slots and the ends under splice plates are cut across the lines that sweep the sides.
    whole = replace(whole, cells=not (slots or smooth or plated))
    return whole, span_body(ribbon, slots, holes, smooth, name) if holes else whole


def lamella_part(made: CutLamella, site: Site, position: str) -> Part:
    """Return the part, its own coordinates in the middle of its axis."""
    lamella, ribbon = made.lamella, made.lamella.ribbon
    origin, frame = ribbon.middle()
    body: Body = made.body.seen_from(origin, frame)
    if made.holes:
        placed = tuple(
            Drill(frame @ (place - origin), frame @ direction, hole.diameter, ribbon.thickness)
            for (place, direction), hole in zip(_drills(made), made.holes, strict=True)
        )
        body = DrilledBody(body, made.drilled.seen_from(origin, frame), placed)
    # The pattern runs along the line from left to right: upwards in it is away from the surface,
    # or across the line to its left where the strip lies.
    pattern = replace(_pattern(made), seen="above" if position == "lying" else "right")
    measures = lamella.measures
    straight = lamella.aim == "straight"
    # A single edge lies on arcs of every radius.
    arc = lamella.pattern == "arc" and np.isfinite(measures.radius)
    bend = measures.smallest_bend_radius
    return Part(
        name=lamella.name,
        kind="lamella",
        body=body,
        origin=origin + site.shift,
        frame=frame,
        pattern=pattern,
        length=float(pattern.size[0]),
        width=float(pattern.size[1]),
        thickness=ribbon.thickness,
        area=pattern.area,
        volume=body.volume,
        material=site.material,
        vertices=lamella.vertices,
        family=lamella.family,
        line=lamella.line,
        curved=lamella.aim != "free" and not lamella.exact,
        measures=Measures(
            gap_mm=measures.gap,
            straightness_mm=measures.straightness if straight else None,
            radius_mm=measures.radius if arc else None,
            radius_spread_mm=measures.radius_spread if arc else None,
            min_bend_radius_mm=bend if np.isfinite(bend) else None,
            shear_MPa=site.material.shear_stress(ribbon.thickness, np.radians(measures.warp_deg))
            if lamella.twisted
            else None,
            lean_deg=measures.lean_deg,
            torsion_deg_per_m=measures.torsion_deg * 1000,
        ),
        height=ribbon.width,
    )


def _drills(made: CutLamella) -> list[tuple[FloatArray, FloatArray]]:
    """Middles of the holes in space, and their directions, in the order of the holes."""
    ribbon = made.lamella.ribbon
    bolted = [each.station for each in made.crossings if each.bolted]
    drills = [_drill(ribbon, station) for station in bolted]
    for face, points in made.lamella.bolts:
        middle, half = ribbon.placed(face, points)
        drills += zip(middle, unit_rows(half), strict=True)
    return drills


def _drill(ribbon: Ribbon, station: int) -> tuple[FloatArray, FloatArray]:
    """Middle of a hole in space, and its direction."""
    strip = ribbon.strip
    level = 0.5 * (ribbon.lower + ribbon.upper) * ribbon.stretch[station]
    return strip.points[station] + level * strip.rulings[station], strip.normals[station]


def _pattern(made: CutLamella) -> FlatPattern:
    """The flat pattern with its axis' ends on a level, lower left corner at the origin."""
    ribbon = made.lamella.ribbon
    strip = ribbon.strip
    chord = strip.flat_points[-1] - strip.flat_points[0]
    if np.linalg.norm(chord) < 0.1 * strip.lengths.sum():
        chord = np.array([1.0, 0.0])
    x, y = chord / np.linalg.norm(chord)
    turn = np.array([[x, y], [-y, x]]).T
    low = (made.outline @ turn).min(axis=0)

    def placed(points: FloatArray) -> FloatArray:
        return np.asarray(points @ turn - low)

    outline_mm = placed(made.outline)
    lower, upper = ribbon.edge(ribbon.lower), ribbon.edge(ribbon.upper)
    ends = np.stack([lower, upper], axis=1)
    for crossing in made.crossings:
        # Where the bend line runs into the slot it ends at the floor.
        if crossing.slot is not None and made.lamella.twisted:
            end = 1 if crossing.slot.upward else 0
            ends[crossing.station, end] = crossing.slot.sides(ribbon).mean(axis=0)
    twists = np.append(np.degrees(strip.twists), 0.0)
    bends = tuple(
        Bend(
            placed(ends[station]),
            -float(np.degrees(angle)),
            placed(strip.flat_points[station][None])[0],
            float(twists[station]),
        )
        for station, angle in enumerate(strip.bends)
        if abs(angle) > FLAT
    )
    label, size, angle = _label(made)
    return FlatPattern(
        outline=outline_mm if polygon_area(outline_mm) > 0 else outline_mm[::-1],
        marks=tuple(_marks(made, placed, turn)),
        label=placed(label[None])[0],
        label_size=size,
        holes=tuple(Hole(placed(hole.centre[None])[0], hole.diameter) for hole in made.holes),
        axis=placed(strip.flat_points),
        bends=bends,
        label_angle=float(np.degrees(np.arctan2(*(angle @ turn)[::-1]))),
    )


def _marks(
    made: CutLamella, placed: Callable[[FloatArray], FloatArray], turn: FloatArray
) -> list[Mark]:
    """A tick and the other's name at each crossing, beside it on the side that stays whole."""
    import shapely

    ribbon = made.lamella.ribbon
    strip = ribbon.strip
    level = 0.5 * (ribbon.lower + ribbon.upper)
    marks = []
    plate = shapely.make_valid(shapely.Polygon(made.outline))
    for crossing in made.crossings:
        station = crossing.station
        slot = crossing.slot
        if slot is None:
            # From the edge to before the hole in the middle, if there is one.
            side, open_width = -1.0, made.holes[0].diameter if crossing.bolted else 0.0
            ruling = ribbon.stretch[station] * strip.flat_rulings[station]
            middle = strip.flat_points[station] + level * ruling
            before = 0.5 * open_width / ribbon.width + 0.1
            tick = (
                middle - np.array([[0.5], [min(before, 0.5 - 0.5 * _TICK)]]) * ribbon.width * ruling
            )
        else:
            side, open_width = (-1.0 if slot.upward else 1.0), slot.width
            floor = slot.sides(ribbon).mean(axis=0)
            tick = floor - np.array([[0.0], [_TICK]]) * ribbon.width * slot.direction
        # The text lies along the edge that follows, in its face.
        across = ribbon.flat_across[station]
        ahead = np.array([across[1], -across[0]])
        room = 0.4 * float(strip.lengths[station])
        size = fitted_text_size(crossing.words, room, 0.3 * ribbon.width, 12.0)
        text_room = 0.5 * (open_width + size * (len(crossing.words) + 1))
        up = level + side * 0.25 * ribbon.width
        place = strip.flat_points[station] + text_room * ahead + up * across
        angle = float(np.degrees(np.arctan2(*(ahead @ turn)[::-1])))
        if (drawn := longest_within(tick, plate)) is not None:
            marks.append(Mark(placed(drawn)))
        marks.append(Mark(placed(place[None]), crossing.words, size, angle))
    return marks


def _label(made: CutLamella) -> tuple[FloatArray, float, FloatArray]:
    """Middle, size and direction of the name: in the longest face, on the slots' side."""
    ribbon = made.lamella.ribbon
    strip = ribbon.strip
    face = int(np.argmax(strip.lengths))
    taken = max((each.slot.width for each in made.crossings if each.slot is not None), default=0.0)
    opens = [each.slot.upward for each in made.crossings if each.slot is not None]
    side = 1.0 if not opens or opens[0] else -1.0
    step = np.diff(strip.flat_points, axis=0)[face] / strip.lengths[face]
    across = np.array([-step[1], step[0]])
    level = 0.5 * (ribbon.lower + ribbon.upper) + side * 0.25 * ribbon.width
    middle = strip.flat_points[[face, face + 1]].mean(axis=0) + level * across
    room = 0.8 * float(strip.lengths[face]) - taken
    size = fitted_text_size(made.lamella.name, max(room, 1.0), 0.4 * ribbon.width)
    return middle, size, step
