"""Nets along curvature in FreeCAD's window: made in the background. Run by FreeCAD."""

import time
from typing import ClassVar
from unittest import mock

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
from ortho_aligned_cases import LONG, AlignedCase
from ortho_aligned_tools import dome, turned
from ortho_mouse_tools import Hand
from ortho_suite_tools import press, wait
from pivy import coin
from PySide import QtCore, QtGui

from freecad_ortho import api
from freecad_ortho.objects import making
from solver.errors import OrthoError


class TestPreview(AlignedCase):
    def test_freecad_stays_alive_while_a_net_is_made_once(self):
        beats, stages = [], set()
        panel = self.opened_on("Face1")
        clock = QtCore.QTimer()
        clock.setInterval(10)
        clock.timeout.connect(lambda: (beats.append(time.monotonic()), stages.add(self.stage())))
        clock.start()
        self.assertTrue(panel.aside.busy)
        self.assertTrue(self.sheet.Visibility)
        begun = time.monotonic()
        self.until_made(panel)
        clock.stop()
        took = time.monotonic() - begun
        # The clock beats on, with no long gap.
        self.assertGreater(len(beats), 10 * took)
        self.assertLess(np.diff([begun, *beats]).max(), max(0.6, 0.2 * took))
        self.assertGreaterEqual(stages, {"directions", "map"})
        self.assertFalse(self.sheet.Visibility)
        self.assertEqual(len(self.previewed()), len(panel.made.mesh.vertices))
        press("Ok")
        net = self.document.Objects[-1]
        np.testing.assert_allclose(tools.vertices(net), panel.made.mesh.vertices, atol=1e-9)
        # Neither the macro line nor the recompute after it has made it again.
        self.assertEqual(self.made, 1)
        self.assertIn("add_source('along curvature', faces=[(", self.lines[-1])
        self.assertEqual((self.document.UndoCount, self.errors), (1, []))

    def stage(self):
        return self.panel.message.text().rpartition(": ")[2]

    def test_a_change_breaks_off_and_begins_again(self):
        panel = self.opened_on("Face1")
        wait(lambda: self.stage() == "directions", LONG)
        panel.fields["edge"].value = 1500.0
        wait(seconds=0.2)
        panel.fields["edge"].value = 1200.0
        self.until_made(panel)
        self.assertAlmostEqual(panel.made.mesh.mean_edge, 1200.0, delta=120.0)
        # Of the three only the last came to its end.
        self.assertEqual(self.made, 2)
        panel.fields["edge"].value = 1e6
        self.assertTrue(wait(lambda: "leaves room for" in panel.message.text(), LONG))
        press("Ok")
        self.assertIn("leaves room for", self.errors.pop())
        self.assertTrue(FreeCADGui.Control.activeDialog())
        press("Cancel")
        self.assertEqual([item.Name for item in self.document.Objects], ["Sheet"])
        self.assertTrue(self.sheet.Visibility)

    def test_stop_and_ok_waits(self):
        panel = self.opened_on("Face1")
        panel.fields["edge"].value = 900.0
        wait(lambda: self.stage() == "map", LONG)
        panel.stop_button.click()
        self.assertFalse(panel.aside.busy)
        self.assertIn("Stopped", panel.message.text())
        wait(seconds=0.6)
        self.assertIsNone(panel.made)
        press("Ok")
        self.assertTrue(panel.aside.busy)
        self.assertFalse(panel.fields["edge"].widget.isEnabled())
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), LONG))
        self.assertEqual(self.document.Objects[-1].Edge.Value, 900.0)
        self.assertEqual(self.errors, [])

    def test_cancel_and_a_closed_document_leave_nothing_behind(self):
        panel = self.opened_on("Face1")
        press("Cancel")
        self.assertFalse(panel.aside.busy)
        self.assertLess(panel.view.getSceneGraph().findChild(panel.preview.root), 0)
        self.opened_on("Face1")
        FreeCAD.closeDocument(self.document.Name)
        wait(seconds=0.4)
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertFalse(self.panel.aside.busy)

    def test_a_double_click_changes_it(self):
        net = api.net_along_curvature(self.sheet, edge=1200.0)
        self.assertEqual(self.made, 1)
        net.ViewObject.Proxy.doubleClicked(net.ViewObject)
        self.until_made(self.panel)
        self.assertEqual(self.made, 1)
        self.panel.fields["edge"].value = 900.0
        press("Ok")
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), LONG))
        self.assertEqual((net.Edge.Value, self.made), (900.0, 2))
        self.assertTrue(self.lines[-1].endswith("edge=900.0)"), self.lines[-1])

    def test_esc_stops_it_where_no_panel_is_open(self):
        net = api.net_along_curvature(self.sheet, edge=1200.0)
        before = tools.vertices(net).tobytes()
        progress = mock.Mock()
        progress.return_value.next.side_effect = RuntimeError("User aborted")
        with mock.patch.object(FreeCAD.Base, "ProgressIndicator", progress):
            with self.assertRaisesRegex(OrthoError, "stopped"):
                api.change_source(net, edge=1000.0)
        self.assertEqual((net.Edge.Value, self.document.UndoCount), (1200.0, 1))
        self.assertEqual(tools.vertices(net).tobytes(), before)
        api.change_source(net, edge=1000.0)
        self.assertAlmostEqual(net.Edge.Value, 1000.0)


