"""Convex hulls that hold a ribbon that may twist, or bends smoothly, for the clash check.

The ribbon is a grid of cells between cross lines (stations and sides of slots) and levels (edges
and floors of slots). A slot is a cell left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.interpolate import CubicSpline

from freecad_ortho.fabrication.systems.lamellas.outline import Slot
from freecad_ortho.fabrication.systems.lamellas.ribbon import Ribbon
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# Ends and sides of a level in their order around a hull.
_RING = ((0, 1), (1, 1), (1, 0), (0, 0))


@dataclass(frozen=True, eq=False)
class CellGrid:
    """Cells of a ribbon.

    Attributes:
        places: (C, L) parameter of each cross line at each level: the station's number where it is
            a station, a fraction beyond it on the face that follows.
        levels: (L,) from the lower to the upper edge, mm.
        full: (C - 1, L - 1) true where there is a cell.
    """

    places: FloatArray
    levels: FloatArray
    full: BoolArray


def grid_of(ribbon: Ribbon, slots: Sequence[Slot]) -> CellGrid:
    """Lay out the cells of a ribbon whose slots stand along its rulings."""
    floors = {round(slot.floor * (1 if slot.upward else -1), 9) for slot in slots}
    levels = np.array([ribbon.lower, *sorted(floors), ribbon.upper])
    cut_at = {slot.station: slot for slot in slots}
    lines: list[FloatArray] = []
    full: list[BoolArray] = []
    every = np.ones(len(levels) - 1, dtype=bool)
    for station in range(len(ribbon.strip.points)):
        here = np.full(len(levels), float(station))
        if station not in cut_at:
            lines.append(here)
            full.append(every)
            continue
        slot = cut_at[station]
        floor = slot.floor * (1 if slot.upward else -1)
        left_out = (levels[:-1] >= floor - 1e-6) if slot.upward else levels[1:] <= floor + 1e-6
        behind, ahead = (slot_side(ribbon, slot, levels, sign) for sign in (-1, 1))
        lines += [behind, here, ahead]
        full += [~left_out, ~left_out, every]
    return CellGrid(np.array(lines), levels, np.array(full[:-1]))


def slot_side(ribbon: Ribbon, slot: Slot, levels: FloatArray, sign: int) -> FloatArray:
    """(L,) parameter of one side of a slot at each level."""
    strip, station = ribbon.strip, slot.station
    face = station if sign > 0 else station - 1
    ruling = strip.flat_rulings[station]
    across = sign * 0.5 * slot.width * np.array([ruling[1], -ruling[0]])
    points = (
        strip.flat_points[station] + across + (levels * ribbon.stretch[station])[:, None] * ruling
    )
    behind, ahead = ribbon.ahead(face, points), -ribbon.ahead(face + 1, points)
    return face + behind / (behind + ahead)


def hulls(
    ribbon: Ribbon,
    slots: Sequence[Slot],
    smooth: bool,
    plated: float = 0.0,
    legs: Sequence[float] = (),
) -> tuple[FloatArray, ...]:
    """Hulls of the cells, long ones in three so that they are nearly plane where others cross.

    They are cut where splice plates and cleats end, so that a plate's sides part it from them.

    Args:
        ribbon: that may twist.
        slots: in it.
        smooth: its edges are cubic splines.
        plated: length at the ends that splice plates lie on, mm.
        legs: places at which cleats on the sides end, as in ``CellGrid``.
    """
    grid = grid_of(ribbon, slots)
    rails, width = Rails(ribbon, grid.levels, smooth), ribbon.width
    rows, spans = [], []
    for cell, row in np.argwhere(grid.full).tolist():
        first, last = grid.places[cell : cell + 2, row : row + 2]
        share = width / rails.length(first[0], last[0])
        cuts = [np.full((2, 2), at) for at in ((0, share, 1 - share, 1) if share < 0.4 else (0, 1))]
        if plated and cell == 0:
            cuts.append(plated / (_edges(rails, first, last, row) @ rails.along[0]))
        if plated and cell == len(grid.full) - 1:
            cuts.append(1 - plated / (_edges(rails, first, last, row) @ rails.along[1]))
        cuts += [np.stack([(leg - first) / (last - first)] * 2, axis=1) for leg in legs]
        cuts = sorted((cut for cut in cuts if 0 <= cut.min() and cut.max() <= 1), key=np.mean)
        for low, high in pairwise(cuts):
            # (end, level, side)
            spans.append(first[:, None] + np.stack([low, high]) * (last - first)[:, None])
            rows.append(row)
    return tuple(_around(rails, np.array(rows), np.array(spans)))


def _around(rails: Rails, rows: IntArray, spans: FloatArray) -> FloatArray:
    """(H, 8 or 16, 3) corners of hulls, and control points of their edges where these are curved.

    Args:
        rails: of the ribbon.
        rows: (H,) number of the level at the lower side of each.
        spans: (H, end, level, side) parameters of its corners.
    """
    levels = rows[:, None, None] + np.array([[0], [1]])
    sides = np.array([0, 1])
    corners = rails.at(spans, levels[:, None], sides)
    rings = [corners[:, end, k, side] for k in (0, 1) for end, side in _RING]
    if rails.spline is not None:
        handles = rails.handles(spans, levels, sides)
        rings += [handles[:, end, k, side] for k in (0, 1) for side in (1, 0) for end in (0, 1)]
    return np.stack(rings, axis=1)


def _edges(rails: Rails, first: FloatArray, last: FloatArray, row: int) -> FloatArray:
    """(level, side, 3) from one end of a cell to the other along its edges."""
    start, end = (
        rails.at(at[:, None], np.array([[row], [row + 1]]), np.array([0, 1]))
        for at in (first, last)
    )
    return np.asarray(end - start)


class Rails:
    """The curves at each level on both sides of the plate, run through by stations."""

    def __init__(self, ribbon: Ribbon, levels: FloatArray, smooth: bool) -> None:
        strip = ribbon.strip
        middle = (
            strip.points[:, None]
            + (levels * ribbon.stretch[:, None])[..., None] * (strip.rulings[:, None])
        )
        self.corners = np.stack(
            [middle + sign * ribbon.mitres[:, None] for sign in (-1, 1)], axis=2
        )
        self.along = strip.along[[0, -1]]
        self.lengths = np.concatenate([[0.0], np.cumsum(strip.lengths)])
        self.spline = CubicSpline(self.lengths, self.corners, axis=0) if smooth else None

    def at(self, places: FloatArray, rows: IntArray, sides: IntArray) -> FloatArray:
        """(..., 3) points at parameters of the curves of levels and sides, of shapes that fit."""
        places, rows, sides = np.broadcast_arrays(places, rows, sides)
        if self.spline is not None:
            return _chosen(self.spline(self._along(places)), rows, sides)
        face = np.minimum(places.astype(int), len(self.lengths) - 2)
        share = (places - face)[..., None]
        start, end = (self.corners[station, rows, sides] for station in (face, face + 1))
        return np.asarray((1 - share) * start + share * end)

    def handles(self, spans: FloatArray, rows: IntArray, sides: IntArray) -> FloatArray:
        """(H, 2, ..., 3) inner control points of curves between parameters (H, 2, ...) of a face.

        The levels and sides of the curves have the shape (H, ...).
        """
        assert self.spline is not None
        ends = self._along(spans)
        both = np.broadcast_arrays(ends, rows[:, None], sides)[1:]
        points, slopes = (_chosen(self.spline(ends, order), *both) for order in (0, 1))
        third = ((ends[:, 1] - ends[:, 0]) / 3)[..., None]
        first, last = points[:, 0] + third * slopes[:, 0], points[:, 1] - third * slopes[:, 1]
        return np.stack([first, last], axis=1)

    def poles(self) -> FloatArray:
        """(face, side, level, P, 3) control points of the curves from station to station."""
        ends = np.stack([self.corners[:-1], self.corners[1:]])
        if self.spline is None:
            return np.moveaxis(ends, (1, 3, 2, 0), (0, 1, 2, 3))
        slopes = self.spline(self.lengths, 1)
        third = (np.diff(self.lengths) / 3)[:, None, None, None]
        inner = [ends[0] + third * slopes[:-1], ends[1] - third * slopes[1:]]
        return np.moveaxis(np.stack([ends[0], *inner, ends[1]]), (1, 3, 2, 0), (0, 1, 2, 3))

    def length(self, start: float, end: float) -> float:
        """Length of the axis between two parameters, mm."""
        first, last = self._along(np.array([start, end]))
        return float(last - first)

    def _along(self, places: FloatArray) -> FloatArray:
        return np.asarray(np.interp(places, np.arange(len(self.lengths)), self.lengths))


def _chosen(values: FloatArray, rows: IntArray, sides: IntArray) -> FloatArray:
    """(..., 3) of values (..., level, side, 3)."""
    places: tuple[IntArray, ...] = np.indices(rows.shape, sparse=True)
    return np.asarray(values[(*places, rows, sides)])
