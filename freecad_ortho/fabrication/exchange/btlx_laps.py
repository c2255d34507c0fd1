"""Slots of boards as laps, and straight boards as bars: what carpenters' machines have cuts for.

A lap takes a block out of a part. Of a board it goes through its thickness: its floor and its two
walls, square to each other, are lines of the flat pattern.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import shapely

# Sine of an angle up to which walls are parallel, and square to their floor.
_STRAIGHT = 1e-6
# Corners that are off a side by less, mm, are none; area, mm2, that counts as nothing.
_OFF, _NOTHING = 1e-6, 1e-3
# Least height of a wall's direction along which a slot is open at its upper or lower edge.
_STEEP = 0.1


@dataclass(frozen=True, eq=False)
class Lap:
    """A slot, seen with its open end up: of one that opens downwards from the other side.

    Attributes:
        start: (2,) left corner of its floor: along, and up from the side's own lower edge, mm.
        angle_deg: of its walls, from the length of the part, counter-clockwise.
        length: of its floor, mm.
        width: of its longer wall, mm.
        below: whether it opens downwards.
    """

    start: FloatArray
    angle_deg: float
    length: float
    width: float
    below: bool


def laps(outline: FloatArray) -> tuple[FloatArray, tuple[Lap, ...]]:
    """The slots of an outline, and what it is without them.

    Args:
        outline: (n, 2) corners, counter-clockwise, in the box of the part, mm.

    Returns:
        (m, 2) the outline with slots filled, straight from wall to wall, without corners on its
        sides; the slots in the order of the corners. What is no block that is open at the part's
        edge, or would take more than the slot, stays in the outline.
    """
    import shapely

    height = float(outline[:, 1].max())
    outline = without_flat_corners(outline)
    found = {}
    for number in range(len(outline)):
        around = outline[(number + np.arange(4) - 1) % len(outline)]
        lap = _lap(around, height)
        if lap is not None:
            found[number] = lap
    filled, kept = outline, dict(found)
    while True:
        floors = {k for number in kept for k in (number, (number + 1) % len(outline))}
        filled = np.array([point for k, point in enumerate(outline) if k not in floors])
        body = shapely.Polygon(filled)
        good = {
            number: lap
            for number, lap in kept.items()
            if body.is_valid and _takes_only_its_slot(body, outline, number, lap, height)
        }
        if len(good) == len(kept):
            break
        kept = good
    return without_flat_corners(filled), tuple(kept.values())


def without_flat_corners(outline: FloatArray) -> FloatArray:
    """(m, 2) of a closed outline (n, 2) those corners at which it turns."""
    kept = list(range(len(outline)))
    for number in range(len(outline)):
        here = kept.index(number)
        before, after = outline[kept[here - 1]], outline[kept[(here + 1) % len(kept)]]
        side, arm = after - before, outline[number] - before
        length = float(np.linalg.norm(side))
        off = abs(float(side[0] * arm[1] - side[1] * arm[0]))
        if len(kept) > 3 and off <= _OFF * length and 0 <= arm @ side <= length**2:
            kept.remove(number)
    return np.asarray(outline[kept])


def sawn_ends(outline: FloatArray) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """Start and end of a straight board, each where it is cut at the lower edge, and its slope.

    Args:
        outline: (n, 2) of the board without its slots, in its box, mm.

    Returns:
        For both ends the place along the lower edge, mm, and how much further it is per mm up; None
        where it has other sides than a lower and an upper edge along its box, and two ends.
    """
    if len(outline) != 4:
        return None
    height = float(outline[:, 1].max())
    low, high = (np.sort(outline[np.abs(outline[:, 1] - y) <= _OFF, 0]) for y in (0.0, height))
    if len(low) != 2 or len(high) != 2:
        return None
    first, last = ((float(low[k]), float(high[k] - low[k]) / height) for k in (0, 1))
    return first, last


def _lap(around: FloatArray, height: float) -> Lap | None:
    """The lap of a corner before a floor, its two corners, and one behind it; None for others."""
    arms = np.diff(around, axis=0)
    lengths = np.linalg.norm(arms, axis=1)
    if lengths.min() <= _OFF:
        return None
    down, floor, up = arms / lengths[:, None]
    square = max(abs(float(down @ floor)), abs(float(up @ floor)))
    turns = (one[0] * two[1] - one[1] * two[0] for one, two in ((down, floor), (floor, up)))
    # Both corners of the floor are hollow, and its walls stand on the same side of it.
    if max(turns) >= 0 or square > _STRAIGHT or abs(up[1]) < _STEEP:
        return None
    below = bool(up[1] < 0)
    corners = around[1:3].copy()
    if below:
        corners[:, 1] = height - corners[:, 1]
    left = corners[np.argmin(corners[:, 0])]
    angle = float(np.degrees(np.arctan2(abs(up[1]), up[0])))
    return Lap(left, angle, float(lengths[1]), float(max(lengths[0], lengths[2])), below)


def _takes_only_its_slot(
    body: shapely.Polygon, outline: FloatArray, number: int, lap: Lap, height: float
) -> bool:
    """Whether nothing of the part lies above the slot in its box."""
    import shapely

    slot = shapely.Polygon(outline[(number + np.arange(4) - 1) % len(outline)])
    up = np.array([np.cos(np.radians(lap.angle_deg)), np.sin(np.radians(lap.angle_deg))])
    along = lap.length * np.array([up[1], -up[0]])
    far = (2 * height + lap.width) / up[1] * up
    corners = lap.start + np.array([0 * up, along, along + far, far])
    if lap.below:
        corners[:, 1] = height - corners[:, 1]
    return float((shapely.Polygon(corners) & body).difference(slot).area) <= _NOTHING
