"""Errors of cutting and drilling: how they add up along a chain, and what a net makes of them."""

import json
import os
from dataclasses import replace

import numpy as np
import pytest

from freecad_ortho import api
from freecad_ortho.cli.commands import run
from freecad_ortho.fabrication.tolerances import BeamRows, Tolerances, bolted, held_nodes
from solver.errors import InputError

SETTINGS = Tolerances(trials=4000, seed=7)
LENGTH = 1000.0


def chain(count, ends=()):
    """Beams in a row from node 0, upright, and further ones."""
    pairs = np.array([(k, k + 1) for k in range(count)] + list(ends))
    frame = np.tile(np.eye(3), (len(pairs), 1, 1))
    return BeamRows(pairs, np.full(len(pairs), LENGTH), frame)


def held(count, *nodes):
    found = np.zeros(count, dtype=bool)
    found[list(nodes)] = True
    return found


@pytest.mark.parametrize("count", [1, 4, 16])
def test_errors_of_a_chain_add_up_as_their_squares(count):
    """Of one beam: 4 errors along, 2 up and a turn by 2, a turn by 2 across, t2 / 3 each."""
    landed = bolted(chain(count), held(count + 1, 0), SETTINGS)
    squares = 4 + 2 + 2 * (LENGTH / 120) ** 2 + 2 * (LENGTH / 100) ** 2
    expected = np.sqrt(count * squares * 0.5**2 / 3)
    got = np.sqrt((landed.off[:, count] ** 2).mean())
    assert got == pytest.approx(expected, rel=0.05)
    assert landed.rings.tolist() == list(range(count + 1))
    # Nothing closes, so no hole misses.
    assert np.abs(landed.missed).max() <= 1e-9


def test_a_node_between_two_beams_lands_half_way_and_both_miss_by_the_rest():
    beams = chain(1, ends=[(1, 2)])
    landed = bolted(beams, held(3, 0, 2), SETTINGS)
    alone = bolted(chain(1), held(2, 0), SETTINGS)
    ratio = np.sqrt((landed.off[:, 1] ** 2).mean() / (alone.off[:, 1] ** 2).mean())
    assert ratio == pytest.approx(1 / np.sqrt(2), rel=0.05)
    # Of what the ends miss upwards, holes miss the less the longer beams are.
    assert landed.missed[:, 0] == pytest.approx(landed.missed[:, 1])
    along = np.sqrt((landed.missed[:, 0] ** 2).mean())
    both = 2 * (4 + (2 + 2 * (LENGTH / 120) ** 2) * (120 / LENGTH) ** 2) * 0.5**2 / 3
    assert along == pytest.approx(np.sqrt(both) / 2, rel=0.05)


def test_everything_is_proportional_to_the_tolerance(roof):
    beams, where = BeamRows.of(roof), held_nodes(roof, None)
    few = replace(SETTINGS, trials=60)
    once = bolted(beams, where, few)
    twice = bolted(beams, where, replace(few, tolerance=1.0))
    assert twice.off == pytest.approx(2 * once.off)
    assert twice.bears == pytest.approx(once.bears)
    again = bolted(beams, where, replace(few, tolerance=once.bears)).report()
    used = again["holes_missed_95_mm"] / 1.0, again["off_95_mm"] / 10.0
    assert max(used) == pytest.approx(1.0)
    assert not np.array_equal(once.off, bolted(beams, where, replace(few, seed=8)).off)


def test_a_net_held_on_one_side_lands_further_off_than_all_around(roof):
    few = {"trials": 100, "tolerance": 0.2}
    around = api.tolerances(roof, **few).report()
    one_side = api.tolerances(roof, held=range(10), **few).report()
    assert one_side["off_95_mm"] > 1.5 * around["off_95_mm"]
    assert one_side["last_node"] == "N0060"
    assert one_side["nodes_free"] == 60
    # In another unit it is the same net.
    metres = api.tolerances(roof.scaled(0.001), unit="m", **few).report()
    assert metres["off_95_mm"] == pytest.approx(around["off_95_mm"], rel=1e-5)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"tolerance": 0.0}, "tolerance: expected a number above 0 mm"),
        ({"trials": 3}, "trials: expected a whole number, 10 to 100,000, got 3"),
        ({"held": [70]}, r"held: expected nodes from 0 to 69, got \[70\]"),
        ({"held": []}, "held: expected nodes from 0 to 69, got none"),
        ({"held": range(70)}, "held: every node is held"),
    ],
)
def test_what_cannot_be_bolted_is_refused(roof, options, words):
    with pytest.raises(InputError, match=words):
        api.tolerances(roof, **options)


def test_a_closed_net_has_to_say_what_is_held(dodecahedron):
    with pytest.raises(InputError, match="the net has no boundary"):
        api.tolerances(dodecahedron)


def failing(*_):
    raise OSError("the disk is full")


def test_the_command_says_it_in_a_line_and_in_a_file(roof, tmp_path, capsys, monkeypatch):
    net, numbers = tmp_path / "net.obj", tmp_path / "tolerances.json"
    api.write_mesh(net, roof)
    told = ["--tolerance", "0.3", "--trials", "50", "--held", "0,9,60,69"]
    assert run(["tolerances", str(net), "--unit", "mm", *told, "-o", str(numbers)]) == 0
    found = json.loads(numbers.read_text(encoding="utf-8"))
    expected = api.tolerances(roof, tolerance=0.3, trials=50, held=[0, 9, 60, 69]).report()
    assert found["nodes_free"] == 66
    assert found["off_95_mm"] == pytest.approx(expected["off_95_mm"], rel=1e-4)
    line = capsys.readouterr().out
    assert f"the design bears {expected['tolerance_borne_mm']:.2f} mm" in line
    # A file is there whole or not at all: what could not be renamed leaves the old one.
    before = numbers.read_bytes()
    monkeypatch.setattr(os, "replace", failing)
    assert run(["tolerances", str(net), "--unit", "mm", *told, "-o", str(numbers)]) == 2
    assert str(numbers) in capsys.readouterr().err
    assert numbers.read_bytes() == before and sorted(tmp_path.iterdir()) == [net, numbers]
    assert run(["tolerances", str(net), "--tolerance", "0"]) == 2
    assert "tolerance: expected a number above 0 mm" in capsys.readouterr().err
