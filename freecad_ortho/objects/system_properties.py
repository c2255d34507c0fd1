"""Typed properties of a structure for the options of its system."""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad_ortho import fabrication
from freecad_ortho.fabrication import SYSTEMS, System, material
from freecad_ortho.objects.option_properties import properties, read
from freecad_ortho.objects.properties import Property
from solver.option import Option

# A structure of panels has a thickness of its own; the option is for panels beside beams.
PANEL_THICKNESS = "panel_thickness"
_ELSEWHERE = (PANEL_THICKNESS,)


def options_of(system: str) -> tuple[Option, ...]:
    """Options of a system that are properties of its structures."""
    return tuple(option for option in SYSTEMS[system].options if option.name not in _ELSEWHERE)


def properties_of(system: str) -> list[Property]:
    """The properties that a structure needs for the options of its system."""
    return [
        item
        for option in options_of(system)
        for item in properties(
            option, "Structure", f"{option.label}: {option.sentence}", titled=True
        )
    ]


def own_words(system: str) -> dict[str, Property]:
    """Properties by name that may hold words which are not among their choices."""
    own = {option.parts[0] for option in options_of(system) if option.examples}
    return {item.name: item for item in properties_of(system) if item.name in own}


def values(feature: FreeCAD.DocumentObject, system: str) -> dict[str, Any]:
    """Values of a system's options from the properties of a structure."""
    return {option.name: read(feature, option) for option in options_of(system)}


def system_of(feature: FreeCAD.DocumentObject, system: str) -> System:
    """The system with the settings that a structure has.

    Raises:
        InputError: a value that cannot be used.
    """
    options = SYSTEMS[system].options
    extra = {option.name: option.default for option in options if option.name in _ELSEWHERE}
    of = material(feature.Material, feature.Density or None)
    return fabrication.system_of(system, values(feature, system) | extra, of)
