"""Nets that overhang the border of their surface: what is cut there, and what is left out."""

import numpy as np
import pytest
import shapely

from freecad_ortho.fabrication import Beams, Panels, build, material
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.plate_bodies import triangles_in
from freecad_ortho.fabrication.plate_limits import LIMITS, can_be_cut
from freecad_ortho.fabrication.site import Selection, Site
from freecad_ortho.fabrication.systems import systems_of
from freecad_ortho.fabrication.systems.panels.blunt import blunted, cut_off
from freecad_ortho.fabrication.systems.panels.trimmed import piece_of
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.fabrication.conftest import grid_faces
from tests.own_system import Tags

# Of the net that is a plane sheet.
EDGE, COLUMNS = 1000.0, 8


def flat(points):
    """A closed polyline in the plane of the sheet."""
    return np.column_stack([np.asarray(points, dtype=float), np.zeros(len(points))])


def circle(x, y, radius, count=120):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False)
    return flat(np.array([x, y]) + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1))


def kept(mesh, *border):
    """What is within a border, as one shape in the plane."""
    site = Site.of(mesh, Selection(), border)
    corners = mesh.vertices[mesh.faces][..., :2]
    found = [shapely.Polygon(corners[face]) for face in np.flatnonzero(site.trimming.whole)]
    for face in site.trimming.regions:
        for region in site.trimming.flat_regions(face, corners[face]):
            found.append(region.intersection(shapely.Polygon(corners[face])))
    whole = shapely.unary_union(found)
    # No place is kept twice.
    assert whole.area == pytest.approx(sum(part.area for part in found), rel=1e-9)
    return whole


SLANTED = flat([(900, 1300), (6100, 700), (6400, 6900), (1200, 7300)])
ALONG_EDGES = flat([(1000, 1000), (6000, 1000), (6000, 7000), (1000, 7000)])
THROUGH_VERTICES = flat([(3000, 1000), (6000, 4000), (3000, 7000), (1000, 5000), (1000, 3000)])
# Its tooth enters and leaves the face at x = 3000 to 4000, y = 6000 to 7000 through one side.
TOOTH = flat([(600, 600), (6400, 600), (6400, 6700), (3700, 6700), (3500, 5600), (3300, 6700)])


@pytest.mark.parametrize(
    "border",
    [
        [SLANTED],
        [SLANTED[::-1]],
        [circle(3500, 4000, 3300)],
        [circle(3500, 4000, 3300), circle(3600, 4100, 1234.5)],
        [circle(3500, 4000, 3300), circle(3450, 3520, 300)],
        [ALONG_EDGES],
        [ALONG_EDGES + 1e-4],
        [THROUGH_VERTICES],
        [TOOTH],
    ],
    ids=[
        "slanted",
        "the other way round",
        "curved",
        "an opening",
        "an opening in one face",
        "along edges",
        "nearly along edges",
        "through vertices",
        "twice through a face",
    ],
)
def test_what_is_within_the_border_is_kept_and_nothing_else(sheet, border):
    outer, *openings = (shapely.Polygon(line[:, :2]) for line in border)
    wanted = outer.difference(shapely.unary_union(openings))
    assert kept(sheet, *border).symmetric_difference(wanted).area <= 1e-5 * wanted.area


def test_where_the_net_ends_before_the_border_it_stays_as_it_is(sheet):
    beyond = shapely.Polygon([(-500, 1500), (7500, 1500), (7500, 6500), (-500, 6500)])
    border = flat(np.array(beyond.exterior.coords)[:-1])
    wanted = beyond.intersection(shapely.box(0, 0, 7000, 8000))
    assert kept(sheet, border).symmetric_difference(wanted).area <= 1e-6 * wanted.area
    messages = build(sheet, [Panels(12, 8)], border=[border]).report()["messages"]
    assert any("the net ends before it along 1" in words for words in messages)


def test_a_border_along_the_end_of_the_net_leaves_all_of_it(sheet):
    end = flat([(0, 0), (7000, 0), (7000, 8000), (0, 8000)])
    assert kept(sheet, end).area == pytest.approx(56e6)