class TestStrokes(AlignedCase):
    def test_a_picked_edge_becomes_a_stroke(self):
        panel = self.opened_on("Face1", "Edge2")
        panel.fields["edge"].value = 1200.0
        self.until_made(panel)
        press("Ok")
        net = self.document.Objects[-1]
        self.assertEqual(net.Strokes, [(self.sheet, ("Edge2",))])
        self.assertIn("strokes=[(", self.lines[-1])
        points = tools.vertices(net).tobytes()
        self.document.undo()
        self.replay()
        self.assertEqual(tools.vertices(self.document.Objects[-1]).tobytes(), points)
        self.assertEqual(self.errors, [])

    def test_edges_are_picked_while_the_panel_is_open(self):
        panel = self.opened_on("Face1")
        panel.fields["edge"].value = 1200.0
        self.until_made(panel)
        self.assertFalse(self.sheet.Visibility)
        panel.strokes.pick_button.click()
        self.assertTrue(self.sheet.Visibility)
        self.assertEqual(self.previewed_faces(), 0)
        for name in ("Edge2", "Edge4", "Face1", "Edge2"):
            FreeCADGui.Selection.addSelection(self.sheet, name)
            wait(seconds=0.1)
        self.assertEqual(panel.strokes.strokes, [(self.sheet, "Edge4")])
        self.assertIn("not 'Face1'", self.said.pop())
        wait(seconds=0.3)
        self.until_made(panel)
        panel.strokes.pick_button.click()
        self.assertFalse(self.sheet.Visibility)
        self.assertGreater(self.previewed_faces(), 10)
        press("Ok")
        net = self.document.Objects[-1]
        self.assertEqual(net.Strokes, [(self.sheet, ("Edge4",))])
        net.ViewObject.Proxy.doubleClicked(net.ViewObject)
        wait()
        self.panel.strokes.clear_button.click()
        press("Ok")
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), LONG))
        self.assertEqual(net.Strokes, [])
        self.assertTrue(self.lines[-1].endswith("strokes=[])"), self.lines[-1])
        self.assertEqual(self.errors, [])

    def previewed_faces(self):
        return self.panel.preview._net._faces.coordIndex.getNum()


