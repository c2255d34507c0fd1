"""Colours, overlays, check and pictures in FreeCAD's window. Run by FreeCAD."""

from unittest import mock

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
from ortho_suite_cases import WindowCase
from ortho_suite_tools import press, vertices, wait
from ortho_workbench_tools import WorkbenchCase
from PySide import QtGui

from freecad_ortho import api, convert
from freecad_ortho.commands import open_file
from freecad_ortho.objects import constraints
from freecad_ortho.objects.net import colour_field
from freecad_ortho.panels import check_panel, display_panel
from freecad_ortho.panels.fields import length_words
from freecad_ortho.panels.net_words import reason_words
from freecad_ortho.window import dialogs
from solver.analysis.fields import field
from solver.errors import InputError
from solver.nets import all_measures


class AnalyseCase(WindowCase):
    def setUp(self):
        super().setUp()
        self.net = api.import_net(tools.wavy_mesh())
        self.document = self.net.Document
        self.document.UndoMode = 1
        FreeCADGui.ActiveDocument.ActiveView.fitAll()
        wait()

    def opened(self, command, module, name):
        self.watch_panel(module, name)
        FreeCADGui.runCommand(command)
        wait()
        return self.panel

    def picture(self, name, width=300, height=200):
        path = str(tools.SCRATCH / f"{name}.png")
        FreeCADGui.ActiveDocument.ActiveView.saveImage(path, width, height, "White")
        image = QtGui.QImage(path)
        self.assertEqual((image.width(), image.height()), (width, height))
        return bytes(image.constBits())


class TestDisplay(AnalyseCase):
    def panel_of_display(self):
        return self.opened("Ortho_Display", display_panel, "DisplayPanel")

    def test_what_is_chosen_is_shown_at_once_and_recorded_once(self):
        before = self.picture("before")
        panel = self.panel_of_display()
        panel.colour_map.widget.setCurrentText("Edge length")
        panel.overlays["Diagonals"].setChecked(True)
        self.assertNotEqual(self.picture("chosen"), before)
        self.assertEqual(self.lines, [])
        press("Ok")
        self.assertEqual(self.net.ColourMap, "Edge length")
        self.assertTrue(self.net.ViewObject.Diagonals)
        lines = [line for line in self.lines if "show_net" in line]
        self.assertEqual(len(lines), 1)
        self.net.ColourMap = "None"
        self.net.ViewObject.Diagonals = False
        exec(lines[0], {"FreeCAD": FreeCAD})
        self.assertEqual(self.net.ColourMap, "Edge length")
        self.assertTrue(self.net.ViewObject.Diagonals)

    def test_cancel_leaves_nothing_behind(self):
        steps = self.document.UndoCount
        before = self.picture("before")
        panel = self.panel_of_display()
        panel.colour_map.widget.setCurrentText("Gauss curvature")
        panel.overlays["Axes"].setChecked(True)
        panel.overlays["ReflectionLines"].setChecked(True)
        press("Cancel")
        self.assertEqual(self.picture("after"), before)
        self.assertEqual(self.document.UndoCount, steps)

    def test_a_range_can_be_set_and_half_a_range_is_refused(self):
        panel = self.panel_of_display()
        panel.colour_map.widget.setCurrentText("Edge length")
        panel.low.widget.setText("100")
        press("Ok")
        self.assertIn("give both numbers", self.errors.pop())
        panel.high.widget.setText("2500")
        press("Ok")
        view = self.net.ViewObject
        self.assertEqual(
            (view.AutomaticRange, view.LowestValue, view.HighestValue), (False, 100.0, 2500.0)
        )
        api.show_net(self.net, "Planarity", value_range=(-8, -2))
        self.assertEqual((view.LowestDecade, view.HighestDecade), (-8, -2))

    def test_unknown_names_are_refused_and_nothing_changes(self):
        before = self.picture("before")
        for wrong in (
            {"colour_map": "Beauty"},
            {"overlays": ["Beauty"]},
            {"value_range": (2.0, 1.0)},
        ):
            with self.assertRaises(InputError):
                api.show_net(self.net, **wrong)
        self.assertEqual(self.picture("after"), before)

    def test_every_overlay_shows_and_hides(self):
        from freecad_ortho.view.net_properties import OVERLAY_NAMES

        self.assertTrue(self.net.ViewObject.Upside)
        self.net.ViewObject.Upside = False
        plain = self.picture("plain")
        seen = {plain}
        shown = [name for name in OVERLAY_NAMES if name != "IrregularVertices"]
        for name in shown:
            setattr(self.net.ViewObject, name, True)
            seen.add(self.picture(name))
            setattr(self.net.ViewObject, name, False)
        self.assertEqual(len(seen), len(shown) + 1)
        self.assertEqual(self.picture("plain again"), plain)

    def test_overlays_follow_the_net_and_survive_a_reload(self):
        api.show_net(self.net, "None", overlays=["Axes", "Forces"])
        before = self.picture("before")
        moved = [point * 1.0 for point in self.net.Vertices]
        moved[20].z += 1500.0
        self.net.Vertices = moved
        after = self.picture("after")
        self.assertNotEqual(after, before)
        path = str(tools.SCRATCH / "overlays.FCStd")
        self.document.saveAs(path)
        tools.close_all()
        again = FreeCAD.openDocument(path)
        wait()
        view = again.getObject(self.net_name()).ViewObject
        self.assertTrue(view.Axes and view.Forces)
        self.assertFalse(view.Diagonals)

    def net_name(self):
        return "Net"


