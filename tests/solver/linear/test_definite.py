"""Positive definite matrices of one sparsity, factored by their places in space."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.sparse import csr_array, eye_array, random_array

from solver.errors import SingularSystemError
from solver.linear.definite import DefiniteSolver
from solver.linear.squares import WeightedSquares


@pytest.fixture(scope="module")
def sheet():
    """Slopes over the edges of a grid of 25 x 20 unknowns, and where these are."""
    places = np.stack(np.meshgrid(np.arange(25.0), np.arange(20.0), [0.0]), axis=-1).reshape(-1, 3)
    number = np.arange(500).reshape(20, 25)
    pairs = np.concatenate(
        [
            np.stack([number[:, :-1].ravel(), number[:, 1:].ravel()], axis=1),
            np.stack([number[:-1].ravel(), number[1:].ravel()], axis=1),
            # The first unknown is held.
            [[0, 0]],
        ]
    )
    rows = np.repeat(np.arange(len(pairs)), 2)
    values = np.append(np.tile([1.0, -1.0], len(pairs) - 1), [1.0, 0.0])
    return csr_array((values, (rows, pairs.ravel())), shape=(len(pairs), 500)), places


def test_squares_with_many_weights(sheet):
    matrix, _ = sheet
    squares = WeightedSquares(matrix)
    for seed in (0, 1):
        weights = np.random.default_rng(seed).uniform(0, 3, matrix.shape[0])
        wanted = matrix.T @ (weights[:, None] * matrix.toarray())
        found = squares.of(weights)
        assert np.allclose(found.toarray(), wanted, rtol=0, atol=1e-13)
        assert found.has_sorted_indices
    # Entries stay where they are when weights let some of them vanish.
    assert squares.of(0 * weights).nnz == found.nnz


def test_squares_of_rows_with_different_counts_of_entries():
    matrix = csr_array(random_array((40, 12), density=0.2, rng=np.random.default_rng(3)))
    assert len(set(np.diff(matrix.indptr))) > 3
    weights = np.linspace(0.5, 2, 40)
    wanted = matrix.T @ (weights[:, None] * matrix.toarray())
    assert np.allclose(WeightedSquares(matrix).of(weights).toarray(), wanted, rtol=0, atol=1e-13)


def test_one_and_several_right_sides(sheet):
    matrix, places = sheet
    squares = WeightedSquares(matrix)
    solver = DefiniteSolver(squares.of(np.ones(matrix.shape[0])), places)
    numbers = np.random.default_rng(5)
    for _ in range(2):
        normal = squares.of(numbers.uniform(0.1, 2, matrix.shape[0]))
        solve, wanted = solver.factor(normal), numbers.normal(size=(500, 3))
        assert np.allclose(solve(normal @ wanted), wanted, rtol=0, atol=1e-9)
        assert np.allclose(solve(normal @ wanted[:, 0]), wanted[:, 0], rtol=0, atol=1e-9)


def test_a_long_chain_of_which_parts_share_two_unknowns():
    count = 300
    ends = np.concatenate([[(k, k + 1), (k, k + 2)] for k in range(count - 2)])
    rows = np.repeat(np.arange(len(ends)), 2)
    values = np.tile([1.0, -1.0], len(ends))
    slopes = csr_array((values, (rows, ends.ravel())), shape=(len(ends), count))
    matrix = csr_array(slopes.T @ slopes + eye_array(count))
    places = np.arange(float(count))[:, None] * [1.0, 0.0, 0.0]
    wanted = np.random.default_rng(6).normal(size=count)
    solve = DefiniteSolver(matrix, places).factor(matrix)
    assert np.allclose(solve(matrix @ wanted), wanted, rtol=0, atol=1e-12)


def test_a_matrix_that_is_not_definite_is_refused(sheet):
    matrix, places = sheet
    squares = WeightedSquares(matrix)
    solver = DefiniteSolver(squares.of(np.ones(matrix.shape[0])), places)
    with pytest.raises(SingularSystemError):
        solver.factor(squares.of(-np.ones(matrix.shape[0])))
