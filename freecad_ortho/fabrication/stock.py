"""Bars and strips: which parts are sawn from which length of stock."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.workshop import Workshop
from solver.errors import InputError

_USUAL = 6000.0


@dataclass(frozen=True)
class Bar:
    """One length of stock.

    Attributes:
        name: ``S0001``.
        kind: of the parts that are sawn from it.
        width: that the strip must have, that of its widest part, mm.
        thickness: mm.
        length: of the stock, mm.
        parts: names, from one end to the other.
        used: length of the parts and the saw cuts between them, mm.
    """

    name: str
    kind: str
    width: float
    thickness: float
    length: float
    parts: tuple[str, ...]
    used: float


def stock_list(parts: Sequence[Part], workshop: Workshop) -> tuple[Bar, ...]:
    """Lay the parts that are longer than wide and stand on edges onto bars: first fit, long first.

    Args:
        parts: panels and parts without a length of their own are left out.
        workshop: length of the stock and width of the saw cut.

    Raises:
        InputError: a part is longer than the stock.
    """
    linear = [part for part in parts if part.face is None and part.line is not None]
    if not linear:
        return ()
    length = _stock_length(linear, workshop)
    bars: list[Bar] = []
    for kind, thickness in dict.fromkeys((part.kind, part.thickness) for part in linear):
        chosen = [part for part in linear if (part.kind, part.thickness) == (kind, thickness)]
        for group in _first_fit(chosen, length, workshop.saw):
            bars.append(
                Bar(
                    f"S{len(bars) + 1:04d}",
                    kind,
                    max(part.width for part in group),
                    thickness,
                    length,
                    tuple(part.name for part in group),
                    _needed(group, workshop.saw),
                )
            )
    return tuple(bars)


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
