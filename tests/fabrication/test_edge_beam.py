"""Beams along borders: pieces from bend to bend, what ends at them, and what lies on them."""

import csv

import numpy as np
import pytest
import shapely
from cadquery import importers

from freecad_ortho.fabrication import Beams, Lamellas, Panels, build
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.files import write
from freecad_ortho.fabrication.profiles import profile
from freecad_ortho.fabrication.systems import EdgeBeam, Nodes, systems_of
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.fabrication.conftest import grid_faces, on_roof
from tests.fabrication.test_trimming import circle

SECTIONS = {
    "plate": EdgeBeam("plate"),
    "tube": EdgeBeam("tube", section_height=150, width=60, wall=6),
    "round": EdgeBeam("round", width=90, wall=4),
    "rolled": EdgeBeam("HEB160", rounded=True),
    "channel": EdgeBeam("UPE160"),
    "timber": EdgeBeam("GL24h:100x240"),
    "strip": EdgeBeam("strip", width=8),
}


@pytest.fixture(scope="module")
def sheet():
    """A plane net of squares of 1 m, 6 by 5."""
    x, y = np.meshgrid(np.arange(7.0), np.arange(6.0))
    points = np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3)
    return QuadMesh(1000 * points, grid_faces(6, 7))


@pytest.fixture(scope="module")
def border(roof):
    """An outer border on the roof and an opening in it."""
    return [on_roof(roof, 2.6, 4.1), on_roof(roof, 0.8, 1.3)]


def pieces_of(structure):
    return structure.results["edge-beam"].parts


def test_round_a_plane_net_it_is_four_pieces_of_known_volume(sheet):
    structure = build(sheet, [EdgeBeam("tube", width=60, wall=5)])
    pieces = pieces_of(structure)
    assert [part.name for part in pieces] == ["E1-001", "E1-002", "E1-003", "E1-004"]
    assert sorted(part.length for part in pieces) == pytest.approx([5060, 5060, 6060, 6060])
    # The middle line of a frame with mitred corners has the length of the rectangle.
    volume = (200 * 60 - 190 * 50) * 2 * (6000 + 5000)
    assert sum(part.volume for part in pieces) == pytest.approx(volume)
    assert all("plan" in part.note and "45.00" in part.note for part in pieces)
    assert structure.results["edge-beam"].report["bend_max_deg"] == pytest.approx(90)


def test_pieces_longer_than_the_stock_are_cut_into_equal_lengths(sheet):
    structure = build(sheet, [EdgeBeam(stock=2000)])
    pieces = pieces_of(structure)
    assert len(pieces) == 2 * 4 + 2 * 3
    assert max(part.length for part in pieces) <= 2000
    whole = pieces_of(build(sheet, [EdgeBeam()]))
    assert sum(part.volume for part in pieces) == pytest.approx(sum(p.volume for p in whole))
    assert check_clashes(pieces).clashes == ()
    rows = structure.results["edge-beam"].tables[0].rows
    assert [row[3] for row in rows] == [*(part.name for part in pieces[1:]), pieces[0].name]
    assert sorted(row[4] for row in rows)[-4:] == pytest.approx([90] * 4)
    assert sum(row[4] for row in rows) == pytest.approx(360)


@pytest.mark.parametrize("section", SECTIONS)
def test_solids_are_closed_and_as_large_as_their_formula(roof, border, section):
    structure = build(roof, [SECTIONS[section]], border=border)
    pieces = pieces_of(structure)
    assert structure.results["edge-beam"].report["ways"] == 2
    for part in pieces:
        solid = part.solid()
        assert solid.isValid(), part.name
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)
        if part.pattern is not None:
            assert shapely.Polygon(part.pattern.outline).is_valid
            assert part.pattern.outline.min(axis=0) == pytest.approx([0, 0])
            # Where strips are bent, what stands out beyond the lower one of two plates is cut off.
            near = 1e-3 if section == "strip" else 1e-6
            assert part.volume == pytest.approx(part.area * part.thickness, rel=near)
    assert check_clashes(pieces).clashes == ()


def test_it_follows_the_border_with_its_upper_side_at_the_level(sheet):
    structure = build(sheet, [EdgeBeam("plate", offset="above", height=150)], border=[ROUND])
    pieces = pieces_of(structure)
    for part in pieces:
        corners = part.points
        assert corners[:, 2].max() == pytest.approx(150)
        assert corners[:, 2].min() == pytest.approx(0)
        # No piece leaves the circle by more than half its width, beside that width.
        radius = np.linalg.norm(corners[:, :2] - [3000, 2500], axis=1)
        assert np.abs(radius - 2100).max() <= 20.5
    bends = [row[4] for row in structure.results["edge-beam"].tables[0].rows]
    assert sum(bends) == pytest.approx(360)


