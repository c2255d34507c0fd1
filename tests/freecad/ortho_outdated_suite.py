"""Nets that were moved away from their source, and what happens when that changes, no window."""

import json

import numpy as np
import ortho_suite_tools as tools
from ortho_aligned_tools import roof
from ortho_suite_cases import DocumentCase

from freecad_ortho import api
from freecad_ortho.documents.common import transaction
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
