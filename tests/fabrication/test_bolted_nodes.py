"""Bolted nodes: by the rules, reachable, clear of beams and panels, listed."""

import re

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.fabrication import Beams, build
from freecad_ortho.fabrication.bolt_strength import AREAS, Clamped
from freecad_ortho.fabrication.bolts import BOLTS, LENGTHS, bolt_of
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.files import write
from freecad_ortho.fabrication.limits import OK
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.step import read_step, write_step
from freecad_ortho.fabrication.systems import Nodes
from freecad_ortho.fabrication.systems.beams.end_plates import EndPlates
from freecad_ortho.fabrication.systems.nodes.hollow import BoltHole, hollow_hub
from solver.errors import InputError
from solver.mesh.quadmesh import QuadMesh, unit_rows
from tests.conftest import ROOT
from tests.fabrication.conftest import grid_faces

TUBE = {"section": "tube:100x60x5", "bolt": "M12"}


@pytest.fixture(scope="module")
def joined(roof):
    """Tubes on bolted hubs under panels."""
    return api.fabricate(roof, "beams+nodes+panels", node="bolted", **TUBE)


@pytest.fixture(scope="module")
def plane():
    x, y = np.meshgrid(900.0 * np.arange(4), 900.0 * np.arange(3), indexing="ij")
    return QuadMesh(np.stack([x, y, 0 * x], axis=-1).reshape(-1, 3), grid_faces(4, 3)[:, ::-1])


@pytest.mark.parametrize("bolt", BOLTS.values(), ids=lambda bolt: bolt.name)
def test_sizes_are_those_of_the_rules(bolt):
    clearance = 1 if bolt.diameter <= 14 else 2 if bolt.diameter <= 24 else 3
    assert bolt.hole == bolt.diameter + clearance
    assert bolt.edge == pytest.approx(1.2 * bolt.hole)
    assert bolt.spacing >= 2.2 * bolt.hole
    assert bolt.wrench >= 1.05 * bolt.flats
    assert bolt.corners > bolt.flats > 1.4 * bolt.diameter
    sizes = EndPlates(bolt, 2, 100.0, 1.0)
    assert sizes.length in LENGTHS
    assert bolt.diameter <= sizes.thread <= sizes.thickness
    assert sizes.wall >= bolt.diameter


def test_a_hub_has_the_volume_of_its_ring_less_the_holes():
    angles = np.radians([0, 90, 180, 270])
    holes = [BoltHole(beam, height, 18.0) for beam in range(4) for height in (-25.0, 25.0)]
    body = hollow_hub(angles, 55.0, 20.0, (-60.0, 50.0), holes)
    ring = (110.0**2 - 70.0**2) * 110.0
    assert body.volume == pytest.approx(ring - 8 * np.pi * 9.0**2 * 20.0, rel=1e-12)
    solid = body.solid()
    assert solid.isValid()
    assert solid.Volume() == pytest.approx(body.volume, rel=1e-9)
    assert sum(piece.volume for piece in body.filling()) == pytest.approx(ring, rel=1e-12)


@pytest.mark.parametrize("name", ["roof", "skewed", "dodecahedron"])
@pytest.mark.parametrize(
    "values",
    [{}, TUBE, {"section": "HEB120"}, {"section": "chs:88.9x5", "bolts": 1, "bolt": "M20"}],
    ids=["plates", "tubes", "HEB", "round"],
)
def test_nothing_clashes_with_default_sizes(meshes, name, values):
    made = api.fabricate(meshes[name], "beams+nodes+panels", node="bolted", **values)
    found = check_clashes(made.parts)
    assert found.near > len(made.parts)
    assert (found.clashes, found.open) == ((), ())
    assert not any(part.assembly for part in made.results["nodes"].parts)


def test_solids_are_valid_with_the_volume_of_the_formula(joined, tmp_path):
    parts = joined.results["nodes"].parts[::9]
    write_step(tmp_path / "nodes.step", parts)
    for (name, shape), part in zip(read_step(tmp_path / "nodes.step"), parts, strict=True):
        assert name == part.name
        assert shape.isValid()
        assert shape.Volume() == pytest.approx(part.volume, rel=1e-9)


def test_every_beam_ends_on_the_plate_that_stands_before_its_hub(joined, roof):
    beams = {part.name: part for part in joined.results["beams"].parts}
    made = {part.name: part for part in joined.results["nodes"].parts}
    plates = [part for part in made.values() if part.kind == "end-plate"]
    assert len(plates) == 2 * len(beams)
    for plate in plates[::7]:
        name, _, end = plate.name.partition("-")
        vertex = beams[name].vertices[("start", "end").index(end)]
        assert plate.vertices == (vertex,)
        # z of a plate runs from the beam to the hub.
        beam = (beams[name].points - plate.origin) @ plate.frame.T
        assert beam[:, 2].max() == pytest.approx(0, abs=1e-6)
        hub = made[f"N{vertex:04d}"]
        corners = (hub.points - plate.origin) @ plate.frame.T
        assert corners[:, 2].min() == pytest.approx(plate.thickness + 1, abs=1e-6)
        # Behind each hole of the plate is one of the hub.
        holes = (hub.origin + np.array([d.centre for d in hub.body.drills]) @ hub.frame) - (
            plate.origin
        )
        there = (holes @ plate.frame.T)[:, :2]
        for hole in plate.pattern.holes:
            assert np.linalg.norm(there - hole.centre, axis=1).min() < 1e-6


