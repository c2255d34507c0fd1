"""Structural checks in documents. Run by FreeCAD without a window."""

import json
import shutil
import unittest
from importlib.util import find_spec

import FreeCAD
import numpy as np
import ortho_suite_tools as tools
from ortho_suite_cases import DocumentCase

from freecad_ortho import api, convert
from solver.errors import InputError

LOADS = {"material": "S355", "snow": "1.5 kPa", "panels": 0.4, "wind": ["0.6@x"]}


class CheckCase(DocumentCase):
    def setUp(self):
        super().setUp()
        self.net = self.imported(rows=5, columns=6)

    def check(self, **more):
        return api.add_structural_check(self.net, **(LOADS | more))


class TestCheck(CheckCase):
    def test_results_are_those_of_the_check_without_a_document(self):
        check = self.check()
        alone = api.check_structure(
            convert.quad_mesh(self.net), material="S355", snow=1.5, panels=0.4, wind="0.6@x"
        )
        self.assertEqual(check.Verdict, alone.verdict)
        self.assertEqual(check.Passed, alone.passed)
        self.assertAlmostEqual(check.Utilisation, 100 * alone.utilisation.max())
        self.assertAlmostEqual(check.BucklingFactor, alone.factor)
        self.assertAlmostEqual(check.LargestDisplacement.Value, alone.deflection)
        self.assertEqual(len(check.MemberUtilisation), len(alone.model.frame.members))
        moves = np.linalg.norm(convert.array(check.Displacements), axis=1)
        self.assertAlmostEqual(moves.max(), alone.deflection)
        self.assertEqual(len(check.BucklingShapes), 5 * (30 + 49))
        most = int(alone.utilisation.argmax())
        by = alone.strength[int(alone.governing[most])]
        self.assertEqual(check.DiagramsOf, by.combination.name)
        along = np.array(check.ForcesAlong).reshape(-1, 3, 6)
        middle = by.response.forces_at(alone.model.frame, 0.5)[most]
        np.testing.assert_allclose(along[most, 1], middle / [1e3, 1e3, 1e3, 1e6, 1e6, 1e6])
        names = [one.combination.name for one in alone.found]
        self.assertEqual(check.CombinationNames, names)
        every = np.array(check.AllForcesAlong).reshape(len(names), -1, 3, 6)
        there = every[names.index(check.DiagramsOf)]
        np.testing.assert_allclose(there, along, rtol=0, atol=4e-6)
        # Short in binary: a saved document is about half as large.
        np.testing.assert_array_equal(np.rint(2**17 * there), 2**17 * there)
        everywhere = convert.array(check.AllDisplacements).reshape(len(names), -1, 3)
        for one, there in zip(alone.found, everywhere, strict=True):
            np.testing.assert_allclose(there, one.response.displacements[:, :3], atol=1e-9)
        self.assertEqual(json.loads(check.Report)["verdict"]["words"], alone.verdict)
        self.assertEqual(
            (check.Snow.Value, str(check.Snow.Unit)), (1.5, str(FreeCAD.Units.Pressure))
        )

    def test_it_follows_the_net_and_is_undone_in_one_step(self):
        before = len(self.document.Objects)
        check = self.check()
        used, name = check.Utilisation, check.Name
        points = self.net.Vertices
        points[14] = points[14] + FreeCAD.Vector(0, 0, 300)
        self.net.Vertices = points
        self.document.recompute()
        self.assertNotAlmostEqual(check.Utilisation, used, places=3)
        self.assertEqual(check.Nodes[14], points[14])
        self.document.undo()
        self.assertEqual(len(self.document.Objects), before)
        self.assertIsNone(self.document.getObject(name))

    def test_what_takes_long_waits_and_is_checked_on_demand(self):
        check = self.check()
        check.AutomaticUpdate = False
        self.document.recompute()
        self.assertFalse(check.Outdated)
        verdict = check.Verdict
        check.Snow = "5 kPa"
        self.document.recompute()
        self.assertEqual((check.Outdated, check.Verdict), (True, verdict))
        self.assertEqual(api.update_structures(self.document), [check])
        self.assertFalse(check.Outdated)
        self.assertNotEqual(check.Verdict, verdict)

    def test_it_is_saved_and_opened_again(self):
        check = self.check(supports="corners:fixed+7", snow_side="x")
        kept = {
            name: getattr(check, name)
            for name in check.PropertiesList
            if check.getGroupOfProperty(name) in ("Structural check", "Result")
            and name not in ("Net", "Members", "Cladding")
        }
        again = self.reopened("check.FCStd").getObject("StructuralCheck")
        for name, value in kept.items():
            self.assertEqual(getattr(again, name), value, name)
        self.assertEqual(again.State, ["Up-to-date"])
        verdict = again.Verdict
        again.touch()
        self.document.recompute()
        self.assertEqual(again.Verdict, verdict)

    def test_other_settings_and_their_refusal(self):
        check = self.check()
        api.change_structural_check(check, section="plate:20x200", snow=2.0, wind=[])
        self.assertEqual(check.CheckedSection, "plate:20x200 of S355")
        self.assertEqual((check.Snow.Value, check.Wind), (2.0, []))
        verdict, steps = check.Verdict, self.document.UndoCount
        for wrong in (
            {"supports": "99999"},
            {"joints": "hinged"},
            {"snow": "2 m"},
            {"snow": -1.0},
            {"section": "HEB170"},
            {"combinations": ["strength: 2 hail"]},
            {"colour": "red"},
        ):
            with self.assertRaises(InputError) as found:
                api.change_structural_check(check, **wrong)
            self.assertNotIn("\n", str(found.exception))
        self.assertEqual((check.Verdict, check.Supports), (verdict, "boundary"))
        self.assertEqual((self.document.UndoCount, check.State), (steps, ["Up-to-date"]))
        count = len(self.document.Objects)
        for refused in (self.document.getObject("Net"), check):
            with self.assertRaises(InputError):
                api.add_structural_check(refused, joints="hinged")
        self.assertEqual(len(self.document.Objects), count)

    def test_own_combinations(self):
        check = self.check(combinations=["strength: 1 self-weight + 3 snow", "service: 1 snow"])
        names = [row["name"] for row in json.loads(check.Report)["combinations"]]
        self.assertEqual(names, list(check.Combinations))
        self.assertIn("Load case 'panels' is in no combination for strength.", check.Remarks)

    def test_files(self):
        folder = tools.SCRATCH / "check-files"
        check = self.check()
        written = api.write_check_files(check, folder)
        self.assertIn(folder / "check.html", written)
        page = (folder / "check.html").read_text(encoding="utf-8")
        self.assertIn(check.Verdict, page)

    @unittest.skipUnless(find_spec("feminout"), "needs the FEM workbench of FreeCAD")
    def test_the_fem_workbench_opens_the_model_of_calculix(self):
        from feminout import importInpMesh

        folder = tools.SCRATCH / "check-fem"
        for settings in ({}, {"layers": 120.0, "crossings": "hinged"}):
            check = self.check(**settings)
            api.write_check_files(check, folder)
            mesh = importInpMesh.read(str(folder / "model.inp"))
            model = json.loads((folder / "model.json").read_text(encoding="utf-8"))
            arms = len(model.get("arms_and_bolts", []))
            beams = len(model["members"]) + arms + (arms // 2 if settings else 0)
            self.assertEqual((mesh.EdgeCount, mesh.FaceCount), (4 * beams, 0))
            places = np.array([tuple(place) for place in mesh.Nodes.values()])
            for vertex in convert.quad_mesh(self.net).vertices:
                self.assertLess(np.linalg.norm(places - vertex, axis=1).min(), 1e-4)

    @unittest.skipUnless(find_spec("ObjectsFem"), "needs the FEM workbench of FreeCAD")
    def test_the_fem_workbench_has_the_model_as_an_analysis(self):
        check = self.check(section="tube:100x60x5,border=chs:88.9x5", load=["14:1,0,-3"])
        service = next(name for name in check.CombinationNames if name.startswith("service"))
        analysis = api.add_fem_analysis(check, service)
        self.document.recompute()
        self.assertTrue(all("Invalid" not in item.State for item in analysis.Group))
        sections, forces, supported = self.solver_input(analysis)
        factors = {
            item.LoadCase: item.Factor for item in analysis.Group if hasattr(item, "LoadCase")
        }
        alone = api.check_structure(
            convert.quad_mesh(self.net), section=check.Section, load="14:1,0,-3",
            material="S355", snow=1.5, panels=0.4, wind="0.6@x",
        )  # fmt: skip
        self.assertEqual(set(factors), {case.name for case in alone.model.cases})
        lengths = alone.model.frame.lengths[:, None]
        whole = sum(
            factors[case.name]
            * (case.loads.nodal[:, :3].sum(0) + (case.loads.spread * lengths).sum(0))
            for case in alone.model.cases
        )
        np.testing.assert_allclose(forces.sum(axis=0), whole, rtol=1e-9, atol=1e-6)
        self.assertEqual(supported, set(np.flatnonzero(alone.model.supports.fixed.any(1)) + 1))
        ups, groups = alone.model.frame.axes[:, 2], alone.model.section_numbers
        self.assertEqual(len(sections), len(ups))
        for member, (kind, sizes, width) in enumerate(sections):
            expected = [("BOX", [60, 100, 5, 5, 5, 5]), ("PIPE", [44.45, 5])][groups[member]]
            self.assertEqual((kind, sizes), expected)
            self.assertAlmostEqual(np.dot(width, ups[member]), 0, places=9)
            along = np.subtract(*alone.model.frame.nodes[alone.model.frame.members[member]])
            self.assertLess(abs(np.dot(width, along)) / np.linalg.norm(along), 1e-9)
        name = analysis.Name
        again = self.reopened("analysis.FCStd").getObject(name)
        reopened = self.solver_input(again)
        self.assertEqual((reopened[0], reopened[2]), (sections, supported))
        np.testing.assert_array_equal(reopened[1], forces)

    @unittest.skipUnless(find_spec("ObjectsFem") and shutil.which("ccx"), "needs CalculiX")
    def test_run_solver_finds_the_displacements_of_the_check(self):
        from femsolver import run

        for given in ({"section": "plate:20x200"}, {"joints": "20", "layers": 120.0}):
            check = self.check(supports="boundary:springs=1/1/1+corners:fixed", **given)
            service = next(name for name in check.CombinationNames if name.startswith("service"))
            analysis = api.add_fem_analysis(check, service)
            self.document.recompute()
            run.run_fem_solver(self.solver(analysis), str(tools.SCRATCH))
            # FreeCAD keeps the run and says errors where the document is closed.
            run._machines.clear()
            found = next(
                item for item in analysis.Group if item.isDerivedFrom("Fem::FemResultObject")
            )
            # Of the line elements, whose first nodes are those of the net.
            rows = convert.array(found.DisplacementVectors)
            moves = dict(zip(found.NodeNumbers, rows, strict=True))
            names = list(check.CombinationNames)
            ours = convert.array(check.AllDisplacements).reshape(len(names), -1, 3)
            ours = ours[names.index(service)][: len(self.net.Vertices)]
            theirs = np.array([moves[node + 1] for node in range(len(ours))])
            largest = np.linalg.norm(ours, axis=1).max()
            # CalculiX takes joints for stiff as far as sections reach.
            self.assertLess(np.linalg.norm(theirs - ours, axis=1).max(), 0.12 * largest)

    def solver(self, analysis):
        return next(
            item for item in analysis.Group if item.isDerivedFrom("Fem::FemSolverObjectPython")
        )

    def solver_input(self, analysis):
        """Sections of the members, forces on the nodes and held nodes of FreeCAD's own input."""
        from femsolver import run

        folder = tools.SCRATCH / "check-solver"
        folder.mkdir(exist_ok=True)
        machine = run.getMachine(self.solver(analysis), str(folder))
        machine.target = run.PREPARE
        machine.start()
        machine.join()
        run._machines.clear()
        self.assertFalse(machine.failed)
        (path,) = folder.glob("*.inp")
        lines = path.read_text(encoding="utf-8").splitlines()
        self.assertTrue(any(line.startswith("*Element, TYPE=B32R") for line in lines))
        elements, sections, forces, held = {}, {}, {}, set()
        for number, line in enumerate(lines):
            if line.startswith("*ELSET,ELSET=M"):
                elements[line.split("=")[1]] = int(lines[number + 1].strip(" ,"))
            if line.startswith("*BEAM SECTION"):
                words = dict(word.split("=") for word in line.split(", ")[1:])
                sizes, width = (
                    [float(size) for size in row.split(",")] for row in lines[number + 1 :][:2]
                )
                sections[elements[words["ELSET"]]] = words["SECTION"], sizes, width
            if line.startswith("*NSET,NSET=Support"):
                held |= {int(row.strip(" ,")) for row in self.data(lines[number + 1 :])}
            if line == "*CLOAD":
                for node, direction, value in map(self.numbers, self.data(lines[number + 1 :])):
                    force = forces.setdefault(node, np.zeros(3))
                    force[int(direction) - 1] += value
        ordered = [sections[element] for element in sorted(sections)]
        return ordered, np.array(list(forces.values())), held

    def data(self, lines):
        from itertools import takewhile

        return [line for line in takewhile(lambda line: not line.startswith("*"), lines) if line]

    def numbers(self, line):
        return [float(word) for word in line.split(",")]

    @unittest.skipUnless(find_spec("ObjectsFem"), "needs the FEM workbench of FreeCAD")
    def test_what_the_fem_workbench_has_not_is_refused(self):
        before = len(self.document.Objects)
        check = self.check(section="HEB100")
        with self.assertRaisesRegex(InputError, "section HEB100: its beams are rec") as found:
            api.add_fem_analysis(check)
        self.assertNotIn("\n", str(found.exception))
        self.document.removeObject(check.Name)
        with self.assertRaisesRegex(InputError, "no 'hail'"):
            api.add_fem_analysis(self.check(), "hail")
        self.assertEqual(len(self.document.Objects), before + 1)

    def test_in_a_part_that_is_turned_down_is_down(self):
        part = self.document.addObject("App::Part", "Part")
        part.addObject(self.net)
        level = self.check()
        down = FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 90)
        part.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 0, 0), down)
        level.touch()
        self.document.recompute()
        turned = convert.quad_mesh(self.net)
        rotation = convert.placing(part.Placement)[0]
        other = api.check_structure(
            turned.with_vertices(turned.vertices @ rotation.T + [100, 0, 0]),
            material="S355", snow=1.5, panels=0.4, wind="0.6@x",
        )  # fmt: skip
        self.assertAlmostEqual(level.Utilisation, 100 * other.utilisation.max(), places=4)
        worst = max(other.service, key=lambda one: one.displacement.max())
        moves = convert.array(level.Displacements) @ rotation.T
        np.testing.assert_allclose(moves, worst.response.displacements[:, :3], atol=1e-6)


