"""Nets that were moved away from their source, and what happens when that changes, no window."""

import json
import time
from unittest import mock

import numpy as np
import ortho_suite_tools as tools
from ortho_aligned_tools import roof
from ortho_suite_cases import DocumentCase, StructureCase

from freecad_ortho import api
from freecad_ortho.documents.common import transaction
from freecad_ortho.objects import flat_patterns, outdated, structure
from solver.errors import InputError


class TestOutdated(DocumentCase):
    """A net that was moved away from its source knows when that has changed."""

    def test_marked_once_its_source_has_changed_until_it_is_optimised_again(self):
        source = api.add_primitive("cylinder", sampling=(7, 6), document=self.document)
        net = api.change_net(source, "subdivide")
        api.optimise_net(net, net="orthogonal")
        beams = api.add_beams(net)
        made = api.change_net(net, "medial mesh")
        points = tools.vertices(net)
        self.assertFalse(net.Outdated)
        with transaction(self.document, "Larger"):
            source.Radius = 2 * source.Radius.Value
            self.document.recompute()
        following = (net, beams, made)
        for item in following:
            self.assertIn("Touched", item.State, item.Label)
        self.assertEqual(tools.vertices(net).tobytes(), points.tobytes())
        self.assertTrue(net.Outdated and json.loads(net.LastReport)["outdated"])
        for said in (beams.Notice, json.loads(beams.Report)["messages"][-1], made.Remarks[-1]):
            self.assertIn(f"{net.Label} is outdated", said)
        self.document.undo()
        self.assertEqual((net.Outdated, beams.Notice), (False, ""))
        self.document.redo()
        labels = [item.Name for item in following]
        self.reopened("outdated.FCStd")
        net, beams, made = (self.document.getObject(name) for name in labels)
        for item in (net, beams, made):
            self.assertIn("Touched", item.State, item.Label)
        self.document.recompute()
        self.assertIn("Touched", net.State)
        api.optimise_net(net, net="orthogonal")
        self.assertGreater(np.ptp(tools.vertices(net)[:, 0]), 1.5 * np.ptp(points[:, 0]))
        self.assertEqual((net.Outdated, beams.Notice, made.Remarks), (False, "", []))
        self.assertNotIn("outdated", json.loads(net.LastReport))
        for item in (net, beams, made):
            self.assertEqual(item.State, ["Up-to-date"], item.Label)

    def test_refused_settings_leave_an_outdated_net_as_it_was(self):
        net = api.change_net(
            api.add_primitive("cylinder", sampling=(7, 6), document=self.document), "subdivide"
        )
        api.optimise_net(net, net="orthogonal")
        radius = net.Nets[0].Radius.Value
        net.Nets[0].Radius = radius / 2
        self.document.recompute()
        points = tools.vertices(net)
        with self.assertRaises(InputError):
            api.optimise_net(net, fix=[10**6])
        self.assertEqual(tools.vertices(net).tobytes(), points.tobytes())
        self.assertTrue(net.Outdated)
        net.Nets[0].Radius = radius
        self.document.recompute()
        self.assertEqual((net.Outdated, net.State), (False, ["Up-to-date"]))


