"""What is bought: bolts where the holes are, counted by size; as solids in STEP where wanted."""

import csv
import re
from collections import Counter

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication import build
from freecad_ortho.fabrication.bolts import (
    BOLTS,
    LENGTHS,
    SMALL,
    WASHERS,
    bolt_in,
    bolt_of,
    on_wood,
)
from freecad_ortho.fabrication.fasteners import Supply, gathered, hardware_rows
from freecad_ortho.fabrication.files import write
from freecad_ortho.fabrication.hardware import bolt_bodies, bolt_frames, bolt_shape
from freecad_ortho.fabrication.material import material
from freecad_ortho.fabrication.site import Selection
from freecad_ortho.fabrication.step import read_step
from freecad_ortho.fabrication.systems import Lamellas
from freecad_ortho.fabrication.workshop import Workshop
from solver.errors import InputError
from tests.fabrication.test_lamellas import flat_grid, helicoid

TUBE = {"section": "tube:100x60x5", "bolt": "M12"}
BALL = {"node": "ball", "section": "chs:88.9x5"}


@pytest.fixture(scope="module")
def bolted(dodecahedron):
    """By what its bolts hold, a small structure of each kind that has bolts."""
    lying = Lamellas(60, 5, position="lying", layers=2, hole=11)
    return {
        "hubs and end plates": api.fabricate(dodecahedron, "beams+nodes", node="bolted", **TUBE),
        "webs and arms of stars": api.fabricate(dodecahedron, "beams+nodes", node="star"),
        "cones and balls": api.fabricate(dodecahedron, "beams+nodes", **BALL),
        "crossings of lamellas": build(flat_grid(), [lying]),
        "splices of lamellas": build(helicoid().scaled(3000.0), [Lamellas(40, 3, stock=2500.0)]),
    }


@pytest.mark.parametrize("name", ["C24", "plywood"])
def test_washers_on_wood_are_as_large_as_it_needs(name):
    """EN 1995-1-1, 10.4.3: three bolts wide and 0.3 bolts thick, under head and nut."""
    lying = Lamellas(60, 5, position="lying", layers=2, hole=11, clearance=1)
    [each] = build(flat_grid(), [lying], material=material(name)).fasteners
    [steel] = build(flat_grid(), [lying]).fasteners
    assert each.bolt.washer_width >= 3 * each.bolt.diameter
    assert each.bolt.washer >= 0.3 * each.bolt.diameter
    assert each.grip == pytest.approx(11 + 2 * each.bolt.washer)
    assert each.length >= each.grip + each.bolt.nut + each.bolt.pitch
    # Heads stand as much higher as washers are thicker.
    up = np.einsum("nk,nk->n", steel.places - each.places, each.directions)
    assert np.allclose(up, each.bolt.washer - steel.bolt.washer)
    [washers] = [row for row in hardware_rows([each], ()) if row[0] == "washer"]
    assert washers[1:] == ["M10", "", "", "DIN 440 R", "100 HV", 2 * each.count, "piece", ""]
    [own] = [row for row in hardware_rows([steel], ()) if row[0] == "washer"]
    assert own[4:6] == [WASHERS, "200 HV"]


def test_sizes_of_washers_on_wood_follow_the_rule():
    for bolt in (*SMALL, *BOLTS.values()):
        if bolt.diameter <= 20:
            assert on_wood(bolt).washer_width >= 3 * bolt.diameter
            assert on_wood(bolt).washer == np.ceil(0.3 * bolt.diameter)
        else:
            assert on_wood(bolt) == bolt


def test_sizes_of_bolts_keep_the_proportions_of_their_standards():
    for bolt in (*SMALL, *BOLTS.values()):
        size = bolt.diameter
        # Drilled for a thread (ISO 2306), clear of a wrench (ISO 7738).
        assert bolt.drill == pytest.approx(size - bolt.pitch, abs=0.051), bolt.name
        assert bolt.wrench == np.ceil(2.1 / 2 * bolt.flats + 1), bolt.name
        # Hexagons with their corners rounded; heads, washers and nuts by the size.
        assert 1.09 < bolt.corners / bolt.flats < 2 / np.sqrt(3), bolt.name
        assert 0.6 < bolt.head / size <= 0.7 and 0.8 < bolt.nut / size < 0.95, bolt.name
        assert 1.8 < bolt.washer_width / size <= 2.0, bolt.name
        assert 0.12 < bolt.washer / size < 0.27 and 1.5 <= bolt.flats / size <= 1.7, bolt.name
    # The lengths of ISO 888.
    assert LENGTHS == (*range(20, 75, 5), *range(80, 160, 10))


