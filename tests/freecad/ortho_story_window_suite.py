"""The whole story in FreeCAD's window, as docs/tutorial.md tells it. Run by FreeCAD."""

import json

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
from ortho_suite_cases import WindowCase
from ortho_suite_tools import vertices, wait
from ortho_tutorial import Tutorial, corners, state

from freecad_ortho import convert
from solver.analysis.advisor import advise


class StoryCase(WindowCase):
    def setUp(self):
        super().setUp()
        self.tutorial = Tutorial()

    def undone_and_redone(self, steps):
        """Undo everything, redo everything: the same document to the last bit."""
        document = FreeCAD.ActiveDocument
        expected = state(document)
        self.assertEqual(document.UndoCount, steps)
        for _ in range(steps):
            document.undo()
        wait()
        undone = state(document)
        for _ in range(steps):
            document.redo()
        wait()
        self.assertEqual(state(document), expected)
        return undone

    def reopened(self):
        """Save, close, open, recompute: the same settings, shapes to the digits of the file."""
        document = FreeCAD.ActiveDocument
        expected = state(document)
        path = str(tools.SCRATCH / f"story-{document.Name}.FCStd")
        document.saveAs(path)
        FreeCAD.closeDocument(document.Name)
        again = FreeCAD.openDocument(path)
        wait()
        self.assertSame(state(again), expected)
        again.recompute()
        self.assertSame(state(again), expected)

    def assertSame(self, found, expected):
        (settings, shapes), (wanted_settings, wanted_shapes) = found, expected
        self.assertEqual(set(settings), set(wanted_settings))
        for key, value in wanted_settings.items():
            if isinstance(value, float):
                self.assertAlmostEqual(settings[key], value, delta=1e-12 * abs(value), msg=key)
            else:
                self.assertEqual(settings[key], value, key)
        self.assertEqual(set(shapes), set(wanted_shapes))
        for name, numbers in wanted_shapes.items():
            np.testing.assert_allclose(shapes[name], numbers, rtol=1e-9, atol=1e-6)

    def exported(self, name):
        folder = tools.SCRATCH / name
        self.tutorial.export(folder)
        files = {file.name for file in folder.iterdir()}
        expected = {"structure.step", "flat.dxf", "parts.csv", "report.json", "report.html"}
        self.assertLessEqual(expected, files)


class TestTutorial(StoryCase):
    def test_surface(self):
        story = self.tutorial
        story.open_surface()
        story.align(1200.0)
        list(story.optimise(stop=False))
        document, net = story.document, story.net
        report = json.loads(net.LastReport)
        self.assertEqual((report["net"], report["status"]), ("principal", "converged"))
        self.assertLess(report["off_surface"]["max"], 50)
        story.structure("Beams", "trimmed-beams")
        story.structure("Panels", "trimmed")
        # Lines as far apart as was asked for, over all of the surface.
        faces = document.Objects[0].Shape.Area / 1200**2
        self.assertAlmostEqual(len(document.Panels.PartNames) / faces, 1.0, delta=0.15)
        self.assertGreater(len(document.Beams.PartNames), 1.8 * faces)
        self.assertIs(document.Panels.OnBeams, document.Beams)
        self.assertEqual(self.errors, [])
        settings, _ = self.undone_and_redone(4)
        self.assertEqual({name for name, _ in settings}, {document.Objects[0].Name})

    def test_roof(self):
        story = self.tutorial
        story.open_mesh()
        net, start = story.net, vertices(story.net)
        self.assertEqual(len(net.Faces), 4 * 480)
        self.assertGreater(min(tools.faults(net)), 1e-2)
        best = advise(convert.quad_mesh(net))[0]
        self.assertEqual((best.net, best.possible), ("principal", True))
        story.check()
        steps = story.optimise()
        next(steps)
        self.assertTrue(tools.button("Start").isEnabled())
        self.assertEqual(vertices(net).tobytes(), start.tobytes())
        next(steps)
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        before = vertices(net)
        middle = story.drag()
        way = vertices(net)[middle] - before[middle]
        self.assertGreater(way[2], 500)
        self.assertLess(np.abs(way[:2]).max(), 0.2 * way[2])
        held = corners(convert.quad_mesh(net))
        np.testing.assert_allclose(vertices(net)[held], before[held], rtol=0, atol=1e-9)
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        story.colour()
        self.assertEqual(net.ColourMap, "Gauss curvature")
        story.structure("Beams", "beams")
        story.structure("Panels", "panels")
        document = story.document
        self.assertEqual(len(document.Beams.PartNames), 1004)
        self.assertEqual(len(document.Panels.PartNames), 480)
        self.assertIs(document.Panels.OnBeams, document.Beams)
        story.flat_patterns("sheets", on_sheets=True)
        flat = document.FlatPatterns
        self.assertEqual(len(flat.PartNames), 1484)
        self.assertGreater(flat.SheetCount, 1)
        self.exported("roof-files")
        self.assertEqual(self.errors, [])
        settings, shapes = self.undone_and_redone(7)
        self.assertEqual((settings, shapes), ({}, {}))
        self.reopened()

    def test_gridshell(self):
        story = self.tutorial
        story.open_gridshell()
        document = story.document
        lamellas = document.Lamellas
        self.assertEqual(set(lamellas.Verdicts), {"ok"})
        story.change_structure(lamellas, "lamellas", [("Width", 80.0)])
        self.assertEqual((lamellas.Width.Value, lamellas.Thickness.Value), (80.0, 4.0))
        self.assertTrue(all(name.startswith("L-") for name in lamellas.PartNames))
        self.assertEqual(len(lamellas.Shape.Solids), len(lamellas.PartNames))
        story.select(lamellas)
        story.flat_patterns("strips", on_sheets=False)
        self.assertEqual(document.FlatPatterns.SheetCount, 0)
        self.exported("gridshell-files")
        self.assertEqual(self.errors, [])
        _, shapes = self.undone_and_redone(2)
        self.assertEqual(set(shapes), {"Lamellas"})
        self.reopened()