@pytest.mark.parametrize("edge", ["square", "bevel"])
def test_trimmed_panels_are_whole_parts(roof, border, edge):
    structure = build(roof, [Panels(20, 15, edge=edge)], border=border)
    cut = [part for part in structure.parts if len(part.pattern.outline) != 4]
    assert 20 < len(cut) < len(structure.parts)
    for part in structure.parts:
        solid = part.solid()
        assert solid.isValid(), part.name
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)
        outline = shapely.Polygon(part.pattern.outline)
        assert outline.is_valid
        assert part.area == pytest.approx(outline.area)
        assert outline.contains(shapely.Point(part.pattern.label))
        radius = outline.boundary.distance(shapely.Point(part.pattern.label))
        assert part.pattern.label_size * len(part.name) <= 2.2 * radius
        for mark in part.pattern.marks:
            assert outline.buffer(1e-6).covers(shapely.MultiPoint(mark.points))
        if edge == "square":
            assert part.volume == pytest.approx(part.area * 20)
    assert check_clashes(structure.parts).clashes == ()


def test_round_tubes_end_at_the_border_and_only_their_nodes_have_a_misfit(roof, border):
    beams = [Beams(200, 5, section="chs:88.9x5")]
    whole, structure = build(roof, beams), build(roof, beams, border=border)
    assert structure.report()["beams"]["trimmed"] > 20
    assert check_clashes(structure.parts).clashes == ()
    for part in structure.parts[::5]:
        assert part.solid().isValid()
        assert part.solid().Volume() == pytest.approx(part.volume, rel=1e-8)
    most = whole.report()["beams"]["misfit_max_mm"]
    assert 0 < structure.report()["beams"]["misfit_max_mm"] <= most


def test_trimmed_panels_reach_the_border(roof, border):
    """Between panels the border is at most half of the gap away from a side."""
    structure = build(roof, [Panels(1, 2, "above")], border=border)
    rings = [part.points[: len(part.pattern.outline)] for part in structure.parts]
    start = np.concatenate(rings)
    steps = np.concatenate([np.roll(ring, -1, axis=0) - ring for ring in rings])
    for point in np.concatenate(border):
        arms = point - start
        share = np.clip((arms * steps).sum(axis=1) / (steps**2).sum(axis=1), 0, 1)
        assert np.linalg.norm(arms - share[:, None] * steps, axis=1).min() <= 1.5


def test_neighbours_of_what_is_outside_are_not_named(roof, border):
    structure = build(roof, [Panels(20, 15)], border=border)
    names = {part.name for part in structure.parts}
    told = {mark.text for part in structure.parts for mark in part.pattern.marks if mark.text}
    assert told <= names
    assert len(names) < len(roof.faces)


def test_pieces_of_one_face_have_names_of_their_own(sheet):
    structure = build(sheet, [Panels(12, 8)], border=[TOOTH])
    face = 6 * (COLUMNS - 1) + 3
    pieces = [part for part in structure.parts if part.face == face]
    assert [part.name for part in pieces] == [f"P{face:04d}", f"P{face:04d}b"]
    assert pieces[0].width >= pieces[1].width


def test_an_opening_in_one_face_is_cut_out_of_its_panel(sheet):
    border = [circle(3500, 4000, 3300), circle(3450, 3520, 300)]
    structure = build(sheet, [Panels(12, 8)], border=border)
    part = next(part for part in structure.parts if part.face == 3 * (COLUMNS - 1) + 3)
    assert len(part.pattern.cutouts) == 1
    area = 992.0**2 - np.pi * 300**2
    assert part.area == pytest.approx(area, rel=1e-3)
    assert part.solid().isValid()
    assert part.solid().Volume() == pytest.approx(part.volume, rel=1e-9)
    assert part.volume == pytest.approx(12 * part.area)
    assert check_clashes(structure.parts).clashes == ()


def barrel(upwards):
    """A net of squares of 1 m on a cylinder, and a border just beyond two of its lines."""
    sign, radius = (1 if upwards else -1), 20 * EDGE

    def points(angle, y):
        z = sign * radius * (np.cos(angle) - 1)
        return np.stack([radius * np.sin(angle), y, z], axis=-1)

    angle, y = np.meshgrid(0.05 * np.arange(7), EDGE * np.arange(6.0))
    corners = np.array([(0.08, 700), (0.254, 700), (0.254, 4060), (0.08, 4060)])
    steps = np.linspace(0, 1, 40, endpoint=False)[:, None]
    ways = zip(corners, np.roll(corners, -1, axis=0), strict=True)
    line = np.concatenate([(1 - steps) * start + steps * end for start, end in ways])
    return QuadMesh(points(angle, y).reshape(-1, 3), grid_faces(6, 7)), points(*line.T)


