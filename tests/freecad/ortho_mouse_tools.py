"""Mouse and keys in a 3D view without a mouse: Coin events, sent through the whole scene."""

import time

import FreeCADGui
import numpy as np
from ortho_suite_tools import wait
from pivy import coin


class Hand:
    """Does in a document's 3D view what a hand on a mouse would do."""

    def __init__(self, document):
        self.view = FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")[0]
        self.view.viewAxonometric()
        self.view.fitAll()
        wait()
        # What the viewer draws; asking FreeCAD 1.1 for the viewer itself crashes it on closing.
        self._scene = coin.SoSeparator()
        self._scene.addChild(self.view.getCameraNode())
        self._scene.addChild(self.view.getSceneGraph())
        self.region = coin.SbViewportRegion(*self.view.getSize())

    def send(self, event, pixel=None, ctrl=False, shift=False):
        if pixel is not None:
            x, y = np.round(pixel).astype(int).tolist()
            event.setPosition(coin.SbVec2s(x, y))
        event.setCtrlDown(ctrl)
        event.setShiftDown(shift)
        action = coin.SoHandleEventAction(self.region)
        action.setEvent(event)
        action.apply(self._scene)
        return action.isHandled()

    def move(self, pixel, **keys):
        return self.send(coin.SoLocation2Event(), pixel, **keys)

    def button(self, state, pixel, which=coin.SoMouseButtonEvent.BUTTON1, **keys):
        event = coin.SoMouseButtonEvent()
        event.setButton(which)
        event.setState(state)
        return self.send(event, pixel, **keys)

    def redraws(self):
        """A list that grows by the time of each redraw of the view, from now on."""
        times = []
        node = coin.SoCallback()
        kind = coin.SoGLRenderAction.getClassTypeId()

        def drawn(_, action):
            if action.isOfType(kind):
                times.append(time.perf_counter())

        node.setCallback(drawn, None)
        self.view.getSceneGraph().addChild(node)
        return times

    def press(self, pixel, **keys):
        return self.button(coin.SoButtonEvent.DOWN, pixel, **keys)

    def release(self, pixel, **keys):
        return self.button(coin.SoButtonEvent.UP, pixel, **keys)

    def click(self, pixel, **keys):
        self.press(pixel, **keys)
        self.release(pixel, **keys)

    def key(self, key):
        event = coin.SoKeyboardEvent()
        event.setKey(key)
        event.setState(coin.SoButtonEvent.DOWN)
        return self.send(event)

    def pixels(self, points):
        """Where points of the model are seen, found by FreeCAD, not by the code under test."""
        # Its name was changed after FreeCAD 0.20.
        ask = getattr(self.view, "getPointOnViewport", None) or self.view.getPointOnScreen
        found = [ask(*map(float, point)) for point in points]
        return np.array(found, dtype=float).reshape(-1, 2)

    def drag(self, start, end, steps=5, until=None):
        """Press at one pixel, move in steps, with time for FreeCAD in between; no release."""
        self.press(start)
        for t in np.linspace(0, 1, steps + 1)[1:]:
            self.move((1 - t) * np.asarray(start) + t * np.asarray(end))
            wait(until or (lambda: False), 0.05)
