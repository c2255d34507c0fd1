"""How a structure is put up: sequences, node book, survey points; weights against the solids."""

import csv
import re
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Lamellas, Panels, Workshop, build, write
from freecad_ortho.fabrication.exchange.assembly import ranks_by_ring, rings_of, sequence
from freecad_ortho.fabrication.exchange.assembly_page import _sketch, pictures_of
from freecad_ortho.fabrication.step import read_step
from freecad_ortho.fabrication.systems.nodes import Nodes
from solver.errors import InputError
from tests.fabrication.test_lamellas import flat_grid

# Coordinates of a national grid, mm.
FAR = np.array([3.5e9, 5.4e9, 4e5])


@pytest.fixture(scope="module")
def job(roof):
    return build(roof, [Nodes(), Beams(200, 20, ends="hub"), Panels(20, 15)])


@pytest.fixture(scope="module")
def folder(job, tmp_path_factory):
    root = tmp_path_factory.mktemp("assembly")
    shop = Workshop(write="assembly", site_origin="1000,2000,300", site_rotation=90.0)
    write(job, root, workshop=shop)
    return root


def rows_of(folder, name):
    with (folder / "assembly" / f"{name}.csv").open(encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


@pytest.mark.parametrize("name", ["sequence-by-ring", "sequence-by-line"])
def test_every_part_once_and_none_before_it_stands_on_something(job, folder, name):
    rows = rows_of(folder, name)
    assert sorted(row["name"] for row in rows) == sorted(part.name for part in job.parts)
    assert [int(row["step"]) for row in rows] == list(range(1, len(rows) + 1))
    vertices = {part.name: set(part.vertices) for part in job.parts}
    border = set(np.flatnonzero(job.mesh.connectivity.boundary_vertices).tolist())
    standing = set()
    for row in rows:
        here = vertices[row["name"]]
        assert here & (border | standing)
        held = row["stands_on"].split()
        assert all(vertices[other] & here for other in held)
        standing |= here
    assert float(rows[-1]["placed_kg"]) == pytest.approx(sum(job.masses.values()), rel=1e-6)


def test_rings_go_up_and_lines_stay_together(job, folder):
    rings = [int(row["ring"]) for row in rows_of(folder, "sequence-by-ring")]
    assert rings == sorted(rings)
    assert max(rings) > 1
    beams = [row for row in rows_of(folder, "sequence-by-line") if row["kind"] == "beam"]
    lines = [(row["family"], row["line"]) for row in beams]
    changes = sum(one != other for one, other in pairwise(lines))
    # A line that hangs in the air when its turn comes may have to wait.
    assert changes < 2 * len(set(lines))


@pytest.mark.parametrize("name", ["sequence-by-ring", "sequence-by-line"])
def test_each_part_finds_what_carries_it(job, folder, name):
    order = {row["name"]: int(row["step"]) for row in rows_of(folder, name)}
    beams = [part for part in job.parts if part.kind == "beam"]
    nodes = {part.vertices[0]: order[part.name] for part in job.parts if part.kind == "node"}
    for beam in beams:
        # It is bolted to one node at least that stands.
        assert min(nodes[vertex] for vertex in beam.vertices) < order[beam.name]
    for panel in (part for part in job.parts if part.kind == "panel"):
        around = [order[b.name] for b in beams if set(b.vertices) <= set(panel.vertices)]
        assert len(around) == 4
        assert max(around) < order[panel.name]


def test_plates_go_up_with_the_beam_that_they_end(roof):
    parts = build(roof, [Nodes("bolted"), Beams(200, 60, ends="end-plate")]).parts
    rings = rings_of(build(roof, [Beams(200, 20)]).site, parts)
    order = [step.part.name for step in sequence(parts, ranks_by_ring(parts, rings), rings)]
    for plate in (part.name for part in parts if part.kind == "end-plate"):
        beam = order.index(plate.split("-")[0])
        assert 1 <= order.index(plate) - beam <= 4


def test_splices_come_after_both_pieces_that_they_join(tmp_path):
    """They have no vertex of the net; on paper they stood first, on nothing."""
    made = build(flat_grid(5, 5), [Lamellas(width=60, thickness=4, stock=1000)])
    write(made, tmp_path, workshop=Workshop(write="assembly"))
    splices = [part.name for part in made.parts if part.kind == "splice"]
    assert len(splices) > 5
    for name in ("sequence-by-ring", "sequence-by-line"):
        rows = rows_of(tmp_path, name)
        assert sorted(row["name"] for row in rows) == sorted(part.name for part in made.parts)
        before = {row["name"]: {other["name"] for other in rows[:k]} for k, row in enumerate(rows)}
        for row in rows:
            held = set(row["stands_on"].split())
            assert held <= before[row["name"]]
            if row["name"] in splices:
                line, _, number = row["name"].removeprefix("S-").partition("-")
                assert held == {f"L-{line}-{int(number) + k}" for k in (0, 1)}


def test_feet_are_what_a_structure_stands_on(roof):
    feet = SimpleNamespace(kind="foot", vertices=(40,))
    frame = build(roof, [Beams(200, 20)])
    rings = rings_of(frame.site, [*frame.parts, feet])
    assert rings[40] == 0
    assert rings.count(0) == 1
    assert max(rings) > 5


def test_where_a_net_overhangs_the_border_is_what_is_built(roof):
    frame = build(roof, [Beams(200, 20)])
    border = frame.site.mesh.connectivity.boundary_vertices
    inner = [part for part in frame.parts if not border[list(part.vertices)].any()]
    rings = rings_of(frame.site, inner)
    assert 0 < sum(rings[v] == 0 for part in inner for v in part.vertices)
    assert all(rings[vertex] for vertex in np.flatnonzero(border).tolist())


def test_weights_and_centres_are_those_of_the_solids(job, folder):
    rows = {row["name"]: row for row in rows_of(folder, "sequence-by-ring")}
    solids = dict(read_step(folder / "structure.step"))
    for part in job.parts[::9]:
        row, solid = rows[part.name], solids[part.name]
        assert float(row["mass_kg"]) == pytest.approx(part.mass, abs=6e-4)
        seen = solid.Center().toTuple()
        np.testing.assert_allclose([float(row[f"{k}_mm"]) for k in "xyz"], seen, atol=0.01)


def test_the_book_goes_round_each_node(job, folder):
    book = {}
    for row in rows_of(folder, "node-book"):
        book.setdefault(row["node"], []).append(row)
    points, axes = job.mesh.vertices, job.axes.directions
    parts = {part.name: part for part in job.parts}
    for name, rows in list(book.items())[::5]:
        vertex = int(name[1:])
        assert sum(float(row["angle_deg"]) for row in rows) == pytest.approx(360, abs=1e-3)
        for row, following in zip(rows, [*rows[1:], rows[0]], strict=True):
            arms = [points[int(each["towards"][1:])] - points[vertex] for each in (row, following)]
            flat = [arm - arm @ axes[vertex] * axes[vertex] for arm in arms]
            turn = np.arctan2(np.cross(*flat) @ axes[vertex], flat[0] @ flat[1])
            assert np.degrees(turn) % 360 == pytest.approx(float(row["angle_deg"]), abs=1e-2)
            (beam,) = row["parts"].split()
            assert row["ends"] == ("start" if parts[beam].vertices[0] == vertex else "end")
            # The side that is named lies to the beam's right.
            side = points[int(row["right_side_to"][1:])] - points[vertex]
            others = [points[int(each["towards"][1:])] - points[vertex] for each in rows]
            right = parts[beam].frame[2]
            if len(rows) == 4 and row["ring"] != "0":
                assert side @ right == max(other @ right for other in others)


def test_survey_points_are_on_site(job, folder):
    rows = {row["point"]: row for row in rows_of(folder, "survey")}
    assert len(rows) == len(job.mesh.vertices)
    for vertex in (0, 17, 40):
        x, y, z = job.mesh.vertices[vertex] / 1000
        row = rows[f"N{vertex:04d}"]
        found = [float(row[name]) for name in ("east_m", "north_m", "height_m")]
        np.testing.assert_allclose(found, [1000 - y, 2000 + x, 300 + z], rtol=0, atol=1e-5)


def test_national_grid_coordinates_lose_nothing(roof, tmp_path):
    near = build(roof, [Beams(200, 20)])
    far = build(roof.with_vertices(roof.vertices + FAR), [Beams(200, 20)])
    for name, job in (("near", near), ("far", far.measured_from("local"))):
        write(job, tmp_path / name, workshop=Workshop(write="assembly"))
    for one, other in zip(
        rows_of(tmp_path / "near", "survey"), rows_of(tmp_path / "far", "survey"), strict=True
    ):
        names = ("east_m", "north_m", "height_m")
        moved = [float(other[name]) - float(one[name]) for name in names]
        np.testing.assert_allclose(moved, FAR / 1000, rtol=0, atol=2e-5)


@pytest.mark.parametrize("origin", ["1,2", "a,b,c", "1,2,nan", "1;2;3"])
def test_a_site_that_is_none_is_refused(origin):
    with pytest.raises(InputError, match=r"site origin: expected east,north,height in metres"):
        Workshop(site_origin=origin)


def test_pictures_show_what_stands_and_what_comes(job, folder):
    page = (folder / "assembly" / "assembly.html").read_text(encoding="utf-8")
    order = [row["name"] for row in rows_of(folder, "sequence-by-ring")]
    rings = [int(row["ring"]) for row in rows_of(folder, "sequence-by-ring")]
    stood, came = 0, []
    for figure in re.findall(r"<figure><h2>.*?</figure>", page):
        comes = [int(k) for k in re.findall(r'<use href="#s(\d+)" class="comes"/>', figure)]
        stands = [int(k) for k in re.findall(r'<use href="#s(\d+)" class="stands"/>', figure)]
        assert sorted(stands) == list(range(stood))
        assert sorted(comes) == list(range(stood, stood + len(comes)))
        shown = re.findall(r'<text x="([^"]+)" y="([^"]+)">([^<]+)</text>', figure)
        assert [name for *_, name in shown] == [
            order[k] for k in sorted(comes) if order[k] in {name for *_, name in shown}
        ]
        left_out = re.search(r"Names of (\d+) that have no room", figure)
        assert len(shown) == len(comes) - (int(left_out[1]) if left_out else 0)
        places = np.array([(float(x), float(y)) for x, y, _ in shown])
        apart = np.abs(places[:, None] - places)
        # A letter is at least half as wide as a line is high, 13.
        touch = (apart[..., 0] < 6.5 * len(shown[0][2])) & (apart[..., 1] < 12.9)
        assert touch.sum() == len(shown)
        assert len({rings[k] for k in comes}) == 1
        stood += len(comes)
        came += comes
    assert len(came) == len(job.parts)
    assert all(f'id="s{k}"' in page for k in came)


def test_sketches_of_nodes_have_every_end(folder):
    page = (folder / "assembly" / "assembly.html").read_text(encoding="utf-8")
    sketches = dict(re.findall(r'aria-label="(N\d+)">(.*?)</svg>', page))
    for row in rows_of(folder, "node-book"):
        words = f"{row['parts']} {row['ends']}"
        assert words in sketches[row["node"]]
        assert f"to {row['towards']}" in sketches[row["node"]]


def test_large_structures_have_few_pictures():
    stages = [0] * 30 + [1] * 3000
    found = pictures_of(stages)
    assert len(found) <= 61
    assert [end for _, end in found][:1] == [30]
    assert found[0][0] == 0
    assert all(one[1] == two[0] for one, two in pairwise(found))
    assert found[-1][1] == len(stages)


def test_words_of_an_arm_stand_beyond_its_end():
    arms = [
        SimpleNamespace(turn_deg=turn, parts=f"B{turn}", towards="N1") for turn in (0, 90, 180, 270)
    ]
    drawn = _sketch("N0", arms)
    anchors = {words: anchor for anchor, words in re.findall(r'text-anchor="(\w+)">(B\d+)<', drawn)}
    assert anchors == {"B0": "start", "B90": "middle", "B180": "end", "B270": "middle"}
