"""An attempt under way: how long its guides stay."""

from __future__ import annotations

import numpy as np

from solver import Constraints, start_optimisation
from solver.terms.pull import Pull
from tests.conftest import wavy_grid


def test_guides_stay_until_handles_that_were_drawn_far_have_arrived():
    start = wavy_grid(9, 8)
    goal = start.vertices[35] + 5 * start.mean_edge * np.array([0.0, 0.0, 1.0])
    run = start_optimisation(start, "principal", constraints=Constraints(handles={35: goal}))
    tuning, fades = run.descent.problem.tuning, []
    while not next(term for term in run.descent.point.terms if isinstance(term, Pull)).arrived:
        fades.append(run.step().fade)
    # A quarter of a mean edge a step.
    assert len(fades) >= 4 * 5 - 1
    assert min(fades) == fades[-1] == tuning.hold
    outcome = run.run()
    assert outcome.report.status == "converged", outcome.report.message
    assert run.descent.fade == 0.0
