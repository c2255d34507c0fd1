"""Structural checks in FreeCAD's window: the panel, what is drawn, what swings."""

import contextlib
import shutil
import unittest
from importlib.util import find_spec

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
from ortho_suite_cases import WindowCase
from ortho_suite_tools import press, wait
from ortho_tutorial import Tutorial

from freecad_ortho import answers, api, convert
from freecad_ortho.panels import structural_panel
from freecad_ortho.window import dialogs


class CheckWindowCase(WindowCase):
    def setUp(self):
        super().setUp()
        self.document = FreeCAD.newDocument("Check")
        self.net = api.import_net(tools.wavy_mesh(rows=4, columns=5), self.document)
        self.watch_panel(structural_panel, "StructuralPanel")

    def check(self, **more):
        return api.add_structural_check(self.net, **({"material": "S355", "snow": 1.5} | more))

    def drawn(self, check):
        points = check.ViewObject.Proxy._lines._points.point.getValues()
        return np.array([point.getValue() for point in points])

    def points(self, check):
        """Nodes, then middles of members."""
        nodes = convert.array(check.Nodes)
        members = np.array(check.MemberNodes).reshape(-1, 2)
        return np.concatenate([nodes, nodes[members].mean(axis=1)])

    def colours(self, check):
        rows = check.ViewObject.Proxy._lines._material.diffuseColor.getValues()
        return np.array([row.getValue() for row in rows])

    def legend(self, check):
        return check.ViewObject.Proxy._legend


class TestPanel(CheckWindowCase):
    def test_the_command_checks_what_the_panel_says(self):
        FreeCADGui.Selection.addSelection(self.net)
        self.assertTrue(FreeCADGui.isCommandActive("Ortho_StructuralCheck"))
        FreeCADGui.runCommand("Ortho_StructuralCheck")
        self.panel.fields["snow"].value = 2.0
        self.panel.fields["material"].value = "S235"
        self.panel.texts["wind"].widget.setText("0.6@x; 0.6@-y")
        press("Ok")
        self.assertFalse(self.errors)
        (check,) = [item for item in self.document.Objects if item.Name == "StructuralCheck"]
        self.assertEqual((check.Snow.Value, check.Wind), (2.0, ["0.6@x", "0.6@-y"]))
        self.assertTrue(check.CheckedSection.endswith("of S235"))
        self.assertIn("add_structural_check", self.lines[-1])
        self.assertFalse(self.net.Visibility)
        self.replay()
        self.assertEqual(self.document.ActiveObject.Verdict, check.Verdict)

    def test_what_cannot_be_checked_keeps_the_panel_open(self):
        FreeCADGui.Selection.addSelection(self.net)
        FreeCADGui.runCommand("Ortho_StructuralCheck")
        self.panel.fields["joints"].value = "hinged"
        press("Ok")
        self.assertIn("a mechanism", self.errors[0])
        self.assertTrue(FreeCADGui.Control.activeDialog())
        self.assertEqual([item.Name for item in self.document.Objects], ["Net"])
        press("Cancel")

    def test_a_double_click_opens_its_settings_again(self):
        beams = api.add_beams(self.net, height=120, thickness=15)
        check = self.check(wind=["0.6@x"], beams=beams)
        check.ViewObject.Proxy.doubleClicked(check.ViewObject)
        self.assertEqual(self.panel.fields["snow"].value, 1.5)
        self.assertEqual(self.panel.texts["wind"].text, "0.6@x")
        self.assertEqual(self.panel.beams.currentText(), beams.Label)
        self.assertFalse(self.panel.fields["section"].widget.isEnabled())
        self.panel.fields["imperfection"].value = 25.0
        self.panel.beams.setCurrentIndex(0)
        press("Ok")
        self.assertIn("change_structural_check", self.lines[-1])
        self.assertEqual(check.CheckedSection, "tube:100x60x5 of S355")
        self.assertEqual((check.Imperfection.Value, check.Members), (25.0, None))

    def test_supports_are_picked_in_the_view(self):
        check = self.check(supports="corners:fixed+3,8:sliding")
        check.ViewObject.Proxy.doubleClicked(check.ViewObject)
        picking = self.panel.picking
        picking.button.setChecked(True)
        self.assertTrue(self.net.Visibility)
        picking.pick(8)
        picking.pick(6)
        self.assertEqual(self.panel.fields["supports"].value, "corners:fixed+3,6:sliding")
        picking.pick(3)
        picking.pick(6)
        self.assertEqual(self.panel.fields["supports"].value, "corners:fixed")
        picking.pick(7)
        press("Ok")
        self.assertEqual(check.Supports, "corners:fixed+7")
        self.assertFalse(self.net.Visibility)

    def test_the_lightest_section_is_looked_for_and_undone(self):
        check = self.check(section="tube:100x60x5")
        self.replace(
            dialogs, "ask_sections", lambda lists: ("tube:100x60x5+tube:150x100x6.3", "all")
        )
        answers.ask("size check", check)
        self.assertEqual((check.Section, check.Passed), ("tube:150x100x6.3", True))
        self.assertIn("size_structural_check", self.lines[-1])
        self.document.undo()
        self.assertEqual(check.Section, "tube:100x60x5")
        self.replace(dialogs, "ask_sections", lambda lists: ("plate:1x8", "all"))
        answers.ask("size check", check)
        self.assertIn("None of 1 sections passes", self.errors[-1])
        self.assertEqual(check.Section, "tube:100x60x5")

    def test_point_loads_are_picked_in_the_view(self):
        check = self.check(supports="boundary")
        check.ViewObject.Proxy.doubleClicked(check.ViewObject)
        loads, supports = self.panel.load_picking, self.panel.picking
        supports.button.setChecked(True)
        loads.button.setChecked(True)
        self.assertFalse(supports.button.isChecked())
        self.assertTrue(self.net.Visibility)
        loads.pick(8)
        self.assertEqual(self.panel.texts["load"].text, "8:0,0,-1")
        self.panel.texts["load"].widget.setText("8:0,0,-5")
        loads.pick(9)
        loads.pick(14)
        loads.pick(8)
        press("Ok")
        self.assertEqual(check.PointLoads, ["9:0,0,-5", "14:0,0,-5"])
        self.assertFalse(self.net.Visibility)

    def test_files_go_where_the_user_says(self):
        check, folder = self.check(), tools.SCRATCH / "check-window"
        self.replace(dialogs, "ask_folder", lambda: str(folder))
        answers.ask("write check", check)
        self.assertTrue((folder / "check.html").exists())
        self.assertIn(str(folder), self.said[-1])


