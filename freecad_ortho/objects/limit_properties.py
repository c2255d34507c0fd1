"""Limits of a structure's parts as properties; 0 is no limit."""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING

import FreeCAD

from freecad_ortho.fabrication import Limits
from freecad_ortho.objects.properties import Property

if TYPE_CHECKING:
    from collections.abc import Iterator

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_TOOLTIPS = {
    "gap_mm": QT_TRANSLATE_NOOP(
        "App::Property", "Largest distance from plane or developable that passes; 0: any"
    ),
    "twist_deg": QT_TRANSLATE_NOOP("App::Property", "Largest twist of a beam that passes; 0: any"),
    "straightness_mm": QT_TRANSLATE_NOOP(
        "App::Property", "Largest distance of an unrolled axis from straight that passes; 0: any"
    ),
    "radius_spread_mm": QT_TRANSLATE_NOOP(
        "App::Property", "Largest distance of an unrolled axis from its arc that passes; 0: any"
    ),
    "lean_deg": QT_TRANSLATE_NOOP(
        "App::Property", "Largest angle from the surface normal that passes; 0: any"
    ),
}


def limit_properties() -> Iterator[Property]:
    """One property a limit, named ``LimitGap``, ``LimitTwist`` ..."""
    for field in fields(Limits):
        kind = "App::PropertyAngle" if field.name.endswith("_deg") else "App::PropertyLength"
        first = field.default or 0.0
        yield Property(kind, _property(field.name), "Limits", _TOOLTIPS[field.name], default=first)


def limits_of(feature: FreeCAD.DocumentObject) -> Limits:
    """Read the limits of a structure.

    Raises:
        InputError: a limit below 0.
    """
    values = {field.name: getattr(feature, _property(field.name)) for field in fields(Limits)}
    return Limits(**{name: value.Value or None for name, value in values.items()})


def _property(field: str) -> str:
    words = field.rpartition("_")[0].split("_")
    return "Limit" + "".join(word.capitalize() for word in words)
