"""What is bought and what is left of it: bars by section, sheets by size, off-cuts."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.nesting.sheet import Sheet
from freecad_ortho.fabrication.production import Production
from freecad_ortho.fabrication.stock import bars_by_section

OFF_CUT_COLUMNS = (
    *("from", "material", "section", "left_mm", "rectangle_left_mm", "waste_share", "rest"),
)


@dataclass(frozen=True)
class Bought:
    """Some pieces of stock of one kind.

    Attributes:
        item: as price lists name it.
        material: its name.
        size: of one piece, in words, mm.
        pieces: how many.
        amount: of all, in the unit.
        unit: "m" or "m2".
    """

    item: str
    material: str
    size: str
    pieces: int
    amount: float
    unit: str


def bought(production: Production) -> list[Bought]:
    """All bars and sheets, by what they are and how large."""
    found = []
    for group in bars_by_section(production.bars):
        for length in sorted({bar.length for bar in group}):
            count = sum(bar.length == length for bar in group)
            found.append(
                Bought(
                    *(group[0].section, group[0].material, f"{length:g}", count),
                    *(count * length / 1000, "m"),
                )
            )
    sheets: dict[tuple[str, str, str], list[Sheet]] = {}
    for sheet in production.sheets:
        item = f"sheet {sheet.material} {sheet.thickness:g} mm"
        size = f"{sheet.width:g} x {sheet.height:g}"
        sheets.setdefault((item, sheet.material, size), []).append(sheet)
    for key, some in sheets.items():
        area = sum(sheet.width * sheet.height for sheet in some) * 1e-6
        found.append(Bought(*key, len(some), area, "m2"))
    return found


def off_cuts(production: Production) -> list[list[object]]:
    """A row for what is left of each bar and of each sheet."""
    rows: list[list[object]] = [
        [
            *(bar.name, bar.material, bar.section, f"{bar.left:.1f}", ""),
            *(f"{1 - bar.cut / bar.length:.4f}", "kept" if bar.usable else "scrap"),
        ]
        for bar in production.bars
    ]
    for sheet in production.sheets:
        across, up = rectangle_left(sheet)
        size = f"{across:.0f} x {up:.0f}" if min(across, up) > 0 else ""
        thickness = f"{sheet.thickness:g} mm"
        rows.append(
            [sheet.name, sheet.material, thickness, "", size, f"{sheet.waste:.4f}", "sheet"]
        )
    return rows


def rectangle_left(sheet: Sheet) -> tuple[float, float]:
    """The larger of the two strips, mm, beside all parts or above them."""
    corners = np.concatenate([placement.outline for placement in sheet.placements])
    across, up = corners.max(axis=0).tolist()
    beside, above = (sheet.width - across, sheet.height), (sheet.width, sheet.height - up)
    return max(beside, above, key=lambda size: size[0] * size[1])
