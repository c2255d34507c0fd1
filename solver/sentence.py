"""Sentences of which numbers and words are known apart, for other languages and units."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Measured:
    """A length or an area within a sentence.

    Attributes:
        value: in ``unit``, or where there is none in that of the mesh.
        power: 1 for a length, 2 for an area.
        digits: how many are said.
        unit: said behind the number.
    """

    value: float
    power: int = 1
    digits: int = 3
    unit: str = ""

    def __str__(self) -> str:
        power = str(self.power) if self.power > 1 else ""
        return f"{self.value:.{self.digits}g}" + f" {self.unit}{power}" * bool(self.unit)


class Sentence(str):
    """A sentence in English that can be said in another language as well.

    Attributes:
        pattern: the words, with ``{}`` where a value stands, written out where it is made:
            ``scripts/translations.py`` finds it there.
        values: numbers, words, measures, sentences, or tuples of these, which make a list.
    """

    pattern: str
    values: tuple[object, ...]

    def __new__(cls, pattern: str, *values: object) -> Sentence:
        """Say it in English."""
        made = super().__new__(cls, pattern.format(*map(_listed, values)))
        made.pattern, made.values = pattern, values
        return made

    def __getnewargs__(self) -> tuple[object, ...]:  # type: ignore[override]
        """What makes it again where it is copied or stored."""
        return (self.pattern, *self.values)


def at(place: Iterable[float]) -> str:
    """A place (3,) in words, with as many digits as tell where to look."""
    return "(" + ", ".join(f"{x:.4g}" for x in place) + ")"


def _listed(value: object) -> object:
    return ", ".join(map(str, value)) if isinstance(value, tuple) else value
