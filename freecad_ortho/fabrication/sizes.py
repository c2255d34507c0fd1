"""Checks of the sizes that a user chooses, and words that several systems share."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import fields
from typing import TYPE_CHECKING

from solver.errors import InputError
from solver.option import POSITIVE, Option, number_within

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

OFFSETS = ("above", "centre", "below")
# Below it, mm, the CAD kernel takes the corners of a plate for one point.
_SMALLEST = 1e-3


def size(name: str, usual: float, words: str) -> Option:
    """An option that is a length above 0, mm."""
    return Option(name, usual, "length", words, within=POSITIVE)


def positive(name: str, value: float, unit: str) -> None:
    """Refuse a value that is not a positive finite number.

    Raises:
        InputError: naming the value.
    """
    number_within(name, value, unit=unit)


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


def check_options(settings: DataclassInstance, options: Iterable[Option], **names: str) -> None:
    """Refuse settings that their options do not allow.

    Args:
        settings: a dataclass; None is allowed where it is a field's default.
        options: any; those that no field holds are left out.
        names: of options by fields that are called otherwise.

    Raises:
        InputError: naming the option.
    """
    by_name = {option.name: option for option in options}
    for field in fields(settings):
        option, value = (
            by_name.get(names.get(field.name, field.name)),
            getattr(settings, field.name),
        )
        if option is None or (value is None and field.default is None):
            continue
        option.check(value)
        if option.kind == "length" and option.range is POSITIVE:
            check_size(option.words_of_name, value)


def offset_levels(offset: str, size: float) -> tuple[float, float]:
    """Lower and upper level of a body of this size above, centred on or below the mesh, mm."""
    lower = {"above": 0.0, "centre": -size / 2, "below": -size}[offset]
    return lower, lower + size


def rounded_down(value: float) -> str:
    """Three digits of a limit that is itself still allowed."""
    digits = 2 - math.floor(math.log10(value)) if value > 0 else 0
    scale = 10.0**-digits
    return f"{math.floor(value / scale) * scale:.6g}"