def test_holes_keep_the_distances_of_the_rules(joined):
    bolt = bolt_of(TUBE["bolt"])
    for part in joined.results["nodes"].parts:
        if part.kind == "end-plate":
            places = np.array([hole.centre for hole in part.pattern.holes])
            margin = np.minimum(places, part.pattern.size - places).min()
            apart = np.linalg.norm(places[0] - places[1])
            assert margin >= bolt.edge - 1e-9
            assert apart >= bolt.spacing - 1e-9
            assert {hole.diameter for hole in part.pattern.holes} == {bolt.drill}
        else:
            heights = np.array([drill.centre[2] for drill in part.body.drills])
            low, high = part.body.points[:, 2].min(), part.body.points[:, 2].max()
            assert min(heights.min() - low, high - heights.max()) >= bolt.edge - 1e-9
            assert high - low == pytest.approx(part.length)


def test_equal_nodes_are_one_type_and_bolts_are_counted(plane, tmp_path):
    made = build(plane, [Beams(100, 10, ends="end-plate"), Nodes("bolted")])
    report = made.report()["nodes"]
    assert report["end_plates"] == 2 * len(made.results["beams"].parts)
    assert report["bolts"] == 2 * report["end_plates"]
    # Corners, sides and the middle; a corner turned about its axis is the same.
    assert report["different"] == 3
    write(made, tmp_path)
    bolts = (tmp_path / "bolts.csv").read_text().splitlines()
    assert bolts[1].startswith(f"M16,45.0,EN ISO 4017,8.8,{report['bolts']},")
    types = (tmp_path / "node-types.csv").read_text().splitlines()[1:]
    assert [int(row.split(",")[1]) for row in types] == [6, 4, 2]
    assert types[2].split(",")[6] == "90.00 90.00 90.00 90.00"


def test_the_list_of_holes_is_what_the_hubs_are_drilled_by(roof):
    made = build(roof, [Beams(200, 20, ends="end-plate"), Nodes("bolted")]).results["nodes"]
    table = next(table for table in made.tables if table.name == "hub-holes.csv")
    rows = [dict(zip(table.columns, row, strict=True)) for row in table.rows]
    plates = {part.name: part for part in made.parts if part.kind == "end-plate"}
    # Drilled for threads, which a drawing alone does not show.
    assert {part.note for part in plates.values()} == {"2 threads M16 through, drilled 14 mm"}
    assert {hole.diameter for part in plates.values() for hole in part.pattern.holes} == {14.0}
    for hub in (part for part in made.parts if part.kind == "node"):
        own = [row for row in rows if row["hub"] == hub.name]
        assert len(own) == len(hub.body.drills)
        low = hub.body.points[:, 2].min()
        for row, drill in zip(own, hub.body.drills, strict=True):
            turn = np.radians(float(row["azimuth_deg"]))
            way = np.array([np.cos(turn), np.sin(turn), 0.0])
            face = (float(row["face_mm"]) - hub.thickness / 2) * way
            height = np.array([0.0, 0.0, low + float(row["from_lower_mm"])])
            assert drill.centre == pytest.approx(face + height, abs=2e-3)
            assert float(row["hole_mm"]) == drill.diameter == 18
            # The plate is the one that stands before it.
            plate = plates[row["plate"]]
            middle = plate.points.mean(axis=0) - hub.origin
            assert unit_rows((middle - middle @ hub.frame[2] * hub.frame[2])[None])[0] @ (
                way @ hub.frame
            ) == pytest.approx(1, abs=1e-3)


def test_sharper_angles_get_larger_hubs():
    """Six rhombi around a vertex, in a plane."""
    turn = np.radians(60 * np.arange(6))
    ring = 1000 * np.column_stack([np.cos(turn), np.sin(turn), 0 * turn])
    outer = ring + np.roll(ring, -1, axis=0)
    faces = [(0, 1 + k, 7 + k, 1 + (k + 1) % 6) for k in range(6)]
    mesh = QuadMesh(np.concatenate([np.zeros((1, 3)), ring, outer]), np.array(faces))
    made = api.fabricate(mesh, "beams+nodes+panels", node="bolted", **TUBE)
    widths = {part.vertices[0]: part.width for part in made.results["nodes"].parts[:13]}
    # Tubes 60 mm wide at 60 degrees stand on faces 30 / tan(30) = 52.0 mm from the axis.
    assert widths[0] == 105
    # A bolt M12x35 passes the head of the one across in 76.6 mm between the outer faces.
    assert widths[1] == 80
    assert check_clashes(made.parts).clashes == ()


