"""The workbench in FreeCAD's window: every command, task panels, pictures. Run by FreeCAD."""

import json
import os
import sys
from unittest import mock

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
from ortho_panel_tools import form, scroll_area, width
from ortho_suite_tools import press, vertices, wait
from ortho_workbench_tools import WorkbenchCase
from PySide import QtCore, QtGui

from examples.mixed_faces import honeycomb
from freecad_ortho import api
from freecad_ortho.window import dialogs
from solver import write_mesh

NEEDS_NET = ("Ortho_Optimise", "Ortho_EditNet", "Ortho_Beams", "Ortho_Panels")


class TestStory(WorkbenchCase):
    def test_formula_mesh(self):
        self.story(tools.wavy_mesh(rows=8, columns=9))

    def test_heart(self):
        heart = tools.SHARED_MESHES / "heart.obj"
        if not heart.is_file():
            self.skipTest(f"{heart} is missing")
        self.story(str(heart), unit="m")

    def story(self, path, unit="mm"):
        """Import, optimise, beams, panels, export; undo and redo all; save, reopen, compare."""
        if unit != "mm":
            lines = open(path, encoding="utf-8").read()
            path = tools.write("with_unit.obj", f"# unit: {unit}\n{lines}")
        net = self.imported(path)
        document = net.Document
        self.assertNotBlank(self.picture("net"))
        start = vertices(net)
        self.optimised()
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        self.assertFalse(np.array_equal(vertices(net), start))
        for command in ("Ortho_Beams", "Ortho_Panels"):
            FreeCADGui.runCommand(command)
            wait()
            press("Ok")
        self.assertIs(document.Panels.OnBeams, document.Beams)
        self.assertNotBlank(self.picture("structure"))
        folder = tools.SCRATCH / f"files-{document.Name}"
        with mock.patch.object(dialogs, "ask_folder", lambda: str(folder)):
            FreeCADGui.runCommand("Ortho_ExportFabrication")
            press("Ok")
        files = {file.name for file in folder.iterdir()}
        self.assertLessEqual({"structure.step", "flat.dxf", "parts.csv", "report.json"}, files)
        self.assertEqual(self.errors, [])
        expected = self.state(document)
        self.undo_and_redo(document, expected)
        self.reopen(document, expected)

    def state(self, document):
        shapes = [item.Shape.Volume for item in (document.Beams, document.Panels)]
        return vertices(document.Net).tobytes(), list(document.Net.Faces), shapes

    def undo_and_redo(self, document, expected):
        self.assertEqual(document.UndoCount, 4)
        for left in (2, 1, 1, 0):
            document.undo()
            self.assertEqual(len(document.Objects), left)
        for _ in range(4):
            document.redo()
        wait()
        self.assertEqual(self.state(document), expected)
        np.testing.assert_allclose(self.shown(document.Net), vertices(document.Net), rtol=1e-6)

    def reopen(self, document, expected):
        path = str(tools.SCRATCH / f"{document.Name}.FCStd")
        document.saveAs(path)
        FreeCAD.closeDocument(document.Name)
        again = FreeCAD.openDocument(path)
        wait()
        points, faces, volumes = self.state(again)
        self.assertEqual((points, faces), expected[:2])
        # FreeCAD writes shapes with fifteen digits.
        np.testing.assert_allclose(volumes, expected[2], rtol=1e-12)
        np.testing.assert_allclose(self.shown(again.Net), vertices(again.Net), rtol=1e-6)
        self.assertFalse(again.Net.ViewObject.Visibility)
        self.assertTrue(again.Beams.ViewObject.Visibility)
        self.assertNotBlank(self.picture("reopened"))


