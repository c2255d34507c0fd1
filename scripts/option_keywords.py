"""Write freecad_ortho/option_keywords.py: what the tables of options say, as editors read it.

Usage: python scripts/option_keywords.py

Whoever adds or changes an option runs it; a test says where that was forgotten.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from freecad_ortho.fabrication import SYSTEMS, Workshop
from freecad_ortho.fabrication.site import FAMILY
from freecad_ortho.sources import GROUPS, SOURCES
from freecad_ortho.structural.design import Design
from solver.nets.options import OPTIONS
from solver.nets.settings import WEIGHTS
from solver.nets.supports import SUPPORTS
from solver.option import Option

ROOT = Path(__file__).resolve().parents[1]
WRITTEN = ROOT / "freecad_ortho" / "option_keywords.py"

_HEAD = '''"""Options by name and with their types, as editors, checkers and ``help`` show them.

Written by ``scripts/option_keywords.py`` from the tables of options, which say what each of them
does. Lengths are numbers of mm; functions on documents take quantities and texts such as
``"0.2 m"`` too, and ``"30 deg"`` of angles.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, TypedDict

Length = float | str
Angle = float | str
Area = float | str
Pressure = float | str
# A force, or one by mm or mm2; a text such as "1.5 kN/m2" too.
Load = float | str
# An object of a FreeCAD document, and where something stands: they have no type outside FreeCAD.
Feature = Any
Placement = Any
'''
_TYPES = {
    "length": "Length",
    "distance": "Length",
    "area": "Area",
    "angle": "Angle",
    "pressure": "Pressure",
    "force": "Load",
    "per_length": "Load",
    "per_area": "Load",
    "percent": "float",
    "number": "float",
    "weight": "float",
    "direction": "str | Sequence[float]",
    "count": "int",
    "flag": "bool",
    "text": "str",
    "points": "Sequence[Any]",
    "polylines": "Sequence[Any]",
    "singular": "str | Sequence[Any]",
    "placement": "Placement",
    "mesh": "Feature",
}
# What may be given besides.
_MORE = {
    "sheet": "tuple[float, float]",
    **dict.fromkeys(("supports", "lift", "foot_at"), "Sequence[int]"),
}
# Sources whose functions have names of some options among their own arguments.
_SOURCES = {
    "PrimitiveOptions": (GROUPS["primitive"], (), "exact surfaces"),
    "MultiNetOptions": (GROUPS["multi-net"], ("points",), "multi-nets of a polyline on a quadric"),
    "EllipticNetOptions": (
        GROUPS["elliptic multi-net"],
        ("moving",),
        "multi-nets in elliptic coordinates",
    ),
    "FaceOptions": (GROUPS["faces"], (), "nets sampled from CAD faces"),
    "CurvatureOptions": (GROUPS["along curvature"], (), "nets along lines of curvature"),
    "FormOptions": (GROUPS["form-finding"], (), "membranes and cable nets"),
    "ChangeOptions": (
        tuple(
            name
            for group in ("derived", "refine", "transform", "offset", "weld")
            for name in GROUPS[group]
        ),
        (),
        "changes of a net; each has some of these",
    ),
    "SourceOptions": (tuple(SOURCES), (), "all sources of nets; each has some of these"),
}


def text() -> str:
    """The module."""
    systems = [option for system in SYSTEMS.values() for option in system.options]
    parts = [
        _class("Sizes", "Options of systems; each of them has some of these.", systems),
        _class("WorkshopSettings", "What parts are cut from, and how drawings are written.",
               Workshop.options),
        _class("DesignOptions", "Members and loads of a structural check; kN and m, lengths in mm.",
               Design.options),
        _class("NetChoices", "What a net is asked for, by guides and of its parts.",
               (SUPPORTS, *OPTIONS.values(), *WEIGHTS.values())),
    ]  # fmt: skip
    for name, (sources, own, words) in _SOURCES.items():
        options = [option for each in sources for option in SOURCES[each].options]
        others = [option for option in options if option.name not in own]
        parts.append(_class(name, f"Options of {words}.", others))
    words = [*systems, *Workshop.options, SOURCES["elliptic multi-net"].option("moving"), FAMILY]
    return "\n\n\n".join([_HEAD.rstrip("\n") + _words(words), *parts]) + "\n"


def alias(name: str) -> str:
    """What the type of an option of few words is called, for functions that spell it out."""
    return "".join(part.capitalize() for part in name.split("_")) + "Word"


def _words(options: Iterable[Option]) -> str:
    """A type for each option that is one of a few words."""
    found: dict[str, list[Option]] = {}
    for option in options:
        if option.kind == "choice" and not option.examples:
            found.setdefault(option.name, []).append(option)
    head = "\n# Options that are one of a few words.\n"
    lines = (
        _wrapped(f"{alias(name)} = {_type([replace(one, default='') for one in each])}", "")
        for name, each in found.items()
    )
    return head + "\n".join(lines)


def _class(name: str, words: str, options: Iterable[Option]) -> str:
    """One dictionary of keywords, in the order in which they first come."""
    found: dict[str, list[Option]] = {}
    for option in options:
        found.setdefault(option.name, []).append(option)
    lines = (_wrapped(f"    {option}: {_type(each)}") for option, each in found.items())
    return "\n".join([f"class {name}(TypedDict, total=False):", f'    """{words}"""', "", *lines])


def _wrapped(line: str, indent: str = "    ") -> str:
    """A long line as the formatter would break it."""
    if len(line) <= 100:
        return line
    head, _, words = line.partition("[")
    words = words.removesuffix("]")
    if len(words) > 96 - len(indent):
        words = f",\n{indent}    ".join(words.split(", ")) + ","
    return f"{head}[\n{indent}    {words}\n{indent}]"


def _type(options: list[Option]) -> str:
    """The type of options that have one name."""
    words = [word for option in options for word in option.choices]
    if words and not any(option.examples for option in options):
        kinds = [f"Literal[{', '.join(repr(word) for word in dict.fromkeys(words))}]"]
    else:
        kinds = list(dict.fromkeys(kind for option in options for kind in _kinds(option)))
    if any(option.default is None for option in options):
        kinds.append("None")
    return " | ".join(kinds).replace("'", '"')


def _kinds(option: Option) -> Iterator[str]:
    single = _TYPES.get(option.kind, "str")
    if not option.several or option.kind == "direction":
        yield single
    elif option.kind == "count":
        yield f"tuple[{', '.join([single] * len(option.default))}]"
    else:
        yield f"Sequence[{single}]"
    if option.name in _MORE and option.kind == "text":
        yield _MORE[option.name]


if __name__ == "__main__":
    WRITTEN.write_text(text(), encoding="utf-8")
    sys.stdout.write(f"{WRITTEN.relative_to(ROOT)}\n")
