"""Settings that forms, macros, documents and the command line offer from one table."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

# Kinds of one number; an option that is a tuple has several of them.
NUMBERS = ("length", "distance", "area", "angle", "percent", "number", "count")
_SUFFIXES = {2: ("Start", "End"), 3: ("X", "Y", "Z"), 4: ("First", "Second", "Third", "Fourth")}


@dataclass(frozen=True)
class Option:
    """One thing that the user may set, as forms, macros and the command line offer it.

    Attributes:
        name: keyword in Python, ``panel_thickness``; ``--panel-thickness`` on the command line.
        default: value, a tuple where there are several numbers; None where there is none.
        kind: ``length`` (mm, not negative), ``distance`` (mm), ``area`` (mm2), ``angle`` (degrees),
            ``percent``, ``number``, ``count`` (whole), ``choice``, ``flag``, ``text``, ``points``
            ((n, 3) mm) or ``placement`` (rotation (3, 3), origin (3,)).
        meaning: what it does, a sentence without its full stop.
        choices: words of a choice.
        suffixes: of the parts of a tuple, in property names.
        written: how its value is written where the kind does not say, as ``WxH``.
        absent: what a form shows in place of a length of zero, as ``none``.
    """

    name: str
    default: Any
    kind: str
    meaning: str
    choices: tuple[str, ...] = ()
    suffixes: tuple[str, ...] = ()
    written: str = ""
    absent: str = ""

    @property
    def parts(self) -> tuple[str, ...]:
        """Names of the properties that hold it."""
        stem = "".join(word.capitalize() for word in self.name.split("_"))
        if self.kind in NUMBERS and isinstance(self.default, tuple):
            ends = self.suffixes or _SUFFIXES[len(self.default)]
            return tuple(stem + end for end in ends)
        return (stem,)

    @property
    def label(self) -> str:
        """The name in plain words."""
        return self.name.replace("_", " ").capitalize()
