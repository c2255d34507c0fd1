"""Where a descent stands: what is linearised when, and what follows the mesh."""

from __future__ import annotations

import numpy as np
import pytest

from solver.assembly import NormalEquations
from solver.mesh.closest import Polyline
from solver.point import Point
from solver.terms.closeness import Closeness
from solver.terms.gliding import OnCurve
from solver.terms.planarity import Planarity
from tests.conftest import wavy_grid


@pytest.fixture
def point():
    mesh = wavy_grid(4, 4)
    vertices = np.arange(16)
    x = mesh.vertices.ravel()
    rim = np.arange(4)
    terms = [
        Planarity(mesh.faces),
        Closeness(vertices, mesh.vertices + 0.1),
        OnCurve(rim, Polyline(mesh.vertices[rim] + [0, 0, 0.2])),
    ]
    free = np.ones(len(x), dtype=bool)
    free[:3] = False
    return Point.at(NormalEquations(terms, free, mesh.vertices), terms, x)


def test_energy_and_gradient_are_those_of_its_terms(point):
    weighed = point.weighed(np.array([1.0, 0.5, 0.0]))
    parts = [float((part.residual**2).sum()) for part in point.linearisations]
    assert weighed.energy == pytest.approx(parts[0] + 0.5 * parts[1], rel=1e-14)
    move = np.zeros(len(weighed.gradient))
    move[7] = 1e-6
    change = weighed.moved(move).energy - weighed.moved(-move).energy
    assert weighed.gradient[7] == pytest.approx(change / 4e-6, rel=1e-5)


def test_what_weighs_nothing_is_not_linearised_and_what_is_fixed_stays(point):
    weighed = point.weighed(np.array([1.0, 0.0, 1.0]))
    there = weighed.moved(np.full(len(weighed.gradient), 0.01))
    assert there.linearisations[1] is point.linearisations[1]
    assert there.linearisations[0] is not point.linearisations[0]
    assert (there.x[:3] == point.x[:3]).all() and (there.x[3:] != point.x[3:]).all()
    assert (point.standing_at(there.x).linearisations[1].residual != 0.1).any()


def test_terms_look_again_where_the_mesh_is(point):
    there = point.moved(np.full(len(point.gradient), 0.3))
    feet = there.terms[2].feet
    again = there.followed()
    assert again.terms[2].feet is not feet and again.terms[0] is there.terms[0]
    replaced = again.with_term(1, Closeness(np.arange(16), again.x.reshape(-1, 3)))
    assert replaced.linearisations[1].residual.max() == 0.0
    assert again.linearisations[1].residual.max() > 0.0
