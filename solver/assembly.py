"""Normal equations of a sum of terms: pattern and scatter positions once, numbers every step.

Unknowns are numbered in blocks: three coordinates a vertex, then single shared scalars. Only the
lower triangle of the symmetric matrix is kept.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csc_array

from solver.linear import fill_reducing_order
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Term


@dataclass(frozen=True)
class Pattern:
    """Sparsity of the lower triangle, by column.

    Attributes:
        indptr: (n + 1,) start of each column.
        indices: (nnz,) row numbers, ascending in each column, the diagonal first.
        unknowns: (n,) position in the flat vector of each row of the matrix.
    """

    indptr: IntArray
    indices: IntArray
    unknowns: IntArray

    @property
    def size(self) -> int:
        """Number n of free unknowns."""
        return len(self.unknowns)


@dataclass(frozen=True)
class _Group:
    """Terms whose elements have the same unknowns, stacked so that their blocks add up early."""

    members: tuple[int, ...]
    rows: IntArray
    scatter: IntArray
    first: IntArray
    second: IntArray


class NormalEquations:
    """Assembles J^T W J and J^T W r for fixed stencils.

    Args:
        terms: the terms, in the order in which weights and linearisations are given later.
        free: (N,) true for unknowns that may move; the others are eliminated.
    """

    def __init__(self, terms: Sequence[Term], free: BoolArray) -> None:
        self.terms = tuple(terms)
        numbering, self.pattern = _pattern(self.terms, free)
        self._groups = [
            _group(members, self.terms[members[0]].unknowns, numbering, self.pattern)
            for members in _alike(self.terms)
        ]
        self._constant: dict[int, FloatArray] = {}

    def matrix(self, linearisations: Sequence[Linearisation], weights: FloatArray) -> FloatArray:
        """(nnz,) lower triangle of the sum of ``weight * J^T J``."""
        data = np.zeros(len(self.pattern.indices))
        for group in self._groups:
            used = tuple(k for k in group.members if weights[k] > 0)
            moving = tuple(k for k in used if not self.terms[k].linear)
            if moving:
                jacobian = np.concatenate(
                    [np.sqrt(weights[k]) * linearisations[k].jacobian for k in moving], axis=1
                )
                data += self._scattered(group, jacobian)
            for k in used:
                if self.terms[k].linear:
                    data += weights[k] * self._constant_part(group, k, linearisations[k].jacobian)
        return data

    def gradient(self, linearisations: Sequence[Linearisation], weights: FloatArray) -> FloatArray:
        """(n,) the sum of ``weight * J^T r`` over the free unknowns."""
        size = self.pattern.size
        total = np.zeros(size + 1)
        for group in self._groups:
            used = [k for k in group.members if weights[k] > 0]
            if used:
                part = sum(
                    weights[k]
                    * np.einsum(
                        "nm,nmk->nk", linearisations[k].residual, linearisations[k].jacobian
                    )
                    for k in used
                )
                total += np.bincount(group.rows, np.ravel(part), minlength=size + 1)
        return total[:size]

    def _constant_part(self, group: _Group, k: int, jacobian: FloatArray) -> FloatArray:
        if k not in self._constant:
            self._constant[k] = self._scattered(group, np.asarray(jacobian))
        return self._constant[k]

    def _scattered(self, group: _Group, jacobian: FloatArray) -> FloatArray:
        blocks = np.einsum("nmp,nmp->np", jacobian[:, :, group.first], jacobian[:, :, group.second])
        size = len(self.pattern.indices)
        sums = np.bincount(group.scatter, blocks.ravel(), minlength=size + 1)
        return sums[:size].astype(np.float64, copy=False)


def _alike(terms: Sequence[Term]) -> list[tuple[int, ...]]:
    groups: list[list[int]] = []
    for k, term in enumerate(terms):
        for group in groups:
            if np.array_equal(terms[group[0]].unknowns, term.unknowns):
                group.append(k)
                break
        else:
            groups.append([k])
    return [tuple(group) for group in groups]


def _pattern(terms: Sequence[Term], free: BoolArray) -> tuple[IntArray, Pattern]:
    """Number the free unknowns to reduce fill, and find which pairs of them meet in an element."""
    count = len(free)
    rows, columns = [np.arange(count)], [np.arange(count)]
    for term in terms:
        unknowns = term.unknowns
        element = np.repeat(np.arange(len(unknowns)), unknowns.shape[1])
        incidence = coo_array(
            (np.ones(unknowns.size, dtype=np.int32), (element, unknowns.ravel())),
            shape=(len(unknowns), count),
        ).tocsr()
        meets = (incidence.T @ incidence).tocoo()
        rows.append(meets.row)
        columns.append(meets.col)
    row, column = np.concatenate(rows), np.concatenate(columns)
    graph = csc_array((np.ones(len(row)), (row, column)), shape=(count, count))
    graph = graph[free][:, free]
    kept = np.flatnonzero(free)[fill_reducing_order(graph)]
    numbering = np.full(count, -1, dtype=np.int64)
    numbering[kept] = np.arange(len(kept))
    row, column = numbering[row], numbering[column]
    lower = (row >= column) & (column >= 0)
    matrix = csc_array(
        (np.ones(int(lower.sum())), (row[lower], column[lower])), shape=(len(kept), len(kept))
    )
    matrix.sum_duplicates()
    matrix.sort_indices()
    pattern = Pattern(matrix.indptr.astype(np.int64), matrix.indices.astype(np.int64), kept)
    return numbering, pattern


def _group(
    members: tuple[int, ...], unknowns: IntArray, numbering: IntArray, pattern: Pattern
) -> _Group:
    size, entries = pattern.size, len(pattern.indices)
    number = numbering[unknowns]
    first, second = np.triu_indices(unknowns.shape[1])
    one, two = number[:, first], number[:, second]
    row, column = np.maximum(one, two), np.minimum(one, two)
    column_of_entry = np.repeat(np.arange(size), np.diff(pattern.indptr))
    keys = column_of_entry * size + pattern.indices
    place = np.searchsorted(keys, column * size + row)
    scatter = np.where(column >= 0, place, entries)
    rows = np.where(number >= 0, number, size)
    return _Group(members, rows.ravel(), scatter.ravel(), first, second)