class TestCommands(WorkbenchCase):
    def active(self):
        names = (*NEEDS_NET, "Ortho_ImportNet", "Ortho_ExportFabrication")
        return {name for name in names if FreeCADGui.isCommandActive(name)}

    def test_each_has_a_picture_a_sentence_and_keys_of_its_own(self):
        from freecad_ortho import commands

        keys = []
        for command in commands._commands():
            resources = command.GetResources()
            self.assertTrue(os.path.isfile(resources["Pixmap"]), resources)
            self.assertGreater(len(resources["ToolTip"]), 15)
            self.assertEqual(resources["WhatsThis"], resources["ToolTip"])
            keys.append(resources["Accel"])
        keys = [key for key in keys if key]
        self.assertGreater(len(keys), 8)
        self.assertEqual(len(keys), len(set(keys)))

    def test_one_of_ones_own_is_known_by_its_class_and_records_itself(self):
        import ortho_own_command

        from freecad_ortho import commands

        own = mock.patch.dict(sys.modules, {"freecad_ortho.commands.own": ortho_own_command})
        with own, mock.patch.object(commands, "_FILES", ("own",)):
            commands.register()
        with mock.patch.dict(commands.TOOLBARS, Own=("TurnOver",)):
            (name,) = commands.names("Own")
        self.assertFalse(FreeCADGui.isCommandActive(name))
        net = self.imported(tools.wavy_mesh())
        steps, lines = net.Document.UndoCount, len(self.lines)
        FreeCADGui.runCommand(name)
        self.assertTrue(net.Flipped)
        self.assertEqual(net.Document.UndoCount, steps + 1)
        self.assertEqual(len(self.lines), lines + 1)
        self.assertIn("freecad_ortho.api.flip_net(FreeCAD.", self.lines[-1])

    def test_context_menu_offers_what_suits_the_selection(self):
        from freecad_ortho import commands

        net = self.imported(tools.wavy_mesh())
        self.assertEqual(commands.for_selection(), [])
        FreeCADGui.Selection.addSelection(net)
        offered = commands.for_selection()
        self.assertIn("Ortho_Optimise", offered)
        self.assertNotIn("Ortho_ExportFabrication", offered)
        beams = api.add_beams(net)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(beams)
        self.assertIn("Ortho_ExportFabrication", commands.for_selection())

    def test_grey_where_they_do_not_apply(self):
        self.assertEqual(self.active(), {"Ortho_ImportNet"})
        net = self.imported(tools.wavy_mesh())
        self.assertEqual(self.active(), {"Ortho_ImportNet", *NEEDS_NET})
        FreeCADGui.runCommand("Ortho_Beams")
        self.assertEqual(self.active(), set())
        press("Ok")
        everything = {"Ortho_ImportNet", "Ortho_ExportFabrication", *NEEDS_NET}
        self.assertEqual(self.active(), everything)
        self.imported(tools.wavy_mesh("second"))
        self.assertEqual(self.active(), everything - set(NEEDS_NET))
        FreeCADGui.Selection.addSelection(net)
        self.assertEqual(self.active(), everything)

    def test_cancelled_dialogs_do_nothing(self):
        with mock.patch.object(dialogs, "ask_mesh_file", lambda: None):
            FreeCADGui.runCommand("Ortho_ImportNet")
        self.assertEqual(len(FreeCAD.listDocuments()), 0)
        net = self.imported(tools.wavy_mesh())
        FreeCADGui.runCommand("Ortho_Beams")
        press("Cancel")
        self.assertEqual((len(net.Document.Objects), net.Document.UndoCount), (1, 1))

    def test_errors_become_messages(self):
        bad = tools.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        with mock.patch.object(dialogs, "ask_mesh_file", lambda: bad):
            FreeCADGui.runCommand("Ortho_ImportNet")
        self.assertIn("1 triangle among 1", self.errors.pop())
        net = self.imported(tools.wavy_mesh())
        FreeCADGui.runCommand("Ortho_Beams")
        wait()
        tools.field("Thickness").setValue(1e5)
        press("Ok")
        self.assertIn("thickness", self.errors.pop())
        self.assertTrue(FreeCADGui.Control.activeDialog())
        self.assertEqual(len(net.Document.Objects), 1)

    def test_recorded_lines_replay_to_the_same_bits(self):
        net = self.imported(tools.wavy_mesh())
        self.optimised()
        for command in ("Ortho_Beams", "Ortho_Panels"):
            FreeCADGui.runCommand(command)
            press("Ok")
        name, points = net.Document.Name, vertices(net)
        volumes = [net.Document.Beams.Shape.Volume, net.Document.Panels.Shape.Volume]
        lines = list(self.lines)
        self.assertEqual(len(lines), 4)
        FreeCAD.closeDocument(name)
        for line in lines:
            exec(line, {"FreeCAD": FreeCAD})
        again = FreeCAD.getDocument(name)
        self.assertEqual(vertices(again.Net).tobytes(), points.tobytes())
        self.assertEqual([again.Beams.Shape.Volume, again.Panels.Shape.Volume], volumes)


