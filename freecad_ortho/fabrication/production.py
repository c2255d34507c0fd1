"""All that a workshop needs to know about a structure: sheets, bars, nodes, families, clashes."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any

from freecad_ortho.fabrication.clash import ClashCheck, check_clashes
from freecad_ortho.fabrication.groups import Groups, groups_of
from freecad_ortho.fabrication.kerf import compensated
from freecad_ortho.fabrication.limits import OK
from freecad_ortho.fabrication.nesting import Nesting, Sheet, nest, too_large_words
from freecad_ortho.fabrication.nodes import Node, nodes
from freecad_ortho.fabrication.part import some_names
from freecad_ortho.fabrication.pattern import FlatPattern
from freecad_ortho.fabrication.stock import (
    Bar,
    Stock,
    bars_by_section,
    is_along_line,
    stock_list,
    too_long_words,
)
from freecad_ortho.fabrication.structure import Structure
from freecad_ortho.fabrication.trades import MACHINED
from freecad_ortho.fabrication.workshop import Workshop
from freecad_ortho.words import counted

Progress = Callable[[float, str], None]
# Components of one STEP file from which on FreeCAD takes minutes: the time grows with their square.
_MANY = 3000
# Names that a message has; the report lists all.
_SHOWN = 10


@dataclass(frozen=True, eq=False)
class Production:
    """A structure on its way to the workshop.

    Attributes:
        structure: its parts.
        workshop: what they are cut from and with.
        patterns: flat pattern of each part, compensated for the kerf; None where it has none.
        nodes: vertices at which parts meet.
        groups: equal parts and nodes.
        nesting: patterns on sheets, empty without a sheet size.
        stock: bars that long parts are sawn from.
        clashes: what the clash check found.
    """

    structure: Structure
    workshop: Workshop
    patterns: tuple[FlatPattern | None, ...]
    nodes: tuple[Node, ...]
    groups: Groups
    nesting: Nesting
    stock: Stock
    clashes: ClashCheck

    @property
    def sheets(self) -> tuple[Sheet, ...]:
        """Nested patterns, empty without a sheet size."""
        return self.nesting.sheets

    @property
    def bars(self) -> tuple[Bar, ...]:
        """Stock that long parts are sawn from."""
        return self.stock.bars

    @property
    def on_site(self) -> str:
        """Where the origin of coordinates in files is on site, in words; empty for there."""
        datum = self.workshop.datum.of_files(self.structure.file_origin)
        return str(datum) if datum.is_known else ""

    @property
    def places(self) -> dict[str, str]:
        """The sheet or bar that each part is cut from, by the names of those that have one."""
        return {name: bar.name for bar in self.bars for name in bar.parts} | self.nesting.places

    @property
    def named_patterns(self) -> dict[str, FlatPattern]:
        """The flat patterns by the names of their parts."""
        pairs = zip(self.structure.parts, self.patterns, strict=True)
        return {part.name: pattern for part, pattern in pairs if pattern is not None}

    @property
    def verdicts(self) -> tuple[str, ...]:
        """For each part "ok", or which limit it exceeds, what it cuts, what it is too large for."""
        cuts: dict[str, list[str]] = {}
        for clash in self.clashes.clashes:
            for name, other in ((clash.first, clash.second), (clash.second, clash.first)):
                cuts.setdefault(name, []).append(f"cuts {other} by {_volume(clash.volume)} mm3")
        for pair in self.clashes.open:
            for name, other in (pair, pair[::-1]):
                cuts.setdefault(name, []).append(
                    f"may cut {other}, which the CAD kernel leaves open"
                )
        verdicts = []
        for part, words in zip(self.structure.parts, self.structure.verdicts, strict=True):
            all_words = ([] if words == OK else [words]) + cuts.get(part.name, [])
            all_words += [words for words in [self.not_cut.get(part.name)] if words]
            verdicts.append("; ".join(all_words) or OK)
        return tuple(verdicts)

    @cached_property
    def not_cut(self) -> dict[str, str]:
        """Of parts that no sheet and no bar has room for, what they are too large for, by name."""
        shop, places = self.workshop, self.places
        words = {
            part.name: f"too long for bars of {shop.stock:g} mm"
            for part in self.stock.too_long
            if part.name not in places
        }
        if shop.sheet is not None:
            width, height = shop.sheet
            for part in self.nesting.too_large:
                if part.name not in places:
                    words[part.name] = f"too large for sheets of {width:g} x {height:g} mm"
        return words

    @property
    def messages(self) -> tuple[str, ...]:
        """What is out of the ordinary, in plain words: on the structure and on its files."""
        words = list(self.structure.report()["messages"])
        if not self.named_patterns:
            words.append(
                "flat.dxf is not written, as no part has a flat pattern; parts.csv says in words "
                "how tubes are cut"
            )
        units = sum(part.material.thickness is not None for part in self.structure.parts)
        if units and self.workshop.sheet is not None:
            words.append(
                f"sheets leave out {units} of a build-up: they are ordered to size, by their flat "
                "patterns"
            )
        words += [
            f"{each.file} is not written: the Python package '{each.installed_as}' is missing; "
            f"install it with pip, or leave out {each.name}"
            for each in self.workshop.formats
            if each.missing
        ]
        materials = {p.material.name: p.material for p in self.structure.parts}.values()
        for each in self.workshop.formats:
            works, what = MACHINED.get(each.name, (None, ""))
            if works is not None and not any(map(works, materials)):
                words.append(
                    f"{each.place}: nothing to write, as no part is of {what}; give such a "
                    f"material, or leave out {each.name}"
                )
        return (*words, *self._about_solids(), *self._about_stock())

    def _about_solids(self) -> list[str]:
        """What makes a large STEP file slow to open."""
        count, shop = len(self.structure.parts), self.workshop
        if count <= _MANY or shop.step == "in-place" or shop.step_tolerance > 0:
            return []
        return [
            f"step: {count:,} parts in one assembly take FreeCAD long to open; "
            "for it take step in-place, and tick Use LinkGroup when it asks how to import the file"
        ]

    def _about_stock(self) -> list[str]:
        """What is cut from no sheet and no bar, or not from the one that it should be."""
        words, places = list(self.nesting.remarks), self.places
        parts, large = self.structure.parts, self.nesting.too_large
        curved = [part.name for part in parts if is_along_line(part) and part.name not in places]
        long = {part.name for part in self.stock.too_long}
        curved = [name for name in curved if name not in long]
        if curved and self.workshop.sheet is None:
            words.append(
                f"stock.csv leaves out {len(curved)} of the parts, {curved[0]} for one: their flat "
                "patterns are curved, so they are cut from sheets"
            )
        lost = [part for part in large if part.name not in places]
        if lost:
            words.append(too_large_words(lost, self.workshop, _SHOWN))
        if len(lost) < len(large):
            sawn = [part.name for part in large if part.name in places]
            words.append(
                f"sheet: {counted(len(sawn), 'part')} too large for a sheet, sawn from bars "
                f"instead: {some_names(sawn, _SHOWN)}"
            )
        if self.stock.too_long:
            words.append(too_long_words(self.stock.too_long, self.workshop, _SHOWN))
        return words

    def report(self) -> dict[str, Any]:
        """The structure's report with what production adds, ready for JSON; lengths in mm."""
        parts, verdicts = self.structure.parts, self.verdicts
        pairs = zip(parts, verdicts, strict=True)
        failed = {part.name: words for part, words in pairs if words != OK}
        return {
            **self.structure.report(),
            "messages": list(self.messages),
            "verdict": {"passed": len(parts) - len(failed), "failed": failed},
            "families": self.groups.report(),
            "clash_check": self.clashes.report(),
            "stock": _stock_report(self.stock, self.workshop),
            "sheets": self._sheet_report(),
            "kerf_mm": self.workshop.kerf,
            "site": asdict(self.workshop.datum.of_files(self.structure.file_origin)),
        }

    def _sheet_report(self) -> dict[str, Any] | None:
        if self.workshop.sheet is None:
            return None
        width, height = self.workshop.sheet
        used = sum(sheet.used for sheet in self.sheets)
        area = sum(sheet.width * sheet.height for sheet in self.sheets)
        return {
            "width_mm": width,
            "height_mm": height,
            "spacing_mm": self.workshop.spacing,
            "count": len(self.sheets),
            "parts": sum(len(sheet.placements) for sheet in self.sheets),
            "waste": 1 - used / (area or width * height),
            "too_large": [part.name for part in self.nesting.too_large],
            "sheets": [
                {
                    "name": sheet.name,
                    "file": sheet.file_name,
                    "material": sheet.material,
                    "thickness_mm": sheet.thickness,
                    "width_mm": sheet.width,
                    "height_mm": sheet.height,
                    "waste": sheet.waste,
                    "parts": [placement.name for placement in sheet.placements],
                }
                for sheet in self.sheets
            ],
        }


