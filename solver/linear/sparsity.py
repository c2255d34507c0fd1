"""Sparsity of the normal equations, found and numbered block by block.

A bundle is the unknowns of a vertex, its three coordinates, or one shared scalar. Bundles that meet
in an element share a dense block. Working with bundles makes the set-up an order of magnitude
cheaper than working with single unknowns.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csc_array

from solver.linear.dissection import dissect
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True)
class Sparsity:
    """Sparsity of the lower triangle, by column.

    Attributes:
        indptr: (n + 1,) start of each column.
        indices: (nnz,) row numbers, ascending in each column, the diagonal first.
        unknowns: (n,) position in the flat vector of each row of the matrix.
        parts: (p + 1,) where the parts of a nested dissection begin, and n; one part where the
            unknowns were left in their own order.
    """

    indptr: IntArray
    indices: IntArray
    unknowns: IntArray
    parts: IntArray

    @property
    def size(self) -> int:
        """Number n of free unknowns."""
        return len(self.unknowns)


class Numbering:
    """Where each unknown and each pair of unknowns is kept.

    Args:
        stencils: arrays (n, k) of unknowns that meet in elements.
        free: (N,) true for unknowns that may move.
        points: (V, 3) where the vertices are about; unknown 3 v + c is coordinate c of vertex v,
            from 3 V on come scalars.
        reorder: order the bundles so that a factorisation fills in little.
    """

    def __init__(
        self, stencils: Sequence[IntArray], free: BoolArray, points: FloatArray, reorder: bool
    ) -> None:
        unknown = np.arange(len(free))
        vertex_count = len(points)
        coordinates = 3 * vertex_count
        self._bundle = np.where(
            unknown < coordinates, unknown // 3, unknown - coordinates + vertex_count
        )
        count = vertex_count + len(free) - coordinates
        graph = _meeting([self._bundle[stencil] for stencil in stencils], count)
        order, begins = np.arange(count), np.array([0, count])
        if reorder:
            weights = np.bincount(self._bundle, free, count).astype(np.int64)
            order, begins = dissect(graph, _places(graph, points), weights)
        self._rank = np.empty(count, dtype=np.int64)
        self._rank[order] = np.arange(count)
        self._free = free
        self._number_unknowns(free)
        self._lay_out(graph, np.unique(self._first[begins]))

    def rows(self, unknowns: IntArray) -> IntArray:
        """Row of the matrix of each unknown; the number of rows for those that are fixed."""
        return np.where(self._free[unknowns], self._number[unknowns], self.sparsity.size)

    def positions(self, unknowns: IntArray, first: IntArray, second: IntArray) -> IntArray:
        """(n, p) place among the entries of each pair of columns; nnz where one is fixed."""
        entries = len(self.sparsity.indices)
        result = np.empty((len(unknowns), len(first)), dtype=np.int64)
        blocks: dict[tuple[int, int], tuple[IntArray, IntArray]] = {}
        slots = self._slots(unknowns)
        for pair, (a, b) in enumerate(zip(first, second, strict=True)):
            one, two = unknowns[:, a], unknowns[:, b]
            key = (slots[a], slots[b])
            if key not in blocks:
                blocks[key] = self._block(
                    self._rank[self._bundle[one]], self._rank[self._bundle[two]]
                )
            column_bundle, offset = blocks[key]
            swap = self._number[one] < self._number[two]
            row_local = np.where(swap, self._local[two], self._local[one])
            column_local = np.where(swap, self._local[one], self._local[two])
            place = self._column_start(column_bundle, column_local) + offset + row_local
            both = self._free[one] & self._free[two]
            result[:, pair] = np.where(both, place - column_local, entries)
        return result

    def _slots(self, unknowns: IntArray) -> list[int]:
        """First column of the run of columns that belong to the same bundle as each column."""
        slots = [0]
        for k in range(1, unknowns.shape[1]):
            same = np.array_equal(self._bundle[unknowns[:, k]], self._bundle[unknowns[:, k - 1]])
            slots.append(slots[-1] if same else k)
        return slots

    def _number_unknowns(self, free: BoolArray) -> None:
        """Number the free unknowns bundle by bundle, in the order of the bundles."""
        by_bundle = np.lexsort((np.arange(len(free)), self._rank[self._bundle]))
        kept = by_bundle[free[by_bundle]]
        self._number = np.full(len(free), -1, dtype=np.int64)
        self._number[kept] = np.arange(len(kept))
        rank = self._rank[self._bundle[kept]]
        self._size = np.bincount(rank, minlength=len(self._rank))
        self._first = np.concatenate([[0], np.cumsum(self._size)])
        self._local = np.full(len(free), 0, dtype=np.int64)
        self._local[kept] = np.arange(len(kept)) - self._first[rank]
        self._kept = kept

    def _lay_out(self, graph: csc_array, parts: IntArray) -> None:
        """Expand the blocks of the lower triangle into entries, column by column."""
        count = len(self._rank)
        column = self._rank[np.repeat(np.arange(count), np.diff(graph.indptr))]
        row = self._rank[graph.indices]
        lower = (row >= column) & (self._size[row] > 0) & (self._size[column] > 0)
        key = np.sort(column[lower] * count + row[lower])
        self._keys, bundle_column, bundle_row = key, key // count, key % count
        height = self._size[bundle_row]
        above = np.cumsum(height) - height
        begins = np.searchsorted(bundle_column, np.arange(count))
        starts = np.concatenate([above, [height.sum()]])[begins]
        self._offset = above - starts[bundle_column]
        self._height = np.bincount(bundle_column, height, minlength=count).astype(np.int64)
        width = self._size
        per_bundle = width * self._height - width * (width - 1) // 2
        self._base = np.cumsum(per_bundle) - per_bundle
        self.sparsity = self._sparsity(bundle_column, bundle_row, parts)

    def _sparsity(self, bundle_column: IntArray, bundle_row: IntArray, parts: IntArray) -> Sparsity:
        size = len(self._kept)
        bundle = self._rank[self._bundle[self._kept]]
        local = self._local[self._kept]
        indptr = np.zeros(size + 1, dtype=np.int64)
        indptr[:-1] = self._column_start(bundle, local)
        if size:
            indptr[-1] = indptr[-2] + self._height[bundle[-1]] - local[-1]
        indices = np.empty(indptr[-1], dtype=np.int64)
        for c in range(3):
            for r in range(3):
                has = (self._size[bundle_column] > c) & (self._size[bundle_row] > r)
                has &= (bundle_row > bundle_column) | (r >= c)
                j, i = bundle_column[has], bundle_row[has]
                indices[self._column_start(j, c) + self._offset[has] + r - c] = self._first[i] + r
        return Sparsity(indptr, indices, self._kept, parts)

    def _column_start(self, bundle: IntArray, local: IntArray | int) -> IntArray:
        """First entry of column ``local`` of a bundle; each column is one entry shorter."""
        before = local * self._height[bundle] - local * (local - 1) // 2
        return np.asarray(self._base[bundle] + before)

    def _block(self, one: IntArray, two: IntArray) -> tuple[IntArray, IntArray]:
        """Bundle of the column and offset of the block in it, for pairs of bundles."""
        column, row = np.minimum(one, two), np.maximum(one, two)
        if not len(self._keys):
            return column, np.zeros_like(column)
        place = np.searchsorted(self._keys, column * len(self._rank) + row)
        return column, self._offset[np.minimum(place, len(self._offset) - 1)]


def _meeting(stencils: Sequence[IntArray], count: int) -> csc_array:
    """Which bundles meet in an element, each with itself included."""
    diagonal = np.arange(count)
    total = csc_array((np.ones(count, dtype=np.int8), (diagonal, diagonal)), shape=(count, count))
    for bundles in stencils:
        element = np.repeat(np.arange(len(bundles)), bundles.shape[1])
        incidence = coo_array(
            (np.ones(bundles.size, dtype=np.int32), (element, bundles.ravel())),
            shape=(len(bundles), count),
        ).tocsr()
        incidence.data[:] = 1
        meets = (incidence.T @ incidence).tocsc()
        meets.data = np.ones_like(meets.data)
        total = total + meets
    total.sort_indices()
    return total


def _places(graph: csc_array, points: FloatArray) -> FloatArray:
    """(n, 3) a place for every bundle; scalars are put amid the vertices that they meet."""
    count = len(points)
    meets = graph[:count, count:] != 0
    met = np.maximum(meets.sum(axis=0), 1)
    return np.concatenate([points, (meets.T @ points) / met[:, None]])
