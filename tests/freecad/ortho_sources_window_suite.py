"""Sources of nets in FreeCAD's window: panels, previews, drawing with the mouse. Run by FreeCAD."""

import unittest
from importlib.util import find_spec
from unittest import mock

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
import Part
from ortho_suite_tools import press, wait
from pivy import coin

from freecad_ortho import api, convert
from freecad_ortho.commands import dialogs, messages, sources
from freecad_ortho.commands.groups import ChangeNet, NewNet
from freecad_ortho.panels import form_panel, multi_net_panel, source_panel
from freecad_ortho.sources import GROUPS
from freecad_ortho.view.lens import Lens
from solver.mesh.remesh import LIBRARY
from solver.multinet import multi_net_residual

DOWN, UP = coin.SoButtonEvent.DOWN, coin.SoButtonEvent.UP


class SourceWindowCase(unittest.TestCase):
    def setUp(self):
        FreeCADGui.activateWorkbench("OrthoWorkbench")
        self.lines, self.errors, self.panel = [], [], None
        run = FreeCADGui.doCommand

        def recorded(line):
            self.lines.append(line)
            run(line)

        self.watch(messages, "show_error", self.errors.append)
        self.watch(FreeCADGui, "doCommand", recorded)
        for module, name in (
            (source_panel, "SourcePanel"),
            (multi_net_panel, "MultiNetPanel"),
            (form_panel, "FormPanel"),
        ):
            self.watch(module, name, self.kept(getattr(module, name)))
        self.document = FreeCAD.newDocument("Sources")
        wait()

    def kept(self, make):
        def made(*arguments):
            self.panel = make(*arguments)
            return self.panel

        return made

    def watch(self, target, name, replacement):
        patch = mock.patch.object(target, name, replacement)
        patch.start()
        self.addCleanup(patch.stop)

    def tearDown(self):
        if FreeCADGui.Control.activeDialog():
            FreeCADGui.Control.closeDialog()
        if self.panel is not None:
            self.panel._stop()
        FreeCADGui.Selection.clearSelection()
        tools.close_all()
        wait()

    def opened(self, command):
        self.assertTrue(FreeCADGui.isCommandActive(f"Ortho_{command}"), command)
        FreeCADGui.runCommand(f"Ortho_{command}")
        wait()
        return self.panel

    def shown(self):
        """Points that the preview shows."""
        points = self.panel.preview._net._points.point.getValues()
        return np.array([point.getValue() for point in points])


