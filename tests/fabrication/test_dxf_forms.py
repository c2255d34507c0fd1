"""Drawings without blocks, of version R12, with letters of strokes: read back by several readers.

The readers here know no INSERT, as many cutting programs: what is only in a block is lost on them.
"""

import csv
import json
import os
import re
import subprocess
import sys
from collections import Counter

import ezdxf
import numpy as np
import pytest
import shapely

from freecad_ortho.fabrication import (
    Beams,
    Bend,
    FlatPattern,
    Hole,
    Panels,
    Workshop,
    build,
    write,
)
from freecad_ortho.fabrication.dxf import DXF_LAYERS, write_dxf, write_sheet
from freecad_ortho.fabrication.dxf_form import DxfForm
from freecad_ortho.fabrication.pattern import polygon_area
from freecad_ortho.fabrication.production import produce
from freecad_ortho.fabrication.strokes import text_strokes
from solver.errors import InputError
from tests.conftest import ROOT


def tags(path):
    """Group codes and values of a DXF file, as the format's description has them."""
    lines = path.read_text(encoding="utf-8").splitlines()
    return [(int(code), value.strip()) for code, value in zip(lines[::2], lines[1::2], strict=True)]


def tag_reader(path):
    """(layer, corners) of the closed lines of a file, by nothing but its group codes."""
    found, section, entity = [], "", None
    for code, value in [*tags(path), (0, "EOF")]:
        if code == 2 and section == "?":
            section = value
        if code != 0:
            if section == "ENTITIES" and entity is not None:
                entity.append((code, value))
            continue
        if value == "SECTION":
            section = "?"
        # A heavy polyline goes on through its vertices.
        elif value in ("VERTEX", "SEQEND") and entity is not None:
            entity.append((0, value))
        else:
            found.append(entity)
            entity = [(0, value)] if section == "ENTITIES" else None
    return [line for line in map(_closed_line, filter(None, found)) if line is not None]


def _closed_line(entity):
    kind, values = entity[0][1], entity[1:]
    if kind not in ("LWPOLYLINE", "POLYLINE"):
        return None
    flags = next((int(value) for code, value in values if code == 70), 0)
    if not flags & 1:
        return None
    if kind == "POLYLINE":
        start = values.index((0, "VERTEX"))
        points = values[start:]
    else:
        points = values
    x = [float(value) for code, value in points if code == 10]
    y = [float(value) for code, value in points if code == 20]
    return next(value for code, value in values if code == 8), np.column_stack([x, y])


def ezdxf_reader(path):
    drawing = ezdxf.readfile(path)
    assert not drawing.audit().errors
    found = []
    for entity in drawing.modelspace():
        if entity.dxftype() == "LWPOLYLINE" and entity.closed:
            found.append((entity.dxf.layer, np.array(entity.get_points("xy"))))
        if entity.dxftype() == "POLYLINE" and entity.is_closed:
            corners = [vertex.dxf.location for vertex in entity.vertices]
            found.append((entity.dxf.layer, np.array([(p.x, p.y) for p in corners])))
    return found


READERS = (tag_reader, ezdxf_reader)


def outlines(reader, path):
    """Areas on CUT, largest first."""
    cut = [abs(polygon_area(points)) for layer, points in reader(path) if layer == "CUT"]
    return sorted(cut, reverse=True)


@pytest.fixture(scope="module")
def made(roof):
    """Some parts of two systems, on sheets."""
    structure = build(roof, [Beams(200, 12), Panels(20, 15)])
    return produce(structure, Workshop(sheet=(3000, 1500)))


@pytest.fixture(scope="module", params=["r2010", "r12"])
def flat(request, made, tmp_path_factory):
    folder = tmp_path_factory.mktemp(f"flat-{request.param}")
    form = DxfForm("flat", request.param, "strokes")
    write_dxf(folder / "flat.dxf", made.named_patterns, form)
    for sheet in made.sheets[:2]:
        write_sheet(folder / sheet.file_name, sheet, form)
    return folder


@pytest.fixture(scope="module")
def folder_of_parts(made, tmp_path_factory):
    """What a whole run writes with one file a part."""
    folder = tmp_path_factory.mktemp("parts")
    shop = Workshop(dxf="parts", dxf_version="r12")
    return folder, write(made.structure, folder, workshop=shop)


