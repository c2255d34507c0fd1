"""How large the cleats of lamellas are."""

from __future__ import annotations

import math

from freecad_ortho.fabrication.bolts import Bolt, bolt_in, on_wood, plate_of
from freecad_ortho.fabrication.cleat import CleatSizes
from freecad_ortho.fabrication.systems.lamellas.bolts import BOLT_DISTANCE, bolts, half_length
from freecad_ortho.fabrication.systems.lamellas.settings import EDGE_DISTANCE, LamellaSettings

# Angle of crossings for which room is left where splices are laid out, radians.
_USUAL = math.radians(60.0)


def sizes_of(
    settings: LamellaSettings,
    angle: float,
    *,
    spread: int = 0,
    slot: float = 0.0,
    slope: float = 0.0,
) -> CleatSizes:
    """Of a cleat between lamellas that cross at an angle, radians.

    In a slot that is so wide, mm, and with legs that rise by a slope at most.

    A wrench turns beside each bolt, in the corner of the legs and in that on the other side of the
    lamella, where a fin of a foot may be; bolts keep 1.2 holes from edges and slots. They are
    ``spread`` over the width (0), as near to each other as the rule and a wrench allow (1), or
    there is one in the middle (2). Of two layers each leg has them in the middle of its own plate,
    above or below the other one.
    """
    hole, bolt = settings.hole, cleat_bolt(settings)
    thickness = leg_thickness(settings)
    edge = EDGE_DISTANCE * hole
    levels = tuple(sorted({level for _, level in bolts(settings).tolist()}))
    least = max(BOLT_DISTANCE * hole, 0.0 if bolt is None else bolt.spacing) / 2
    if spread == 1 and least < max(levels):
        levels = (-least, least)
    elif spread == 2:
        levels = (0.0,)
    sine, cosine = math.sin(angle), abs(math.cos(angle))
    stands = 0.0 if bolt is None else bolt.washer + max(bolt.head, bolt.nut + 2 * bolt.pitch)
    wrench = 0.0 if bolt is None else bolt.wrench
    beside = (wrench + thickness + settings.thickness + (thickness + stands) * cosine) / sine
    beyond = (settings.thickness / 2 + settings.clearance) / sine
    beyond = max(beyond, slot / 2) + edge
    back = float(math.ceil(max(beside, beyond)))
    lift = (settings.width + settings.clearance) / 2 if settings.layers == 2 else 0.0
    return CleatSizes(
        bolt,
        hole,
        thickness,
        2 * (lift + math.ceil(max(levels) + edge * math.hypot(1.0, slope))),
        levels,
        back,
        back + math.ceil(edge),
        settings.thickness,
        lift,
    )


def cleat_bolt(settings: LamellaSettings) -> Bolt | None:
    """What legs are bolted with; None where no bolt of the list passes their holes."""
    bolt = bolt_in(settings.hole)
    return on_wood(bolt) if bolt is not None and settings.on_wood else bolt


def leg_thickness(settings: LamellaSettings) -> float:
    """Of a cleat's legs, mm.

    Those of the lamellas' own metal are as thick as these. Those of steel on wood need not be
    thicker than their bolts: from that on a plate holds them upright (EN 1995-1-1, 8.2.3).
    """
    bolt = bolt_in(settings.hole)
    if not settings.steel_cleats or bolt is None:
        return plate_of(settings.thickness)
    return plate_of(min(settings.thickness, bolt.diameter))


def edge_for_splice(settings: LamellaSettings) -> float:
    """Length of an edge that takes a splice plate between two cleats, mm."""
    beside = sizes_of(settings, _USUAL).reach + settings.clearance
    return 2 * (half_length(settings) + beside)