class TestPanels(SourceWindowCase):
    def test_choose_look_and_make(self):
        panel = self.opened("Primitive")
        panel.choice.setCurrentIndex(GROUPS["primitive"].index("sphere"))
        wait(lambda: panel.source.name == "sphere")
        panel.fields["radius"].value = 8000.0
        wait(seconds=0.4)
        np.testing.assert_allclose(np.linalg.norm(self.shown(), axis=1), 8000.0, rtol=1e-6)
        self.assertEqual(len(self.document.Objects), 0)
        press("Ok")
        net = self.document.Objects[0]
        self.assertEqual((net.Radius.Value, net.MadeBy), (8000.0, "sphere"))
        self.assertEqual(self.document.UndoCount, 1)
        line = self.lines[-1]
        self.assertIn("add_primitive('sphere'", line)
        points = tools.vertices(net).tobytes()
        self.document.undo()
        exec(line, {"FreeCAD": FreeCAD, "freecad_ortho": __import__("freecad_ortho.api")})
        self.assertEqual(tools.vertices(self.document.Objects[0]).tobytes(), points)
        self.assertEqual(self.errors, [])

    def test_every_primitive_is_seen_before_it_is_made(self):
        panel = self.opened("Primitive")
        for place, name in enumerate(GROUPS["primitive"]):
            panel.choice.setCurrentIndex(place)
            panel.look()
            self.assertIsNotNone(panel.made, name)
            self.assertEqual(len(self.shown()), len(panel.made.mesh.vertices))
        press("Cancel")
        self.assertEqual((len(self.document.Objects), self.document.UndoCount), (0, 0))
        self.assertLess(panel.view.getSceneGraph().findChild(panel.preview.root), 0)

    def test_a_bad_number_is_said_and_keeps_the_panel_open(self):
        panel = self.opened("Primitive")
        panel.choice.setCurrentIndex(GROUPS["primitive"].index("sphere"))
        panel.fields["radius"].value = 0.0
        panel.look()
        self.assertIn("radius: expected a positive number", panel.message.text())
        press("Ok")
        self.assertIn("radius", self.errors.pop())
        self.assertTrue(FreeCADGui.Control.activeDialog())
        self.assertEqual(len(self.document.Objects), 0)
        press("Cancel")

    def test_a_double_click_changes_it_again(self):
        net = api.add_primitive("cylinder", radius=2000.0)
        self.assertTrue(net.ViewObject.Proxy.doubleClicked(net.ViewObject))
        wait()
        self.assertFalse(net.Visibility)
        self.panel.fields["radius"].value = 3000.0
        steps = self.document.UndoCount
        press("Ok")
        self.assertEqual((net.Radius.Value, self.document.UndoCount), (3000.0, steps + 1))
        self.assertTrue(net.Visibility)
        self.assertTrue(self.lines[-1].endswith("radius=3000.0)"), self.lines[-1])
        net.ViewObject.Proxy.doubleClicked(net.ViewObject)
        self.panel.fields["radius"].value = 1.0
        press("Cancel")
        self.assertEqual(net.Radius.Value, 3000.0)
        self.assertTrue(net.Visibility)

    def test_changes_of_a_net_and_weld(self):
        net = api.add_primitive("rectangle", sampling=(9, 9), length=8000.0, width=8000.0)
        for command, group in (("Derived", "derived"), ("Refine", "refine"), ("FormNet", None)):
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelection(net)
            panel = self.opened(command)
            self.assertFalse(net.Visibility)
            self.assertIsNotNone(panel.made, panel.message.text())
            press("Ok")
            made = self.document.Objects[-1]
            self.assertEqual(made.Nets, [net])
            if group:
                self.assertIn(made.MadeBy, GROUPS[group])
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(net)
        panel = self.opened("Transform")
        panel.fields["move"].value = (8000.0, 0.0, 0.0)
        press("Ok")
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(net)
        FreeCADGui.Selection.addSelection(self.document.Objects[-1])
        self.opened("Weld")
        press("Ok")
        self.assertEqual(len(self.document.Objects[-1].Vertices), 9 * 17)
        self.assertEqual(self.errors, [])

    def test_picked_faces(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        self.assertFalse(FreeCADGui.isCommandActive("Ortho_FaceNet"))
        FreeCADGui.Selection.addSelection(box, ["Face1", "Face3"])
        panel = self.opened("FaceNet")
        panel.fields["edge"].value = 2.5
        press("Ok")
        net = self.document.Objects[-1]
        self.assertEqual(net.CadFaces, [(box, ("Face1", "Face3"))])
        self.assertEqual(len(net.Faces) // 4, 2 * 16)
        box.Height = 20
        self.document.recompute()
        self.assertEqual(len(net.Faces) // 4, 2 * 32)

    def test_closing_the_document_is_safe(self):
        self.opened("Primitive")
        FreeCAD.closeDocument(self.document.Name)
        wait(seconds=0.3)
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_a_panel_that_is_closed_from_outside_leaves_nothing(self):
        panel = self.opened("Primitive")
        FreeCADGui.Control.closeDialog()
        wait(seconds=0.4)
        self.assertLess(panel.view.getSceneGraph().findChild(panel.preview.root), 0)
        self.opened("MultiNet")
        drawing = self.panel.drawing
        FreeCADGui.Control.closeDialog()
        wait(seconds=0.4)
        self.assertLess(self.panel.view.getSceneGraph().findChild(drawing.root), 0)

    def test_a_saved_net_opens_with_its_view_and_panel(self):
        net = api.add_primitive("sphere", radius=3000.0)
        path, name = str(tools.SCRATCH / "sources.FCStd"), net.Name
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        wait()
        net = self.document.getObject(name)
        self.assertTrue(net.ViewObject.Proxy.doubleClicked(net.ViewObject))
        self.panel.fields["radius"].value = 2000.0
        press("Ok")
        self.assertEqual(net.Radius.Value, 2000.0)
        self.assertEqual(self.errors, [])

    def test_once_moved_a_double_click_drags_it(self):
        net = api.add_primitive("translational", sampling=(7, 6))
        net.FollowSource = False
        net.ViewObject.Proxy.doubleClicked(net.ViewObject)
        wait()
        self.assertIsNone(self.panel)
        self.assertIsNotNone(FreeCADGui.ActiveDocument.getInEdit())
        FreeCADGui.ActiveDocument.resetEdit()
        wait()
        sources.edit_source(net)
        self.panel.fields["rise"].value = 900.0
        press("Ok")
        self.assertTrue(net.FollowSource)
        self.assertEqual(net.Rise.Value, 900.0)

    def test_without_a_document_there_will_be_one(self):
        FreeCAD.closeDocument(self.document.Name)
        self.opened("Primitive")
        press("Ok")
        self.assertEqual(len(FreeCAD.ActiveDocument.Objects), 1)

    def test_groups_hold_commands_that_are_there(self):
        known = set(FreeCADGui.listCommands())
        for group in (NewNet(), ChangeNet()):
            self.assertLessEqual({f"Ortho_{type(group).__name__}", *group.GetCommands()}, known)

    def test_quads_from_triangles(self):
        from freecad_ortho.panels.remesh_panel import RemeshPanel

        with mock.patch.object(dialogs, "ask_triangle_file", lambda: None):
            FreeCADGui.runCommand("Ortho_QuadsFromMesh")
        self.assertFalse(FreeCADGui.Control.activeDialog())
        import Mesh

        mesh = self.document.addObject("Mesh::Feature", "Tube")
        mesh.Mesh = Mesh.Mesh(Part.makeCylinder(1000, 3000).tessellate(20.0))
        FreeCADGui.Selection.addSelection(mesh)
        FreeCADGui.runCommand("Ortho_QuadsFromMesh")
        wait()
        panel = RemeshPanel(mesh)
        self.assertGreater(panel.edge.millimetres, 100.0)
        with mock.patch("solver.mesh.remesh.LIBRARY", "no_such_library"):
            press("Ok")
        self.assertIn("no_such_library is not installed", self.errors.pop())
        self.assertEqual(len(self.document.Objects), 1)
        press("Cancel")

    @unittest.skipIf(find_spec(LIBRARY) is None, f"{LIBRARY} is not installed")
    def test_irregular_vertices_are_shown(self):
        import Mesh

        mesh = self.document.addObject("Mesh::Feature", "Ball")
        mesh.Mesh = Mesh.Mesh(Part.makeSphere(1000).tessellate(20.0))
        FreeCADGui.Selection.addSelection(mesh)
        FreeCADGui.runCommand("Ortho_QuadsFromMesh")
        press("Ok")
        self.assertEqual(self.errors, [])
        net = self.document.Objects[-1]
        connectivity = convert.quad_mesh(net).connectivity
        self.assertGreaterEqual((~connectivity.regular).sum(), 8)
        self.assertTrue(net.ViewObject.IrregularVertices)
        self.assertFalse(mesh.Visibility)
        self.assertIn("quads_from_mesh(", self.lines[-1])

    def test_supports_are_picked(self):
        net = api.add_primitive("rectangle", sampling=(5, 5), length=8000.0, width=8000.0)
        panel = self.opened("FormNet")
        panel.view.viewTop()
        panel.view.fitAll()
        wait()
        panel.pick_button.click()
        lens = Lens(panel.view, coin.SbViewportRegion(*panel.view.getSize()))
        for vertex in (0, 4, 20, 24, 12, 12):
            place = tools.vertices(net)[vertex]
            event = coin.SoMouseButtonEvent()
            event.setButton(coin.SoMouseButtonEvent.BUTTON1)
            event.setState(DOWN)
            event.setPosition(coin.SbVec2s(*np.rint(lens.pixels(place)[0]).astype(int).tolist()))
            action = coin.SoHandleEventAction(coin.SbViewportRegion(*panel.view.getSize()))
            action.setEvent(event)
            action.apply(panel.picking.root)
        self.assertEqual(panel.fields["supports"].value, "0,4,20,24")
        panel.fields["lift"].value = "0:2000; 24:2000"
        press("Ok")
        sail = self.document.Objects[-1]
        self.assertEqual(sail.Supports, "0,4,20,24")
        self.assertAlmostEqual(tools.vertices(sail)[12, 2], 1000.0, delta=1e-6)


class TestDrawing(SourceWindowCase):
    def mouse(self, place, state=None, button=coin.SoMouseButtonEvent.BUTTON1):
        """Send a mouse event at (3,) mm in space into the scene; a move without a state."""
        view = self.panel.view
        if state is None:
            event = coin.SoLocation2Event()
        else:
            event = coin.SoMouseButtonEvent()
            event.setButton(button)
            event.setState(state)
        event.setPosition(coin.SbVec2s(*self.pixel(place)))
        return self.send(view, event)

    def pixel(self, place):
        lens = Lens(self.panel.view, self.region(self.panel.view))
        return np.rint(lens.pixels(np.array(place))[0]).astype(int).tolist()

    def region(self, view):
        return coin.SbViewportRegion(*view.getSize())

    def send(self, view, event):
        action = coin.SoHandleEventAction(self.region(view))
        action.setEvent(event)
        action.apply(self.panel.drawing.root)
        return action.isHandled()

    def click(self, place):
        self.mouse(place, DOWN)
        self.mouse(place, UP)

    def key(self, key):
        event = coin.SoKeyboardEvent()
        event.setKey(key)
        event.setState(DOWN)
        return self.send(self.panel.view, event)

    def front(self, count=4):
        """Points of the ellipsoid that face the viewer."""
        look = -np.array(self.panel.view.getViewDirection())
        across = np.cross(look, [0, 0, 1])
        across /= np.linalg.norm(across)
        up = np.cross(across, look)
        places = [look + 0.35 * (k - 1.5) * across + 0.2 * np.sin(k) * up for k in range(count)]
        return self.panel.quadric.normalised(6000.0 * np.array(places))

    def drawn(self):
        panel = self.opened("MultiNet")
        panel.view.viewIsometric()
        panel.view.fitAll()
        wait()
        panel.draw_button.click()
        for place in self.front():
            self.click(place)
        return panel

    def test_clicks_become_points_on_the_quadric_and_a_net(self):
        panel = self.drawn()
        quadric, points = panel.quadric, panel.drawing.points
        self.assertEqual(points.shape, (4, 3))
        self.assertLess(quadric.distance(points).max(), 1e-6)
        # As near as the pixels of the view.
        self.assertLess(np.linalg.norm(points - self.front(), axis=1).max(), 200.0)
        self.assertEqual(len(self.shown()), 24 * 12)
        self.mouse([0, 0, 0], DOWN, coin.SoMouseButtonEvent.BUTTON2)
        self.assertFalse(panel.drawing.adding)
        press("Ok")
        net = self.document.MultiNet
        self.assertEqual(len(net.Points), 4)
        mesh = convert.quad_mesh(net)
        self.assertLess(multi_net_residual(mesh).bound, 1e-12)
        self.assertEqual(self.document.UndoCount, 1)
        exec(self.lines[-1], {"FreeCAD": FreeCAD, "freecad_ortho": __import__("freecad_ortho.api")})
        again = self.document.Objects[-1]
        self.assertEqual(tools.vertices(again).tobytes(), tools.vertices(net).tobytes())
        self.assertEqual(self.errors, [])

    def test_a_dragged_point_takes_the_net_along(self):
        panel = self.drawn()
        self.key(coin.SoKeyboardEvent.ESCAPE)
        self.assertFalse(panel.drawing.adding)
        before, shown = panel.drawing.points.copy(), self.shown()
        target = panel.quadric.normalised(before[1] * [1.0, 1.0, 0.4])
        self.assertTrue(self.mouse(before[1], DOWN))
        for share in (0.3, 0.7, 1.0):
            place = panel.quadric.normalised((1 - share) * before[1] + share * target)
            self.assertTrue(self.mouse(place))
        self.mouse(target, UP)
        after = panel.drawing.points
        self.assertLess(np.linalg.norm(after[1] - target), 200.0)
        np.testing.assert_array_equal(np.delete(after, 1, axis=0), np.delete(before, 1, axis=0))
        self.assertGreater(np.abs(self.shown() - shown).max(), 100.0)
        # Nothing is held any more: a move does nothing, a click beside points neither.
        self.assertFalse(self.mouse(target))
        self.click(self.front(7)[6])
        self.assertEqual(len(panel.drawing.points), 4)
        press("Cancel")
        self.assertEqual(len(self.document.Objects), 0)
        self.assertLess(panel.view.getSceneGraph().findChild(panel.drawing.root), 0)

    def test_beside_the_quadric_a_click_does_nothing_and_a_drag_stays_on_it(self):
        panel = self.drawn()
        look = -np.array(panel.view.getViewDirection())
        beside = 20000.0 * np.cross(look, [0, 0, 1])
        self.click(beside)
        self.assertEqual(len(panel.drawing.points), 4)
        panel.add_button.click()
        self.assertFalse(panel.drawing.adding)
        self.mouse(panel.drawing.points[3], DOWN)
        self.mouse(beside)
        self.mouse(beside, UP)
        self.assertLess(panel.quadric.distance(panel.drawing.points).max(), 1e-6)
        press("Cancel")

    def test_backspace_takes_the_last_point(self):
        panel = self.drawn()
        self.key(coin.SoKeyboardEvent.BACKSPACE)
        self.assertEqual(len(panel.drawing.points), 3)
        press("Cancel")

    def test_points_follow_the_quadric(self):
        panel = self.drawn()
        for name, value in (
            ("semi_axes", (12000.0, 6000.0, 5000.0)),
            ("quadric", "one-sheeted hyperboloid"),
            ("quadric", "two-sheeted hyperboloid"),
        ):
            panel.fields[name].value = value
            panel.look()
            self.assertIsNotNone(panel.made, panel.message.text())
            self.assertLess(panel.quadric.distance(panel.drawing.points).max(), 1e-6)
            self.assertIn("admissible", panel.message.text())
        panel.fields["t_range"].value = (-1e12, 1e6)
        panel.look()
        self.assertIn("t: expected", panel.message.text())
        press("Cancel")

    def test_it_is_drawn_on_when_opened_again(self):
        net = api.add_multi_net()
        points = convert.array(net.Points)
        sources.edit_source(net)
        self.panel.view.viewIsometric()
        self.panel.view.fitAll()
        wait()
        self.assertEqual(len(self.panel.drawing.points), 4 if not len(points) else len(points))
        self.mouse(self.panel.drawing.points[1], DOWN)
        place = self.panel.quadric.normalised(self.panel.drawing.points[1] * [1, 1, 0.5])
        self.mouse(place)
        self.mouse(place, UP)
        before = tools.vertices(net)
        press("Ok")
        self.assertGreater(np.abs(tools.vertices(net) - before).max(), 10.0)
        self.document.undo()
        self.assertEqual(tools.vertices(net).tobytes(), before.tobytes())

    def test_picture(self):
        panel = self.drawn()
        path = str(tools.SCRATCH / "drawing.png")
        panel.view.saveImage(path, 900, 600, "White")
        press("Ok")
        api.save_picture(str(tools.SCRATCH / "multinet.png"), width=900, height=600)