class TestReference(AnalyseCase):
    def test_gap_is_measured_to_the_faces_that_a_net_was_sampled_from(self):
        cylinder = self.document.addObject("Part::Cylinder", "Cylinder")
        cylinder.Radius, cylinder.Height = 3000.0, 5000.0
        self.document.recompute()
        net = api.net_from_faces([(cylinder, "Face1")])
        api.show_net(net, "Gap to reference")
        reference = constraints.reference_surface(net, convert.quad_mesh(net))
        values = field(convert.quad_mesh(net), "Gap to reference", reference).values
        self.assertLess(values.max(), 1.0)
        moved = [FreeCAD.Vector(p.x * 1.1, p.y * 1.1, p.z) for p in net.Vertices]
        net.Vertices = moved
        values = field(convert.quad_mesh(net), "Gap to reference", reference).values
        self.assertAlmostEqual(values.max(), 300.0, delta=1.0)
        self.assertGreater(net.ViewObject.Proxy._painting(convert.quad_mesh(net)).scale.high, 250.0)

    def test_a_net_that_came_near_shows_how_near(self):
        cylinder = self.document.addObject("Part::Cylinder", "Cylinder")
        cylinder.Radius, cylinder.Height = 3000.0, 5000.0
        self.document.recompute()
        net = api.net_from_faces([(cylinder, "Face1")], sampling=(13, 7))
        painted = net.ViewObject.Proxy
        self.assertEqual(colour_field(net), "Planarity")
        api.set_net(net, net="planar", flatness=5.0, close_to=[(cylinder, "Face1")])
        self.assertEqual(net.LargestGap.getValueAs("mm"), 5.0)
        self.assertEqual(colour_field(net), "Planarity")
        outcome = api.optimise_net(net, within="2 cm")
        self.assertLessEqual(outcome.report.form.gap, 5.0)
        self.assertEqual(colour_field(net), "Gap to reference")
        self.assertEqual(painted._explanation.scale.unit, "mm")
        self.assertEqual(net.ColourMap, "Target")
        api.set_net(net, close_to=[])
        self.assertEqual(colour_field(net), "Planarity")
        self.assertEqual(painted._explanation.scale.unit, "")


