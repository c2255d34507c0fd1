"""Live editing in FreeCAD's window: handles, drags, undo, and everything that can go wrong."""

import json
import time
from unittest import mock

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
from ortho_editing_tools import CORNERS, MIDDLE, SIDE, EditingCase
from ortho_suite_tools import vertices, wait
from pivy import coin
from PySide import QtCore, QtGui

from freecad_ortho import api, convert
from freecad_ortho.objects import structure
from solver.analysis import measures


class TestDragging(EditingCase):
    def test_a_drag_is_one_undo_step_and_one_line_that_replays(self):
        net = self.edited()
        start, steps = vertices(net), net.Document.UndoCount
        end = self.held(net)
        self.assertEqual(set(self.editing.handles), {*CORNERS, MIDDLE})
        self.assertGreater(np.abs(self.shown(net) - start).max(), 100)
        self.assertEqual(vertices(net).tobytes(), start.tobytes())
        self.settled(end)
        self.assertEqual(net.Document.UndoCount, steps + 1)
        kept = vertices(net)
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        self.assertGreater(np.linalg.norm(kept[MIDDLE] - start[MIDDLE]), 500)
        # Where the middle was drawn to is where it is, nearly; the corners have held exactly.
        held = list(CORNERS)
        np.testing.assert_allclose(kept[held], start[held], rtol=0, atol=1e-9)
        self.assertEqual([line.count("drag_net") for line in self.lines], [1])
        net.Document.undo()
        wait()
        self.assertEqual(vertices(net).tobytes(), start.tobytes())
        self.replay()
        edge = convert.quad_mesh(net).mean_edge
        self.assertLess(np.abs(vertices(net) - kept).max(), 1e-5 * edge)
        wait()
        self.panel.reject()
        self.assertLeft(net)

    def test_handles_persist_with_the_net(self):
        net = self.edited()
        self.settled(self.held(net))
        self.panel.reject()
        self.assertLeft(net)
        self.assertEqual(set(net.Handles), {*CORNERS, MIDDLE})
        places = convert.array(net.HandlePlaces)
        np.testing.assert_allclose(places, vertices(net)[list(net.Handles)], rtol=0, atol=1e-9)
        name = net.Name
        path = str(tools.SCRATCH / "handles.FCStd")
        net.Document.saveAs(path)
        FreeCAD.closeDocument(net.Document.Name)
        net = FreeCAD.openDocument(path).getObject(name)
        self.enter(net)
        self.assertEqual(set(self.editing.handles), {*CORNERS, MIDDLE})
        self.editing.click(MIDDLE, False)
        self.editing.remove([MIDDLE])
        self.panel.reject()
        self.assertLeft(net)
        self.assertEqual(set(net.Handles), set(CORNERS))
        self.assertEqual(net.Document.UndoCount, 1)
        net.Document.undo()
        self.assertEqual(set(net.Handles), {*CORNERS, MIDDLE})

    def test_letting_go_waits_for_no_long_structure(self):
        net = api.import_net(tools.wavy_mesh(rows=SIDE, columns=SIDE))
        api.optimise_net(net)
        beams = api.add_beams(net)
        tools.follow_at_once(self, 0.0)
        volume = beams.Shape.Volume
        self.enter(net)
        end = self.held(net)
        with mock.patch.object(structure, "rebuild", side_effect=AssertionError):
            self.settled(end)
        self.assertEqual((beams.Outdated, beams.Shape.Volume), (True, volume))
        self.panel.reject()
        self.assertLeft(net)
        self.assertIn("Touched", beams.State)
        self.assertTrue(FreeCADGui.isCommandActive("Ortho_UpdateStructures"))
        steps = net.Document.UndoCount
        # As a click on FreeCAD's Refresh, which is enabled where something is marked.
        (refresh,) = FreeCADGui.Command.get("Std_Refresh").getAction()
        refresh.setEnabled(True)
        refresh.trigger()
        wait()
        self.assertFalse(beams.Outdated)
        self.assertNotEqual(beams.Shape.Volume, volume)
        self.assertEqual(net.Document.UndoCount, steps + 1)
        self.assertTrue(self.lines[-1].endswith("freecad_ortho.api.update_structures()"))
        self.assertFalse(FreeCADGui.isCommandActive("Ortho_UpdateStructures"))
        self.assertEqual(self.errors, [])

    def test_under_the_mouse_and_along_an_axis(self):
        net = self.edited()
        start = vertices(net)[MIDDLE]
        end = self.held(net, way=(40, 50))
        place = self.editing.handles[MIDDLE]
        np.testing.assert_allclose(self.hand.pixels([place])[0], end, atol=2)
        self.hand.key(coin.SoKeyboardEvent.Z)
        self.hand.move(end)
        way = self.editing.handles[MIDDLE] - start
        np.testing.assert_allclose(way[:2], 0, atol=1e-9)
        self.assertGreater(abs(way[2]), 100)
        self.hand.key(coin.SoKeyboardEvent.S)
        self.assertEqual(self.panel.mode.word, "surface")
        self.hand.key(coin.SoKeyboardEvent.X)
        self.hand.move(end)
        way = self.editing.handles[MIDDLE] - start
        np.testing.assert_allclose(way[1:], 0, atol=1e-9)

    def test_on_the_surface(self):
        net = self.edited()
        start = convert.quad_mesh(net)
        self.hand.key(coin.SoKeyboardEvent.S)
        self.held(net, way=(30, 10))
        place = self.editing.handles[MIDDLE]
        from solver.mesh.closest import TriangleSurface

        feet, _ = TriangleSurface.from_quads(start).closest(place[None])
        self.assertLess(np.linalg.norm(feet[0] - place), 1e-6 * start.mean_edge)
        self.assertGreater(np.linalg.norm(place - start.vertices[MIDDLE]), 100)

    def test_several_move_together_and_numbers_work(self):
        net = self.edited()
        start, pair = vertices(net), [MIDDLE, MIDDLE + 1]
        for vertex in (*CORNERS, *pair):
            self.hand.click(self.pixels[vertex], ctrl=True)
        self.hand.click(self.pixels[pair[0]])
        self.hand.click(self.pixels[pair[1]], ctrl=True)
        self.assertEqual(self.editing.chosen, pair)
        self.assertAlmostEqual(self.panel.place[2].millimetres, start[pair[1], 2], delta=0.01)
        self.panel.place[2].millimetres = start[pair[1], 2] + 700
        self.panel.move.click()
        self.assertTrue(wait(lambda: not self.editing.busy, 60))
        rise = vertices(net)[pair] - start[pair]
        np.testing.assert_allclose(rise[:, 2], 700, atol=150)
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        self.hand.key(coin.SoKeyboardEvent.KEY_DELETE)
        self.assertEqual(set(self.editing.handles), set(CORNERS))

    def test_a_frame_chooses_what_is_in_it(self):
        net = self.edited()
        low, high = self.pixels.min(axis=0) - 5, self.pixels.max(axis=0) + 5
        self.hand.press(low, shift=True)
        self.hand.move(high, shift=True)
        self.hand.release(high, shift=True)
        self.assertEqual(len(self.editing.chosen), len(net.Vertices))

    def test_clicks_select_nothing_and_fixed_vertices_stay(self):
        net = self.edited(fix=[0])
        self.hand.click(self.pixels[0])
        self.assertEqual(self.editing.handles, {})
        self.assertIn("fixed", self.panel.message.text())
        self.hand.click(self.pixels[MIDDLE])
        self.assertEqual(FreeCADGui.Selection.getSelection(), [])
        self.panel.reject()
        wait()
        self.hand.press(self.pixels[MIDDLE])
        self.assertFalse(self.editing.busy)
        self.hand.release(self.pixels[MIDDLE])
        self.assertLeft(net)


