"""View provider of flat patterns: FreeCAD's display of the lines, with the parts' names."""

from __future__ import annotations

from typing import Any

import FreeCAD
from pivy import coin

from freecad_ortho import answers
from freecad_ortho.objects.drawings import flat_shape
from freecad_ortho.objects.properties import Property, Stateless, ensure
from freecad_ortho.resources import icon
from freecad_ortho.view import context_menu, refresh

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_PROPERTIES = (
    Property(
        "App::PropertyBool",
        "ShowNames",
        "Flat patterns",
        QT_TRANSLATE_NOOP("App::Property", "Show the names of the parts"),
        default=True,
    ),
)


class FlatPatternsView(Stateless):
    """Proxy of flat patterns' view provider."""

    def __init__(self, view_object: Any) -> None:
        ensure(view_object, _PROPERTIES)
        view_object.Proxy = self
        view_object.LineColor = (0.13, 0.19, 0.24)
        view_object.LineWidth = 1.0
        view_object.PointSize = 1.0

    def attach(self, view_object: Any) -> None:
        """Add the names to what FreeCAD draws."""
        refresh.connect()
        ensure(view_object, _PROPERTIES)
        self.ViewObject, self.Object = view_object, view_object.Object
        self._names = coin.SoSwitch()
        view_object.RootNode.addChild(self._names)
        self._write_names()

    def getIcon(self) -> str:
        """Icon in the tree: the same picture as on the command."""
        return icon("flat_patterns")

    def doubleClicked(self, view_object: Any) -> bool:
        """Open the settings of the flat patterns."""
        answers.ask("edit flat patterns", view_object.Object)
        return True

    def setupContextMenu(self, view_object: Any, menu: Any) -> None:
        """Offer the settings in the tree."""
        words = FreeCAD.Qt.translate("Ortho", "Edit settings")
        context_menu.offer(menu, words, lambda: self.doubleClicked(view_object))

    def updateData(self, feature: Any, name: str) -> None:
        """Follow the names; their places change last."""
        if name == "LabelPlaces" and hasattr(self, "_names"):
            self._write_names()

    def onChanged(self, view_object: Any, name: str) -> None:
        """Follow a property of the view provider."""
        if name in ("ShowNames", "Visibility") and hasattr(self, "_names"):
            self._show_names()

    def _show_names(self) -> None:
        view = self.ViewObject
        shown = view.ShowNames and view.Visibility
        self._names.whichChild = coin.SO_SWITCH_ALL if shown else coin.SO_SWITCH_NONE

    def _write_names(self) -> None:
        self._names.removeAllChildren()
        feature = self.Object
        if len(feature.PartNames) == len(feature.LabelPlaces):
            colour = coin.SoBaseColor()
            colour.rgb = (0.75, 0.22, 0.10)
            plain = coin.SoLightModel()
            plain.model = coin.SoLightModel.BASE_COLOR
            for child in (colour, plain):
                self._names.addChild(child)
            # The parts come first in the shape, then the sheets.
            parts = flat_shape(feature).SubShapes[: len(feature.PartNames)]
            for name, place, part in zip(
                feature.PartNames, feature.LabelPlaces, parts, strict=False
            ):
                self._names.addChild(_text(name, place, part.BoundBox))
        self._show_names()


def _text(words: str, place: FreeCAD.Vector, box: FreeCAD.BoundBox) -> coin.SoSeparator:
    """A name as large as its part has room for: names of a fixed size would cover each other."""
    made = coin.SoSeparator()
    font = coin.SoFont()
    font.name = "Sans"
    font.size = max(min(0.4 * box.YLength, 1.2 * box.XLength / len(words)), 1e-3)
    shift = coin.SoTranslation()
    shift.translation = (place.x, place.y - 0.35 * font.size.getValue(), place.z)
    text = coin.SoAsciiText()
    text.string = words
    text.justification = coin.SoAsciiText.CENTER
    for child in (font, shift, text):
        made.addChild(child)
    return made
