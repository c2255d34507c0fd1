"""Checks of the sizes that a user chooses, and words that several systems share."""

from __future__ import annotations

import math
from collections.abc import Collection

from solver.errors import InputError

OFFSETS = ("above", "centre", "below")
# Below it, mm, the CAD kernel takes the corners of a plate for one point.
_SMALLEST = 1e-3


def positive(name: str, value: float, unit: str) -> None:
    """Refuse a value that is not a positive finite number.

    Raises:
        InputError: naming the value.
    """
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    if not number or not math.isfinite(value) or value <= 0:
        raise InputError(f"{name}: expected a number above 0 {unit}, got {value}; give a size")


def not_negative(name: str, value: float) -> None:
    """Refuse a length in mm below 0.

    Raises:
        InputError: naming the value.
    """
    if not (isinstance(value, (int, float)) and math.isfinite(value) and value >= 0):
        raise InputError(f"{name}: expected 0 mm or more, got {value}; give a size")


def check_size(name: str, value: float) -> None:
    """Refuse a length in mm that is not positive, or too small for the CAD kernel.

    Raises:
        InputError: naming the value.
    """
    positive(name, value, "mm")
    if value < _SMALLEST:
        raise InputError(
            f"{name}: expected at least {_SMALLEST:g} mm, got {value:g}; check the unit"
        )


def one_of(name: str, word: str, words: Collection[str]) -> None:
    """Refuse a word that is none of those there are.

    Raises:
        InputError: naming them.
    """
    if word not in words:
        *others, last = words
        raise InputError(f"{name}: expected {', '.join(others)} or {last}, got '{word}'")


def check_offset(offset: str) -> None:
    """Refuse an offset that is none of ``OFFSETS``.

    Raises:
        InputError: naming those there are.
    """
    if offset not in OFFSETS:
        raise InputError(f"offset: expected one of {', '.join(OFFSETS)}, got '{offset}'")


def offset_levels(offset: str, size: float) -> tuple[float, float]:
    """Lower and upper level of a body of this size above, centred on or below the mesh, mm."""
    lower = {"above": 0.0, "centre": -size / 2, "below": -size}[offset]
    return lower, lower + size


def rounded_down(value: float) -> str:
    """Three digits of a limit that is itself still allowed."""
    digits = 2 - math.floor(math.log10(value)) if value > 0 else 0
    scale = 10.0**-digits
    return f"{math.floor(value / scale) * scale:.6g}"
