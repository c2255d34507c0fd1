"""Corners at the border that are too sharp for a material, or sides too short: cut off.

A glazier cuts the tip of a sharp corner off, square to its bisector, until what is cut is a side
that can be ground: ``2 d tan(angle / 2)`` long at a distance d from the tip. A side that is too
short moves inwards, parallel to itself, until it is long enough: by h it grows by
``-h (cot a + cot b)`` between corners with the angles a and b. What is not within the limits then
cannot be made.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.plate_limits import (
    CORNER,
    PlateLimits,
    as_cut,
    can_be_cut,
    turns_of,
    wide_enough,
)
from freecad_ortho.fabrication.systems.panels.trimmed import Trimmed, piece_of
from solver.mesh.quadmesh import FloatArray, unit_rows

if TYPE_CHECKING:
    import shapely

# A side that is cut is longer than the least by this part; more is tried where outlines of several
# levels or curved sides want it.
_MORE = (1.001, 1.25, 1.5, 2.0)
# So many corners of one piece are cut off at most.
_CUTS = 12
# Least by which a side grows as it moves inwards by 1: tips of less than 3 degrees take too much.
_GROWS = 0.05
# A point nearer to another, mm, is that.
_NEAR = 1e-6


def blunted(piece: Trimmed, rings: Sequence[FloatArray], limits: PlateLimits) -> Trimmed | None:
    """A piece as it can be made of a material; None where it cannot.

    Args:
        piece: as the border leaves it; the same is returned where it can be made as it is.
        rings: the whole panel's lower, upper and whole outline (N, 2).
        limits: of the material. Pieces of panels that are too small for it even when whole stay as
            they are.
    """
    import shapely

    if can_be_cut(piece.outline, limits) or not wide_enough(rings[2], limits):
        return piece
    tight = shapely.Polygon(piece.under).intersection(shapely.Polygon(piece.over, piece.cutouts))
    for more in _MORE:
        left = _less_sharp(tight, limits, more * limits.side_mm)
        if left is None:
            return None
        found = piece_of(rings, left)
        if can_be_cut(found.outline, limits):
            return found
    return None


def cut_off(piece: Trimmed, blunt: Trimmed) -> float:
    """How far, mm, the farthest corner of a piece is from what is left of it."""
    import shapely

    return float(shapely.Polygon(piece.outline).hausdorff_distance(shapely.Polygon(blunt.outline)))


def _less_sharp(plate: shapely.Polygon, limits: PlateLimits, side: float) -> shapely.Polygon | None:
    """A plate whose corners are cut off one after the other, the sharpest first."""
    for _ in range(_CUTS):
        if plate.geom_type != "Polygon" or plate.is_empty:
            return None
        outline = as_cut(_outline(plate))
        turns = turns_of(outline)
        sharpest = int(turns.argmax())
        if 180.0 - turns[sharpest] < limits.angle_deg:
            plate = _without(plate, *_tip(outline, sharpest, float(turns[sharpest]), side))
            continue
        numbers = np.flatnonzero(np.abs(turns) >= CORNER)
        corners = outline[numbers]
        ahead = np.roll(corners, -1, axis=0) - corners
        length = np.linalg.norm(ahead, axis=1)
        shortest = int(length.argmin())
        if length[shortest] >= limits.side_mm:
            return plate
        ends = turns[numbers[shortest]], turns[numbers[(shortest + 1) % len(numbers)]]
        # The angle within is 180 degrees less the turn: its cotangent is minus that of the turn.
        grows = float(sum(1 / np.tan(np.radians(ends))))
        if min(ends) <= 0 or grows < _GROWS:
            return None
        inward = unit_rows(np.array([[-ahead[shortest, 1], ahead[shortest, 0]]]))[0]
        depth = (side - float(length[shortest])) / grows
        plate = _without(plate, corners[shortest], inward, depth)
    return None


def _tip(
    outline: FloatArray, corner: int, turn: float, side: float
) -> tuple[FloatArray, FloatArray, float]:
    """A corner, the direction of its bisector inwards, and how far along that its tip goes."""
    arms = np.stack([outline[corner - 1], outline[(corner + 1) % len(outline)]]) - outline[corner]
    inward = unit_rows(unit_rows(arms).sum(axis=0)[None])[0]
    return outline[corner], inward, side / 2 / float(np.tan(np.radians(180.0 - turn) / 2))


def _without(
    plate: shapely.Polygon, point: FloatArray, inward: FloatArray, depth: float
) -> shapely.Polygon:
    """A plate less what is around one of its points up to a depth."""
    import shapely

    reach = 2 * float(np.ptp(_outline(plate), axis=0).sum())
    across = reach * np.array([-inward[1], inward[0]])
    end = point + depth * inward
    begin = point - reach * inward
    ring = np.array([end + across, begin + across, begin - across, end - across])
    parts = shapely.get_parts(plate.intersection(shapely.Polygon(ring)))
    tip = [part for part in parts if part.distance(shapely.Point(point)) < _NEAR]
    # A little more than it, so that nothing of its sides is left.
    gone = shapely.union_all(tip).buffer(_NEAR, join_style="mitre")
    return plate.difference(gone.intersection(shapely.Polygon(ring)))


def _outline(plate: shapely.Polygon) -> FloatArray:
    """(N, 2) its outline, counter-clockwise."""
    from shapely.geometry.polygon import orient

    return np.array(orient(plate).exterior.coords)[:-1]
