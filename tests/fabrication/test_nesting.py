"""Sheets hold every part once, inside, apart by the spacing; the files keep names and layers."""

import csv
import html
import json
import math
import re
from dataclasses import replace
from pathlib import Path

import ezdxf
import numpy as np
import pytest
import shapely

from freecad_ortho import api
from freecad_ortho.fabrication import Beams, FlatPattern, Panels, Workshop, build, write
from freecad_ortho.fabrication.dxf import DXF_LAYERS
from freecad_ortho.fabrication.nesting import library, nest
from freecad_ortho.fabrication.nesting.nest import too_large_words
from freecad_ortho.fabrication.nesting.skyline import Skyline
from freecad_ortho.fabrication.nesting.strip import StripPacker
from freecad_ortho.fabrication.part import some_names
from freecad_ortho.fabrication.pattern import polygon_area
from solver.errors import InputError

INPUTS = Path(__file__).resolve().parents[3] / "shared" / "inputs"
SHOP = Workshop(sheet=(3000.0, 1500.0), spacing=8.0)


@pytest.fixture(scope="module")
def plates(roof):
    """Beams and panels of two thicknesses."""
    return build(roof, [Beams(200, 12), Panels(20, 15)]).parts


def assert_sound(sheets, parts, shop):
    """Nothing lost or doubled, all inside, none closer to another than the spacing."""
    placed = [placement for sheet in sheets for placement in sheet.placements]
    patterns = {part.name: part.pattern for part in parts}
    assert sorted(placement.name for placement in placed) == sorted(patterns)
    total = sum(polygon_area(placement.outline) for placement in placed)
    assert total == pytest.approx(sum(part.area for part in parts), rel=1e-9)
    thickness = {part.name: part.thickness for part in parts}
    for sheet in sheets:
        assert {thickness[placement.name] for placement in sheet.placements} == {sheet.thickness}
        shapes = [shapely.Polygon(placement.outline) for placement in sheet.placements]
        rim = shapely.box(0, 0, *shop.sheet).buffer(0.02 - shop.spacing, join_style="mitre")
        assert all(rim.contains(shape) for shape in shapes)
        for number, shape in enumerate(shapes):
            assert all(shape.distance(other) > shop.spacing - 0.02 for other in shapes[:number])
        assert sheet.waste == pytest.approx(
            1 - sum(shape.area for shape in shapes) / (sheet.width * sheet.height)
        )


@pytest.mark.parametrize("grain", ["none", "along"])
def test_boxes_on_sheets(plates, grain):
    shop = Workshop(sheet=(3000.0, 1800.0), spacing=8.0, grain=grain)
    sheets = nest(plates, shop).sheets
    assert_sound(sheets, plates, shop)
    if grain == "along":
        angles = {p.angle_deg % 180 for sheet in sheets for p in sheet.placements}
        assert angles == {0.0}
    assert [sheet.name for sheet in sheets] == [f"sheet-{k + 1:03d}" for k in range(len(sheets))]
    again = nest(plates, shop).sheets
    assert all(
        np.array_equal(one.outline, other.outline)
        for first, second in zip(sheets, again, strict=True)
        for one, other in zip(first.placements, second.placements, strict=True)
    )


def test_outlines_by_the_library_are_sound_and_no_worse(plates):
    if not library.is_there():
        pytest.skip("spyrrow is not installed")
    some = plates[-8:]
    shop = Workshop(sheet=(3000.0, 3000.0), spacing=8.0, nesting="outlines", seed=3)
    nesting = nest(some, shop)
    assert nesting.remarks == ()
    assert_sound(nesting.sheets, some, shop)
    boxes = nest(some, Workshop(sheet=(3000.0, 3000.0), spacing=8.0)).sheets
    assert len(nesting.sheets) <= len(boxes)


def test_the_library_is_given_each_outline_once():
    if not library.is_there():
        pytest.skip("spyrrow is not installed")
    square, strip = ((0, 0), (90, 0), (90, 90), (0, 90)), ((0, 0), (40, 0), (40, 80), (0, 80))
    placed = StripPacker().pack([square, strip], [[0.0], [0.0]], 100.0, 1, 3)
    assert sorted(number for number, *_ in placed) == [0, 1]


# Half a degree at the tip: the spacing must hold there too.
NEEDLE = [[0.0, 0.0], [2000.0, -9.0], [2000.0, 9.0]]
# Its two arms nearly meet: with the spacing around it the outline closes to a ring.
RING = [[0, 0], [600, 0], [600, 600], [305, 600], [305, 500], [500, 500], [500, 100], [100, 100],
        [100, 500], [295, 500], [295, 600], [0, 600]]  # fmt: skip