class TestExport(WorkbenchCase):
    def test_progress_moves_and_esc_leaves_nothing(self):
        beams = api.add_beams(self.imported(tools.wavy_mesh()))
        moved, folder = [], tools.SCRATCH / "stopped"

        class Bar:
            def start(self, title, steps):
                self.steps = steps

            def next(self, can_abort):
                moved.append(can_abort)
                if stop_after and len(moved) > stop_after:
                    raise RuntimeError("Aborted")

            def stop(self):
                moved.append("stopped")

        with (
            mock.patch.object(FreeCAD.Base, "ProgressIndicator", Bar),
            mock.patch.object(dialogs, "ask_folder", lambda: str(folder)),
        ):
            stop_after = 30
            FreeCADGui.runCommand("Ortho_ExportFabrication")
            press("Ok")
            self.assertEqual(self.errors, ["stopped; nothing was written"])
            self.assertEqual(moved, [True] * 31 + ["stopped"])
            self.assertFalse(folder.exists())
            stop_after = None
            moved.clear()
            written = api.export_fabrication(beams, folder)
            self.assertEqual(moved, [True] * 100 + ["stopped"])
        self.assertGreaterEqual(len(written), 4)
        self.assertEqual(sorted(folder.iterdir()), sorted(written))


class TestOptimisePanel(WorkbenchCase):
    def started(self, rows=30):
        """A run that is in the middle of its work."""
        net = self.imported(tools.wavy_mesh(rows=rows, columns=rows))
        FreeCADGui.runCommand("Ortho_Optimise")
        self.panel.start_button.click()
        self.assertTrue(wait(lambda: self.panel.run.steps >= 2, 20))
        self.assertFalse(self.panel.run.optimisation.finished)
        return net

    def test_stop_go_on_and_keep(self):
        net = self.started()
        start = vertices(net)
        self.panel.stop_button.click()
        steps = self.panel.run.steps
        wait(seconds=0.3)
        self.assertEqual(self.panel.run.steps, steps)
        self.assertEqual(vertices(net).tobytes(), start.tobytes())
        self.assertGreater(np.abs(self.shown(net) - start).max(), 1.0)
        self.panel.start_button.click()
        self.assertTrue(wait(lambda: self.panel.run.steps > steps, 20))
        self.panel.stop_button.click()
        press("Ok")
        self.assertEqual(net.Document.UndoCount, 2)
        kept = vertices(net)
        net.Document.undo()
        self.assertEqual(vertices(net).tobytes(), start.tobytes())
        # The recorded line says how many steps were made, and they are the same steps.
        self.replay()
        self.assertEqual(vertices(net).tobytes(), kept.tobytes())

    def test_cancel_restores(self):
        net = self.started()
        start = vertices(net)
        press("Cancel")
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertEqual(vertices(net).tobytes(), start.tobytes())
        np.testing.assert_allclose(self.shown(net), start, rtol=1e-6, atol=1e-2)
        self.assertEqual(net.Document.UndoCount, 1)

    def test_closing_the_document_is_safe(self):
        run_document = self.started().Document.Name
        run = self.panel.run
        FreeCAD.closeDocument(run_document)
        wait(seconds=0.3)
        self.assertFalse(run.running)
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_deleting_the_net_is_safe(self):
        net = self.started()
        document, run = net.Document, self.panel.run
        document.removeObject(net.Name)
        wait(seconds=0.3)
        self.assertFalse(run.running)
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_undo_meanwhile_begins_anew(self):
        net = self.imported(tools.wavy_mesh())
        start = vertices(net)
        api.optimise_net(net)
        FreeCADGui.runCommand("Ortho_Optimise")
        self.panel.start_button.click()
        self.assertTrue(wait(lambda: self.panel.run.optimisation.finished, 20))
        net.Document.undo()
        self.assertIsNone(self.panel.run)
        np.testing.assert_allclose(self.shown(net), start, rtol=1e-6, atol=1e-2)
        self.panel.start_button.click()
        self.assertTrue(wait(lambda: self.panel.run.optimisation.finished, 20))
        press("Ok")
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        np.testing.assert_allclose(self.shown(net), vertices(net), rtol=1e-6, atol=1e-2)
        self.assertEqual(net.Document.UndoCount, 2)

    def test_bad_numbers_are_said(self):
        self.imported(tools.wavy_mesh())
        FreeCADGui.runCommand("Ortho_Optimise")
        self.panel.tolerance.widget.setText("tiny")
        self.panel.start_button.click()
        self.assertIn("'tiny' is not a number", self.errors.pop())
        self.panel.tolerance.widget.setText("1e-10")
        self.panel.fix.widget.setCurrentText("0,x")
        self.panel.start_button.click()
        self.assertIn("fix", self.errors.pop())
        press("Cancel")


