"""Bars and strips: which parts are sawn from which length of stock.

A bar gives up a piece at each end, a saw cut behind every part, and what is left is a rest that
goes back to the store or to scrap.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from freecad_ortho.fabrication.part import Part, some_names
from freecad_ortho.fabrication.workshop import Workshop
from solver.errors import InputError

_USUAL = 6000.0
# A flat pattern whose box is more times as wide as its part is curved: cut from a sheet, not a
# strip, of which a third and more would be lost.
_CURVED = 1.5
# Parts that fill a bar exactly may miss by rounding, mm.
_ROUNDING = 1e-6


@dataclass(frozen=True)
class Bar:
    """One length of stock.

    Attributes:
        name: ``S0001``.
        material: its name.
        kind: of the parts that are sawn from it.
        section: what to take from the store, ``strip 200 x 12`` or ``tube 120 x 80 x 5``.
        widths: of its narrowest and its widest part, mm; of tubes, their heights.
        thickness: mm.
        length: of the stock, mm.
        parts: names, from one end to the other.
        cut: length of the parts, mm.
        used: with the saw cuts behind them and the two ends, mm.
        usable: whether what is left is long enough to be kept.
    """

    name: str
    material: str
    kind: str
    section: str
    widths: tuple[float, float]
    thickness: float
    length: float
    parts: tuple[str, ...]
    cut: float
    used: float
    usable: bool

    @property
    def left(self) -> float:
        """What is left over, mm."""
        return self.length - self.used


@dataclass(frozen=True)
class Stock:
    """What came of laying parts onto bars.

    Attributes:
        bars: with all parts that fit on one.
        too_long: the parts that do not.
    """

    bars: tuple[Bar, ...] = ()
    too_long: tuple[Part, ...] = ()


def stock_list(parts: Sequence[Part], workshop: Workshop) -> Stock:
    """Lay the parts that are longer than wide and stand on edges onto bars: first fit, long first.

    Plates may be cut from a strip that is wider than they are; a tube cannot be made lower, so the
    tubes on one bar are of one section.

    Args:
        parts: panels, parts without a length of their own and those whose flat pattern is curved,
            which are cut from sheets, are left out.
        workshop: length of the stock, what its ends and saw cuts take.

    Raises:
        InputError: stock on which no part fits.
    """
    linear = [part for part in parts if _is_linear(part)]
    length = _stock_length(linear, workshop)
    fits = [_needed([part], workshop) <= length + _ROUNDING for part in linear]
    fitting = [part for part, good in zip(linear, fits, strict=True) if good]
    too_long = tuple(part for part, good in zip(linear, fits, strict=True) if not good)
    if too_long and not fitting:
        raise InputError(too_long_words(too_long, workshop))
    bars: list[Bar] = []
    for alike in _alike(fitting, workshop.section_tolerance):
        section = _section(alike)
        for group in _first_fit(alike, length, workshop):
            used, widths = _needed(group, workshop), [_width(part) for part in group]
            shorter = [each for each in workshop.lengths_in_store if used <= each + _ROUNDING]
            bar = min([length, *shorter])
            bars.append(
                Bar(
                    f"S{len(bars) + 1:04d}",
                    group[0].material.name,
                    group[0].kind,
                    section,
                    (min(widths), max(widths)),
                    group[0].thickness,
                    bar,
                    tuple(part.name for part in group),
                    sum(part.length for part in group),
                    used,
                    bar - used >= workshop.rest,
                )
            )
    return Stock(tuple(bars), too_long)


def too_long_words(parts: Sequence[Part], workshop: Workshop, shown: int | None = None) -> str:
    """Name the parts that do not fit on a bar, all or so many, with the length of the longest."""
    names = some_names([part.name for part in parts], shown)
    count = f"{len(parts)} parts do" if len(parts) > 1 else "1 part does"
    longest = max(part.length for part in parts)
    return (
        f"stock: {count} not fit on {workshop.stock:g} mm, of which {workshop.trim:g} mm at each "
        f"end and {workshop.saw:g} mm a cut are lost (the longest is {longest:.1f} mm): {names}; "
        "take longer stock or a system that splices its parts"
    )


def bars_by_section(bars: Sequence[Bar]) -> list[list[Bar]]:
    """The bars of one section and material together: what to take from the store."""
    groups: dict[tuple[str, str], list[Bar]] = {}
    for bar in bars:
        groups.setdefault((bar.section, bar.material), []).append(bar)
    return list(groups.values())


def different_tubes(
    parts: Sequence[Part], tolerance: float = Workshop.section_tolerance
) -> tuple[tuple[Part, ...], ...]:
    """Groups of the tubes among the parts that are of one section, the lowest first.

    Args:
        parts: whatever there is.
        tolerance: by which their heights may differ from the middle one, percent.
    """
    tubes = [part for part in parts if is_sawn(part)]
    groups: list[list[Part]] = []
    spread = (100 + tolerance) / (100 - tolerance)
    for part in sorted(tubes, key=lambda part: (*_bar_kind(part), part.width)):
        first = groups[-1][0] if groups else None
        if (
            first is not None
            and _bar_kind(first) == _bar_kind(part)
            and part.width <= first.width * spread
        ):
            groups[-1].append(part)
        else:
            groups.append([part])
    return tuple(tuple(group) for group in groups)


def _bar_kind(part: Part) -> tuple[str, str, str, float, float]:
    """What the parts on one bar have in common, whatever their height."""
    width = part.section_width or 0.0
    return part.material.name, part.kind, part.section, part.thickness, width


def is_along_line(part: Part) -> bool:
    """Whether a part lies along a parameter line, as beams and lamellas do."""
    return part.face is None and part.line is not None


def is_sawn(part: Part) -> bool:
    """Whether a part is sawn from a tube or another section: edge beams and posts of feet too."""
    ordered = part.line is not None or bool(part.section) or part.section_width is not None
    return part.pattern is None and ordered


def _alike(parts: Sequence[Part], tolerance: float) -> list[Sequence[Part]]:
    """Parts that may share a bar: plates of one material, kind and thickness, then tubes.

    Flanges are not cut from strips as wide as webs: of one a third and more would be lost.
    """
    plates: dict[tuple[str, str, str, float, float], list[Part]] = {}
    for part in parts:
        if part.pattern is not None:
            plates.setdefault(_bar_kind(part), []).append(part)
    strips = [strip for some in plates.values() for strip in _by_width(some)]
    return [*strips, *different_tubes(parts, tolerance)]


def _by_width(parts: Sequence[Part]) -> list[list[Part]]:
    """Plates that are cut from strips of one width, the widest first, each in the order given."""
    widths, left = {part.name: _width(part) for part in parts}, list(parts)
    strips = []
    while left:
        least = max(widths[part.name] for part in left) / _CURVED
        strips.append([part for part in left if widths[part.name] >= least])
        left = [part for part in left if widths[part.name] < least]
    return strips


def _section(parts: Sequence[Part]) -> str:
    """What to take from the store for parts that share bars."""
    first, widths = parts[0], [_width(part) for part in parts]
    if first.pattern is not None:
        return f"strip {math.ceil(max(widths) - _ROUNDING)} x {first.thickness:g}"
    if first.section:
        return first.section
    middle = (min(widths) + max(widths)) / 2
    across = f" x {first.section_width:g}" if first.section_width else ""
    return f"tube {middle:.0f}{across} x {first.thickness:g}"


def _is_linear(part: Part) -> bool:
    if is_sawn(part):
        return True
    return is_along_line(part) and _width(part) <= _CURVED * part.section_height


def _width(part: Part) -> float:
    """Of the strip or tube that a part is cut from, mm."""
    return part.width if part.pattern is None else float(part.pattern.size[1])


def _stock_length(parts: Sequence[Part], workshop: Workshop) -> float:
    if workshop.stock is not None:
        return workshop.stock
    longest = max((_needed([part], workshop) for part in parts), default=0.0)
    return max(_USUAL, 1000.0 * math.ceil(longest / 1000))


def _first_fit(parts: Sequence[Part], length: float, workshop: Workshop) -> list[list[Part]]:
    groups: list[list[Part]] = []
    left: list[float] = []
    for part in sorted(parts, key=lambda part: (-part.length, part.name)):
        needed = part.length + workshop.saw
        place = next((k for k, rest in enumerate(left) if needed <= rest + _ROUNDING), None)
        if place is None:
            groups.append([part])
            left.append(length - _needed([part], workshop))
        else:
            groups[place].append(part)
            left[place] -= needed
    return groups


def _needed(parts: Sequence[Part], workshop: Workshop) -> float:
    """Stock that parts take: the last is cut off too, and both ends of the bar are."""
    cuts = workshop.saw * len(parts)
    return sum(part.length for part in parts) + cuts + 2 * workshop.trim
