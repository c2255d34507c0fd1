"""Mouse and keys in the 3D view, turned into clicks on vertices, drags and words."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from pivy import coin

from freecad_ortho.view.handles import Handles
from freecad_ortho.view.screen import Ray, Screen, mouse_of, views
from solver.mesh.quadmesh import FloatArray

# Pixels within which a vertex is hit, and beyond which a press becomes a drag.
_REACH = 10.0
_STILL = 3.0
# Fields of FreeCAD's selection node: what a click selects, and what lights up under the mouse; the
# latter has another name in FreeCAD 0.20.
_SELECTING = ("selectionMode", "preselectionMode", "highlightMode")

_KEYS = {
    coin.SoKeyboardEvent.X: "x",
    coin.SoKeyboardEvent.Y: "y",
    coin.SoKeyboardEvent.Z: "z",
    coin.SoKeyboardEvent.N: "normal",
    coin.SoKeyboardEvent.S: "surface",
    coin.SoKeyboardEvent.V: "view",
    coin.SoKeyboardEvent.KEY_DELETE: "delete",
    coin.SoKeyboardEvent.BACKSPACE: "delete",
}


class Listener(Protocol):
    """Who is told what the mouse does."""

    points: FloatArray

    def hover(self, vertex: int | None) -> None:
        """The mouse is over another vertex than before, or over none."""

    def click(self, vertex: int, add: bool) -> None:
        """A vertex was clicked, with Ctrl held where ``add``."""

    def frame(self, vertices: list[int]) -> None:
        """A rectangle was drawn, with Shift held, round vertices."""

    def grab(self, vertex: int) -> bool:
        """A drag begins at a vertex; return whether it may."""

    def move(self, ray: Ray) -> None:
        """The dragged vertex is wanted under the mouse, somewhere on the ray."""

    def drop(self) -> None:
        """The drag has ended."""

    def cancel(self) -> None:
        """Esc was pressed during a drag."""

    def key(self, word: str) -> None:
        """A key with a meaning was pressed: a way to drag, or ``delete``."""


class Mouse:
    """Listens on a node of its own below a view provider's root.

    While it listens, clicks select nothing in FreeCAD's sense.

    Attributes:
        handles: the markers that lie beside it in the scene.
    """

    def __init__(self, view_object: Any, listener: Listener) -> None:
        self.handles = Handles()
        self._listener = listener
        self._pressed: int | None = None
        self._dragging = False
        self._framed_from: FloatArray | None = None
        self._start = self._offset = np.zeros(2)
        self._hovered: int | None = None
        # The root is kept, not the view object: it stays valid when that has been deleted.
        self._root = view_object.RootNode
        self._separator = coin.SoSeparator()
        events = coin.SoEventCallback()
        events.addEventCallback(coin.SoEvent.getClassTypeId(), self._event)
        self._separator.addChild(events)
        self._separator.addChild(self.handles.root)
        self._root.addChild(self._separator)
        self._selecting = _selection_off(view_object.Object.Document.Name)

    def remove(self) -> None:
        """Listen no more and take the markers away; doing it again changes nothing."""
        if self._separator is None:
            return
        if self._root.findChild(self._separator) >= 0:
            self._root.removeChild(self._separator)
        for field, value in self._selecting:
            field.set(value)
        self._separator = None
        self._selecting = []

    def _event(self, _: Any, callback: Any) -> None:
        event = callback.getEvent()
        kind = event.getTypeId()
        if kind.isDerivedFrom(coin.SoKeyboardEvent.getClassTypeId()):
            self._key_event(callback, event)
            return
        moved = kind.isDerivedFrom(coin.SoLocation2Event.getClassTypeId())
        button = kind.isDerivedFrom(coin.SoMouseButtonEvent.getClassTypeId())
        if not moved and not (button and event.getButton() == coin.SoMouseButtonEvent.BUTTON1):
            return
        screen = Screen.of_event(callback)
        pixel = mouse_of(callback)
        if moved:
            handled = self._moved(screen, pixel)
        elif event.getState() == coin.SoButtonEvent.DOWN:
            handled = self._down(screen, pixel, event.wasShiftDown())
        else:
            handled = self._up(screen, pixel, event.wasCtrlDown())
        if handled:
            callback.setHandled()

    def _down(self, screen: Screen, pixel: FloatArray, shift: bool) -> bool:
        self._start = pixel
        if shift:
            self._framed_from = pixel
            return True
        points = self._listener.points
        self._pressed = screen.vertex_at(pixel, points, _REACH)
        if self._pressed is None:
            return False
        places, _ = screen.pixels(points[[self._pressed]])
        self._offset = places[0] - pixel
        return True

    def _moved(self, screen: Screen, pixel: FloatArray) -> bool:
        if self._framed_from is not None:
            size = np.array(screen.size)
            self.handles.show_frame(2 * self._framed_from / size - 1, 2 * pixel / size - 1)
            return True
        if self._pressed is None:
            self._hover(screen.vertex_at(pixel, self._listener.points, _REACH))
            return False
        if not self._dragging and np.linalg.norm(pixel - self._start) > _STILL:
            self._dragging = self._listener.grab(self._pressed)
        if self._dragging:
            self._listener.move(screen.ray(pixel + self._offset))
        return True

    def _up(self, screen: Screen, pixel: FloatArray, add: bool) -> bool:
        if self._framed_from is not None:
            corner, self._framed_from = self._framed_from, None
            self.handles.hide_frame()
            self._listener.frame(screen.vertices_in(corner, pixel, self._listener.points))
            return True
        vertex, dragged = self._pressed, self._dragging
        self.release()
        if dragged:
            self._listener.drop()
        elif vertex is not None:
            self._listener.click(vertex, add)
        return vertex is not None

    def release(self) -> None:
        """Forget a button that is held, as where what it dragged has gone."""
        self._pressed, self._dragging = None, False

    def _hover(self, vertex: int | None) -> None:
        if vertex != self._hovered:
            self._hovered = vertex
            self._listener.hover(vertex)

    def _key_event(self, callback: Any, event: Any) -> None:
        if event.getState() != coin.SoButtonEvent.DOWN:
            return
        if event.getKey() == coin.SoKeyboardEvent.ESCAPE:
            if self._dragging:
                self.release()
                self._listener.cancel()
                callback.setHandled()
        elif event.getKey() in _KEYS and not event.wasCtrlDown():
            self._listener.key(_KEYS[event.getKey()])
            callback.setHandled()


def _selection_off(document: str) -> list[tuple[Any, str]]:
    """Let the mouse select nothing in a document's 3D views; give the fields and what they were.

    Nor does anything light up under it: FreeCAD would look through all faces at each move.
    """
    before = []
    for view in views(document):
        root = view.getSceneGraph()
        for name in _SELECTING:
            field = root.getField(name)
            if field is not None:
                before.append((field, field.get().getString()))
                field.set("OFF")
    return before