@pytest.mark.parametrize("spacing", [0.0, 8.0, 40.0])
def test_awkward_outlines_go_through_the_library(plates, spacing):
    if not library.is_there():
        pytest.skip("spyrrow is not installed")
    outlines = [np.array(points, dtype=float) for points in (NEEDLE, RING, NEEDLE, RING)]
    parts = [
        replace(plates[0], name=f"X{k}", area=polygon_area(outline),
                pattern=FlatPattern(outline - outline.min(axis=0), (), np.zeros(2), 1.0))
        for k, outline in enumerate(outlines)
    ]  # fmt: skip
    shop = Workshop(sheet=(3000.0, 1500.0), spacing=spacing, nesting="outlines")
    nesting = nest(parts, shop)
    assert nesting.remarks == ()
    assert_sound(nesting.sheets, parts, shop)


def test_curved_plates_that_once_brought_the_library_down(tmp_path, capfd):
    path = INPUTS / "helicoid.obj"
    if not path.is_file():
        pytest.skip(f"{path} is missing: files that failed are not shipped")
    if not library.is_there():
        pytest.skip("spyrrow is not installed")
    loaded = api.read_mesh(path)
    parts = api.fabricate(loaded.mesh, "lamellas", unit=loaded.unit).parts
    shop = Workshop(sheet=(12000.0, 3000.0), nesting="outlines")
    nesting = nest(parts, shop)
    assert nesting.remarks == () and nesting.too_large == ()
    assert_sound(nesting.sheets, parts, shop)
    assert capfd.readouterr() == ("", "")


STAND_IN = """
class Panic(BaseException):
    pass

class Item:
    def __init__(self, name, points, count, angles):
        self.id, self.points = name, points

def StripPackingConfig(**settings):
    return settings

class Placed:
    def __init__(self, item, x, y):
        self.id, self.rotation, self.translation = item.id, 0.0, (x, y)

class Solution:
    def __init__(self, placed):
        self.placed_items = placed

class StripPackingInstance:
    def __init__(self, name, height, items):
        self.items = items

    def solve(self, search):
        low = [(min(x for x, _ in i.points), min(y for _, y in i.points)) for i in self.items]
        placed = [Placed(i, -x, -y) for i, (x, y) in zip(self.items, low)]
        {act}
        return Solution(placed)
"""


@pytest.mark.parametrize(
    ("act", "words"),
    [
        ("raise Panic('duplicate vertices')", "failed (duplicate vertices)"),
        ("import os; os.abort()", "failed (it ended with code"),
        ("import time; time.sleep(60)", "failed (it did not finish within 2 s and was stopped)"),
        ("pass", "too close to"),
        ("placed = placed[:1] * 2", "it laid a part twice"),
        ("placed = placed[:1]; placed[0].translation = (-500, 0)", "over the rim of the sheet"),
        ("placed = placed[:1]", ""),
        ("placed = []", ""),
    ],
)
def test_whatever_the_library_does_the_sheets_are_sound(
    plates, tmp_path, monkeypatch, capfd, act, words
):
    (tmp_path / "spyrrow.py").write_text(STAND_IN.format(act=act))
    monkeypatch.syspath_prepend(str(tmp_path))
    if "sleep" in act:
        monkeypatch.setattr(library, "_TIME_LIMIT", 2.0)
    shop = Workshop(sheet=(6000.0, 3000.0), spacing=8.0, nesting="outlines")
    some = plates[:6]
    nesting = nest(some, shop)
    assert_sound(nesting.sheets, some, shop)
    assert [words in remark for remark in nesting.remarks] == [True] * bool(words)
    assert all("boxes were packed" in r and "\n" not in r for r in nesting.remarks)
    assert capfd.readouterr() == ("", "")


def test_progress_is_the_part_that_has_been_laid(plates, tmp_path, monkeypatch):
    (tmp_path / "spyrrow.py").write_text(STAND_IN.format(act="placed = placed[:1]"))
    monkeypatch.syspath_prepend(str(tmp_path))
    heard = []
    shop = Workshop(sheet=(3000.0, 2000.0), spacing=8.0, nesting="outlines")
    some = [part for part in plates if part.kind == "panel"][:6]
    sheets = nest(some, shop, progress=lambda share, words: heard.append((share, words))).sheets
    laid = np.cumsum([len(sheet.placements) for sheet in sheets]) / len(some)
    assert len(sheets) > 1
    assert sorted({share for share, _ in heard}) == pytest.approx([0.0, *laid])
    assert heard[0][1] == "nesting sheet 1" and heard == sorted(heard)


