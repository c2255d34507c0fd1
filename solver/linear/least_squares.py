"""Sparse linear least squares, free and with solutions that are bounded from below."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.sparse import csc_array, csr_array, diags_array
from scipy.sparse.linalg import splu

from solver.mesh.quadmesh import FloatArray

# Damping of normal equations relative to their diagonal, and how often they are repeated at most,
# until the solution changes by less than the last part.
_DAMPING, _REPEATS, _SETTLED = 1e-10, 30, 1e-14
# Most steps of the interior point method, what is left of its conditions at the end, and the part
# of the way to a bound that a step may go.
_STEPS, _LEFT, _WAY = 60, 1e-12, 0.99


def smallest_solution(matrix: csr_array, right: FloatArray) -> FloatArray:
    """(n,) smallest of the least-squares solutions; rows and columns may be redundant.

    By damped normal equations, repeated for what they leave. What the system does not determine is
    zero up to six digits: rounding divided by the damping.

    Args:
        matrix: (m, n).
        right: (m,) right side.
    """
    if not matrix.nnz:
        return np.zeros(matrix.shape[1])
    solve = _factored(_damped_normal(matrix))
    solution = np.zeros(matrix.shape[1])
    for _ in range(_REPEATS):
        step = solve(matrix.T @ (right - matrix @ solution))
        solution += step
        if np.abs(step).max() <= _SETTLED * np.abs(solution).max():
            break
    return solution


def solution_above(matrix: csr_array, right: FloatArray, least: float) -> FloatArray:
    """(n,) least-squares solution whose entries are not below ``least``.

    A primal-dual interior point method: with x the excess over the bound, z the multipliers and
    g = M^T (M x - r) it follows g = z, x z = mu, x > 0, z > 0 to mu = 0. Where several solutions
    are equally good it is one amid them.

    Args:
        matrix: (m, n).
        right: (m,) right side.
        least: the bound.

    Source: Mehrotra (1992), On the implementation of a primal-dual interior point method.
    """
    normal, count = _damped_normal(matrix), matrix.shape[1]
    right = matrix.T @ (right - matrix @ np.full(count, least))
    x, z = np.ones(count), np.ones(count)
    for _ in range(_STEPS):
        gradient = normal @ x - right
        mu = float(x @ z) / count
        if max(mu, float(np.abs(gradient - z).max())) <= _LEFT:
            break
        solve = _factored(normal + diags_array(z / x))
        by_x = solve(-gradient)
        by_z = -z - z * by_x / x
        ahead = (x + _room(x, by_x) * by_x) @ (z + _room(z, by_z) * by_z) / count
        target = mu * (ahead / mu) ** 3 - by_x * by_z
        by_x = solve(target / x - gradient)
        by_z = (target - z * by_x) / x - z
        part = min(_room(x, by_x), _room(z, by_z))
        x, z = x + part * by_x, z + part * by_z
    return x + least


def _damped_normal(matrix: csr_array) -> csc_array:
    normal = (matrix.T @ matrix).tocsc()
    damping = np.full(normal.shape[0], _DAMPING * float(normal.diagonal().mean()))
    return csc_array(normal + diags_array(damping))


def _factored(matrix: csc_array) -> Callable[[FloatArray], FloatArray]:
    solve: Callable[[FloatArray], FloatArray] = splu(
        csc_array(matrix),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    ).solve
    return solve


def _room(values: FloatArray, step: FloatArray) -> float:
    """Part of a step that keeps positive values positive."""
    falling = step < 0
    return min(1.0, _WAY * float((-values[falling] / step[falling]).min(initial=np.inf)))
