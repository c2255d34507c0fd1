"""Settings that forms, properties, macros and the command line offer from one declaration each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

Kind = Literal[
    "length", "distance", "area", "angle", "percent", "number", "count",
    "choice", "flag", "text", "points", "placement", "mesh",
]  # fmt: skip
# Kinds of one number; an option that is a tuple has several of them.
NUMBERS = ("length", "distance", "area", "angle", "percent", "number", "count")
_SUFFIXES = {2: ("Start", "End"), 3: ("X", "Y", "Z"), 4: ("First", "Second", "Third", "Fourth")}


@dataclass(frozen=True)
class Option:
    """One thing that the user may set: of a net, a source of nets, a system or the workshop.

    Attributes:
        name: keyword in Python, ``panel_thickness``; ``--panel-thickness`` on the command line.
        default: value, a tuple where there are several numbers; None where there is none, and of a
            length that is found where none is given.
        kind: ``length`` (not negative), ``distance``, ``area``, ``angle`` (degrees), ``percent``,
            ``number``, ``count`` (whole), ``choice``, ``flag``, ``text``, ``points`` ((n, 3)),
            ``placement`` (rotation (3, 3), origin (3,)) or ``mesh`` (one with the same faces).
            Lengths are in mm, those of nets in the unit of the mesh.
        meaning: what it does, a sentence without its full stop.
        choices: words of a choice.
        suffixes: of the parts of a tuple, in property names.
        written: how its value is written where the kind does not say, as ``WxH``.
        absent: what a form shows in place of a length of zero, as ``none``.
        title: what stands before its field in a form; by default its name.
        brief: its meaning in the words of the command line, where these are others.
        shown: words of a form for each choice, for a box to tick (``yes``) or for none (``none``).
        stored: name of the property that holds it, where that does not follow from the name.
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
        found = self.kind == "length" and self.default is None
        return f"{self.meaning}; 0 is {self.absent}" if found else self.meaning

    @property
    def words(self) -> dict[str, str]:
        """What a form shows for each choice."""
        return {word: self.shown.get(word, word) for word in self.choices}
