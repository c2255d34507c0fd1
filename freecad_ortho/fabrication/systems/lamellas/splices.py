"""Lamellas that are longer than the stock, or closed: cut, their ends bolted to splice plates."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.bolts import (
    bolts,
    half_length,
    least_edge,
    least_width,
)
from freecad_ortho.fabrication.systems.lamellas.cleat_sizes import edge_for_splice
from freecad_ortho.fabrication.systems.lamellas.ribbon import Ribbon
from freecad_ortho.fabrication.systems.lamellas.settings import LamellaSettings
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray
from solver.unroll.strip import Strip


@dataclass(frozen=True, eq=False)
class Joint:
    """Where a lamella is cut.

    Attributes:
        face: of its ribbon.
        place: along the face's edge, mm.
        plated: whether a splice plate is bolted over it.
        ruling: (3,) unit direction of the cut across the strip, None for one square to it.
    """

    face: int
    place: float
    plated: bool = True
    ruling: FloatArray | None = None


@dataclass(frozen=True, eq=False)
class SplicePlate:
    """A plate that joins two pieces of a lamella.

    Attributes:
        name: ``S-U002-1`` joins ``L-U002-1`` and ``L-U002-2``.
        lamella: the whole one, before it was cut.
        joint: that it covers.
        pieces: names of the pieces; those of a ring in one piece are the same.
    """

    name: str
    lamella: Lamella
    joint: Joint
    pieces: tuple[str, str]

    @property
    def closes(self) -> bool:
        """Whether it joins the end of a closed lamella to its start."""
        return self.lamella.closed and self.joint.face == 0


def spliced(
    lamella: Lamella, settings: LamellaSettings, taken: Collection[int] = ()
) -> tuple[list[Lamella], list[SplicePlate]]:
    """Cut a lamella that is longer than the stock or closed; others come back as they are.

    Pieces are of about one length; in every second line the joints lie in the middle between those
    of its neighbours. Beside vertices that are ``taken``, by
    cleats, they take longer edges.

    Raises:
        InputError: no room for splices where they would be needed.
    """
    beside = _beside(lamella, taken)
    begin, end = _ends(lamella, settings, beside)
    joints = _joints(lamella, settings, (begin, end), beside)
    if not (joints or lamella.closed):
        return [lamella], []
    bounds = [begin, *joints, end] if lamella.closed else [None, *joints, None]
    pieces = [
        piece_between(lamella, start, stop, f"{lamella.name}-{number}" if joints else "", settings)
        for number, (start, stop) in enumerate(pairwise(bounds), start=1)
    ]
    pairs = [*zip(joints, pairwise(pieces), strict=True)]
    if lamella.closed and begin.plated:
        pairs.append((begin, (pieces[-1], pieces[0])))
    stem = lamella.name.replace("L-", "S-", 1)
    splices = [
        SplicePlate(f"{stem}-{number}", lamella, joint, (one.name, two.name))
        for number, (joint, (one, two)) in enumerate(pairs, start=1)
    ]
    return pieces, splices


def _beside(lamella: Lamella, taken: Collection[int]) -> set[int]:
    """Faces beside vertices that are taken."""
    pairs = zip(lamella.vertices, lamella.stations, strict=True)
    return {face for vertex, station in pairs if vertex in taken for face in (station - 1, station)}


def _ends(
    lamella: Lamella, settings: LamellaSettings, beside: Collection[int]
) -> tuple[Joint, Joint]:
    """Where a lamella begins and ends: a closed one in the middle of its first and last face."""
    strip = lamella.ribbon.strip
    last = len(strip.lengths) - 1
    if not lamella.closed:
        return Joint(0, 0.0, False), Joint(last, float(strip.lengths[last]), False)
    begin, end = (Joint(face, float(strip.lengths[face]) / 2) for face in (0, last))
    (_, first), (_, second) = square_end(strip, begin), square_end(strip, end)
    ribbon = lamella.ribbon
    askew = max(abs(ribbon.lower), abs(ribbon.upper)) * float(np.linalg.norm(first - second))
    plated = askew <= settings.clearance / 2
    plated &= all(
        joint.face not in beside or float(strip.lengths[joint.face]) >= edge_for_splice(settings)
        for joint in (begin, end)
    )
    plated &= all(_has_room(lamella, joint.face, settings) for joint in (begin, end))
    return replace(begin, plated=plated), replace(end, plated=plated)


def _joints(
    lamella: Lamella,
    settings: LamellaSettings,
    ends: tuple[Joint, Joint],
    beside: Collection[int],
) -> list[Joint]:
    """Where to cut, in order: as few pieces as the stock and the room for splices allow."""
    strip, (begin, end) = lamella.ribbon.strip, ends
    reached = np.concatenate([[0.0], np.cumsum(strip.lengths)]) - begin.place
    total, stock = float(reached[end.face]) + end.place, settings.longest
    if total <= stock * (1 + 1e-9):
        return []
    faces = [
        face
        for face in range(len(strip.lengths))
        if {face, face + 1} <= set(lamella.stations)
        and (face not in beside or strip.lengths[face] >= edge_for_splice(settings))
        and _has_room(lamella, face, settings)
    ]
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
    apart = float(np.diff([0.0, *places, total]).max())
    needed = edge_for_splice(settings) if beside else least_edge(settings)
    raise InputError(
        f"stock: {lamella.name} is {total:.1f} mm long, a bar gives {stock:g} mm, and it has no "
        f"room for splices {2 * half_length(settings):.3g} mm long often enough: they need plane "
        f"edges of {needed:.3g} mm between crossings, the middles of two of them no further apart "
        f"than the stock ({apart:.0f} mm here), and a width of {least_width(settings):.3g} mm; "
        "take longer stock, smaller holes or other lines"
    )


def _has_room(lamella: Lamella, face: int, settings: LamellaSettings) -> bool:
    """Whether a splice plate fits between two crossings, clear of bend lines."""
    ribbon = lamella.ribbon
    strip = ribbon.strip
    if settings.width < least_width(settings) or strip.lengths[face] < least_edge(settings):
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


def piece_between(
    lamella: Lamella,
    start: Joint | None,
    end: Joint | None,
    name: str,
    settings: LamellaSettings,
) -> Lamella:
    """The part of a lamella between two joints, its ends square and half a clearance from them.

    Without a ``name`` it has that of the whole.
    """
    whole = lamella.ribbon.strip
    first = 0 if start is None else start.face + 1
    last = len(whole.points) if end is None else end.face + 1
    points, rulings = list(whole.points[first:last]), list(whole.rulings[first:last])
    back = settings.clearance / 2
    if start is not None:
        point, ruling = square_end(whole, replace(start, place=start.place + back))
        points, rulings = [point, *points], [ruling, *rulings]
    if end is not None:
        point, ruling = square_end(whole, replace(end, place=end.place - back))
        points, rulings = [*points, point], [*rulings, ruling]
    ribbon = replace(lamella.ribbon, strip=Strip(np.array(points), np.array(rulings)))
    moved = 0 if start is None else 1
    kept = [
        (vertex, station - first + moved)
        for vertex, station in zip(lamella.vertices, lamella.stations, strict=True)
        if first <= station < last
    ]
    drilled = []
    if start is not None and start.plated:
        drilled.append((0, _end_bolts(ribbon, Joint(0, 0.0), 1.0, settings)))
    if end is not None and end.plated:
        face = len(points) - 2
        place = Joint(face, float(ribbon.strip.lengths[face]))
        drilled.append((face, _end_bolts(ribbon, place, -1.0, settings)))
    return replace(
        lamella,
        name=name or lamella.name,
        vertices=tuple(vertex for vertex, _ in kept),
        stations=tuple(station for _, station in kept),
        ribbon=ribbon,
        bolts=tuple(drilled),
    )


def square_end(strip: Strip, joint: Joint) -> tuple[FloatArray, FloatArray]:
    """Point of the axis at a joint, and the direction of the cut across it in the strip."""
    face = joint.face
    if joint.ruling is not None:
        return strip.points[face] + joint.place * strip.along[face], joint.ruling
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
    lamellas: Sequence[Lamella], settings: LamellaSettings, taken: Collection[int] = ()
) -> tuple[list[Lamella], list[SplicePlate]]:
    """Pieces of all lamellas in order, and the plates that join them, beside cleats at ``taken``.

    Raises:
        InputError: no room for splices where they would be needed.
    """
    pieces: list[Lamella] = []
    splices: list[SplicePlate] = []
    for lamella in lamellas:
        cut, joined = spliced(lamella, settings, taken)
        pieces += cut
        splices += joined
    return pieces, splices
