"""Sources of nets in FreeCAD's window: panels and previews. Run by FreeCAD."""

import unittest
from importlib.util import find_spec
from unittest import mock

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
import Part
from ortho_aligned_cases import LONG
from ortho_mouse_tools import Hand
from ortho_suite_cases import PanelCase, WindowCase
from ortho_suite_tools import press, wait
from PySide import QtGui

from freecad_ortho import api, commands, convert
from freecad_ortho.commands import sources
from freecad_ortho.commands.groups import ChangeNet, NewNet
from freecad_ortho.panels import aligned_panel, form_panel, multi_net_panel, source_panel
from freecad_ortho.sources import GROUPS
from freecad_ortho.window import dialogs
from solver.mesh.remesh import LIBRARY


class SourceWindowCase(PanelCase):
    def setUp(self):
        super().setUp()
        self.watch_panel(source_panel, "SourcePanel")
        self.watch_panel(multi_net_panel, "MultiNetPanel")
        self.watch_panel(form_panel, "FormPanel")
        self.watch_panel(aligned_panel, "AlignedPanel")
        self.document = FreeCAD.newDocument("Sources")
        wait()


class TestPanels(SourceWindowCase):
    def test_choose_look_and_make(self):
        panel = self.opened("Primitive")
        panel.choice.setCurrentIndex(GROUPS["primitive"].index("sphere"))
        wait(lambda: panel.source.name == "sphere")
        panel.fields["radius"].value = 8000.0
        wait(seconds=0.4)
        np.testing.assert_allclose(np.linalg.norm(self.previewed(), axis=1), 8000.0, rtol=1e-6)
        self.assertEqual(len(self.document.Objects), 0)
        press("Ok")
        net = self.document.Objects[0]
        self.assertEqual((net.Radius.Value, net.MadeBy), (8000.0, "sphere"))
        self.assertEqual(self.document.UndoCount, 1)
        line = self.lines[-1]
        self.assertIn("add_primitive('sphere'", line)
        points = tools.vertices(net).tobytes()
        self.document.undo()
        exec(line, {"FreeCAD": FreeCAD})
        self.assertEqual(tools.vertices(self.document.Objects[0]).tobytes(), points)
        self.assertEqual(self.errors, [])

    def test_every_primitive_is_seen_before_it_is_made(self):
        panel = self.opened("Primitive")
        for place, name in enumerate(GROUPS["primitive"]):
            panel.choice.setCurrentIndex(place)
            panel.look()
            self.assertIsNotNone(panel.made, name)
            self.assertEqual(len(self.previewed()), len(panel.made.mesh.vertices))
        press("Cancel")
        self.assertEqual((len(self.document.Objects), self.document.UndoCount), (0, 0))
        self.assertLess(panel.view.getSceneGraph().findChild(panel.preview.root), 0)

    def test_a_bad_number_is_said_and_keeps_the_panel_open(self):
        panel = self.opened("Primitive")
        panel.choice.setCurrentIndex(GROUPS["primitive"].index("sphere"))
        panel.fields["radius"].value = 0.0
        panel.look()
        self.assertIn("radius: expected a number above 0", panel.message.text())
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
        self.assertFalse(box.Visibility)
        self.document.undo()
        wait()
        self.assertEqual(self.document.Objects, [box])
        self.assertTrue(box.Visibility and box.ViewObject.Visibility)

    def test_a_net_is_seen_on_its_faces(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        FreeCADGui.Selection.addSelection(box, ["Face3", "Face6"])
        panel = self.opened("FaceNet")
        self.assertFalse(box.Visibility)
        panel.fields["edge"].value = 2.0
        press("Cancel")
        self.assertTrue(box.Visibility)
        net = api.net_from_faces([(box, "Face3"), (box, "Face6")], edge=2.0)
        self.assertFalse(box.Visibility)
        Hand(self.document)
        alone = self.net_picture(net)
        # Both at once: in the same planes the net is the one that is seen.
        box.Visibility = True
        together = self.net_picture(net)
        on_net = (alone != 255).any(axis=2)
        self.assertGreater(on_net.mean(), 0.1)
        self.assertGreater((alone == together).all(axis=2)[on_net].mean(), 0.98)
        self.assertGreater((alone != together).any(axis=2).mean(), 0.02)
        self.document.undo()
        self.assertEqual([item.Name for item in self.document.Objects], ["Box"])
        self.assertTrue(box.Visibility)

    def net_picture(self, net):
        """Pixels of the view as (height, width, 3) bytes."""
        net.ColourMap = "None"
        path = str(tools.SCRATCH / "faces.png")
        FreeCADGui.activeView().saveImage(path, 600, 400, "White")
        image = QtGui.QImage(path).convertToFormat(QtGui.QImage.Format_RGB888)
        return np.frombuffer(bytes(image.constBits()), np.uint8).reshape(400, 600, 3)

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
        self.assertGreater(panel.fields["edge"].value, 100.0)
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
        hand = Hand(self.document)
        panel.pick_button.click()
        pixels = hand.pixels(tools.vertices(net))
        for vertex in (0, 4, 20, 24, 12, 12):
            hand.click(pixels[vertex])
        self.assertEqual(panel.fields["supports"].value, "0,4,20,24")
        shown = [
            panel.picking._numbers.getChild(k).getChild(1).string.getValues()[0].strip()
            for k in range(panel.picking._numbers.getNumChildren())
        ]
        self.assertEqual(shown, ["0", "4", "20", "24"])
        panel.fields["lift"].value = "0,2000; 24,2000"
        press("Ok")
        sail = self.document.Objects[-1]
        self.assertEqual(sail.Supports, "0,4,20,24")
        self.assertAlmostEqual(tools.vertices(sail)[12, 2], 1000.0, delta=1e-6)


class TestAgain(WindowCase):
    def test_outdated_nets_are_optimised_by_one_command(self):
        document = FreeCAD.newDocument("Again")
        self.assertFalse(FreeCADGui.isCommandActive("Ortho_OptimiseAgain"))
        source = api.add_primitive("cylinder", sampling=(5, 4), document=document)
        first = api.change_net(source, "subdivide")
        api.optimise_net(first, net="orthogonal")
        second = api.change_net(first, "transform", move=("9 m", 0, 0))
        api.optimise_net(second, net="orthogonal")
        beams = api.add_beams(second)
        self.assertFalse(FreeCADGui.isCommandActive("Ortho_OptimiseAgain"))
        source.Radius = 2 * source.Radius.Value
        document.recompute()
        volume, steps = beams.Shape.Volume, document.UndoCount
        FreeCADGui.runCommand("Ortho_OptimiseAgain")
        done = wait(lambda: not (first.Outdated or second.Outdated) and self.closed(), LONG)
        self.assertTrue(done, self.errors)
        self.assertEqual(document.UndoCount, steps + 2)
        self.assertEqual(sum("optimise_net(" in line for line in self.lines), 2)
        self.assertNotEqual(beams.Shape.Volume, volume)
        self.assertFalse(FreeCADGui.isCommandActive("Ortho_OptimiseAgain"))
        self.assertEqual(self.errors, [])

    def closed(self):
        wait(seconds=0.1)
        return not FreeCADGui.Control.activeDialog()

    def test_numbers_of_before_are_said(self):
        document = FreeCAD.newDocument("Again")
        source = api.add_primitive("cylinder", sampling=(5, 4), document=document)
        net = api.change_net(source, "subdivide")
        api.optimise_net(net, net="orthogonal", fix=[3])
        source.SamplingU = 6
        document.recompute()
        FreeCADGui.Selection.addSelection(net)
        self.assertIn("Ortho_OptimiseAgain", commands.for_selection())
        FreeCADGui.runCommand("Ortho_OptimiseAgain")
        self.assertIn("choose them anew in Optimise", self.errors.pop())
        self.assertFalse(FreeCADGui.Control.activeDialog())
