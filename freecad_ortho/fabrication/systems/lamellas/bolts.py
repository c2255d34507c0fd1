"""How splices are bolted: places of the bolts, length of the plates, room that they take."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.systems.lamellas.settings import EDGE_DISTANCE, LamellaSettings
from solver.mesh.quadmesh import FloatArray

# Distance between bolts, in diameters of their holes (EN 1993-1-8, table 3.3, asks for 2.2).
BOLT_DISTANCE = 2.4
# Thicknesses that a plate keeps away from a crossing, as it stands out on one side.
_ROOM = 3.0


def bolts(settings: LamellaSettings) -> FloatArray:
    """(N, 2) bolts of one end of a lamella: distance from the end, and level from its middle."""
    first = EDGE_DISTANCE * settings.hole
    along = [first, first + BOLT_DISTANCE * settings.hole]
    two_rows = settings.width >= (2 * EDGE_DISTANCE + BOLT_DISTANCE) * settings.hole
    levels = (-settings.width / 4, settings.width / 4) if two_rows else (0.0,)
    return np.array([(distance, level) for distance in along for level in levels])


def half_length(settings: LamellaSettings) -> float:
    """Half the length of a splice plate, mm."""
    ends = 2 * EDGE_DISTANCE + BOLT_DISTANCE
    return settings.clearance / 2 + ends * settings.hole


def least_edge(settings: LamellaSettings) -> float:
    """Length of an edge between two crossings that takes a splice plate, mm."""
    beside = max(_ROOM * settings.thickness, EDGE_DISTANCE * settings.hole) + settings.clearance
    return 2 * (half_length(settings) + beside)


def least_width(settings: LamellaSettings) -> float:
    """Width of lamellas that take bolts, mm."""
    return 2 * EDGE_DISTANCE * settings.hole
