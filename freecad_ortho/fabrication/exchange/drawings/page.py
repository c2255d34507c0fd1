"""A page: its frame, its title block, and the room that is left for what it shows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freecad_ortho import __version__
from freecad_ortho.fabrication.drawing_form import PAPERS, DrawingForm
from freecad_ortho.fabrication.exchange.drawings.pen import (
    FRAME,
    LARGE,
    SMALL,
    TEXT,
    THIN,
    Pen,
)
from solver.mesh.quadmesh import FloatArray

# Between the edge of the paper and the frame, mm (ISO 5457): on the left it is filed.
_FILED, _MARGIN = 20.0, 10.0
# Of the title block (ISO 7200), and of a line of notes, mm.
_WIDE, _HIGH, _NOTE, _PAD = 180.0, 31.0, 4.2, 6.0


@dataclass(frozen=True, eq=False)
class Page:
    """What a page shows.

    Attributes:
        number: of the drawing, ``PLAN-1``.
        title: what it is, in words.
        scale: as the title block says it, ``1:20``.
        draw: draws it into the room from its low to its high corner (2,), mm.
        notes: lines beside the title block.
    """

    number: str
    title: str
    scale: str
    draw: Callable[[Pen, FloatArray, FloatArray], None]
    notes: tuple[str, ...] = ()


def room_of(form: DrawingForm, notes: int) -> tuple[FloatArray, FloatArray]:
    """Low and high corner (2,) of what a page with so many notes has room for, mm."""
    width, height = PAPERS[form.paper]
    block = _HIGH
    if width - _FILED - _MARGIN - _WIDE < _WIDE / 2:
        # Notes stand above the title block.
        block += notes * _NOTE + (2.0 if notes else 0.0)
    else:
        block = max(block, notes * _NOTE + 2.0)
    low = np.array([_FILED + _PAD, _MARGIN + block + _PAD])
    return low, np.array([width - _MARGIN - _PAD, height - _MARGIN - _PAD])


def draw_page(
    pen: Pen, page: Page, form: DrawingForm, project: str, number: int, count: int
) -> None:
    """Draw a page with its frame and its title block.

    Args:
        pen: on an empty page.
        page: what it shows.
        form: paper and date.
        project: name.
        number: of the page, from 1.
        count: of all pages.
    """
    width, height = PAPERS[form.paper]
    low, high = np.array([_FILED, _MARGIN]), np.array([width - _MARGIN, height - _MARGIN])
    corners = np.array([low, [high[0], low[1]], high, [low[0], high[1]]])
    page.draw(pen, *room_of(form, len(page.notes)))
    pen.lines([corners], FRAME, closed=True)
    _title_block(pen, high[0] - _WIDE, low[1], page, form, project, f"{number} / {count}")
    beside = width - _FILED - _MARGIN - _WIDE >= _WIDE / 2
    base = low[1] + (2.0 if beside else _HIGH + 2.0)
    room = (high[0] - low[0]) - (_WIDE if beside else 0.0) - 6.0
    for row, words in enumerate(reversed(page.notes)):
        pen.text(words, (low[0] + 3.0, base + row * _NOTE), TEXT, anchor="start", room=room)


def _title_block(
    pen: Pen, x: float, y: float, page: Page, form: DrawingForm, project: str, number: str
) -> None:
    """Three rows of fields, each with what it is in small letters above it."""
    cells = [
        (0.0, 21.0, 120.0, 10.0, "project", project or "structure", LARGE),
        (120.0, 21.0, 60.0, 10.0, "drawing", page.number, 3.5),
        (0.0, 10.0, 180.0, 11.0, "title", page.title, 3.5),
        (0.0, 0.0, 28.0, 10.0, "scale", page.scale, 3.5),
        (28.0, 0.0, 44.0, 10.0, "date", form.date, TEXT),
        (72.0, 0.0, 22.0, 10.0, "paper", form.paper.upper(), TEXT),
        (94.0, 0.0, 22.0, 10.0, "unit", "mm", TEXT),
        (116.0, 0.0, 40.0, 10.0, "made by", f"freecad_ortho {__version__}", TEXT),
        (156.0, 0.0, 24.0, 10.0, "page", number, 3.5),
    ]
    for left, low, wide, high, name, words, size in cells:
        corner = np.array([x + left, y + low])
        box = corner + np.array([[0, 0], [wide, 0], [wide, high], [0, high]])
        pen.lines([box], THIN, closed=True, fill=1.0)
        pen.text(name, corner + [1.2, high - 2.6], SMALL - 0.3, anchor="start")
        size = min(size, high - 5.2)
        pen.text(words, corner + [1.5, 1.6], size, anchor="start", room=wide - 3.0)
    outer = np.array([[x, y], [x + 180, y], [x + 180, y + _HIGH], [x, y + _HIGH]])
    pen.lines([outer], FRAME, closed=True)
