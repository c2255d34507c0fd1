"""View provider of a structure: FreeCAD's own display of its solids, with colour and icon."""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad_ortho import answers, preferences
from freecad_ortho.objects.properties import Property, Stateless, ensure
from freecad_ortho.resources import icon
from freecad_ortho.view import context_menu, refresh

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

PLAIN, VERDICT = "Plain", "Verdict"
_PASSED, _FAILED = (0.33, 0.62, 0.40), (0.80, 0.16, 0.14)
_OK = "ok"

# Colour and transparency in per cent; what carries the panels stays visible through them.
_WOOD, _IRON = (0.76, 0.64, 0.47), (0.36, 0.39, 0.43)
_TRANSPARENT = 40


_PROPERTIES = (
    Property(
        "App::PropertyEnumeration",
        "ColourBy",
        "Structure",
        QT_TRANSLATE_NOOP(
            "App::Property", "One colour for all parts, or green and red by their verdicts"
        ),
        choices=(PLAIN, VERDICT),
    ),
)


class StructureView(Stateless):
    """Proxy of a structure's view provider."""

    def __init__(self, view_object: Any) -> None:
        ensure(view_object, _PROPERTIES)
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
        refresh.connect()
        ensure(view_object, _PROPERTIES)
        self.Object = view_object.Object
        self.ViewObject = view_object

    def updateData(self, feature: Any, name: str) -> None:
        """Follow the verdicts; they change last when the parts do."""
        if name == "Verdicts" and hasattr(self, "ViewObject"):
            self._colour()

    def onChanged(self, view_object: Any, name: str) -> None:
        """Follow a property of the view provider."""
        if name == "ColourBy" and hasattr(self, "ViewObject"):
            self._colour()

    def getIcon(self) -> str:
        """Icon in the tree: the same picture as on the command."""
        return icon(self.Object.System.lower())

    def doubleClicked(self, view_object: Any) -> bool:
        """Open the settings of the structure."""
        answers.ask("edit structure", view_object.Object)
        return True

    def setupContextMenu(self, view_object: Any, menu: Any) -> None:
        """Offer the settings in the tree."""
        words = FreeCAD.Qt.translate("Ortho", "Edit settings")
        context_menu.offer(menu, words, lambda: self.doubleClicked(view_object))

    def _colour(self) -> None:
        """Give every face the colour of its part's verdict, or all the same again."""
        view, feature = self.ViewObject, self.Object
        plain = tuple(view.ShapeColor[:3])
        if view.ColourBy == PLAIN or len(feature.Shape.Solids) != len(feature.Verdicts):
            if len(view.DiffuseColor) > 1:
                view.DiffuseColor = [plain]
            return
        colours = []
        for solid, verdict in zip(feature.Shape.Solids, feature.Verdicts, strict=True):
            colours += [_PASSED if verdict == _OK else _FAILED] * len(solid.Faces)
        view.DiffuseColor = colours


def _look(system: str) -> tuple[tuple[float, float, float], int]:
    transparency = _TRANSPARENT if system == "Panels" else 0
    own = {"Lamellas": _WOOD, "Nodes": _IRON, "Beams": preferences.colour("BeamColour")}
    return own.get(system, preferences.colour("PanelColour")), transparency
