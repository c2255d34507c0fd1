"""The files are read back: same parts, names and numbers; whole or not at all."""

import csv
import dataclasses
import json
import math
import os

import ezdxf
import numpy as np
import pytest
from ezdxf.enums import TextEntityAlignment

from freecad_ortho.fabrication import (
    FILES,
    MATERIALS,
    Beams,
    Measures,
    Panels,
    Workshop,
    build,
    files,
    stage_seconds,
    write,
)
from freecad_ortho.fabrication.dxf import DXF_LAYERS, row_layout, write_dxf
from freecad_ortho.fabrication.pattern import Bevel, FlatPattern, polygon_area
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.step import read_step
from freecad_ortho.fabrication.tables import COLUMNS
from solver.errors import OrthoError, OutputError
from solver.mesh.primitives import primitive

REQUIRED = (
    "name kind family line length_mm width_mm thickness_mm area_mm2 mass_kg gap_mm twist_deg "
    "straightness_mm radius_mm min_bend_radius_mm stress_MPa shear_MPa combined_MPa verdict"
)
SIZES = ("length", "width", "thickness", "area", "volume", "mass")


@pytest.fixture(scope="module")
def folder(structure, tmp_path_factory):
    target = tmp_path_factory.mktemp("out") / "new" / "folder"
    assert write(structure, target) == [target / name for name in FILES]
    return target


@pytest.fixture(scope="module")
def small(dodecahedron):
    return build(dodecahedron, [Beams(200, 12)])


@pytest.fixture(scope="module")
def drawing(folder):
    return ezdxf.readfile(folder / "flat.dxf")


def test_folder_holds_the_files_and_nothing_else(folder):
    assert sorted(os.listdir(folder)) == sorted(FILES)


def test_step_gives_back_names_places_and_volumes(structure, folder):
    read = read_step(folder / "structure.step")
    assert [name for name, _ in read] == [part.name for part in structure.parts]
    for (_, solid), part in zip(read, structure.parts, strict=True):
        assert solid.ShapeType() == "Solid"
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)
        found = np.array([vertex.toTuple() for vertex in solid.Vertices()])
        gap = np.linalg.norm(found[:, None] - part.points[None], axis=2).min(axis=0)
        assert gap.max() <= 1e-6


def test_step_is_in_millimetres_and_has_one_product_a_part(structure, folder):
    text = (folder / "structure.step").read_text()
    assert "SI_UNIT(.MILLI.,.METRE.)" in text
    assert text.count("=PRODUCT('") == len(structure.parts) + 1
    assert text.count("NEXT_ASSEMBLY_USAGE_OCCURRENCE(") == len(structure.parts)


def test_writing_says_nothing(small, tmp_path, capfd):
    write(small, tmp_path)
    printed = capfd.readouterr()
    assert printed.out == printed.err == ""


def test_same_structure_gives_the_same_files(roof, tmp_path):
    glass = {"beams": MATERIALS["steel"], "panels": MATERIALS["toughened-glass"]}
    for name in ("one", "two"):
        write(build(roof, [Beams(200, 12), Panels(20, 15)], material=glass), tmp_path / name)
    for name in FILES:
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes()


def test_dxf_is_sound_and_in_millimetres(drawing):
    assert not drawing.audit().errors
    assert drawing.header["$INSUNITS"] == 4
    assert set(DXF_LAYERS) <= {layer.dxf.name for layer in drawing.layers}


def test_dxf_has_one_block_a_part_with_its_outline(structure, drawing):
    inserts = [insert.dxf.name for insert in drawing.modelspace().query("INSERT")]
    assert inserts == [part.name for part in structure.parts]
    assert len(drawing.modelspace()) == len(inserts)
    for part in structure.parts:
        block = drawing.blocks.get(part.name)
        cut = block.query('*[layer=="CUT"]')
        assert len(cut) == 1
        assert cut[0].closed
        outline = np.array(cut[0].get_points("xy"))
        assert polygon_area(outline) == pytest.approx(part.area, rel=1e-9)
        assert outline.min(axis=0) == pytest.approx([0, 0], abs=1e-9)
        # the flat outline is the solid's own: its corners, in its own coordinates
        gap = np.linalg.norm(outline[:, None] - part.body.corners[None, :, :2], axis=2)
        assert gap.min(axis=1).max() <= 1e-7
        assert {entity.dxf.layer for entity in block} <= set(DXF_LAYERS)


