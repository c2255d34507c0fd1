"""Support feet: level base plates, upright posts, caps below what stands on them."""

import csv

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Panels, build, write
from freecad_ortho.fabrication.bolts import bolt_of
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.material import material
from freecad_ortho.fabrication.stock import stock_list
from freecad_ortho.fabrication.systems import EdgeBeam, Feet, Nodes, systems_of
from freecad_ortho.fabrication.workshop import Workshop
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh
from tests.fabrication.conftest import grid_faces
from tests.fabrication.test_trimmed_sheets import on_grid


@pytest.fixture(scope="module")
def sheet():
    """Meridians and parallels of a wavy vault, 6 by 5 faces of about 1.3 m, upper side up."""
    along, angle = np.meshgrid(np.linspace(0, 8, 7), np.linspace(2.2, 0.9, 6), indexing="ij")
    radius = 4.2 + 0.5 * np.sin(0.7 * along)
    points = np.stack([along, radius * np.cos(angle), radius * np.sin(angle)], axis=-1)
    return QuadMesh(1000 * points.reshape(-1, 3), grid_faces(7, 6)[:, ::-1])


def feet_of(structure):
    return structure.results["feet"].parts


JOINED = {
    "alone": (),
    "beams": (Beams(200, 12), Panels(20, 15)),
    "hubs": (Beams(200, 12, ends="hub", hub_diameter=120), Nodes(diameter=120)),
    "bolted": (Beams(200, 12, ends="end-plate"), Nodes("bolted")),
    "edge beam": (EdgeBeam("HEB160"), Beams(200, 12)),
    "above": (Beams(200, 12, "above"),),
}


@pytest.mark.parametrize("places", ["corners", "boundary"])
@pytest.mark.parametrize("systems", JOINED)
def test_they_are_whole_parts_clear_of_what_they_carry(sheet, systems, places):
    structure = build(sheet, [*JOINED[systems], Feet(places)])
    parts = feet_of(structure)
    net = sheet.connectivity
    count = int((net.corners if places == "corners" else net.boundary_vertices).sum())
    assert len(parts) == 3 * count
    for part in parts:
        solid = part.solid()
        assert solid.isValid(), part.name
        assert solid.Volume() == pytest.approx(part.volume, rel=1e-9)
        if part.pattern is not None:
            assert part.volume == pytest.approx(part.area * part.thickness)
    assert check_clashes(structure.parts).clashes == ()


@pytest.mark.parametrize(
    "name, own",
    [("C24", "steel"), ("gfrp", "steel"), ("toughened-glass", "steel"), ("stainless", "stainless")],
)
def test_feet_and_bolted_nodes_are_of_metal(sheet, name, own):
    """What is welded is of steel where the structure is of wood, gfrp or glass."""
    joined = [Beams(200, 12, ends="end-plate"), Nodes("bolted"), Feet()]
    structure = build(sheet, joined, material=material(name))
    kinds = {part.kind: part.material.name for part in structure.parts}
    assert kinds["beam"] == name
    assert kinds.keys() - {"beam"} == {"node", "end-plate", "foot", "foot-plate"}
    assert {kinds[kind] for kind in kinds.keys() - {"beam"}} == {own}
    hubs = build(sheet, [Beams(200, 12, ends="hub"), Nodes()], material=material(name))
    assert {part.material.name for part in hubs.parts} == {name}


def test_posts_and_edge_beams_are_sawn_from_bars(sheet):
    """Each part without a flat pattern is on one bar of its section, long enough for its parts."""
    structure = build(sheet, [EdgeBeam("tube", 200, width=80, wall=5), Beams(200, 12), Feet()])
    stock = stock_list(structure.parts, Workshop())
    lengths = {part.name: part.length for part in structure.parts if part.pattern is None}
    sawn = [bar for bar in stock.bars if bar.kind in ("edge-beam", "foot")]
    assert sorted(name for bar in sawn for name in bar.parts) == sorted(lengths)
    assert {bar.section for bar in sawn if bar.kind == "foot"} == {"chs:88.9x5"}
    assert {bar.section for bar in sawn if bar.kind == "edge-beam"} == {"tube 200 x 80 x 5"}
    for bar in sawn:
        assert sum(lengths[name] for name in bar.parts) < bar.used <= bar.length


