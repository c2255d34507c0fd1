"""What systems of large plates know of the sheets that these are cut from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from freecad_ortho.fabrication.nesting.room import Room
from freecad_ortho.fabrication.sizes import check_options
from freecad_ortho.fabrication.systems.system import System
from freecad_ortho.fabrication.workshop import Workshop
from freecad_ortho.words import counted

# What systems of sheets that span several faces are not built with.
OVER_NODES = {
    "nodes": "cannot be built together: the sheets run over the nodes; take panels, or leave "
    "the nodes out"
}
# The workshop's own, so that a size is given once.
SHEET_OPTIONS = tuple(
    option for option in Workshop.options if option.name in ("sheet", "spacing", "grain", "kerf")
)

# Names of pieces that a message says.
_SHOWN = 5


@dataclass(frozen=True, kw_only=True)
class FromSheets(System):
    """A system of plates that are cut small enough for a sheet.

    Args:
        sheet: its size, mm; None leaves plates whole.
        spacing: from the rim of a sheet, mm.
        grain: "none" lets plates turn on a sheet, "along" does not.
        kerf: width of the cut, mm.

    Raises:
        InputError: a size or a word that cannot be used.
    """

    sheet: str | tuple[float, float] | None = None
    spacing: float = Workshop.spacing
    grain: str = Workshop.grain
    kerf: float = Workshop.kerf

    def __post_init__(self) -> None:
        # Those of the sheet are checked where the room on it is worked out.
        check_options(self, set(self.options).difference(SHEET_OPTIONS))
        _ = self.room

    @property
    def room(self) -> Room | None:
        """What a sheet leaves for a pattern, None without a sheet.

        Raises:
            InputError: a size or a word that cannot be used.
        """
        values = {option.name: getattr(self, option.name) for option in SHEET_OPTIONS}
        return Room.of(Workshop.of(values), self.kerf / 2)


def trimming_report(cut: int, left_out: Mapping[str, float]) -> dict[str, Any]:
    """What is to be said of the border in a system's report.

    Args:
        cut: how many parts it cuts.
        left_out: areas of the pieces that are left out by their names, mm2.
    """
    return {
        "trimmed": cut,
        "left_out": sorted(left_out),
        "left_out_mm2": sum(left_out.values()),
    }


def narrower(least_width: float) -> str:
    """What pieces are that are narrower than a width, mm."""
    return f"narrower than {least_width:g} mm"


def left_out_words(
    system: str,
    left_out: Mapping[str, float],
    what: str,
    remedy: str = "a smaller least width keeps it",
) -> list[str]:
    """A message where a system leaves narrow pieces out.

    Args:
        system: its name.
        left_out: areas by names, mm2.
        what: pieces are left out that are this.
        remedy: what can be done.
    """
    if not left_out:
        return []
    area = sum(left_out.values()) / 1e6
    shown = ", ".join(list(left_out)[:_SHOWN]) + (" ..." if len(left_out) > _SHOWN else "")
    return [
        f"{system}: left out at the border what is {what}: {shown}, {area:.2g} m2 in "
        f"{len(left_out)}; {remedy}"
    ]


def split_words(
    kind: str,
    whole: Sequence[object],
    parts: Sequence[object],
    sheet: str | tuple[float, float] | None,
    too_large: int = 0,
) -> tuple[str, ...]:
    """What is to be said where parts were cut to fit a sheet, which some may still not."""
    if len(parts) <= len(whole):
        return ()
    size = sheet if isinstance(sheet, str) else "{:g}x{:g}".format(*(sheet or (0.0, 0.0)))
    return (
        f"sheet: {counted(len(whole), kind)} cut along lines of the net into {len(parts)} parts, "
        f"so that {f'all but {too_large} fit' if too_large else 'each fits'} on {size} mm",
    )
