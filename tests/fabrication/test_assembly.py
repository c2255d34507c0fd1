"""Whether slotted parts can be pushed onto what stands, in one direction."""

import math
from dataclasses import replace

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Lamellas, Panels, build
from freecad_ortho.fabrication.assembly import (
    SlotWay,
    conflict,
    conflicts,
    insertion,
    lean,
    turning,
)
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.systems.panels.way_in import closing
from solver import QuadMesh, optimise
from tests.conftest import shared_mesh, surface_of_revolution
from tests.fabrication.test_lamellas import flat_grid
from tests.meshes import grid


def ways(*degrees, play=1.0, depth=100.0, give=0.0):
    return [
        SlotWay(
            f"P{number}",
            np.array([math.sin(math.radians(turn)), 0.0, math.cos(math.radians(turn))]),
            depth,
            play,
            give,
        )
        for number, turn in enumerate(degrees)
    ]


def test_the_direction_is_the_middle_of_what_diverges_most():
    angle = math.degrees(math.atan2(*insertion(ways(-10, 0, 1, 2, 20))[[0, 2]]))
    assert angle == pytest.approx(5, abs=0.2)


def test_play_over_depth_and_give_say_how_far_slots_may_diverge():
    play = math.degrees(math.atan(1 / 100))
    assert conflict(ways(0, 1.9 * play)) is None
    found = conflict(ways(0, 1.0, 2.2 * play + 1.0))
    assert (found.first, found.second) == ("P0", "P2")
    assert found.diverge_deg == pytest.approx(2.2 * play + 1.0)
    assert found.allowed_deg == pytest.approx(2 * play)
    assert conflict(ways(0, 1.0, 2.2 * play + 1.0, give=math.radians(1.0))) is None
    assert conflict(ways(0)) is None


def test_opposite_slots_have_no_direction_in_common():
    found = conflict(ways(0, 180, 1))
    assert found.diverge_deg == pytest.approx(180)


def test_a_plate_leans_as_far_as_its_torsion_allows():
    steel = MATERIALS["steel"]
    shear = steel.youngs_modulus / 2.6 * 4 * lean(steel, 4.0, 500.0) / 500
    assert shear == pytest.approx(steel.bending_limit / math.sqrt(3))


def test_a_flexible_plate_goes_on_crossing_by_crossing():
    """Each slot has to suit the next one; for a rigid plate they add up."""
    play = math.degrees(math.atan(1 / 100))
    arc = ways(*np.arange(8) * 1.9 * play)
    assert conflict(arc).diverge_deg == pytest.approx(7 * 1.9 * play)
    assert conflict([replace(way, turn=0.0) for way in arc]) is None
    lifted = [replace(way, turn=math.radians(-0.2 * play)) for way in arc]
    found = conflict(lifted)
    assert int(found.second[1:]) == int(found.first[1:]) + 1
    assert found.count == 7
    assert found.allowed_deg == pytest.approx(1.8 * play)


def test_a_bent_and_twisted_strip_turns_in_its_plane():
    """Bent and twisted as a circle in both says, integrated step by step."""
    steel, thickness, length = MATERIALS["steel"], 4.0, 1000.0
    bend, twist = length / steel.least_radius(thickness), lean(steel, thickness, length)
    steps, frame = 4000, np.eye(3)
    for angle in (np.arange(steps) + 0.5) * 2 * math.pi / steps:
        # Stresses lie on von Mises' limit all the way.
        x, y = math.cos(angle) * twist / steps, math.sin(angle) * bend / steps
        frame = frame @ (np.eye(3) + np.array([[0, 0, y], [0, 0, -x], [-y, x, 0]]))
        frame = np.linalg.qr(frame)[0] @ np.diag(np.sign(np.diag(np.linalg.qr(frame)[1])))
    turned = abs(math.atan2(frame[1, 0], frame[0, 0]))
    assert turning(steel, thickness, length, 0.0) == pytest.approx(turned, rel=0.05)
    assert turning(steel, thickness, length, 30.0) < turning(steel, thickness, length, 0.0)


def test_thin_lamellas_on_arcs_pass_where_thick_ones_do_not():
    """Slots of rings of 93 degrees; the verdicts say which can be put on."""
    mesh = surface_of_revolution(17, 15).scaled(1000.0)
    failed = {}
    for thickness in (4, 20):
        structure = build(mesh, [Lamellas(width=40, thickness=thickness)])
        words = [word for word in structure.verdicts if "diverge by" in word]
        assert structure.report()["lamellas"]["not_put_on"] == len(words)
        failed[thickness] = len(words)
    assert failed[4] < 3 <= 10 < failed[20]


def test_the_family_with_fewer_conflicts_is_put_on_last():
    slots = {"A": ways(0, 30), "B": ways(0, 40), "C": ways(0, 0), "D": ways(0, 50)}
    families = {"A": "u", "B": "u", "C": "v", "D": "v"}
    assert set(conflicts(slots, families)) == {"D"}
    assert set(conflicts(slots, dict.fromkeys(slots, ""))) == {"A", "B", "D"}


