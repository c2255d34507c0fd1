"""Normal equations of one matrix with many weights."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array, csc_array, csr_array

from solver.mesh.quadmesh import FloatArray


class WeightedSquares:
    """M^T W M of one matrix M and diagonal weights W: entries are sums of these.

    Args:
        matrix: M (m, n), a few entries a row.
    """

    def __init__(self, matrix: csr_array) -> None:
        height, width = matrix.shape
        counts = np.diff(matrix.indptr)
        row = np.repeat(np.arange(height), counts)
        partners = counts[row]
        one = np.repeat(np.arange(matrix.nnz), partners)
        ends = np.cumsum(partners)
        two = np.arange(len(one)) - np.repeat(ends - partners - matrix.indptr[row], partners)
        keys = matrix.indices[two].astype(np.int64) * width + matrix.indices[one]
        kept, entry = np.unique(keys, return_inverse=True)
        products = matrix.data[one] * matrix.data[two]
        self._sums = coo_array((products, (entry, row[one])), shape=(len(kept), height)).tocsr()
        self._indices = kept % width
        self._indptr = np.searchsorted(kept, width * np.arange(width + 1))

    def of(self, weights: FloatArray) -> csc_array:
        """The symmetric matrix (n, n) for weights (m,); its entries are always in the same places.

        Indices are sorted.
        """
        count = len(self._indptr) - 1
        data = self._sums @ weights
        return csc_array((data, self._indices, self._indptr), shape=(count, count))
