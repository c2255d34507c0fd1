"""A net in edit mode, its middle and its corners, for suites in FreeCAD's window."""

import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
from ortho_mouse_tools import Hand
from ortho_suite_cases import WindowCase
from ortho_suite_tools import vertices, wait

from freecad_ortho import api

SIDE = 10
MIDDLE = SIDE * 5 + 5
CORNERS = (0, SIDE - 1, SIDE * SIDE - SIDE, SIDE * SIDE - 1)


class EditingCase(WindowCase):
    def edited(self, side=SIDE, **settings):
        """A principal net in edit mode."""
        net = api.import_net(tools.wavy_mesh(rows=side, columns=side))
        api.optimise_net(net, **settings)
        self.enter(net)
        return net

    def enter(self, net):
        self.hand = Hand(net.Document)
        self.assertTrue(net.ViewObject.Proxy.doubleClicked(net.ViewObject))
        wait()
        self.panel = net.ViewObject.Proxy._edit_panel
        self.editing = self.panel.editing
        self.pixels = self.hand.pixels(vertices(net))

    def held(self, net, way=(0, 60)):
        """In the middle of a drag of the middle vertex, the corners being handles too."""
        for corner in CORNERS:
            self.hand.click(self.pixels[corner], ctrl=True)
        start = self.pixels[MIDDLE]
        self.hand.drag(start, start + way)
        return start + way

    def settled(self, end):
        self.hand.release(end)
        self.assertTrue(wait(lambda: not self.editing.busy, 60))

    def shown(self, net):
        points = net.ViewObject.Proxy._coordinates.point.getValues()
        return np.array([point.getValue() for point in points])

    def assertLeft(self, net=None):
        """Edit mode is over and has left nothing behind."""
        wait()
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertFalse(self.editing.busy)
        if net is not None:
            self.assertIsNone(FreeCADGui.getDocument(net.Document.Name).getInEdit())
            np.testing.assert_allclose(self.shown(net), vertices(net), rtol=1e-6, atol=1e-2)
