"""Lamellas longer than the stock: cut between crossings, their ends bolted to splice plates."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.ribbon import Ribbon
from freecad_ortho.fabrication.systems.lamellas.settings import EDGE_DISTANCE, LamellaSettings
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray
from solver.unroll.strip import Strip

# Distance between bolts, in diameters of their holes (EN 1993-1-8, table 3.3, asks for 2.2).
_BOLT_DISTANCE = 2.4
# Thicknesses that a plate keeps away from a crossing, as it stands out on one side.
_ROOM = 3.0


@dataclass(frozen=True, eq=False)
class Joint:
    """Where a lamella is cut.

    Attributes:
        face: of its ribbon.
        place: along the face's edge, mm.
    """

    face: int
    place: float


@dataclass(frozen=True, eq=False)
class Splice:
    """A plate that joins two pieces of a lamella.

    Attributes:
        name: ``S-U003-1`` joins ``L-U003-1`` and ``L-U003-2``.
        lamella: the whole one, before it was cut.
        joint: that it covers.
        pieces: names of the pieces.
    """

    name: str
    lamella: Lamella
    joint: Joint
    pieces: tuple[str, str]


def bolts(settings: LamellaSettings) -> FloatArray:
    """(N, 2) bolts of one end of a lamella: distance from the end, and level from its middle."""
    first = EDGE_DISTANCE * settings.hole
    along = [first, first + _BOLT_DISTANCE * settings.hole]
    two_rows = settings.width >= (2 * EDGE_DISTANCE + _BOLT_DISTANCE) * settings.hole
    levels = (-settings.width / 4, settings.width / 4) if two_rows else (0.0,)
    return np.array([(distance, level) for distance in along for level in levels])


def half_length(settings: LamellaSettings) -> float:
    """Half the length of a splice plate, mm."""
    ends = 2 * EDGE_DISTANCE + _BOLT_DISTANCE
    return settings.clearance / 2 + ends * settings.hole


def spliced(lamella: Lamella, settings: LamellaSettings) -> tuple[list[Lamella], list[Splice]]:
    """Cut a lamella that is longer than the stock; others come back as they are.

    Pieces are of about one length; in every second line the joints lie in the middle between those
    of its neighbours.

    Raises:
        InputError: no room for splices where they would be needed.
    """
    strip = lamella.ribbon.strip
    if settings.stock is None or strip.lengths.sum() <= settings.stock * (1 + 1e-9):
        return [lamella], []
    joints = _joints(lamella, settings)
    bounds = [None, *joints, None]
    pieces = [
        _piece(lamella, start, end, f"{lamella.name}-{number}", settings)
        for number, (start, end) in enumerate(pairwise(bounds), start=1)
    ]
    stem = lamella.name.replace("L-", "S-", 1)
    splices = [
        Splice(f"{stem}-{number}", lamella, joint, (one.name, two.name))
        for number, (joint, (one, two)) in enumerate(
            zip(joints, pairwise(pieces), strict=True), start=1
        )
    ]
    return pieces, splices


def _joints(lamella: Lamella, settings: LamellaSettings) -> list[Joint]:
    """Where to cut, in order: as few pieces as the stock and the room for splices allow."""
    strip = lamella.ribbon.strip
    reached = np.concatenate([[0.0], np.cumsum(strip.lengths)])
    total, stock = float(reached[-1]), settings.stock or math.inf
    faces = [face for face in range(len(strip.lengths)) if _has_room(lamella, face, settings)]
    places = np.array([0.5 * (reached[face] + reached[face + 1]) for face in faces])
    shift = 0.5 * (lamella.line % 2)
    for count in range(math.ceil(total / stock), len(faces) + 2):
        shares = (np.arange(count + (shift > 0)) - shift)[1:] / count
        if not len(faces):
            break
        chosen = [int(np.abs(places - share * total).argmin()) for share in shares]
        lengths = np.diff([0.0, *places[chosen], total])
        if lengths.min() > 0 and lengths.max() <= stock:
            return [Joint(faces[k], float(strip.lengths[faces[k]]) / 2) for k in chosen]
    needed = 2 * (half_length(settings) + _room(settings))
    raise InputError(
        f"stock: {lamella.name} is {total:.1f} mm long, the stock {stock:g} mm, and it has no room "
        f"for splices {2 * half_length(settings):.3g} mm long often enough: they need plane edges "
        f"of {needed:.3g} mm between crossings and a width of "
        f"{2 * EDGE_DISTANCE * settings.hole:.3g} mm; take longer stock, smaller holes or coarser "
        "lines"
    )


def _room(settings: LamellaSettings) -> float:
    """Distance of a splice plate from a crossing."""
    beside = max(_ROOM * settings.thickness, EDGE_DISTANCE * settings.hole)
    return beside + settings.clearance


def _has_room(lamella: Lamella, face: int, settings: LamellaSettings) -> bool:
    """Whether a splice plate fits between two crossings, clear of bend lines."""
    ribbon = lamella.ribbon
    strip = ribbon.strip
    if not {face, face + 1} <= set(lamella.stations):
        return False
    if settings.width < 2 * EDGE_DISTANCE * settings.hole:
        return False
    if strip.lengths[face] / 2 < half_length(settings) + _room(settings):
        return False
    corners = _plate_outline(ribbon, Joint(face, strip.lengths[face] / 2), settings)
    mitres = 2 * ribbon.thickness * np.abs(np.tan(strip.bends[[face, face + 1]] / 2))
    return bool(
        ribbon.ahead(face, corners).min() > mitres[0]
        and ribbon.ahead(face + 1, corners).max() < -mitres[1]
    )


def _plate_outline(ribbon: Ribbon, joint: Joint, settings: LamellaSettings) -> FloatArray:
    """(4, 2) corners of a splice plate in the lamella's pattern, counter-clockwise."""
    half = half_length(settings)
    along = np.array([-half, half, half, -half])
    across = np.array([ribbon.lower, ribbon.lower, ribbon.upper, ribbon.upper])
    return _in_pattern(ribbon, joint, along, across)


