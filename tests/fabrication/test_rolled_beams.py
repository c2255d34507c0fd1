"""Beams with a section of the catalogue: prisms of its area, clear of each other, in lists."""

import csv
import math
from dataclasses import replace

import numpy as np
import pytest

from freecad_ortho.fabrication import MATERIALS, Beams, Panels, Workshop, build, write
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.profiled import ProfiledBody
from freecad_ortho.fabrication.profiles import profile
from freecad_ortho.fabrication.profiles.end import End
from freecad_ortho.fabrication.stock import stock_list
from freecad_ortho.fabrication.systems.nodes import Nodes
from solver.errors import InputError

SQUARE = (End(0.0, 0.0, 0.0, 0.0), End(1000.0, 0.0, 0.0, 0.0))
SLANTED = (End(0.0, 0.1, 0.3, -0.3), End(1000.0, -0.2, -0.2, 0.2))
MITRED = (End(0.0, 0.1, 0.3, 0.6), End(1000.0, -0.2, -0.2, -0.4))
CHAMBERS = "polygon:0,0 60,0 60,100 0,100|5,5 20,5 20,95 5,95|40,5 55,5 55,95 40,95"
NAMES = ("GL24h:80x200", "tube:100x60x5", "chs:88.9x5", "HEB160", "UPE200", "tee:IPE200", CHAMBERS)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("ends", [SQUARE, SLANTED, MITRED], ids=["square", "slanted", "mitred"])
def test_members_are_closed_and_have_the_volume_of_their_formula(name, ends):
    for section in (profile(name), profile(name).less_round()):
        body = ProfiledBody(section, *ends)
        solid = body.solid()
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(body.volume, rel=1e-9)
        low, high = body.points.min(axis=0), body.points.max(axis=0)
        assert (high - low)[1:] == pytest.approx([section.height, section.width], rel=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_cut_square_they_are_their_area_times_their_length(name):
    section = profile(name)
    body = ProfiledBody(section, *SQUARE)
    solid = body.solid()
    assert solid.Volume() == pytest.approx(1000 * section.area, rel=1e-9)
    assert body.skin == pytest.approx(1000 * section.perimeter, rel=1e-12)
    caps = [face.Area() for face in solid.Faces() if abs(face.normalAt().x) > 0.999]
    assert caps == pytest.approx([section.area] * 2, rel=1e-9)


def test_rounded_corners_are_cylinders_and_their_cuts_ellipses():
    solid = ProfiledBody(profile("chs:88.9x5"), *MITRED).solid()
    kinds = [face.geomType() for face in solid.Faces()]
    assert (kinds.count("CYLINDER"), kinds.count("PLANE")) == (8, 4)
    assert {edge.geomType() for edge in solid.Edges()} == {"LINE", "ELLIPSE"}


@pytest.mark.parametrize("name", NAMES)
def test_pieces_for_the_clash_check_contain_the_body_and_fill_it(name):
    section = profile(name)
    sharp = section.less_round()
    reaching = name != CHAMBERS and not name.startswith("chs")
    for ends in (SQUARE, SLANTED, MITRED):
        body = ProfiledBody(sharp, *ends)
        filled = sum(piece.volume for piece in body.filling())
        if reaching:
            assert filled == pytest.approx(body.volume, rel=1e-12)
        rounded = ProfiledBody(section, *ends)
        (hull,) = rounded.pieces()
        filled = sum(piece.volume for piece in rounded.filling())
        assert rounded.volume <= filled * (1 + 1e-12) <= hull.volume * (1 + 1e-9)


@pytest.fixture(scope="module")
def rolled(roof):
    """Beams of four sections, with panels on them."""
    made = {}
    for name, ends in (
        ("tube:100x60x5", "mitred"),
        ("HEB160", "hub"),
        ("chs:88.9x5", "mitred"),
        ("GL24h:80x200", "through-u"),
    ):
        beams = Beams(200, 12, section=name, ends=ends, hub_diameter=300)
        made[name] = build(roof, [beams, Panels(12, 15)])
    return made


@pytest.mark.parametrize("name", ["tube:100x60x5", "HEB160", "chs:88.9x5", "GL24h:80x200"])
def test_beams_of_one_section_do_not_clash(rolled, name):
    structure = rolled[name]
    assert check_clashes(structure.parts).clashes == ()
    section = profile(name)
    for part in structure.only("beams").parts[::17]:
        assert part.solid().isValid()
        assert part.solid().Volume() == pytest.approx(part.volume, rel=1e-9)
        assert (part.section, part.width, part.thickness) == (name, section.height, section.wall)
    deviations = {part.measures.gap_mm for part in structure.only("beams").parts}
    assert max(deviations) < 1e-6


def test_upper_sides_lie_where_the_net_has_them_and_lower_ones_are_measured(roof, rolled):
    structure = rolled["HEB160"]
    axes, edges = structure.axes, structure.site.mesh.connectivity.edges
    lower = {}
    for part in structure.only("beams").parts:
        for vertex, other in (part.vertices, part.vertices[::-1]):
            point, axis = structure.mesh.vertices[vertex], axes.offsets[vertex]
            along = part.frame[0]
            # The upper side's middle line meets the axis at the upper level.
            up = part.frame[1] * 80.0
            line = np.cross(along, part.frame[2])
            upper = ((part.origin + up - point) @ line) / (axis @ line)
            assert upper == pytest.approx(80.0, abs=1e-6), (vertex, other)
            depth = ((part.origin - up - point) @ line) / (axis @ line) * np.linalg.norm(axis)
            lower.setdefault(vertex, []).append(depth)
    spread = {vertex: max(values) - min(values) for vertex, values in lower.items()}
    report = structure.report()["beams"]
    assert len(edges) == len(structure.only("beams").parts)
    assert report["misfit_max_mm"] == pytest.approx(max(spread.values()), abs=1e-6)
    assert spread[int(report["misfit_worst"][1:])] == pytest.approx(report["misfit_max_mm"])
    for part in structure.only("beams").parts:
        most = max(spread[vertex] for vertex in part.vertices)
        assert part.measures.misfit_mm == pytest.approx(most, abs=1e-6)
    assert any("lower sides lie up to" in words for words in structure.report()["messages"])


def test_masses_are_of_the_section_as_it_is_rolled(roof):
    beams = Beams(1, 1, section="HEB160", ends="hub", hub_diameter=300)
    sharp, rounded = (
        build(roof, [replace(beams, rounded=choice)]).parts[0] for choice in (False, True)
    )
    assert sharp.volume < 0.97 * rounded.volume
    assert sharp.mass == pytest.approx(rounded.mass, rel=1e-9)
    # Cut square seen from above; its ends lean by the slopes of the axes.
    mean = rounded.volume / profile("HEB160").area
    assert rounded.mass == pytest.approx(42.6 * mean / 1000, rel=2e-3)


def test_lists_name_the_section(roof, rolled, tmp_path):
    structure = rolled["tube:100x60x5"]
    write(structure, tmp_path, workshop=Workshop(stock=6000.0))
    with (tmp_path / "parts.csv").open(encoding="utf-8") as stream:
        rows = {row["name"]: row for row in csv.DictReader(stream)}
    beam, panel = rows["B0000"], rows["P0000"]
    assert (beam["section"], panel["section"]) == ("tube:100x60x5", "")
    assert float(beam["misfit_mm"]) > 0 and panel["misfit_mm"] == ""
    assert beam["note"].startswith("tube:100x60x5; start: elevation")
    bars = stock_list(structure.only("beams").parts, Workshop(stock=6000.0)).bars
    assert {bar.section for bar in bars} == {"tube:100x60x5"}
    assert sum(bar.cut for bar in bars) == pytest.approx(
        sum(part.length for part in structure.only("beams").parts)
    )


@pytest.mark.parametrize(
    ("name", "material", "found"),
    [
        ("HEB160", "steel", "steel"),
        ("HEB160", "S235", "S235"),
        ("GL28h:80x200", "steel", "GL28h"),
        ("alu:120x50x3", "steel", "aluminium"),
        ("tube:100x60x5", "aluminium", "aluminium"),
        ("plate:12x150", "timber", "timber"),
    ],
)
def test_beams_are_made_of_what_their_section_is_made_of(roof, name, material, found):
    structure = build(roof, [Beams(1, 1, section=name)], material=MATERIALS[material])
    assert {part.material.name for part in structure.parts} == {found}


@pytest.mark.parametrize(
    ("settings", "material", "words"),
    [
        ({"section": "HEB160"}, "timber", "section: HEB160 is made of steel, S235"),
        ({"section": "GL24h:80x200"}, "S355", "GL24h:80x200 is made of GL24h, not of S355"),
        ({"section": "HEB165"}, "steel", "there is no HEB165"),
        ({"section": "HEB160", "ends": "lapped"}, "steel", "only plates can be lapped"),
        ({"section": "GL24h:900x900"}, "steel", "take at most"),
    ],
)
def test_what_does_not_fit_is_one_line(roof, settings, material, words):
    with pytest.raises(InputError) as caught:
        build(roof, [Beams(200, 12, **settings)], material=MATERIALS[material])
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_hubs_are_as_high_as_the_beams(roof):
    beams = Beams(200, 12, section="tube:100x60x5", ends="hub", hub_diameter=200)
    structure = build(roof, [beams, Nodes()])
    heights = [np.ptp(part.body.points[:, 2]) for part in structure.only("nodes").parts]
    assert heights == pytest.approx([100.0] * len(heights), abs=5)
    assert check_clashes(structure.parts).clashes == ()
    assert math.isclose(structure.report()["beams"]["height_max_mm"], 100.0)


def test_sizes_given_beside_a_section_that_has_them_are_said_not_to_count():
    assert Beams(200, 20, section="HEB160").unheeded == ()
    assert Beams(160, 8, section="HEB160").unheeded == ()
    said = Beams(300, 12, section="HEB160").unheeded
    assert said == (
        "beams: HEB160 has a height of 160 mm; the 300 mm that were given do not count",
        "beams: HEB160 has a thickness of 8 mm; the 12 mm that were given do not count",
    )
    assert replace(Beams(300, 12, section="HEB160")).unheeded == said
    assert Beams(300, 12).unheeded == ()