def test_base_plates_are_level_below_their_vertices(sheet):
    structure = build(sheet, [Feet(foot_height=700, anchor="M20")])
    bolt = bolt_of("M20")
    for base, post, cap in zip(*[iter(feet_of(structure))] * 3, strict=True):
        (vertex,) = base.vertices
        point = structure.site.mesh.vertices[vertex] + structure.site.shift
        low, high = base.points[:, 2].min(), base.points[:, 2].max()
        assert (low, high) == pytest.approx((point[2] - 700, point[2] - 685))
        # The post stands upright between both plates, its axis through their middles.
        axis = structure.site.axes.directions[vertex]
        assert cap.frame[2] == pytest.approx(axis)
        assert post.frame[0] == pytest.approx([0, 0, 1])
        assert post.origin == pytest.approx([*base.points[:, :2].mean(axis=0), high])
        under = cap.points[:4].mean(axis=0)
        assert post.origin[:2] == pytest.approx(under[:2])
        assert post.body.stations[1] == pytest.approx(under[2] - high)
        middles = np.array([hole.centre for hole in base.pattern.holes])
        size = base.pattern.size
        assert {hole.diameter for hole in base.pattern.holes} == {bolt.hole}
        assert np.minimum(middles, size - middles).min() >= bolt.edge
        away = np.linalg.norm(middles - size / 2, axis=1)
        assert away.min() >= 88.9 / 2 + bolt.wrench - 1e-9
        assert not cap.pattern.holes
        # A tick in the middle of the edge that points to y on site.
        (tick,) = base.pattern.marks
        ahead = np.diff(tick.points, axis=0)[0] @ base.frame[:2]
        assert ahead / np.linalg.norm(ahead) == pytest.approx([0, 1, 0])
        assert tick.points[:, 0] == pytest.approx(size[0] / 2)


def test_at_a_border_vertices_within_stand_on_them(sheet):
    points = sheet.vertices.reshape(7, 6, 3)
    structure = build(sheet, [Beams(200, 12), Feet("boundary")], border=[on_grid(points, 2.6, 2.1)])
    stand = {part.vertices[0] for part in feet_of(structure)}
    within = np.flatnonzero(structure.site.trimming.vertices(sheet.connectivity.edges))
    assert 4 < len(stand) < len(within)
    assert stand <= set(within.tolist())
    assert check_clashes(structure.parts).clashes == ()


def test_numbers_choose_vertices_and_lists_name_them(sheet, tmp_path):
    structure = build(sheet, systems_of("beams+feet", {"foot_at": "8, 20", "anchor": "M24"}))
    write(structure, tmp_path)
    with (tmp_path / "anchors.csv").open(newline="") as lines:
        rows = list(csv.DictReader(lines))
    assert [(row["foot"], row["anchor"], row["count"]) for row in rows] == [
        ("FT0008", "M24", "4"),
        ("FT0020", "M24", "4"),
    ]
    assert structure.report()["feet"]["anchors"] == 8
    with (tmp_path / "parts.csv").open(newline="") as lines:
        names = {row["name"] for row in csv.DictReader(lines)}
    assert {"FT0008", "FT0008-base", "FT0008-cap"} <= names


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"places": "roof"}, "foot at: expected corners, boundary or numbers"),
        ({"places": "99"}, "numbers of vertices from 0 to 41, got '99'"),
        ({"foot_height": 120.0}, r"foot height: 120 mm leave .* take at least \d+ mm"),
        ({"wall": 50.0}, "post wall: 50 mm fills"),
        ({"anchor": "M17"}, "M17"),
    ],
)
def test_what_cannot_be_built_is_refused(sheet, settings, words):
    with pytest.raises(InputError, match=words):
        build(sheet, [Feet(**settings)])


def test_axes_that_lie_flat_are_refused(sheet):
    upright = sheet.with_vertices(sheet.vertices[:, [2, 0, 1]])
    with pytest.raises(InputError, match="lies too flat for a foot"):
        build(upright, [Feet("20")])


def test_a_net_that_faces_down_stands_on_its_upper_side(sheet):
    turned = type(sheet)(sheet.vertices, sheet.faces[:, ::-1])
    structure = build(turned, [Beams(200, 12, "above"), Feet()])
    assert check_clashes(structure.parts).clashes == ()
    for base, _, cap in zip(*[iter(feet_of(structure))] * 3, strict=True):
        assert cap.points[:, 2].min() > base.points[:, 2].max()