def text_box(text):
    """Corners of a text as wide as its letters are high, seven tenths the usual plotter width."""
    align, place, _ = text.get_placement()
    assert align == TextEntityAlignment.MIDDLE_CENTER
    size = np.array([len(text.dxf.text), 1.0]) * text.dxf.height / 2
    turn = math.radians(text.dxf.rotation)
    x = np.array([math.cos(turn), math.sin(turn)])
    y = np.array([-x[1], x[0]])
    middle = np.array([place.x, place.y])
    return np.array([middle + a * size[0] * x + b * size[1] * y for a in (-1, 1) for b in (-1, 1)])


def depth(points, outline):
    """Smallest distance of the points inside a convex outline from its sides."""
    side = np.roll(outline, -1, axis=0) - outline
    side /= np.linalg.norm(side, axis=1)[:, None]
    arms = points[:, None] - outline[None]
    return (side[None, :, 0] * arms[..., 1] - side[None, :, 1] * arms[..., 0]).min()


def test_texts_lie_inside_and_names_are_right(structure, drawing):
    for part in structure.parts:
        block = drawing.blocks.get(part.name)
        labels = block.query('TEXT[layer=="LABEL"]')
        assert [label.dxf.text for label in labels] == [part.name]
        for text in block.query("TEXT"):
            assert text.dxf.height > 1
            assert depth(text_box(text), part.pattern.outline) > 0, part.name


def test_bevels_on_the_far_side_are_dashed_and_no_others(tmp_path):
    ends = {-5.0: [[10.0, 10.0], [90.0, 10.0]], 5.0: [[10.0, 30.0], [90.0, 30.0]]}
    bevels = tuple(Bevel(np.array(points), angle) for angle, points in ends.items())
    outline = np.array([[0.0, 0.0], [100.0, 0.0], [100.0, 50.0], [0.0, 50.0]])
    pattern = FlatPattern(outline, (), np.array([50.0, 20.0]), 5.0, bevels=bevels)
    write_dxf(tmp_path / "p.dxf", {"P1": pattern})
    lines = [
        line
        for block in ezdxf.readfile(tmp_path / "p.dxf").blocks
        for line in block.query("LINE[layer=='BEVEL']")
    ]
    drawn = {
        line.dxf.linetype == "FAR_SIDE": [[*line.dxf.start][:2], [*line.dxf.end][:2]]
        for line in lines
    }
    assert drawn == {True: ends[-5.0], False: ends[5.0]} and len(lines) == 2


def test_label_and_marks_do_not_cover_each_other(structure, drawing):
    for part in structure.parts:
        texts = list(drawing.blocks.get(part.name).query("TEXT"))
        boxes = [text_box(text) for text in texts]
        low = np.array([box.min(axis=0) for box in boxes])
        high = np.array([box.max(axis=0) for box in boxes])
        apart = ((low[:, None] > high[None]) | (high[:, None] < low[None])).any(axis=2)
        assert (apart | np.eye(len(texts), dtype=bool)).all(), part.name


def test_beams_carry_bevel_lines_and_vertices(structure, drawing):
    geometry = structure.results["beams"].geometry
    for edge, part in enumerate(structure.parts[: len(geometry.setback)]):
        block = drawing.blocks.get(part.name)
        lines = block.query('LINE[layer=="BEVEL"]')
        assert len(lines) == (geometry.setback[edge] > 1e-6).sum()
        solid_corners = part.body.corners[[1, 2, 4, 5, 7, 8, 10, 11], :2]
        for line in lines:
            for end in (line.dxf.start, line.dxf.end):
                gap = np.linalg.norm(solid_corners - [end.x, end.y], axis=1)
                assert gap.min() <= 1e-7
        texts = {text.dxf.text for text in block.query('TEXT[layer=="ENGRAVE"]')}
        assert texts == {f"N{vertex:04d}" for vertex in part.vertices}


def test_panels_name_their_neighbours(structure, drawing, roof):
    names = [part.name for part in structure.parts if part.kind == "panel"]
    sides = roof.connectivity.edge_faces
    for part in structure.parts[-len(names) :]:
        texts = {t.dxf.text for t in drawing.blocks.get(part.name).query('TEXT[layer=="ENGRAVE"]')}
        beside = {int(f) for f in sides[(sides == part.face).any(axis=1)].ravel()}
        assert texts == {names[face] for face in beside - {part.face, -1}}


