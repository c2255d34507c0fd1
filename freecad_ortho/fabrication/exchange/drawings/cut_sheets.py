"""A page for each sheet that parts are cut from."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_ortho.fabrication.drawing_form import DrawingForm, scale_for
from freecad_ortho.fabrication.exchange.drawings.page import Page, room_of
from freecad_ortho.fabrication.exchange.drawings.pen import LEAST, MIDDLE, TEXT, THICK, THIN, Pen
from freecad_ortho.fabrication.exchange.drawings.view import View, millimetres
from freecad_ortho.fabrication.nesting.sheet import Placement, Sheet, turned
from freecad_ortho.words import counted
from solver.mesh.quadmesh import FloatArray

# What the dimensions of a sheet take on its left and below it, mm.
_DIMENSIONS = 12.0


def sheet_page(sheet: Sheet, form: DrawingForm) -> Page:
    """The page of one sheet: its rim, what lies on it, names, and its file."""
    notes = (
        f"file: sheets/{sheet.file_name}",
        f"{counted(len(sheet.placements), 'part')}, waste {100 * sheet.waste:.0f} %",
    )
    low, high = room_of(form, len(notes))
    room = high - low - _DIMENSIONS
    scale = scale_for(sheet.width, sheet.height, (float(room[0]), float(room[1])))
    middle = np.array([sheet.width, sheet.height]) / 2
    upright = scale_for(sheet.height, sheet.width, (float(room[0]), float(room[1])))
    angle = 0.0 if scale <= upright else 90.0
    shift = np.array([-1.0 if angle else 1.0, 1.0]) * _DIMENSIONS / 2

    def draw(pen: Pen, low: FloatArray, high: FloatArray) -> None:
        view = View(min(scale, upright), turned(middle[None], angle)[0], (low + high) / 2 + shift)
        rim = view(turned(np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * 2 * middle, angle))
        pen.lines([rim], THICK, closed=True)
        for placement in sheet.placements:
            _part(pen, view, placement, angle)
        # Turned, its width goes up on the right.
        pen.dimension(rim[0], rim[1], -8.0, millimetres(sheet.width))
        pen.dimension(rim[0], rim[3], 8.0, millimetres(sheet.height))

    return Page(
        sheet.name.upper(), sheet.title.capitalize(), f"1:{min(scale, upright)}", draw, notes
    )


def _part(pen: Pen, view: View, placement: Placement, angle: float) -> None:
    """A part on a sheet that is turned by so many degrees on the page."""
    pattern = placement.pattern
    shift = turned(placement.shift[None], angle)[0]
    placement = replace(placement, angle_deg=placement.angle_deg + angle, shift=shift)
    cut = [placement.outline, *(placement.on_sheet(hole) for hole in pattern.cutouts)]
    pen.lines([view(line) for line in cut], MIDDLE, closed=True, fill=0.93)
    for hole in pattern.holes:
        at = view(placement.on_sheet(hole.centre[None]))[0]
        pen.circle(at, hole.diameter / 2 / view.scale, THIN, fill=1.0)
    for bend in pattern.bends:
        pen.lines([view(placement.on_sheet(bend.points))], THIN, dash=(2.0, 0.6, 0.3, 0.6))
    _name(pen, view, placement)


def _name(pen: Pen, view: View, placement: Placement) -> None:
    """The part's name along the longer side of its box, as large as there is room."""
    width, height = np.ptp(placement.outline, axis=0) / view.scale
    at = view(placement.on_sheet(placement.pattern.label[None]))[0]
    upright = height > width
    size = float(np.clip(0.45 * min(width, height), LEAST, TEXT))
    turn = 90.0 if upright else 0.0
    base = at + (np.array([size / 2, 0.0]) if upright else np.array([0.0, -size / 2]))
    pen.text(placement.name, base, size, turn, room=0.9 * float(max(width, height)))
