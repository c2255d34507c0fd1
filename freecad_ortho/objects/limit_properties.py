"""Limits of a structure's parts as properties; 0 is no limit."""

from __future__ import annotations

import FreeCAD

from freecad_ortho.fabrication import Limits
from freecad_ortho.objects.option_properties import properties, read
from freecad_ortho.objects.properties import Property


def limit_properties() -> list[Property]:
    """One property a limit, named ``LimitGap``, ``LimitTwist`` ..."""
    return [item for option in Limits.options for item in properties(option, "Limits")]


def limits_of(feature: FreeCAD.DocumentObject) -> Limits:
    """Read the limits of a structure.

    Raises:
        InputError: a limit below 0.
    """
    return Limits.of({option.name: read(feature, option) for option in Limits.options})