ROUND = circle(3000, 2500, 2100)
JOINED = {
    "plates": (Beams(200, 12), Panels(20, 15)),
    "tubes": (Beams(200, 5, section="hollow", section_width=60), Panels(20, 15, edge="bevel")),
    "hubs": (Beams(200, 12, ends="hub", hub_diameter=120), Nodes(diameter=120), Panels(20, 15)),
    "rolled": (Beams(200, 5, section="HEA100"), Panels(20, 15)),
    "lapped": (Beams(200, 12, ends="lapped"), Panels(20, 15)),
    "panels alone": (Panels(20, 15),),
}


@pytest.mark.parametrize("systems", JOINED)
@pytest.mark.parametrize("trims", [True, False], ids=["trimmed", "whole"])
def test_what_ends_at_it_or_lies_on_it_does_not_clash(roof, border, systems, trims):
    edge_beam = SECTIONS[
        {"tubes": "tube", "rolled": "rolled", "lapped": "strip"}.get(systems, "plate")
    ]
    made = build(roof, [edge_beam, *JOINED[systems]], border=border if trims else ())
    assert check_clashes(made.parts).clashes == ()


@pytest.mark.parametrize(
    "corners",
    [
        [(3882, 3611), (876, 3946), (707, 4202), (-1463, 1460), (1250, 786), (2381, 708)],
        [(-2131, 4085), (-2090, 2030), (-2121, 1550), (-2272, 959), (1574, 1225), (4202, 1985)],
    ],
)
def test_beams_met_at_a_slant_leave_the_upright_edges_that_pass_their_sides(roof, corners):
    """Of both borders an edge at a bend goes in at one side of a beam, between its edges."""
    border = np.array([(x, y, 4500.0) for x, y in corners])
    made = build(roof, [EdgeBeam(), Beams(200, 20)], border=[border])
    assert check_clashes(made.parts).clashes == ()


@pytest.mark.parametrize("beams", [Beams(200, 12), Beams(200, 12, ends="lapped")])
def test_beams_leave_the_clearance_before_it_and_little_more(roof, beams):
    made = build(roof, [EdgeBeam(clearance=2), beams]).results["beams"].parts
    touched = []
    for width in (20 + 3.98, 20 + 6):
        pieces = pieces_of(build(roof, [EdgeBeam(width=width)]))
        found = check_clashes([*pieces, *made]).clashes
        touched.append({clash.second for clash in found})
    ends = roof.connectivity.boundary_vertices[roof.connectivity.edges]
    assert touched[0] == set()
    assert len(touched[1]) >= 0.9 * min(len(made), int((ends.sum(axis=1) == 1).sum()))


@pytest.mark.parametrize("section", ["plate", "strip"])
@pytest.mark.parametrize("trims", [True, False], ids=["trimmed", "whole"])
def test_lamellas_end_the_clearance_before_it(roof, border, trims, section):
    systems = [EdgeBeam(section, width=10, clearance=2), Lamellas(80, 5)]
    made = build(roof, systems, border=border if trims else ())
    assert check_clashes(made.parts).clashes == ()
    lamellas = made.results["lamellas"].parts
    # All lines that cross others: on a whole net none along its boundary.
    assert len(lamellas) == (16 if trims else 5 + 8)
    # As high as they are, at their level.
    (height,) = {part.height or part.width for part in pieces_of(made)}
    assert height == pytest.approx(80)
    if not trims:
        # A little more, and they run into it: none ends before a crossing here.
        wider = pieces_of(build(roof, [EdgeBeam(section, width=15)]))
        touched = {clash.second for clash in check_clashes([*wider, *lamellas]).clashes}
        assert len(touched) >= 0.9 * len(lamellas)


def test_panels_at_the_border_lie_on_it(roof, border):
    systems = [Beams(200, 30), Panels(20, 8)]
    alone, carried = (
        build(roof, some, border=border) for some in (systems, [EdgeBeam(), *systems])
    )
    assert loose(carried) < loose(alone) / 2
    whole = build(roof, [EdgeBeam(), *systems]).results["panels"]
    # Half of the edge beam less half of the gap; inside it is half of a beam less that.
    on_it = roof.connectivity.boundary_vertices[roof.faces].sum(axis=1) >= 2
    for part in whole.parts:
        assert part.measures.bearing_mm <= (10 if on_it[part.face] else 15) - 4 + 1e-6
        assert part.measures.bearing_mm > 5


