"""What systems of large plates know of the sheets that these are cut from."""

from __future__ import annotations

from collections.abc import Sequence

from freecad_ortho.fabrication.nesting.room import Room
from freecad_ortho.fabrication.workshop import Workshop
from freecad_ortho.words import counted

# The workshop's own, so that a size is given once.
SHEET_OPTIONS = tuple(
    option for option in Workshop.options if option.name in ("sheet", "spacing", "grain", "kerf")
)


def room_on(
    sheet: str | tuple[float, float] | None, spacing: float, grain: str, kerf: float
) -> Room | None:
    """The room that a sheet leaves for a pattern, None without a sheet.

    Raises:
        InputError: a size or a word that cannot be used.
    """
    values = {"sheet": sheet, "spacing": spacing, "grain": grain, "kerf": kerf}
    return Room.of(Workshop.of(values), kerf / 2)


def split_words(
    kind: str,
    whole: Sequence[object],
    parts: Sequence[object],
    sheet: str | tuple[float, float] | None,
) -> tuple[str, ...]:
    """What is to be said where parts were cut to fit a sheet."""
    if len(parts) <= len(whole):
        return ()
    size = sheet if isinstance(sheet, str) else "{:g}x{:g}".format(*(sheet or (0.0, 0.0)))
    return (
        f"sheet: {counted(len(whole), kind)} cut along lines of the net into {len(parts)} parts, "
        f"so that each fits on {size} mm",
    )