class TestTutorial(CheckWindowCase):
    def test_the_steps_of_the_page(self):
        api.optimise_net(self.net)
        api.add_beams(self.net)
        api.add_panels(self.net)
        drawn, seen = [], []

        def look(name):
            seen.append(name)
            if name == "stand-diagram":
                view = self.document.StructuralCheck.ViewObject
                drawn.append((view.Diagram, view.Combination))

        story = Tutorial(look)
        story.check_structure(1.5)
        check = self.document.StructuralCheck
        self.assertEqual((check.Snow.Value, check.Wind), (1.5, ["0.6@x"]))
        self.assertEqual(
            (check.Members, check.Cladding), (self.document.Beams, self.document.Panels)
        )
        self.assertEqual(check.CheckedSection, "plate:20x200 of steel")
        story.draw_forces()
        self.assertEqual(drawn, [("My", check.CombinationNames[1])])
        story.balance_deformed()
        self.assertTrue(check.SecondOrder)
        self.assertEqual(check.ViewObject.DrawnShape, "Buckling")
        story.size("tube:150x100x6.3+tube:200x120x10")
        self.assertEqual((check.Section, check.Members), ("tube:150x100x6.3", None))
        self.assertTrue(check.Passed)
        self.assertEqual(self.errors, [])
        expected = ["stand-panel", "stand", "stand-diagram", "stand-buckling", "stand-sized"]
        self.assertEqual(seen, expected)


