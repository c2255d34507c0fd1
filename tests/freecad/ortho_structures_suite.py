"""Structures in documents: lines, materials, updating, baking. Run by FreeCAD without a window."""

import json

import FreeCAD
import ortho_suite_tools as tools
from ortho_suite_cases import DocumentCase

from freecad_ortho import api
from freecad_ortho.fabrication import SYSTEMS
from freecad_ortho.objects.system_properties import options_of, property_name
from solver.errors import InputError


class StructureCase(DocumentCase):
    def setUp(self):
        super().setUp()
        self.net = api.import_net(tools.wavy_mesh(), self.document)
        api.optimise_net(self.net)


class TestSettings(StructureCase):
    def test_every_option_of_every_system_is_a_property(self):
        for system in SYSTEMS:
            try:
                feature = api.add_structure(self.net, system)
            except InputError as error:
                # Some systems ask for another net than this one; they must say so.
                self.assertIn("optimise", str(error), system)
                continue
            for option in options_of(system):
                self.assertIn(property_name(option), feature.PropertiesList)
            self.assertEqual(len(feature.PartNames), len(feature.Shape.Solids), system)
            self.assertTrue(feature.Shape.isValid(), system)

    def test_lines_of_a_family_alone(self):
        whole = api.add_structure(self.net, "beams")
        some = api.add_structure(self.net, "beams", family="u", lines=[0, 2])
        self.assertLess(len(some.PartNames), len(whole.PartNames))
        self.assertLess(set(some.PartNames), set(whole.PartNames))
        some.Lines = []
        self.document.recompute()
        every_u = set(some.PartNames)
        some.Family = "V"
        self.document.recompute()
        self.assertEqual(every_u | set(some.PartNames), set(whole.PartNames))
        self.assertFalse(every_u & set(some.PartNames))

    def test_material_and_density_change_the_mass(self):
        steel = json.loads(api.add_structure(self.net, "beams").Report)
        light = json.loads(api.add_structure(self.net, "beams", material="aluminium").Report)
        self.assertAlmostEqual(light["mass_kg"] / steel["mass_kg"], 2700 / 7850, places=9)
        own = json.loads(api.add_structure(self.net, "beams", density=1000.0).Report)
        self.assertAlmostEqual(own["mass_kg"] / steel["mass_kg"], 1000 / 7850, places=9)

    def test_lengths_in_any_unit_and_bad_ones_refused(self):
        feature = api.add_structure(self.net, "beams", height="0.3 m", thickness="1 cm")
        self.assertEqual((feature.Height.Value, feature.Thickness.Value), (300.0, 10.0))
        count = len(self.document.Objects)
        for wrong in (
            {"height": "tall"},
            {"height": -1.0},
            {"colour": 3},
            {"offset": "inside"},
            {"family": "w"},
            {"lines": [99]},
            {"material": "cheese"},
        ):
            with self.assertRaises(InputError, msg=str(wrong)):
                api.add_structure(self.net, "beams", **wrong)
        with self.assertRaises(InputError):
            api.add_structure(self.net, "walls")
        self.assertEqual(len(self.document.Objects), count)

    def test_verdicts_belong_to_the_parts(self):
        beams = api.add_structure(self.net, "beams")
        self.assertEqual(beams.Verdicts, ["ok"] * len(beams.PartNames))


class TestUpdating(StructureCase):
    def test_on_request_the_shape_waits_and_keeps_its_mark(self):
        beams = api.add_beams(self.net)
        beams.AutomaticUpdate = False
        before = beams.Shape.Volume
        beams.Thickness = 24.0
        self.document.recompute()
        self.assertEqual(beams.Shape.Volume, before)
        self.assertIn("Touched", beams.State)
        self.assertEqual(api.update_structures(self.document), [beams])
        self.assertGreater(beams.Shape.Volume, 1.8 * before)
        self.assertNotIn("Touched", beams.State)
        self.document.undo()
        self.assertEqual(beams.Shape.Volume, before)


class TestBaking(StructureCase):
    def test_a_structure_becomes_one_feature_a_part(self):
        beams = api.add_beams(self.net)
        (group,) = api.bake(beams)
        self.assertEqual([part.Label for part in group.Group], beams.PartNames)
        self.assertTrue(all(part.TypeId == "Part::Feature" for part in group.Group))
        total = sum(part.Shape.Volume for part in group.Group)
        self.assertAlmostEqual(total, beams.Shape.Volume, delta=1e-9 * total)
        self.document.undo()
        self.assertEqual(len(self.document.Objects), 2)

    def test_a_net_becomes_a_mesh_and_its_edges(self):
        (group,) = api.bake([self.net])
        mesh, edges = group.Group
        self.assertEqual(mesh.Mesh.CountFacets, 2 * 30)
        self.assertEqual(mesh.Mesh.CountPoints, 42)
        self.assertEqual(len(edges.Shape.Edges), 71)

    def test_anything_else_is_refused(self):
        box = self.document.addObject("Part::Box", "Box")
        for wrong in (box, [], [self.net, box]):
            with self.assertRaises(InputError):
                api.bake(wrong)
        self.assertEqual(len(self.document.Objects), 2)


class TestBentPanels(StructureCase):
    def test_a_name_with_a_hyphen_makes_an_object_that_follows_its_sizes(self):
        panels = api.add_structure(self.net, "bent-panels", family="v")
        self.assertEqual((panels.Name, panels.Label), ("Bentpanels", "Bent-panels"))
        self.assertTrue(panels.Shape.isValid())
        self.assertTrue(all(name.startswith("R-V") for name in panels.PartNames))
        volume = panels.Shape.Volume
        panels.Thickness = 6.0
        self.document.recompute()
        self.assertGreater(panels.Shape.Volume, 1.9 * volume)


class TestCopying(StructureCase):
    def test_a_copy_in_another_document_lives_on_its_own(self):
        beams = api.add_beams(self.net)
        other = FreeCAD.newDocument("Other")
        copy = other.copyObject(beams, True)
        other.recompute()
        self.assertIsNot(copy.Net, self.net)
        self.assertEqual(copy.PartNames, beams.PartNames)
        self.assertAlmostEqual(copy.Shape.Volume, beams.Shape.Volume, places=3)
        copy.Thickness = 2 * beams.Thickness.Value
        other.recompute()
        self.assertGreater(copy.Shape.Volume, 1.8 * beams.Shape.Volume)
