"""Documents without a window: objects, undo, saving, recomputing, errors. Run by FreeCAD."""

import json
import os
import sys
from pathlib import Path

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
from ortho_suite_cases import DocumentCase

from freecad_ortho import api, convert
from freecad_ortho.commands import open_file
from freecad_ortho.objects.net import VERSION, NetProxy
from solver.errors import InputError, OutputError
from solver.io.polygons import READERS, WRITERS


class TestNet(DocumentCase):
    def test_import_keeps_the_quads_and_every_bit(self):
        net = self.imported()
        loaded = api.read_mesh(net.SourceFile)
        self.assertEqual(np.array(net.Faces).reshape(-1, 4).tolist(), loaded.mesh.faces.tolist())
        self.assertEqual(tools.vertices(net).tobytes(), loaded.mesh.vertices.tobytes())

    def test_import_scales_to_millimetres(self):
        net = self.imported(unit="m", edge=1.5)
        self.assertEqual(net.Unit, "m")
        metres = api.read_mesh(net.SourceFile).mesh.vertices
        np.testing.assert_array_equal(tools.vertices(net), metres * 1000.0)
        feet = api.import_net(net.SourceFile, self.document, unit="ft")
        np.testing.assert_array_equal(tools.vertices(feet), metres * 304.8)

    def test_save_and_reopen_is_exact(self):
        net = self.imported()
        points = tools.vertices(net) * np.pi + [0.1, -1e-17, 1e9]
        convert.store_vertices(net, points)
        faces, name = list(net.Faces), net.Name
        net.ColourMap = "Orthogonality"
        net.LastReport = '{"net": "principal"}'
        again = self.reopened("exact.FCStd").getObject(name)
        self.assertEqual(tools.vertices(again).tobytes(), points.tobytes())
        self.assertEqual(list(again.Faces), faces)
        self.assertEqual(again.ColourMap, "Orthogonality")
        self.assertEqual(json.loads(again.LastReport), {"net": "principal"})
        self.assertIsInstance(again.Proxy, NetProxy)

    def test_migration_adds_what_is_missing_and_nothing_twice(self):
        net = self.imported()
        net.removeProperty("ColourMap")
        net.Version = 0
        for _ in range(2):
            net.Proxy.onDocumentRestored(net)
            self.assertEqual(net.ColourMap, "Target")
            self.assertEqual(net.Version, VERSION)
        self.assertEqual(net.PropertiesList.count("ColourMap"), 1)

    def test_colour_map_does_not_make_structures_stale(self):
        net = self.imported()
        beams = api.add_beams(net)
        net.ColourMap = "None"
        self.assertEqual(self.document.recompute(), 0)
        self.assertIn("Up-to-date", beams.State)

    def test_open_and_insert_through_the_file_menu(self):
        path = tools.wavy_mesh("opened")
        document = open_file.open(path)
        self.assertEqual([item.Label for item in document.Objects], ["opened"])
        self.assertTrue(open_file.insert(path, document.Name))
        self.assertEqual(len(document.Objects), 2)

    def test_the_file_menu_knows_every_format_and_prefers_freecads_own(self):
        ours = "freecad_ortho.commands.open_file"
        self.assertEqual(READERS.keys(), WRITERS.keys())
        for ending in READERS:
            for modules in (FreeCAD.getImportType(ending[1:]), FreeCAD.getExportType(ending[1:])):
                # The first one is taken where nobody can be asked.
                self.assertEqual((modules[-1], modules.count(ours)), (ours, 1), ending)
                self.assertGreater(len(modules), 1, ending)

    def test_every_format_comes_back_through_the_file_menu(self):
        net = self.imported(unit="m", edge=1.37)
        for ending in READERS:
            path = tools.SCRATCH / f"written{ending}"
            self.assertTrue(open_file.export([net], str(path)))
            again = api.read_mesh(path)
            np.testing.assert_array_equal(again.mesh.faces.ravel(), net.Faces)
            metres = api.read_mesh(net.SourceFile).mesh.vertices
            np.testing.assert_allclose(again.mesh.vertices, metres, rtol=1e-15)
            document = open_file.open(str(path))
            read = document.Objects[0]
            self.assertEqual((read.Label, list(read.Faces)), ("written", list(net.Faces)))
            self.assertTrue(open_file.insert(str(path), self.document.Name))
            FreeCAD.closeDocument(document.Name)

    def test_what_is_no_net_is_not_written(self):
        net = self.imported()
        beams = api.add_beams(net)
        path = tools.SCRATCH / "never.obj"
        for wrong in ([], [net, net], [beams]):
            self.assertFalse(open_file.export(wrong, str(path)))
        with self.assertRaisesRegex(InputError, "unit"):
            api.export_net(net, path, unit="yard")
        self.assertFalse(path.exists())

    def test_a_bad_file_leaves_no_document_behind(self):
        before = set(FreeCAD.listDocuments())
        triangle = tools.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.assertIsNone(open_file.open(triangle))
        self.assertEqual(set(FreeCAD.listDocuments()), before)