class TestView(CheckWindowCase):
    def test_members_are_coloured_by_what_is_asked_for(self):
        check, seen = self.check(), []
        view = check.ViewObject
        for colours, title in (
            ("Utilisation", "Utilisation"),
            ("Axial force", "Axial force"),
            ("Displacement", "Displacement"),
        ):
            view.ColourBy = colours
            self.assertEqual(len(self.colours(check)), len(check.MemberUtilisation))
            self.assertEqual(view.Proxy._explanation.title, title)
            seen.append(self.colours(check).tobytes())
        self.assertEqual(len(set(seen)), 3)
        np.testing.assert_allclose(self.drawn(check), self.points(check), atol=1e-2)
        view.ColourBy = "None"
        self.assertEqual(len(np.unique(self.colours(check), axis=0)), 1)
        self.assertFalse(view.Proxy.explains())

    def written(self, diagram):
        """Words that stand at a diagram."""
        labels = [label.getChild(1) for label in diagram._labels]
        return {label.getField("string").getValues()[0] for label in labels}

    def test_diagrams_stand_on_the_members(self):
        check = self.check()
        view, diagram = check.ViewObject, check.ViewObject.Proxy._diagram

        def tips():
            return np.concatenate(
                [
                    [point.getValue() for point in sign._points.point.getValues()]
                    for sign in diagram._signs
                    if sign._faces.coordIndex.getNum() > 1
                ]
            )

        def far(points):
            """How far points are from the lines of the members, at most."""
            start, end = self.points(check)[np.array(check.MemberNodes).reshape(-1, 2).T]
            along = end - start
            part = np.einsum("pmc,mc->pm", points[:, None] - start, along)
            part = np.clip(part / (along**2).sum(axis=1), 0, 1)
            apart = points[:, None] - start - part[:, :, None] * along
            return np.linalg.norm(apart, axis=2).min(axis=1).max()

        view.DiagramScale = 2.0
        forces = np.array(check.ForcesAlong).reshape(-1, 3, 6)
        view.Diagram = "N"
        origin = np.array(diagram._stand.translation.getValue().getValue())
        self.assertAlmostEqual(far(tips() + origin) / (2 * np.abs(forces[:, :, 0]).max()), 1, 3)
        self.assertIn(f"N {forces[:, :, 0].min():.3g} kN", self.written(diagram))
        view.DrawnShape = "Deflected"
        self.assertEqual([sign._faces.coordIndex.getNum() for sign in diagram._signs], [0, 0])
        seen = []
        for _ in range(6):
            view.Proxy.next_diagram()
            seen.append(view.Diagram)
        self.assertEqual(seen, ["Vy", "Vz", "T", "My", "Mz", "None"])
        self.assertEqual(view.DrawnShape, "As drawn")
        self.assertEqual(diagram._labels.getNumChildren(), 0)
        view.Diagram = "My"
        before = tips()
        points = self.net.Vertices
        points[6] = points[6] + FreeCAD.Vector(0, 0, 300)
        self.net.Vertices = points
        self.document.recompute()
        self.assertGreater(np.abs(tips() - before).max(), 50)

    def test_any_combination_is_drawn(self):
        check = self.check(wind=["0.6@x"])
        view, start = check.ViewObject, self.points(check)
        names = list(check.CombinationNames)
        self.assertEqual(view.getEnumerationsOfProperty("Combination"), ["Governing", *names])
        members, nodes = len(check.MemberUtilisation), len(check.Nodes)
        view.Combination, view.Enlarged = names[1], 50.0
        view.ColourBy, view.DrawnShape = "Displacement", "Deflected"
        moves = convert.array(check.AllDisplacements).reshape(-1, nodes, 3)[1]
        moved = self.drawn(check)[:nodes] - start[:nodes]
        np.testing.assert_allclose(moved, 50 * moves, atol=1e-2)
        self.assertIn(names[1], view.Proxy._explanation.note)
        view.DrawnShape, view.ColourBy = "As drawn", "Axial force"
        axial = np.array(check.AllForcesAlong).reshape(-1, members, 3, 6)[1, :, :, 0]
        self.assertIn(f"{axial.min():.3g} to", view.Proxy._explanation.note)
        view.Diagram = "N"
        self.assertIn(f"N {axial.min():.3g} kN", self.written(view.Proxy._diagram))
        api.change_structural_check(check, snow=2.0)
        self.assertEqual(view.Combination, names[1])
        api.change_structural_check(check, wind=[])
        self.assertEqual(
            len(view.getEnumerationsOfProperty("Combination")), 1 + len(check.CombinationNames)
        )
        for _ in range(len(check.CombinationNames) + 1):
            self.assertIn(view.Combination, view.getEnumerationsOfProperty("Combination"))
            view.Proxy.next_combination()

    @unittest.skipUnless(find_spec("ObjectsFem"), "needs the FEM workbench of FreeCAD")
    def test_the_drawn_combination_becomes_an_analysis(self):
        check = self.check(wind=["0.6@x"])
        check.ViewObject.Combination = check.CombinationNames[2]
        answers.ask("analyse check", check)
        self.assertEqual(self.errors, [])
        self.assertIn(check.CombinationNames[2], self.lines[-1])
        analysis = self.document.getObject("NetAnalysis")
        self.assertTrue(analysis.Label.endswith(check.CombinationNames[2]))
        self.document.undo()
        self.assertIsNone(self.document.getObject("NetAnalysis"))

    @unittest.skipUnless(find_spec("ObjectsFem") and shutil.which("ccx"), "needs CalculiX")
    def test_the_button_that_runs_the_solver_finds_the_displacements(self):
        with contextlib.suppress(ImportError):
            # FreeCAD 1.1 asks about the VTK that cadquery brings.
            from femguiutils import vtk_module_handling

            vars(vtk_module_handling)["__user_input_received"] = True
        import femcommands.commands  # noqa: F401
        from femsolver import run

        check = self.check(supports="corners:fixed", section="plate:20x200")
        service = next(name for name in check.CombinationNames if name.startswith("service"))
        analysis = api.add_fem_analysis(check, service)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.document.getObject("SolverCalculiX"))
        self.assertTrue(FreeCADGui.isCommandActive("FEM_SolverRun"))
        FreeCADGui.runCommand("FEM_SolverRun")
        run._machines.clear()
        (found,) = (one for one in analysis.Group if one.isDerivedFrom("Fem::FemResultObject"))
        names, nodes = list(check.CombinationNames), len(self.net.Vertices)
        self.assertEqual(list(found.NodeNumbers[:nodes]), list(range(1, nodes + 1)))
        ours = convert.array(check.AllDisplacements).reshape(len(names), -1, 3)
        ours = ours[names.index(service), :nodes]
        theirs = convert.array(found.DisplacementVectors)[:nodes]
        apart = np.linalg.norm(theirs - ours, axis=1).max()
        self.assertLess(apart, 0.12 * np.linalg.norm(ours, axis=1).max())

    def test_shapes_are_drawn_as_large_as_is_said(self):
        check = self.check()
        view, start = check.ViewObject, self.points(check)
        view.DrawnShape, view.Enlarged = "Deflected", 50.0
        moves = 50 * convert.array(check.Displacements)
        moved = self.drawn(check)[: len(moves)] - start[: len(moves)]
        np.testing.assert_allclose(moved, moves, atol=1e-2)
        view.Enlarged = 0.0
        view.Proxy.next_mode()
        self.assertEqual((view.DrawnShape, view.BucklingMode), ("Buckling", 1))
        shapes = convert.array(check.BucklingShapes).reshape(-1, len(start), 3)
        largest = 0.06 * np.ptp(start, axis=0).max()
        moved = self.drawn(check) - start
        self.assertAlmostEqual(np.linalg.norm(moved, axis=1).max() / largest, 1.0, places=3)
        np.testing.assert_allclose(moved, largest * shapes[0], atol=0.1)
        for _ in range(len(shapes)):
            view.Proxy.next_mode()
        self.assertEqual(view.BucklingMode, 1)
        view.BucklingMode = 99
        np.testing.assert_allclose(self.drawn(check), start, atol=1e-2)

    def test_a_shape_swings_until_it_is_told_not_to_or_is_out_of_sight(self):
        check = self.check()
        swing = check.ViewObject.Proxy._swinging
        check.ViewObject.Proxy.swing()
        begun = self.drawn(check)
        self.assertTrue(wait(lambda: np.abs(self.drawn(check) - begun).max() > 1.0, 5))
        check.ViewObject.Proxy.swing()
        self.assertFalse(swing.going)
        np.testing.assert_allclose(self.drawn(check), begun)
        check.ViewObject.Proxy.swing()
        check.Visibility = False
        self.assertTrue(wait(lambda: not swing.going, 5))
        check.Visibility = True
        check.ViewObject.Proxy.swing()
        self.document.removeObject(check.Name)
        self.assertTrue(wait(lambda: not swing.going, 5))

    def test_undo_and_redo_are_drawn(self):
        check = self.check()
        view = check.ViewObject
        view.DrawnShape, view.ColourBy = "Buckling", "Displacement"
        before = self.drawn(check), self.colours(check)
        points = self.net.Vertices
        self.document.openTransaction("Move")
        points[6] = points[6] + FreeCAD.Vector(0, 0, 500)
        self.net.Vertices = points
        self.document.recompute()
        self.document.commitTransaction()
        after = self.drawn(check), self.colours(check)
        self.assertGreater(np.abs(after[0] - before[0]).max(), 100)
        for step, expected in (("undo", before), ("redo", after)):
            getattr(self.document, step)()
            np.testing.assert_allclose(self.drawn(check), expected[0], atol=1e-2)
            np.testing.assert_allclose(self.colours(check), expected[1], atol=1e-6)

    def test_one_legend_is_seen_beside_a_net_that_has_one(self):
        check = self.check()
        self.net.ColourMap = "Planarity"
        self.net.Visibility = True
        explained = [item for item in (check, self.net) if item.ViewObject.Proxy.explains()]
        self.assertEqual(len(explained), 2)
        shown = [item.ViewObject.Proxy._legend.root.whichChild.getValue() for item in explained]
        self.assertEqual(sorted(shown), [-3, -1])

    def test_it_is_drawn_again_when_its_document_is_opened(self):
        check = self.check()
        check.ViewObject.ColourBy = "Axial force"
        before = self.colours(check)
        path = str(tools.SCRATCH / "check-window.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        wait()
        again = self.document.getObject("StructuralCheck")
        self.assertEqual(again.ViewObject.ColourBy, "Axial force")
        np.testing.assert_allclose(self.colours(again), before, atol=1e-6)
        self.assertTrue(again.ViewObject.Proxy.explains())