class TestLeaving(EditingCase):
    def test_esc_puts_back(self):
        net = self.edited()
        steps = net.Document.UndoCount
        end = self.held(net)
        self.hand.key(coin.SoKeyboardEvent.ESCAPE)
        wait()
        np.testing.assert_allclose(self.shown(net), vertices(net), rtol=1e-6, atol=1e-2)
        self.assertFalse(self.editing.busy)
        self.hand.release(end)
        wait()
        self.assertEqual(net.Document.UndoCount, steps)

    def test_closing_in_the_middle_of_a_drag(self):
        for ending in ("panel", "unset", "dialog", "document", "object", "settling"):
            with self.subTest(ending):
                net = self.edited()
                document, stored = net.Document, vertices(net)
                end = self.held(net)
                if ending == "panel":
                    self.panel.reject()
                elif ending == "unset":
                    FreeCADGui.getDocument(document.Name).resetEdit()
                elif ending == "dialog":
                    FreeCADGui.Control.closeDialog()
                elif ending == "document":
                    FreeCAD.closeDocument(document.Name)
                elif ending == "object":
                    document.removeObject(net.Name)
                else:
                    self.hand.release(end)
                    self.panel.reject()
                left = net if ending in ("panel", "unset", "dialog", "settling") else None
                self.assertLeft(left)
                if left is not None:
                    self.assertEqual(vertices(net).tobytes(), stored.tobytes())
                tools.close_all()
        self.assertEqual(self.errors, [])

    def test_undo_and_redo_during_a_drag(self):
        net = self.edited()
        after = vertices(net)
        end = self.held(net)
        net.Document.undo()
        wait()
        self.assertFalse(self.editing.busy)
        self.hand.move(end)
        self.hand.release(end)
        np.testing.assert_allclose(self.shown(net), vertices(net), rtol=1e-6, atol=1e-2)
        self.assertFalse(np.array_equal(vertices(net), after))
        net.Document.redo()
        wait()
        self.assertEqual(vertices(net).tobytes(), after.tobytes())
        np.testing.assert_allclose(self.shown(net), after, rtol=1e-6, atol=1e-2)

    def test_command_and_double_click_are_the_same(self):
        net = api.import_net(tools.wavy_mesh())
        FreeCADGui.runCommand("Ortho_EditNet")
        wait()
        self.assertEqual(FreeCADGui.ActiveDocument.getInEdit().Object, net)
        tools.press("Close")
        self.assertIsNone(FreeCADGui.ActiveDocument.getInEdit())

    def test_only_one_panel_at_a_time(self):
        net = api.import_net(tools.wavy_mesh())
        FreeCADGui.runCommand("Ortho_Optimise")
        wait()
        self.assertFalse(net.ViewObject.Proxy.doubleClicked(net.ViewObject))
        self.assertIn("task panel", self.said[-1])
        tools.press("Cancel")

    def test_wild_mouse(self):
        random = np.random.default_rng(7)
        net = self.edited()
        keys = [coin.SoKeyboardEvent.X, coin.SoKeyboardEvent.S, coin.SoKeyboardEvent.KEY_DELETE]
        for _ in range(150):
            pixel = self.pixels[random.integers(len(self.pixels))] + random.normal(0, 6, 2)
            act = random.choice(["press", "move", "move", "release", "key", "undo", "wait"])
            if act == "key":
                self.hand.key(keys[random.integers(len(keys))])
            elif act == "undo":
                getattr(net.Document, random.choice(["undo", "redo"]))()
                if net.Document.getObject("Net") is None:
                    net.Document.redo()
            elif act == "wait":
                wait(seconds=0.05)
            else:
                ctrl, shift = random.random(2) < 0.2
                getattr(self.hand, act)(pixel, ctrl=bool(ctrl), shift=bool(shift))
            if not FreeCADGui.Control.activeDialog():
                wait()
                net = net.Document.Net
                self.enter(net)
        self.hand.release(self.pixels[0])
        wait(lambda: not self.editing.busy, 60)
        self.panel.reject()
        self.assertLeft(net)
        self.assertEqual([error for error in self.errors if "Traceback" in error], [])


