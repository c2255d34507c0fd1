"""Patterns as near to straight as strips that lean little can be."""

import numpy as np
import pytest

from solver.mesh.quadmesh import unit_rows
from solver.unroll.corner import Corners
from solver.unroll.measures import straightness
from solver.unroll.nearest_turns import nearest_turns
from solver.unroll.strip import angle_between
from solver.unroll.twisted import twisted_strip

LEAN = np.radians(8.0)


def wall(kink):
    """A level arch with upright directions, its last edge rising out of its plane."""
    s = np.linspace(0.0, 10.0, 11)
    points = np.stack([s, 0.1 * s * (10 - s), 0.0 * s], axis=1)
    points[-1, 2] += np.tan(kink) * np.linalg.norm(points[-1] - points[-2])
    return points, np.tile([0.0, 0.0, 1.0], (len(s), 1))


@pytest.mark.parametrize("kink_deg", [0.5, 3.0])
def test_a_kink_is_evened_out_within_the_lean(kink_deg):
    points, upright = wall(np.radians(kink_deg))
    wanted = np.zeros(len(points) - 2)
    turns = nearest_turns(points, upright, wanted, LEAN)
    free = twisted_strip(points, upright)
    best = twisted_strip(points, upright, turns)
    assert np.abs(best.turns[1:-1] - turns).max() <= 1e-12
    assert straightness(best.flat_points) <= 0.5 * straightness(free.flat_points)
    away = angle_between(best.rulings[1:-1], free.rulings[1:-1])
    assert away.max() <= 1.02 * LEAN


def test_turns_within_reach_stay_as_they_are():
    points, upright = wall(0.0)
    along = unit_rows(np.diff(points, axis=0))
    reach = Corners(along[:-1], along[1:], upright[1:-1]).half_turn.min() * np.sin(LEAN)
    wanted = reach * np.cos(np.arange(len(points) - 2))
    assert (nearest_turns(points, upright, wanted, LEAN) == wanted).all()


def test_turns_are_the_same_in_any_unit():
    points, upright = wall(np.radians(3.0))
    wanted = np.zeros(len(points) - 2)
    turns = nearest_turns(points, upright, wanted, LEAN)
    assert np.abs(turns).max() > 0.01
    assert nearest_turns(1e3 * points, upright, wanted, LEAN) == pytest.approx(turns, abs=1e-6)