def drills_of(part):
    """(N, 3) middles of the holes of a plate in its place, and (N,) their diameters."""
    body = part.body
    points = np.array([drill.centre for drill in body.drills]).reshape(-1, 3)
    return part.origin + points @ part.frame, [drill.diameter for drill in body.drills]


@pytest.mark.parametrize("holds", ["webs and arms of stars", "splices of lamellas"])
def test_bolts_go_through_the_middles_of_the_holes_that_they_join(bolted, holds):
    structure = bolted[holds]
    parts = {part.name: part for part in structure.parts}
    drilled = {
        name: drills_of(part) for name, part in parts.items() if hasattr(part.body, "drills")
    }
    for each in structure.fasteners:
        for place, way, names in zip(each.places, each.directions, each.joins, strict=True):
            assert np.linalg.norm(way) == pytest.approx(1.0)
            for name in names:
                arms = drilled[name][0] - place
                depth = arms @ way
                off = np.linalg.norm(arms - depth[:, None] * way, axis=1)
                nearest = int(off.argmin())
                # A lamella that twists leans a little off the plate that lies on it.
                assert off[nearest] < (0.5 if "lamellas" in holds else 1e-6)
                assert each.bolt.washer < depth[nearest] < each.grip - each.bolt.washer
                assert each.bolt.hole <= drilled[name][1][nearest] + 1e-9


def test_every_hole_has_its_bolt(bolted):
    for holds, structure in bolted.items():
        assert {each.holds for each in structure.fasteners} == {holds}
        count = sum(each.count for each in structure.fasteners)
        names = {part.name for part in structure.parts}
        assert {name for each in structure.fasteners for row in each.joins for name in row} <= names
        report = structure.report()
        if "nodes" in report:
            assert count == report["nodes"]["bolts"]
        elif "crossings" in holds:
            assert count == report["lamellas"]["crossings"] > 0
        else:
            plates = [part for part in structure.parts if part.kind == "splice"]
            assert count == sum(len(part.pattern.holes) for part in plates) > 0


@pytest.mark.parametrize("holds", ["hubs and end plates", "cones and balls"])
def test_heads_stand_free_and_threads_end_in_the_parts_that_have_them(bolted, holds):
    structure = bolted[holds]
    each = structure.fasteners[0]
    solids = {part.name: part.solid() for part in structure.parts}
    for number in range(0, each.count, 7):
        first, last = each.joins[number][0], each.joins[number][-1]
        place, way = each.places[number], each.directions[number]
        # Beside the shank: within the wall under the head, within the thread at its end.
        aside = bolt_frames(each)[number, 0] * (each.bolt.hole / 2 + 1.5)
        tip = place + (each.length - 1) * way + aside
        # The wall begins where its washers end.
        for depth, within in ((-0.1, False), (0.1, True)):
            wall = place + (each.washers * each.bolt.washer + depth) * way + aside
            assert solids[first].isInside(tuple(wall)) == within
        assert solids[last].isInside(tuple(tip))
        under = place - 1 * way + aside
        assert not any(solid.isInside(tuple(under)) for solid in solids.values())


def test_of_eight_bolts_of_a_wide_splice_four_go_through_each_end():
    some = Selection(family="u", lines=(0,))
    lamellas = Lamellas(150, 3, stock=2500.0)
    made = build(helicoid().scaled(3000.0), [lamellas], selection=some)
    joins = Counter(names for each in made.fasteners for names in each.joins)
    plates = [part.name for part in made.parts if part.kind == "splice"]
    assert len(joins) == 2 * len(plates) > 0
    assert set(joins.values()) == {4}


