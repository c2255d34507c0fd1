"""Colours in IFC: a surface style for each material, on the shapes that parts share."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from freecad_ortho.fabrication.colours import Colour

Make = Callable[..., Any]


class Styles:
    """Surface styles by their names, each made once."""

    def __init__(self, make: Make) -> None:
        self.make = make
        self._made: dict[str, Any] = {}

    def paint(self, items: Iterable[Any], name: str, colour: Colour) -> None:
        """Give solids a colour.

        Args:
            items: geometric items of a shape.
            name: of the style, which is that of the material.
            colour: red, green, blue and opacity, 0 to 255.
        """
        if name not in self._made:
            red, green, blue, opacity = (value / 255 for value in colour)
            tint = self.make("IfcColourRgb", None, red, green, blue)
            shading = self.make(
                *("IfcSurfaceStyleRendering", tint, round(1 - opacity, 3)),
                *(None, None, None, None, None, None, "NOTDEFINED"),
            )
            self._made[name] = self.make("IfcSurfaceStyle", name, "BOTH", [shading])
        for item in items:
            self.make("IfcStyledItem", item, [self._made[name]], None)
