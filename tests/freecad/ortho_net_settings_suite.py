"""What a net is to become and what holds it: properties, macros, files. Run by FreeCAD."""

import json

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
import Part
from ortho_suite_cases import DocumentCase
from ortho_suite_tools import vertices

from freecad_ortho import api, convert, sources
from freecad_ortho.documents import net_settings
from freecad_ortho.keywords import NetSettings
from freecad_ortho.objects.net import NET_PROPERTIES
from solver.errors import InputError
from solver.io.polygons import write_mesh
from solver.mesh.grid import grid_faces
from solver.mesh.quadmesh import QuadMesh
from solver.nets import NETS


class TestTable(DocumentCase):
    def test_every_net_can_be_chosen(self):
        net = self.imported()
        self.assertEqual(net.getEnumerationsOfProperty("NetType"), list(NETS))

    def test_options_of_other_nets_wait_for_theirs(self):
        net = self.imported()
        api.set_net(net, net="cmc", radius=2000.0)
        api.set_net(net, net="asymptotic", diagonal=True)
        mesh = convert.quad_mesh(net)
        self.assertTrue(net_settings.for_solver(net, mesh)["options"].diagonal)
        self.assertIsNone(net_settings.for_solver(net, mesh)["options"].radius)
        api.set_net(net, net="conical")
        self.assertFalse(net_settings.for_solver(net, mesh)["options"].diagonal)
        api.set_net(net, net="cmc")
        self.assertEqual(net_settings.for_solver(net, mesh)["options"].radius, 2000.0)

    def test_no_source_has_a_property_of_that_name(self):
        names = {item.name for item in NET_PROPERTIES}
        for entry in sources.SOURCES.values() if hasattr(sources.SOURCES, "values") else ():
            parts = {part for option in entry.options for part in option.parts}
            self.assertEqual(names & parts, set(), entry.name)

    def test_few_kinds_of_panels(self):
        net = self.imported()
        with self.assertRaisesRegex(InputError, "kinds: expected 1 to"):
            api.optimise_net(net, repeat="panels", kinds=100_000)
        found = api.optimise_net(net, repeat="panels", alike="40 mm", max_steps=40)
        told = json.loads(net.LastReport)["repetition"]
        self.assertEqual((told["of"], told["alike"], told["asked"]), ("panels", 40.0, None))
        self.assertEqual(told["kinds"], found.report.repetition.kinds)
        self.assertEqual(sum(told["counts"]), len(convert.quad_mesh(net).faces))
        api.show_net(net, colour_map="Kinds of panels")
        self.assertEqual(net.ColourMap, "Kinds of panels")

    def test_words_go_in_and_come_out(self):
        net, twin = self.imported(), self.imported(name="twin")
        box = self.shape(Part.makeBox(1e4, 1e4, 10))
        given = {
            "net": "isometric",
            "diagonal": True,
            "flatness": 2.0,
            "supports": "corners",
            "angle": 80.0,
            "tilt_u": 60.0,
            "tilt_v": 120.0,
            "plane": "both",
            "web": "agg",
            "radius": 2000.0,
            "length": 150.0,
            "per_family": True,
            "reference": twin,
            "load": 2.0,
            "load_area": 3.0,
            "load_length": 4.0,
            "forces": "tension",
            "singular": "include",
            "symmetry": "",
            "fairness": 0.5,
            "closeness": 0.0,
            "multi": None,
            "multi_patch": (2, 3),
            "evenness": 0.3,
            "smooth_motion": 0.0,
            "edge_vectors": None,
            "isometry": 10.0,
            "repeat": "panels",
            "kinds": 6,
            "alike": 2.0,
            "alike_angle": 0.2,
            "tolerance": 1e-9,
            "within": 20.0,
            "fix": ["corners", 8],
            "handles": {9: (1.0, 2.0, 3.0)},
            "glide": ["boundary", (box, "Edge1", [0, 1]), (box, "Face6")],
            "close_to": [(box, "Face1"), (box, "Face6")],
        }
        net_settings.store(net, given)
        self.assertEqual(net_settings.words(net), given)
        path = str(tools.SCRATCH / "settings.FCStd")
        self.document.saveAs(path)
        name, label = net.Name, box.Name
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        again = net_settings.words(self.document.getObject(name))
        box = self.document.getObject(label)
        self.assertEqual(again["glide"][1:], [(box, "Edge1", [0, 1]), (box, "Face6")])
        self.assertEqual(again["close_to"], [(box, "Face1"), (box, "Face6")])
        for word in set(given) - {"glide", "close_to", "reference"}:
            self.assertEqual(again[word], given[word], word)

    def test_supports_are_kept_and_slide_or_stay(self):
        x, y = np.meshgrid(np.linspace(-4, 4, 9), np.linspace(-4, 4, 9), indexing="ij")
        lift = np.cos(np.pi * x / 10) * np.cos(np.pi * y / 10) + 0.03 * x * y
        points = 1000 * np.stack([x, y, 2 * lift], axis=2).reshape(-1, 3)
        vault = QuadMesh(points, grid_faces(9, 9))
        path = str(tools.SCRATCH / "vault.obj")
        write_mesh(path, vault, "mm")
        net = api.import_net(path, document=self.document)
        vault = convert.quad_mesh(net)
        rim = vault.connectivity.boundary_vertices
        corners = np.flatnonzero(vault.connectivity.corners)
        api.set_net(net, net="stress", supports=corners.tolist())
        self.assertEqual(net.SupportRule, ",".join(map(str, corners)))
        found = net_settings.for_solver(net, vault)
        self.assertEqual(found["supports"], net.SupportRule)
        self.assertEqual(np.flatnonzero(net_settings.held(net, vault)).tolist(), corners.tolist())
        api.set_net(net, supports="boundary")
        self.assertEqual(np.flatnonzero(net_settings.held(net, vault)).tolist(), corners.tolist())
        outcome = api.optimise_net(net, forces="compression")
        moved = np.linalg.norm(outcome.mesh.vertices - vault.vertices, axis=1)
        self.assertGreater(moved[rim].max(), 1.0)
        self.assertEqual(moved[corners].max(), 0.0)
        self.assertLess(outcome.report.form.border, 1.0)
        api.set_net(net, fix="boundary")
        self.assertTrue(net_settings.held(net, vault)[rim].all())
        api.set_net(net, net="principal", fix="none")
        self.assertEqual(net_settings.for_solver(net, vault)["supports"], "")

    def test_settings_are_those_that_editors_know_and_others_are_listed(self):
        known = {*net_settings.KEPT, *net_settings.PASSED}
        self.assertEqual(known, set(NetSettings.__annotations__))
        net = self.imported()
        with self.assertRaisesRegex(InputError, "^net: has no 'speed'; it has net, "):
            api.optimise_net(net, speed=3)
        with self.assertRaisesRegex(InputError, "^radius: only cmc nets have it, not conical; "):
            api.optimise_net(net, net="conical", radius="2 m")
        api.set_net(net, net="conical", radius=None, load=0, supports="")
        with self.assertRaisesRegex(InputError, "^add_beams: has no 'hight'; it has net, height, "):
            api.add_beams(net, hight=3)
        with self.assertRaisesRegex(InputError, "^hight: panels have no such setting; there are "):
            api.add_structure(net, "panels", hight=3)
        with self.assertRaisesRegex(InputError, "^sphere: has sampling, radius, .*, not 'size'; "):
            api.add_primitive("sphere", size=3)

    def test_things_are_written_as_on_the_command_line(self):
        net = self.imported()
        corners = np.flatnonzero(convert.quad_mesh(net).connectivity.corners).tolist()
        api.set_net(net, fix="corners,8", handles=["9:1,20cm,3.5 m"], glide=["z=1.5m@1,2"])
        found = net_settings.for_solver(net, convert.quad_mesh(net))
        self.assertEqual(found["fix"], sorted({8, *corners}))
        self.assertEqual(net_settings.words(net)["handles"], {9: (1.0, 200.0, 3500.0)})
        self.assertEqual([glide.place for glide in found["constraints"].glide], [1500.0])
        api.set_net(
            net, net="stress", load_area="1.5 kN/m2", load="500 N", supports=["boundary", 9]
        )
        self.assertAlmostEqual(net.AreaWeight, 1.5e-6, delta=1e-20)
        self.assertEqual((net.VertexWeight, net.SupportRule), (0.5, "boundary,9"))
        for wrong in ({"handles": "9:1,2"}, {"load_area": "1 kN/m"}, {"glide": ["z=up"]}):
            with self.assertRaises(InputError):
                api.set_net(net, **wrong)

    def test_set_net_is_one_step_and_refusals_change_nothing(self):
        net = self.imported()
        steps = self.document.UndoCount
        api.set_net(net, net="geodesic", fix="corners")
        self.assertEqual((net.NetType, net.FixRule), ("geodesic", "corners"))
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.document.undo()
        self.assertEqual((net.NetType, net.FixRule), ("principal", "none"))
        box = self.shape(Part.makeBox(10, 10, 10))
        box.Placement.Base.x = 1e7
        before = net_settings.words(net)
        for mode in (1, 0):
            self.document.UndoMode = mode
            for wrong in (
                {"net": "fishing"},
                {"fix": "0,x"},
                {"fix": [9999]},
                {"radius": -1},
                {"isometry": -2},
                {"forces": "both"},
                {"symmetry": "w"},
                {"handles": [1, 2]},
                {"glide": ["q=3"]},
                {"glide": [(box, "Edge99")]},
                {"glide": [(box, "Edge1")]},
                {"close_to": [(box, "Edge1")]},
                {"reference": box},
                {"speed": 3},
                {"length": 150.0},
                {"supports": [3]},
            ):
                with self.subTest(mode=mode, wrong=str(wrong)), self.assertRaises(InputError):
                    api.set_net(net, **{"net": "cmc", **wrong})
                self.assertEqual(net_settings.words(net), before)