@pytest.mark.parametrize("with_beams", [True, False])
@pytest.mark.parametrize("upwards", [True, False])
def test_slivers_are_part_of_neighbours_that_go_on_above_them(upwards, with_beams):
    mesh, border = barrel(upwards)
    beams = [Beams(200, 12)] if with_beams else []
    sizes = {"thickness": 20, "gap": 8, "least_width": 100}
    alone, made = (
        build(mesh, [*beams, Panels(**sizes, slivers=way)], border=[border])
        for way in ("leave-out", "join")
    )
    assert check_clashes(made.parts).clashes == ()
    before, after = (one.report()["panels"] for one in (alone, made))
    joined = after["joined"]
    assert len(before["left_out"]) == 9
    # Across a ridge the plane goes on above the sliver, across a valley it would lie below it.
    assert len(joined) == (8 if upwards else 4)
    assert set(joined) | set(after["left_out"]) == set(before["left_out"])
    assert after["joined_above_max_mm"] == pytest.approx(4.0 if upwards else 0.0, abs=0.2)
    areas = [
        {part.name: part.area for part in one.results["panels"].parts} for one in (alone, made)
    ]
    for name, larger in areas[1].items():
        assert (larger > areas[0][name] + 1) == (name in joined.values()), name
    for part in made.results["panels"].parts:
        solid = part.solid()
        assert solid.isValid()
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)
        assert shapely.Polygon(part.pattern.outline).is_valid
    said = made.report()["messages"]
    assert any("are part of their neighbours" in words for words in said)


def test_narrow_pieces_are_left_out_and_said(sheet):
    border = [ALONG_EDGES + [[0, 0, 0], [50, 0, 0], [50, 0, 0], [0, 0, 0]]]
    structure = build(sheet, [Panels(12, 8, slivers="leave-out")], border=border)
    assert len(structure.parts) == 30
    report = structure.report()
    assert report["panels"]["left_out"] == [f"P{row * 7 + 6:04d}" for row in range(1, 7)]
    assert any("narrower than 60 mm: P0013, P0020" in words for words in report["messages"])
    joined = build(sheet, [Panels(12, 8)], border=border)
    assert len(joined.parts) == 30
    assert joined.report()["panels"]["left_out"] == []
    pairs = {f"P{row * 7 + 6:04d}": f"P{row * 7 + 5:04d}" for row in range(1, 7)}
    assert joined.report()["panels"]["joined"] == pairs
    # From half a gap beside one line of the net over another to the border.
    widest = max(joined.parts, key=lambda part: part.area)
    assert widest.area == pytest.approx(992 * (1050 - 4), rel=1e-6)
    all_of_it = build(sheet, [Panels(12, 8, least_width=20)], border=border)
    assert len(all_of_it.parts) == 36
    assert all_of_it.report()["panels"]["left_out"] == []


@pytest.mark.parametrize("frame", ["none", "plate", "silicone"])
def test_a_border_that_leaves_no_panel_is_refused(sheet, frame):
    inside = [flat([(1200, 1200), (1800, 1200), (1800, 1800), (1200, 1800)])]
    with pytest.raises(InputError, match="panels: the border leaves no piece that is wide enough"):
        build(sheet, [Panels(12, 8, least_width=900, frame=frame)], border=inside)


def test_without_a_border_nothing_is_said_of_it(sheet):
    report = build(sheet, [Panels(12, 8)]).report()
    assert not {"trimmed", "left_out"} & report["panels"].keys()
    assert len(build(sheet, [Panels(12, 8)]).parts) == len(sheet.faces)


def test_systems_that_know_no_border_say_so(sheet):
    messages = build(sheet, [Tags(4, 100)], border=[SLANTED]).report()["messages"]
    assert "tags: they run on over the border, which does not cut them" in messages


@pytest.mark.parametrize("moved", [[0, 0, 5000.0], [60000.0, 0, 0]])
def test_a_border_of_something_else_is_refused(sheet, moved):
    with pytest.raises(InputError, match=r"border: it is .* mm from the net near face"):
        build(sheet, [Panels(12, 8)], border=[SLANTED + moved])


def test_ears_fill_a_polygon_with_recesses():
    angle = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    star = np.stack([np.cos(angle), np.sin(angle)], axis=1) * (1 + 0.6 * np.sin(5 * angle))[:, None]
    triangles = [shapely.Polygon(star[corners]) for corners in triangles_in(star)]
    assert len(triangles) == 38
    assert all(shapely.is_ccw(triangle.exterior) for triangle in triangles)
    assert sum(triangle.area for triangle in triangles) == pytest.approx(shapely.Polygon(star).area)


