"""Where things stand: parts that contain them, placements by hand, coordinates far from the origin.

Run by FreeCAD without a window.
"""

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
import Part
from ortho_places_tools import OFFSET, SMALL, TURNED, PlaceCase, placed

from freecad_ortho import api, convert
from freecad_ortho.objects import cad_faces, constraints, places
from solver.errors import InputError
from solver.mesh.local_origin import LocalOrigin


class TestFar(PlaceCase):
    def test_a_far_net_is_put_near_and_goes_back_where_it_is_written(self):
        path = self.far_file()
        net = api.import_net(path, self.document)
        self.assertLess(np.abs(tools.vertices(net)[:, :2]).max(), 1e6)
        taken = LocalOrigin.of_mesh(api.read_mesh(path).mesh).scaled(1000)
        np.testing.assert_allclose(places.origin(net), taken.shift, rtol=1e-15)
        self.assertGreater(taken.shift[1], 5e9)
        for choice, point in (("keep", [0, 0, 0]), ("local", places.origin(net)), ([7, 8, 9],) * 2):
            out = tools.SCRATCH / "out.obj"
            api.export_net(net, out, origin=choice)
            written = api.read_mesh(out)
            self.assertEqual(written.unit, "m")
            expected = api.read_mesh(path).mesh.vertices - np.array(point) / 1000
            np.testing.assert_allclose(written.mesh.vertices, expected, rtol=0, atol=2e-9)
        api.export_net(net, out)
        self.assertEqual(
            api.read_mesh(out).mesh.vertices.tobytes(), api.read_mesh(path).mesh.vertices.tobytes()
        )
        with self.assertRaisesRegex(InputError, "expected keep, local"):
            api.export_net(net, out, origin="there")

    def test_nets_of_one_site_keep_their_places_beside_each_other(self):
        first = api.import_net(self.far_file(), self.document)
        second = api.import_net(self.far_file("b", OFFSET + [60000, 60000, 0]), self.document)
        self.assertEqual(first.Origin, second.Origin)
        way = tools.vertices(second) - tools.vertices(first)
        np.testing.assert_allclose(way, np.tile([60000, 60000, 0], (len(way), 1)), atol=2e-6)
        derived = api.change_net(first, "subdivide")
        self.assertEqual(derived.Origin, first.Origin)
        kept = api.import_net(self.far_file(), self.document, origin="keep")
        self.assertFalse(kept.Origin.Length)
        self.assertGreater(tools.vertices(kept)[:, 1].min(), 5e9)

    def test_results_and_solids_are_those_of_the_same_net_near_the_origin(self):
        near = self.imported(**SMALL)
        nets = [
            near,
            api.import_net(self.far_file(), self.document),
            api.import_net(self.far_file(), self.document, origin="keep"),
        ]
        found = []
        for net in nets:
            outcome = api.optimise_net(net)
            beams = api.add_structure(net, "beams")
            panels = api.add_structure(net, "panels", beams=beams)
            for item in (beams, panels):
                self.assertEqual(item.State, ["Up-to-date"])
                own = item.Shape.copy()
                own.Placement = FreeCAD.Placement()
                self.assertTrue(all(solid.isValid() for solid in own.Solids), item.Label)
            points, report = self.written([beams, panels])
            origin = np.array(report["file_origin_mm"])
            found.append((outcome.report, points, origin, beams.Shape.Volume))
        for report, points, origin, volume in found[1:]:
            self.assertEqual(report.iterations, found[0][0].iterations)
            self.assertEqual(report.status, "converged")
            self.assertGreater(np.abs(origin).max(), 5e9)
            moved = {name: place + origin - OFFSET for name, place in points.items()}
            self.assertSamePlaces(moved, found[0][1])
            self.assertAlmostEqual(volume / found[0][3], 1.0, places=5)
        self.assertFalse(found[0][2].any())

    def test_parts_in_place_open_in_freecad_with_their_names(self):
        import Import

        expected, _ = self.written(api.add_structure(self.imported(), "beams"), step="in-place")
        for group in ("", "/hSTEP"):
            chosen = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Import" + group)
            # FreeCAD 0.20 crashes where groups have no shape of their own.
            chosen.SetBool("UseLinkGroup", FreeCAD.Version()[0] != "0")
            self.addCleanup(chosen.RemBool, "UseLinkGroup")
        Import.open(str(tools.SCRATCH / "files" / "structure.step"))
        things = [thing for thing in FreeCAD.ActiveDocument.Objects if hasattr(thing, "Shape")]
        # FreeCAD 1.0 says the group's own shape too, which has no centre of mass.
        solids = [thing for thing in things if thing.Shape.ShapeType == "Solid"]
        found = {part.Label: tuple(part.Shape.CenterOfMass) for part in solids}
        self.assertSamePlaces(found, expected)

    def test_kept_coordinates_in_files_and_far_nets_baked(self):
        net = api.import_net(self.far_file(), self.document)
        beams = api.add_structure(net, "beams")
        local, _ = self.written(beams)
        kept, report = self.written(beams, origin="keep")
        self.assertEqual(report["file_origin_mm"], [0, 0, 0])
        shift = places.origin(net)
        self.assertSamePlaces({n: p - shift for n, p in kept.items()}, local)
        far = api.import_net(self.far_file(), self.document, origin="keep")
        mesh = api.bake(far)[0].Group[0]
        box = mesh.Mesh.BoundBox
        span = np.ptp(tools.vertices(far), axis=0)
        np.testing.assert_allclose([box.XLength, box.YLength, box.ZLength], span, atol=1.0)


