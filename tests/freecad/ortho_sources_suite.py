"""Sources of nets in documents without a window: what they make, follow, undo and refuse."""

import math

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
import Part
from ortho_suite_cases import DocumentCase

from freecad_ortho import api, convert
from freecad_ortho.objects import source_net
from freecad_ortho.sources import GROUPS, SOURCES
from solver.analysis import measures
from solver.errors import InputError
from solver.multinet import multi_net_residual


class SourceCase(DocumentCase):
    def flat(self, count=9, size=8000.0):
        return api.add_primitive("rectangle", sampling=(count, count), length=size, width=size)


class TestPrimitives(SourceCase):
    def test_every_primitive_is_a_net_that_follows_its_numbers(self):
        for name in GROUPS["primitive"]:
            with self.subTest(name):
                net = api.add_primitive(name, sampling=(12, 7))
                mesh = convert.quad_mesh(net)
                self.assertGreater(len(mesh.faces), 60)
                self.assertFalse(measures.flipped(mesh).any())
                net.SamplingU = 14
                self.document.recompute()
                self.assertGreater(len(net.Faces), mesh.faces.size)

    def test_units_placement_and_undo(self):
        net = api.add_primitive("sphere", radius="8 m", sampling=(24, 9))
        self.assertEqual(net.Radius.Value, 8000.0)
        radii = np.linalg.norm(tools.vertices(net), axis=1)
        np.testing.assert_allclose(radii, 8000.0, rtol=1e-12)
        net.Placement = FreeCAD.Placement(
            FreeCAD.Vector(1000, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90)
        )
        self.document.recompute()
        moved = tools.vertices(net) - [1000, 0, 0]
        np.testing.assert_allclose(np.linalg.norm(moved, axis=1), 8000.0, rtol=1e-12)
        steps = self.document.UndoCount
        api.change_source(net, radius="2 m", angles=(0, 180))
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.assertEqual((net.Radius.Value, net.AnglesEnd.Value), (2000.0, 180.0))
        self.document.undo()
        self.assertEqual((net.Radius.Value, net.AnglesEnd.Value), (8000.0, 360.0))
        np.testing.assert_allclose(
            np.linalg.norm(tools.vertices(net) - [1000, 0, 0], axis=1), 8000.0, rtol=1e-12
        )

    def test_bad_values_leave_the_document_as_it_was(self):
        net = self.flat()
        before = tools.vertices(net).tobytes()
        for attempt in (
            lambda: api.add_primitive("cube"),
            lambda: api.add_primitive("sphere", diameter=3),
            lambda: api.add_primitive("sphere", radius="3 kg"),
            lambda: api.add_primitive("sphere", radius=-1.0),
            lambda: api.add_primitive("sphere", sampling=(3,)),
            lambda: api.add_primitive("catenoid", lines="curly"),
            lambda: api.change_source(net, length=-5.0),
            lambda: api.change_source(net, length="wide"),
            lambda: api.change_net(net, "mirror"),
            lambda: api.change_net(net, "sphere"),
            lambda: api.weld_nets([]),
            lambda: api.form_net(net, supports="0,1000"),
            lambda: api.form_net(net, lift="40:100"),
            lambda: api.net_from_faces(net),
            lambda: api.add_source("faces"),
            lambda: api.add_source("sorcery"),
        ):
            steps = self.document.UndoCount
            with self.assertRaises(InputError) as caught:
                attempt()
            self.assertNotIn("\n", str(caught.exception))
            self.assertEqual((len(self.document.Objects), self.document.UndoCount), (1, steps))
            self.assertEqual(tools.vertices(net).tobytes(), before)


