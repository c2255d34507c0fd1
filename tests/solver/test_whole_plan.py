"""All attempts one after the other: what follows on what was reached, without making any."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from solver import QuadMesh, start_optimisation
from solver.along import Along
from solver.analysis.form import surface_of
from solver.candidate import judge
from solver.last_phase import Aim
from solver.plan import Attempt
from solver.repetition import Repeat
from solver.report import COLLAPSED, CONVERGED, STALLED, STOPPED
from solver.whole_plan import Ended, WholePlan
from tests.conftest import wavy_grid
from tests.solver.test_plan import planner

START = wavy_grid(7, 6)
NEAR, FAR = Aim(surface_of(START)), Aim(surface_of(START), within=1e-9)
EARLY = Aim(surface_of(START), early=True, late=False)
RIGHTED = Aim(surface_of(START), late=False, righted=True)


def whole(net: str = "principal", aim: Aim = NEAR, history=(), **wants) -> WholePlan:
    plan = planner(net, START)
    repeat = wants.get("repeat")
    return WholePlan(plan.original, plan.way, aim, repeat, 1e-10, 100, "scipy", history)


def reached(plan: WholePlan, mesh: QuadMesh = START, **kind):
    """A solution, good unless something else is said."""
    found = judge(plan.original, plan.original.at(mesh), 1e-10)
    return replace(found, **{"met": True, **kind})


def uneven(plan: WholePlan):
    """A solution of which lines zigzag."""
    return reached(plan, smoothness_start=0.9, smoothness=0.2)


def higher(plan: WholePlan, height: float):
    """A good one, so far from where it was drawn."""
    return reached(plan, START.with_vertices(START.vertices + [0.0, 0.0, height]))


def told(plan: WholePlan, *ends: Ended):
    """Kinds of the attempts that are made where they end like this, and the status or None."""
    way, kinds = plan.way(), []
    attempt = next(way)
    for end in ends:
        kinds.append(type(attempt))
        try:
            attempt = way.send(end)
        except StopIteration as last:
            return kinds, last.value
    return [*kinds, type(attempt)], None


def test_a_good_net_is_led_along_the_nets_once_and_kept_where_that_is_nearer():
    plan = whole()
    near, far = higher(plan, 0.2), higher(plan, 0.5)
    assert told(plan, Ended(far), Ended(near)) == ([Attempt, Along], CONVERGED)
    assert plan.best.so_far() is near
    plan = whole()
    assert told(plan, Ended(near), Ended(far))[1] == CONVERGED
    assert plan.best.so_far() is near


def test_one_that_has_no_long_way_to_go_is_brought_nearer_at_its_farthest_place():
    plan = whole()
    net, first, sharp = (higher(plan, height) for height in (0.1, 0.08, 0.06))
    kinds, status = told(plan, Ended(net), Ended(first), Ended(sharp))
    assert (kinds, status) == ([Attempt, Along, Along], CONVERGED)
    assert plan.best.so_far() is sharp
    # Where it comes no nearer by that, or at the price of even lines or of area, what was lowered
    # before is lowered to its end.
    first = replace(first, smoothness=0.92)
    dear = replace(sharp, smoothness=0.87)
    shrunk = replace(sharp, area_ratio=0.8 * net.area_ratio)
    for worse in (net, uneven(plan), dear, shrunk):
        plan = whole()
        kinds, status = told(plan, Ended(net), Ended(first), Ended(worse), Ended(sharp))
        assert (kinds, status) == ([Attempt, Along, Along, Along], CONVERGED)
        assert plan.best.so_far() is sharp


def test_evenness_that_is_more_than_enough_may_go_where_the_largest_distance_falls():
    plan = whole()
    net, first, sharp = (higher(plan, height) for height in (0.1, 0.08, 0.06))
    first, sharp = replace(first, smoothness=0.98), replace(sharp, smoothness=0.91)
    kinds, status = told(plan, Ended(net), Ended(first), Ended(sharp))
    assert (kinds, status) == ([Attempt, Along, Along], CONVERGED)
    assert plan.best.so_far() is sharp


def test_lines_without_evenness_to_lose_turn_even_before_what_is_farthest_counts_most():
    plan = whole()
    net = replace(higher(plan, 0.5), smoothness_start=0.9, smoothness=0.87)
    way = plan.way()
    next(way)
    first = way.send(Ended(net))
    while not first.over:
        first.step(first.taken + 1, 99, 2)
    # It takes as many steps as it may, of which the last third is for what is farthest.
    second = way.send(Ended(replace(higher(plan, 0.3), smoothness=0.9)))
    assert first.most == 16 and isinstance(second, Along)
    assert second.most == 24 - first.taken
    assert second.moving is first.moving and second.moving.worth == plan._tuning.along_worth


def test_lines_that_zigzag_give_way_to_even_ones_that_are_on_the_surface_too():
    for height, mended in ((0.003, True), (0.02, False)):
        plan = whole()
        # A grid so coarse is never as near to its surface as others are.
        plan._tuning = replace(plan._tuning, on_surface=0.0035)
        before = replace(higher(plan, 0.002), smoothness=0.1, smoothness_start=0.1)
        after = replace(higher(plan, height), smoothness=0.9, smoothness_start=0.1)
        told(plan, Ended(before), Ended(after), Ended(before))
        assert (plan.best.so_far() is after) is mended


def test_where_no_surface_is_near_to_anything_it_ends_with_the_net():
    plan = whole(aim=Aim())
    assert told(plan, Ended(reached(plan))) == ([Attempt], CONVERGED)


def test_what_is_farther_than_it_may_be_is_led_on_once_more():
    plan = whole(aim=FAR)
    one, two, three = (higher(plan, height) for height in (0.5, 0.3, 0.2))
    kinds, status = told(plan, Ended(one), Ended(two), Ended(three))
    assert (kinds, status) == ([Attempt, Along, Along], CONVERGED)
    assert plan.best.so_far() is three


def test_what_zigzags_along_the_nets_is_tried_once_more_with_evener_lines():
    plan = whole()
    before, after = higher(plan, 0.5), higher(plan, 0.1)
    spoilt = uneven(plan)
    kinds, status = told(plan, Ended(before), Ended(spoilt), Ended(after))
    assert (kinds, status) == ([Attempt, Along, Along], CONVERGED)
    assert plan.best.so_far() is after
    plan = whole()
    assert told(plan, Ended(before), Ended(spoilt), Ended(spoilt))[1] == CONVERGED
    assert plan.best.so_far() is before


def test_a_net_that_asks_for_it_is_mended_along_the_nets_before_other_attempts():
    plan = whole("stress", EARLY)
    bad, good = uneven(plan), reached(plan)
    assert told(plan, Ended(bad), Ended(good)) == ([Attempt, Along], CONVERGED)
    assert plan.best.so_far() is good
    # Not mended: the way goes on where it was, and another that zigzags is not led on.
    plan = whole("stress", EARLY)
    kinds, status = told(plan, Ended(bad), Ended(bad), Ended(bad), Ended(bad))
    assert kinds == [Attempt, Along, Attempt, Attempt, Attempt] and status is None
    # A good one needs nothing.
    plan = whole("stress", EARLY)
    assert told(plan, Ended(good)) == ([Attempt], CONVERGED)


def test_what_no_attempt_made_good_is_led_on_to_what_is_more_like_the_start():
    plan = whole("cmc", RIGHTED)
    bad, better = uneven(plan), higher(plan, 0.02)
    kinds, status = told(plan, *3 * [Ended(bad)], Ended(better))
    assert kinds == [*3 * [Attempt], Along] and status == CONVERGED
    assert plan.best.so_far() is better
    # With less of its area it is not; the next weight of even lines is tried.
    plan = whole("cmc", RIGHTED)
    small = reached(plan, better.mesh, area_ratio=0.93)
    kinds, status = told(plan, *3 * [Ended(bad)], Ended(small), Ended(small))
    assert kinds == [*3 * [Attempt], Along, Along] and status == CONVERGED
    assert plan.best.so_far() is bad
    # A good one with upright corners needs nothing.
    plan = whole("cmc", RIGHTED)
    assert told(plan, Ended(reached(plan))) == ([Attempt], CONVERGED)
    # With sharp ones it does.
    points = START.vertices + 0.7 * START.vertices[:, [1]] * [1.0, 0.0, 0.0]
    plan = whole("cmc", RIGHTED)
    sharp = reached(plan, START.with_vertices(points))
    assert sharp.good and told(plan, Ended(sharp))[0] == [Attempt, Along]


def test_an_easier_net_is_a_start_and_no_result():
    plan = whole("stress", Aim())
    failed = reached(plan, met=False)
    way, attempt = plan.way(), None
    attempt = next(way)
    while not attempt.easier:
        attempt = way.send(Ended(failed))
    there = higher(plan, 0.02)
    following = way.send(Ended(there))
    assert isinstance(following, Attempt) and not following.easier
    np.testing.assert_array_equal(following.problem.mesh.vertices, there.mesh.vertices)
    assert not plan.best.so_far().valid


@pytest.mark.parametrize("kind", ["attempt", "along"])
def test_where_it_is_stopped_nothing_follows(kind):
    plan = whole(repeat=Repeat("edges", 3, 1e-3))
    net = reached(plan)
    ends = [Ended(net, stopped=True)] if kind == "attempt" else [Ended(net), Ended(net, True)]
    assert told(plan, *ends)[1] == CONVERGED
    assert plan.repetition is None
    plan = whole()
    assert told(plan, Ended(reached(plan, met=False), stopped=True))[1] == STOPPED


def test_few_kinds_of_parts_come_last():
    plan = whole(aim=Aim(), repeat=Repeat("edges", 3, 1e-3))
    net, alike = reached(plan), higher(plan, 0.1)
    assert told(plan, Ended(net), Ended(alike)) == ([Attempt, Along], CONVERGED)
    assert plan.best.so_far() is alike
    assert plan.repetition.asked == 3


def test_it_ends_where_attempts_are_given_up_or_steps_used_up():
    plan = whole("chebyshev", Aim())
    slow = Ended(reached(plan, met=False), given_up=True)
    assert told(plan, slow, slow) == ([Attempt, Attempt], STALLED)
    plan = whole(history=[None] * 100)
    assert told(plan, Ended(uneven(plan))) == ([Attempt], CONVERGED)
    plan = whole(history=[None] * 100)
    assert told(plan, Ended(reached(plan, met=False))) == ([Attempt], STALLED)


def test_a_net_that_has_gone_flat_is_not_led_on():
    plan = whole()
    gone = reached(plan, thickness=0.0)
    kinds, status = told(plan, *[Ended(gone)] * 3)
    assert Along not in kinds and status in (COLLAPSED, None)


@pytest.mark.parametrize(("tolerance", "status"), [(1e-10, CONVERGED), (1e-30, STOPPED)])
def test_an_interrupt_between_attempts_keeps_the_best(monkeypatch, tolerance, status):
    def interrupted(*_):
        raise KeyboardInterrupt

    run = start_optimisation(START, "principal", tolerance=tolerance)
    monkeypatch.setattr(WholePlan, "_is_enough", interrupted)
    outcome = run.run()
    assert run.finished and outcome.report.attempts == 1
    assert outcome.report.status == status
    assert max(part.max for part in outcome.report.residuals.values()) < 1e-10