class TestMovedByHand(PlaceCase):
    def setUp(self):
        super().setUp()
        self.net = self.imported(**SMALL)
        api.optimise_net(self.net)
        self.beams = api.add_structure(self.net, "beams")

    def test_a_structure_is_written_where_it_is_seen_and_stays_there(self):
        before, _ = self.written(self.beams)
        self.assertSamePlaces(before, self.seen(self.beams))
        self.beams.Placement = TURNED
        self.document.recompute()
        self.assertTurned(self.beams)
        after, _ = self.written(self.beams)
        self.assertSamePlaces(after, self.seen(self.beams))
        self.assertGreater(np.linalg.norm(after["B0001"] - before["B0001"]), 1000)
        # Built anew it is where it was put.
        self.beams.Height = 300.0
        self.document.recompute()
        self.assertTurned(self.beams)
        taller, _ = self.written(self.beams)
        self.assertSamePlaces(taller, self.seen(self.beams))
        (baked,) = api.bake(self.beams)
        centres = [np.array(tuple(item.Shape.CenterOfMass)) for item in baked.Group]
        self.assertSamePlaces(dict(zip(self.beams.PartNames, centres, strict=True)), taller)

    def test_what_is_moved_and_saved_opens_where_it_was(self):
        self.beams.Placement = TURNED
        self.document.recompute()
        seen, name = self.seen(self.beams), self.beams.Name
        beams = self.reopened("moved.FCStd").getObject(name)
        self.assertSamePlaces(self.seen(beams), seen)
        beams.Height = 220.0
        self.document.recompute()
        self.assertTurned(beams)

    def test_structures_that_were_moved_apart_are_not_written_together(self):
        panels = api.add_structure(self.net, "panels", beams=self.beams)
        self.written([self.beams, panels])
        panels.Placement.Base.z = 1000
        with self.assertRaisesRegex(InputError, "were moved apart; give them the same Placement"):
            self.written([self.beams, panels])
        self.beams.Placement = panels.Placement
        self.written([self.beams, panels])

    def test_flat_patterns_stay_where_they_were_put(self):
        flat = api.add_flat_patterns(self.beams)
        flat.Placement = TURNED
        page = api.add_drawing_page(flat)
        self.beams.Height = 260.0
        self.document.recompute()
        self.assertTurned(flat)
        self.assertIsNotNone(page)

    def test_a_net_that_left_its_source_has_its_placement_locked(self):
        net = api.add_primitive("sphere", sampling=(9, 9))
        self.assertNotIn("ReadOnly", net.getPropertyStatus("Placement"))
        api.optimise_net(net)
        self.assertIn("ReadOnly", net.getPropertyStatus("Placement"))
        net.FollowSource = True
        self.assertNotIn("ReadOnly", net.getPropertyStatus("Placement"))