class TestAgain(DocumentCase):
    """An upstream change, and nets that are optimised again after it."""

    def aligned(self, **settings):
        """A sheet, an exact net on it, beams on that, and an exact net made from that one."""
        sheet = self.shape(roof())
        net = api.net_along_curvature(sheet, edge=1000.0)
        api.optimise_net(net, net="principal", close_to=net, **settings)
        return sheet, net

    def raise_roof(self, sheet):
        sheet.Shape = roof(rise=1200.0)
        self.document.recompute()

    def assert_near(self, net, sheet):
        """The net is exact and follows its faces."""
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        height = sheet.Shape.BoundBox.ZLength
        self.assertAlmostEqual(np.ptp(tools.vertices(net)[:, 2]) / height, 1.0, delta=0.25)

    def test_another_surface_and_another_edge_length(self):
        sheet, net = self.aligned()
        beams = api.add_beams(net)
        self.raise_roof(sheet)
        self.assertTrue(net.Outdated)
        before, volume, steps = tools.vertices(net), beams.Shape.Volume, self.document.UndoCount
        settings = net.NetType, net.CloseTo
        (outcome,) = api.optimise_again(net)
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.assertEqual((net.NetType, net.CloseTo), settings)
        self.assertEqual(outcome.report.status, "converged")
        self.assert_near(net, sheet)
        self.assertGreater(np.ptp(tools.vertices(net)[:, 2]), 1.15 * np.ptp(before[:, 2]))
        self.assertEqual((net.Outdated, beams.Notice, net.FollowSource), (False, "", False))
        self.assertNotEqual(beams.Shape.Volume, volume)
        self.document.undo()
        self.assertEqual(tools.vertices(net).tobytes(), before.tobytes())
        self.document.redo()
        count = len(net.Faces)
        net.Edge = 1400.0
        self.document.recompute()
        self.assertTrue(net.Outdated)
        self.assertEqual(len(net.Faces), count)
        api.optimise_again(document=self.document)
        self.assertLess(len(net.Faces), 0.7 * count)
        self.assert_near(net, sheet)
        self.assertEqual(api.optimise_again(net), [])

    def test_at_once_where_that_is_asked_for(self):
        sheet, net = self.aligned()
        beams = api.add_beams(net)
        net.OptimiseAgain = True
        volume = beams.Shape.Volume
        self.raise_roof(sheet)
        self.assertFalse(net.Outdated)
        self.assert_near(net, sheet)
        self.assertNotIn("outdated", json.loads(net.LastReport))
        self.assertNotEqual(beams.Shape.Volume, volume)
        for item in (net, beams):
            self.assertEqual(item.State, ["Up-to-date"], item.Label)
        count = len(net.Faces)
        api.change_source(net, edge=1300.0)
        self.assertLess(len(net.Faces), 0.8 * count)
        self.assert_near(net, sheet)
        self.assertEqual((net.FollowSource, net.Outdated), (False, False))
        self.assertEqual(beams.State, ["Up-to-date"])
        by_hand = tools.vertices(net)
        sheet.Shape = roof()
        net.OptimiseAgain = False
        self.document.recompute()
        self.raise_roof(sheet)
        # Back where it was last optimised it is not outdated, and is as it was.
        self.assertFalse(net.Outdated)
        self.assertEqual(tools.vertices(net).tobytes(), by_hand.tobytes())

    def test_nets_that_stand_on_each_other_follow_in_their_order(self):
        source = api.add_primitive("cylinder", sampling=(5, 4), document=self.document)
        first = api.change_net(source, "subdivide")
        api.optimise_net(first, net="orthogonal")
        second = api.change_net(first, "transform", move=("9 m", 0, 0))
        api.optimise_net(second, net="orthogonal")
        with transaction(self.document, "Larger"):
            source.Radius = 2 * source.Radius.Value
            self.document.recompute()
        self.assertEqual((first.Outdated, second.Outdated), (True, False))
        steps = self.document.UndoCount
        self.assertEqual(len(api.optimise_again(document=self.document)), 2)
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.assertEqual((first.Outdated, second.Outdated), (False, False))
        widths = [np.ptp(tools.vertices(net)[:, 0]) for net in (first, second)]
        self.assertAlmostEqual(widths[0], widths[1], delta=1.0)

    def test_numbers_of_vertices_that_are_no_more_are_refused(self):
        sheet, net = self.aligned(fix=[0, 5])
        net.Edge = 1400.0
        self.document.recompute()
        before = tools.vertices(net).tobytes()
        with self.assertRaisesRegex(InputError, "its fixed vertices are numbers of those before"):
            api.optimise_again(net)
        self.assertEqual((tools.vertices(net).tobytes(), net.Outdated), (before, True))
        with self.assertRaisesRegex(InputError, "expected a Net"):
            api.optimise_again(sheet)
        net.OptimiseAgain = True
        self.document.recompute()
        self.assertIn("numbers of those before", net.getStatusString())
        api.set_net(net, fix="none")
        self.document.recompute()
        self.assertEqual((net.Outdated, net.State), (False, ["Up-to-date"]))