class TestGuides(DocumentCase):
    def test_boundary_glides_on_a_real_curve(self):
        net = self.imported()
        mesh = convert.quad_mesh(net)
        side = mesh.vertices[:7]
        poles = [FreeCAD.Vector(*point) for point in side]
        curve = Part.BSplineCurve()
        curve.interpolate(poles)
        edge = self.shape(curve.toShape())
        api.optimise_net(net, glide=[(edge, "Edge1")])
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        shape = edge.Shape.Edge1
        misses = [shape.distToShape(Part.Vertex(p))[0] for p in net.Vertices[:7]]
        self.assertLess(max(misses), 1e-3 * mesh.mean_edge)
        self.assertEqual(net_settings.words(net)["glide"], [(edge, "Edge1")])

    def test_boundary_glides_on_an_oblique_plane(self):
        net = self.imported()
        mesh = convert.quad_mesh(net)
        side = mesh.vertices[:7]
        # A plane through the side's chord that leans outwards.
        normal = np.cross(side[-1] - side[0], [0.3, 0.0, 1.0])
        normal /= np.linalg.norm(normal)
        offset = (side @ normal).mean()
        plane = Part.makePlane(10, 10, FreeCAD.Vector(*(normal * offset)), FreeCAD.Vector(*normal))
        face = self.shape(plane)
        api.optimise_net(net, glide=[(face, "Face1", list(range(7)))])
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        np.testing.assert_allclose(vertices(net)[:7] @ normal, offset, atol=1e-5)

    def test_all_vertices_glide_on_a_curved_face(self):
        i, j = np.meshgrid(np.linspace(-0.4, 0.4, 7), np.linspace(0, 6000, 6), indexing="ij")
        points = np.stack([1e4 * np.sin(i + j / 4e4), j, 1e4 * np.cos(i + j / 4e4)], axis=2)
        net = api.import_net(tools.write_grid("barrel", points), self.document)
        cylinder = Part.makeCylinder(
            1e4, 8000, FreeCAD.Vector(0, -1000, 0), FreeCAD.Vector(0, 1, 0)
        )
        guide = self.shape(cylinder)
        number = next(
            k + 1 for k, f in enumerate(cylinder.Faces) if f.Surface.TypeId == "Part::GeomCylinder"
        )
        api.optimise_net(net, net="orthogonal", glide=[(guide, f"Face{number}")])
        radius = np.linalg.norm(vertices(net)[:, [0, 2]], axis=1)
        # The face is followed to a thousandth of a mean edge.
        np.testing.assert_allclose(radius, 1e4, atol=2e-3 * convert.quad_mesh(net).mean_edge)

    def test_a_guide_that_has_gone(self):
        net = self.imported()
        box = self.shape(Part.makeBox(1e5, 1e5, 10))
        api.set_net(net, close_to=[(box, "Face6")])
        self.document.removeObject(box.Name)
        self.document.recompute()
        self.assertEqual(net_settings.words(net)["close_to"], [])
        api.optimise_net(net)

    def test_a_guide_does_not_make_the_net_stale(self):
        net = self.imported()
        box = self.shape(Part.makeBox(1e5, 1e5, 10))
        api.set_net(net, close_to=[(box, "Face6")])
        beams = api.add_beams(net)
        box.Shape = Part.makeBox(10, 10, 10)
        self.document.recompute()
        self.assertIn("Up-to-date", beams.State)