class TestLinks(PlaceCase):
    def link(self, feature, part=None):
        make = self.document.addObject if part is None else part.newObject
        link = make("App::Link", "Link")
        link.LinkedObject = feature
        link.Placement = TURNED
        self.document.recompute()
        return link

    def assertRefused(self, action, link, linked):
        words = f"Link.*: is a link to {linked.Label}, .*take {linked.Label}"
        count, undo = len(self.document.Objects), self.document.UndoCount
        with self.assertRaisesRegex(InputError, words):
            action(link)
        self.assertEqual((len(self.document.Objects), self.document.UndoCount), (count, undo))

    def test_nothing_is_made_of_a_link_to_a_net_or_a_structure(self):
        import Mesh

        net = self.imported(**SMALL)
        beams = api.add_structure(net, "beams")
        flat = api.add_flat_patterns(beams)
        mesh = self.document.addObject("Mesh::Feature", "Mesh")
        mesh.Mesh = Mesh.createSphere(1000.0, 10)
        for part in (None, self.part()):
            for shown, actions in (
                (
                    net,
                    (
                        lambda link: api.add_structure(link, "panels"),
                        api.optimise_net,
                        lambda link: api.change_net(link, "subdivide"),
                        lambda link: api.export_net(link, tools.SCRATCH / "link.obj"),
                        lambda link: api.weld_nets([net, link]),
                        lambda link: api.optimise_net(net, close_to=[(link, "")]),
                        api.bake,
                    ),
                ),
                (
                    beams,
                    (
                        lambda link: api.change_structure(link, height=300),
                        lambda link: api.add_structure(net, "panels", beams=link),
                        api.add_flat_patterns,
                        lambda link: api.export_fabrication([link], tools.SCRATCH / "link"),
                        lambda link: api.bake([beams, link]),
                    ),
                ),
                (flat, (api.add_drawing_page,)),
                (
                    mesh,
                    (
                        api.quads_from_mesh,
                        lambda link: api.optimise_net(net, close_to=[(link, "")]),
                    ),
                ),
            ):
                link = self.link(shown, part)
                for action in actions:
                    self.assertRefused(action, link, shown)
        # What the links show is as it was, and not taken along.
        self.assertIsNone(net.getParentGeoFeatureGroup())
        self.assertSamePlaces(self.written(beams)[0], self.seen(beams))

    def test_faces_of_a_link_are_where_it_is_seen(self):
        plate = self.shape(Part.makePlane(8000, 6000), "Plate")
        raised = FreeCAD.Placement(FreeCAD.Vector(0, 0, 7000), FreeCAD.Rotation())
        for part, placements in (
            (None, (TURNED,)),
            (self.part(placement=raised), (raised, TURNED)),
        ):
            net = api.net_from_faces((self.link(plate, part), "Face1"), sampling=(5, 4))
            for corner in placed([[0, 0, 0], [8000, 6000, 0]], *placements):
                nearest = np.linalg.norm(tools.vertices(net) - corner, axis=1).min()
                self.assertLess(nearest, 1e-6)