def _in_pattern(ribbon: Ribbon, joint: Joint, along: FloatArray, level: FloatArray) -> FloatArray:
    """(N, 2) points of the pattern at distances from a joint along the edge and across it."""
    across = ribbon.flat_across[joint.face]
    forwards = np.array([across[1], -across[0]])
    middle = ribbon.strip.flat_points[joint.face] + joint.place * forwards
    return np.asarray(middle + along[:, None] * forwards + level[:, None] * across)


def _piece(
    lamella: Lamella,
    start: Joint | None,
    end: Joint | None,
    name: str,
    settings: LamellaSettings,
) -> Lamella:
    """The part of a lamella between two joints, its ends square and half a clearance from them."""
    whole = lamella.ribbon.strip
    first = 0 if start is None else start.face + 1
    last = len(whole.points) if end is None else end.face + 1
    points, rulings = list(whole.points[first:last]), list(whole.rulings[first:last])
    back = settings.clearance / 2
    if start is not None:
        point, ruling = square_end(whole, Joint(start.face, start.place + back))
        points, rulings = [point, *points], [ruling, *rulings]
    if end is not None:
        point, ruling = square_end(whole, Joint(end.face, end.place - back))
        points, rulings = [*points, point], [*rulings, ruling]
    ribbon = replace(lamella.ribbon, strip=Strip(np.array(points), np.array(rulings)))
    moved = 0 if start is None else 1
    kept = [
        (vertex, station - first + moved)
        for vertex, station in zip(lamella.vertices, lamella.stations, strict=True)
        if first <= station < last
    ]
    drilled = []
    if start is not None:
        drilled.append((0, _end_bolts(ribbon, Joint(0, 0.0), 1.0, settings)))
    if end is not None:
        face = len(points) - 2
        place = Joint(face, float(ribbon.strip.lengths[face]))
        drilled.append((face, _end_bolts(ribbon, place, -1.0, settings)))
    return replace(
        lamella,
        name=name,
        vertices=tuple(vertex for vertex, _ in kept),
        stations=tuple(station for _, station in kept),
        ribbon=ribbon,
        bolts=tuple(drilled),
    )


def square_end(strip: Strip, joint: Joint) -> tuple[FloatArray, FloatArray]:
    """Point of the axis at a joint, and the direction across it in the strip."""
    face = joint.face
    along, up = strip.along[face], strip.across[0][face]
    angle = strip.twists[face] * joint.place / strip.lengths[face]
    ruling = np.cos(angle) * up + np.sin(angle) * np.cross(along, up)
    return strip.points[face] + joint.place * along, ruling


def _end_bolts(ribbon: Ribbon, end: Joint, inwards: float, settings: LamellaSettings) -> FloatArray:
    """(N, 2) bolts of an end in the pattern."""
    distance, level = bolts(settings).T
    middle = 0.5 * (ribbon.lower + ribbon.upper)
    return _in_pattern(ribbon, end, inwards * distance, middle + level)


def pieces_of(
    lamellas: Sequence[Lamella], settings: LamellaSettings
) -> tuple[list[Lamella], list[Splice]]:
    """Pieces of all lamellas in order, and the plates that join them.

    Raises:
        InputError: no room for splices where they would be needed.
    """
    pieces: list[Lamella] = []
    splices: list[Splice] = []
    for lamella in lamellas:
        cut, joined = spliced(lamella, settings)
        pieces += cut
        splices += joined
    return pieces, splices
