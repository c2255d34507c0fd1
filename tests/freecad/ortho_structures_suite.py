"""Structures in documents: lines, materials, updating, baking. Run by FreeCAD without a window."""

import json
import math

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
from ortho_suite_cases import StructureCase

from freecad_ortho import api
from freecad_ortho.fabrication import SYSTEMS
from freecad_ortho.objects import structure
from freecad_ortho.objects.system_properties import options_of, values
from solver.errors import InputError


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
                self.assertIn(option.parts[0], feature.PropertiesList)
            self.assertEqual(len(feature.PartNames), len(feature.Shape.Solids), system)
            self.assertTrue(feature.Shape.isValid(), system)

    def test_an_angle_is_one_and_that_of_an_older_document_still_counts(self):
        louvres = api.add_structure(self.net, "louvres", tilt="0.5 rad")
        self.assertEqual(louvres.getTypeIdOfProperty("Tilt"), "App::PropertyAngle")
        self.assertAlmostEqual(louvres.Tilt.Value, math.degrees(0.5))
        middles = [solid.BoundBox.ZLength for solid in louvres.Shape.Solids]
        louvres.removeProperty("Tilt")
        louvres.addProperty("App::PropertyFloat", "Tilt", "Structure")
        louvres.Tilt = math.degrees(0.5)
        louvres.Proxy.onDocumentRestored(louvres)
        self.document.recompute()
        again = [solid.BoundBox.ZLength for solid in louvres.Shape.Solids]
        np.testing.assert_allclose(again, middles, rtol=1e-9)
        api.change_structure(louvres, tilt=10.0)
        self.assertEqual(louvres.Tilt, 10.0)

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

    def test_structures_of_different_materials_go_into_one_export(self):
        beams = api.add_structure(self.net, "beams")
        unit = "glass:5/14/5"
        panels = api.add_structure(self.net, "panels", beams=beams, material=unit)
        self.assertEqual((panels.Material, panels.Thickness.Value), (unit.capitalize(), 24.0))
        panels.LimitGap = 5.0
        folder = tools.SCRATCH / "mixed"
        api.export_fabrication([beams, panels], folder)
        report = json.loads((folder / "report.json").read_text())
        self.assertEqual(set(report["materials"]), {"steel", unit})
        self.assertEqual(report["clash_check"]["clashes"], [])
        own = sum(json.loads(feature.Report)["mass_kg"] for feature in (beams, panels))
        self.assertAlmostEqual(report["mass_kg"], own, places=6)

    def test_rows_larger_than_a_sheet_are_cut_to_it_with_joints(self):
        whole = api.add_structure(self.net, "bent-panels", family="u")
        box = whole.Shape.BoundBox
        long = round(0.6 * max(box.XLength, box.YLength))
        sheet = f"{long}x{long}"
        rows = api.add_bent_panels(self.net, family="u", sheet=sheet, spacing=20.0, grain="along")
        self.assertGreater(len(rows.PartNames), len(whole.PartNames))
        self.assertEqual((rows.Sheet, rows.Spacing.Value, rows.Grain), (sheet, 20.0, "Along"))
        self.assertIn("cut along lines of the net", " ".join(json.loads(rows.Report)["messages"]))
        sizes = {"sheet": (long, long), "spacing": 20.0, "grain": "along"}
        with self.assertRaisesRegex(InputError, "not fit"):
            api.add_flat_patterns(whole, **sizes)
        self.assertFalse(api.add_flat_patterns(rows, **sizes).TooLarge)
        with self.assertRaisesRegex(InputError, "sheet"):
            api.change_structure(rows, sheet="wide")
        api.change_structure(rows, sheet=None)
        self.assertEqual(rows.PartNames, whole.PartNames)
        api.change_structure(rows, piece_length=f"{0.6 * long:.0f} mm")
        report = json.loads(rows.Report)["bent-panels"]
        self.assertEqual(report["pieces"], len(rows.PartNames))
        self.assertGreater(len(rows.PartNames), len(whole.PartNames))
        self.assertLessEqual(report["piece_length_max_mm"], rows.PieceLength.Value)

    def test_a_third_layer_of_lamellas_is_a_setting_of_theirs(self):
        lamellas = api.add_lamellas(self.net, position="lying", layers=2)
        two = set(lamellas.PartNames)
        lamellas.Diagonals = "First"
        self.document.recompute()
        self.assertEqual(lamellas.State, ["Up-to-date"])
        added = set(lamellas.PartNames) - two
        self.assertTrue(added and all(name.startswith("L-D") for name in added))
        api.change_structure(lamellas, diagonals="none")
        self.assertEqual(set(lamellas.PartNames), two)

    def test_every_system_has_a_function(self):
        plane_lines = api.import_net(tools.wavy_mesh())
        for name in SYSTEMS:
            function = getattr(api, f"add_{name.replace('-', '_')}")
            feature = function(plane_lines if name == "arches" else self.net)
            self.assertEqual(structure.TITLES[feature.System], name)
            usual = {option.name: option.default for option in options_of(name)}
            self.assertEqual(values(feature, name), usual, name)
            self.document.removeObject(feature.Name)
        panels = api.add_panels(self.net, panel_thickness="10 mm")
        self.assertEqual(panels.Thickness.Value, 10.0)
        with self.assertRaisesRegex(InputError, "^panel_thickness: beams have no such setting"):
            api.add_structure(self.net, "beams", panel_thickness=10.0)
        beams = api.add_beams(self.net, "0.3 m", section="hollow", ends="hub", lines=[0])
        self.assertEqual((beams.Height.Value, beams.Section), (300.0, "Hollow"))
        self.assertEqual((beams.Ends, beams.Lines), ("Hub", [0]))
        nodes = api.add_nodes(self.net, beams, lines=[0])
        self.assertIs(nodes.OnBeams, beams)

    def test_sections_of_the_catalogue_are_constant_whatever_the_height_says(self):
        beams = api.add_beams(self.net, "0.3 m", section="HEB160", ends="hub", hub_diameter=300)
        self.assertEqual((beams.Height.Value, beams.Section), (300.0, "HEB160"))
        self.assertEqual(json.loads(beams.Report)["beams"]["height_max_mm"], 160.0)
        self.assertTrue(beams.Shape.isValid())
        sharp = beams.Shape.Volume
        api.change_structure(beams, rounded=True)
        self.assertTrue(beams.Shape.isValid())
        self.assertGreater(beams.Shape.Volume, 1.005 * sharp)
        # One of the list, one of one's own, and back.
        for word, shown in (("tube:100x60x5", "Tube:100x60x5"), ("tube:90x50x4", "tube:90x50x4")):
            api.change_structure(beams, section=word)
            self.assertEqual(beams.Section, shown)
            self.assertEqual(json.loads(beams.Report)["beams"]["section"], word)
        with self.assertRaisesRegex(InputError, "there is no HEB165"):
            api.change_structure(beams, section="HEB165")
        self.assertEqual(beams.Section, "tube:90x50x4")
        beams.Section = "GL24h:80x200"
        self.document.recompute()
        self.assertEqual(set(json.loads(beams.Report)["materials"]), {"GL24h"})
        api.change_structure(beams, section="plate", material="S235")
        self.assertEqual((beams.Section, beams.Material), ("Plate", "S235"))
        self.assertEqual(json.loads(beams.Report)["beams"]["height_mm"], 300.0)

    def test_mitred_beams_end_before_the_hubs_that_join_them(self):
        beams = api.add_beams(self.net)
        long, steps = beams.Shape.Volume, self.document.UndoCount
        with self.assertRaises(InputError):
            api.add_structure(self.net, "nodes", beams=beams, bore=99)
        self.assertEqual((beams.Ends, beams.State), ("Mitred", ["Up-to-date"]))
        nodes = api.add_structure(self.net, "nodes", beams=beams)
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.assertEqual((beams.Ends, beams.State), ("Hub", ["Up-to-date"]))
        self.assertLess(beams.Shape.Volume, long)
        api.export_fabrication([beams, nodes], tools.SCRATCH / "hubs")
        self.document.undo()
        self.assertEqual(beams.Ends, "Mitred")
        self.assertAlmostEqual(beams.Shape.Volume / long, 1.0, places=9)

    def test_beams_that_bolted_nodes_join_have_end_plates(self):
        beams = api.add_beams(self.net)
        nodes = api.add_nodes(self.net, beams, node="bolted")
        self.assertEqual((beams.Ends, beams.State), ("End-plate", ["Up-to-date"]))
        plates = [name for name in nodes.PartNames if name.startswith("B")]
        self.assertEqual(len(plates), 2 * len(beams.PartNames))
        api.change_structure(beams, bolt="M20", bolts=1)
        self.document.recompute()
        report = json.loads(nodes.Report)["nodes"]
        self.assertEqual((report["bolts"], report["bolt"][:3]), (len(plates), "M20"))

    def test_nodes_beams_and_panels_know_each_other(self):
        beams = api.add_structure(self.net, "beams", ends="hub", hub_diameter=160.0)
        first = api.add_structure(self.net, "panels", beams=beams)
        whole = first.Shape.Volume
        with self.assertRaises(InputError) as refused:
            lapped = api.add_structure(self.net, "beams", ends="lapped")
            api.add_structure(self.net, "nodes", beams=lapped)
        self.assertEqual(lapped.Ends, "Lapped")
        self.assertIn("leave no room for hubs", str(refused.exception))
        nodes = api.add_structure(self.net, "nodes", beams=beams)
        self.assertIs(first.OnNodes, nodes)
        self.assertLess(first.Shape.Volume, whole)
        self.assertEqual(first.State, ["Up-to-date"])
        second = api.add_structure(self.net, "panels", beams=beams)
        self.assertIs(second.OnNodes, nodes)
        self.assertAlmostEqual(second.Shape.Volume, first.Shape.Volume, places=3)
        folder = tools.SCRATCH / "joined"
        api.export_fabrication([beams, nodes, first], folder)
        report = json.loads((folder / "report.json").read_text())
        self.assertEqual(report["clash_check"]["clashes"], [])
        self.assertEqual(report["nodes"]["diameter_mm"], 160.0)
        self.document.removeObject(nodes.Name)
        self.document.recompute()
        self.assertAlmostEqual(first.Shape.Volume, whole, places=3)

    def test_beams_and_panels_end_at_the_edge_beam_whichever_was_there_first(self):
        beams = api.add_beams(self.net)
        whole = beams.Shape.Volume
        edge = api.add_edge_beam(self.net, edge_section="tube", edge_width="80 mm")
        self.assertEqual(edge.EdgeWidth.Value, 80.0)
        self.assertIs(beams.AtEdgeBeam, edge)
        self.assertEqual(beams.State, ["Up-to-date"])
        self.assertLess(beams.Shape.Volume, whole)
        panels = api.add_panels(self.net, beams=beams)
        self.assertIs(panels.AtEdgeBeam, edge)
        folder = tools.SCRATCH / "edge"
        api.export_fabrication([edge, beams, panels], folder)
        report = json.loads((folder / "report.json").read_text())
        self.assertEqual(report["clash_check"]["clashes"], [])
        self.assertTrue((folder / "edge-beam.csv").exists())
        panels.AtEdgeBeam = None
        with self.assertRaises(InputError) as refused:
            api.export_fabrication([beams, panels], folder)
        self.assertIn("AtEdgeBeam", str(refused.exception))
        panels.AtEdgeBeam = edge
        lamellas = api.add_lamellas(self.net)
        self.assertIs(lamellas.AtEdgeBeam, edge)
        self.assertEqual(lamellas.State, ["Up-to-date"])
        self.document.removeObject(lamellas.Name)
        shorter = beams.Shape.Volume
        api.change_structure(edge, edge_width="160 mm")
        self.assertLess(beams.Shape.Volume, shorter)
        self.document.removeObject(edge.Name)
        self.document.recompute()
        self.assertAlmostEqual(beams.Shape.Volume, whole, delta=1e-9 * whole)

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
        beams.Thickness = 40.0
        self.document.recompute()
        self.assertEqual(beams.Shape.Volume, before)
        self.assertIn("Touched", beams.State)
        self.assertEqual(api.update_structures(self.document), [beams])
        self.assertGreater(beams.Shape.Volume, 1.8 * before)
        self.assertNotIn("Touched", beams.State)
        self.document.undo()
        self.assertEqual(beams.Shape.Volume, before)


