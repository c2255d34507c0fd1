"""Parts onto sheets: by their boxes, or by their outlines with an optional library."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.nesting import library
from freecad_ortho.fabrication.nesting.room import Room
from freecad_ortho.fabrication.nesting.sheet import Placement, Sheet, turned
from freecad_ortho.fabrication.nesting.skyline import Skyline
from freecad_ortho.fabrication.nesting.strip import LIBRARY
from freecad_ortho.fabrication.part import Part, some_names
from freecad_ortho.fabrication.pattern import FlatPattern
from freecad_ortho.fabrication.workshop import Workshop
from solver.errors import InputError, OrthoError
from solver.isolated import LibraryError

# Sheets that still take parts while more are begun: enough for the small ones to fill gaps.
_OPEN = 12
# What lies as near to the rim fits, mm.
_SAME = 1e-6
Progress = Callable[[float, str], None]


@dataclass(frozen=True, eq=False)
class Nesting:
    """What came of laying parts onto sheets.

    Attributes:
        sheets: with all parts that fit on one.
        too_large: the parts that do not.
        remarks: what is to be said about the search, in plain words.
    """

    sheets: tuple[Sheet, ...] = ()
    too_large: tuple[Part, ...] = ()
    remarks: tuple[str, ...] = ()

    @property
    def places(self) -> dict[str, str]:
        """Names of the sheets by the names of the parts on them."""
        return {on.name: sheet.name for sheet in self.sheets for on in sheet.placements}


@dataclass(frozen=True, eq=False)
class _Item:
    """A part with its pattern turned so that its box is small."""

    part: Part
    pattern: FlatPattern
    angle_deg: float
    width: float
    height: float


def nest(
    parts: Sequence[Part],
    workshop: Workshop,
    patterns: Sequence[FlatPattern | None] | None = None,
    progress: Progress | None = None,
) -> Nesting:
    """Lay the flat patterns of parts onto sheets, each material and thickness on its own.

    Args:
        parts: those without a flat pattern are left out, and build-ups, which nobody cuts.
        workshop: with a sheet size.
        patterns: one a part that has one, to nest instead of the parts' own, e.g. compensated ones.
        progress: called with a fraction and words; may raise to stop.

    Raises:
        InputError: no sheet size, or one on which no part fits.
    """
    if workshop.sheet is None:
        raise InputError("sheet: no size given; say WxH in mm, e.g. 3000x1500")
    chosen = [part.pattern for part in parts] if patterns is None else patterns
    plates = [
        (part, pattern)
        for part, pattern in zip(parts, chosen, strict=True)
        if pattern is not None and part.material.thickness is None
    ]
    found = [_item(part, pattern, workshop) for part, pattern in plates]
    items = [item for item in found if item is not None]
    too_large = [part for (part, _), item in zip(plates, found, strict=True) if item is None]
    if too_large and not items:
        raise InputError(too_large_words(too_large, workshop))
    remarks: list[str] = []
    say = progress or (lambda fraction, words: None)
    sheets: list[Sheet] = []
    for (material, thickness), group in _alike(items):
        placed, failure = _placed(group, workshop, lambda f, words: say(f, f"nesting {words}"))
        for placements in placed:
            name = f"sheet-{len(sheets) + 1:03d}"
            size = _smallest(placements, workshop)
            sheets.append(Sheet(name, *size, thickness, placements, material))
        remarks += [failure] if failure and failure not in remarks else []
    _nothing_lost([item.part.name for item in items], sheets)
    return Nesting(tuple(sheets), tuple(too_large), tuple(remarks))


def _smallest(placements: Sequence[Placement], workshop: Workshop) -> tuple[float, float]:
    """The smallest sheet of the store that what was laid on one fits on, with its clear rim."""
    assert workshop.sheet is not None
    far = np.concatenate([each.outline for each in placements]).max(axis=0) + workshop.spacing
    fits = [
        size
        for size in workshop.sizes_in_store
        if far[0] <= size[0] + _SAME and far[1] <= size[1] + _SAME
    ]
    whole = workshop.sheet
    return min([*fits, whole], key=lambda size: size[0] * size[1])


def _alike(items: Sequence[_Item]) -> list[tuple[tuple[str, float], list[_Item]]]:
    """Items of one material and thickness: materials as they come, the thickest plates first."""
    groups: dict[tuple[str, float], list[_Item]] = {}
    for item in items:
        groups.setdefault((item.part.material.name, item.part.thickness), []).append(item)
    materials = list(dict.fromkeys(material for material, _ in groups))
    return sorted(groups.items(), key=lambda entry: (materials.index(entry[0][0]), -entry[0][1]))


def _placed(
    items: list[_Item], workshop: Workshop, say: Progress
) -> tuple[list[tuple[Placement, ...]], str]:
    """What lies on each sheet, and what is to be said about the library."""
    boxes = _by_boxes(items, workshop)
    if workshop.nesting == "boxes":
        return boxes, ""
    if not library.is_there():
        return boxes, (
            f"nesting: the library {LIBRARY} is not installed, so boxes were packed "
            "instead of outlines"
        )
    try:
        return min(boxes, _by_outlines(items, workshop, say), key=len), ""
    except LibraryError as error:
        return boxes, (
            f"nesting: the library {LIBRARY} failed ({error}), so boxes were packed "
            "instead of outlines"
        )


def _by_outlines(
    items: list[_Item], workshop: Workshop, say: Progress
) -> list[tuple[Placement, ...]]:
    """Sheet by sheet; whatever the library finds, one is never filled less than by boxes."""
    rest = {item.part.name: item for item in items}
    result: list[tuple[Placement, ...]] = []
    with library.Library(workshop) as packer:
        while rest:

            def waiting() -> None:
                say(1 - len(rest) / len(items), f"sheet {len(result) + 1}")

            fallback = _by_boxes(list(rest.values()), workshop)[0]
            found = packer.one_sheet([_as_placement(item) for item in rest.values()], waiting)
            result.append(max(fallback, found, key=_covered))
            for placement in result[-1]:
                del rest[placement.name]
            waiting()
    return result


def _by_boxes(items: list[_Item], workshop: Workshop) -> list[tuple[Placement, ...]]:
    """First fit, the tallest first."""
    width, height = workshop.sheet or (0.0, 0.0)
    spacing = workshop.spacing
    sheets: list[tuple[Skyline, list[Placement]]] = []
    for item in sorted(items, key=lambda item: (-max(item.width, item.height), item.part.name)):
        sizes = [(item.width + spacing, item.height + spacing)]
        if workshop.grain == "none":
            sizes.append((item.height + spacing, item.width + spacing))
        for skyline, placements in sheets[-_OPEN:]:  # noqa: B007
            if (found := skyline.place(*sizes)) is not None:
                break
        else:
            skyline, placements = Skyline(width - spacing, height - spacing), []
            sheets.append((skyline, placements))
            found = skyline.place(*sizes)
        assert found is not None, "the size was checked before"
        number, x, y = found
        placements.append(_placement(item, 90.0 * number, x + spacing, y + spacing))
    return [tuple(placements) for _, placements in sheets]


def _placement(item: _Item, quarter: float, x: float, y: float) -> Placement:
    """Put the lower left corner of the turned pattern's box at (x, y)."""
    angle = (item.angle_deg + quarter) % 360
    low = turned(item.pattern.outline, angle).min(axis=0)
    return Placement(item.part.name, item.pattern, angle, np.array([x, y]) - low)


