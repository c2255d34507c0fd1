"""View provider of a structure: FreeCAD's own display of its solids, with colour and icon."""

from __future__ import annotations

from typing import Any

from freecad_ortho import preferences
from freecad_ortho.objects.properties import Stateless
from freecad_ortho.resources import icon

# Colour and transparency in per cent; what carries the panels stays visible through them.
_WOOD, _IRON = (0.76, 0.64, 0.47), (0.36, 0.39, 0.43)
_TRANSPARENT = 40


class StructureView(Stateless):
    """Proxy of a structure's view provider."""

    def __init__(self, view_object: Any) -> None:
        view_object.Proxy = self
        colour, transparency = _look(view_object.Object.System)
        view_object.ShapeColor = colour
        view_object.Transparency = transparency
        view_object.LineColor = (0.27, 0.31, 0.36)
        view_object.LineWidth = 1.0
        view_object.PointSize = 1.0
        # Most parts are flat-faced: a coarse tessellation shows them exactly.
        view_object.Deviation = 5.0

    def attach(self, view_object: Any) -> None:
        """Remember the object; the solids are shown by FreeCAD itself."""
        self.Object = view_object.Object

    def getIcon(self) -> str:
        """Icon in the tree: the same picture as on the command."""
        return icon(self.Object.System.lower())


def _look(system: str) -> tuple[tuple[float, float, float], int]:
    if system == "Panels":
        return preferences.colour("PanelColour"), _TRANSPARENT
    return {"Lamellas": _WOOD, "Nodes": _IRON}.get(system, preferences.colour("BeamColour")), 0
