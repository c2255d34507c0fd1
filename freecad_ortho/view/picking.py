"""Vertices picked in a 3D view with the mouse: a click takes one, another click gives it back."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD
from pivy import coin

from freecad_ortho.view import scene
from freecad_ortho.view.screen import Screen, mouse_of
from solver.mesh.quadmesh import FloatArray

# Pixels around a vertex in which a click means it.
_NEAR = 12.0
# With more than this they would cover each other.
_MOST_NUMBERS = 200
_CHOSEN, _OTHER = (0.84, 0.15, 0.16), (0.55, 0.60, 0.66)


class Picking:
    """Marks on vertices, and the clicks that change which are chosen.

    Args:
        view: the 3D view.
        points: (n, 3) in mm.
        changed: called after every click that changed something.
        stands: where the coordinates of the points stand in the view.

    Attributes:
        chosen: numbers of the vertices.
        active: whether clicks count.
    """

    def __init__(
        self,
        view: Any,
        points: FloatArray,
        changed: Callable[[], None],
        stands: FreeCAD.Placement,
    ) -> None:
        self.chosen: set[int] = set()
        self.active = False
        self._points, self._changed = points, changed
        self._scene = view.getSceneGraph()
        self._build_scene(stands)
        self._scene.insertChild(self.root, 0)

    def show(self, chosen: set[int], active: bool) -> None:
        """Mark other vertices without calling back; while picking, show those not chosen too."""
        self.chosen, self.active = set(chosen), active
        shown = range(len(self._points)) if active else sorted(self.chosen)
        rows = self._points[list(shown)].tolist()
        shades = [_CHOSEN if k in self.chosen else _OTHER for k in shown]
        self._coordinates.point.deleteValues(0)
        self._coordinates.point.setValues(0, len(rows), rows)
        self._colours.diffuseColor.deleteValues(0)
        self._colours.diffuseColor.setValues(0, len(shades), shades)
        self._markers.numPoints = len(rows)
        self._write_numbers()

    def _write_numbers(self) -> None:
        """Each chosen vertex has its number beside it, as other fields ask for it."""
        self._numbers.removeAllChildren()
        if len(self.chosen) > _MOST_NUMBERS:
            return
        for vertex in sorted(self.chosen):
            one, place, text = coin.SoSeparator(), coin.SoTranslation(), coin.SoText2()
            place.translation = tuple(self._points[vertex].tolist())
            text.string = f"  {vertex}"
            one.addChild(place)
            one.addChild(text)
            self._numbers.addChild(one)

    def remove(self) -> None:
        """Take nodes and callback out of the view; doing it again changes nothing."""
        if self._scene.findChild(self.root) >= 0:
            self._events.removeEventCallback(*self._callback)
            self._scene.removeChild(self.root)

    def _build_scene(self, stands: FreeCAD.Placement) -> None:
        self.root, self._events = coin.SoSeparator(), coin.SoEventCallback()
        self._coordinates, self._colours = coin.SoCoordinate3(), coin.SoMaterial()
        self._markers = coin.SoMarkerSet()
        self._markers.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_7_7
        on_top, each = coin.SoDepthBuffer(), coin.SoMaterialBinding()
        on_top.function = coin.SoDepthBuffer.ALWAYS
        each.value = coin.SoMaterialBinding.PER_VERTEX
        for child in (
            scene.standing(stands), self._events, scene.unpickable(), scene.unlit(), on_top,
            self._coordinates,
            self._colours, each, self._markers,
        ):  # fmt: skip
            self.root.addChild(child)
        self._numbers, ink, font = coin.SoSeparator(), coin.SoBaseColor(), coin.SoFont()
        ink.rgb = _CHOSEN
        font.name, font.size = "Sans", 14
        for child in (ink, font, self._numbers):
            self.root.addChild(child)
        kind = coin.SoMouseButtonEvent.getClassTypeId()
        self._callback = (kind, self._events.addEventCallback(kind, self._pressed))

    def _pressed(self, _: Any, callback: Any) -> None:
        event = callback.getEvent()
        left = event.getButton() == coin.SoMouseButtonEvent.BUTTON1
        if not (self.active and left and event.getState() == coin.SoButtonEvent.DOWN):
            return
        vertex = Screen.of_event(callback).vertex_at(mouse_of(callback), self._points, _NEAR)
        if vertex is not None:
            self.show(self.chosen ^ {vertex}, self.active)
            callback.setHandled()
            self._changed()
