"""Whether slotted parts can be pushed onto what stands, in one direction."""

import math

import numpy as np
import pytest

from freecad_ortho.fabrication import Beams, Lamellas, build
from freecad_ortho.fabrication.assembly import SlotWay, conflict, conflicts, insertion, lean
from freecad_ortho.fabrication.material import MATERIALS
from tests.conftest import surface_of_revolution
from tests.fabrication.test_lamellas import flat_grid


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


def test_rigid_beams_around_a_barrel_are_named_with_the_slots_that_conflict():
    mesh = surface_of_revolution(17, 15).scaled(1000.0)
    structure = build(mesh, [Beams(120, 10, ends="lapped", clearance=1.0)])
    failing = [part for part in structure.parts if part.assembly]
    assert failing and len({part.family for part in failing}) == 1
    names = {part.name for part in structure.parts}
    verdicts = dict(zip((part.name for part in structure.parts), structure.verdicts, strict=True))
    for part in failing:
        assert "diverge by" in verdicts[part.name]
        one, other = (word for word in part.assembly.split() if word in names)
        assert one != other
    assert structure.report()["beams"]["not_put_on"] == len(failing)
    assert any("cannot be pushed on" in words for words in structure.report()["messages"])
