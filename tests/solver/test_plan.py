"""The way to a net: what is tried from which starts, in which order, and nothing twice."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from solver import Constraints, InputError, NetOptions, start_optimisation
from solver.candidate import judge
from solver.nets import NETS
from solver.nets.settings import WEIGHTS, Weights
from solver.plan import Plan
from tests.conftest import wavy_grid
from tests.meshes import bent_sheet, noisy


def planner(net, mesh, weights=None, once=False):
    fixed = np.zeros(len(mesh.vertices), dtype=bool)
    if net == "stress":
        fixed = mesh.connectivity.boundary_vertices
    weights = weights or Weights()
    return Plan(NETS[net], mesh, fixed, NetOptions(), Constraints(), weights, once)


def candidate(plan, mesh, **kind):
    """What an attempt would reach with that mesh: a failure, or a solution of some quality."""
    found = judge(plan.original, plan.original.start, 1e-10)
    return replace(found, mesh=mesh, **{"met": False, **kind})


def tried(plan, reached):
    """All attempts of a way where each reaches what ``reached`` gives for it."""
    way = plan.way()
    attempt = next(way)
    while True:
        yield attempt
        try:
            attempt = way.send(reached(attempt))
        except StopIteration:
            return


def failing(plan):
    return list(tried(plan, lambda attempt: candidate(plan, plan.mesh)))


def leading(attempt):
    """The guides that count in an attempt, with their weights."""
    weights = attempt.weights_of_guides(1.0)
    named = zip(attempt.problem.guides, weights, strict=True)
    return {guide.term.name: weight for guide, weight in named if weight > 0}


@pytest.mark.parametrize("build", [lambda: wavy_grid(7, 6), bent_sheet], ids=["wave", "sheet"])
@pytest.mark.parametrize("net", NETS)
def test_no_attempt_is_made_twice_and_the_first_at_a_problem_is_patient(net, build):
    plan = planner(net, build())
    seen, before = set(), None
    for attempt in failing(plan):
        problem = attempt.problem
        assert attempt.patient == (problem is not before)
        before = problem
        start = problem.mesh.vertices.tobytes()
        round_by = id(problem) if attempt.easier else 0
        key = (problem.net, start, round_by, tuple(sorted(leading(attempt).items())))
        assert key not in seen
        seen.add(key)
    assert seen


@pytest.mark.parametrize("build", [lambda: wavy_grid(7, 6), bent_sheet], ids=["wave", "sheet"])
@pytest.mark.parametrize("net", NETS)
def test_a_given_fairness_changes_no_other_guide(net, build):
    mesh = build()
    usual = next(attempt for attempt in failing(planner(net, mesh)) if attempt.problem.mesh is mesh)
    (given,) = failing(planner(net, mesh, Weights(fairness=0.5), once=True))
    assert leading(given) == {**leading(usual), "fairness": 0.5}


def test_the_start_itself_is_tried_before_it_is_bent():
    mesh = bent_sheet()
    for net in NETS:
        plan = planner(net, mesh)
        assert next(plan.way()).problem is plan.original
        assert plan.original.mesh is mesh
    problems = list(
        dict.fromkeys(map(id, (one.problem for one in failing(planner("geodesic", mesh)))))
    )
    assert len(problems) == 4
    starts = [one.problem.mesh for one in failing(planner("geodesic", mesh))]
    assert starts[0] is starts[-1] is mesh
    assert len({id(start) for start in starts}) == 3


def test_a_rigid_net_of_a_dome_begins_with_bent_starts():
    x, y = np.meshgrid(np.linspace(-1, 1, 7), np.linspace(-1, 1, 6), indexing="ij")
    flat = wavy_grid(7, 6, height=0.0, shear=0.0)
    dome = flat.with_vertices(np.stack([x, y, 1 - 0.3 * (x**2 + y**2)], axis=2).reshape(-1, 3))
    plan = planner("geodesic-chebyshev", dome)
    assert next(plan.way()).problem.mesh is not dome
    assert plan.original.mesh is dome
    assert next(planner("geodesic", dome).way()).problem.mesh is dome


def test_an_easier_net_leads_to_the_wanted_one_from_where_it_arrived():
    start, arrived = wavy_grid(7, 6), noisy(wavy_grid(7, 6), 0.1)
    plan = planner("circular", start)
    good = candidate(plan, arrived, met=True)
    assert good.good

    def reached(attempt):
        return good if attempt.easier else candidate(plan, start)

    ways = list(tried(plan, reached))
    nets = [(attempt.problem.net, attempt.easier) for attempt in ways]
    assert nets[:3] == [("circular", False), ("principal", True), ("circular", False)]
    assert nets.count(("principal", True)) == 1
    assert ways[2].problem.mesh is arrived and ways[-1].problem.mesh is start


def test_a_cramped_result_of_an_easier_net_serves_only_where_no_better_comes():
    start = wavy_grid(7, 6)
    plan = planner("conical", start)
    cramped = candidate(plan, start, met=True, crease=90.0)
    assert cramped.valid and not cramped.good
    easier = [one for one in tried(plan, lambda attempt: cramped) if one.easier]
    assert len(easier) > 1
    assert [one.leads_on(cramped) for one in easier] == [one.last for one in easier]
    assert [one.last for one in easier] == [False] * (len(easier) - 1) + [True]


def test_posing_stops_with_the_attempts():
    """What comes later on a way is posed only when it is asked for."""
    plan = planner("stress", wavy_grid(7, 6))
    way = plan.way()
    assert next(way).problem.net == "stress"
    assert way.send(candidate(plan, plan.mesh)).problem.net == "orthogonal"
    way.close()


def test_every_guide_can_be_weighed_and_switched_off_and_patches_have_a_size():
    mesh = wavy_grid(7, 6)
    words = ("fairness", "multi", "closeness", "evenness", "smooth_motion", "edge_vectors")
    terms = {word: word.replace("_", " ") for word in words} | {"multi": "multi-net"}
    assert set(words) | {"isometry"} <= set(WEIGHTS)
    for word, term in terms.items():
        off, on = (
            start_optimisation(mesh, **{word: weight}).descent.attempt for weight in (0.0, 0.7)
        )
        assert term not in leading(off) and leading(on)[term] == 0.7
    large = start_optimisation(mesh, multi=0.5, multi_patch=(2, 3)).original
    (guide,) = [one for one in large.guides if one.term.name == "multi-net"]
    assert len(guide.term.faces) == len(mesh.connectivity.rectangles(2, 3)) > 0
    with pytest.raises(InputError, match="multi patch: expected two counts"):
        start_optimisation(mesh, multi_patch=(1, 1))
