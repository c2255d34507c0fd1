"""A polyline drawn in a 3D view with the mouse: points are set, dragged and removed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD
import numpy as np
from pivy import coin

from freecad_ortho.view import scene
from freecad_ortho.view.screen import Screen, mouse_of
from solver.mesh.quadmesh import FloatArray

# Pixels around a point in which the mouse takes hold of it.
_NEAR = 9.0
_HANDLE, _HELD, _LINE = (0.94, 0.58, 0.17), (0.84, 0.15, 0.16), (0.85, 0.33, 0.10)

# A ray (origin (3,), direction (3,)) to the point that is meant, or None where there is none.
Picker = Callable[[FloatArray, FloatArray], "FloatArray | None"]


class Drawing:
    """Points on something that rays are shot at, and the events that change them.

    Left click: a new point at the end (while ``adding``), on a point: drag it. Right click or Esc:
    no more new points. Backspace or Delete: the last point goes.

    Args:
        view: the 3D view.
        pick: gives the point that a ray means.
        changed: called after every change.
        ended: called when the user has had enough of adding points.
        stands: where the coordinates of the points stand in the view.

    Attributes:
        points: (n, 3) in mm.
        adding: whether a click sets a new point.
    """

    def __init__(
        self,
        view: Any,
        pick: Picker,
        changed: Callable[[], None],
        ended: Callable[[], None] = lambda: None,
        stands: FreeCAD.Placement | None = None,
    ) -> None:
        self.points: FloatArray = np.zeros((0, 3))
        self.adding = False
        self.pick = pick
        self._changed, self._ended = changed, ended
        self._held: int | None = None
        self._scene = view.getSceneGraph()
        self._build_scene(stands or FreeCAD.Placement())
        self._scene.insertChild(self.root, 0)

    def set_points(self, points: FloatArray) -> None:
        """Show other points without calling back."""
        self.points = np.asarray(points, dtype=np.float64).reshape(-1, 3)
        self._held = None
        self._show()

    def remove(self) -> None:
        """Take nodes and callbacks out of the view; doing it again changes nothing."""
        if self._scene.findChild(self.root) >= 0:
            for kind, callback in self._callbacks:
                self._events.removeEventCallback(kind, callback)
            self._scene.removeChild(self.root)

    def _build_scene(self, stands: FreeCAD.Placement) -> None:
        self.root = coin.SoSeparator()
        self._events = coin.SoEventCallback()
        self._coordinates, self._markers = coin.SoCoordinate3(), coin.SoMarkerSet()
        self._line, self._colours = coin.SoLineSet(), coin.SoMaterial()
        self._markers.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_9_9
        on_top, style = coin.SoDepthBuffer(), coin.SoDrawStyle()
        on_top.function = coin.SoDepthBuffer.ALWAYS
        style.lineWidth = 3
        line_colour, each = coin.SoBaseColor(), coin.SoMaterialBinding()
        line_colour.rgb = _LINE
        whole = coin.SoMaterialBinding()
        whole.value = coin.SoMaterialBinding.OVERALL
        each.value = coin.SoMaterialBinding.PER_VERTEX
        for child in (
            scene.standing(stands), self._events, scene.unpickable(), scene.unlit(), on_top, style,
            self._coordinates,
            line_colour, whole, self._line, self._colours, each, self._markers,
        ):  # fmt: skip
            self.root.addChild(child)
        self._callbacks = scene.heard(self._events, self._pressed, self._moved, self._typed)

    def _pressed(self, _: Any, callback: Any) -> None:
        event = callback.getEvent()
        down = event.getState() == coin.SoButtonEvent.DOWN
        if event.getButton() == coin.SoMouseButtonEvent.BUTTON1:
            if down:
                self._take_or_add(callback)
            elif self._held is not None:
                self._held = None
                self._show()
                callback.setHandled()
        elif event.getButton() == coin.SoMouseButtonEvent.BUTTON2 and down and self.adding:
            self._stop_adding()
            callback.setHandled()

    def _take_or_add(self, callback: Any) -> None:
        near = Screen.of_event(callback).vertex_at(mouse_of(callback), self.points, _NEAR)
        if near is None and self.adding:
            place = self._aimed_at(callback)
            if place is None:
                return
            self.points = np.concatenate([self.points, [place]])
            near = len(self.points) - 1
            self._held = near
            self._tell()
        self._held = near
        if near is not None:
            self._show()
            callback.setHandled()

    def _moved(self, _: Any, callback: Any) -> None:
        if self._held is None:
            return
        place = self._aimed_at(callback)
        if place is not None:
            self.points = self.points.copy()
            self.points[self._held] = place
            self._tell()
        callback.setHandled()

    def _typed(self, _: Any, callback: Any) -> None:
        event = callback.getEvent()
        if event.getState() != coin.SoButtonEvent.DOWN:
            return
        if event.getKey() == coin.SoKeyboardEvent.ESCAPE and self.adding:
            self._stop_adding()
            callback.setHandled()
        elif event.getKey() in (coin.SoKeyboardEvent.BACKSPACE, coin.SoKeyboardEvent.KEY_DELETE):
            if len(self.points):
                self._held = None
                self.points = self.points[:-1]
                self._tell()
            callback.setHandled()

    def _stop_adding(self) -> None:
        self.adding = False
        self._ended()

    def _tell(self) -> None:
        self._show()
        self._changed()

    def _show(self) -> None:
        count = len(self.points)
        self._coordinates.point.deleteValues(0)
        self._coordinates.point.setValues(0, count, self.points.tolist())
        self._line.numVertices.deleteValues(0)
        if count > 1:
            self._line.numVertices.setValue(count)
        self._markers.numPoints = count
        shades = [_HELD if k == self._held else _HANDLE for k in range(count)]
        self._colours.diffuseColor.deleteValues(0)
        self._colours.diffuseColor.setValues(0, count, shades)

    def _aimed_at(self, callback: Any) -> FloatArray | None:
        """What the mouse points at at an event."""
        ray = Screen.of_event(callback).ray(mouse_of(callback))
        return self.pick(ray.origin, ray.direction)