def _as_placement(item: _Item) -> Placement:
    return _placement(item, 0.0, 0.0, 0.0)


def _item(part: Part, pattern: FlatPattern, workshop: Workshop) -> _Item | None:
    """Turn a part so that it fits, in a box as small as can be; None where it does not fit."""
    room = Room.of(workshop)
    assert room is not None, "the sheet was checked before"
    best: tuple[float, _Item] | None = None
    for angle in room.angles(pattern.outline):
        box = np.ptp(turned(pattern.outline, angle), axis=0)
        area = float(box.prod())
        if room.takes(box) and (best is None or area < best[0] * (1 - 1e-9)):
            best = area, _Item(part, pattern, angle, float(box[0]), float(box[1]))
    return None if best is None else best[1]


def too_large_words(parts: Sequence[Part], workshop: Workshop, shown: int | None = None) -> str:
    """Name the parts that do not fit on a sheet, all or so many, with the size of the largest."""
    width, height = workshop.sheet or (0.0, 0.0)
    largest = max((part.pattern.size for part in parts if part.pattern), key=np.prod)
    names = some_names([part.name for part in parts], shown)
    count = f"{len(parts)} parts do" if len(parts) > 1 else "1 part does"
    size = " x ".join(f"{length:g}" for length in np.ceil(largest))
    return (
        f"sheet: {count} not fit on {width:g} x {height:g} mm with {workshop.spacing:g} mm around "
        f"(the largest is {size} mm): {names}; take larger sheets, less spacing or smaller parts"
    )


def _covered(placements: Sequence[Placement]) -> float:
    return sum(placement.pattern.area for placement in placements)


def _nothing_lost(names: list[str], sheets: Sequence[Sheet]) -> None:
    placed = [placement.name for sheet in sheets for placement in sheet.placements]
    if sorted(placed) != sorted(names):
        wrong = sorted(set(placed) ^ set(names)) or ["one twice"]
        raise OrthoError(f"nesting: {', '.join(wrong[:5])} lost or doubled; please report this")
