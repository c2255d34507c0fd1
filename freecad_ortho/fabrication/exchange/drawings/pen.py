"""Lines, texts and dimensions on a page of a PDF file; millimetres on paper, y upwards."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from solver.mesh.quadmesh import FloatArray

# Widths of lines, mm (ISO 128): what is seen, what is told about it, the frame.
THICK, MIDDLE, THIN, FRAME = 0.35, 0.25, 0.13, 0.5
# Heights of capitals, mm (ISO 3098), and what a capital is of its font's size.
LARGE, TEXT, SMALL, LEAST = 5.0, 2.5, 1.8, 1.2
_CAPITAL = 0.718
_POINTS = 72 / 25.4
# Of dimensions, mm: gap before a line begins, how far it goes on, half of an oblique stroke.
_GAP, _BEYOND, _STROKE = 1.0, 1.5, 1.2


class Pen:
    """Draws on the page that is open.

    Args:
        canvas: of reportlab.
    """

    def __init__(self, canvas: Any) -> None:
        self._canvas = canvas

    def lines(
        self,
        lines: Iterable[FloatArray],
        width: float = THICK,
        closed: bool = False,
        dash: tuple[float, ...] = (),
        fill: float | None = None,
        grey: float = 0.0,
    ) -> None:
        """Draw lines through points (n, 2), all of one kind.

        Args:
            lines: any number.
            width: of the lines, mm.
            closed: each returns to where it began.
            dash: lengths of dashes and gaps, mm.
            fill: brightness inside, 0 to 1; of closed ones, openings after their outline.
            grey: brightness of the lines.
        """
        path = self._canvas.beginPath()
        for line in lines:
            rows = (np.asarray(line) * _POINTS).tolist()
            path.moveTo(*rows[0])
            for row in rows[1:]:
                path.lineTo(*row)
            if closed:
                path.close()
        self._line(width, grey, dash)
        if fill is not None:
            self._canvas.setFillGray(fill)
        self._canvas.drawPath(path, stroke=1, fill=int(fill is not None), fillMode=0)

    def circle(
        self, at: FloatArray, radius: float, width: float = THIN, fill: float | None = None
    ) -> None:
        """Draw a circle about (2,)."""
        self._line(width, 0.0, ())
        if fill is not None:
            self._canvas.setFillGray(fill)
        x, y = (np.asarray(at) * _POINTS).tolist()
        self._canvas.circle(x, y, radius * _POINTS, stroke=1, fill=int(fill is not None))

    def text(
        self,
        words: str,
        at: FloatArray | tuple[float, float],
        size: float = TEXT,
        angle: float = 0.0,
        anchor: str = "middle",
        bold: bool = False,
        room: float = math.inf,
        cleared: bool = False,
    ) -> None:
        """Write a line of text that stands on a point (2,).

        Args:
            words: what the fonts of every reader lack is shown by a question mark.
            at: where.
            size: height of a capital, mm; smaller where it needs more than the room.
            angle: degrees, counter-clockwise.
            anchor: "start", "middle" or "end" is there.
            bold: whether.
            room: that it may take, mm.
            cleared: what is below it goes.
        """
        plain, font = _plain(words), _font(bold)
        size = fitted(words, size, room, bold)
        points = size / _CAPITAL * _POINTS
        wide = self._canvas.stringWidth(plain, font, points)
        back = {"start": 0.0, "middle": wide / 2, "end": wide}[anchor]
        x, y = (np.asarray(at) * _POINTS).tolist()
        self._canvas.saveState()
        self._canvas.translate(x, y)
        self._canvas.rotate(angle)
        if cleared:
            rim = 0.15 * points
            self._canvas.setFillGray(1.0)
            self._canvas.rect(
                *(-back - rim, -rim, wide + 2 * rim, size * _POINTS + 2 * rim), stroke=0, fill=1
            )
        self._canvas.setFillGray(0.0)
        self._canvas.setFont(font, points)
        self._canvas.drawString(-back, 0, plain)
        self._canvas.restoreState()

    def dimension(self, one: FloatArray, two: FloatArray, away: float, words: str) -> None:
        """Tell the distance of two points (2,).

        Args:
            one: first point.
            two: second point.
            away: where its line is, mm to the left of the way from one to two.
            words: the number.
        """
        length = float(np.linalg.norm(two - one))
        if length < 1e-6:
            return
        along = (two - one) / length
        left = np.array([-along[1], along[0]])
        side = math.copysign(1.0, away)
        ends = [one + away * left, two + away * left]
        rests = [
            np.array([point + side * _GAP * left, end + side * _BEYOND * left])
            for point, end in zip((one, two), ends, strict=True)
        ]
        slant = _STROKE * (along + left) / math.sqrt(2)
        strokes = [np.array([end - slant, end + slant]) for end in ends]
        reach = [ends[0] - _BEYOND * along, ends[1] + _BEYOND * along]
        self.lines([*rests, np.array(reach)], THIN)
        self.lines(strokes, THICK)
        turn = math.degrees(math.atan2(along[1], along[0]))
        # It is read from below or from the right.
        above = left if -89.9 < turn <= 90.1 else -left
        turn = turn if -89.9 < turn <= 90.1 else turn + 180
        middle = (ends[0] + ends[1]) / 2
        self.text(words, middle + 0.7 * above, TEXT, turn, cleared=True)

    def angle(
        self, centre: FloatArray, start_deg: float, turn_deg: float, radius: float, words: str
    ) -> None:
        """Tell the angle between two directions from a point (2,)."""
        turns = np.radians(start_deg + np.linspace(0.0, turn_deg, 33))
        ring = centre + radius * np.column_stack([np.cos(turns), np.sin(turns)])
        self.lines([ring], THIN)
        for end, sign in ((0, 1.0), (-1, -1.0)):
            out = np.array([math.cos(turns[end]), math.sin(turns[end])])
            back = sign * math.copysign(1.0, turn_deg) * np.array([-out[1], out[0]])
            for spread in (0.18, -0.18):
                self.lines([np.array([ring[end], ring[end] + 2 * (back + spread * out)])], THIN)
        self.text(words, ring[16] - [0.0, TEXT / 2], TEXT, cleared=True)

    @contextmanager
    def within(self, low: FloatArray, high: FloatArray) -> Iterator[None]:
        """Nothing is drawn outside of this box meanwhile."""
        self._canvas.saveState()
        path = self._canvas.beginPath()
        x, y = (np.asarray(low) * _POINTS).tolist()
        width, height = ((np.asarray(high) - low) * _POINTS).tolist()
        path.rect(x, y, width, height)
        self._canvas.clipPath(path, stroke=0, fill=0)
        try:
            yield
        finally:
            self._canvas.restoreState()

    def _line(self, width: float, grey: float, dash: tuple[float, ...]) -> None:
        self._canvas.setLineWidth(width * _POINTS)
        self._canvas.setStrokeGray(grey)
        self._canvas.setLineJoin(1)
        self._canvas.setDash([length * _POINTS for length in dash])


def fitted(words: str, size: float, room: float, bold: bool = False) -> float:
    """Height of a capital, mm, at most this one, at which words take no more than a room, mm."""
    from reportlab.pdfbase.pdfmetrics import stringWidth

    wide = stringWidth(_plain(words), _font(bold), size / _CAPITAL)
    return size * min(1.0, room / max(float(wide), 1e-9))


def _plain(words: str) -> str:
    """The fonts that every reader has know Latin-1 only."""
    return words.encode("latin-1", "replace").decode("latin-1")


def _font(bold: bool) -> str:
    return "Helvetica-Bold" if bold else "Helvetica"
