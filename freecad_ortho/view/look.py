"""How a net looks, as one set of properties that is read, worked out and set together."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD

from freecad_ortho.objects.net import colour_field
from freecad_ortho.view.net_properties import OVERLAY_NAMES
from solver.analysis.fields import residuals

_RANGE = ("AutomaticRange", "LowestValue", "HighestValue", "LowestDecade", "HighestDecade")


def current(net: FreeCAD.DocumentObject) -> dict[str, Any]:
    """Everything that :func:`wanted` may change, as it is."""
    names = ("Legend", *_RANGE, *OVERLAY_NAMES)
    return {"ColourMap": net.ColourMap} | {name: getattr(net.ViewObject, name) for name in names}


def wanted(
    net: FreeCAD.DocumentObject,
    colour_map: str,
    value_range: tuple[float, float] | None,
    overlays: Sequence[str] | None,
    legend: bool,
) -> dict[str, Any]:
    """The properties that :func:`freecad_ortho.api.show_net` stands for."""
    look: dict[str, Any] = {"ColourMap": colour_map, "Legend": legend}
    if overlays is not None:
        look |= {name: name in overlays for name in OVERLAY_NAMES}
    if value_range is None:
        return look | {"AutomaticRange": True}
    low, high = value_range
    if colour_field(net, colour_map) in residuals():
        return look | {"LowestDecade": round(low), "HighestDecade": round(high)}
    return look | {"AutomaticRange": False, "LowestValue": low, "HighestValue": high}


def show(net: FreeCAD.DocumentObject, look: dict[str, Any]) -> None:
    """Set the properties that differ."""
    for name, value in look.items():
        owner = net if name == "ColourMap" else net.ViewObject
        if getattr(owner, name) != value:
            setattr(owner, name, value)
