"""The Optimise panel in FreeCAD's window: choices, picked constraints, steps. Run by FreeCAD."""

import time

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
import Part
from ortho_mouse_tools import Hand
from ortho_suite_cases import WindowCase
from ortho_suite_tools import press, vertices, wait
from PySide import QtCore

from freecad_ortho import api, convert
from freecad_ortho.documents import net_settings
from freecad_ortho.panels.fields import length_words
from freecad_ortho.panels.net_words import net_words
from freecad_ortho.panels.optimise_panel import OptimisePanel
from solver.analysis.advisor import advise
from solver.nets import NETS, register, unregister
from solver.nets.options import OPTIONS
from tests.own_net import FLAT


def asked_of(net):
    """Names of what a net is told: its supports, then its options in the order of the table."""
    supports = [] if net.supports == "none" else ["supports"]
    return [*supports, *(name for name in OPTIONS if name in net.options)]


class OptimiseCase(WindowCase):
    def net(self, rows=10, columns=9):
        net = api.import_net(tools.wavy_mesh(rows=rows, columns=columns))
        FreeCADGui.SendMsgToActiveView("ViewFit")
        return net

    def opened(self, net):
        self.panel = OptimisePanel(net)
        FreeCADGui.Control.showDialog(self.panel)
        wait()
        return self.panel

    def finished(self, seconds=100):
        self.panel.start_button.click()
        run = self.panel.run
        self.assertTrue(wait(lambda: run.optimisation.finished, seconds))

    def replayed(self, net):
        """Undo what was kept and run the recorded line; give both results."""
        kept, words = vertices(net), net_settings.words(net)
        net.Document.undo()
        self.replay()
        self.assertEqual(net_settings.words(net), words)
        return kept, vertices(net)


