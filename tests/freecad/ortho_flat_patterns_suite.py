"""Flat patterns and drawing pages in documents. Run by FreeCAD without a window."""

import re
from unittest import mock

import FreeCAD
import ortho_suite_tools as tools
from ortho_suite_cases import DocumentCase

from freecad_ortho import api
from freecad_ortho.documents import drawing_pages
from solver.errors import InputError


class FlatCase(DocumentCase):
    def setUp(self):
        super().setUp()
        self.net = api.import_net(tools.wavy_mesh(rows=4, columns=5), self.document)
        api.optimise_net(self.net)
        self.beams = api.add_beams(self.net)


class TestLayout(FlatCase):
    def test_rows_show_every_part_once(self):
        flat = api.add_flat_patterns(self.beams)
        self.assertEqual(sorted(flat.PartNames), sorted(self.beams.PartNames))
        self.assertEqual(flat.SheetCount, 0)
        self.assertEqual(len(flat.Shape.SubShapes), len(self.beams.PartNames))
        self.assertLess(abs(flat.Shape.BoundBox.ZLength), 1e-6)

    def test_sheets_hold_every_part_once_and_inside(self):
        flat = api.add_flat_patterns(self.beams, sheet=("4 m", 2000), spacing=12)
        self.assertEqual(sorted(flat.PartNames), sorted(self.beams.PartNames))
        self.assertGreaterEqual(flat.SheetCount, 1)
        self.assertTrue(0 < flat.Waste < 1)
        shapes = flat.Shape.SubShapes
        sheets = shapes[len(flat.PartNames) :]
        self.assertEqual(len(sheets), flat.SheetCount)
        for part in shapes[: len(flat.PartNames)]:
            box = part.BoundBox
            inside = [
                box.XMin >= sheet.BoundBox.XMin + 11.9
                and box.XMax <= sheet.BoundBox.XMax - 11.9
                and box.YMin >= sheet.BoundBox.YMin + 11.9
                and box.YMax <= sheet.BoundBox.YMax - 11.9
                for sheet in sheets
            ]
            self.assertEqual(sum(inside), 1)

    def test_they_follow_the_structure_and_are_undone_in_one_step(self):
        flat = api.add_flat_patterns(self.beams)
        before = flat.Shape.SubShapes[0].BoundBox.YLength
        self.beams.Height = 400.0
        self.document.recompute()
        self.assertGreater(flat.Shape.SubShapes[0].BoundBox.YLength, 1.8 * before)
        count = len(self.document.Objects)
        name = api.add_flat_patterns(self.beams).Name
        self.document.undo()
        self.assertEqual(len(self.document.Objects), count)
        self.assertIsNone(self.document.getObject(name))

    def test_kerf_makes_the_outlines_larger(self):
        plain = api.add_flat_patterns(self.beams).Shape.SubShapes[0].BoundBox
        cut = api.add_flat_patterns(self.beams, kerf="0.4 mm").Shape.SubShapes[0].BoundBox
        self.assertAlmostEqual(cut.YLength - plain.YLength, 0.4, places=2)

    def test_parts_larger_than_the_sheet_are_listed_and_the_others_laid_out(self):
        shapes = api.add_flat_patterns(self.beams).Shape.SubShapes
        lengths = sorted(shape.BoundBox.XLength for shape in shapes)
        middle = (lengths[0] + lengths[-1]) / 2
        flat = api.add_flat_patterns(self.beams, sheet=(middle + 2, 600), spacing=1)
        self.assertTrue(flat.TooLarge and flat.PartNames)
        self.assertEqual(sorted([*flat.TooLarge, *flat.PartNames]), sorted(self.beams.PartNames))
        self.assertEqual(len(flat.TooLarge), sum(length > middle for length in lengths))

    def test_sheets_on_which_nothing_fits_are_refused(self):
        count = len(self.document.Objects)
        for wrong in (
            {"sheet": (500, 100)},
            {"sheet": (4000, 0)},
            {"grain": "across"},
            {"nesting": "magic"},
        ):
            with self.assertRaises(InputError):
                api.add_flat_patterns(self.beams, **wrong)
        with self.assertRaises(InputError):
            api.add_flat_patterns([])
        with self.assertRaises(InputError):
            api.add_flat_patterns(self.net)
        self.assertEqual(len(self.document.Objects), count)

    def test_saved_and_opened_again_they_are_the_same(self):
        flat = api.add_flat_patterns(self.beams, sheet=(4000, 2000))
        names, length = list(flat.PartNames), flat.Shape.Length
        path = str(tools.SCRATCH / "flat.FCStd")
        self.document.saveAs(path)
        tools.close_all()
        again = FreeCAD.openDocument(path).getObject("FlatPatterns")
        self.assertEqual(again.PartNames, names)
        self.assertAlmostEqual(again.Shape.Length, length, places=6)
        again.touch()
        again.Document.recompute()
        self.assertAlmostEqual(again.Shape.Length, length, places=6)