@pytest.mark.parametrize("reader", READERS)
def test_readers_without_blocks_get_every_outline(made, flat, reader):
    def areas(patterns):
        return sorted((polygon_area(p.outline) for p in patterns), reverse=True)

    wanted = areas(made.named_patterns.values())
    assert outlines(reader, flat / "flat.dxf") == pytest.approx(wanted, rel=1e-6)
    for sheet in made.sheets[:2]:
        wanted = areas(placed.pattern for placed in sheet.placements)
        assert outlines(reader, flat / sheet.file_name) == pytest.approx(wanted, rel=1e-6)


def test_blocks_hide_the_outlines_from_them(made, tmp_path):
    """So the readers here are what the tests above need."""
    write_dxf(tmp_path / "flat.dxf", made.named_patterns)
    assert [outlines(reader, tmp_path / "flat.dxf") for reader in READERS] == [[], []]


def test_flat_drawings_have_the_layers_and_what_is_on_them(made, flat):
    drawing = ezdxf.readfile(flat / "flat.dxf")
    assert set(DXF_LAYERS) <= {layer.dxf.name for layer in drawing.layers}
    kinds = Counter((e.dxf.layer, e.dxftype()) for e in drawing.modelspace())
    assert {layer for layer, _ in kinds} == {"CUT", "BEVEL", "ENGRAVE", "LABEL"}
    # Letters are lines; no text, no insert and no block of ours is left.
    assert {kind for _, kind in kinds} <= {"LWPOLYLINE", "POLYLINE", "LINE"}
    assert not any(re.match(r"[BP]\d{4}", block.name) for block in drawing.blocks)
    version = {"AC1024": "r2010", "AC1009": "r12"}[drawing.dxfversion]
    assert version in flat.name
    hidden = [e for e in drawing.modelspace().query("LINE") if e.dxf.linetype == "FAR_SIDE"]
    undercut = [b for pattern in made.named_patterns.values() for b in pattern.bevels if b.hidden]
    assert len(hidden) == len(undercut) > 0


def test_turned_parts_on_plain_sheets_lie_where_blocks_would(made, flat, tmp_path):
    for sheet in made.sheets[:2]:
        write_sheet(tmp_path / sheet.file_name, sheet)
        blocks = []
        for insert in ezdxf.readfile(tmp_path / sheet.file_name).modelspace().query("INSERT"):
            cut = [e for e in insert.virtual_entities() if e.dxf.layer == "CUT"]
            blocks += [shapely.Polygon(e.get_points("xy")) for e in cut]
        found = ezdxf_reader(flat / sheet.file_name)
        plain = [shapely.Polygon(points) for layer, points in found if layer == "CUT"]
        assert len(plain) == len(blocks) == len(sheet.placements)
        for one, other in zip(plain, blocks, strict=True):
            assert one.symmetric_difference(other).area < 1e-6 * one.area