class TestStructures(CheckCase):
    def setUp(self):
        super().setUp()
        api.optimise_net(self.net)

    def test_members_and_weights_are_those_of_structures(self):
        beams = api.add_beams(self.net, height=120, thickness=15)
        panels = api.add_panels(self.net, 10.0, material="glass")
        check = api.add_structural_check(self.net, beams=beams, cladding=panels, snow=1.0)
        self.assertEqual(check.CheckedSection, "plate:15x120 of steel")
        area = sum(np.linalg.norm(convert.quad_mesh(self.net).face_area_vectors, axis=1))
        weight = json.loads(panels.Report)["mass_kg"] * 9.81e-3 / (area / 1e6)
        alone = api.check_structure(
            convert.quad_mesh(self.net), section="plate:15x120", panels=weight, snow=1.0
        )
        self.assertAlmostEqual(check.Utilisation, 100 * alone.utilisation.max(), places=6)
        api.change_structure(beams, section="HEB100")
        self.assertEqual(check.CheckedSection, "HEB100 of steel")
        used = check.Utilisation
        api.change_structure(panels, thickness=20)
        self.assertGreater(check.Utilisation, used)
        api.change_structural_check(check, beams=None, section="tube:60x40x4")
        self.assertEqual(check.CheckedSection, "tube:60x40x4 of steel")

    def test_members_are_those_of_lamellas(self):
        lamellas = api.add_lamellas(self.net, width=60, thickness=4, position="lying", layers=2)
        check = api.add_structural_check(self.net, beams=lamellas, snow=1.0, crossings="hinged")
        self.assertEqual(check.CheckedSection, "plate:4x60 of steel")
        alone = api.check_structure(
            convert.quad_mesh(self.net), section="plate:4x60", position="lying", snow=1.0,
            layers=4 + 1.0, crossings="hinged",
        )  # fmt: skip
        # Steel has 1 mm of clearance where none is given.
        self.assertEqual(lamellas.Clearance.Value, 0.0)
        self.assertAlmostEqual(check.Utilisation, 100 * alone.utilisation.max(), places=6)
        self.assertTrue(any("bent into place" in words for words in check.Remarks))
        api.change_structure(lamellas, layers=1, position="standing")
        slotted = api.check_structure(
            convert.quad_mesh(self.net), section="plate:4x60", position="standing", snow=1.0,
            crossings="hinged",
        )  # fmt: skip
        self.assertAlmostEqual(check.Utilisation, 100 * slotted.utilisation.max(), places=6)

    def test_the_fabrication_report_tells_the_check(self):
        panels = api.add_panels(self.net, 10.0)
        check = api.add_structural_check(self.net, snow=1.0, cladding=panels)
        folder = tools.SCRATCH / "with-check"
        api.export_fabrication(panels, folder)
        page = (folder / "report.html").read_text(encoding="utf-8")
        self.assertIn(check.Verdict, page)

    def test_structures_that_say_nothing_of_members_are_refused(self):
        beams = api.add_beams(self.net, family="u")
        lamellas = api.add_lamellas(self.net, family="v")
        panels = api.add_panels(self.net)
        count = len(self.document.Objects)
        for wrong in (
            {"beams": beams},
            {"beams": lamellas},
            {"beams": panels},
            {"cladding": self.net},
        ):
            with self.assertRaises(InputError):
                api.add_structural_check(self.net, snow=1.0, **wrong)
        self.assertEqual(len(self.document.Objects), count)

    def test_beams_that_wait_let_the_check_wait(self):
        beams = api.add_beams(self.net, height=120, thickness=15)
        check = api.add_structural_check(self.net, beams=beams, snow=1.0)
        beams.AutomaticUpdate = False
        beams.Height = 200.0
        self.document.recompute()
        self.assertTrue(beams.Outdated and check.Outdated)
        self.assertEqual(api.update_structures(self.document), [beams, check])
        self.assertEqual(check.CheckedSection, "plate:15x200 of steel")