class TestSmallScreen(WorkbenchCase):
    def test_what_came_of_a_run_is_seen_without_scrolling(self):
        net = self.imported(tools.wavy_mesh())
        net.Label = "A net with a name that is longer than any panel of FreeCAD is wide at first"
        report = FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "Report view")
        report.show()
        self.addCleanup(report.hide)
        FreeCADGui.runCommand("Ortho_Optimise")
        wait()
        self.panel.start_button.click()
        self.assertTrue(wait(lambda: self.panel.run.optimisation.finished, 60))
        wait()
        area = scroll_area()
        FreeCADGui.getMainWindow().grab().save(str(tools.SCRATCH / "small0.png"))
        self.assertLessEqual(form().width(), width())
        for widget in (self.panel.message, self.panel.plot):
            top, foot = (
                area.widget().mapTo(area.viewport(), widget.mapTo(area.widget(), point)).y()
                for point in (QtCore.QPoint(0, 0), QtCore.QPoint(0, widget.height()))
            )
            self.assertGreaterEqual(top, 0)
            self.assertLessEqual(foot, area.viewport().height())
        FreeCADGui.getMainWindow().grab().save(str(tools.SCRATCH / "small.png"))
        press("Cancel")


class TestFacesOfAnySize(WorkbenchCase):
    def test_a_honeycomb_is_drawn_checked_and_made_flat_in_the_panel(self):
        path = tools.SCRATCH / "honeycomb.obj"
        write_mesh(path, honeycomb(3), "mm")
        net = self.imported(str(path))
        self.assertNotBlank(self.picture("honeycomb"))
        faces = net.ViewObject.Proxy._face_set.coordIndex.getValues()
        self.assertEqual([len(face) for face in self.rows(faces)], [6] * 9)
        self.optimised()
        report = json.loads(net.LastReport)
        self.assertEqual((report["net"], report["status"]), ("planar", "converged"))
        # Overlays of quads have nothing to show, and say so in the report view alone.
        net.ViewObject.MedialLines = True
        FreeCADGui.runCommand("Ortho_Check")
        wait()
        labels = [label.text() for label in form().findChildren(QtGui.QLabel)]
        self.assertTrue(any("9 faces of 6 corners" in text for text in labels), labels)
        press("Close")
        self.assertEqual(self.errors, [])

    def rows(self, numbers):
        """Lists of the numbers before each -1."""
        words = " ".join(map(str, numbers)).split("-1")
        return [list(map(int, word.split())) for word in words if word.strip()]
