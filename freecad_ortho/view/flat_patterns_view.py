"""View provider of flat patterns: FreeCAD's display of the lines, with the parts' names."""

from __future__ import annotations

from typing import Any

import FreeCAD
from pivy import coin

from freecad_ortho.objects.properties import Property, Stateless, ensure
from freecad_ortho.resources import icon

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
        ensure(view_object, _PROPERTIES)
        self.ViewObject, self.Object = view_object, view_object.Object
        self._names = coin.SoSwitch()
        view_object.RootNode.addChild(self._names)
        self._write_names()

    def getIcon(self) -> str:
        """Icon in the tree: the same picture as on the command."""
        return icon("flat_patterns")

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
            font = coin.SoFont()
            font.size = 11
            for node in (colour, font):
                self._names.addChild(node)
            for name, place in zip(feature.PartNames, feature.LabelPlaces, strict=True):
                self._names.addChild(_text(name, place))
        self._show_names()


def _text(words: str, place: FreeCAD.Vector) -> coin.SoSeparator:
    node = coin.SoSeparator()
    shift = coin.SoTranslation()
    shift.translation = tuple(place)
    text = coin.SoText2()
    text.string = words
    text.justification = coin.SoText2.CENTER
    node.addChild(shift)
    node.addChild(text)
    return node