def test_rows_do_not_overlap(structure):
    patterns = [part.pattern for part in structure.parts]
    low = row_layout(patterns)
    high = low + [pattern.size for pattern in patterns]
    apart = ((low[:, None] >= high[None] + 1) | (high[:, None] + 1 <= low[None])).any(axis=2)
    assert (apart | np.eye(len(patterns), dtype=bool)).all()
    width, height = high.max(axis=0)
    assert 0.2 < width / height < 5
    # 30 mm for cutter and clamps, as the manual of files has it.
    assert low[1, 0] - high[0, 0] == pytest.approx(30, abs=1e-9)


def test_parts_list_reads_back(structure, folder):
    with (folder / "parts.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert tuple(rows[0]) == COLUMNS
    assert set(REQUIRED.split()) <= set(COLUMNS)
    sizes = [column for column in COLUMNS if column.rpartition("_")[0] in SIZES]
    assert len(sizes) == len(SIZES)
    verdicts = structure.verdicts
    for row, part, verdict in zip(rows, structure.parts, verdicts, strict=True):
        assert (row["name"], row["kind"], row["family"]) == (part.name, part.kind, part.family)
        assert row["line"] == ("" if part.line is None else str(part.line))
        for column in sizes:
            value = getattr(part, column.rpartition("_")[0])
            assert float(row[column]) == pytest.approx(value, abs=1e-6)
        assert row["height_mm"] == row["width_mm"]
        for field in dataclasses.fields(Measures):
            value = getattr(part.measures, field.name)
            if value is None:
                assert row[field.name] == ""
            else:
                assert float(row[field.name]) == pytest.approx(value, rel=1e-5)
        assert tuple(map(int, row["vertices"].split())) == part.vertices
        assert row["face"] == ("" if part.face is None else str(part.face))
        assert row["verdict"] == verdict


def test_report_reads_back(structure, folder, roof):
    report = json.loads((folder / "report.json").read_text())
    assert report.pop("files") == list(FILES)
    assert report == json.loads(json.dumps(produce(structure).report()))
    assert report["unit"] == "mm"
    assert report["systems"] == ["beams", "panels"]
    assert report["counts"]["beams"] == len(roof.connectivity.edges)
    assert report["counts"]["panels"] == len(roof.faces)
    assert report["beams"]["twist_max"] <= 1e-7
    assert report["beams"]["height_deviation_max"] <= 0.05
    assert report["volume_mm3"] == pytest.approx(sum(part.volume for part in structure.parts))
    shrunk = report["panels"]["sides_shrunk_more"]
    assert shrunk == (structure.results["panels"].geometry.sides > 7.5 + 1e-6).sum() > 0
    assert [message for message in report["messages"] if f"{shrunk} sides" in message]


@pytest.mark.parametrize("failing", ["write_step", "write_dxf", "write_table", "write_report"])
def test_failure_leaves_nothing(small, tmp_path, monkeypatch, failing):
    def fail(path, *rest):
        path.write_text("half of it")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(files, failing, fail)
    with pytest.raises(OutputError, match="No space left"):
        write(small, tmp_path / "a" / "b")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("failing", ["write_sheet", "overview"])
def test_failing_sheets_leave_the_old_ones(small, tmp_path, monkeypatch, failing):
    shop = Workshop(sheet=(3000, 1500))
    write(small, tmp_path, workshop=shop)
    before = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    assert any(path.parent.name == "sheets" for path in before)

    def fail(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(files, failing, fail)
    with pytest.raises(OutputError, match=r"No space left on device.*free some space"):
        write(small, tmp_path, workshop=shop)
    assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == before


def test_a_file_in_the_place_of_the_sheets_is_said(small, tmp_path):
    (tmp_path / "sheets").write_text("mine")
    with pytest.raises(OutputError, match="sheets: is a file"):
        write(small, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["sheets"]


def test_failure_keeps_what_was_there(small, tmp_path, monkeypatch):
    before = {name: f"old {name}" for name in (*FILES, "notes.txt")}
    for name, text in before.items():
        (tmp_path / name).write_text(text)

    def fail(path, *rest):
        raise OrthoError("DXF: no")

    monkeypatch.setattr(files, "write_dxf", fail)
    with pytest.raises(OrthoError, match="DXF: no"):
        write(small, tmp_path)
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == before


def test_progress_rises_and_may_stop_the_writing(small, tmp_path):
    seen = []
    write(small, tmp_path / "whole", lambda fraction, words: seen.append((fraction, words)))
    fractions = [fraction for fraction, _ in seen]
    assert fractions == sorted(fractions)
    assert (fractions[0], fractions[-1]) == (0.0, 1.0)
    assert all(words for _, words in seen)
    for stop_at in (0, 2, len(seen) // 2, len(seen) - 3, len(seen) - 1):
        calls = iter(range(len(seen)))

        def stop(fraction, words, calls=calls, stop_at=stop_at):
            if next(calls) == stop_at:
                raise KeyboardInterrupt

        with pytest.raises(KeyboardInterrupt):
            write(small, tmp_path / "stopped", stop)
        assert not (tmp_path / "stopped").exists()


def test_folder_in_the_place_of_a_file_is_said_before_anything_is_written(small, tmp_path):
    (tmp_path / "parts.csv").mkdir()
    with pytest.raises(OutputError, match=r"parts\.csv: is a folder"):
        write(small, tmp_path)
    assert os.listdir(tmp_path) == ["parts.csv"]


def test_folder_that_cannot_be_made(small, tmp_path):
    (tmp_path / "file").write_text("not a folder")
    for target in (tmp_path / "file", tmp_path / "file" / "below"):
        with pytest.raises(OutputError, match="cannot be written"):
            write(small, target)
    assert (tmp_path / "file").read_text() == "not a folder"


def test_stages_are_timed(roof):
    seconds = stage_seconds(roof, [Beams(200, 12)])
    assert set(seconds) == {"build", "solids", "step", "dxf", "checks", "tables", "total"}
    assert seconds["total"] == pytest.approx(
        sum(value for name, value in seconds.items() if name != "total")
    )
    # The first run of a process also readies the drawing library, a third of so small a job.
    seconds = stage_seconds(roof, [Beams(200, 12)])
    assert seconds["total"] <= 3 * seconds["step"]


@pytest.mark.slow
def test_two_thousand_parts_take_little_more_than_the_step_writer():
    mesh = primitive("translational", 27, 27)
    mesh = mesh.scaled(1000 / mesh.mean_edge)
    seconds = stage_seconds(mesh, [Beams(200, 12), Panels(12, 10)])
    ours = seconds["build"] + seconds["solids"] + seconds["dxf"] + seconds["step"]
    assert ours <= 3 * seconds["step"]
    assert seconds["total"] <= 3 * seconds["step"]


def test_a_sheet_says_what_it_is_on_the_layer_of_its_rim(small, tmp_path):
    write(small, tmp_path, workshop=Workshop(sheet=(6000, 3000)), project="dome <1>")
    name = "sheet-001-steel-12mm.dxf"
    space = ezdxf.readfile(tmp_path / "sheets" / name).modelspace()
    (title,) = space.query("TEXT")
    assert (title.dxf.text, title.dxf.layer) == ("sheet 001 steel 12 mm", "SHEET")
    # Above the rim: it lies on no part.
    assert title.dxf.align_point.y - title.dxf.height / 2 > 3000
    assert "sheet 001 steel 12 mm, waste" in (tmp_path / "sheets" / "overview.svg").read_text()
    sheet = json.loads((tmp_path / "report.json").read_text())["sheets"]["sheets"][0]
    assert (sheet["file"], sheet["material"]) == (name, "steel")
    page = (tmp_path / "report.html").read_text()
    assert "<h1>Fabrication report: dome &lt;1&gt;</h1>" in page
    assert "<p>beams (height 200 mm, thickness 12 mm) on a net of " in page


def test_no_empty_drawing_where_nothing_is_flat(small, roof, tmp_path):
    write(small, tmp_path)
    assert (tmp_path / "flat.dxf").is_file()
    tubes = build(roof, [Beams(200, 12, section="hollow", section_width=80, ends="hub")])
    names = [path.name for path in write(tubes, tmp_path)]
    assert names == [name for name in FILES if name != "flat.dxf"]
    assert sorted(os.listdir(tmp_path)) == sorted(names)
    report = json.loads((tmp_path / "report.json").read_text())
    assert any(words.startswith("flat.dxf is not written") for words in report["messages"])