def test_a_file_for_each_of_the_different_parts(made, folder_of_parts):
    folder, files = folder_of_parts
    assert not (folder / "flat.dxf").exists()
    names = sorted(path.name for path in (folder / "parts").iterdir())
    assert names == sorted(path.name for path in files if path.parent.name == "parts")
    with (folder / "parts.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    counts = Counter(row["equal_to"] for row in rows)
    parts = {part.name: part for part in made.structure.parts}
    assert len(counts) < len(parts)
    assert names == sorted(
        f"{name}-steel-{parts[name].thickness:g}mm-{count}x.dxf" for name, count in counts.items()
    )
    for path in list((folder / "parts").iterdir())[::5]:
        name = path.name.split("-")[0]
        for reader in READERS:
            assert outlines(reader, path) == pytest.approx([parts[name].area], rel=1e-6)
    assert json.loads((folder / "report.json").read_text())["files"][-1].startswith("parts/")


def test_a_file_for_several_parts_tells_nothing_that_is_true_of_one_alone(made, folder_of_parts):
    parts = {part.name: part for part in made.structure.parts}
    for path in list((folder_of_parts[0] / "parts").iterdir())[::4]:
        name, count = path.stem.split("-")[0], int(path.stem.rsplit("-", 1)[1][:-1])
        space = ezdxf.readfile(path).modelspace()
        assert [text.dxf.text for text in space.query('TEXT[layer=="LABEL"]')] == [name]
        engraved = {text.dxf.text for text in space.query('TEXT[layer=="ENGRAVE"]')}
        own = {mark.text for mark in parts[name].pattern.marks if mark.text}
        assert engraved == (own if count == 1 else set())


@pytest.mark.parametrize(("text", "kinds"), [("text", {"TEXT"}), ("none", set())])
def test_text_as_text_or_none(made, tmp_path, text, kinds):
    write_dxf(tmp_path / "flat.dxf", made.named_patterns, DxfForm("flat", "r12", text))
    space = ezdxf.readfile(tmp_path / "flat.dxf").modelspace()
    assert {entity.dxftype() for entity in space if entity.dxf.layer == "LABEL"} == kinds


def test_holes_axes_and_bends_are_there_in_r12(made, tmp_path, capfd):
    outline = np.array([[0, 0], [100, 0], [100, 60], [0, 60]], dtype=float)
    pattern = FlatPattern(
        outline,
        (),
        np.array([50.0, 30.0]),
        5.0,
        cutouts=(outline * 0.1 + 20,),
        holes=(Hole(np.array([80.0, 30.0]), 9.0),),
        axis=np.array([[0, 30], [50, 31], [100, 30]], dtype=float),
        bends=(Bend(np.array([[50.0, 0.0], [50.0, 60.0]]), 12.0),),
    )
    write_dxf(tmp_path / "flat.dxf", {"X": pattern}, DxfForm("flat", "r12"))
    space = ezdxf.readfile(tmp_path / "flat.dxf").modelspace()
    kinds = Counter((e.dxf.layer, e.dxftype()) for e in space)
    assert kinds == {
        ("CUT", "POLYLINE"): 2, ("HOLE", "CIRCLE"): 1, ("AXIS", "POLYLINE"): 1,
        ("BEND", "LINE"): 1, ("LABEL", "TEXT"): 1,
    }  # fmt: skip
    (circle,) = space.query("CIRCLE")
    assert (circle.dxf.center.x, circle.dxf.radius) == (80.0, 4.5)
    # Not a word of the library about units that R12 does not have.
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("letter", "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-+.,:/()=<>#%'*é")
def test_letters_are_as_high_as_asked_and_no_wider(letter):
    points = np.concatenate(text_strokes(letter, np.array([5.0, 7.0]), 12.0, 0.0))
    low, high = points.min(axis=0), points.max(axis=0)
    assert low[1] >= 7 - 6 - 1e-9 and high[1] <= 7 + 6 + 1e-9
    assert low[0] >= 5 - 4 - 1e-9 and high[0] <= 5 + 4 + 1e-9
    if letter.isalnum():
        assert high[1] - low[1] == pytest.approx(12)


def test_different_letters_look_different():
    letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
    drawn = {
        letter: str([line.tolist() for line in text_strokes(letter, np.zeros(2), 6.0, 0.0)])
        for letter in letters
    }
    assert len(set(drawn.values())) == len(letters)
    assert text_strokes("a", np.zeros(2), 6.0, 0.0)[0].tolist() == (
        text_strokes("A", np.zeros(2), 6.0, 0.0)[0].tolist()
    )


def test_a_text_is_centred_turned_and_fits_the_room_that_is_kept_for_it():
    words, size, middle = "P0017", 10.0, np.array([100.0, 50.0])
    flat = np.concatenate(text_strokes(words, middle, size, 0.0))
    assert (flat.min(axis=0) + flat.max(axis=0)) / 2 == pytest.approx(middle)
    # A letter is no wider than high, as the places of texts are reckoned.
    assert np.ptp(flat[:, 0]) <= len(words) * size
    turned = np.concatenate(text_strokes(words, middle, size, 90.0))
    assert turned - middle == pytest.approx((flat - middle) @ [[0, 1], [-1, 0]])


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"dxf": "layers"}, "dxf: expected blocks, flat or parts, got 'layers'"),
        ({"dxf_version": "r13"}, "dxf version: expected r2010 or r12, got 'r13'"),
        ({"dxf_text": "outline"}, "dxf text: expected text, strokes or none, got 'outline'"),
    ],
)
def test_unknown_words_are_refused(values, words):
    with pytest.raises(InputError, match=words):
        Workshop.of(values)


def test_another_run_writes_the_same_bytes(tmp_path):
    """Runs differ in the order of their sets of words."""
    code = (
        "import sys, numpy as np; from pathlib import Path\n"
        "from freecad_ortho.fabrication import FlatPattern\n"
        "from freecad_ortho.fabrication.dxf import write_dxf\n"
        "square = np.array([[0.0, 0], [80, 0], [80, 80], [0, 80]])\n"
        "pattern = FlatPattern(square, (), square.mean(axis=0), 8.0)\n"
        "write_dxf(Path(sys.argv[1]), {'P1': pattern})\n"
    )
    written = []
    for seed in "04":
        path = tmp_path / f"{seed}.dxf"
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        command = [sys.executable, "-c", code, str(path)]
        subprocess.run(command, cwd=ROOT, env=environment, check=True)
        written.append(path.read_bytes())
    assert written[0] == written[1]