def loose(structure):
    """How many panels have fewer than two beams under them."""
    return sum(part.measures.bearing_mm <= 0 for part in structure.results["panels"].parts)


def test_beams_reach_it_from_all_sides(roof, border):
    """Every edge of the net that crosses the border has a beam that ends there, but for stubs."""
    with_it = build(roof, [EdgeBeam(), Beams(200, 12)], border=border)
    without = build(roof, [Beams(200, 12)], border=border)
    lengths = {part.name: part.length for part in without.results["beams"].parts}
    for part in with_it.results["beams"].parts:
        lost = lengths.pop(part.name) - part.length
        assert -1e-6 <= lost < 80
    assert all(length < 140 for length in lengths.values())


def test_a_net_without_a_border_has_no_other_beams_along_its_boundary(roof):
    structure = build(roof, [EdgeBeam(), Beams(200, 12)])
    rim = roof.connectivity.boundary_edges
    names = {part.name for part in structure.results["beams"].parts}
    assert names == {f"B{edge:04d}" for edge in np.flatnonzero(~rim)}
    assert len(pieces_of(structure)) == int(rim.sum())


def test_sections_of_the_catalogue_are_listed_as_they_are_ordered(sheet):
    (report,) = (build(sheet, [EdgeBeam(name)]) for name in ("HEB160",))
    pieces = pieces_of(report)
    area = profile("HEB160").area
    # Middle lines of the mitred frame, its sections symmetric about them.
    assert sum(part.weighed for part in pieces) == pytest.approx(area * 2 * (6000 + 5000))
    assert {part.section for part in pieces} == {"HEB160"}
    assert {part.section_height for part in pieces} == {160.0}
    assert all(part.note.startswith("HEB160; start: elevation") for part in pieces)
    (timber,) = {part.material.name for part in pieces_of(build(sheet, [SECTIONS["timber"]]))}
    assert timber == "GL24h"
    rows = report.results["edge-beam"].tables[0].rows
    assert {row[1] for row in rows} == {"HEB160"}
    # The upper side is at the level of the beams, whatever the section's height.
    assert max(part.points[:, 2].max() for part in pieces) == pytest.approx(100)


@pytest.mark.parametrize(
    ("name", "words"), [("HEB", "edge section: expected plate"), ("HEB161", "there is no HEB161")]
)
def test_unknown_sections_are_refused(name, words):
    with pytest.raises(InputError, match=words):
        EdgeBeam(name)


def test_a_strip_round_a_circle_is_bent_and_unrolls_straight(sheet):
    structure = build(sheet, [EdgeBeam("strip", width=8)], border=[ROUND])
    pieces, report = pieces_of(structure), structure.results["edge-beam"].report
    rim = structure.results["edge-beam"].geometry.length.sum()
    # As few strips of 6 m as go round, in equal shares.
    assert [part.name for part in pieces] == ["E1-001", "E1-002", "E1-003"]
    assert sum(part.length for part in pieces) == pytest.approx(rim)
    assert [part.width for part in pieces] == pytest.approx([200] * 3)
    inside = [bend.angle_deg for part in pieces for bend in part.pattern.bends]
    between = [row[4] for row in structure.results["edge-beam"].tables[0].rows]
    assert report["bends_in_strips"] == len(inside) == report["pieces"] - 3
    # All to one side, the inner one of a way that turns to the left.
    assert max(inside) < 0
    assert sum(between) - sum(inside) == pytest.approx(360)


def test_strips_are_plane_between_bends_and_unroll_without_stretch(roof, border):
    structure = build(roof, [EdgeBeam("strip", width=8)], border=border)
    geometry = structure.results["edge-beam"].geometry
    runs, rulings = geometry.strips.runs, geometry.strips.rulings
    assert sorted(np.concatenate(runs).tolist()) == list(range(len(geometry.length)))
    along = geometry.frame[:, 0]
    volume = np.linalg.det(np.stack([rulings[:, 0], rulings[:, 1], along], axis=1))
    assert np.abs(volume).max() < 1e-11
    assert np.abs(np.einsum("nek,nk->ne", rulings, along)).max() <= 0.5
    for run, part in zip(runs, pieces_of(structure), strict=True):
        assert np.array_equal(rulings[run[:-1], 1], rulings[run[1:], 0])
        assert part.pattern.label_size >= 3.0, "its name can be read"
        plate = shapely.Polygon(part.pattern.outline)
        assert plate.contains(shapely.Point(part.pattern.label)), "and is on it"
        bends = np.array([bend.points for bend in part.pattern.bends])
        if len(bends) < len(run) - 1:
            continue
        # Both ends of its bend lines, in place.
        tops = geometry.start[run[1:]]
        longs = np.linalg.norm(bends[:, 1] - bends[:, 0], axis=1)
        feet = tops - longs[:, None] * rulings[run[1:], 0]
        for flat, placed in ((bends[:, 1], tops), (bends[:, 0], feet)):
            steps = [np.linalg.norm(np.diff(points, axis=0), axis=1) for points in (flat, placed)]
            assert steps[0] == pytest.approx(steps[1], abs=1e-6)


