"""Declared options as arguments of the command line, and what the texts given for them say."""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from freecad_ortho.cli import values
from freecad_ortho.written import LOADS, number
from solver.io.points import read_points
from solver.mesh.quadmesh import FloatArray
from solver.option import NUMBERS, Option, unknown

# What stands for a value in the help, a letter for each where there are several.
_WRITTEN = {
    "length": "L", "distance": "L", "area": "A", "angle": "DEG", "pressure": "KN/M2",
    "percent": "PERCENT", "number": "N", "weight": "W", "direction": "x|y|z|X,Y,Z", "count": "N",
    "force": "F", "per_length": "F[/M]", "per_area": "F[/M2]", "text": "TEXT", "points": "FILE",
    "singular": "auto|none|FILE", "mesh": "FILE",
}  # fmt: skip
_LETTERS = {2: "A,B", 3: "X,Y,Z"}
_PLACING = {"rotate": "turn by angles about x, then y, then z", "centre": "where it is put"}
# Kinds of numbers that may have a unit behind them.
_WITH_UNITS = ("length", "distance", "area", "angle", *LOADS)


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
    flag, former = flag_of(option), option.former
    if former is not None:
        flags: dict[str, Any] = {"action": "store_true"} if option.kind == "flag" else {}
        word = f"--{_dashed(former.name)}"
        group.add_argument(word, help=argparse.SUPPRESS, default=None, **flags)
    if option.kind == "flag":
        action = "store_false" if option.default else "store_true"
        group.add_argument(flag, dest=option.name, action=action, default=None, help=words)
        return
    if option.kind == "placement":
        for part, what in _PLACING.items():
            group.add_argument(f"--{part}", metavar="X,Y,Z", help=what)
        return
    words += f", {option.range.words()}" if option.range.closed and not option.written else ""
    usual = option.absent or (_usual(option, length) if usual is None else usual)
    words += f" (default: {usual})" if usual else ""
    group.add_argument(flag, dest=option.name, metavar=_metavar(option, length), help=words)


def flag_of(option: Option) -> str:
    """The argument that sets it: of what is on by default the one that puts it off."""
    off = "no-" if option.kind == "flag" and option.default else ""
    return f"--{off}{_dashed(option.name)}"


def given(
    options: Iterable[Option],
    arguments: argparse.Namespace,
    unit: str = "mm",
    bare: str | None = None,
) -> dict[str, Any]:
    """Values of those options that were given, by name.

    Args:
        options: any that were added.
        arguments: as they were parsed.
        unit: of the values.
        bare: that of lengths that are given without one, by default the same.

    Raises:
        InputError: a text that says no such value.
    """
    found = {}
    for option in options:
        text, former = getattr(arguments, option.name, None), option.former
        if option.kind == "placement":
            text = _placing(arguments, unit, bare)
        elif text is not None and option.kind != "flag":
            text = read(option, text, unit, bare)
        elif former is not None and (then := getattr(arguments, former.name)) is not None:
            if option.kind != "flag":
                then = read(option, then, unit, bare, f"--{_dashed(former.name)}")
            text = former.now(then)
        if text is not None:
            found[option.name] = text
    return found


def read(
    option: Option,
    text: str,
    unit: str = "mm",
    bare: str | None = None,
    name: str | None = None,
) -> Any:
    """The value that a text stands for; of a mesh the text itself.

    Args:
        option: whose value it is.
        text: ``12``, ``0.3m``, ``1,2,3``, a word, a path.
        unit: of the value.
        bare: that of lengths that come without one, by default the same.
        name: what the option is called in a refusal.

    Raises:
        InputError: the text says no such value.
    """
    name = name or flag_of(option)
    text = ",".join(map(str, option.plain(text))) if option.plain(text) is not text else text
    if option.kind == "choice":
        return _word(name, text, option.choices, bool(option.examples))
    if option.kind == "points":
        return read_points(text, (2, 3))
    if option.kind == "singular":
        return _singular(text)
    if option.kind not in NUMBERS:
        return text
    several = option.several
    if _is_pair(option):
        if option.written and text.isdecimal():
            return (int(text), int(text))
        return values.sampling(text, name, option.written or "MxN")
    parts = text.split(",")
    plain = ",".join(_plain(part, option.kind, unit, bare or unit) for part in parts)
    found: tuple[float, ...]
    if option.kind == "count":
        found = values.whole_numbers(name, plain, len(option.default) if several else 1)
    else:
        found = values.numbers(name, plain, len(option.default) if several else 1)
    return found if several else found[0]