def test_without_the_library_boxes_take_its_place(plates, monkeypatch):
    monkeypatch.setattr(library, "is_there", lambda: False)
    nesting = nest(plates, Workshop(sheet=(3000.0, 1500.0), nesting="outlines"))
    assert len(nesting.sheets) == len(nest(plates, Workshop(sheet=(3000.0, 1500.0))).sheets)
    (remark,) = nesting.remarks
    assert remark.startswith("nesting: the library spyrrow is not installed")


def test_sheets_on_which_nothing_fits_are_refused_with_all_names(plates, structure, tmp_path):
    with pytest.raises(InputError) as caught:
        nest(plates, Workshop(sheet=(300.0, 100.0)))
    names = ", ".join(part.name for part in plates)
    size = r"sheet: \d+ parts do not fit on 300 x 100 mm .* \(the largest is \d+ x \d+ mm"
    assert re.match(rf"{size}\): {names}; take larger sheets", str(caught.value))
    with pytest.raises(InputError, match="do not fit"):
        write(structure, tmp_path / "never", workshop=Workshop(sheet=(300.0, 100.0)))
    assert not (tmp_path / "never").exists()


def test_the_sheet_of_the_store_with_the_least_area_is_taken(plates):
    """Whichever of its sides is the shorter one."""
    size = plates[0].pattern.size
    long, square = (4 * size.max(), size.max() + 20), (1.6 * size.max() + 30,) * 2
    store = ",".join(f"{a:.0f}x{b:.0f}" for a, b in (long, square))
    shop = Workshop(sheet=(9000.0, 9000.0), sheet_sizes=store)
    (sheet,) = nest(plates[:1], shop).sheets
    assert sheet.width == pytest.approx(square[0], abs=0.5) and square[1] > long[1]


def test_one_part_does_not_fit_and_two_do_not(plates):
    shop = Workshop(sheet=(300.0, 100.0))
    assert "sheet: 1 part does not fit on" in too_large_words(plates[:1], shop)
    assert "sheet: 2 parts do not fit on" in too_large_words(plates[:2], shop)


def test_what_fits_is_nested_and_all_that_does_not_is_listed(structure, tmp_path):
    """Message, report and table say the same."""
    shop = Workshop(sheet=(1500.0, 900.0), spacing=8.0)
    room = np.array(shop.sheet) - 2 * shop.spacing
    write(structure, tmp_path, workshop=shop)
    report = json.loads((tmp_path / "report.json").read_text())
    with (tmp_path / "parts.csv").open(newline="") as stream:
        rows = {row["name"]: row for row in csv.DictReader(stream)}
    placed = {name for sheet in report["sheets"]["sheets"] for name in sheet["parts"]}
    large = report["sheets"]["too_large"]
    assert 0 < len(large) < len(rows) and placed | set(large) == set(rows)
    assert not placed & set(large)
    for part in structure.parts:
        fits = (part.pattern.size <= room).all() or (part.pattern.size[::-1] <= room).all()
        assert not fits or part.name in placed
    for sheet in report["sheets"]["sheets"]:
        assert {rows[name]["cut_from"] for name in sheet["parts"]} == {sheet["name"]}
    # Beams that are too large for a sheet are sawn from bars; panels are lost.
    sawn = [name for name in large if rows[name]["kind"] == "beam"]
    lost = [name for name in large if rows[name]["kind"] == "panel"]
    assert all(rows[name]["cut_from"].startswith("S0") for name in sawn)
    assert all(rows[name]["cut_from"] == "" for name in lost)
    # Whoever reads one row knows it too.
    words = "too large for sheets of 1500 x 900 mm"
    assert [name for name, row in rows.items() if row["verdict"].endswith(words)] == lost
    assert all(words in report["verdict"]["failed"][name] for name in lost)
    said, others = [words for words in report["messages"] if words.startswith("sheet: ")]
    assert f"{len(lost)} parts do not fit on 1500 x 900 mm" in said
    assert f": {some_names(lost, 10)}; take larger sheets" in said
    assert others.endswith(f"sawn from bars instead: {some_names(sawn, 10)}")
    assert set(lost) | set(sawn) == set(large)
    assert said in html.unescape((tmp_path / "report.html").read_text())


def test_a_message_has_ten_names_and_says_how_many_more_there_are():
    names = [f"P{number:04d}" for number in range(163)]
    assert some_names(names[:10], 10) == ", ".join(names[:10])
    assert some_names(names, 10) == (
        ", ".join(names[:10]) + " and 153 more, which the report lists"
    )
    assert some_names(names) == ", ".join(names)