def test_strips_are_no_longer_than_the_stock(roof, sheet):
    pieces = pieces_of(build(roof, [EdgeBeam("strip", width=8, stock=3000)]))
    assert max(part.length for part in pieces) <= 3000
    with pytest.raises(InputError, match=r"stock: 3000 mm .* take 6000 mm or more"):
        build(sheet, [EdgeBeam("strip", stock=3000)])


def test_hubs_leave_room_for_it(roof):
    structure = build(roof, [EdgeBeam(), *JOINED["hubs"]])
    rim = roof.connectivity.boundary_vertices
    stand = {part.vertices[0] for part in structure.results["nodes"].parts}
    assert stand == set(np.flatnonzero(~rim).tolist())


def test_hubs_without_room_beside_it_are_said(roof, border):
    structure = build(roof, [EdgeBeam(), *JOINED["hubs"]], border=border)
    without = build(roof, JOINED["hubs"], border=border)
    names = [{part.name for part in one.results["nodes"].parts} for one in (structure, without)]
    left_out = structure.report()["nodes"]["no_room"]
    assert left_out == sorted(names[1] - names[0])
    assert left_out
    said = [words for words in structure.report()["messages"] if "no room for a hub" in words]
    assert [f"{len(left_out)} in all" in words for words in said] == [True]
    whole = build(roof, [EdgeBeam(), *JOINED["hubs"]]).report()
    assert "no_room" not in whole["nodes"]
    assert "no_room" not in without.report()["nodes"]


def test_too_wide_for_the_border_is_refused_with_the_width_that_fits(roof):
    with pytest.raises(InputError, match=r"edge beam: 4000 mm wide .* take at most \d+ mm"):
        build(roof, [EdgeBeam("tube", width=4000, wall=50, section_height=500)])


def test_an_opening_too_small_for_it_is_said(sheet):
    structure = build(sheet, [EdgeBeam()], border=[ROUND, circle(3500, 2500, 60)])
    assert any("1 opening, too small" in words for words in structure.report()["messages"])


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"edge_section": "beam"}, "edge section"),
        ({"edge_width": -1.0}, "edge width"),
        ({"edge_section": "tube", "edge_wall": 40.0}, "take less than 30 mm"),
        ({"stock": 0.0}, "stock"),
    ],
)
def test_sizes_that_make_no_section_are_refused(values, words):
    with pytest.raises(InputError, match=words):
        systems_of("edge-beam", values)


def test_files_of_strips_list_their_bends(sheet, tmp_path):
    structure = build(sheet, [EdgeBeam("strip", width=8)], border=[ROUND])
    write(structure, tmp_path)
    with (tmp_path / "bends.csv").open(newline="") as lines:
        rows = list(csv.DictReader(lines))
    assert len(rows) == structure.results["edge-beam"].report["bends_in_strips"]
    assert {row["part"] for row in rows} == {"E1-001", "E1-002", "E1-003"}


def test_its_files_list_length_and_bends(roof, border, tmp_path):
    structure = build(roof, systems_of("edge-beam+beams", {"thickness": 12.0}), border=border)
    write(structure, tmp_path)
    with (tmp_path / "edge-beam.csv").open(newline="") as lines:
        rows = list(csv.DictReader(lines))
    pieces = pieces_of(structure)
    assert [row["name"] for row in rows] == [part.name for part in pieces]
    lengths = [float(row["length_mm"]) for row in rows]
    assert lengths == pytest.approx([part.length for part in pieces], abs=0.01)
    assert all(0 < float(row["bend_deg"]) < 60 for row in rows)
    assert (tmp_path / "flat.dxf").read_text().count("E1-001") > 0
    solids = importers.importStep(str(tmp_path / "structure.step")).solids().vals()
    assert all(solid.isValid() for solid in solids)
    volumes = sorted(solid.Volume() for solid in solids)
    assert volumes == pytest.approx(sorted(part.volume for part in structure.parts), rel=1e-9)
