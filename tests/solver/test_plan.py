"""Which problems are tried for a net: from which starts, and none of them twice."""

from __future__ import annotations

import numpy as np
import pytest

from solver import Constraints, NetOptions
from solver.nets import NETS
from solver.nets.settings import Weights
from solver.plan import Plan
from tests.conftest import wavy_grid
from tests.meshes import bent_sheet


def planner(net, mesh, weights):
    fixed = np.zeros(len(mesh.vertices), dtype=bool)
    if net == "stress":
        fixed = mesh.connectivity.boundary_vertices
    return Plan(NETS[net], fixed, NetOptions(), Constraints(), weights)


def planned(net, mesh):
    return planner(net, mesh, Weights()).problems(mesh)


def attempts(problem):
    """The guides that count in each attempt, with their weights."""
    for number in range(1, problem.attempts + 1):
        weights = {guide.term.name: guide.weight(number) for guide in problem.guides}
        yield tuple((name, weight) for name, weight in weights.items() if weight > 0)


@pytest.mark.parametrize("build", [lambda: wavy_grid(7, 6), bent_sheet], ids=["wave", "sheet"])
@pytest.mark.parametrize("net", NETS)
def test_no_attempt_is_made_twice(net, build):
    mesh = build()
    straight, ways_round = {}, []
    for problem in planned(net, mesh):
        if problem.easier:
            ways_round += [list(attempts(problem)), list(attempts(problem.easier(mesh)))]
        else:
            straight.setdefault(id(problem.mesh), []).extend(attempts(problem))
    for tried in (*straight.values(), *ways_round):
        assert len(set(tried)) == len(tried) > 0


@pytest.mark.parametrize("build", [lambda: wavy_grid(7, 6), bent_sheet], ids=["wave", "sheet"])
@pytest.mark.parametrize("net", NETS)
def test_a_given_fairness_changes_no_other_guide(net, build):
    mesh = build()
    own = next(problem for problem in planned(net, mesh) if problem.mesh is mesh)
    usual = dict(next(attempts(own)))
    given = dict(next(attempts(planner(net, mesh, Weights(fairness=0.5)).single(mesh))))
    assert given == {**usual, "fairness": 0.5}


def test_the_start_itself_is_tried_before_it_is_bent():
    mesh = bent_sheet()
    for net in NETS:
        assert planned(net, mesh)[0].mesh is mesh
    first, *bent, last = planned("geodesic", mesh)
    assert first.mesh is last.mesh is mesh
    assert len(bent) == 2 and all(problem.mesh is not mesh for problem in bent)
