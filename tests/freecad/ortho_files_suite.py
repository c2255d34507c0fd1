"""Mesh files with faces of any size, and documents of earlier versions. Run by FreeCAD.

These documents are in ``fixtures``, by version, made by ``scripts/document_fixture.py``.
"""

import json
import shutil
import unittest
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
import Part
from ortho_suite_cases import DocumentCase

from examples.mixed_faces import cut_round
from freecad_ortho import api, convert
from freecad_ortho.objects import cad_faces
from freecad_ortho.objects.net import VERSION, is_net
from freecad_ortho.objects.structure import is_structure
from solver import write_mesh
from solver.errors import InputError
from solver.mesh.remesh import LIBRARY

FIXTURES = Path(__file__).resolve().parent / "fixtures"
VERSIONS = sorted(path.stem for path in FIXTURES.glob("*.FCStd"))


class TestFacesOfAnySize(DocumentCase):
    """A dome cut off round: triangles, quads and pentagons."""

    def setUp(self):
        super().setUp()
        self.drawn = cut_round(4)
        path = tools.SCRATCH / "round.obj"
        write_mesh(path, self.drawn, "mm")
        self.net = api.import_net(path, self.document)

    def polygons(self, net):
        return convert.quad_mesh(net).connectivity.polygons

    def test_they_are_read_kept_and_written_as_they_are(self):
        polygons = self.drawn.connectivity.polygons
        self.assertEqual({len(face) for face in polygons}, {3, 4, 5})
        self.assertEqual(self.polygons(self.net), polygons)
        path = tools.SCRATCH / "again.obj"
        api.export_net(self.net, path)
        written = api.read_mesh(path, mixed=True).mesh
        self.assertEqual(written.connectivity.polygons, polygons)
        np.testing.assert_array_equal(written.vertices, self.drawn.vertices)
        api.flip_net(self.net)
        turned = [face[1::-1] + face[:1:-1] for face in polygons]
        self.assertEqual(self.polygons(self.net), turned)
        self.document.undo()
        self.assertEqual(self.polygons(self.net), polygons)
        (group,) = api.bake([self.net])
        mesh, edges = group.Group
        corners = sum(map(len, polygons))
        self.assertEqual(mesh.Mesh.CountFacets, corners - 2 * len(polygons))
        self.assertEqual(len(edges.Shape.Edges), len(self.drawn.connectivity.edges))
        name = self.net.Name
        again = self.reopened("any_size.FCStd").getObject(name)
        self.assertEqual(self.polygons(again), polygons)

    def test_flat_faces_become_panels_on_beams_that_follow(self):
        self.assertEqual(self.net.NetType, "planar")
        outcome = api.optimise_net(self.net)
        self.assertEqual(outcome.report.status, "converged")
        gaps = convert.quad_mesh(self.net).face_gaps
        self.assertLess(gaps.max(), 1e-9 * self.drawn.mean_edge)
        beams = api.add_beams(self.net)
        panels = api.add_panels(self.net, beams=beams)
        faces = len(self.drawn.connectivity.polygons)
        self.assertEqual(len(panels.Shape.Solids), faces)
        self.assertTrue(panels.Shape.isValid())
        self.assertEqual(len(beams.Shape.Solids), len(self.drawn.connectivity.edges))
        report = json.loads(panels.Report)["panels"]
        counts = np.bincount([len(face) for face in self.drawn.connectivity.polygons])
        self.assertEqual(report["panels_by_corners"], {str(n): counts[n] for n in (3, 4, 5)})
        before = panels.Shape.Volume
        convert.store_vertices(self.net, 1.1 * tools.vertices(self.net))
        self.document.recompute()
        self.assertGreater(panels.Shape.Volume, 1.15 * before)

    def test_what_needs_quads_says_so_and_changes_nothing(self):
        before, count = tools.vertices(self.net).tobytes(), len(self.document.Objects)
        for what in (
            lambda: api.optimise_net(self.net, net="principal"),
            lambda: api.add_lamellas(self.net),
            lambda: api.add_panels(self.net, bending="cold"),
        ):
            with self.assertRaisesRegex(InputError, " triangles, |several sizes"):
                what()
        self.assertEqual((tools.vertices(self.net).tobytes(), self.net.NetType), (before, "planar"))
        self.assertEqual(len(self.document.Objects), count)
        self.net.FaceSizes = self.net.FaceSizes[:-1]
        with self.assertRaisesRegex(InputError, "'Faces' holds .*, 'FaceSizes' says"):
            convert.quad_mesh(self.net)


