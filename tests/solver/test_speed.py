"""Speed, as ratios of processor time within one process, so that other work does not count."""

from __future__ import annotations

import time

import numpy as np
import pytest
from scipy import sparse
from scipy.sparse.linalg import splu

from solver import NetOptions, start_optimisation
from solver.nets import NETS
from tests.conftest import wavy_grid

STEPS, REPEATS = 8, 4


def times(monkeypatch, mesh, net, steps=STEPS, repeats=REPEATS):
    """Median step, median part of it in factorisations and solves, and set-up, in seconds.

    Each step counts with the fastest of its repetitions: they are the same steps, noise only adds.
    """
    monkeypatch.setattr(time, "perf_counter", time.process_time)
    rest = mesh.vertices * [1.0, 1.0, 1.02]
    options = NetOptions(reference=rest) if net == "isometric" else NetOptions()
    fix = "boundary" if net == "stress" else "none"
    step, solve, setup = np.full(steps, np.inf), np.full(steps, np.inf), np.inf
    for _ in range(repeats):
        run = start_optimisation(
            mesh, net, fix=fix, options=options, backend="scipy", tolerance=1e-30
        )
        for k in range(steps):
            begin = time.process_time()
            record = run.step()
            step[k] = min(step[k], time.process_time() - begin)
            solve[k] = min(solve[k], record.solve_seconds)
        setup = min(setup, run.seconds_setup)
    return float(np.median(step)), float(np.median(solve)), setup


@pytest.mark.slow
@pytest.mark.parametrize("net", NETS)
def test_a_step_costs_little_more_than_its_solve(monkeypatch, net):
    step, solve, setup = times(monkeypatch, wavy_grid(48, 48), net)
    # Half of a solve in whose matrix all guides have a place; one of those that weigh anything
    # takes two thirds of it.
    assert step <= 1.75 * solve
    assert setup <= 5 * step


@pytest.mark.slow
def test_time_grows_slowly_with_the_mesh(monkeypatch):
    small, _, _ = times(monkeypatch, wavy_grid(32, 32), "principal")
    large, _, _ = times(monkeypatch, wavy_grid(100, 100), "principal", repeats=4)
    # 1.3 on a quiet machine; other work leaves less of the caches to the larger mesh.
    assert np.log(large / small) / np.log(10_000 / 1_024) <= 1.55


def factorisation_seconds(side=39, repeats=8):
    """Fastest factorisation by a library of a matrix as large and as full as that of such a net.

    Three unknowns a vertex, each with those of the vertices two edges away: as the step itself it
    feels how much of the caches other work leaves.
    """
    line = sparse.diags([-1.0, 2.1, -1.0], [-1, 0, 1], shape=(side, side))
    laplacian = sparse.kronsum(line, line)
    matrix = sparse.csc_matrix(sparse.kron(laplacian @ laplacian, np.ones((3, 3)) + 2 * np.eye(3)))
    fastest = np.inf
    for _ in range(repeats):
        begin = time.process_time()
        splu(matrix, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
        fastest = min(fastest, time.process_time() - begin)
    return fastest


@pytest.mark.slow
@pytest.mark.parametrize(("net", "most"), [("principal", 1.6), ("cmc", 1.6), ("stress", 2.6)])
def test_a_step_costs_little_more_than_one_factorisation(monkeypatch, net, most):
    # Measured 0.9 to 1.2, 0.9 to 1.2 and 1.7 to 1.9 beside other work; where that came between, it
    # is measured again.
    ratios = []
    while len(ratios) < 3 and (not ratios or ratios[-1] > most):
        yardsticks = [factorisation_seconds()]
        step, _, _ = times(monkeypatch, wavy_grid(39, 39), net)
        yardsticks.append(factorisation_seconds())
        ratios.append(step / max(yardsticks))
    assert ratios[-1] <= most, ratios