class TestInParts(PlaceCase):
    def setUp(self):
        super().setUp()
        self.net = self.imported(**SMALL)
        self.outer = self.part(
            placement=FreeCAD.Placement(FreeCAD.Vector(0, 0, 9000), FreeCAD.Rotation())
        )
        self.inner = self.part(self.net)
        self.outer.addObject(self.inner)
        api.optimise_net(self.net)

    def test_what_is_made_of_a_net_is_in_its_part_and_written_where_it_is_seen(self):
        beams = api.add_structure(self.net, "beams")
        fine = api.change_net(self.net, "subdivide")
        (baked,) = api.bake(self.net)
        for item in (beams, fine, baked):
            self.assertIs(item.getParentGeoFeatureGroup(), self.inner)
        centres, _ = self.written(beams)
        self.assertSamePlaces(centres, self.seen(beams))
        own = dict(
            zip(
                beams.PartNames,
                [np.array(tuple(solid.CenterOfMass)) for solid in beams.Shape.Solids],
                strict=True,
            )
        )
        expected = {
            name: placed([place], self.outer.Placement, self.inner.Placement)[0]
            for name, place in own.items()
        }
        self.assertSamePlaces(centres, expected)
        out = tools.SCRATCH / "out.obj"
        api.export_net(self.net, out)
        np.testing.assert_allclose(
            api.read_mesh(out).mesh.vertices,
            placed(tools.vertices(self.net), self.outer.Placement, self.inner.Placement),
            atol=1e-6,
        )

    def test_a_structure_outside_the_part_stands_on_the_net_where_it_is_seen(self):
        inside = api.add_structure(self.net, "beams")
        outside = api.add_structure(self.net, "beams")
        self.inner.removeObject(outside)
        outside.touch()
        self.document.recompute()
        self.assertSamePlaces(self.seen(outside), self.seen(inside))
        self.assertSamePlaces(self.written(outside)[0], self.written(inside)[0])

    def test_guides_count_where_they_are_seen(self):
        points = placed(tools.vertices(self.net), self.outer.Placement, self.inner.Placement)
        rim = convert.quad_mesh(self.net).connectivity.boundary_loops[0]
        wire = Part.makePolygon([FreeCAD.Vector(*points[k]) for k in rim[:2]])
        edge = self.shape(wire, "Guide")
        (glide,) = constraints.glides([(edge, "Edge1")], convert.quad_mesh(self.net), self.net)
        self.assertTrue(set(rim[:2].tolist()) <= set(glide.vertices.tolist()))
        np.testing.assert_allclose(
            np.sort(glide.points[[0, -1]], axis=0),
            np.sort(tools.vertices(self.net)[rim[:2]], axis=0),
            atol=1e-6,
        )
        other = self.imported(name="other", **SMALL)
        points, _ = constraints.close_to([(other, "")], convert.quad_mesh(self.net), self.net)
        seen = placed(points, self.outer.Placement, self.inner.Placement)
        np.testing.assert_allclose(
            np.sort(seen, axis=0), np.sort(tools.vertices(other), axis=0), atol=1e-6
        )

    def test_nets_from_faces_and_nets_of_other_parts_stay_where_they_are_seen(self):
        plate = self.shape(Part.makePlane(8000, 6000), "Plate")
        net = api.net_from_faces((plate, "Face1"), sampling=(5, 4))
        before = tools.vertices(net)
        # FreeCAD takes along what an object is linked to.
        self.inner.addObject(net)
        net.touch()
        self.document.recompute()
        self.assertIs(plate.getParentGeoFeatureGroup(), self.inner)
        np.testing.assert_allclose(tools.vertices(net), before, atol=1e-6)
        outside = self.imported(name="outside", **SMALL)
        both = api.weld_nets([outside, self.net])
        count = len(tools.vertices(outside))
        np.testing.assert_allclose(
            tools.vertices(both)[count:],
            placed(tools.vertices(self.net), self.outer.Placement, self.inner.Placement),
            atol=1e-6,
        )

    def test_a_mesh_in_a_part_is_remeshed_where_it_is_seen(self):
        import Mesh

        mesh = self.document.addObject("Mesh::Feature", "Mesh")
        mesh.Mesh = Mesh.createSphere(1000.0, 10)
        self.part(mesh)
        points, _ = cad_faces.triangles_of(mesh)
        np.testing.assert_allclose(points.mean(axis=0), tuple(TURNED.Base), atol=150)