class TestOptimise(DocumentCase):
    def test_net_becomes_principal_and_undoes_in_one_step(self):
        net = self.imported()
        beams = api.add_beams(net)
        before, volume, steps = tools.vertices(net), beams.Shape.Volume, self.document.UndoCount
        outcome = api.optimise_net(net, net="principal")
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        self.assertEqual(json.loads(net.LastReport)["status"], outcome.report.status)
        after, volume_after = tools.vertices(net), beams.Shape.Volume
        self.assertNotEqual(volume_after, volume)
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.document.undo()
        self.assertEqual(tools.vertices(net).tobytes(), before.tobytes())
        self.assertEqual(beams.Shape.Volume, volume)
        self.document.redo()
        self.assertEqual(tools.vertices(net).tobytes(), after.tobytes())
        self.assertEqual(beams.Shape.Volume, volume_after)

    def test_beside_pyside(self):
        from PySide import QtCore

        self.assertTrue(QtCore.qVersion())
        net = self.imported()
        api.optimise_net(net)
        self.assertLessEqual(max(tools.faults(net)), 1e-10)

    def test_bad_settings_change_nothing(self):
        net = self.imported()
        before = tools.vertices(net)
        for settings in ({"net": "fishing"}, {"fix": "nothing at all"}, {"tolerance": -1.0}):
            with self.subTest(settings), self.assertRaises(InputError):
                api.optimise_net(net, **settings)
        self.assertEqual(tools.vertices(net).tobytes(), before.tobytes())
        with self.assertRaises(InputError):
            api.optimise_net(api.add_beams(net))