class TestChoices(OptimiseCase):
    def test_recommendation_can_be_taken(self):
        net = self.net()
        api.set_net(net, net="stress")
        panel = self.opened(net)
        best = advise(convert.quad_mesh(net))[0].net
        self.assertIn(net_words()[best].split(":")[0], panel.choice.recommendation.text())
        self.assertEqual(panel.net_type.word, "stress")
        panel.choice.use.click()
        self.assertEqual(panel.net_type.word, best)
        self.assertFalse(panel.choice.use.isVisible())

    def test_what_stands_in_the_way_is_said_before_the_first_step(self):
        x, y = np.meshgrid(np.linspace(-6000, 6000, 9), np.linspace(-6000, 6000, 9), indexing="ij")
        path = tools.write_grid("saddle", np.stack([x, y, 3e-5 * x * y], axis=2))
        panel = self.opened(api.import_net(path))
        panel.start()
        self.assertIn("The lines do not follow the curvature", panel.message.text())
        wait(lambda: not panel.run.running, 60)
        self.assertIn("as a plane only", panel.message.text())

    def test_every_net_shows_what_belongs_to_it(self):
        panel = self.opened(self.net())
        panel.choice.fields["radius"].value = 5000.0
        seen = {}
        for name in NETS:
            panel.net_type.choose(name)
            rows = panel.choice.rows
            seen[name] = [option for option, row in rows.items() if not row.isHidden()]
            self.assertTrue(panel.choice.explanation.text())
        # A grid has no irregular vertices, so that nothing is asked of them.
        wanted = {name: asked_of(net) for name, net in NETS.items()}
        regular = {name: [one for one in row if one != "singular"] for name, row in wanted.items()}
        self.assertEqual(seen, regular)
        self.assertNotEqual(seen["cmc"], seen["chebyshev"])
        # What was said of one net waits for it, and is not said of another.
        self.assertNotIn("radius", panel.settings())
        panel.net_type.choose("cmc")
        self.assertEqual(panel.settings()["radius"], 5000)

    def test_irregular_vertices_are_asked_of_where_there_are_any(self):
        path = tools.SCRATCH / "three.obj"
        rim = [
            f"v {1e3 * np.cos(turn)} {1e3 * np.sin(turn)} 0" for turn in np.pi / 3 * np.arange(6)
        ]
        faces = ["f 1 2 3 4", "f 1 4 5 6", "f 1 6 7 2"]
        path.write_text("\n".join(["# unit: mm", "v 0 0 300", *rim, *faces]) + "\n")
        panel = self.opened(api.import_net(path))
        self.assertFalse(panel.choice.rows["singular"].isHidden())
        panel.net_type.choose("circular")
        self.assertTrue(panel.choice.rows["singular"].isHidden())

    def test_a_diagonal_that_was_ticked_for_one_net_is_not_for_the_next(self):
        net = self.net()
        panel = self.opened(net)
        ticked = panel.choice.fields["diagonal"].widget
        for name in ("asymptotic", "geodesic-chebyshev"):
            panel.net_type.choose(name)
            self.assertFalse(panel.choice.rows["diagonal"].isHidden())
            self.assertFalse(ticked.isChecked())
            ticked.setChecked(True)
        panel.net_type.choose("conical")
        self.assertFalse(panel.settings().get("diagonal", False))

    def test_a_net_of_ones_own_is_found(self):
        register(FLAT)
        self.addCleanup(unregister, FLAT.name)
        net = self.net()
        panel = self.opened(net)
        panel.net_type.choose("flat")
        self.assertEqual(panel.net_type.widget.currentText(), FLAT.title)
        self.assertIn(FLAT.gives, panel.choice.explanation.text())
        shown = [name for name, row in panel.choice.rows.items() if not row.isHidden()]
        self.assertEqual(shown, ["length"])
        self.finished()
        press("Ok")
        self.assertEqual(panel.run.optimisation.status, "converged")
        self.assertEqual((net.NetType, net.TargetEdge.Value), ("flat", 0.0))

    def test_settings_are_kept_and_found_again(self):
        net = self.net()
        panel = self.opened(net)
        self.assertFalse(panel.advanced._inside.isVisible())
        panel.advanced.unfold.click()
        panel.fairness.widget.setText("0.05")
        panel.fix.choose("corners")
        self.finished()
        press("Ok")
        kept, again = self.replayed(net)
        self.assertEqual(again.tobytes(), kept.tobytes())
        self.assertEqual(net.FairnessWeight, 0.05)
        panel = self.opened(net)
        self.assertEqual((panel.fix.word, panel.fairness.value), ("corners", 0.05))
        self.assertEqual(set(panel.settings()), {"net", "fix"})