def test_washers_lie_on_both_outer_faces_of_crossing_lamellas(bolted):
    structure = bolted["crossings of lamellas"]
    (each,) = structure.fasteners
    solids = {part.name: part.solid() for part in structure.parts}
    washer = each.bolt.washer
    for number in range(0, each.count, 5):
        place, way = each.places[number], each.directions[number]
        aside = place + bolt_frames(each)[number, 0] * (each.bolt.hole / 2 + 1.5)
        inside = [
            [name for name, solid in solids.items() if solid.isInside(tuple(aside + depth * way))]
            for depth in (washer - 0.1, washer + 0.1, each.grip - washer - 0.1)
        ]
        first, last = each.joins[number]
        assert inside == [[], [first], [last]]
        beyond = aside + (each.grip - washer + 0.1) * way
        assert not any(solid.isInside(tuple(beyond)) for solid in solids.values())


def test_the_list_counts_bolts_washers_and_nuts():
    bolt = bolt_of("M16")
    spots = [(np.full(3, 9.0 * k), np.eye(3)[2], (f"A{k}", f"B{k}")) for k in range(5)]
    through = gathered(bolt, 50.0, 26.0, 2, True, "plates", spots)
    thread = gathered(bolt, 50.0, 24.0, 1, False, "hubs", spots[:2])
    none = gathered(bolt, 90.0, 24.0, 1, False, "nothing", [])
    rows = hardware_rows([through, thread, none], [Supply("gasket", "5 mm", 12.345, "m", "frames")])
    assert [(row[0], row[1], row[2], row[6], row[7]) for row in rows] == [
        ("bolt", "M16", "50", 5, "piece"),
        ("bolt", "M16", "50", 2, "piece"),
        ("washer", "M16", "", 12, "piece"),
        ("nut", "M16", "", 5, "piece"),
        ("gasket", "5 mm", "", "12.35", "m"),
    ]


def test_small_bolts_fill_the_holes_of_lamellas():
    assert [bolt_in(hole) and bolt_in(hole).name for hole in (5.0, 6.0, 9.0, 11.0, 19.0)] == [
        None,
        "M5",
        "M8",
        "M10",
        "M16",
    ]
    for bolt in SMALL:
        assert bolt.corners == pytest.approx(2 / np.sqrt(3) * bolt.flats, rel=0.06)
        assert bolt.drill + bolt.pitch == pytest.approx(bolt.diameter, abs=0.06)
        assert bolt.wrench >= 1.05 * bolt.flats
    made = build(flat_grid(), [Lamellas(60, 5, position="lying", layers=2, hole=5.0)])
    assert made.fasteners == ()
    assert "from 5.5 mm on" in " ".join(made.report()["messages"])


def test_washers_and_nuts_are_those_of_their_standards():
    """EN ISO 7089: outer diameter, thickness; EN ISO 4032: across flats, largest height."""
    sizes = {
        each.name: (each.washer_width, each.washer, each.flats, each.nut)
        for each in (*SMALL, *BOLTS.values())
    }
    assert sizes == {
        "M5": (10, 1, 8, 4.7), "M6": (12, 1.6, 10, 5.2), "M8": (16, 1.6, 13, 6.8),
        "M10": (20, 2, 16, 8.4), "M12": (24, 2.5, 18, 10.8), "M16": (30, 3, 24, 14.8),
        "M20": (37, 3, 30, 18), "M24": (44, 4, 36, 21.5), "M27": (50, 4, 41, 23.8),
        "M30": (56, 4, 46, 25.6),
    }  # fmt: skip


def test_a_bolt_has_the_volume_of_its_formula():
    bolt = bolt_of("M20")
    each = gathered(bolt, 70.0, 46.0, 2, True, "plates", [(np.zeros(3), np.eye(3)[2], ("A", "B"))])
    hexagon = 3 * np.sqrt(3) / 8 * bolt.corners**2
    washer = np.pi / 4 * (bolt.washer_width**2 - (bolt.diameter + 1) ** 2) * bolt.washer
    shank = np.pi / 4 * bolt.diameter**2
    whole = hexagon * (bolt.head + bolt.nut) - shank * bolt.nut + shank * 70.0 + 2 * washer
    assert sum(body.volume for body in bolt_bodies(each)) == pytest.approx(whole, rel=1e-12)
    shape = bolt_shape(each)
    assert shape.isValid()
    assert shape.Volume() == pytest.approx(whole, rel=1e-9)