class TestStock(StructureCase):
    def test_lamellas_and_the_list_of_stock_have_one_length(self):
        lamellas = api.add_structure(
            self.net, "lamellas", family="u", lines=[0, 1], width=60.0, stock="6 m"
        )
        folder, whole = tools.SCRATCH / "stock", lamellas.PartNames

        def listed(**workshop):
            api.export_fabrication(lamellas, folder, **workshop)
            return json.loads((folder / "report.json").read_text(encoding="utf-8"))["stock"]

        steps = self.document.UndoCount
        self.assertEqual(listed()["length_mm"], 6000.0)
        self.assertEqual(self.document.UndoCount, steps)
        self.assertEqual(listed(stock="3 m")["length_mm"], 3000.0)
        self.assertEqual((lamellas.Stock.Value, lamellas.Outdated), (3000.0, False))
        self.assertGreater(len(lamellas.PartNames), len(whole))
        self.assertEqual(self.document.UndoCount, steps + 1)
        text = (folder / "parts.csv").read_text(encoding="utf-8")
        self.assertTrue(all(name in text for name in lamellas.PartNames))
        self.document.undo()
        self.assertEqual((lamellas.Stock.Value, lamellas.PartNames), (6000.0, whole))
        listed(stock=0)
        self.assertEqual(lamellas.Stock.Value, 0.0)
        self.assertLess(len(lamellas.PartNames), len(whole))
        for mode in (1, 0):
            self.document.UndoMode = mode
            before = list(lamellas.PartNames), self.document.UndoCount
            with self.assertRaisesRegex(InputError, "stock"):
                listed(stock="100 mm")
            self.assertEqual(lamellas.Stock.Value, 0.0)
            self.document.recompute()
            self.assertEqual((list(lamellas.PartNames), self.document.UndoCount), before)


class TestBaking(StructureCase):
    def test_a_structure_becomes_one_feature_a_part(self):
        beams = api.add_beams(self.net)
        (group,) = api.bake(beams)
        self.assertEqual([part.Label for part in group.Group], beams.PartNames)
        self.assertTrue(all(part.TypeId == "Part::Feature" for part in group.Group))
        for item in (group, *group.Group):
            self.assertIn("Up-to-date", item.State)
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