class TestSteps(OptimiseCase):
    def test_step_plot_and_numbers_of_table_2(self):
        net = self.net()
        panel = self.opened(net)
        start = vertices(net)
        for count in (1, 2, 3):
            panel.step_button.click()
            self.assertEqual(panel.run.steps, count)
            lengths = {len(line) for line in panel.plot.series.values()}
            self.assertEqual(lengths, {count})
        self.assertEqual(set(panel.plot.series), {"orthogonality", "planarity"})
        # V vertices, 3 V + 3 F unknowns with the normals, F + 5 F equations of a principal net.
        self.assertIn("90 vertices", panel.statistics.text())
        problem = panel.run.optimisation.original
        self.assertIn(f"{problem.variables:,} variables", panel.statistics.text())
        self.assertIn(f"{problem.equations:,} constraints", panel.statistics.text())
        self.assertIn("ms a step", panel.statistics.text())
        self.assertGreater(np.abs(self.shown(net) - start).max(), 1.0)
        panel.undo_button.click()
        self.assertIsNone(panel.run)
        np.testing.assert_allclose(self.shown(net), start, rtol=1e-6, atol=1e-2)
        panel.step_button.click()
        press("Ok")
        kept, again = self.replayed(net)
        self.assertFalse(np.array_equal(kept, start))
        self.assertEqual(again.tobytes(), kept.tobytes())

    def test_net_that_is_there_already(self):
        net = self.net()
        api.optimise_net(net)
        panel = self.opened(net)
        for button in (panel.start_button, panel.start_button):
            button.click()
            self.assertIn("is a principal net already", panel.message.text())
        self.assertFalse(panel.run.running)

    def test_how_far_the_shape_moved_is_said_in_the_users_units(self):
        u, v = np.meshgrid(np.linspace(-5e3, 5e3, 11), np.linspace(-4e3, 4e3, 9), indexing="ij")
        net = self.net(rows=11, columns=9)
        dome = np.stack([u, v, 3.7e3 - 9e-5 * (u**2 + v**2)], axis=-1).reshape(-1, 3)
        net.Vertices = [FreeCAD.Vector(*point) for point in dome]
        panel = self.opened(net)
        panel.net_type.choose("asymptotic")
        self.finished()
        wait(lambda: not panel.run.running)
        told = panel.message.text()
        metres = FreeCAD.Units.Quantity(1e4, FreeCAD.Units.Length).UserString
        self.assertIn("The shape moved by up to", told)
        self.assertIn(f"Its size was {metres}", told)

    def test_panels_may_have_a_gap_which_is_said(self):
        panel = self.opened(self.net())
        panel.net_type.choose("planar")
        self.assertFalse(panel.choice.rows["flatness"].isHidden())
        panel.choice.fields["flatness"].value = 5.0
        self.finished()
        wait(lambda: not panel.run.running)
        form = panel.run.optimisation.outcome().report.form
        self.assertTrue(0.5 < form.gap <= 5.0, form.gap)
        words = f"The largest gap of a face is {length_words(form.gap)}, of face {form.gap_face}."
        self.assertIn(words, panel.message.text())

    def test_the_plot_draws(self):
        panel = self.opened(self.net())
        before = panel.plot.grab().toImage()
        self.finished()
        wait()
        self.assertNotEqual(panel.plot.grab().toImage(), before)

    def test_freecad_lives_on_while_a_step_is_made(self):
        self.net(rows=20, columns=20)
        panel = self.opened(FreeCAD.ActiveDocument.Net)
        panel.step_button.click()
        optimisation, ticks = panel.run.optimisation, []
        quick = optimisation.step

        def slow():
            time.sleep(0.3)
            return quick()

        optimisation.step = slow
        timer = QtCore.QTimer()
        timer.setInterval(5)
        timer.timeout.connect(lambda: ticks.append(time.perf_counter()))
        panel.start_button.click()
        timer.start()
        self.assertTrue(wait(lambda: panel.run.steps >= 3, 20))
        timer.stop()
        self.assertLess(np.diff(ticks).max(), 0.2)
        # Stop waits for the step under way, which counts.
        panel.stop_button.click()
        steps = len(optimisation.history)
        self.assertEqual(panel.run.steps, steps)
        self.assertIn("Stopped", panel.message.text())
        wait(seconds=0.5)
        self.assertEqual(len(optimisation.history), steps)
        panel.start_button.click()
        wait(seconds=0.1)
        press("Cancel")


class TestLeaving(OptimiseCase):
    def test_a_panel_that_is_closed_by_others(self):
        net = self.net(rows=20, columns=20)
        panel = self.opened(net)
        panel.constraints._pickers["fix"].click()
        panel.start_button.click()
        run = panel.run
        FreeCADGui.Control.closeDialog()
        wait()
        self.assertFalse(run.running)
        FreeCAD.closeDocument(net.Document.Name)
        wait()


