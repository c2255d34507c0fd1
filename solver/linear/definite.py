"""Sparse positive definite matrices, factored many times, whose unknowns lie in space."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.sparse import csc_array

from solver.linear.dissection import dissect
from solver.linear.multifrontal import Multifrontal
from solver.linear.sparsity import Sparsity
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray


class DefiniteSolver:
    """Factors symmetric matrices that have entries where one of them has.

    Args:
        matrix: (n, n) one of them, indices sorted; its values do not matter.
        places: (n, 3) where the unknowns are; neighbours near each other best.
    """

    def __init__(self, matrix: csc_array, places: FloatArray) -> None:
        count = matrix.shape[0]
        self._order, parts = dissect(matrix, places, np.ones(count, dtype=np.int64))
        numbered = csc_array(
            (np.arange(matrix.nnz), matrix.indices, matrix.indptr), shape=matrix.shape
        )
        numbered = csc_array(numbered[self._order][:, self._order])
        numbered.sort_indices()
        column = np.repeat(np.arange(count), np.diff(numbered.indptr))
        lower = numbered.indices >= column
        indptr = np.concatenate([[0], np.bincount(column[lower], minlength=count).cumsum()])
        indices: IntArray = numbered.indices[lower].astype(np.int64)
        self._entries: IntArray = numbered.data[lower]
        self._blocks = Multifrontal(Sparsity(indptr, indices, self._order, parts))

    def factor(self, matrix: csc_array) -> Callable[[FloatArray], FloatArray]:
        """Factor a matrix; return the function that solves for right sides (n,) or (n, k).

        Raises:
            SingularSystemError: the matrix is not positive definite.
        """
        solve = self._blocks.factor(matrix.data[self._entries])

        def solved(right: FloatArray) -> FloatArray:
            found = np.empty_like(right, dtype=np.float64)
            found[self._order] = solve(right[self._order])
            return found

        return solved
