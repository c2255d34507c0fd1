"""Panels that a border cuts: their outlines, square along the border and as they are elsewhere."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.pattern import FlatPattern, Mark, fitted_text_size
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, unit_rows

if TYPE_CHECKING:
    import shapely

# The border is made of straight pieces that leave it by this much at most, mm.
_TRUE = 0.05
# A corner nearer to the line of a side, mm, is on it.
_ON_LINE = 1e-5
# Sine of an angle between two sides below which they do not say where they meet.
_PARALLEL = 1e-3
# How true the middle of the largest circle in a panel is, mm.
_MIDDLE = 1.0
# The number of sides that are along the border.
BORDER = -1


@dataclass(frozen=True, eq=False)
class Trimmed:
    """A piece of a panel that a border leaves.

    Attributes:
        under: (N, 2) its lower outline in the plane of the panel, counter-clockwise.
        over: (N, 2) its upper one.
        outline: (N, 2) the plate to cut.
        sides: (N,) side of the whole outline that each side from corner to corner lies on, or
            ``BORDER``.
        cutouts: openings within it.
        middle: (2,) the middle of the largest circle in it.
        width: diameter of that circle, mm.
        area: mm2.
    """

    under: FloatArray
    over: FloatArray
    outline: FloatArray
    sides: IntArray
    cutouts: tuple[FloatArray, ...]
    middle: FloatArray
    width: float
    area: float

    def moved(self, step: FloatArray) -> Trimmed:
        """The same elsewhere in its plane, by (2,)."""
        return replace(
            self,
            under=self.under + step,
            over=self.over + step,
            outline=self.outline + step,
            cutouts=tuple(cutout + step for cutout in self.cutouts),
            middle=self.middle + step,
        )


def trimmed(
    under: FloatArray, over: FloatArray, outline: FloatArray, regions: Iterable[shapely.Polygon]
) -> list[Trimmed]:
    """What is within a border of a panel with outlines (N, 2), the widest piece first.

    Args:
        under: of the lower side.
        over: of the upper one, its sides parallel to those.
        outline: of the plate to cut, which holds both.
        regions: polygons in the same plane that are within the border.
    """
    import shapely

    tight = shapely.Polygon(under).intersection(shapely.Polygon(over))
    found = []
    for region in regions:
        for part in shapely.get_parts(tight.intersection(region)):
            piece = part.simplify(_TRUE)
            if piece.geom_type == "Polygon" and piece.area > _TRUE**2:
                found.append(piece_of((under, over, outline), piece))
    return sorted(found, key=lambda piece: -piece.width)


def piece_of(rings: Sequence[FloatArray], piece: shapely.Polygon) -> Trimmed:
    """A piece of a panel with a lower, an upper and a whole outline (N, 2)."""
    from shapely.geometry.polygon import orient
    from shapely.ops import polylabel

    piece = orient(piece)
    corners = np.array(piece.exterior.coords)[:-1]
    under, over, _ = rings
    on_lower, on_upper = (_sides_on(corners, ring) for ring in (under, over))
    sides = np.where(on_lower == BORDER, on_upper, on_lower)
    # Corners between two pieces of one side are none.
    turns = (sides == BORDER) | (sides != np.roll(sides, 1))
    corners, sides = corners[turns], sides[turns]
    point = polylabel(piece, _MIDDLE)
    led_under, led_over, outline = (_led_to(ring, corners, sides) for ring in rings)
    return Trimmed(
        led_under,
        led_over,
        outline,
        sides,
        tuple(np.array(ring.coords)[:-1] for ring in piece.interiors),
        np.array(point.coords[0]),
        2 * float(point.distance(piece.boundary)),
        float(piece.area),
    )


def _sides_on(corners: FloatArray, ring: FloatArray) -> IntArray:
    """(N,) side of an outline that each side from corner to corner lies on, or ``BORDER``."""
    along = unit_rows(np.roll(ring, -1, axis=0) - ring)
    arms = corners[:, None] - ring
    off = np.abs(along[:, 0] * arms[..., 1] - along[:, 1] * arms[..., 0])
    both = np.maximum(off, np.roll(off, -1, axis=0))
    return np.where(both.min(axis=1) <= _ON_LINE, both.argmin(axis=1), BORDER)


def _led_to(ring: FloatArray, corners: FloatArray, sides: IntArray) -> FloatArray:
    """Corners (N, 2) moved to where sides that lie on an outline's are in this one."""
    steps = np.roll(corners, -1, axis=0) - corners
    own = np.roll(ring, -1, axis=0) - ring
    on_ring = (sides != BORDER)[:, None]
    start = np.where(on_ring, ring[sides], corners)
    along = unit_rows(np.where(on_ring, own[sides], steps))
    before, behind = np.roll(start, 1, axis=0), np.roll(along, 1, axis=0)
    sine = behind[:, 0] * along[:, 1] - behind[:, 1] * along[:, 0]
    arms = start - before
    clear = np.abs(sine) > _PARALLEL
    share = (arms[:, 0] * along[:, 1] - arms[:, 1] * along[:, 0]) / np.where(clear, sine, 1.0)
    met = before + share[:, None] * behind
    free = (sides == BORDER) & (np.roll(sides, 1) == BORDER)
    return np.where((clear & ~free)[:, None], met, corners)


def trimmed_pattern(name: str, piece: Trimmed, beside: list[str]) -> FlatPattern:
    """Outline seen from above, a tick at its first free corner, neighbours' names along its sides.

    Args:
        name: of the panel.
        piece: with the lower left corner of its outline's box at the origin.
        beside: names of the panels across the sides of the whole outline, "" where there is none.
    """
    import shapely

    corner, middle, radius = piece.outline, piece.middle, piece.width / 2
    ahead = np.roll(corner, -1, axis=0) - corner
    length = np.linalg.norm(ahead, axis=1)
    plate = shapely.Polygon(corner, piece.cutouts).buffer(_ON_LINE)
    ticks = np.stack([corner, corner + 0.15 * (middle - corner)], axis=1)
    within = np.flatnonzero(shapely.covers(plate, shapely.linestrings(ticks)))
    marks = [Mark(tick) for tick in ticks[within[:1]]]
    for side, text in enumerate(beside):
        own = np.flatnonzero(piece.sides == side)
        if text and len(own):
            longest = int(own[length[own].argmax()])
            along = ahead[longest] / length[longest]
            size = fitted_text_size(text, 0.5 * float(length[longest]), 0.3 * radius, 12.0)
            inward = np.array([-along[1], along[0]])
            place = corner[longest] + 0.5 * ahead[longest] + size * inward
            angle = float(np.degrees(np.arctan2(along[1], along[0])))
            marks.append(Mark(place[None], text, size, angle))
    size = min(1.1 * radius / float(np.hypot(len(name), 1)), 30.0)
    return FlatPattern(corner, tuple(marks), middle, size, piece.cutouts)
