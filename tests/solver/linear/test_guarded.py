"""A sparse solver of someone else's that panics, lies, hangs or says that there is no solution."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from solver import optimise
from solver.errors import SingularSystemError
from solver.linear import threads
from solver.linear.backends import symmetric_solver
from solver.linear.sparsity import Sparsity

# Stands for the library: solves densely, and does what it is told first.
STAND_IN = """
import time
import numpy as np

class Panic(BaseException):
    pass

class Symbolic:
    def __init__(self, matrix):
        self.matrix = matrix

    def factor(self, lower):
        half = self.matrix.copy()
        half.data = lower
        half = half.toarray()
        return Factors(half + np.tril(half, -1).T)

class Factors:
    def __init__(self, matrix):
        self.matrix = matrix

    def solve(self, right):
        {act}
        return np.linalg.solve(self.matrix, right)

def analyze(matrix, path):
    return Symbolic(matrix)
"""
# Lower triangle of a matrix of three unknowns, by column: 4 1 0 | 5 2 | 6.
SPARSITY = Sparsity(
    np.array([0, 2, 4, 5]), np.array([0, 1, 1, 2, 2]), np.arange(3), np.array([0, 3])
)
LOWER = np.array([4.0, 1.0, 5.0, 2.0, 6.0])
FULL = np.array([[4.0, 1.0, 0.0], [1.0, 5.0, 2.0], [0.0, 2.0, 6.0]])


@pytest.fixture
def rslab(tmp_path, monkeypatch):
    """Put a stand-in for the library first on the path."""

    def install(act: str) -> None:
        (tmp_path / "rslab.py").write_text(STAND_IN.format(act=act))
        monkeypatch.syspath_prepend(str(tmp_path))
        monkeypatch.delitem(sys.modules, "rslab", raising=False)

    return install


@pytest.mark.parametrize(
    ("act", "words"),
    [
        ("pass", ""),
        ("raise Panic('index out of bounds')", "index out of bounds"),
        ("import os; os._exit(3)", "ended with code 3"),
        ("return 1.01 * np.linalg.solve(self.matrix, right)", "its solution is wrong"),
        ("return np.full(3, np.nan)", "its solution is wrong"),
        ("time.sleep(60)", "did not finish within 1 s"),
    ],
)
def test_whatever_the_library_does_the_system_is_solved(rslab, monkeypatch, capfd, act, words):
    rslab(act)
    solver = symmetric_solver(SPARSITY, "rslab")
    solve = solver.factor(LOWER)
    if "sleep" in act:
        monkeypatch.setattr(solver, "_limit", 1.0)
    for right in (np.array([1.0, 2.0, 3.0]), np.array([0.0, -1.0, 1e6])):
        assert solve(right) == pytest.approx(np.linalg.solve(FULL, right), rel=1e-12)
    # A matrix after the failure is solved as well.
    assert solver.factor(2 * LOWER)(np.ones(3)) == pytest.approx(np.linalg.solve(2 * FULL, [1] * 3))
    assert words in solver.remark and bool(words) == bool(solver.remark)
    assert capfd.readouterr() == ("", "")


def test_an_older_factorisation_still_solves_its_own_matrix(rslab):
    rslab("pass")
    solver = symmetric_solver(SPARSITY, "rslab")
    older, newer = solver.factor(LOWER), solver.factor(3 * LOWER)
    for solve, factor in ((newer, 3), (older, 1), (newer, 3)):
        assert solve(np.ones(3)) == pytest.approx(np.linalg.solve(factor * FULL, [1] * 3))


@pytest.mark.parametrize("act", ["pass", "raise Panic('no')"])
def test_a_singular_matrix_asks_for_more_damping(act, rslab):
    pytest.importorskip("rslab", reason="rslab is not installed")
    solver = symmetric_solver(SPARSITY, "rslab")
    if act != "pass":
        rslab(act)
        solver.factor(LOWER)(np.ones(3))
        assert solver.remark
    with pytest.raises(SingularSystemError):
        solver.factor(np.zeros(5))


def test_an_optimisation_says_in_its_report_that_the_library_failed(rslab, wave):
    rslab("raise Panic('lost')")
    report = optimise(wave, "principal", backend="rslab", max_steps=3).report
    plain = optimise(wave, "principal", backend="scipy", max_steps=3).report
    assert report.status == plain.status and report.iterations == plain.iterations
    assert "the library rslab failed (lost), so scipy solved the systems" in report.warnings
    assert not any("rslab" in warning for warning in plain.warnings)


def test_a_library_of_threads_that_fails_changes_nothing(monkeypatch):
    threadpoolctl = pytest.importorskip("threadpoolctl")

    def failing():
        raise AttributeError("no version")

    monkeypatch.setattr(threadpoolctl, "ThreadpoolController", failing)
    threads._controller.cache_clear()
    with pytest.warns(UserWarning, match="threadpoolctl failed"), threads.one_thread():
        assert np.linalg.solve(FULL, FULL[0]) == pytest.approx([1, 0, 0])
    threads._controller.cache_clear()