def produce(
    structure: Structure,
    workshop: Workshop | None = None,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> Production:
    """Work out everything that does not need solids.

    Args:
        structure: what is built.
        workshop: sizes of sheets and bars, width of the cut.
        executor: for work on parts; without one it is done here.
        progress: called with a fraction and words; may raise to stop.

    Raises:
        InputError: sheets or stock on which no part fits, a kerf that closes a slot.
    """
    chosen = workshop or Workshop()
    say = progress or (lambda fraction, words: None)
    parts = structure.parts
    say(0.0, "flat patterns")
    patterns = tuple(
        None if part.pattern is None else compensated(part.name, part.pattern, chosen.kerf)
        for part in parts
    )
    nesting = Nesting()
    if chosen.sheet is not None:
        nesting = nest(parts, chosen, patterns, lambda done, words: say(0.1 + 0.4 * done, words))
    say(0.5, "bars, nodes and families")
    # A part is cut from a sheet or from a bar, not from both.
    places = nesting.places
    bars = stock_list([part for part in parts if part.name not in places], chosen)
    joints = nodes(structure.site, parts)
    equal = groups_of(parts, joints, chosen.equal)
    say(0.6, "clash check")
    clashes = check_clashes(parts, executor, lambda done: say(0.6 + 0.4 * done, "clash check"))
    say(1.0, "clash check")
    return Production(structure, chosen, patterns, joints, equal, nesting, bars, clashes)


def _stock_report(stock: Stock, workshop: Workshop) -> dict[str, Any]:
    bars = stock.bars
    length, cut = sum(bar.length for bar in bars), sum(bar.cut for bar in bars)
    kept = sum(bar.left for bar in bars if bar.usable)
    return {
        "bars": len(bars),
        "length_mm": max((bar.length for bar in bars), default=None),
        "saw_mm": workshop.saw,
        "trim_mm": workshop.trim,
        "waste": 1 - (cut + kept) / length if bars else None,
        "rests_kept_mm": kept,
        "sections": [
            {
                "section": group[0].section,
                "material": group[0].material,
                "bars": len(group),
                "parts": sum(len(bar.parts) for bar in group),
                "width_min_mm": min(bar.widths[0] for bar in group),
                "width_max_mm": max(bar.widths[1] for bar in group),
                "thickness_mm": group[0].thickness,
            }
            for group in bars_by_section(bars)
        ],
        "too_long": [part.name for part in stock.too_long],
    }


def _volume(volume: float) -> str:
    """A volume that is not 0 in words that do not say so either, mm3."""
    return f"{volume:.1f}" if volume >= 0.1 else "less than 0.1"