class TestLongOnes(StructureCase):
    """Shapes that take longer than the user allows wait; here every shape does."""

    def setUp(self):
        super().setUp()
        self.beams = api.add_beams(self.net)
        self.panels = api.add_panels(self.net, beams=self.beams)
        self.flat = api.add_flat_patterns(self.panels)
        self.at_once(0.0)

    def at_once(self, seconds):
        tools.follow_at_once(self, seconds)

    def shapes(self):
        built = (self.beams, self.panels, self.flat)
        return [(item.Shape.Volume, item.Shape.Length) for item in built]

    def lifted(self):
        """Drag the middle of the net, which changes everything that stands on it."""
        x, y, z = self.net.Vertices[17]
        api.drag_net(self.net, {17: (x, y, z + 300)})

    def waiting(self):
        return [item.Name for item in outdated.waiting(self.document)]

    def test_a_drag_waits_for_none_of_them(self):
        before, steps = self.shapes(), self.document.UndoCount
        with (
            mock.patch.object(structure, "rebuild", side_effect=AssertionError),
            mock.patch.object(flat_patterns, "rebuild", side_effect=AssertionError),
        ):
            self.lifted()
            self.lifted()
        self.assertEqual(self.shapes(), before)
        self.assertEqual(self.waiting(), ["Beams", "Panels", "FlatPatterns"])
        for item in (self.beams, self.panels, self.flat):
            self.assertIn("Touched", item.State)
        self.assertEqual(len(api.update_structures(self.document)), 3)
        self.assertEqual(self.waiting(), [])
        for shown, old in zip(self.shapes(), before, strict=True):
            self.assertNotEqual(shown, old)
        self.assertEqual(self.document.UndoCount, steps + 3)
        waited = self.shapes()
        self.at_once(1000.0)
        for item in (self.beams, self.panels, self.flat):
            item.touch()
        self.document.recompute()
        self.assertEqual(self.shapes(), waited)

    def test_quick_ones_follow_at_once(self):
        self.at_once(1000.0)
        before = self.shapes()
        self.lifted()
        self.assertEqual(self.waiting(), [])
        for shown, old in zip(self.shapes(), before, strict=True):
            self.assertNotEqual(shown, old)

    def test_undo_takes_the_mark_back(self):
        before = self.shapes()
        self.lifted()
        self.document.undo()
        self.document.recompute()
        self.assertEqual((self.waiting(), self.shapes()), ([], before))
        self.document.redo()
        self.assertEqual(self.waiting(), ["Beams", "Panels", "FlatPatterns"])

    def test_touched_is_not_changed(self):
        self.beams.touch()
        self.document.recompute()
        self.assertEqual(self.waiting(), [])

    def test_a_setting_that_cannot_be_used_is_said_at_once(self):
        self.beams.Thickness = 0
        self.document.recompute()
        self.assertIn("thickness", self.beams.getStatusString())

    def test_what_stands_on_one_that_waits_waits_with_it(self):
        self.at_once(1000.0)
        self.beams.AutomaticUpdate = False
        self.lifted()
        self.assertEqual(self.waiting(), ["Beams", "Panels", "FlatPatterns"])

    def test_a_document_that_was_just_opened_does_not_wait_either(self):
        self.lifted()
        document = self.reopened("long.FCStd")
        self.assertEqual(len(outdated.waiting(document)), 3)
        self.assertIn("Touched", document.Beams.State)
        # Twelve edges a beam say what is to be expected before it was ever built here.
        edges = len(document.Beams.Shape.Edges)
        self.at_once(1e-3 * edges)
        document.Beams.Thickness = 13
        document.recompute()
        self.assertFalse(document.Beams.Outdated)
        self.assertGreater(document.Beams.Proxy.seconds, 0)

    def test_building_is_timed(self):
        self.at_once(1000.0)
        start = time.perf_counter()
        self.beams.Thickness = 14
        self.document.recompute()
        self.assertLess(0.0, self.beams.Proxy.seconds)
        self.assertLess(self.beams.Proxy.seconds, time.perf_counter() - start)
