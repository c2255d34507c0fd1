"""Typed properties of a structure for the options of its system."""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad_ortho.fabrication import SYSTEMS, Option, System
from freecad_ortho.objects.properties import Property

# A structure of panels has a thickness of its own; the option is for panels beside beams.
_ELSEWHERE = ("panel_thickness",)
_KINDS = {float: "App::PropertyFloat", int: "App::PropertyInteger", bool: "App::PropertyBool"}


def options_of(system: str) -> tuple[Option, ...]:
    """Options of a system that are properties of its structures."""
    return tuple(option for option in SYSTEMS[system].options if option.name not in _ELSEWHERE)


def property_name(option: Option) -> str:
    """Name of an option's property: ``panel_thickness`` becomes ``PanelThickness``."""
    return "".join(word.capitalize() for word in option.name.split("_"))


def label(option: Option) -> str:
    """Name of an option for people, in English."""
    return option.name.replace("_", " ").capitalize()


def choices(option: Option) -> tuple[str, ...]:
    """Words that an option can take, empty for anything else than a choice of words."""
    words = tuple(option.metavar.split("|"))
    return words if option.kind is str and len(words) > 1 else ()


def is_length(option: Option) -> bool:
    """Tell whether an option is a length in mm."""
    return option.kind is float and option.metavar == "MM"


def system_property(option: Option) -> Property:
    """The property of an option; one that may be left out is 0 or empty then."""
    words = tuple(word.capitalize() for word in choices(option))
    if words:
        kind = "App::PropertyEnumeration"
    elif is_length(option):
        kind = "App::PropertyLength"
    else:
        kind = _KINDS.get(option.kind, "App::PropertyString")
    default = option.default.capitalize() if words and option.default else option.default
    tooltip = f"{label(option)}: {option.help}"
    return Property(kind, property_name(option), "Structure", tooltip, default, words)


def values(feature: FreeCAD.DocumentObject, system: str) -> dict[str, Any]:
    """Values of a system's options from the properties of a structure."""
    return {option.name: _value(feature, option) for option in options_of(system)}


def system_of(feature: FreeCAD.DocumentObject, system: str) -> System:
    """The system with the settings that a structure has.

    Raises:
        InputError: a value that cannot be used.
    """
    elsewhere = {name: None for name in _ELSEWHERE}
    known = {option.name for option in SYSTEMS[system].options}
    extra = {name: value for name, value in elsewhere.items() if name in known}
    return SYSTEMS[system].of(values(feature, system) | extra)


def _value(feature: FreeCAD.DocumentObject, option: Option) -> Any:
    value = getattr(feature, property_name(option))
    if is_length(option):
        value = value.Value
    if choices(option):
        return value.lower()
    return None if option.default is None and not value else value
