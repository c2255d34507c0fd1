"""Anderson's mixing on maps of which the fixed point is known."""

from __future__ import annotations

import numpy as np
import pytest

from solver.formfinding.mixing import Mixing


@pytest.mark.parametrize("size", [1, 2, 3])
def test_an_affine_map_is_solved_in_as_many_steps_as_it_has_directions(size):
    """One image tells nothing; each further one settles a direction."""
    random = np.random.default_rng(size)
    slope = 0.9 * np.linalg.qr(random.normal(size=(size, size)))[0]
    fixed = random.normal(size=size)
    mixing, point, away = Mixing(), np.zeros(size), []
    for _ in range(size + 1):
        point = mixing(point, fixed + slope @ (point - fixed))
        away.append(np.linalg.norm(point - fixed))
    assert away[-1] <= 1e-6 < away[-2]


def test_a_step_ten_times_as_long_forgets_the_past():
    mixing = Mixing()
    mixing(np.array([0.0]), np.array([1.0]))
    assert mixing(np.array([1.0]), np.array([12.0])) == 12.0
