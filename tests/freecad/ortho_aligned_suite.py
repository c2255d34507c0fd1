"""Nets along curvature in documents without a window: what they make, follow and refuse."""

import json
import os
import tempfile

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
import Part
from ortho_aligned_tools import roof, turned
from ortho_suite_cases import DocumentCase

from freecad_ortho import api, convert
from freecad_ortho.objects import making
from solver.analysis import measures
from solver.errors import InputError


class TestAligned(DocumentCase):
    def setUp(self):
        super().setUp()
        making._made.clear()
        self.sheet = self.shape(roof())

    def line(self, first=(0.2, 0.2), last=(0.8, 0.5)):
        """A curve on the sheet that crosses its lines of curvature, and its points."""
        face = self.sheet.Shape.Face1
        low, high = np.array(face.ParameterRange).reshape(2, 2).T
        places = np.linspace(low + first * (high - low), low + last * (high - low), 40)
        points = [face.valueAt(*place) for place in places.tolist()]
        curve = Part.BSplineCurve()
        curve.interpolate(points)
        return curve.toShape(), convert.array(points)

    def test_along_the_curvature_of_a_face(self):
        net = api.net_along_curvature(self.sheet, edge="0.6 m")
        mesh = convert.quad_mesh(net)
        self.assertEqual(net.Edge.getValueAs("mm"), 600)
        self.assertLess(measures.orthogonality(mesh).mean(), 0.02)
        # What overhangs lies beyond the face, everything else on it.
        distances = np.array(
            [
                self.sheet.Shape.distToShape(Part.Vertex(point))[0]
                for point in convert.vectors(tools.vertices(net))
            ]
        )
        inner = ~mesh.connectivity.boundary_vertices
        self.assertLess(distances[inner].max(), 900)
        self.assertGreater(np.mean(distances < 1e-3), 0.6)
        before = len(net.Faces)
        net.Edge = 900
        self.document.recompute()
        self.assertLess(len(net.Faces), 0.7 * before)
        api.optimise_net(net, net="principal", close_to=net)
        self.assertLessEqual(max(tools.faults(net)), 1e-10)

    def test_structures_are_cut_along_the_border_of_the_face(self):
        net = api.net_along_curvature(self.sheet, edge=900.0)
        api.optimise_net(net, net="principal", close_to=net)
        (line,) = convert.border(net)
        far = max(self.sheet.Shape.distToShape(Part.Vertex(p))[0] for p in convert.vectors(line))
        self.assertLess(far, 20)
        panels = api.add_panels(net, gap=1.0)
        covered = json.loads(panels.Report)["panels"]["area_mm2"]
        self.assertLess(abs(covered / self.sheet.Shape.Area - 1), 0.01)
        self.assertLess(len(panels.PartNames), len(net.Faces) // 4)
        self.assertTrue(all(solid.isValid() for solid in panels.Shape.Solids))
        api.change_structure(panels, trimmed=False)
        self.assertEqual(len(panels.PartNames), len(net.Faces) // 4)
        panels.Trimmed = True
        self.document.recompute()
        self.assertLess(len(panels.PartNames), len(net.Faces) // 4)

    def test_a_border_goes_from_net_to_net_and_through_files(self):
        net = api.net_along_curvature(self.sheet, edge=900.0)
        (line,) = convert.border(net)
        fine = api.change_net(net, "subdivide", levels=1)
        self.assertEqual(len(convert.border(fine)), 1)
        self.assertEqual(convert.border(api.change_net(net, "transform", scale=2.0)), ())
        path = os.path.join(tempfile.mkdtemp(), "net.json")
        api.export_net(net, path, unit="m")
        again = api.import_net(path, self.document)
        self.assertLess(np.abs(convert.border(again)[0] - line).max(), 1e-9)

    def test_irregular_vertices_are_counted_by_their_lines(self):
        net = api.net_along_curvature(self.sheet, edge=900.0)
        mesh = convert.quad_mesh(net)
        inner = ~mesh.connectivity.boundary_vertices & ~mesh.connectivity.regular
        said = [remark for remark in net.Remarks if remark.startswith("irregular")]
        self.assertEqual(len(said), bool(inner.any()))
        for lines in set(mesh.connectivity.face_valence[inner].tolist()):
            self.assertIn(f"with {lines} lines", said[0])

    def test_lines_run_along_an_edge_and_follow_it(self):
        shape, points = self.line()
        wire = self.shape(shape, "Wall")
        plain = api.net_along_curvature(self.sheet, edge=700.0)
        self.assertGreater(turned(plain, points), 20.0)
        net = api.net_along_curvature(self.sheet, (wire, "Edge1"), edge=700.0)
        self.assertEqual(net.Strokes, [(wire, ("Edge1",))])
        self.assertLess(turned(net, points), 3.0)
        self.assertFalse(wire.Visibility)
        before = tools.vertices(net)
        wire.Shape, points = self.line((0.2, 0.8), (0.8, 0.5))
        self.document.recompute()
        self.assertLess(turned(net, points), 3.0)
        self.assertFalse(before.tobytes() == tools.vertices(net).tobytes())
        names = net.Name, wire.Name, plain.Name
        self.reopened("strokes.FCStd")
        self.document.UndoMode = 1
        net, wire, plain = (self.document.getObject(name) for name in names)
        self.assertEqual(net.Strokes, [(wire, ("Edge1",))])
        api.change_source(net, strokes=())
        np.testing.assert_allclose(tools.vertices(net), tools.vertices(plain), atol=1e-9)
        self.document.undo()
        self.assertEqual(net.Strokes, [(wire, ("Edge1",))])

    def test_edges_of_the_shape_and_whole_wires_are_strokes(self):
        wire = self.shape(self.line()[0], "Wall")
        along = api.net_along_curvature(self.sheet, (self.sheet, "Edge1"), edge=900.0)
        self.assertLess(turned(along, convert.array(self.sheet.Shape.Edge1.discretize(30))), 3.0)
        both = api.net_along_curvature(self.sheet, [wire, (self.sheet, "Edge3")], edge=900.0)
        self.assertEqual(both.Strokes, [(wire, ("",)), (self.sheet, ("Edge3",))])
        self.assertLess(turned(both, self.line()[1]), 8.0)

    def test_a_stroke_in_a_part_stands_where_it_is_seen(self):
        shape, points = self.line()
        wire = self.shape(shape.translated(FreeCAD.Vector(0, 0, -5000)), "Wall")
        with self.assertRaisesRegex(InputError, "stroke 1: it is up to .* off the surface"):
            api.net_along_curvature(self.sheet, wire, edge=900.0)
        part = self.document.addObject("App::Part", "Part")
        part.addObject(wire)
        part.Placement.Base = FreeCAD.Vector(0, 0, 5000)
        self.document.recompute()
        net = api.net_along_curvature(self.sheet, wire, edge=900.0)
        self.assertLess(turned(net, points), 6.0)

    def test_what_is_no_stroke_is_refused(self):
        wire = self.shape(self.line()[0], "Wall")
        box = self.shape(Part.makeBox(10, 10, 10), "Box")
        count = len(self.document.Objects)
        for strokes, words in (
            (box, "Box has faces; select edges of it"),
            ((wire, "Edge7"), "has Edge1 to Edge1, not 'Edge7'"),
            ((wire, "Vertex1"), "not 'Vertex1'"),
            (self.document.addObject("App::FeaturePython", "Nothing"), "Nothing has no edges"),
        ):
            with self.assertRaisesRegex(InputError, words):
                api.net_along_curvature(self.sheet, strokes)
        with self.assertRaisesRegex(InputError, "its lines follow no strokes"):
            api.add_source("faces", faces=[(self.sheet, "Face1")], strokes=[(wire, "Edge1")])
        self.assertEqual(len(self.document.Objects), count + 1)

    def test_singular_vertices_and_drawn_lines_are_kept_in_the_document(self):
        places = [self.sheet.Shape.Face1.valueAt(*uv) for uv in ((0.3, 0.65), (0.6, 0.8))]
        rows = [(*place, lines) for place, lines in zip(places, (3, 5), strict=True)]
        drawn = [[tuple(point) for point in self.line()[1][::5]]]
        net = api.net_along_curvature(
            self.sheet, edge=900.0, singularities=rows, drawn_strokes=drawn
        )
        self.assertIn("irregular: 1 vertex with 3 lines, 1 vertex with 5 lines", net.Remarks)
        self.assertLess(turned(net, self.line()[1]), 10.0)
        before = tools.vertices(net).tobytes()
        name = net.Name
        self.reopened("singular.FCStd")
        self.document.UndoMode = 1
        net = self.document.getObject(name)
        net.touch()
        self.document.recompute()
        self.assertEqual(tools.vertices(net).tobytes(), before)
        api.change_source(net, singularities="none", drawn_strokes=())
        self.assertEqual((net.Singularities, net.DrawnStrokes), (["none"], []))
        api.change_source(net, singularities="auto")
        self.assertEqual(net.Singularities, [])
        self.document.undo()
        self.document.undo()
        self.assertEqual(tools.vertices(net).tobytes(), before)
        # As somebody types it into the property.
        x, y, z = rows[0][:3]
        net.Singularities = [f"{x}, {y}, {z}, 5", f"{x} {y} {z} 5"]
        self.document.recompute()
        self.assertIn("irregular: 1 vertex with 6 lines", net.Remarks)

    def test_singular_vertices_that_are_none_are_refused(self):
        for given, words in (
            ([(0, 0, 0)], "singularities: expected rows of x, y, z and a number of lines"),
            ([(0, 0, 9e4, 3)], "singularities: .* off the surface"),
            (["1 2 3 x"], "singularities: expected rows"),
            ([(4000, 3000, 0, 3.5)], "whole ones"),
        ):
            with self.assertRaisesRegex(InputError, words):
                api.net_along_curvature(self.sheet, edge=900.0, singularities=given)
        with self.assertRaisesRegex(InputError, "stroke 1: .* off the surface"):
            api.net_along_curvature(
                self.sheet, edge=900.0, drawn_strokes=[[(0, 0, 9e4), (9, 0, 0)]]
            )

    def test_nothing_is_made_twice(self):
        net = api.net_along_curvature(self.sheet, edge=900.0)
        self.assertEqual(len(making._made), 1)
        for value in (1100.0, 900.0):
            net.Edge = value
            self.document.recompute()
        self.assertEqual(len(making._made), 2)
        self.sheet.Placement.Base = FreeCAD.Vector(0, 0, 1000)
        self.document.recompute()
        self.assertEqual(len(making._made), 3)
        self.assertGreater(tools.vertices(net)[:, 2].mean(), 500.0)
