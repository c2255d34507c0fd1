"""Assembled normal equations against dense ones, and both sparse solvers against numpy."""

from __future__ import annotations

import importlib.util

import numpy as np
import pytest

from solver.assembly import NormalEquations
from solver.errors import InputError
from solver.linear.backends import BACKENDS, symmetric_solver
from solver.terms.base import Linearisation
from solver.terms.fairness import Fairness
from solver.terms.multi import multi_net
from solver.terms.orthogonality import Orthogonality
from solver.terms.planarity import Planarity
from tests.conftest import wavy_grid

WEIGHTS = np.array([1.0, 0.7, 0.3, 0.2])


@pytest.fixture
def system():
    mesh = wavy_grid(7, 6)
    net = mesh.connectivity
    terms = [
        Orthogonality(mesh.faces),
        Planarity(mesh.faces),
        Fairness(net.line_triples),
        multi_net(net),
    ]
    free = np.ones(3 * len(mesh.vertices), dtype=bool)
    free[[0, 1, 2, 50, 77]] = False
    x = mesh.vertices.ravel()
    return (
        NormalEquations(terms, free, mesh.vertices),
        [term.linearise(x) for term in terms],
        free,
    )


def dense(system, linearisations, free, weights=WEIGHTS):
    matrix = np.zeros((len(free), len(free)))
    gradient = np.zeros(len(free))
    for term, weight, (residual, jacobian) in zip(
        system.terms, weights, linearisations, strict=True
    ):
        for unknowns, r, j in zip(term.unknowns, residual, jacobian, strict=True):
            matrix[np.ix_(unknowns, unknowns)] += weight * j.T @ j
            gradient[unknowns] += weight * j.T @ r
    order = system.sparsity.unknowns
    assert sorted(order) == np.flatnonzero(free).tolist()
    return matrix[np.ix_(order, order)], gradient[order]


def unpacked(pattern, data):
    lower = np.zeros((pattern.size, pattern.size))
    column = np.repeat(np.arange(pattern.size), np.diff(pattern.indptr))
    lower[pattern.indices, column] = data
    return lower + np.tril(lower, -1).T


def test_matrix_and_gradient_equal_the_dense_sums(system):
    equations, linearisations, free = system
    matrix, gradient = dense(equations, linearisations, free)
    assert np.allclose(
        unpacked(equations.sparsity, equations.matrix(linearisations, WEIGHTS)),
        matrix,
        rtol=0,
        atol=1e-12,
    )
    assert np.allclose(equations.gradient(linearisations, WEIGHTS), gradient, rtol=0, atol=1e-12)


def test_a_weight_of_zero_leaves_a_term_out(system):
    equations, linearisations, free = system
    broken = [linearisations[0], *(_not_a_number(part) for part in linearisations[1:])]
    weights = np.array([1.0, 0.0, 0.0, 0.0])
    matrix, gradient = dense(equations, linearisations, free, weights)
    data = equations.matrix(broken, weights)
    assert np.allclose(unpacked(equations.sparsity, data), matrix, rtol=0, atol=1e-12)
    assert np.allclose(equations.gradient(broken, weights), gradient, rtol=0, atol=1e-12)


def _not_a_number(part):
    return Linearisation(np.full_like(part.residual, np.nan), np.full(part.jacobian.shape, np.nan))


def test_terms_that_never_weigh_anything_have_no_place(system):
    full, linearisations, free = system
    points = wavy_grid(7, 6).vertices
    slim = NormalEquations(full.terms, free, points, used=[True, True, False, False])
    weights = np.array([1.0, 0.3, 0.0, 0.0])
    assert len(slim.sparsity.indices) < len(full.sparsity.indices)
    matrix, gradient = dense(slim, linearisations, free, weights)
    found = unpacked(slim.sparsity, slim.matrix(linearisations, weights))
    np.testing.assert_allclose(found, matrix, rtol=0, atol=1e-12 * np.abs(matrix).max())
    np.testing.assert_allclose(slim.gradient(linearisations, weights), gradient, atol=1e-12)
    with pytest.raises(AssertionError, match="no place"):
        slim.matrix(linearisations, np.ones(4))


@pytest.mark.parametrize("backend", BACKENDS)
def test_solvers_solve(system, backend):
    if backend == "rslab" and importlib.util.find_spec("rslab") is None:
        pytest.skip("rslab is not installed; scipy is used instead")
    equations, linearisations, free = system
    matrix, gradient = dense(equations, linearisations, free)
    data = equations.matrix(linearisations, WEIGHTS)
    data[equations.sparsity.indptr[:-1]] += 0.5
    solver = symmetric_solver(equations.sparsity, backend)
    for right in (gradient, 2 * gradient + 1):
        solution = solver.factor(data)(right)
        wanted = np.linalg.solve(matrix + 0.5 * np.eye(len(matrix)), right)
        assert np.allclose(solution, wanted, rtol=0, atol=1e-10)


def test_unknown_solver_is_refused(system):
    with pytest.raises(InputError, match="sparse solver: expected scipy or rslab"):
        symmetric_solver(system[0].sparsity, "magic")
