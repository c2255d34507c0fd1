"""View provider of a structure: FreeCAD's own display of its solids, with colour and icon."""

from __future__ import annotations

from typing import Any

from freecad_ortho import preferences
from freecad_ortho.objects.properties import Stateless
from freecad_ortho.resources import icon


class StructureView(Stateless):
    """Proxy of a structure's view provider."""

    def __init__(self, view_object: Any) -> None:
        view_object.Proxy = self
        panels = view_object.Object.System == "Panels"
        view_object.ShapeColor = preferences.colour("PanelColour" if panels else "BeamColour")
        # What carries the panels stays visible through them, in per cent.
        view_object.Transparency = 40 if panels else 0
        view_object.LineColor = (0.27, 0.31, 0.36)
        view_object.LineWidth = 1.0
        view_object.PointSize = 1.0
        # Every part is flat-faced: a coarse tessellation shows it exactly.
        view_object.Deviation = 5.0

    def attach(self, view_object: Any) -> None:
        """Remember the object; the solids are shown by FreeCAD itself."""
        self.Object = view_object.Object

    def getIcon(self) -> str:
        """Icon in the tree: the same picture as on the command."""
        panels = self.Object.System == "Panels"
        return icon("panels" if panels else "beams")