def test_a_part_as_large_as_the_sheet_fits(plates):
    part = plates[0]
    width, height = part.pattern.size.tolist()
    (sheet,) = nest([part], Workshop(sheet=(height + 20, width + 20), spacing=10)).sheets
    assert sheet.placements[0].angle_deg in (90.0, 270.0)
    with pytest.raises(InputError, match="does not fit"):
        nest([part], Workshop(sheet=(height + 20, width + 20), spacing=10, grain="along"))


def test_skyline_fills_a_sheet_of_squares_completely():
    skyline = Skyline(40.0, 30.0)
    places = [skyline.place((10.0, 10.0)) for _ in range(12)]
    assert sorted((x, y) for _, x, y in places) == [
        (x, y) for x in (0.0, 10.0, 20.0, 30.0) for y in (0.0, 10.0, 20.0)
    ]
    assert skyline.place((10.0, 10.0)) is None


def test_skyline_never_overlaps():
    random = np.random.default_rng(7)
    skyline, boxes = Skyline(100.0, 80.0), []
    for width, height in random.uniform(3, 25, (60, 2)):
        if (found := skyline.place((width, height), (height, width))) is not None:
            number, x, y = found
            size = (width, height) if number == 0 else (height, width)
            boxes.append((x, y, x + size[0], y + size[1]))
    assert len(boxes) > 15
    assert all(x >= 0 and y >= 0 and r <= 100 + 1e-6 and t <= 80 + 1e-6 for x, y, r, t in boxes)
    for k, one in enumerate(boxes):
        for other in boxes[:k]:
            apart = one[0] >= other[2] - 1e-9 or other[0] >= one[2] - 1e-9
            assert apart or one[1] >= other[3] - 1e-9 or other[1] >= one[3] - 1e-9


def test_files_of_the_sheets(roof, tmp_path):
    structure = build(roof, [Panels(20, 15)])
    smaller = replace(SHOP, sheet=(2000.0, 1500.0))
    earlier = {path.name for path in write(structure, tmp_path, workshop=smaller)}
    files = write(structure, tmp_path, workshop=SHOP)
    names = {path.name for path in files if path.parent.name == "sheets"}
    assert names == {path.name for path in (tmp_path / "sheets").iterdir()}
    assert "overview.svg" in names and len(earlier) > len(files)
    seen = []
    for path in sorted((tmp_path / "sheets").glob("*.dxf")):
        drawing = ezdxf.readfile(path)
        assert not drawing.audit().errors
        assert set(DXF_LAYERS) | {"SHEET"} <= {layer.dxf.name for layer in drawing.layers}
        for insert in drawing.modelspace().query("INSERT"):
            seen.append(insert.dxf.name)
            cut = insert.virtual_entities()
            outline = next(e for e in cut if e.dxf.layer == "CUT")
            points = np.array(outline.get_points("xy"))
            part = next(part for part in structure.parts if part.name == insert.dxf.name)
            assert polygon_area(points) == pytest.approx(part.area, rel=1e-9)
            assert points.min() >= SHOP.spacing - 1e-6
            assert (points.max(axis=0) <= np.array(SHOP.sheet) - SHOP.spacing + 1e-6).all()
            label = insert.doc.blocks.get(insert.dxf.name).query('TEXT[layer=="LABEL"]')
            assert [text.dxf.text for text in label] == [insert.dxf.name]
    assert sorted(seen) == sorted(part.name for part in structure.parts)
    svg = (tmp_path / "sheets" / "overview.svg").read_text()
    assert all(f">{name}<" in svg for name in seen)


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"sheet": "3000"}, "sheet: expected WxH in mm"),
        ({"sheet": "0x100"}, "sheet: expected a number above 0 mm"),
        ({"stock": -1.0}, "stock: expected a number above 0"),
        ({"spacing": -1.0}, "spacing: expected 0 mm or more"),
        ({"kerf": math.nan}, "kerf: expected a finite number, got nan"),
        ({"grain": "across"}, "grain: expected none or along"),
        ({"colour": "red"}, "colour: the workshop has no such size; it has sheet, spacing"),
        ({"nesting": "tight"}, "nesting: expected boxes or outlines"),
    ],
)
def test_bad_settings_are_one_line(values, words):
    with pytest.raises(InputError, match=re.escape(words)) as caught:
        Workshop.of(values)
    assert "\n" not in str(caught.value)
