"""Bars and strips: which parts are sawn from which length of stock."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.workshop import Workshop
from solver.errors import InputError

_USUAL = 6000.0
# Tubes whose heights differ by no more, mm, are one tube: mills roll them no truer.
SAME_TUBE = 0.1
# A flat pattern whose box is more times as wide as its part is curved: cut from a sheet, not a
# strip, of which a third and more would be lost.
_CURVED = 1.5


@dataclass(frozen=True)
class Bar:
    """One length of stock.

    Attributes:
        name: ``S0001``.
        material: its name.
        kind: of the parts that are sawn from it.
        width: that the strip must have, that of its widest part, mm; of a tube, its height.
        thickness: mm.
        length: of the stock, mm.
        parts: names, from one end to the other.
        used: length of the parts and the saw cuts between them, mm.
    """

    name: str
    material: str
    kind: str
    width: float
    thickness: float
    length: float
    parts: tuple[str, ...]
    used: float


def stock_list(parts: Sequence[Part], workshop: Workshop) -> tuple[Bar, ...]:
    """Lay the parts that are longer than wide and stand on edges onto bars: first fit, long first.

    Plates may be cut from a strip that is wider than they are; a tube cannot be made lower, so the
    tubes on one bar are alike.

    Args:
        parts: panels, parts without a length of their own and those whose flat pattern is curved,
            which are cut from sheets, are left out.
        workshop: length of the stock and width of the saw cut.

    Raises:
        InputError: a part is longer than the stock.
    """
    linear = [part for part in parts if _is_linear(part)]
    if not linear:
        return ()
    length = _stock_length(linear, workshop)
    bars: list[Bar] = []
    for alike in _alike(linear):
        for group in _first_fit(alike, length, workshop.saw):
            bars.append(
                Bar(
                    f"S{len(bars) + 1:04d}",
                    group[0].material.name,
                    group[0].kind,
                    max(_width(part) for part in group),
                    group[0].thickness,
                    length,
                    tuple(part.name for part in group),
                    _needed(group, workshop.saw),
                )
            )
    return tuple(bars)


def different_tubes(parts: Sequence[Part]) -> tuple[tuple[Part, ...], ...]:
    """Groups of the tubes among the parts that are as high as one another, the lowest first."""
    tubes = [part for part in parts if part.pattern is None and part.line is not None]
    groups: list[list[Part]] = []
    for part in sorted(tubes, key=lambda part: (*_bar_kind(part), part.width)):
        first = groups[-1][0] if groups else None
        if (
            first is not None
            and _bar_kind(first) == _bar_kind(part)
            and part.width - first.width <= SAME_TUBE
        ):
            groups[-1].append(part)
        else:
            groups.append([part])
    return tuple(tuple(group) for group in groups)


def _bar_kind(part: Part) -> tuple[str, str, float]:
    """What the parts on one bar have in common, whatever their width."""
    return part.material.name, part.kind, part.thickness


def is_along_line(part: Part) -> bool:
    """Whether a part lies along a parameter line, as beams and lamellas do."""
    return part.face is None and part.line is not None


def _alike(parts: Sequence[Part]) -> list[Sequence[Part]]:
    """Parts that may share a bar: plates of one material, kind and thickness, then tubes."""
    plates: dict[tuple[str, str, float], list[Part]] = {}
    for part in parts:
        if part.pattern is not None:
            plates.setdefault(_bar_kind(part), []).append(part)
    return [*plates.values(), *different_tubes(parts)]


def _is_linear(part: Part) -> bool:
    return is_along_line(part) and _width(part) <= _CURVED * part.section_height


def _width(part: Part) -> float:
    """Of the strip or tube that a part is cut from, mm."""
    return part.width if part.pattern is None else float(part.pattern.size[1])


def _stock_length(parts: Sequence[Part], workshop: Workshop) -> float:
    longest = max(parts, key=lambda part: part.length)
    if workshop.stock is None:
        return max(_USUAL, 1000.0 * math.ceil(longest.length / 1000))
    if longest.length > workshop.stock * (1 + 1e-9):
        raise InputError(
            f"stock: {longest.name} is {longest.length:.1f} mm long and the stock "
            f"{workshop.stock:g} mm; take longer stock or a system that splices its parts"
        )
    return workshop.stock


def _first_fit(parts: Sequence[Part], length: float, saw: float) -> list[list[Part]]:
    groups: list[list[Part]] = []
    left: list[float] = []
    for part in sorted(parts, key=lambda part: (-part.length, part.name)):
        place = next((k for k, rest in enumerate(left) if part.length + saw <= rest), None)
        if place is None:
            groups.append([part])
            left.append(length - part.length)
        else:
            groups[place].append(part)
            left[place] -= part.length + saw
    return groups


def _needed(parts: Sequence[Part], saw: float) -> float:
    return sum(part.length for part in parts) + saw * (len(parts) - 1)