class TestColours(AnalyseCase):
    def title(self, net):
        """The first words of the scale that a net shows; None where it shows none."""
        legend = net.ViewObject.Proxy._legend
        return legend._explained[0] if legend.root.whichChild.getValue() != -1 else None

    def test_they_follow_the_target(self):
        self.assertEqual((self.net.ColourMap, self.title(self.net)), ("Target", "Planarity"))
        for net, diagonal, title in (
            ("asymptotic", False, "Asymptotic"),
            ("asymptotic", True, "Asymptotic diagonals"),
            ("cmc", False, "Mean curvature"),
            ("orthogonal", False, "Orthogonality"),
        ):
            api.set_net(self.net, net=net, diagonal=diagonal)
            self.assertEqual(self.title(self.net), title)
        api.show_net(self.net, colour_map="Planarity")
        self.assertEqual(self.title(self.net), "Planarity")

    def test_one_scale_a_view(self):
        other = api.add_primitive("sphere", document=self.document)
        titles = {net.Name: self.title(net) for net in (self.net, other)}
        self.assertEqual(titles, {self.net.Name: None, other.Name: f"Planarity: {other.Label}"})
        other.Visibility = False
        self.assertEqual((self.title(self.net), self.title(other)), ("Planarity", None))
        other.Visibility = True
        api.show_net(self.net, colour_map="Orthogonality")
        self.assertEqual(self.title(self.net), f"Orthogonality: {self.net.Label}")
        self.assertIsNone(self.title(other))

    def test_a_hidden_net_says_so(self):
        api.add_beams(self.net)
        self.assertFalse(self.net.Visibility)
        panel = self.opened("Ortho_Display", display_panel, "DisplayPanel")
        self.assertTrue(panel.hidden.isVisible())
        panel.reveal.click()
        wait()
        self.assertTrue(self.net.Visibility)
        self.assertFalse(panel.hidden.isVisible())
        press("Ok")

    def test_the_upper_side_is_seen_and_turned(self):
        before, normal = self.picture("up"), convert.quad_mesh(self.net).vertex_normals[0]
        panels = api.add_panels(self.net, offset="above")
        level = panels.Shape.BoundBox.ZMax
        self.net.Visibility = True
        FreeCADGui.Selection.addSelection(self.net)
        steps = self.document.UndoCount
        FreeCADGui.runCommand("Ortho_FlipNet")
        wait()
        self.assertIn("flip_net", self.lines[-1])
        np.testing.assert_allclose(convert.quad_mesh(self.net).vertex_normals[0], -normal)
        self.assertLess(panels.Shape.BoundBox.ZMax, level)
        panels.Visibility = False
        FreeCADGui.Selection.clearSelection()
        self.assertNotEqual(self.picture("down"), before)
        self.assertEqual((self.document.UndoCount, self.errors), (steps + 1, []))
        self.document.undo()
        np.testing.assert_allclose(convert.quad_mesh(self.net).vertex_normals[0], normal)

    def test_a_net_that_follows_a_source_stays_turned(self):
        net = api.add_primitive("rectangle", document=self.document)
        up = convert.quad_mesh(net).face_normals[0, 2]
        api.flip_net(net)
        net.Length = 2 * net.Length.Value
        self.document.recompute()
        self.assertEqual(convert.quad_mesh(net).face_normals[0, 2], -up)
        self.assertTrue(net.FollowSource)


class TestCheck(AnalyseCase):
    def test_measures_and_advice_are_listed(self):
        panel = self.opened("Ortho_Check", check_panel, "CheckPanel")
        names = [panel.measures.item(row, 0).text() for row in range(panel.measures.rowCount())]
        self.assertEqual(names, [measure.title for measure in all_measures().values()])
        self.assertGreater(panel.nets.rowCount(), 5)
        best = panel.result["advice"]["nets"][0]
        self.assertIn(f"{best['distance']:.1e}", panel.recommendation.text())
        for k, one in enumerate(panel.result["advice"]["nets"]):
            if one["cause"]:
                self.assertEqual(panel.nets.item(k, 2).toolTip(), reason_words(one["cause"]))
        self.assertIn(length_words(panel.result["planarity_gap"]), panel.summary.text())
        row = names.index("Orthogonality")
        plain = self.picture("unmarked")
        for k, entry in enumerate(panel.result["measures"].values()):
            panel.measures.cellClicked.emit(k, 0)
            count = {"face": 4, "edge": 2, "vertex": 1}[entry["where"]]
            self.assertEqual(panel.marks._handles._markers.numPoints.getValue(), count)
            self.assertNotEqual(self.picture("marked"), plain)
        panel._unmark()
        self.assertEqual(self.picture("unmarked again"), plain)
        panel.measures.cellDoubleClicked.emit(row, 0)
        self.assertEqual(self.net.ColourMap, "Orthogonality")
        press("Close")
        self.assertFalse(FreeCADGui.Control.activeDialog())