class TestByHand(AlignedCase):
    """The mouse on the surface: singular vertices are dragged, strokes are drawn."""

    # All begin with the same net.
    first: ClassVar = {}

    def setUp(self):
        super().setUp()
        making._made.update(self.first)
        self.sheet.Shape = dome()
        self.document.recompute()
        self.opened_on("Face1")
        self.panel.fields["edge"].value = 2500.0
        self.until_made(self.panel)
        self.first.update(making._made)
        self.hand = Hand(self.document)

    def given(self):
        return self.panel.fields["singularities"].value

    def remade(self):
        wait(seconds=0.5)
        self.until_made(self.panel)

    def on_dome(self, x, y):
        height = 6e3 * np.cos(0.9 * np.pi * x / 3e4) * np.cos(0.9 * np.pi * y / 2e4)
        return np.array([x, y, height])

    def drag(self, place, to):
        start, end = self.hand.pixels([place, to])
        self.hand.drag(start, end)
        self.hand.release(end)
        wait()

    def valences(self):
        return sorted(self.panel.made.singular.valences.tolist())

    def test_a_singular_vertex_is_dragged_and_reset(self):
        found = self.panel.made.singular
        self.assertEqual((self.valences(), self.given()), ([3, 3, 5, 5], None))
        row = int(np.flatnonzero(found.valences == 3)[0])
        goal = self.on_dome(5000.0, 2500.0)
        self.drag(found.places[row], goal)
        places = np.array(self.given())[:, :3]
        self.assertLess(np.linalg.norm(places[row] - goal), 250.0)
        np.testing.assert_allclose(np.delete(places, row, 0), np.delete(found.places, row, 0))
        self.remade()
        self.assertEqual(self.valences(), [3, 3, 5, 5])
        apart = np.linalg.norm(self.panel.made.singular.places - goal, axis=1)
        self.assertLess(apart.min(), 0.4 * 2500.0)
        press("Ok")
        net = self.document.Objects[-1]
        self.assertEqual((len(net.Singularities), self.document.UndoCount), (4, 1))
        self.assertIn("singularities=((", self.lines[-1])
        points = tools.vertices(net).tobytes()
        self.document.undo()
        self.replay()
        net = self.document.Objects[-1]
        self.assertEqual(tools.vertices(net).tobytes(), points)
        net.ViewObject.Proxy.doubleClicked(net.ViewObject)
        self.until_made(self.panel)
        self.panel.singular.reset_button.click()
        self.assertFalse(self.panel.singular.reset_button.isEnabled())
        self.remade()
        press("Ok")
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), LONG))
        self.assertEqual(net.Singularities, [])
        self.assertTrue(self.lines[-1].endswith("singularities=None)"), self.lines[-1])
        self.document.undo()
        self.assertEqual(len(net.Singularities), 4)
        self.assertEqual(self.errors, [])

    def test_dropped_onto_each_other_they_vanish_or_are_refused(self):
        found = self.panel.made.singular
        three, five = (found.places[found.valences == lines] for lines in (3, 5))
        self.drag(three[0], three[1])
        self.assertIn("would make a vertex with 2", self.said.pop())
        self.assertIsNone(self.given())
        self.drag(three[0], five[0])
        self.assertEqual(len(self.given()), 2)
        self.remade()
        self.assertEqual(self.valences(), [3, 5])
        self.drag(three[1], five[1])
        self.assertEqual(self.given(), ())
        self.remade()
        self.assertEqual(self.valences(), [])
        press("Ok")
        net = self.document.Objects[-1]
        self.assertEqual(net.Singularities, ["none"])
        self.assertIn("singularities=()", self.lines[-1])
        self.assertEqual(self.errors, [])

    def test_singular_vertices_are_added(self):
        box, goal = self.panel.singular, self.on_dome(4000.0, 2500.0)
        pixel, beside = self.hand.pixels([goal, self.on_dome(9000.0, -5000.0)])
        box.add_button.click()
        self.hand.press(beside)
        self.hand.key(coin.SoKeyboardEvent.ESCAPE)
        self.hand.release(beside)
        self.assertIsNone(self.given())
        box.lines_box.setCurrentIndex(1)
        self.hand.click(pixel)
        wait()
        self.assertFalse(box.add_button.isChecked())
        self.assertEqual([row[3] for row in self.given()].count(5), 3)
        self.assertLess(np.linalg.norm(np.array(self.given()[-1][:3]) - goal), 250.0)
        self.remade()
        self.assertEqual(self.valences(), [3, 3, 5, 5, 5])
        # A click adds no more.
        self.hand.click(beside)
        wait()
        self.assertEqual(len(self.given()), 5)
        press("Cancel")
        self.assertEqual(self.errors, [])

    def test_esc_and_clicks_beside_change_nothing(self):
        place = self.panel.made.singular.places[0]
        start, end = self.hand.pixels([place, self.on_dome(0.0, 0.0)])
        self.assertFalse(self.hand.press(end))
        self.hand.release(end)
        self.hand.drag(start, end)
        self.assertTrue(self.hand.key(coin.SoKeyboardEvent.ESCAPE))
        self.hand.release(end)
        self.hand.click(start)
        wait(seconds=0.2)
        self.assertIsNone(self.given())
        self.assertIsNotNone(self.panel.made)
        press("Cancel")
        self.assertFalse(self.hand.press(start))
        self.assertEqual(self.document.UndoCount, 0)

    def test_a_stroke_is_drawn(self):
        places = [self.on_dome(*xy) for xy in ((-9e3, -6e3), (0.0, 0.0), (9e3, 1e3))]
        pixels = self.hand.pixels(places)
        self.panel.strokes.draw_button.click()
        self.hand.press(pixels[0])
        for one, two in ((0, 1), (1, 2)):
            for part in np.linspace(0, 1, 12)[1:]:
                self.hand.move((1 - part) * pixels[one] + part * pixels[two])
        self.hand.release(pixels[2])
        (line,) = self.panel.fields["drawn_strokes"].value
        for place in (places[0], places[2]):
            self.assertLess(np.linalg.norm(line - place, axis=1).min(), 600.0)
        points = np.array(line)
        np.testing.assert_allclose(points, [self.on_dome(*p[:2]) for p in points], atol=60.0)
        self.panel.strokes.draw_button.click()
        self.remade()
        press("Ok")
        net = self.document.Objects[-1]
        self.assertEqual((len(net.DrawnStrokes), self.document.UndoCount), (1, 1))
        self.assertLess(turned(net, points), 6.0)
        drawn = tools.vertices(net).tobytes()
        self.document.undo()
        self.replay()
        net = self.document.Objects[-1]
        self.assertEqual(tools.vertices(net).tobytes(), drawn)
        net.ViewObject.Proxy.doubleClicked(net.ViewObject)
        self.until_made(self.panel)
        self.panel.strokes.clear_button.click()
        self.remade()
        press("Ok")
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), LONG))
        self.assertEqual(net.DrawnStrokes, [])
        self.assertEqual(self.errors, [])