class TestDragNet(DocumentCase):
    def test_one_step_that_is_a_net_and_undoes(self):
        net = self.imported()
        api.optimise_net(net)
        start, steps = vertices(net), self.document.UndoCount
        place = start[24] + [0, 0, 800]
        api.drag_net(net, {24: tuple(place), 0: tuple(start[0])})
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.assertLessEqual(max(tools.faults(net)), 1e-10)
        self.assertLess(np.linalg.norm(vertices(net)[24] - place), 300)
        self.document.undo()
        self.assertEqual(vertices(net).tobytes(), start.tobytes())

    def test_refusals_change_nothing(self):
        net = self.imported()
        api.set_net(net, fix=[0])
        before, steps = vertices(net), self.document.UndoCount
        for wrong in ({999: (0, 0, 0)}, {}, {3: (0, 0)}, {3: (0, 0, np.nan)}, {0: (0, 0, 1)}):
            with self.subTest(wrong), self.assertRaises(InputError):
                api.drag_net(net, wrong)
        self.assertEqual(vertices(net).tobytes(), before.tobytes())
        self.assertEqual(self.document.UndoCount, steps)

    def test_a_vertex_can_be_a_handle_of_an_optimisation_too(self):
        net = self.imported()
        place = vertices(net)[24] + [0, 0, 500]
        api.optimise_net(net, handles={24: tuple(place)})
        self.assertLess(np.linalg.norm(vertices(net)[24] - place), 300)
        self.assertEqual(net.Handles, [24])


class TestDocumentation(DocumentCase):
    def test_macro_of_the_page_on_editing(self):
        text = (tools.ROOT / "docs" / "editing.md").read_text(encoding="utf-8")
        macro = text.split("```python\n")[1].split("```")[0]
        names = {}
        exec(macro, names)
        self.assertEqual(names["net"].FixRule, "boundary")
        self.assertEqual(names["net"].CloseTo[0][0], names["box"])
