"""Least squares against dense algebra, and its conditions on larger systems."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import lsq_linear
from scipy.sparse import csr_array, random_array

from solver.linear.least_squares import smallest_solution, solution_above


def system(rows, columns, seed):
    numbers = np.random.default_rng(seed)
    matrix = csr_array(random_array((rows, columns), density=0.3, rng=numbers))
    return matrix, numbers.normal(size=rows)


@pytest.mark.parametrize(("rows", "columns"), [(30, 12), (12, 30), (20, 20)])
@pytest.mark.parametrize("seed", range(3))
def test_smallest_solution_is_that_of_the_pseudo_inverse(rows, columns, seed):
    matrix, right = system(rows, columns, seed)
    expected = np.linalg.pinv(matrix.toarray()) @ right
    found = smallest_solution(matrix, right)
    assert np.abs(found - expected).max() <= 1e-5 * np.abs(expected).max()
    assert np.abs(matrix.T @ (matrix @ found - right)).max() <= 1e-12


def test_rows_and_columns_may_repeat():
    matrix, right = system(30, 12, 5)
    twice = csr_array(np.tile(matrix.toarray(), (2, 2)))
    found = smallest_solution(twice, np.tile(right, 2))
    once = smallest_solution(matrix, right)
    assert np.allclose(found, np.tile(once, 2) / 2, rtol=0, atol=1e-5)


def test_a_system_without_entries_has_the_solution_zero():
    assert smallest_solution(csr_array((0, 4)), np.zeros(0)).tolist() == [0, 0, 0, 0]


@pytest.mark.parametrize("least", [0.0, 1e-3, 0.5])
@pytest.mark.parametrize("seed", range(4))
def test_bounded_solutions_are_those_of_an_active_set(least, seed):
    matrix, right = system(40, 15, seed)
    found = solution_above(matrix, right, least)
    expected = lsq_linear(matrix.toarray(), right, (least, np.inf), "bvls", tol=1e-15).x
    assert (found > least).all()
    assert found == pytest.approx(expected, abs=1e-8)


def test_bounded_solutions_of_redundant_systems_are_as_good_as_any():
    matrix, right = system(15, 40, 1)
    found = solution_above(matrix, right, 1e-3)
    gradient = matrix.T @ (matrix @ found - right)
    # Nothing is gained by raising an entry, nor by lowering one that is off the bound.
    assert gradient.min() >= -1e-8
    assert np.abs(gradient * (found - 1e-3)).max() <= 1e-8