class TestField(AlignedCase):
    def children(self, node):
        return [node.getChild(k) for k in range(node.getNumChildren())]

    def marks(self):
        """Numbers of lines and of points that are drawn on the preview, and their colours."""
        lines, points, colours = 0, 0, set()
        for mark in self.children(self.panel.preview._marks):
            for child in self.children(self.children(mark)[-1]):
                kind = child.getTypeId().getName()
                if kind == "LineSet":
                    lines += child.numVertices.getNum()
                elif kind == "PointSet":
                    points += child.numPoints.getValue()
                elif kind == "Material":
                    colours.add(child.diffuseColor[0].getValue())
        return lines, points, colours

    def test_crosses_strokes_and_singular_points_are_drawn(self):
        self.sheet.Shape = dome()
        self.document.recompute()
        panel = self.opened_on("Face1")
        self.until_made(panel)
        singular = panel.made.singular
        self.assertEqual(len(singular.places), 4)
        self.assertEqual(sorted(set(singular.valences.tolist())), [3, 5])
        words = "irregular: 2 vertices with 3 lines, 2 vertices with 5 lines"
        self.assertIn(words, panel.message.text())
        self.assertEqual(self.marks()[:2], (0, 4))
        plain = self.picture()
        panel.field_box.click()
        lines, points, colours = self.marks()
        faces = len(panel.made.mesh.faces)
        self.assertTrue(0.6 * faces < lines / 2 < 1.4 * faces, (lines, faces))
        self.assertEqual(points, 4)
        self.assertGreater(len(colours), 3)
        self.assertGreater((plain != self.picture()).any(axis=2).mean(), 0.02)
        panel.field_box.click()
        self.assertEqual(self.marks()[:2], (0, 4))
        press("Cancel")
        self.assertLess(panel.view.getSceneGraph().findChild(panel.preview.root), 0)

    def picture(self):
        """Pixels of the view as (height, width, 3) bytes."""
        path = str(tools.SCRATCH / "field.png")
        FreeCADGui.activeView().saveImage(path, 900, 600, "White")
        image = QtGui.QImage(path).convertToFormat(QtGui.QImage.Format_RGB888)
        return np.frombuffer(bytes(image.constBits()), np.uint8).reshape(600, 900, 3)