class TestNets(EditingCase):
    """The five kinds of nets of the paper's figure 21, and sheets that keep their lengths."""

    def dragged(self, name, lift, **settings):
        path = tools.SHARED_MESHES / f"{name}.obj"
        if not path.is_file():
            self.skipTest(f"{path} is missing")
        net = api.import_net(str(path))
        outcome = api.optimise_net(net, **settings)
        self.assertEqual(outcome.report.status, "converged", outcome.report.message)
        points = vertices(net)
        middle = int(np.argmin(np.linalg.norm(points - points.mean(axis=0), axis=1)))
        self.enter(net)
        self.editing.click(middle, False)
        edge = convert.quad_mesh(net).mean_edge
        self.editing.move_to(points[middle] + [0, 0, lift * edge])
        self.assertTrue(wait(lambda: not self.editing.busy, 100))
        self.assertEqual(len(self.lines), 1)
        report = json.loads(net.LastReport)
        self.assertEqual(report["status"], "converged", report["message"])
        self.assertGreater(np.linalg.norm(vertices(net)[middle] - points[middle]), 0.3 * edge)
        self.panel.reject()
        self.assertLeft(net)
        return net

    def test_principal(self):
        self.dragged("heart", 0.6, net="principal")

    def test_minimal(self):
        self.dragged("knet1", 0.6, net="asymptotic")

    def test_cmc(self):
        self.dragged("cmc1", 0.6, net="cmc")

    def test_stress(self):
        self.dragged("quad_dome", 0.6, net="stress")

    def test_another_net_begins_on_the_edges(self):
        net = self.edited()
        api.set_net(net, net="asymptotic", diagonal=True)
        self.panel.net_type.choose("geodesic")
        self.assertEqual((net.NetType, net.DiagonalNet), ("geodesic", False))

    def test_developable_hardly_stretches_when_isometric(self):
        stretched = {}
        for weight in (None, 10.0):
            net = api.import_net(tools.bent_sheet())
            api.optimise_net(net, net="geodesic", isometry=weight)
            before = convert.quad_mesh(net)
            lifted = before.vertices[132] + [-1000.0, 0.0, 2000.0]
            api.drag_net(net, {0: before.vertices[0], 10: before.vertices[10], 132: lifted})
            after = convert.quad_mesh(net)
            self.assertLessEqual(measures.geodesic(after).max(), 1e-10)
            stretched[weight] = np.abs(after.edge_lengths / before.edge_lengths - 1).max()
        self.assertLess(stretched[10.0], 0.8 * stretched[None])


