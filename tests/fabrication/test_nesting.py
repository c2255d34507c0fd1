"""Sheets hold every part once, inside, apart by the spacing; the files keep names and layers."""

import math
import re
from dataclasses import replace

import ezdxf
import numpy as np
import pytest
import shapely

from freecad_ortho.fabrication import Beams, Panels, Workshop, build, write
from freecad_ortho.fabrication.dxf import LAYERS
from freecad_ortho.fabrication.nesting import library, nest
from freecad_ortho.fabrication.nesting.skyline import Skyline
from freecad_ortho.fabrication.pattern import polygon_area
from solver.errors import InputError

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
    sheets = nest(plates, shop)
    assert_sound(sheets, plates, shop)
    if grain == "along":
        angles = {p.angle_deg % 180 for sheet in sheets for p in sheet.placements}
        assert angles == {0.0}
    assert [sheet.name for sheet in sheets] == [f"sheet-{k + 1:03d}" for k in range(len(sheets))]
    again = nest(plates, shop)
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
    sheets = nest(some, shop)
    assert_sound(sheets, some, shop)
    boxes = nest(some, Workshop(sheet=(3000.0, 3000.0), spacing=8.0))
    assert len(sheets) <= len(boxes)


def test_without_the_library_boxes_take_its_place(plates, monkeypatch):
    monkeypatch.setattr(library, "is_there", lambda: False)
    sheets = nest(plates, Workshop(sheet=(3000.0, 1500.0), nesting="outlines"))
    assert len(sheets) == len(nest(plates, Workshop(sheet=(3000.0, 1500.0))))


def test_part_larger_than_the_sheet_is_named(plates, structure, tmp_path):
    with pytest.raises(InputError, match=r"sheet: [BP]\d{4} is \d+ x \d+ mm and does not fit on "):
        nest(plates, Workshop(sheet=(800.0, 600.0)))
    with pytest.raises(InputError, match="does not fit"):
        write(structure, tmp_path / "never", workshop=Workshop(sheet=(800.0, 600.0)))
    assert not (tmp_path / "never").exists()


def test_a_part_as_large_as_the_sheet_fits(plates):
    part = plates[0]
    width, height = part.pattern.size.tolist()
    (sheet,) = nest([part], Workshop(sheet=(height + 20, width + 20), spacing=10))
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
        assert set(LAYERS) | {"SHEET"} <= {layer.dxf.name for layer in drawing.layers}
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
        ({"kerf": math.nan}, "kerf: expected 0 mm or more"),
        ({"grain": "across"}, "grain: expected none or along"),
        ({"colour": "red"}, "colour: the workshop has no such size; it has sheet, spacing"),
        ({"nesting": "tight"}, "nesting: expected boxes or outlines"),
    ],
)
def test_bad_settings_are_one_line(values, words):
    with pytest.raises(InputError, match=re.escape(words)) as caught:
        Workshop.of(values)
    assert "\n" not in str(caught.value)