class TestPicture(AnalyseCase):
    def test_saved_at_the_size_asked_for_as_the_view_shows_it(self):
        path = str(tools.SCRATCH / "saved.png")
        with mock.patch.object(dialogs, "ask_picture", lambda: (path, 640, 320)):
            FreeCADGui.runCommand("Ortho_SavePicture")
        image = QtGui.QImage(path)
        self.assertEqual((image.width(), image.height()), (640, 320))
        self.assertEqual(len([line for line in self.lines if "save_picture" in line]), 1)

    def test_an_impossible_size_is_refused(self):
        with self.assertRaises(InputError):
            api.save_picture(str(tools.SCRATCH / "no.png"), width=0)

    def test_an_unknown_ending_is_refused_with_those_that_are_known(self):
        path = tools.SCRATCH / "no.tiffx"
        with self.assertRaisesRegex(InputError, "one of png, .*jpg.* call it no.png"):
            api.save_picture(str(path))
        self.assertFalse(path.exists())
        api.save_picture(str(path.with_suffix(".jpg")), width=64, height=48)
        self.assertEqual(QtGui.QImage(str(path.with_suffix(".jpg"))).width(), 64)


class TestPages(AnalyseCase):
    def test_names_stand_where_the_parts_are(self):
        flat = api.add_flat_patterns(api.add_beams(self.net), sheet=("3 m", "1.5 m"))
        page = api.add_drawing_page(flat)
        parts, names = page.Views
        box = flat.Shape.BoundBox
        wide, high = box.XLength * names.PatternScale, box.YLength * names.PatternScale
        # TechDraw draws ten units a millimetre, from the lower left corner of the page upwards.
        self.assertGreater(names.Y.Value - high / 2, 70.0)
        expected = np.array([wide, high, names.X.Value, -names.Y.Value]) * 10
        self.document.removeObject(parts.Name)
        page.ViewObject.doubleClicked()
        wait(seconds=1.0)
        views = FreeCADGui.getMainWindow().findChildren(QtGui.QGraphicsView)
        boxes = [item.sceneBoundingRect() for view in views for item in view.items()]
        found = [(box.width(), box.height(), box.center().x(), box.center().y()) for box in boxes]
        off = np.abs(np.array(found) / expected - 1).max(axis=1)
        self.assertLess(off.min(), 0.01)


class TestNetView(WorkbenchCase):
    def test_colour_maps_and_modes_change_the_picture(self):
        net = self.imported(tools.wavy_mesh())
        seen = []
        maps = net.getEnumerationsOfProperty("ColourMap")
        maps.remove("Gap to reference")
        # The same as one of the others.
        maps.remove("Target")
        for colour_map in maps:
            net.ColourMap = colour_map
            seen.append(self.picture(colour_map).tobytes())
        net.ViewObject.DisplayMode = "Wireframe"
        seen.append(self.picture("wireframe").tobytes())
        self.assertEqual(len(set(seen)), len(maps) + 1)

    def test_range_of_a_colour_map_can_be_set(self):
        net = self.imported(tools.wavy_mesh())
        net.ColourMap = "Edge length"
        automatic = self.picture("automatic").tobytes()
        net.ViewObject.AutomaticRange = False
        net.ViewObject.LowestValue, net.ViewObject.HighestValue = 0.0, 9000.0
        self.assertNotEqual(self.picture("set").tobytes(), automatic)

    def test_fit_all_and_picking_find_it(self):
        net = self.imported(tools.wavy_mesh())
        view = FreeCADGui.ActiveDocument.ActiveView
        view.viewTop()
        view.fitAll()
        wait()
        width, height = view.getSize()
        found = view.getObjectInfo((width // 2, height // 2))
        self.assertEqual(found["Object"], net.Name)

    def test_file_open_looks_at_it_from_the_front_right_and_above(self):
        document = open_file.open(tools.wavy_mesh())
        wait()
        view = FreeCADGui.ActiveDocument.ActiveView
        x, y, z = view.getViewDirection()
        self.assertLess(max(x, z), -0.2)
        self.assertGreater(y, 0.2)
        hand_size = np.array(view.getSize())
        ask = getattr(view, "getPointOnViewport", None) or view.getPointOnScreen
        pixels = np.array([ask(*map(float, point)) for point in vertices(document.Net)])
        self.assertTrue(((pixels > 0) & (pixels < hand_size)).all())
        self.assertGreater(np.ptp(pixels, axis=0).max(), 0.4 * hand_size.min())

    def test_structures_open_in_their_colours(self):
        net = self.imported(tools.wavy_mesh())
        beams = api.add_beams(net)
        self.assertNotEqual(beams.ViewObject.ShapeColor[:3], (0.8, 0.8, 0.8))
        self.assertFalse(net.ViewObject.Visibility)
