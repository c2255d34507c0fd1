"""In FreeCAD's window: what stands in parts, or far from the origin, is taken where it is seen."""

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
from ortho_mouse_tools import Hand
from ortho_suite_cases import WindowCase
from ortho_suite_tools import vertices, wait
from pivy import coin

from freecad_ortho import api, convert
from freecad_ortho.objects import places
from freecad_ortho.panels import form_panel
from freecad_ortho.panels.check_panel import CheckPanel

SIDE = 7
MIDDLE = SIDE * 3 + 3
PLACE = FreeCAD.Placement(
    FreeCAD.Vector(30000, -20000, 5000), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 40)
)


class PlaceCase(WindowCase):
    def net_in_part(self):
        net = api.import_net(tools.wavy_mesh(rows=SIDE, columns=SIDE))
        part = net.Document.addObject("App::Part", "Part")
        part.Placement = PLACE
        part.addObject(net)
        net.Document.recompute()
        api.optimise_net(net)
        return net

    def seen(self, net, points):
        """Points of a net's coordinates in those of the view."""
        return places.moved(points, places.container(net))

    def edited(self, net):
        self.hand = Hand(net.Document)
        self.assertTrue(net.ViewObject.Proxy.doubleClicked(net.ViewObject))
        wait()
        return net.ViewObject.Proxy._edit_panel.editing

    def taken_and_dragged(self, net):
        """Click on a vertex where it is seen, drag it, and let the net settle."""
        editing, steps = self.edited(net), net.Document.UndoCount
        pixels = self.hand.pixels(self.seen(net, vertices(net)))
        for vertex in (0, SIDE - 1, MIDDLE):
            self.hand.click(pixels[vertex], ctrl=True)
        self.assertEqual(set(editing.handles), {0, SIDE - 1, MIDDLE})
        end = pixels[MIDDLE] + (20, 40)
        self.hand.drag(pixels[MIDDLE], end)
        place = editing.handles[MIDDLE]
        np.testing.assert_allclose(self.hand.pixels(self.seen(net, place[None]))[0], end, atol=2)
        self.hand.release(end)
        self.assertTrue(wait(lambda: not editing.busy, 60))
        self.assertEqual(net.Document.UndoCount, steps + 1)
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        self.assertEqual(self.errors, [])


class TestInParts(PlaceCase):
    def test_vertices_are_taken_and_dragged_where_they_are_seen(self):
        self.taken_and_dragged(self.net_in_part())

    def test_supports_are_picked_where_they_are_seen(self):
        net = self.net_in_part()
        self.watch_panel(form_panel, "FormPanel")
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(net)
        FreeCADGui.runCommand("Ortho_FormNet")
        wait()
        panel = self.panel
        self.addCleanup(panel._stop)
        hand = Hand(net.Document)
        shown = np.array([p.getValue() for p in panel.preview._net._points.point.getValues()])
        self.assertEqual(len(shown), len(vertices(net)))
        panel.fields["supports"].value = "0,6"
        panel.pick_button.setChecked(True)
        panel.look()
        wait()
        hand.click(hand.pixels(self.seen(net, vertices(net)))[SIDE * SIDE - 1])
        self.assertEqual(panel.fields["supports"].value, f"0,6,{SIDE * SIDE - 1}")

    def test_marks_of_the_check_are_on_the_net(self):
        net = self.net_in_part()
        panel = CheckPanel(net)
        self.addCleanup(panel._unmark)
        panel._mark(0, 0)
        face = panel.result["measures"]["orthogonality"]["worst"]
        corners = convert.quad_mesh(net).vertices[convert.quad_mesh(net).faces[face]]
        action = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(800, 600))
        action.apply(panel.marks._root)
        middle = np.array(action.getBoundingBox().getCenter().getValue())
        points = self.seen(net, corners)
        np.testing.assert_allclose(middle, (points.min(axis=0) + points.max(axis=0)) / 2, atol=50)


class TestLinks(PlaceCase):
    def test_nothing_is_offered_for_what_a_link_shows(self):
        net = api.import_net(tools.wavy_mesh(rows=SIDE, columns=SIDE))
        beams = api.add_beams(net)
        flat = api.add_flat_patterns(beams)
        for shown, command in (
            (net, "Ortho_Beams"),
            (beams, "Ortho_ExportFabrication"),
            (flat, "Ortho_DrawingPage"),
        ):
            link = net.Document.addObject("App::Link", "Link")
            link.LinkedObject = shown
            net.Document.recompute()
            for selected, active in ((link, False), (shown, True)):
                FreeCADGui.Selection.clearSelection()
                FreeCADGui.Selection.addSelection(selected)
                self.assertEqual(FreeCADGui.isCommandActive(command), active, command)


class TestFar(PlaceCase):
    def far(self, origin):
        near = api.read_mesh(tools.wavy_mesh(rows=SIDE, columns=SIDE)).mesh
        offset = np.array([500123250.0, 5412345500.0, 412000.0])
        path = tools.SCRATCH / "far.obj"
        api.write_mesh(path, near.with_vertices((near.vertices + offset) / 1000), "m")
        net = api.import_net(path, origin=origin)
        api.optimise_net(net)
        return net

    def test_a_net_of_the_national_grid_is_dragged_like_any_other(self):
        self.taken_and_dragged(self.far("local"))

    def test_a_net_that_is_kept_there_is_drawn_without_loss(self):
        net = self.far("keep")
        view = net.ViewObject.Proxy
        shift = np.array(view._stand.translation.getValue().getValue())
        self.assertGreater(shift[1], 5e9)
        miss = self.shown(net) + view._origin.shift - vertices(net)
        self.assertLess(np.abs(miss).max(), 0.1)
        api.change_net(net, "subdivide")
        self.assertEqual(self.errors, [])
