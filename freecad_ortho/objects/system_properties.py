"""Typed properties of a structure for the options of its system."""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad_ortho.fabrication import SYSTEMS, System
from freecad_ortho.objects.properties import Property
from solver.option import Option

# A structure of panels has a thickness of its own; the option is for panels beside beams. Sheets
# are said where files are written.
_ELSEWHERE = ("panel_thickness", "sheet", "spacing", "grain", "kerf")
_KINDS = {
    "length": "App::PropertyLength",
    "angle": "App::PropertyFloat",
    "percent": "App::PropertyFloat",
    "count": "App::PropertyInteger",
    "choice": "App::PropertyEnumeration",
    "flag": "App::PropertyBool",
}


def options_of(system: str) -> tuple[Option, ...]:
    """Options of a system that are properties of its structures."""
    return tuple(option for option in SYSTEMS[system].options if option.name not in _ELSEWHERE)


def system_property(option: Option) -> Property:
    """The property of an option; one that may be left out is 0 or empty then."""
    words = tuple(word.capitalize() for word in option.choices)
    default = option.default.capitalize() if words and option.default else option.default
    tooltip = f"{option.label}: {option.meaning}"
    return Property(_KINDS[option.kind], *option.parts, "Structure", tooltip, default, words)


def values(feature: FreeCAD.DocumentObject, system: str) -> dict[str, Any]:
    """Values of a system's options from the properties of a structure."""
    return {option.name: _value(feature, option) for option in options_of(system)}


def property_values(option: Option, value: Any) -> dict[str, Any]:
    """Values of the properties of an option; None is written as what stands for it, 0 or empty."""
    if value is None:
        value = "" if option.kind in ("choice", "text") else 0
    (part,) = option.parts
    return {part: value.capitalize() if option.choices else value}


def system_of(feature: FreeCAD.DocumentObject, system: str) -> System:
    """The system with the settings that a structure has.

    Raises:
        InputError: a value that cannot be used.
    """
    options = SYSTEMS[system].options
    extra = {option.name: option.default for option in options if option.name in _ELSEWHERE}
    return SYSTEMS[system].of(values(feature, system) | extra)


def _value(feature: FreeCAD.DocumentObject, option: Option) -> Any:
    value = getattr(feature, *option.parts)
    if option.kind == "length":
        value = value.Value
    if option.kind == "choice":
        return value.lower()
    return None if option.default is None and not value else value