def test_level_grids_go_together():
    for system in (Lamellas(80, 6), Beams(100, 10, ends="lapped")):
        structure = build(flat_grid(), [system])
        assert not any(part.assembly for part in structure.parts)
        assert structure.report()[system.name]["not_put_on"] == 0


def give_and_play(mesh, beam, other):
    """Of a slot of 1 mm play, 60 mm deep: what the other, 10 mm thick, yields beside it."""
    (vertex,) = set(beam.vertices) & set(other.vertices)
    edges = mesh.connectivity.edges
    there = (edges == vertex).any(axis=1) & np.isin(edges, other.vertices).all(axis=1)
    length = float(mesh.edge_lengths[there].min())
    return math.atan2(1, 60) + lean(MATERIALS["steel"], 10.0, length)


def test_rigid_beams_around_a_barrel_are_named_with_the_slots_that_conflict():
    mesh = surface_of_revolution(17, 15).scaled(1000.0)
    structure = build(mesh, [Beams(120, 10, ends="lapped", clearance=1.0)])
    failing = [part for part in structure.parts if part.assembly]
    assert failing and len({part.family for part in failing}) == 1
    by_name = {part.name: part for part in structure.parts}
    names = set(by_name)
    verdicts = dict(zip((part.name for part in structure.parts), structure.verdicts, strict=True))
    for part in failing:
        assert "diverge by" in verdicts[part.name]
        one, other = (word for word in part.assembly.split() if word in names)
        assert one != other
        allowed = sum(give_and_play(mesh, part, by_name[name]) for name in (one, other))
        said = float(part.assembly.rpartition("play and give allow ")[2])
        assert said == pytest.approx(math.degrees(allowed), abs=0.06)
    assert structure.report()["beams"]["not_put_on"] == len(failing)
    assert any("cannot be pushed on" in words for words in structure.report()["messages"])


def test_plates_of_the_heart_cannot_go_onto_slots_that_diverge_by_172_degrees():
    """Rigid plates with 1 mm of play, around the whole of a closed form."""
    net = optimise(shared_mesh("heart"), "principal").mesh
    structure = build(
        net.scaled(1000.0 / net.mean_edge), [Beams(120, 10, ends="lapped", clearance=1.0)]
    )
    failing = [part for part in structure.parts if part.assembly]
    assert {part.family for part in failing} == {"v"} and len(failing) == 21
    words = structure.report()["verdict"]["failed"]["B-V000"]
    assert "slots for B-U010 and B-U020 diverge by 171.9 degrees" in words


def leaning(*degrees):
    """Inward normals of the sides of a panel in the plane z = 0, which lean in by these angles."""
    around = np.radians([0.0, 90.0, 180.0, 270.0])
    lean = np.radians(degrees)
    flat = np.stack([-np.cos(around), -np.sin(around)], axis=1) * np.cos(lean)[:, None]
    return np.column_stack([flat, -np.sin(lean)])[None]


@pytest.mark.parametrize(
    ("degrees", "closes"),
    [
        ((10, 10, 10, 10), 40 * math.sin(math.radians(10))),
        ((-10, -10, -10, -10), 0.0),
        # One side that leans in alone: the panel goes in aslant, along it.
        ((10, 0, -10, 0), 0.0),
        ((10, 0, 0, 0), 40 * math.sin(math.radians(5)) / math.cos(math.radians(5))),
    ],
)
def test_bevelled_sides_close_in_on_the_way_that_is_best(degrees, closes):
    up, beside = np.array([[0.0, 0.0, 1.0]]), np.ones((1, 4), dtype=bool)
    found = closing(up, leaning(*degrees), beside, thickness=40.0, gap=0.0)
    assert found == pytest.approx(closes, abs=1e-9)


@pytest.mark.parametrize("hollow", [True, False])
def test_thick_bevelled_panels_of_a_bowl_cannot_be_put_in_last(hollow):
    """A part of a sphere of 3 m, seen from inside or from outside; beams are behind the panels."""
    polar, turn = np.meshgrid(np.linspace(1.0, 2.2, 5), np.linspace(0, 1.2, 5), indexing="ij")
    x, y = np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn)
    mesh = grid(3000 * x, 3000 * y, 3000 * np.cos(polar))
    if hollow:
        mesh = QuadMesh(mesh.vertices, mesh.faces[:, ::-1])
    for gap, stuck in ((8.0, hollow), (20.0, False)):
        made = build(mesh, [Beams(100, 30), Panels(80, gap, edge="bevel")])
        names = {part.name for part in made.parts if part.assembly}
        assert len(names) == made.report()["panels"]["not_put_on"]
        assert all("close in by" in made.report()["verdict"]["failed"][name] for name in names)
        # Panels at the border go in aslant; beside the middle all four sides lean in.
        assert {"P0005", "P0006", "P0009", "P0010"} <= names if stuck else not names