def test_the_hub_diameter_that_is_named_is_the_least_that_takes_the_beams(dodecahedron):
    def made(diameter):
        return api.fabricate(
            dodecahedron, "beams+nodes", node="bolted", hub_diameter=diameter, hub_wall=8,
            section="tube:100x100x5",
        )  # fmt: skip

    with pytest.raises(InputError, match="hub: at N") as caught:
        made(80.0)
    named = float(re.search(r"or (\d+) mm hub diameter", str(caught.value))[1])
    assert made(named).report()["nodes"]
    with pytest.raises(InputError, match="hub: at N"):
        made(named - 5.0)


def test_bolts_that_cannot_be_reached_are_said_in_the_verdict(dodecahedron):
    made = api.fabricate(dodecahedron, "beams+nodes", node="bolted", hub_diameter=105.0)
    verdicts = dict(zip((part.name for part in made.parts), made.verdicts, strict=True))
    failed = {name: words for name, words in verdicts.items() if words != OK}
    assert failed
    assert len(failed) == made.report()["nodes"]["not_put_on"]
    words = " ".join(failed.values())
    assert "the bolt of beam B" in words
    assert "cannot be put in" in words
    [message] = [line for line in made.report()["messages"] if line.startswith("nodes:")]
    assert "leave the hub diameter out" in message


@pytest.mark.parametrize(
    "values, words",
    [
        ({"hub_diameter": 80, "hub_wall": 8, "section": "tube:100x100x5"}, "hub: at N.* degrees"),
        (
            {"height": 60},
            r"has .* mm of height for bolts, one of M16 takes 43.2 mm; take bolts of M12",
        ),
        ({"bolts": 3}, "bolts: expected a whole number, 1 to 2, got 3"),
        ({"bolt": "M17"}, "bolt: expected M12, .* or M30, got 'M17'"),
        ({"hub_wall": 80.5, "hub_diameter": 300}, "hub wall: of M16x100 a wall of 80.5 mm"),
        ({"clearance": 200.0}, "clearance: M16 do not reach over 200 mm .* take 111 mm at most"),
        ({"hub_diameter": 50}, "hub diameter: 50 mm leave no room for a bolt M16"),
        ({"ends": "mitred"}, "nodes: the beams are mitred .* set ends end-plate"),
    ],
)
def test_what_does_not_fit_is_one_line(roof, values, words):
    with pytest.raises(InputError, match=words) as caught:
        api.fabricate(roof, "beams+nodes", node="bolted", **values)
    assert "\n" not in str(caught.value)


def test_the_largest_section_that_fits_does(roof):
    with pytest.raises(InputError, match="at most") as caught:
        api.fabricate(
            roof, "beams", ends="end-plate", hub_diameter=100, section="hollow", section_width=120
        )
    width = float(str(caught.value).split("at most ")[1].split()[0])
    api.fabricate(
        roof, "beams", ends="end-plate", hub_diameter=100, section="hollow", section_width=width
    )


def test_nodes_alone_are_those_of_plates_of_their_sizes(roof):
    alone = api.fabricate(roof, "nodes", node="bolted", height=160, thickness=12)
    joined = api.fabricate(roof, "beams+nodes", node="bolted", height=160, thickness=12)
    one, other = alone.results["nodes"].parts, joined.results["nodes"].parts
    assert [part.name for part in one] == [part.name for part in other]
    assert sum(part.volume for part in one) == pytest.approx(sum(part.volume for part in other))


def test_the_table_of_the_documents_is_that_of_the_rules():
    text = (ROOT / "docs" / "fabrication.md").read_text(encoding="utf-8")
    rows = [line for line in text.splitlines() if line.startswith("| M")]
    [said] = [line for line in text.splitlines() if line.startswith("| shims up to, mm |")]
    shims = said.strip("| ").split(" | ")[1:]
    split = [row.strip("| ").split(" | ") for row in rows]
    written = {name: cells for name, *cells in split if len(cells) == 7}
    strength = {name: cells for name, *cells in split if len(cells) == 3}
    assert list(written) == list(strength) == list(BOLTS)
    for name, bolt in BOLTS.items():
        sizes = EndPlates(bolt, 2, 60.0, 1.0)
        # With all shims a thread is left that is as deep as the bolt is thick.
        assert sizes.length - sizes.wall - bolt.washer - sizes.shims == bolt.diameter
        assert shims[list(BOLTS).index(name)] == f"{sizes.shims:g}"
        tension, shear, _ = Clamped(bolt, 1, 99.0, 99.0, 99.0, None, MATERIALS["steel"]).row()
        assert [float(cell) for cell in strength[name]] == [AREAS[bolt.diameter], tension, shear]
        numbers = (
            *(bolt.hole, bolt.edge, bolt.spacing, bolt.wrench, bolt.drill),
            *(bolt.threaded_plate, bolt.clamped_plate),
        )
        assert [float(cell) for cell in written[name]] == pytest.approx(numbers, abs=0.051)
