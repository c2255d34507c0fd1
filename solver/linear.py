"""Sparse symmetric systems whose pattern never changes.

The analysis of the pattern is done once; each call factors new numbers. The package ``rslab`` is
used where it can be imported, otherwise SuperLU from scipy.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol

import numpy as np
from scipy.sparse import csc_array
from scipy.sparse.linalg import splu

from solver.errors import InputError, OrthoError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    from solver.pattern import Pattern

BACKENDS = ("rslab", "scipy")


class SingularSystemError(OrthoError):
    """The matrix could not be factored."""


class SymmetricSolver(Protocol):
    """Solves A x = b for matrices of one pattern."""

    def factor(self, lower: FloatArray) -> Callable[[FloatArray], FloatArray]:
        """Factor the lower triangle (nnz,); return the function that solves for right sides (n,).

        Raises:
            SingularSystemError: the matrix cannot be factored.
        """


def symmetric_solver(pattern: Pattern, backend: str | None = None) -> SymmetricSolver:
    """Return the fastest solver that is installed, or the one that ``backend`` names.

    Raises:
        InputError: the named backend is unknown or not installed.
    """
    if backend is None:
        backend = default_backend()
    if backend not in BACKENDS:
        raise InputError(f"sparse solver: expected one of {', '.join(BACKENDS)}, got '{backend}'")
    if backend == "rslab" and not _rslab_installed():
        raise InputError("sparse solver: rslab is not installed; pip install rslab, or use scipy")
    return _Rslab(pattern) if backend == "rslab" else _SuperLU(pattern)


def default_backend() -> str:
    """Name of the solver used when none is asked for."""
    return "rslab" if _rslab_installed() else "scipy"


def fill_reducing_order(graph: csc_array) -> IntArray:
    """(n,) order of the unknowns in which a factorisation of the pattern fills in little."""
    size = graph.shape[0]
    if size == 0:
        return np.zeros(0, dtype=np.int64)
    # Any positive definite matrix with this pattern will do: only its ordering is used.
    dominant = (graph != 0).astype(np.float64) * -1.0
    diagonal = np.arange(size)
    strong = csc_array((np.full(size, 2.0 * size), (diagonal, diagonal)), shape=(size, size))
    dominant = csc_array(dominant + strong)
    factors = splu(
        dominant,
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    return np.argsort(factors.perm_c)


def _rslab_installed() -> bool:
    return importlib.util.find_spec("rslab") is not None


class _SuperLU:
    """SuperLU in its symmetric mode; the pattern already comes in a fill-reducing order."""

    def __init__(self, pattern: Pattern) -> None:
        size = pattern.size
        row = pattern.indices
        column = np.repeat(np.arange(size), np.diff(pattern.indptr))
        entry = np.arange(len(row))
        inner = row != column
        full = csc_array(
            (
                np.concatenate([entry, entry[inner]]) + 1.0,
                (
                    np.concatenate([row, column[inner]]),
                    np.concatenate([column, row[inner]]),
                ),
            ),
            shape=(size, size),
        )
        full.sort_indices()
        self._gather = full.data.astype(np.int64) - 1
        self._matrix = full

    def factor(self, lower: FloatArray) -> Callable[[FloatArray], FloatArray]:
        self._matrix.data = lower[self._gather]
        try:
            factors = splu(
                self._matrix,
                permc_spec="NATURAL",
                diag_pivot_thresh=0.0,
                options={"SymmetricMode": True},
            )
        except RuntimeError as error:
            raise SingularSystemError(f"linear system: {error}; raise the damping") from error
        return lambda right: np.asarray(factors.solve(right))


class _Rslab:
    """LDL^T of the package rslab, whose symbolic analysis is done once."""

    def __init__(self, pattern: Pattern) -> None:
        import rslab

        size = pattern.size
        matrix = csc_array(
            (np.ones(len(pattern.indices)), pattern.indices, pattern.indptr), shape=(size, size)
        )
        self._symbolic = rslab.analyze(matrix, path="ldlt")

    def factor(self, lower: FloatArray) -> Callable[[FloatArray], FloatArray]:
        factors = self._symbolic.factor(lower)
        return lambda right: np.asarray(factors.solve(right))