class TestSpeed(EditingCase):
    def test_redraws_a_second(self):
        """Mouse moves at 2,304 vertices, each with a solver step and a picture of it."""
        net = self.edited(side=48)
        middle = 48 * 24 + 24
        for corner in (0, 47, 48 * 47, 48 * 48 - 1):
            self.hand.click(self.pixels[corner], ctrl=True)
        start, drawn = self.pixels[middle], self.hand.redraws()
        self.hand.press(start)
        self.hand.move(start + [0, 4])
        # Wanted are 20 redraws, and they are had where this machine does nothing else. Where other
        # processes and an emulated graphics card take their share, drawing alone tells how much;
        # as that share changes from one second to the next, one try of four has to be good.
        for turn in range(4):
            wait(seconds=1.0)
            alone = self.plain_redraws(drawn)
            shown, steps = self.redraws_of_a_drag(start, drawn, back=turn % 2)
            words = (
                f"{shown:.0f} redraws a second at 2,304 vertices, "
                f"{steps:.0f} of them of a new step; {alone:.0f} when nothing changes"
            )
            FreeCAD.Console.PrintMessage(words + "\n")
            if shown > min(8, 0.3 * alone) and steps > min(5, 0.1 * alone):
                break
        else:
            self.fail(words)
        end = start + [0, 64]
        self.settled(end)
        self.assertLessEqual(max(tools.faults(net)), 1e-10)

    def redraws_of_a_drag(self, start, drawn, back):
        """How often a second the picture, and a step, are drawn in 3 s of a drag."""
        # A mouse tells where it is some 100 times a second, whatever the program is doing.
        moves = iter(np.linspace(*((65, 5) if back else (5, 65)), 300))
        mouse = QtCore.QTimer()
        mouse.timeout.connect(lambda: self.hand.move(start + [0, next(moves)]))
        begin, shown, steps = time.perf_counter(), len(drawn), len(self.editing.live.frames)
        mouse.start(10)
        wait(seconds=3.0)
        mouse.stop()
        seconds = time.perf_counter() - begin
        return (
            (len(drawn) - shown) / seconds,
            (len(self.editing.live.frames) - steps) / seconds,
        )

    def plain_redraws(self, drawn):
        """How often a second the picture is drawn while nobody moves anything."""
        begin, before = time.perf_counter(), len(drawn)
        while time.perf_counter() - begin < 1.0:
            self.hand.view.redraw()
            QtGui.QApplication.processEvents()
        return (len(drawn) - before) / (time.perf_counter() - begin)
