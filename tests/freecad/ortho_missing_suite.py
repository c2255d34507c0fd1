"""A saved document where the whole add-on, or cadquery only, is missing. Run by FreeCAD."""

import importlib.util
import sys
import unittest

import FreeCAD
import ortho_suite_tools as tools


class _Blocked:
    """An import hook under which cadquery is not installed."""

    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] == "cadquery":
            raise ModuleNotFoundError("No module named 'cadquery'", name="cadquery")
        return None


class TestSavedDocument(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.openDocument(str(tools.SCRATCH / "structure.FCStd"))
        self.volume = float((tools.SCRATCH / "volume.txt").read_text(encoding="utf-8"))

    def tearDown(self):
        tools.close_all()

    def test_without_the_add_on_shapes_are_there(self):
        if importlib.util.find_spec("freecad_ortho") is not None:
            self.skipTest("this is the run with the add-on")
        self.assertEqual(self.document.Beams.Shape.Volume, self.volume)

    def test_without_cadquery_shapes_are_there_and_stay(self):
        if importlib.util.find_spec("freecad_ortho") is None:
            self.skipTest("this is the run without the add-on")
        self.assertNotIn("cadquery", sys.modules)
        sys.meta_path.insert(0, _Blocked())
        beams = self.document.Beams
        self.assertEqual(beams.Shape.Volume, self.volume)
        beams.Thickness = 14
        self.document.recompute()
        self.assertIn("'cadquery' is missing", beams.getStatusString())
        self.assertEqual(beams.Shape.Volume, self.volume)