class TestPicking(OptimiseCase):
    def picking(self, what):
        self.panel.constraints._pickers[what].click()
        wait()

    def test_vertices_are_fixed_and_drawn_to_places(self):
        net = self.net()
        self.opened(net)
        start, hand = vertices(net), Hand(net.Document)
        pixels = hand.pixels(start)
        self.picking("fix")
        for vertex in (0, 8, 45, 8):
            hand.click(pixels[vertex])
        self.assertEqual(self.panel.fix.word, "0,45")
        self.picking("handle")
        hand.drag(pixels[49], pixels[49] + [0, 20])
        hand.release(pixels[49] + [0, 20])
        self.assertEqual(list(self.panel.constraints.handles), [49])
        self.assertEqual(FreeCADGui.Selection.getSelection(), [])
        self.finished()
        press("Ok")
        found = vertices(net)
        self.assertEqual(found[[0, 45]].tobytes(), start[[0, 45]].tobytes())
        self.assertEqual((list(net.FixedVertices), list(net.Handles)), ([0, 45], [49]))
        kept, again = self.replayed(net)
        self.assertEqual(again.tobytes(), kept.tobytes())

    def test_edges_and_faces(self):
        net = self.net()
        rim = vertices(net)[:9]
        document = net.Document
        line = document.addObject("Part::Feature", "Line")
        curve = Part.BSplineCurve()
        curve.interpolate([FreeCAD.Vector(*point) for point in rim])
        line.Shape = curve.toShape()
        box = document.addObject("Part::Box", "Box")
        box.Placement.Base.x = -1e6
        document.recompute()
        self.opened(net)
        self.picking("glide")
        FreeCADGui.Selection.addSelection(document.Name, "Line", "Edge1")
        FreeCADGui.Selection.addSelection(document.Name, "Box", "Edge1")
        FreeCADGui.Selection.addSelection(document.Name, net.Name)
        wait()
        self.assertEqual(self.panel.constraints.glide, [(line, "Edge1")])
        self.assertIn("no boundary vertex lies within", self.said.pop())
        FreeCADGui.Selection.clearSelection()
        self.picking("near")
        FreeCADGui.Selection.addSelection(document.Name, "Line", "Edge1")
        self.assertIn("choose a face", self.said.pop())
        FreeCADGui.Selection.addSelection(document.Name, "Box", "Face6")
        self.assertEqual(self.panel.constraints.close_to, [(box, "Face6")])
        self.assertEqual(self.panel.constraints.list.count(), 2)
        self.panel.constraints.list.item(1).setSelected(True)
        self.panel.constraints.remove.click()
        self.assertEqual(self.panel.constraints.close_to, [])
        self.finished()
        press("Ok")
        misses = [line.Shape.distToShape(Part.Vertex(p))[0] for p in net.Vertices[:9]]
        self.assertLess(max(misses), 2.0)
        kept, again = self.replayed(net)
        self.assertEqual(again.tobytes(), kept.tobytes())
        wait()
        FreeCADGui.Selection.addSelection(document.Name, "Box", "Face5")
        self.assertEqual(self.panel.constraints.close_to, [])

    def test_leaving_while_picking(self):
        for ending in ("Cancel", "document", "object"):
            with self.subTest(ending):
                net = self.net()
                self.opened(net)
                hand = Hand(net.Document)
                pixels = hand.pixels(vertices(net))
                self.picking("handle")
                hand.press(pixels[40])
                hand.move(pixels[40] + [9, 9])
                if ending == "Cancel":
                    press("Cancel")
                elif ending == "document":
                    FreeCAD.closeDocument(net.Document.Name)
                else:
                    net.Document.removeObject(net.Name)
                wait()
                self.assertFalse(FreeCADGui.Control.activeDialog())
                self.assertIsNone(self.panel.constraints._mouse)
                tools.close_all()

    def test_wild_use(self):
        random = np.random.default_rng(3)
        net = self.net(rows=20, columns=20)
        document = net.Document
        for _ in range(4):
            panel = self.opened(net)
            for _ in range(12):
                act = random.integers(7)
                if act < 4:
                    buttons = (
                        panel.start_button,
                        panel.stop_button,
                        panel.step_button,
                        panel.undo_button,
                    )
                    buttons[act].click()
                elif act == 4:
                    getattr(document, random.choice(["undo", "redo"]))()
                    if document.getObject("Net") is None:
                        document.redo()
                elif act == 5:
                    panel.net_type.choose(random.choice(["principal", "orthogonal", "circular"]))
                wait(seconds=float(random.choice([0.0, 0.05, 0.2])))
                if not FreeCADGui.Control.activeDialog():
                    panel = self.opened(document.Net)
            press(random.choice(["Ok", "Cancel"]))
            net = document.Net
            np.testing.assert_allclose(self.shown(net), vertices(net), rtol=1e-6, atol=1e-2)
        self.assertFalse([words for words in self.errors + self.said if "Traceback" in words])
