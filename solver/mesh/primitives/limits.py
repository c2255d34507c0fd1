"""What every primitive asks of its parameters."""

from __future__ import annotations

from solver.errors import InputError
from solver.option import number_within


def positive(**values: float) -> None:
    """Refuse values that are not positive and finite.

    Raises:
        InputError: names the first of them.
    """
    for name, value in values.items():
        number_within(name, value)


def between(low: float, high: float, **values: float) -> None:
    """Refuse values that are not strictly between two limits.

    Raises:
        InputError: names the first of them.
    """
    for name, value in values.items():
        if not low < value < high:
            raise InputError(f"{name}: expected {low:g} < {name} < {high:g}, got {value:g}")