def _singular(text: str) -> tuple[tuple[float, ...], ...] | None:
    """Rows x, y, z and number of lines; None where they are to be found."""
    if text in ("auto", "none"):
        return None if text == "auto" else ()
    return tuple(map(tuple, read_points(text, (4,), least=0).tolist()))


def shown(value: Any) -> str:
    """A value as it would be typed; nothing where there is none."""
    if isinstance(value, tuple):
        return ",".join(map(shown, value))
    if value is None or value is False:
        return ""
    return f"{value:g}" if isinstance(value, float) else str(value)


def _usual(option: Option, length: str) -> str:
    """The default; lengths that are in no one's unit in metres."""
    zero = isinstance(option.default, tuple) and not any(option.default)
    if option.absent or zero or option.kind in ("points", "placement"):
        return option.absent
    metres = length == "L" and option.kind in ("length", "distance")
    if _is_pair(option):
        return "{}x{}".format(*option.default)
    words = shown(option.default_in(1000.0) if metres else option.default)
    return f"{words} m" if metres and words else words


def _dashed(name: str) -> str:
    return name.replace("_", "-")


def _placing(
    arguments: argparse.Namespace, unit: str, bare: str | None
) -> tuple[FloatArray, FloatArray] | None:
    """Where something stands, if that was said."""
    if all(getattr(arguments, part) is None for part in _PLACING):
        return None
    turn = Option("rotate", (0.0, 0.0, 0.0), "angle", _PLACING["rotate"])
    place = Option("centre", (0.0, 0.0, 0.0), "distance", _PLACING["centre"])
    said = given((turn, place), arguments, unit, bare)
    angles = said.get("rotate", turn.default)
    rotation = Rotation.from_euler("xyz", angles, degrees=True).as_matrix()
    return rotation, np.array(said.get("centre", place.default))


def _explained(option: Option) -> str:
    words = option.brief or option.meaning
    # A name in capitals stays one.
    return words if words[1:2].isupper() else words[:1].lower() + words[1:]


def _metavar(option: Option, length: str) -> str:
    if option.written or option.choices:
        return option.written or "|".join((*option.choices, *["..."] * bool(option.examples)))
    count = len(option.default) if isinstance(option.default, tuple) else 0
    if _is_pair(option):
        return "MxN"
    if option.kind == "direction":
        return _WRITTEN[option.kind]
    single = length if option.kind in ("length", "distance") else _WRITTEN[option.kind]
    return _LETTERS.get(count, single) if option.kind in NUMBERS else single


def _is_pair(option: Option) -> bool:
    """Whether it counts along u and along v."""
    return option.kind == "count" and option.several and len(option.default) == 2


def _word(name: str, text: str, choices: tuple[str, ...], own: bool) -> str:
    """One of several words, of which the beginning is enough where it is that of one alone.

    Any other word too where ``own`` ones are allowed.
    """
    meant = [word for word in choices if word.startswith(text)] if text else []
    if text in choices or len(meant) == 1:
        return text if text in choices else meant[0]
    if own:
        return text
    raise unknown(name, text, choices)


def _plain(text: str, kind: str, unit: str, bare: str) -> str:
    """A number with or without a unit in the unit asked for; any other text as it is."""
    found = number(text, kind, unit, bare) if kind in _WITH_UNITS else None
    return text if found is None else repr(found)
