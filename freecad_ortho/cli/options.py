"""Declared options as arguments of the command line, and what the texts given for them say."""

from __future__ import annotations

import argparse
import math
import re
from collections.abc import Iterable
from typing import Any

from freecad_ortho.cli import values
from freecad_ortho.units import MILLIMETRES
from solver.errors import InputError
from solver.io.points import read_points
from solver.option import NUMBERS, Option

# What stands for a value in the help, a letter for each where there are several.
_WRITTEN = {
    "length": "L", "distance": "L", "area": "A", "angle": "DEG", "percent": "PERCENT",
    "number": "N", "count": "N", "text": "TEXT", "points": "FILE", "mesh": "FILE",
}  # fmt: skip
_LETTERS = {2: "A,B", 3: "X,Y,Z"}
# A number and the unit behind it.
_QUANTITY = re.compile(r"\s*([-+.\d]+(?:e[-+]?\d+)?)\s*([a-z°]+)(\^?2)?\s*", re.IGNORECASE)
_ANGLES = {"deg": 1.0, "°": 1.0, "rad": math.degrees(1.0)}


def add(
    group: argparse._ActionsContainer,
    option: Option,
    before: str = "",
    usual: str | None = None,
    length: str = "L",
) -> None:
    """Offer an option.

    Args:
        group: of arguments.
        option: what is offered; its value is None where nothing is said.
        before: words before those that explain it.
        usual: the default in words, where it is not the option's own.
        length: what stands for a length.
    """
    words = (before + _explained(option)).replace("%", "%%")
    if option.kind == "flag":
        action = "store_false" if option.default else "store_true"
        group.add_argument(
            flag_of(option), dest=option.name, action=action, default=None, help=words
        )
        return
    usual = option.absent or (shown(option.default) if usual is None else usual)
    words += f" (default: {usual})" if usual else ""
    group.add_argument(
        flag_of(option), dest=option.name, metavar=_metavar(option, length), help=words
    )


def flag_of(option: Option) -> str:
    """The argument that sets it: of what is on by default the one that puts it off."""
    off = "no-" if option.kind == "flag" and option.default else ""
    return f"--{off}{option.name.replace('_', '-')}"


def given(
    options: Iterable[Option], arguments: argparse.Namespace, unit: str = "mm"
) -> dict[str, Any]:
    """Values of those options that were given, by name.

    Args:
        options: any that were added.
        arguments: as they were parsed.
        unit: of lengths that are given without one, and of the values.

    Raises:
        InputError: a text that says no such value.
    """
    found = {option: getattr(arguments, option.name) for option in options}
    return {
        option.name: text if option.kind == "flag" else read(option, text, unit)
        for option, text in found.items()
        if text is not None
    }


def read(option: Option, text: str, unit: str = "mm", name: str | None = None) -> Any:
    """The value that a text stands for; of a mesh the text itself.

    Args:
        option: whose value it is.
        text: ``12``, ``0.3m``, ``1,2,3``, a word, a path.
        unit: of lengths that come without one, and of the value.
        name: what the option is called in a refusal.

    Raises:
        InputError: the text says no such value.
    """
    name = name or flag_of(option)
    if option.kind == "choice":
        return _word(name, text, option.choices)
    if option.kind == "points":
        return read_points(text, (2, 3))
    if option.kind not in NUMBERS:
        return text
    several = isinstance(option.default, tuple)
    if option.kind == "count" and several and len(option.default) == 2:
        return values.sampling(text, name)
    parts = text.split(",")
    plain = ",".join(_plain(part, option.kind, unit) for part in parts)
    if option.kind == "count":
        found = values.whole_numbers(name, plain, len(option.default) if several else 1)
    else:
        found = values.numbers(name, plain, len(option.default) if several else 1)
    return found if several else found[0]


def shown(default: Any) -> str:
    """A default as it would be typed; nothing where there is none."""
    if default is None or default is False or default == ():
        return ""
    if isinstance(default, tuple):
        return ",".join(shown(part) for part in default)
    return f"{default:g}" if isinstance(default, float) else str(default)


def _explained(option: Option) -> str:
    words = option.brief or option.meaning
    # A name in capitals stays one.
    return words if words[1:2].isupper() else words[:1].lower() + words[1:]


def _metavar(option: Option, length: str) -> str:
    if option.written or option.choices:
        return option.written or "|".join(option.choices)
    count = len(option.default) if isinstance(option.default, tuple) else 0
    if option.kind == "count" and count == 2:
        return "MxN"
    single = length if option.kind in ("length", "distance") else _WRITTEN[option.kind]
    return _LETTERS.get(count, single) if option.kind in NUMBERS else single


def _word(name: str, text: str, choices: tuple[str, ...]) -> str:
    """One of several words, of which the beginning is enough where it is that of one alone."""
    meant = [word for word in choices if word.startswith(text)] if text else []
    if text in choices or len(meant) == 1:
        return text if text in choices else meant[0]
    *others, last = choices
    raise InputError(f"{name}: expected {', '.join(others)} or {last}, got '{text[:40]}'")


def _plain(text: str, kind: str, unit: str) -> str:
    """A number with a unit as one without; any other text as it is."""
    match = _QUANTITY.fullmatch(text)
    if match is None:
        return text
    number, word, square = match[1], match[2].lower(), match[3]
    factor = None
    if kind == "angle" and not square:
        factor = _ANGLES.get(word)
    elif kind in ("length", "distance", "area") and (kind == "area") == bool(square):
        power = 2 if square else 1
        factor = (MILLIMETRES.get(word, 0.0) / MILLIMETRES[unit]) ** power or None
    try:
        return text if factor is None else repr(float(number) * factor)
    except ValueError:
        return text