# Triangles and quads that a border leaves in the corner of a square: what is cut off of them.
POINTED = {
    "tip": ([(0, 0), (900, 0), (900, 220)], 1),
    "short side": ([(0, 0), (900, 0), (900, 500), (0, 8)], 1),
    "two tips": ([(0, 0), (900, 180), (0, 360)], 1),
    # The side at its tip is a bit bent.
    "long tip": ([(0, 0), (890, 0), (815, 10.4), (0, 123)], 1),
    "needle": ([(0, 0), (900, 0), (900, 80)], None),
    "strip": ([(0, 0), (900, 0), (900, 80), (0, 80)], None),
    "as it is": ([(0, 0), (900, 0), (900, 900), (300, 900)], 0),
}


@pytest.mark.parametrize("name", POINTED)
def test_pointed_pieces_of_glass_are_cut_to_what_can_be_made(name):
    """What is cut at a tip is square to its bisector and as long as the shortest side."""
    outline, cuts = POINTED[name]
    ring = np.array([(0.0, 0.0), (900, 0), (900, 900), (0, 900)])
    piece = piece_of([ring] * 3, shapely.Polygon(outline))
    made = blunted(piece, [ring] * 3, LIMITS["glass"])
    assert (made is None) == (cuts is None)
    if made is None:
        return
    if not cuts:
        assert made is piece
        return
    assert can_be_cut(made.outline, LIMITS["glass"])
    assert not can_be_cut(piece.outline, LIMITS["glass"])
    assert len(made.outline) == len(piece.outline) + (name not in ("short side", "long tip"))
    before, after = (shapely.Polygon(each.outline) for each in (piece, made))
    assert before.buffer(1e-6).contains(after)
    if name == "tip":
        half = np.arctan2(220, 900) / 2
        away = 1.001 * 20 / 2 / np.tan(half)
        assert cut_off(piece, made) == pytest.approx(away, rel=1e-6)
        assert before.area - after.area == pytest.approx(away**2 * np.tan(half), rel=1e-4)


@pytest.fixture(scope="module")
def pointed(sheet):
    """Glass on the sheet, cut by a slanted border that leaves tips of 21 degrees."""
    border = [flat([(900, 1300), (6100, 3300), (6400, 6900), (1200, 7300)])]
    made_of = {name: material("steel") for name in ("edge-beam", "beams")}
    made_of["panels"] = material("glass:6/16/44.2")
    sizes = {"section": "tube:160x60x5", "frame": "plate"}
    systems = systems_of("edge-beam+beams+panels", sizes, made_of)
    return build(sheet, systems, material=made_of, border=border)


def test_glass_at_a_slanted_border_passes(pointed):
    report = pointed.report()["panels"]
    assert report["blunted"] == ["P0009", "P0019"]
    assert set(pointed.verdicts) == {"ok"}
    assert check_clashes(pointed.parts).clashes == ()
    said = " ".join(pointed.report()["messages"])
    assert f"panels: {len(report['blunted'])} at the border have corners cut off" in said
    assert "close it with sheet metal" in said
    for part in pointed.results["panels"].parts:
        assert part.solid().Volume() == pytest.approx(part.volume, rel=1e-9)


def test_no_pressure_plate_is_screwed_through_a_panel_that_a_sliver_is_part_of(sheet):
    border = [ALONG_EDGES + [[0, 0, 0], [50, 0, 0], [50, 0, 0], [0, 0, 0]]]
    made = build(sheet, [Panels(12, 8, frame="plate", least_width=70)], border=border)
    joined = made.report()["panels"]["joined"]
    assert len(joined) == 6
    pairs = {(int(panel[1:]), int(sliver[1:])) for sliver, panel in joined.items()}
    sides = sheet.connectivity.edge_faces.tolist()
    within = {f"F{k:04d}-plate" for k, (one, two) in enumerate(sides) if (one, two) in pairs}
    within |= {f"F{k:04d}-plate" for k, (one, two) in enumerate(sides) if (two, one) in pairs}
    assert len(within) == 6
    plates = {part.name for part in made.parts if part.kind == "pressure-plate"}
    assert not within & plates
    # All around the panels, and between rows of them, there is one.
    rows = {row[0]: row[2] for row in made.results["panels"].tables[0].rows}
    across = [k for k, each in enumerate(sides) if {13, 20} == set(each)]
    assert rows[f"F{across[0]:04d}-plate"] in ("P0012 P0019", "P0019 P0012")


@pytest.mark.parametrize(
    ("values", "section"),
    [
        ({}, "plate"),
        ({"section": "I"}, "tube"),
        ({"section": "HEB160"}, "HEB160"),
        ({"section": "HEB160", "edge_section": "plate"}, "plate"),
        ({"section": "HEB160", "edge_width": 30.0}, "plate"),
    ],
)
def test_an_edge_beam_is_as_wide_as_the_beams_unless_told(values, section):
    assert systems_of("edge-beam+beams", values)[0].section == section
