"""What FreeCAD saves by itself every minute can be opened after a crash. Run by FreeCAD."""

import unittest
from pathlib import Path

import FreeCAD
import ortho_suite_tools as tools
from ortho_suite_tools import wait

from freecad_ortho import api

# The runner's preferences ask for one minute, the shortest that FreeCAD knows.
SECONDS = 100


class TestRecovery(unittest.TestCase):
    def tearDown(self):
        tools.close_all()

    def test_what_was_saved_by_itself_opens_whole(self):
        document = FreeCAD.newDocument("Crash")
        net = api.import_net(tools.wavy_mesh(), document)
        api.optimise_net(net)
        beams = api.add_beams(net)
        points, volume = tools.vertices(net), beams.Shape.Volume
        parts = list(beams.PartNames)

        def saved():
            return [path for path in Path(document.TransientDir).glob("*.fcstd")]

        self.assertTrue(wait(saved, SECONDS), "nothing was saved")
        wait(seconds=3)
        copy = tools.SCRATCH / "recovered.FCStd"
        copy.write_bytes(saved()[0].read_bytes())
        FreeCAD.closeDocument(document.Name)
        again = FreeCAD.openDocument(str(copy))
        self.assertEqual(tools.vertices(again.Net).tobytes(), points.tobytes())
        self.assertLess(abs(again.Beams.Shape.Volume / volume - 1), 1e-12)
        self.assertEqual(list(again.Beams.PartNames), parts)
        again.recompute()
        self.assertLess(abs(again.Beams.Shape.Volume / volume - 1), 1e-9)
        # It is a whole document again, not a picture of one.
        again.Beams.Height = 400
        again.recompute()
        self.assertGreater(again.Beams.Shape.Volume, 1.5 * volume)