class TestEarlierVersions(unittest.TestCase):
    def tearDown(self):
        tools.close_all()

    @contextmanager
    def opened(self, version):
        """Open a copy of the document; give it with what it held when it was saved."""
        path = tools.SCRATCH / f"{version}.FCStd"
        shutil.copy(FIXTURES / path.name, path)
        held = json.loads((FIXTURES / f"{version}.json").read_text(encoding="utf-8"))
        with self.subTest(version):
            yield FreeCAD.openDocument(str(path)), held
        tools.close_all()

    def assertHolds(self, document, held, tolerance, named=lambda name: name):
        net = document.Net
        np.testing.assert_array_equal(tools.vertices(net), held["vertices"])
        self.assertEqual(list(net.Faces), held["faces"])
        self.assertEqual(json.loads(net.LastReport), held["report"])
        self.assertEqual(net.ColourMap, "Orthogonality")
        for name, expected in held["structures"].items():
            item = document.getObject(name)
            self.assertEqual(item.Label, expected["label"])
            self.assertEqual(list(item.PartNames), [named(part) for part in expected["parts"]])
            volumes = [solid.Volume for solid in item.Shape.Solids]
            np.testing.assert_allclose(volumes, expected["volumes"], rtol=tolerance)
            centre = list(item.Shape.CenterOfGravity)
            np.testing.assert_allclose(centre, expected["centre"], rtol=tolerance, atol=1e-6)

    def test_there_is_one_of_every_version(self):
        changes = (tools.ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
        released = [line.split()[1] for line in changes.splitlines() if line.startswith("## ")]
        self.assertEqual(sorted(released), VERSIONS)

    def test_open_as_they_were_saved(self):
        for version in VERSIONS:
            with self.opened(version) as (document, held):
                self.assertHolds(document, held, 1e-12)
                # FreeCAD marks shapes of older versions of itself for a recompute; none may fail.
                for item in document.Objects:
                    self.assertNotIn("Invalid", item.State)
                self.assertTrue(is_net(document.Net))
                self.assertEqual(document.Net.Version, VERSION)
                self.assertTrue(all(map(is_structure, (document.Beams, document.Panels))))

    def test_recompute_to_the_same_shapes(self):
        for version in VERSIONS:
            with self.opened(version) as (document, held):
                for item in document.Objects:
                    item.touch()
                document.recompute()
                states = [item.State for item in document.Objects]
                self.assertEqual(states, [["Up-to-date"]] * 3)
                # Axes come of equations with weights of 1 and 1e10: what processors round otherwise
                # (AVX-512 or not) moved volumes by 4e-8.
                # Up to 0.2.0 the first edge and face were 1.
                self.assertHolds(
                    document, held, 1e-6, lambda name: f"{name[0]}{int(name[1:]) - 1:04d}"
                )

    def test_can_be_worked_on_and_saved_anew(self):
        for version in VERSIONS:
            with self.opened(version) as (document, held):
                document.UndoMode = 1
                document.Beams.Height = 2 * 180.0
                document.recompute()
                volume = sum(held["structures"]["Beams"]["volumes"])
                self.assertAlmostEqual(document.Beams.Shape.Volume / volume, 2.0, delta=0.02)
                document.Net.ColourMap = "Gauss curvature"
                api.optimise_net(document.Net, net="principal")
                volume = document.Panels.Shape.Volume
                path = str(tools.SCRATCH / "anew.FCStd")
                document.saveAs(path)
                FreeCAD.closeDocument(document.Name)
                again = FreeCAD.openDocument(path)
                self.assertLess(abs(again.Panels.Shape.Volume / volume - 1), 1e-12)
                self.assertEqual(again.Net.ColourMap, "Gauss curvature")


class TestTriangles(DocumentCase):
    def test_mesh_objects_and_files_are_read_alike(self):
        import Mesh

        shape = Part.makeCylinder(1000, 3000)
        mesh = self.document.addObject("Mesh::Feature", "Mesh")
        mesh.Mesh = Mesh.Mesh(shape.tessellate(5.0))
        path = str(tools.SCRATCH / "tube.stl")
        mesh.Mesh.write(path)
        here, there = cad_faces.triangles_of(mesh), cad_faces.triangles_of(path)
        self.assertEqual(here[1].shape, there[1].shape)
        metres = cad_faces.triangles_of(path, "m")
        np.testing.assert_allclose(metres[0], 1000 * there[0])
        with self.assertRaisesRegex(InputError, "holds no triangles"):
            api.quads_from_mesh(self.document.addObject("App::FeaturePython", "Nothing"), faces=100)

    @unittest.skipIf(find_spec(LIBRARY) is None, f"{LIBRARY} is not installed")
    def test_quads_from_a_mesh_object(self):
        import Mesh

        shape = Part.makeCylinder(1000, 3000, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 180)
        mesh = self.document.addObject("Mesh::Feature", "Half")
        mesh.Mesh = Mesh.Mesh(shape.Face1.tessellate(2.0))
        steps = self.document.UndoCount
        net = api.quads_from_mesh(mesh, edge="300 mm")
        quads = convert.quad_mesh(net)
        self.assertLess(abs(quads.mean_edge / 300 - 1), 0.3)
        radii = np.hypot(*tools.vertices(net)[:, :2].T)
        self.assertLess(np.abs(radii - 1000).max(), 3.0)
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.document.undo()
        self.assertEqual(self.document.Objects, [mesh])
