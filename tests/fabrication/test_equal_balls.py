"""Balls that may be turned in many ways are told apart at once, by the same rule as all parts."""

import numpy as np
import pytest

from freecad_ortho.fabrication import equal
from freecad_ortho.fabrication.ball_body import Ball
from freecad_ortho.fabrication.equal import TOLERANCE_MM, equal_groups
from freecad_ortho.fabrication.material import MATERIALS
from freecad_ortho.fabrication.part import Part
from solver.mesh.quadmesh import unit_rows


def ball(ways):
    body = Ball(40.0, ways, 35.0, 14.0, 20.0)
    return Part(
        *("N0000", "node", body, np.zeros(3), np.eye(3), None, 80.0, 80.0, 80.0, 0.0),
        *(body.volume, MATERIALS["steel"]),
    )


@pytest.fixture
def balls():
    """Of two kinds, turned about z, their four holes off by nothing to 2 mm."""
    random = np.random.default_rng(3)
    quarters = np.radians([0.0, 90.0, 180.0, 270.0])
    made = []
    for number in range(60):
        turns = quarters * [1.0, 1.0 - 0.02 * (number % 2), 1.0, 1.0] + random.uniform(0, 6)
        ways = np.column_stack([np.cos(turns), np.sin(turns), np.full(4, -0.1)])
        made.append(ball(unit_rows(ways + random.normal(size=(4, 3)) * 0.01 * (number % 3))))
    return made


def test_what_is_ruled_out_at_once_lies_on_nothing(balls, monkeypatch):
    groups = equal_groups(balls)
    assert 10 < len(groups) < 50
    monkeypatch.setattr(equal._Form, "_may_lie_on", lambda form, other: True)
    assert equal_groups(balls) == groups


def test_few_are_laid_on_each_other_to_tell_them_apart(balls, monkeypatch):
    tried, groups = [], equal_groups(balls)
    lies_on = equal._Form._lies_on
    monkeypatch.setattr(
        equal._Form,
        "_lies_on",
        lambda form, other, turn: tried.append(form) or lies_on(form, other, turn),
    )
    assert equal_groups(balls) == groups
    assert len(tried) < 100 * len(balls)


def test_a_ball_whose_corners_move_by_less_than_the_tolerance_stays_equal(balls):
    one = balls[0]
    angle = 0.5 * TOLERANCE_MM / 40.0
    for sign in (1, -1):
        moved = one.body.ways @ equal._about_z(2.0)
        moved[0] = moved[0] @ equal._about_z(sign * angle)
        assert len(equal_groups([one, ball(moved)])) == 1
