"""How drawings are made: sizes of paper, standard scales, what the title block says."""

from __future__ import annotations

from dataclasses import dataclass

from solver.errors import InputError
from solver.option import one_of

# Width and height, mm (ISO 216); A4 upright, the larger ones across, as they are folded.
PAPERS = {
    "a4": (210.0, 297.0),
    "a3": (420.0, 297.0),
    "a2": (594.0, 420.0),
    "a1": (841.0, 594.0),
    "a0": (1189.0, 841.0),
}
# 1 to so many (ISO 5455).
SCALES = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000)
_LONGEST_DATE = 30


@dataclass(frozen=True)
class DrawingForm:
    """How drawings are made.

    Args:
        paper: one of ``PAPERS``.
        date: of the title block, as it is written there; empty for none.

    Raises:
        InputError: an unknown paper, a date that has no room.
    """

    paper: str = "a3"
    date: str = ""

    def __post_init__(self) -> None:
        one_of("paper", self.paper, PAPERS)
        if len(self.date) > _LONGEST_DATE or not self.date.isprintable():
            raise InputError(
                f"date: expected up to {_LONGEST_DATE} characters on one line, got "
                f"'{self.date[:40]}'; shorten it"
            )


def scale_for(width: float, height: float, room: tuple[float, float]) -> int:
    """The largest standard scale, 1 to so many, at which a size fits into a room; both mm."""
    needed = max(width / room[0], height / room[1])
    return next((scale for scale in SCALES if scale >= needed), SCALES[-1])
