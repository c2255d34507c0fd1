"""Settings that forms, properties, macros and the command line offer from one declaration each."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

import numpy as np

from solver.errors import InputError

Kind = Literal[
    "length", "distance", "area", "angle", "pressure", "force", "per_length", "per_area", "percent",
    "number", "weight", "direction", "count", "choice", "flag", "text", "points", "polylines",
    "singular", "placement", "mesh",
]  # fmt: skip
# Kinds of one number; an option that is a tuple has several of them.
NUMBERS = (
    "length", "distance", "area", "angle", "pressure", "force", "per_length", "per_area", "percent",
    "number", "weight", "direction", "count",
)  # fmt: skip
# Words for directions.
AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
_SUFFIXES = {2: ("Start", "End"), 3: ("X", "Y", "Z"), 4: ("First", "Second", "Third", "Fourth")}
# The power of length that a kind of value is.
_POWERS = {
    "length": 1, "distance": 1, "area": 2, "per_length": -1, "per_area": -2, "points": 1,
}  # fmt: skip


def _same(value: Any) -> Any:
    return value


class Former(NamedTuple):
    """What an option was called before, where scripts and documents may still do so.

    Attributes:
        name: its name then.
        now: what a value of then is now.
    """

    name: str
    now: Callable[[Any], Any] = _same


class Range(NamedTuple):
    """The numbers that an option may be.

    Attributes:
        least: the smallest one; lengths in mm, angles in degrees.
        most: the largest one.
        above: whether it has to be above ``least``, which is itself not allowed.
        below: whether it has to be below ``most``.
        zero: whether 0 is one of them, where it lies between.
    """

    least: float = -math.inf
    most: float = math.inf
    above: bool = False
    below: bool = False
    zero: bool = True

    @property
    def closed(self) -> bool:
        """Whether there is a smallest and a largest one."""
        return math.isfinite(self.least) and math.isfinite(self.most)

    def holds(self, value: float) -> bool:
        """Whether a number is one of them."""
        low = value > self.least if self.above else value >= self.least
        high = value < self.most if self.below else value <= self.most
        return low and high and (self.zero or value != 0)

    def words(self, unit: str = "") -> str:
        """Say which these are, as ``0 to 10 mm``; nothing where any number is."""
        least, most, unit = f"{self.least:g}", f"{self.most:,g}", f" {unit}" * bool(unit)
        if math.isinf(self.most):
            if math.isinf(self.least):
                return "" if self.zero else "a number other than 0"
            return f"a number above {least}{unit}" if self.above else f"{least}{unit} or more"
        if math.isinf(self.least):
            return f"a number below {most}{unit}" if self.below else f"{most}{unit} at most"
        if self.above and self.below:
            return f"a number between {least} and {most}{unit}"
        if self.above:
            return f"a number above {least}, {most}{unit} at most"
        return f"{least} to {'below ' * self.below}{most}{unit}"


POSITIVE = Range(0.0, above=True)
NOT_NEGATIVE = Range(0.0)
NOT_ZERO = Range(zero=False)
# Of kinds that are not just any number; a length that is found where none is given is positive.
_RANGES = {"length": NOT_NEGATIVE, "weight": NOT_NEGATIVE, "count": NOT_NEGATIVE}
_UNITS = {"angle": "degrees", "percent": "%", "pressure": "kN/m2"}


@dataclass(frozen=True)
class Option:
    """One thing that the user may set: of a net, a source of nets, a system or the workshop.

    Attributes:
        name: keyword in Python, ``panel_thickness``; ``--panel-thickness`` on the command line.
        default: value, a tuple where there are several numbers; None where there is none, and of a
            length that is found where none is given.
        kind: ``length`` (not negative), ``distance``, ``area``, ``angle`` (degrees), ``pressure``
            (kN/m2), ``force`` (kN, or all in another unit), ``per_length`` and ``per_area`` (forces
            by model units), ``percent``, ``number``, ``weight`` (not negative), ``count`` (whole),
            ``direction`` (three numbers, or ``x``, ``y``, ``z``), ``choice``, ``flag``, ``text``,
            ``points`` ((n, 3)), ``polylines`` (any number of those), ``singular`` (rows x, y, z,
            number of lines; none, or None to have them found), ``placement`` (rotation (3, 3),
            origin (3,)) or ``mesh`` (one with the same faces).
            Defaults with a length are in mm.
        meaning: what it does, a sentence without its full stop.
        choices: words of a choice.
        within: what its numbers may be, where the kind does not say; lengths in mm.
        examples: other words that may stand in place of a choice; where there are some, any may.
        suffixes: of the parts of a tuple, in property names.
        written: how its value is written where the kind does not say, as ``WxH``.
        absent: what a form shows in place of a length of zero, as ``none``.
        title: what stands before its field in a form; by default its name.
        brief: its meaning in the words of the command line, where these are others.
        shown: words of a form for each choice, for a box to tick (``yes``) or for none (``none``).
        stored: name of the property that holds it, where that does not follow from the name.
        former: what it was called before.
    """

    name: str
    default: Any
    kind: Kind
    meaning: str
    choices: tuple[str, ...] = ()
    suffixes: tuple[str, ...] = ()
    written: str = ""
    absent: str = ""
    title: str = ""
    brief: str = ""
    shown: Mapping[str, str] = field(default_factory=dict, hash=False)
    stored: str = ""
    former: Former | None = None
    examples: tuple[str, ...] = ()
    within: Range | None = None

    @property
    def range(self) -> Range:
        """What its numbers may be."""
        if self.within is None and self.kind == "length" and self.default is None:
            return POSITIVE
        return self.within or _RANGES.get(self.kind, Range())

    @property
    def words_of_name(self) -> str:
        """What it is called in a refusal."""
        return self.name.replace("_", " ")

    @property
    def parts(self) -> tuple[str, ...]:
        """Names of the properties that hold it."""
        stem = self.stored or "".join(word.capitalize() for word in self.name.split("_"))
        if self.kind in NUMBERS and isinstance(self.default, tuple):
            ends = self.suffixes or _SUFFIXES[len(self.default)]
            return tuple(stem + end for end in ends)
        return (stem,)

    @property
    def label(self) -> str:
        """What it is called in a form."""
        return self.title or self.name.replace("_", " ").capitalize()

    @property
    def sentence(self) -> str:
        """The meaning, and what stands for "let it be found" in a property."""
        zero = f"0 is {self.absent or 'automatic'}"
        found = {"length": zero, "angle": zero, "weight": "-1 is automatic"}.get(self.kind)
        return f"{self.meaning}; {found}" if found and self.default is None else self.meaning

    @property
    def words(self) -> dict[str, str]:
        """What a form shows for each choice."""
        return {word: self.shown.get(word, word) for word in self.choices}

    @property
    def several(self) -> bool:
        """Whether a value is a tuple of numbers."""
        return self.kind in NUMBERS and isinstance(self.default, tuple)

    def plain(self, value: Any) -> Any:
        """A value in numbers where a word may stand for it."""
        words = self.kind == "direction" and isinstance(value, str)
        return AXES.get(value.strip().lower(), value) if words else value

    def default_in(self, millimetres: float) -> Any:
        """The default where the unit of length has so many mm."""
        factor = millimetres ** -_POWERS.get(self.kind, 0)
        if factor == 1.0 or self.default is None:
            return self.default
        if self.kind == "points":
            return tuple(tuple(factor * x for x in point) for point in self.default)
        if isinstance(self.default, tuple):
            return tuple(factor * x for x in self.default)
        return factor * self.default

    def is_default(self, value: Any) -> bool:
        """Whether a value says nothing other than the default; of a mesh whether there is none."""
        if value is None or self.default is None:
            return value is self.default
        return np.shape(value) == np.shape(self.default) and bool(np.all(value == self.default))

    def check(self, value: Any, unit: str = "mm") -> None:
        """Refuse a value that is not of this kind.

        Args:
            value: of the option; of numbers and words only one of them is refused.
            unit: of its lengths.

        Raises:
            InputError: naming the option, what was expected and what came.
        """
        own = bool(self.examples) and isinstance(value, str)
        if self.kind == "choice" and not own:
            one_of(self.words_of_name, value, self.choices)
        if self.kind == "flag" and not isinstance(value, (bool, np.bool_)):
            raise InputError(f"{self.words_of_name}: expected True or False, got {value!r}")
        if self.kind == "text" and not isinstance(value, str):
            raise InputError(f"{self.words_of_name}: expected a text, got {value!r}")
        if self.kind in NUMBERS and not (value is None and self.default is None):
            self._check_numbers(value, unit)

    def _check_numbers(self, value: Any, unit: str) -> None:
        many = self.several and isinstance(value, (tuple, list))
        numbers = tuple(value) if many else (value,)
        count = len(self.default) if self.several else 1
        if len(numbers) != count or not all(map(_is_number, numbers)):
            words = f"{count} finite numbers" if count > 1 else "a finite number"
            raise InputError(f"{self.words_of_name}: expected {words}, got {value!r}")
        whole = self.kind == "count"
        if not all(self.range.holds(item) and not (whole and item % 1) for item in numbers):
            of = {"length": unit, "distance": unit, "area": f"{unit}2", **_UNITS}
            words = self.range.words(of.get(self.kind, ""))
            left_out = self.absent if self.default is None and value == 0 else ""
            raise InputError(
                f"{self.words_of_name}: expected {'a whole number, ' * whole}{words}, got {value!r}"
                + f"; without it: {left_out}" * bool(left_out)
            )


def one_of(name: str, word: object, words: Collection[str]) -> None:
    """Refuse a word that is none of those there are.

    Raises:
        InputError: naming them.
    """
    if word not in tuple(words):
        raise unknown(name, word, words)


def unknown(name: str, word: object, words: Iterable[str], also: str = "") -> InputError:
    """What is raised where a word is none of those there are, nor ``also``, what else may be."""
    *others, last = words
    known = f"{', '.join(others)} or {last}" if others else last
    known = f"{', '.join((*others, last))}, or {also}" if also else known
    return InputError(f"{name}: expected {known}, got {str(word)[:40]!r}")


def number_within(name: str, value: object, within: Range = POSITIVE, unit: str = "") -> None:
    """Refuse what is no finite number, or not within a range, in the words of options.

    Raises:
        InputError: naming the range and what came.
    """
    Option(name, 0.0, "length" if unit else "number", "", within=within).check(value, unit)


def whole_number(name: str, value: object, within: Range) -> None:
    """Refuse what is no whole number, or not within a range, in the words of options.

    Raises:
        InputError: naming the range and what came.
    """
    Option(name, 0, "count", "", within=within).check(value)


def _is_number(value: Any) -> bool:
    real = isinstance(value, (int, float, np.integer, np.floating))
    return real and not isinstance(value, bool) and abs(value) < 1e300
