"""The library rslab, as it is called in its own process."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.sparse import csc_array

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray


class RslabFactors:
    """LDL^T factors of matrices of one sparsity, analysed once; one matrix at a time.

    Args:
        indptr: (n + 1,) start of each column of the lower triangle.
        indices: (nnz,) its row numbers.
    """

    def __init__(self, indptr: IntArray, indices: IntArray) -> None:
        import rslab

        size = len(indptr) - 1
        matrix = csc_array((np.ones(len(indices)), indices, indptr), shape=(size, size))
        self._symbolic = rslab.analyze(matrix, path="ldlt")
        self._factors: Any = None

    def factor(self, lower: FloatArray) -> bool:
        """Factor the lower triangle (nnz,); False where it is singular."""
        try:
            self._factors = self._symbolic.factor(lower)
        except RuntimeError:
            # So the library says that the rank is too small.
            return False
        return True

    def solve(self, right: FloatArray) -> FloatArray:
        """Solve for a right side (n,) with the matrix that was factored last."""
        return np.asarray(self._factors.solve(right))
