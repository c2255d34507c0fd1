"""Declared options as properties of document objects, and their values there and back."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.objects.properties import Property
from solver.errors import InputError
from solver.option import Option

_KINDS = {
    "length": "App::PropertyLength",
    "distance": "App::PropertyDistance",
    # FreeCAD's area cannot be negative, t can.
    "area": "App::PropertyFloat",
    "angle": "App::PropertyAngle",
    # FreeCAD's own unit of it is kPa, which is kN/m2.
    "pressure": "App::PropertyPressure",
    # Of any unit of force, by mm and mm2.
    "force": "App::PropertyFloat",
    "per_length": "App::PropertyFloat",
    "per_area": "App::PropertyFloat",
    "number": "App::PropertyFloat",
    "weight": "App::PropertyFloat",
    "direction": "App::PropertyFloat",
    "percent": "App::PropertyFloat",
    "count": "App::PropertyInteger",
    "choice": "App::PropertyEnumeration",
    "flag": "App::PropertyBool",
    "text": "App::PropertyString",
    "points": "App::PropertyVectorList",
    "polylines": "App::PropertyStringList",
    "singular": "App::PropertyStringList",
    "placement": "App::PropertyPlacement",
    "mesh": "App::PropertyLinkHidden",
}
# What stands in a property where there is no value.
_ABSENT: dict[str, Any] = {
    "length": 0.0,
    "weight": -1.0,
    "text": "",
    "choice": "",
    "mesh": None,
    "singular": [],
}


def properties(
    option: Option, group: str, tooltip: str = "", flags: int = 0, titled: bool = False
) -> list[Property]:
    """The properties that hold an option.

    Args:
        option: any.
        group: heading in the property editor.
        tooltip: by default the sentence on the option.
        flags: of the properties.
        titled: words of a choice begin with a capital letter.
    """
    words = tuple(with_capital(word) if titled else word for word in _offered(option))
    defaults = stored(option, option.default, titled)
    return [
        Property(
            _KINDS[option.kind], part, group, tooltip or option.sentence, default, words, flags
        )
        for part, default in defaults.items()
    ]


def read(feature: FreeCAD.DocumentObject, option: Option) -> Any:
    """The value of an option, plain, in mm and degrees; None where there is none."""
    values = tuple(_plain(option, getattr(feature, part)) for part in option.parts)
    return values if option.several else values[0]


def stored(option: Option, value: Any, titled: bool = False) -> dict[str, Any]:
    """What properties hold for a plain value, by their names."""
    if value is None:
        value = _ABSENT.get(option.kind, 0)
    elif option.kind == "points":
        value = convert.vectors(convert.rows(value))
    elif option.kind == "polylines":
        value = [", ".join(map(_written, convert.rows(line).tolist())) for line in value]
    elif option.kind == "singular":
        value = list(map(_written, value)) or ["none"]
    elif option.kind == "placement":
        value = convert.placement(value)
    elif option.kind == "choice" and titled and value in _offered(option):
        value = with_capital(value)
    values = value if option.several else (value,)
    return dict(zip(option.parts, values, strict=True))


def write(feature: FreeCAD.DocumentObject, option: Option, value: Any) -> None:
    """Set the properties of an option."""
    for part, item in stored(option, value).items():
        setattr(feature, part, item)


def _plain(option: Option, value: Any) -> Any:
    if option.kind == "mesh":
        return value
    # What has no unit now may have had one when the document was made, and the other way round.
    value = getattr(value, "Value", value)
    if option.kind == "points":
        return convert.array(value)
    if option.kind == "polylines":
        return tuple(_read_line(option.name, line) for line in value)
    if option.kind == "singular":
        return convert.singular_rows(list(value) or "auto")
    if option.kind == "placement":
        return convert.placing(value)
    if option.kind == "choice":
        value = next(
            (word for word in _offered(option) if with_capital(word) == with_capital(value)), value
        )
    absent = value < 0 if option.kind == "weight" else not value
    return None if option.default is None and absent else value


def _written(row: Iterable[float]) -> str:
    return " ".join(f"{x!r}" for x in row)


def _read_line(name: str, text: str) -> tuple[tuple[float, ...], ...]:
    """Points of a line from ``x y z, x y z, ...``."""
    try:
        points = [tuple(map(float, point.split())) for point in text.split(",")]
    except ValueError:
        raise InputError(f"{name}: expected 'x y z, x y z, ...', got '{text[:40]}'") from None
    return tuple(map(tuple, convert.rows(points).tolist()))


def _offered(option: Option) -> tuple[str, ...]:
    return (*option.choices, *option.examples)


def with_capital(word: str) -> str:
    """A word with a capital first letter, as properties show it."""
    return word[:1].upper() + word[1:]