class TestStructure(DocumentCase):
    def test_one_valid_solid_a_part(self):
        net = self.imported()
        api.optimise_net(net)
        beams = api.add_beams(net, height="20 cm", thickness=12)
        panels = api.add_panels(net, beams=beams)
        mesh = convert.quad_mesh(net)
        for feature, count, letter in (
            (beams, len(mesh.connectivity.edges), "B"),
            (panels, len(mesh.faces), "P"),
        ):
            self.assertEqual(len(feature.Shape.Solids), count)
            self.assertTrue(all(solid.isValid() for solid in feature.Shape.Solids))
            self.assertEqual(feature.PartNames[0], f"{letter}0000")
            self.assertEqual(len(set(feature.PartNames)), count)
        self.assertEqual(beams.Height.Value, 200.0)

    def test_volumes_survive_the_crossing(self):
        net = self.imported()
        beams = api.add_beams(net)
        parts = api.fabricate(convert.quad_mesh(net), "beams").parts
        for solid, part in zip(beams.Shape.Solids, parts, strict=True):
            self.assertLess(abs(solid.Volume / part.volume - 1), 1e-9)

    def test_follows_net_and_settings(self):
        net = self.imported()
        beams = api.add_beams(net)
        panels = api.add_panels(net, beams=beams)
        names, volume, top = list(beams.PartNames), beams.Shape.Volume, panels.Shape.BoundBox.ZMax
        beams.Height = 400
        self.document.recompute()
        self.assertAlmostEqual(beams.Shape.Volume / volume, 2.0, delta=0.02)
        self.assertGreater(panels.Shape.BoundBox.ZMax, top + 50)
        volume = beams.Shape.Volume
        convert.store_vertices(net, tools.vertices(net) * 2.0)
        self.document.recompute()
        self.assertGreater(beams.Shape.Volume, 1.5 * volume)
        self.assertEqual(list(beams.PartNames), names)

    def test_each_undoes_in_one_step(self):
        net = self.imported()
        beams = api.add_beams(net)
        api.add_panels(net, beams=beams)
        self.assertEqual(len(self.document.Objects), 3)
        for left in (2, 1, 0):
            self.document.undo()
            self.assertEqual(len(self.document.Objects), left)
        for present in (1, 2, 3):
            self.document.redo()
            self.assertEqual(len(self.document.Objects), present)

    def test_bad_sizes_leave_the_document_as_it_was(self):
        net = self.imported()
        attempts = (
            lambda: api.add_beams(net, height=0),
            lambda: api.add_beams(net, thickness=-3),
            lambda: api.add_beams(net, height=None),
            lambda: api.add_beams(net, thickness="1 kg"),
            lambda: api.add_beams(net, thickness="thick"),
            lambda: api.add_beams(net, thickness=1e5),
            lambda: api.add_beams(net, offset="sideways"),
            lambda: api.add_panels(net, gap=1e5),
            lambda: api.add_panels(net, beams=net),
            lambda: api.add_panels(None),
        )
        for undo_mode in (1, 0):
            self.document.UndoMode = undo_mode
            steps = self.document.UndoCount
            for number, attempt in enumerate(attempts):
                with self.subTest(undo_mode=undo_mode, number=number):
                    with self.assertRaises(InputError):
                        attempt()
                    self.assertEqual(len(self.document.Objects), 1)
                    self.assertEqual(self.document.UndoCount, steps)

    def test_an_error_marks_the_object_and_keeps_its_shape(self):
        beams = api.add_beams(self.imported())
        volume = beams.Shape.Volume
        beams.Thickness = 1e5
        self.document.recompute()
        self.assertIn("Invalid", beams.State)
        self.assertIn("thickness", beams.getStatusString())
        self.assertEqual(beams.Shape.Volume, volume)
        beams.Thickness = 12
        self.document.recompute()
        self.assertIn("Up-to-date", beams.State)

    def test_what_a_structure_stands_on_must_be_a_net(self):
        net = self.imported()
        beams = api.add_beams(net)
        volume, faces = beams.Shape.Volume, list(net.Faces)
        box = self.document.addObject("Part::Box", "Box")

        def swap():
            beams.Net = box

        def remove():
            beams.Net = None

        def break_faces():
            net.Faces = faces[:-1]

        for damage, words in (
            (swap, "which is no net"),
            (remove, "stands on no net"),
            (break_faces, "expected four a face"),
        ):
            with self.subTest(words):
                damage()
                self.document.recompute()
                self.assertIn(words, beams.getStatusString())
                self.assertEqual(beams.Shape.Volume, volume)
                beams.Net, net.Faces = net, faces
                self.document.recompute()
                self.assertIn("Up-to-date", beams.State)

    def test_deleting_the_net_keeps_the_shape_and_undoes(self):
        net = self.imported()
        beams = api.add_beams(net)
        panels = api.add_panels(net, beams=beams)
        volumes = [beams.Shape.Volume, panels.Shape.Volume]
        self.document.openTransaction("Delete")
        self.document.removeObject(net.Name)
        self.document.commitTransaction()
        self.document.recompute()
        self.assertIn("stands on no net", beams.getStatusString())
        self.assertEqual([beams.Shape.Volume, panels.Shape.Volume], volumes)
        self.document.undo()
        self.document.recompute()
        self.assertEqual([item.State for item in (beams, panels)], [["Up-to-date"]] * 2)
        self.assertEqual(beams.Net.Name, net.Name)

    def test_reopened_documents_are_up_to_date(self):
        api.add_panels(self.imported(), beams=None)
        again = self.reopened("fresh.FCStd")
        self.assertEqual([item.State for item in again.Objects], [["Up-to-date"]] * 2)

    def test_saves_and_reopens_with_shapes(self):
        beams = api.add_beams(self.imported())
        volume, names = beams.Shape.Volume, list(beams.PartNames)
        # ortho_missing_suite opens this file too.
        again = self.reopened("structure.FCStd").Beams
        # FreeCAD writes shapes with fifteen digits.
        self.assertLess(abs(again.Shape.Volume / volume - 1), 1e-12)
        self.assertEqual(list(again.PartNames), names)
        self.assertEqual(again.Thickness.Value, 20.0)
        Path(tools.SCRATCH / "volume.txt").write_text(repr(again.Shape.Volume), encoding="utf-8")