class TestDrawing(FlatCase):
    def test_a_page_shows_them(self):
        flat = api.add_flat_patterns(self.beams, sheet=(4000, 2000))
        page = api.add_drawing_page(flat)
        view, names = page.Views
        self.assertEqual(view.Source, [flat])
        self.assertLessEqual(view.Scale * flat.Shape.BoundBox.XLength, 420.0)
        for name in flat.PartNames:
            self.assertIn(f">{name}<", names.Symbol)
        with self.assertRaises(InputError):
            api.add_drawing_page(self.beams)

    def test_each_sheet_has_a_page_with_its_parts_and_its_title_block(self):
        flat = api.add_flat_patterns(self.beams, sheet=(2200, 1000))
        self.assertGreater(flat.SheetCount, 2)
        steps = self.document.UndoCount
        pages = api.add_drawing_pages(flat)
        self.assertEqual((len(pages), self.document.UndoCount), (flat.SheetCount, steps + 1))
        seen = []
        for number, page in enumerate(pages, 1):
            lines, names = page.Views
            shown = re.findall(r">([^<]+)</text>", names.Symbol)
            seen += shown
            fields = page.Template.EditableTexts
            self.assertEqual(fields["SheetNumber"], f"{number} / {flat.SheetCount}")
            self.assertIn(f"{shown[0]} to {shown[-1]}", fields["Subtitle"])
            scale = float((fields.get("FC-Scale") or fields["scale"]).split(":")[1])
            self.assertLessEqual(2200 / scale, 420.0)
            self.assertGreater(2200 / scale, 100.0)
            # The parts' edges and the four of the sheet, nothing of the next sheet.
            self.assertEqual(lines.Sheet, number)
            self.assertNotIn("-", re.sub(r"[^-\d]", "", lines.Symbol.split('d="')[1].split('"')[0]))
            self.assertEqual([text for text in fields.values() if text.isupper()], [])
        self.assertEqual(sorted(seen), sorted(flat.PartNames))
        with self.assertRaises(InputError):
            api.add_drawing_page(flat, sheet=99)

    def test_many_parts_are_drawn_as_a_picture(self):
        flat = api.add_flat_patterns(self.beams, sheet=(4000, 2000))
        with mock.patch.object(drawing_pages, "_MOST_PARTS", 3):
            page = api.add_drawing_page(flat)
        lines, names = page.Views
        lines_name = lines.Name
        self.assertEqual(lines.TypeId, "TechDraw::DrawViewSymbol")
        self.assertEqual(lines.Symbol.count("M"), len(flat.Shape.Edges))
        self.assertIn(f">{flat.PartNames[0]}<", names.Symbol)
        before = lines.Symbol, names.Symbol
        flat.Spacing = 37.0
        self.document.recompute()
        self.assertNotEqual(lines.Symbol, before[0])
        self.assertNotEqual(names.Symbol, before[1])
        flat.AutomaticUpdate = False
        drawn = lines.Symbol
        flat.Spacing = 53.0
        self.document.recompute()
        self.assertEqual(lines.Symbol, drawn)
        path_names = {item.Name for item in page.Views}
        again = self.reopened("page.FCStd")
        self.assertEqual({item.Name for item in again.Page.Views}, path_names)
        api.update_structures(again)
        self.assertNotEqual(again.getObject(lines_name).Symbol, drawn)
