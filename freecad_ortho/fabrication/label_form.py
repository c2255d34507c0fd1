"""Sheets of labels: how many on a page, how large, and where they are."""

from __future__ import annotations

import re
from dataclasses import dataclass

from solver.errors import InputError
from solver.option import unknown

# Width and height, mm: ISO 216, and the letter size of North America.
_PAPERS = {"a4": (210.0, 297.0), "letter": (215.9, 279.4)}
# Width and height of a label, mm, as office suppliers sell them; gaps between columns and rows.
# What is left of the page are equal margins on opposite sides.
_KNOWN = {
    "3x8": (70.0, 36.0, 0.0, 0.0),
    "3x7": (63.5, 38.1, 2.5, 0.0),
    "2x7": (99.1, 38.1, 2.5, 0.0),
    "2x4": (99.1, 67.7, 2.5, 0.0),
    "4x10": (48.5, 25.4, 0.0, 0.0),
    "5x13": (38.1, 21.2, 2.5, 0.0),
    "letter-3x10": (66.675, 25.4, 3.175, 0.0),
    "letter-2x10": (101.6, 25.4, 4.7625, 0.0),
    "letter-2x7": (101.6, 101.6 / 3, 4.7625, 0.0),
    "letter-2x5": (101.6, 50.8, 4.7625, 0.0),
    "letter-2x3": (101.6, 254.0 / 3, 4.7625, 0.0),
}
# Smaller ones have no room for a code that a telephone reads, and for a name, mm.
_SMALLEST = (35.0, 15.0)
_NUMBER = r"(\d+\.?\d*)"
_PAIR = rf"{_NUMBER}x{_NUMBER}"
_WORDS = re.compile(rf"(?:(a4|letter)-)?(\d+)x(\d+)(?::{_PAIR}(?::{_PAIR})?)?")


@dataclass(frozen=True)
class LabelForm:
    """A sheet of labels, mm.

    Attributes:
        paper: width and height of the page.
        columns: labels beside each other.
        rows: labels below each other.
        size: width and height of a label.
        margin: left of the first label, and above it.
        gap: between columns, and between rows.
    """

    paper: tuple[float, float]
    columns: int
    rows: int
    size: tuple[float, float]
    margin: tuple[float, float]
    gap: tuple[float, float]

    @property
    def count(self) -> int:
        """Labels on a page."""
        return self.columns * self.rows

    def corner(self, number: int) -> tuple[float, float]:
        """Lower left corner of a label of a page, counted row by row, from that of the page."""
        row, column = divmod(number, self.columns)
        across = self.margin[0] + column * (self.size[0] + self.gap[0])
        down = self.margin[1] + row * (self.size[1] + self.gap[1]) + self.size[1]
        return across, self.paper[1] - down


def label_form(words: str) -> LabelForm:
    """The sheet that a name stands for, or that columns, rows, margins and gaps describe.

    Args:
        words: ``3x8``, ``letter-3x10``; ``3x9:5x12`` with margins at the sides and above and below,
            mm, ``letter-4x6:8x10:3x2`` with gaps between columns and between rows.

    Raises:
        InputError: what is not understood, an unknown sheet without margins, labels too small.
    """
    plain = words.strip().lower().removeprefix("a4-")
    match = _WORDS.fullmatch(plain)
    if match is None or (match[4] is None and plain not in _KNOWN):
        raise unknown(
            "label sheet", words, _KNOWN, "columns and rows with margins in mm as 3x9:5x12"
        )
    paper = _PAPERS[match[1] or "a4"]
    counts = int(match[2]), int(match[3])
    if match[4] is None:
        *size, across, down = _KNOWN[plain]
        gap = across, down
        margin = [
            (page - many * side - (many - 1) * between) / 2
            for page, many, side, between in zip(paper, counts, size, gap, strict=True)
        ]
    else:
        margin = [float(match[4]), float(match[5])]
        gap = float(match[6] or 0), float(match[7] or 0)
        size = [
            (page - 2 * beside - (many - 1) * between) / many if many else 0.0
            for page, beside, many, between in zip(paper, margin, counts, gap, strict=True)
        ]
    if any(side < least for side, least in zip(size, _SMALLEST, strict=True)):
        raise InputError(
            f"label sheet: labels of '{words[:40]}' would be {max(size[0], 0):.4g} x "
            f"{max(size[1], 0):.4g} mm, and need {_SMALLEST[0]:g} x {_SMALLEST[1]:g}; take fewer, "
            "or smaller margins"
        )
    return LabelForm(paper, *counts, (size[0], size[1]), (margin[0], margin[1]), gap)