class TestLimits(DocumentCase):
    def test_verdicts_follow_the_limits(self):
        beams = api.add_beams(self.imported())
        twist = max(json.loads(beams.Report)["beams"]["twist_max_deg"], 1e-9)
        self.assertEqual(beams.LimitTwist.Value, 1.0)
        beams.LimitTwist, beams.LimitGap = twist / 2, 0
        self.document.recompute()
        failing = [words for words in beams.Verdicts if words != "ok"]
        self.assertTrue(failing)
        self.assertTrue(all(words.startswith("twist ") for words in failing))
        beams.LimitTwist = 0
        self.document.recompute()
        self.assertEqual(set(beams.Verdicts), {"ok"})
        name = beams.Name
        again = self.reopened("limits.FCStd").getObject(name)
        self.assertEqual((again.LimitTwist.Value, again.LimitStraightness.Value), (0.0, 1.0))


class TestExport(DocumentCase):
    def test_files_name_every_part(self):
        net = self.imported()
        beams = api.add_beams(net)
        panels = api.add_panels(net, beams=beams)
        files = api.export_fabrication([beams, panels], tools.SCRATCH / "files")
        names = {"structure.step", "flat.dxf", "parts.csv", "report.json"}
        self.assertLessEqual(names, {path.name for path in files})
        listed = (tools.SCRATCH / "files" / "parts.csv").read_text(encoding="utf-8")
        for name in (*beams.PartNames, *panels.PartNames):
            self.assertIn(name, listed)
        alone = api.export_fabrication(panels, tools.SCRATCH / "alone")
        self.assertLessEqual(names, {path.name for path in alone})

    def test_sheets_stock_and_workers(self):
        # Not optimised: its beams twist, so the clash check has much to look at.
        beams = api.add_beams(self.imported())
        sizes = {"sheet": "3000x1500", "stock": "6 m", "kerf": "0.2 mm"}
        alone = api.export_fabrication(beams, tools.SCRATCH / "one", **sizes)
        shared = api.export_fabrication(beams, tools.SCRATCH / "two", workers=2, **sizes)
        self.assertIn("sheet-001-steel-20mm.dxf", [path.name for path in alone])
        for one, other in zip(alone, shared, strict=True):
            self.assertEqual(one.read_bytes(), other.read_bytes(), one.name)
        report = json.loads((tools.SCRATCH / "two" / "report.json").read_text(encoding="utf-8"))
        self.assertGreater(report["clash_check"]["pairs_near"], 0)
        self.assertEqual(report["kerf_mm"], 0.2)
        with self.assertRaises(InputError):
            api.export_fabrication(beams, tools.SCRATCH / "three", sheet="300x150")
        self.assertFalse((tools.SCRATCH / "three").exists())

    def test_what_does_not_go_together(self):
        net, other = self.imported(), self.imported(name="other")
        beams, beams_too, elsewhere = (api.add_beams(each) for each in (net, net, other))
        loose = api.add_panels(net)
        for wrong in ([], [net], [beams, beams_too], [beams, elsewhere], [beams, loose]):
            with self.subTest([item.Label for item in wrong]), self.assertRaises(InputError):
                api.export_fabrication(wrong, tools.SCRATCH / "never")
        self.assertFalse((tools.SCRATCH / "never").exists())
        blocked = tools.write("file-not-folder", "")
        with self.assertRaises(OutputError):
            api.export_fabrication(beams, os.path.join(blocked, "inside"))


class TestWithoutWindow(DocumentCase):
    def test_picture_says_what_it_needs(self):
        with self.assertRaises(InputError):
            api.save_picture(tools.SCRATCH / "none.png")

    def test_packages_come_from_the_project(self):
        import scipy

        import freecad_ortho
        import solver

        self.assertIsNone(freecad_ortho.shadowing_module())
        self.assertEqual(Path(solver.__file__).resolve().parents[1], tools.ROOT)
        self.assertNotIn("dist-packages", scipy.__file__)

    def test_a_foreign_solver_is_named(self):
        import freecad_ortho

        folder = tools.SCRATCH / "foreign"
        folder.mkdir()
        (folder / "solver.py").write_text("", encoding="utf-8")
        kept = {name: sys.modules.pop(name) for name in list(sys.modules) if name == "solver"}
        sys.path.insert(0, str(folder))
        try:
            self.assertIn(str(folder), freecad_ortho.shadowing_module())
        finally:
            sys.path.remove(str(folder))
            sys.modules.update(kept)
