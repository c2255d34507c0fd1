"""Is a mesh a multi-net? The largest violation of Eq. 1 over all parameter rectangles.

There are M^2 N^2 / 4 rectangles. Most of them are never visited: for two lines j, l the violations
of all rectangles between them are the entries of an antisymmetric matrix of rank eight or less,

    R_ik = |v_kl - v_ij|^2 - |v_kj - v_il|^2
         = (f_k - f_i) - 2 (v_kl . v_ij - v_kj . v_il),    f_k = |v_kl|^2 - |v_kj|^2,

that is R = B C B^T with the rows B_i = (1, f_i, v_ij, v_il) and one constant antisymmetric C:

    B_i C B_k^T = f_k - f_i - 2 v_ij . v_kl + 2 v_il . v_kj.

With B = Q T, Q of orthonormal columns, R = Q D Q^T, D = T C T^T, and by Cauchy-Schwarz
|R_ik| <= |Q_i D| |Q_k| for every entry. The bounds of all pairs of lines cost O(N^2 M) operations.
They are free of cancellation: the numbers in D are as small as the violations are, to rounding.
Only pairs whose bound exceeds the worst violation found so far are visited, worst bound first, so
the result is the exact maximum. Where all bounds are at rounding level there is nothing to find,
and the bound itself is the certificate.

Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, equation 1.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.grid import grid_of
from solver.mesh.mirror import size_of
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Bounds below this, in parts of size^2, are rounding: a visit would measure the arithmetic.
_ROUNDING = 5e-14
_NUMBERS_AT_ONCE = 2_000_000


@dataclass(frozen=True)
class MultiNetResidual:
    """Largest violation of Eq. 1, in parts of the squared size of the mesh.

    Attributes:
        worst: largest violation among the rectangles visited; the largest of all of them wherever
            it exceeds 5e-14.
        bound: proven: no rectangle of the mesh violates Eq. 1 by more.
        rectangle: grid places (i, j, k, l) of the corners v_ij and v_kl of the worst rectangle.
        visited: pairs of lines whose rectangles were visited, one by one.
    """

    worst: float
    bound: float
    rectangle: tuple[int, int, int, int]
    visited: int


def multi_net_residual(mesh: QuadMesh) -> MultiNetResidual:
    """Largest ``abs(|v_kl - v_ij|^2 - |v_kj - v_il|^2)`` over all rectangles / size^2.

    The size is the diagonal of the bounding box.

    Raises:
        InputError: the mesh is not of grid type.
    """
    return multi_net_residual_of(grid_of(mesh).points(mesh))


def multi_net_residual_of(points: FloatArray) -> MultiNetResidual:
    """The same for an (M, N, 3) grid of points."""
    flat = points.reshape(-1, 3)
    points = (points - flat.mean(axis=0)) / size_of(flat)
    transposed = points.shape[1] > points.shape[0]
    if transposed:
        points = points.transpose(1, 0, 2)
    first, second = np.triu_indices(points.shape[1], 1)
    bounds = _bounds(points, first, second)
    worst, place, visited = 0.0, (0, 0, 1, 1), 0
    for pair in np.argsort(-bounds):
        if visited and bounds[pair] <= max(worst, _ROUNDING):
            break
        visited += 1
        j, line = int(first[pair]), int(second[pair])
        entries = np.abs(_violations(points[:, j], points[:, line]))
        i, k = np.unravel_index(int(np.argmax(entries)), entries.shape)
        if entries[i, k] > worst:
            worst, place = float(entries[i, k]), (int(i), j, int(k), line)
    rest = float(np.sort(bounds)[::-1][visited]) if visited < len(bounds) else 0.0
    if transposed:
        place = (place[1], place[0], place[3], place[2])
    return MultiNetResidual(worst, max(worst, rest), place, visited)


def is_multi_net(mesh: QuadMesh, tolerance: float = 1e-10) -> bool:
    """Whether no rectangle violates Eq. 1 by more than ``tolerance`` times the squared size.

    Raises:
        InputError: the mesh is not of grid type.
    """
    return multi_net_residual(mesh).worst <= max(tolerance, _ROUNDING)


def _violations(one: FloatArray, two: FloatArray) -> FloatArray:
    """(M, M) entry (i, k): the violation of the rectangle of lines ``one`` and ``two``.

    By differences of points, not by the expanded form, so that no digit is lost.
    """
    across = one[:, None] - two[None, :]
    squares = np.einsum("ikx,ikx->ik", across, across)
    return np.asarray(squares - squares.T)


def _bounds(points: FloatArray, first: IntArray, second: IntArray) -> FloatArray:
    """(P,) a bound on the violations between each pair of lines."""
    lines = points.transpose(1, 0, 2)
    squares = np.einsum("jix,jix->ji", lines, lines)
    constant = np.zeros((8, 8))
    constant[0, 1], constant[1, 0] = 1.0, -1.0
    constant[2:5, 5:8], constant[5:8, 2:5] = -2 * np.eye(3), 2 * np.eye(3)
    result = np.empty(len(first))
    step = max(1, _NUMBERS_AT_ONCE // (8 * lines.shape[1]))
    for start in range(0, len(first), step):
        one, two = first[start : start + step], second[start : start + step]
        ones = np.ones((len(one), lines.shape[1], 1))
        f = (squares[two] - squares[one])[..., None]
        rows = np.concatenate([ones, f, lines[one], lines[two]], axis=2)
        q, t = np.linalg.qr(rows)
        small = t @ constant @ t.transpose(0, 2, 1)
        left = np.linalg.norm(q @ small, axis=2).max(axis=1)
        result[start : start + step] = left * np.linalg.norm(q, axis=2).max(axis=1)
    return result
