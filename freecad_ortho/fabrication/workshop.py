"""What the workshop cuts from and with: sheets, bars, the width of the cut."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from freecad_ortho.fabrication.sizes import positive
from freecad_ortho.option import Option
from solver.errors import InputError

GRAINS = ("none", "along")
NESTINGS = ("boxes", "outlines")


@dataclass(frozen=True)
class Workshop:
    """Sizes of the material and of the cut, mm.

    Args:
        sheet: width and height of the sheets that plates are cut from, None for no nesting.
        spacing: clear distance between parts on a sheet, and from its rim.
        grain: "none" lets parts turn, "along" keeps their length along the sheet's width.
        nesting: "boxes" packs the parts' boxes: fast, and always the same; "outlines" packs their
            outlines with an optional library, which searches for some seconds a sheet.
        seed: of that search.
        stock: length of bars and strips, None for 6 m or as many metres as the longest part needs.
        saw: width of a saw cut between two parts of a bar.
        kerf: width of the cut that flat patterns are compensated for, 0 for true outlines.

    Raises:
        InputError: a size that cannot be used, an unknown word.
    """

    sheet: tuple[float, float] | None = None
    spacing: float = 10.0
    grain: str = "none"
    nesting: str = "boxes"
    seed: int = 0
    stock: float | None = None
    saw: float = 3.0
    kerf: float = 0.0

    options: ClassVar[tuple[Option, ...]] = (
        Option("sheet", None, "text", "parts are nested on sheets of this size", written="WxH"),
        Option("spacing", 10.0, "length", "parts keep so far from each other and from the rim"),
        Option("grain", "none", "choice", "parts may turn on the sheet as its grain says", GRAINS),
        Option("nesting", "boxes", "choice", "boxes pack fast, outlines densely", NESTINGS),
        Option("seed", 0, "count", "another number begins another search for a dense nesting"),
        Option(
            "stock", None, "length", "bars and strips are this long; longer lamellas are spliced"
        ),
        Option("saw", 3.0, "length", "a saw cut between two parts of a bar is this wide"),
        Option("kerf", 0.0, "length", "outlines grow by half this width of a cut", absent="none"),
    )

    def __post_init__(self) -> None:
        for side in self.sheet or ():
            positive("sheet", side, "mm")
        if self.stock is not None:
            positive("stock", self.stock, "mm")
        for name in ("spacing", "saw", "kerf"):
            value = getattr(self, name)
            if not (isinstance(value, (int, float)) and math.isfinite(value) and value >= 0):
                raise InputError(f"{name}: expected 0 mm or more, got {value}; give a size")
        for name, words in (("grain", GRAINS), ("nesting", NESTINGS)):
            if getattr(self, name) not in words:
                raise InputError(
                    f"{name}: expected {' or '.join(words)}, got '{getattr(self, name)}'"
                )

    @classmethod
    def of(cls, values: Mapping[str, Any]) -> Workshop:
        """Make the settings from values of some of ``options``; a sheet may be a text ``WxH``.

        Raises:
            InputError: a value that cannot be used.
        """
        given = dict(values)
        known = [option.name for option in cls.options]
        for name in given:
            if name not in known:
                raise InputError(
                    f"{name}: the workshop has no such size; it has {', '.join(known)}"
                )
        if isinstance(given.get("sheet"), str):
            given["sheet"] = sheet_size(given["sheet"])
        return cls(**given)


def sheet_size(text: str) -> tuple[float, float]:
    """Width and height of ``3000x1500``, mm.

    Raises:
        InputError: not two numbers.
    """
    match = re.fullmatch(r"\s*(\d+\.?\d*)\s*[xX]\s*(\d+\.?\d*)\s*", text)
    if match is None:
        raise InputError(f"sheet: expected WxH in mm, e.g. 3000x1500, got '{text[:40]}'")
    return float(match[1]), float(match[2])
