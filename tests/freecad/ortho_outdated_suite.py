"""Nets that were moved away from their source, and what happens when that changes, no window."""

import json

import numpy as np
import ortho_suite_tools as tools
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