class TestMultiNet(SourceCase):
    def test_is_exact_however_it_is_sampled_and_moved(self):
        net = api.add_multi_net()
        self.assertEqual(net.Name, "MultiNet")
        for settings in (
            {},
            {"SamplingU": 9, "SamplingV": 31},
            {"Quadric": "one-sheeted hyperboloid"},
            {"SemiAxesX": 12000},
            {"TRangeStart": -3e6, "TRangeEnd": 4e6},
        ):
            for name, value in settings.items():
                setattr(net, name, value)
            self.document.recompute()
            self.assertIn("Up-to-date", net.State)
            mesh = convert.quad_mesh(net)
            self.assertLess(multi_net_residual(mesh).bound, 1e-12)
            self.assertEqual(len(mesh.vertices), net.SamplingU * net.SamplingV)

    def test_points_are_set_onto_the_quadric_and_survive_saving(self):
        points = [(8000, 0, 1000), (6000, 4000, 1500), (2000, 5500, 2000)]
        net = api.add_multi_net(points, semi_axes=("9 m", "6 m", "4 m"), sampling=(5, 4))
        name, before = net.Name, tools.vertices(net).tobytes()
        again = self.reopened("multinet.FCStd").getObject(name)
        self.assertEqual(tools.vertices(again).tobytes(), before)
        again.SamplingU = 9
        self.document.recompute()
        self.assertLess(multi_net_residual(convert.quad_mesh(again)).bound, 1e-12)

    def test_says_the_range_of_t(self):
        net = api.add_multi_net()
        self.assertIn("admissible from -1.6e+07 mm2 on", net.Remarks[0])
        with self.assertRaisesRegex(InputError, r"t: expected -1\.6e\+07"):
            api.change_source(net, t_range=(-2e7, 1e6))
        self.assertEqual(net.TRangeStart, 0.0)

    def test_elliptic_coordinates(self):
        net = api.add_elliptic_net("mu", curve="arch", sampling=(21, 11))
        self.assertLess(multi_net_residual(convert.quad_mesh(net)).bound, 1e-12)
        formulas = api.add_elliptic_net(
            "lambda",
            curve="formulas",
            first_formula="-c - (b - c)*s",
            second_formula="-0.5*(a + b)",
        )
        self.assertLess(multi_net_residual(convert.quad_mesh(formulas)).bound, 1e-12)
        whole = api.add_elliptic_net("lambda", curve="wave", reflect="x, y", sampling=(9, 7))
        self.assertEqual(len(whole.Faces) // 4, 4 * 8 * 6)


class TestFaces(SourceCase):
    def dome(self):
        """A B-spline face over 8 m x 6 m."""
        rows = [
            [FreeCAD.Vector(2000 * i, 1500 * j, 900 * math.sin(0.9 * i) * math.cos(0.7 * j))
             for j in range(5)]
            for i in range(5)
        ]  # fmt: skip
        surface = Part.BSplineSurface()
        surface.interpolate(rows)
        return surface

    def worst_distance(self, net, shape):
        return max(
            shape.distToShape(Part.Vertex(point))[0]
            for point in convert.vectors(tools.vertices(net))
        )

    def test_whole_face_by_counts_and_by_edge_length(self):
        feature = self.shape(self.dome().toShape())
        net = api.net_from_faces(feature, sampling=(9, 7), spacing="parameter")
        points = tools.vertices(net).reshape(9, 7, 3)
        expected = self.dome().value(0.25, 0.5)
        np.testing.assert_allclose(points[2, 3], tuple(expected), atol=1e-9)
        self.assertLess(self.worst_distance(net, feature.Shape), 1e-6)
        fine = api.net_from_faces((feature, "Face1"), edge="0.5 m")
        self.assertLess(abs(convert.quad_mesh(fine).mean_edge / 500 - 1), 0.06)
        self.assertEqual(fine.CadFaces, [(feature, ("Face1",))])

    def test_follows_the_face_until_it_was_optimised(self):
        feature = self.shape(self.dome().toShape())
        net = api.net_from_faces(feature, sampling=(9, 7))
        feature.Shape = feature.Shape.translated(FreeCAD.Vector(0, 0, 500))
        self.document.recompute()
        self.assertLess(self.worst_distance(net, feature.Shape), 1e-6)
        api.optimise_net(net, net="principal", close_to=net)
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        self.assertFalse(net.FollowSource)
        kept = tools.vertices(net).tobytes()
        feature.Shape = feature.Shape.translated(FreeCAD.Vector(0, 0, 500))
        self.document.recompute()
        self.assertEqual(tools.vertices(net).tobytes(), kept)
        self.document.undo()
        self.assertTrue(net.FollowSource)

    def test_closeness_to_a_face_is_that_to_its_points(self):
        feature = self.shape(self.dome().toShape())
        apart = []
        for near in ({}, {"close_to": (feature, "Face1")}, {"close_to": feature}):
            net = api.net_from_faces(feature, sampling=(13, 11))
            api.optimise_net(net, net="principal", **near)
            apart.append(self.worst_distance(net, feature.Shape))
        self.assertLess(apart[1], apart[0])
        self.assertEqual(apart[1], apart[2])

    def test_trimmed_face_ends_at_its_border(self):
        sheet = self.dome().toShape()
        drill = Part.makeCylinder(1500, 8000, FreeCAD.Vector(4000, 3000, -4000))
        for shape in (sheet.common(drill), sheet.cut(drill)):
            feature = self.shape(shape)
            net = api.net_from_faces(feature, edge=400)
            mesh = convert.quad_mesh(net)
            self.assertFalse(measures.flipped(mesh).any())
            self.assertGreater(measures.edge_ratio(mesh), 0.2)
            rim = mesh.vertices[mesh.connectivity.boundary_vertices]
            border = Part.Compound(feature.Shape.Edges)
            apart = [border.distToShape(Part.Vertex(p))[0] for p in convert.vectors(rim)]
            self.assertLess(max(apart), 2.0)
            self.assertLess(self.worst_distance(net, feature.Shape), 2.0)
            area = sum(
                0.5 * np.linalg.norm(np.cross(q[2] - q[0], q[3] - q[1]))
                for q in mesh.vertices[mesh.faces]
            )
            self.assertLess(abs(area / feature.Shape.Area - 1), 0.02)
            rough = api.net_from_faces(feature, edge=400, outside="drop")
            self.assertLess(len(rough.Faces), len(net.Faces))

    def test_faces_are_joined_and_agree_on_the_outside(self):
        box = self.shape(Part.makeBox(4000, 3000, 2000))
        net = api.net_from_faces(box, edge=500)
        mesh = convert.quad_mesh(net)
        self.assertEqual(len(mesh.faces), 2 * (8 * 6 + 8 * 4 + 6 * 4))
        self.assertFalse(mesh.connectivity.boundary_vertices.any())
        volume = np.einsum(
            "fi,fi->",
            mesh.vertices[mesh.faces].mean(axis=1),
            np.cross(
                mesh.vertices[mesh.faces[:, 2]] - mesh.vertices[mesh.faces[:, 0]],
                mesh.vertices[mesh.faces[:, 3]] - mesh.vertices[mesh.faces[:, 1]],
            )
            / 6,
        )
        self.assertAlmostEqual(volume / 4000 / 3000 / 2000, 1.0, places=9)
        tube = self.shape(Part.makeCylinder(1000, 3000))
        ring = api.net_from_faces((tube, "Face1"), sampling=(16, 5))
        self.assertEqual(len(ring.Faces) // 4, 64)
        self.assertTrue(convert.quad_mesh(ring).connectivity.regular.any())

    def test_faces_inside_parts_stand_where_they_are_seen(self):
        box = self.shape(Part.makeBox(4000, 3000, 2000), "Box")
        box.Placement.Base = FreeCAD.Vector(0, 0, 100)
        part = self.document.addObject("App::Part", "Part")
        part.addObject(box)
        part.Placement.Base = FreeCAD.Vector(10000, 0, 0)
        self.document.recompute()
        net = api.net_from_faces((box, "Face1"), sampling=(3, 3))
        points = tools.vertices(net)
        np.testing.assert_allclose(points.min(axis=0), [10000, 0, 100], atol=1e-9)
        np.testing.assert_allclose(points.max(axis=0), [10000, 3000, 2100], atol=1e-9)

    def test_what_cannot_be_sampled_is_said(self):
        ball = self.shape(Part.makeSphere(1000), "Ball")
        with self.assertRaisesRegex(InputError, "Ball.Face1: its side v = .* shrinks to a point"):
            api.net_from_faces(ball, sampling=(16, 9))
        part = api.net_from_faces(ball, sampling=(16, 9), v_part=(0.1, 0.9))
        np.testing.assert_allclose(np.linalg.norm(tools.vertices(part), axis=1), 1000, rtol=1e-9)
        with self.assertRaisesRegex(InputError, "Face1 to Face1, not 'Face7'"):
            api.net_from_faces((ball, "Face7"))
        line = [FreeCAD.Vector(1000 * math.cos(t), 800 * math.sin(2 * t), 0)
                for t in np.linspace(0.1, 6.0, 30)]  # fmt: skip
        curve = Part.BSplineCurve()
        curve.interpolate(line)
        crossed = self.shape(curve.toShape().extrude(FreeCAD.Vector(0, 0, 900)))
        with self.assertRaisesRegex(InputError, "meets itself"):
            api.net_from_faces(crossed, sampling=(40, 5))


class TestChanges(SourceCase):
    def test_every_change_makes_a_net_that_follows(self):
        net = self.flat()
        for name, entry in SOURCES.items():
            if entry.needs != "net":
                continue
            with self.subTest(name):
                options = {"point": (5000, 0, 0)} if name == "mirror" else {}
                changed = api.change_net(net, name, **options)
                self.assertTrue(changed.Faces)
                self.assertFalse(net.Visibility)
                self.document.undo()
        half = api.change_net(net, "subdivide")
        beams = api.add_beams(half)
        self.assertEqual(len(half.Faces), 4 * len(net.Faces))
        net.Length = 16000
        self.document.recompute()
        self.assertEqual(np.ptp(tools.vertices(half)[:, 0]), 16000)
        self.assertGreater(beams.Shape.BoundBox.XLength, 15900)

    def test_weld(self):
        left = self.flat()
        right = api.change_net(left, "transform", move=("8 m", 0, 0))
        whole = api.weld_nets([left, right])
        self.assertEqual(len(whole.Vertices), 9 * 17)
        self.assertEqual(list(whole.Nets), [left, right])

    def test_form_finding_follows_its_supports(self):
        net = self.flat()
        sail = api.form_net(net, supports="corners", lift="0:2000; 80:2000", border_density=8.0)
        points = tools.vertices(sail)
        self.assertAlmostEqual(points[40, 2], 1000.0, delta=1e-6)
        self.assertIn("in equilibrium", sail.Remarks[0])
        film = api.form_net(net, kind="membrane", pressure=1e-4)
        self.assertGreater(tools.vertices(film)[40, 2], 100.0)
        sail.Lift = "0:4000; 80:4000"
        self.document.recompute()
        self.assertAlmostEqual(tools.vertices(sail)[40, 2], 2000.0, delta=1e-6)

    def test_a_bad_value_in_the_property_editor_marks_the_net(self):
        net = self.flat()
        half = api.change_net(net, "subdivide")
        before = tools.vertices(half).tobytes()
        half.Levels = 99
        self.document.recompute()
        self.assertIn("Invalid", half.State)
        self.assertIn("levels", half.getStatusString())
        self.assertEqual(tools.vertices(half).tobytes(), before)
        half.Levels = 1
        self.document.recompute()
        self.assertIn("Up-to-date", half.State)

    def test_no_option_hides_a_property_of_every_net(self):
        common = {entry.name for entry in source_net.SourceNet.properties}
        common |= {"Nets", "CadFaces", "Label", "Visibility", "Proxy", "ExpressionEngine"}
        for name, entry in SOURCES.items():
            parts = [part for option in entry.options for part in option.parts]
            self.assertFalse(common & set(parts), name)
            self.assertEqual(len(parts), len(set(parts)), name)

    def test_migration(self):
        net = self.flat()
        for name in ("Remarks", "Width"):
            net.removeProperty(name)
        net.Proxy.onDocumentRestored(net)
        self.assertEqual(net.Width.Value, 1000.0)
        self.assertTrue(source_net.is_source_net(net))

    def test_an_older_document_has_squares_of_semi_axes(self):
        net = api.add_primitive("confocal-conics", sampling=(9, 5))
        for end, square in (("Start", 9e6), ("End", 4e6)):
            net.removeProperty(f"SemiAxes{end}")
            net.addProperty("App::PropertyFloat", f"Squares{end}")
            setattr(net, f"Squares{end}", square)
        net.Proxy.onDocumentRestored(net)
        self.assertEqual((net.SemiAxesStart.Value, net.SemiAxesEnd.Value), (3000.0, 2000.0))
        self.assertNotIn("SquaresStart", net.PropertiesList)
        self.document.recompute()
        macro = api.add_primitive("confocal-conics", sampling=(9, 5), squares=(9e6, 4e6))
        self.assertEqual(tools.vertices(net).tobytes(), tools.vertices(macro).tobytes())

    def test_a_direction_may_be_the_name_of_an_axis(self):
        net = api.change_net(self.flat(), "mirror", normal="z", point=(0, 0, 1000), image_only=True)
        self.assertEqual((net.NormalX, net.NormalY, net.NormalZ), (0.0, 0.0, 1.0))
        self.assertTrue((tools.vertices(net)[:, 2] == 2000.0).all())

    def test_an_elliptic_net_may_follow_points(self):
        curve = api.add_elliptic_net(sampling=(12, 5))
        points = tools.vertices(curve).reshape(12, 5, 3)[:, 2]
        net = api.add_elliptic_net(sampling=(12, 5), points=points.tolist())
        self.assertLess(multi_net_residual(convert.quad_mesh(net)).worst, 1e-12)
        line = tools.vertices(net)
        apart = np.linalg.norm(line[None] - points[:, None], axis=2).min(axis=1)
        self.assertLess(apart.max(), 1000.0)


class TestDocument(SourceCase):
    def test_the_macro_of_the_document_runs(self):
        text = (tools.ROOT / "docs" / "sources.md").read_text(encoding="utf-8")
        macro = text.split("```python\n")[1].split("```")[0]
        names = {"App": FreeCAD}
        exec(macro, names)
        self.assertLessEqual(max(tools.faults(names["net"])), 1e-10)
        radii = np.linalg.norm(tools.vertices(names["net"]), axis=1)
        self.assertLess(np.abs(radii - 8000).max(), 400)