@pytest.mark.parametrize("step", ["one", "in-place", "systems"])
def test_solids_are_one_product_a_size_with_a_place_for_each(bolted, tmp_path, step):
    structure = bolted["webs and arms of stars"]
    write(structure, tmp_path, workshop=Workshop(hardware="solids", step=step))
    name = "structure-nodes-steel.step" if step == "systems" else "structure.step"
    each = structure.fasteners[0]
    found = {name: shape for name, shape in read_step(tmp_path / name) if name.startswith("M16x")}
    assert len(found) == each.count == structure.report()["nodes"]["bolts"]
    middle = {name: np.array(shape.CenterOfBoundBox().toTuple()) for name, shape in found.items()}
    low, high = -each.bolt.head, each.length
    for number in (0, each.count - 1):
        place = each.places[number] + (low + high) / 2 * each.directions[number]
        assert np.linalg.norm(middle[f"{each.name}-{number + 1:04d}"] - place) < 3
    if step == "one":
        text = (tmp_path / name).read_text()
        assert len(re.findall(r"=PRODUCT\('M16x", text.replace(" ", ""))) == 1


def test_the_list_is_a_file_of_every_structure_that_has_bolts(bolted, tmp_path):
    files = write(bolted["hubs and end plates"], tmp_path)
    assert tmp_path / "hardware.csv" in files
    with (tmp_path / "hardware.csv").open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    with (tmp_path / "bolts.csv").open(encoding="utf-8", newline="") as stream:
        bolts = next(csv.DictReader(stream))
    assert [row["item"] for row in rows] == ["bolt", "washer"]
    for key in ("count", "length_mm", "grip_mm", "standard", "grade"):
        assert (
            float(rows[0][key]) == float(bolts[key])
            if key.endswith("mm")
            else (rows[0][key] == bolts[key])
        )
    # Another run without bolts takes the list away.
    write(api.fabricate(bolted["hubs and end plates"].mesh, "beams"), tmp_path)
    assert not (tmp_path / "hardware.csv").exists()


@pytest.mark.parametrize(
    "holds", ["hubs and end plates", "webs and arms of stars", "cones and balls"]
)
def test_both_lists_of_bolts_say_one_grip(bolted, holds):
    structure = bolted[holds]
    table = next(t for t in structure.results["nodes"].tables if t.name == "bolts.csv")
    listed = {float(row[table.columns.index("grip_mm")]) for row in table.rows}
    rows = [row for row in hardware_rows(structure.fasteners, ()) if row[0] == "bolt"]
    assert sorted(float(row[3]) for row in rows) == pytest.approx(sorted(listed), abs=1e-3)


def test_an_unknown_word_is_refused():
    with pytest.raises(InputError, match=r"hardware: expected list or solids, got 'all'"):
        Workshop(hardware="all")


def test_feet_and_frames_say_what_is_bought(roof):
    made = api.fabricate(roof, "beams+panels+feet", frame="plate", foot_height=2500.0)
    rows = {row[0]: row for row in hardware_rows(made.fasteners, made.supplies)}
    feet = made.report()["feet"]
    assert rows["anchor"][1] == "M16"
    assert rows["anchor"][6] == rows["anchor nut"][6] == str(feet["anchors"])
    grades = [rows[f"anchor{item}"][5] for item in ("", " washer", " nut")]
    assert grades == ["8.8", "200 HV", "8"]
    frames = next(t for t in made.results["panels"].tables if t.name == "frames.csv")
    blocks = next(t for t in made.results["panels"].tables if t.name == "setting-blocks.csv")
    assert rows["setting block"][6] == str(len(blocks.rows))
    assert rows["screw"][6] == str(sum(row[4] for row in frames.rows))
    sealed = sum(2 * len(row[2].split()) * float(row[3]) for row in frames.rows)
    assert float(rows["gasket"][6]) == pytest.approx(sealed / 1000, abs=0.006)
