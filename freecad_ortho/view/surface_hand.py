"""The mouse on a surface: points are dragged along it or added, lines are drawn on it."""

from __future__ import annotations

from typing import Any, Protocol

import FreeCAD
import numpy as np
from pivy import coin

from freecad_ortho.view import scene
from freecad_ortho.view.dragging import first_hit, on_surface
from freecad_ortho.view.screen import Ray, Screen, mouse_of
from solver.mesh.closest import TriangleSurface
from solver.mesh.quadmesh import FloatArray

# Pixels around a point in which the mouse takes hold of it; beyond which a press is a drag; and
# between two points of a line that is drawn.
_NEAR, _STILL, _STEP = 10.0, 3.0, 8.0
_HELD, _LINE = (0.84, 0.15, 0.16), (0.10, 0.52, 0.30)


class HandListener(Protocol):
    """Who is told what the mouse has done."""

    def dropped(self, number: int, place: FloatArray, reach: float) -> None:
        """A point was dragged to a place (3,); others are there within a reach, in mm."""

    def drawn(self, line: FloatArray) -> None:
        """A line (n, 3) was drawn."""

    def added(self, place: FloatArray) -> None:
        """A point was added at a place (3,)."""


class SurfaceHand:
    """Listens in a 3D view, and shows what is being dragged, added or drawn.

    Args:
        view: the 3D view.
        surface: what is aimed at, mm.
        listener: who is told.
        stands: where the coordinates of surface and points stand in the view.

    Attributes:
        points: (n, 3) that can be dragged.
        drawing: whether a press begins a line.
        adding: whether a press beside all points adds one.
    """

    def __init__(
        self,
        view: Any,
        surface: TriangleSurface,
        listener: HandListener,
        stands: FreeCAD.Placement,
    ) -> None:
        self.points: FloatArray = np.zeros((0, 3))
        self.drawing = self.adding = False
        self._new = False
        self._surface, self._listener = surface, listener
        self._held: int | None = None
        self._line: list[FloatArray] | None = None
        self._place: FloatArray | None = None
        self._start = self._last = self._offset = np.zeros(2)
        self._scene = view.getSceneGraph()
        self._build_scene(stands)
        self._scene.insertChild(self.root, 0)

    def remove(self) -> None:
        """Take nodes and callbacks out of the view; doing it again changes nothing."""
        if self._scene.findChild(self.root) >= 0:
            for kind, callback in self._callbacks:
                self._events.removeEventCallback(kind, callback)
            self._scene.removeChild(self.root)

    def release(self) -> None:
        """Forget what is being dragged, added or drawn."""
        self._held = self._line = self._place = None
        self._new = False
        self._show([])

    def _build_scene(self, stands: FreeCAD.Placement) -> None:
        self.root, self._events = coin.SoSeparator(), coin.SoEventCallback()
        self._coordinates, self._colour = coin.SoCoordinate3(), coin.SoBaseColor()
        self._markers, self._lines = coin.SoMarkerSet(), coin.SoLineSet()
        self._markers.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_9_9
        on_top, style = coin.SoDepthBuffer(), coin.SoDrawStyle()
        on_top.function = coin.SoDepthBuffer.ALWAYS
        style.lineWidth = 4
        for child in (
            scene.standing(stands), self._events, scene.unpickable(), scene.unlit(), on_top, style,
            self._colour, self._coordinates, self._lines, self._markers,
        ):  # fmt: skip
            self.root.addChild(child)
        self._show([])
        self._callbacks = scene.heard(self._events, self._pressed, self._moved, self._typed)

    def _pressed(self, _: Any, callback: Any) -> None:
        event = callback.getEvent()
        if event.getButton() != coin.SoMouseButtonEvent.BUTTON1:
            return
        screen, pixel = Screen.of_event(callback), mouse_of(callback)
        down = event.getState() == coin.SoButtonEvent.DOWN
        handled = self._down(screen, pixel) if down else self._up(screen)
        if handled:
            callback.setHandled()

    def _down(self, screen: Screen, pixel: FloatArray) -> bool:
        self._start = self._last = pixel
        if self.drawing:
            place = first_hit(screen.ray(pixel), self._surface)
            if place is None:
                return False
            self._line = [place]
            return True
        if len(self.points):
            self._held = screen.vertex_at(pixel, self.points, _NEAR)
        if self._held is None:
            return self.adding and self._begin(screen.ray(pixel))
        self._offset = screen.pixels(self.points[[self._held]])[0][0] - pixel
        return True

    def _begin(self, ray: Ray) -> bool:
        """Add a point where the mouse is on the surface."""
        place = first_hit(ray, self._surface)
        if place is not None:
            self._new, self._place = True, place
            self._show([place])
        return self._new

    def _moved(self, _: Any, callback: Any) -> None:
        if self._held is None and self._line is None and not self._new:
            return
        screen, pixel = Screen.of_event(callback), mouse_of(callback)
        if self._new:
            self._begin(screen.ray(pixel))
        elif self._line is not None:
            self._go_on(screen.ray(pixel), pixel)
        elif self._place is not None or np.linalg.norm(pixel - self._start) > _STILL:
            ray = screen.ray(pixel + self._offset)
            self._place = on_surface(ray, self.points[self._held], self._surface)
            self._show([self._place])
        callback.setHandled()

    def _go_on(self, ray: Ray, pixel: FloatArray) -> None:
        """Draw on, where the mouse has gone far enough and is on the surface."""
        place = first_hit(ray, self._surface)
        if place is not None and np.linalg.norm(pixel - self._last) >= _STEP:
            self._last = pixel
            self._line.append(place)
            self._show(self._line)

    def _up(self, screen: Screen) -> bool:
        held, line, place, new = self._held, self._line, self._place, self._new
        self.release()
        if new:
            self._listener.added(place)
        if line is not None and len(line) > 1:
            self._listener.drawn(np.array(line))
        if held is not None and place is not None:
            pixel = screen.pixels(place[None])[0][0]
            beside = screen.ray(pixel + [_NEAR, 0.0])
            across = np.cross(beside.direction, place - beside.origin)
            self._listener.dropped(held, place, float(np.linalg.norm(across)))
        return new or held is not None or line is not None

    def _typed(self, _: Any, callback: Any) -> None:
        event = callback.getEvent()
        busy = self._new or self._held is not None or self._line is not None
        pressed = event.getState() == coin.SoButtonEvent.DOWN
        if busy and pressed and event.getKey() == coin.SoKeyboardEvent.ESCAPE:
            self.release()
            callback.setHandled()

    def _show(self, places: list[FloatArray]) -> None:
        count = len(places)
        self._colour.rgb = _HELD if self._line is None else _LINE
        self._coordinates.point.deleteValues(0)
        self._coordinates.point.setValues(0, count, [tuple(map(float, place)) for place in places])
        self._lines.numVertices.deleteValues(0)
        if count > 1:
            self._lines.numVertices.setValue(count)
        self._markers.numPoints = count if self._line is None else 0
