"""Normal equations of a sum of terms: sparsity and scatter positions once, numbers every step.

Only the lower triangle of the symmetric matrix is kept. How the sparsity is found and numbered is
:mod:`solver.linear.sparsity`'s business.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from solver.linear.sparsity import Numbering, Sparsity
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Term

# Elements handled at once: their blocks stay in the processor's cache.
_CHUNK = 4096


@dataclass(frozen=True)
class _Group:
    """Terms whose elements have the same unknowns, stacked so that their blocks add up early."""

    members: tuple[int, ...]
    rows: IntArray
    scatter: IntArray


class NormalEquations:
    """Assembles J^T W J and J^T W r for fixed stencils.

    Args:
        terms: the terms, in the order in which weights and linearisations are given later.
        free: (N,) true for unknowns that may move; the others are eliminated.
        points: (V, 3) where the vertices are about, to number the unknowns by; the first 3 V
            unknowns are coordinates, the others shared scalars.
        reorder: number the unknowns so that a factorisation fills in little.
        used: whether each term may weigh anything; wide stencils of those that never do would fill
            the matrix with zeros. By default all may.
    """

    def __init__(
        self,
        terms: Sequence[Term],
        free: BoolArray,
        points: FloatArray,
        reorder: bool = True,
        used: Sequence[bool] | None = None,
    ) -> None:
        self.terms = tuple(terms)
        self._unused = [k for k in range(len(terms)) if used is not None and not used[k]]
        members = _alike(self.terms)
        members = [group for group in members if not set(group) <= set(self._unused)]
        stencils = [self.terms[group[0]].unknowns for group in members]
        numbering = Numbering(stencils, free, points, reorder)
        self.sparsity: Sparsity = numbering.sparsity
        self._groups = [
            _group(group, unknowns, numbering)
            for group, unknowns in zip(members, stencils, strict=True)
        ]
        self._constant: dict[int, FloatArray] = {}
        # Kept: memory that is new costs more than what is written into it.
        self._entries = np.empty(len(self.sparsity.indices))
        self._products = np.empty(sum(len(group.scatter) for group in self._groups))
        self._together: dict[tuple[tuple[int, ...], ...], IntArray] = {}

    def matrix(self, linearisations: Sequence[Linearisation], weights: FloatArray) -> FloatArray:
        """(nnz,) lower triangle of the sum of ``weight * J^T J``."""
        assert not weights[self._unused].any(), "a term weighs something that has no place"
        constants, moved = [], []
        for group in self._groups:
            used = tuple(k for k in group.members if weights[k] > 0)
            moving = tuple(k for k in used if not self.terms[k].linear)
            if moving:
                parts = [_weighted(linearisations[k].jacobian, weights[k]) for k in moving]
                moved.append(
                    (group, parts[0] if len(parts) == 1 else np.concatenate(parts, axis=1))
                )
            for k in used:
                if self.terms[k].linear:
                    constant = self._constant_part(group, k, linearisations[k].jacobian)
                    constants.append((constant, weights[k]))
        data = self._scattered(moved)
        for constant, weight in constants:
            data += np.multiply(constant, weight, out=self._entries)
        return data

    def gradient(self, linearisations: Sequence[Linearisation], weights: FloatArray) -> FloatArray:
        """(n,) the sum of ``weight * J^T r`` over the free unknowns."""
        size = self.sparsity.size
        total = np.zeros(size + 1)
        for group in self._groups:
            used = [k for k in group.members if weights[k] > 0]
            if used:
                part = sum(
                    weights[k] * _transposed_product(linearisations[k], self.terms[k].linear)
                    for k in used
                )
                total += np.bincount(group.rows, np.ravel(part), minlength=size + 1)
        return total[:size]

    def _constant_part(self, group: _Group, k: int, jacobian: FloatArray) -> FloatArray:
        if k not in self._constant:
            self._constant[k] = self._scattered([(group, jacobian)])
        return self._constant[k]

    def _scattered(self, parts: Sequence[tuple[_Group, FloatArray]]) -> FloatArray:
        """(nnz,) the sum of J^T J over the elements of groups, in one go for all of them."""
        end, entries = 0, len(self.sparsity.indices)
        for group, jacobian in parts:
            begin, end = end, end + len(group.scatter)
            count, _, width = jacobian.shape
            blocks = self._products[begin:end].reshape(width * (width + 1) // 2, count)
            for first in range(0, count, _CHUNK):
                chunk = slice(first, first + _CHUNK)
                columns = np.ascontiguousarray(jacobian[chunk].transpose(1, 2, 0))
                _multiply_columns(columns, blocks[:, chunk])
        scatter = self._scatter(tuple(group.members for group, _ in parts))
        sums = np.bincount(scatter, self._products[:end], minlength=entries + 1)
        return sums[:entries].astype(np.float64, copy=False)

    def _scatter(self, groups: tuple[tuple[int, ...], ...]) -> IntArray:
        """Where the products of groups, named by their members, are summed up."""
        if groups not in self._together:
            chosen = [group.scatter for group in self._groups if group.members in groups]
            none = np.empty(0, dtype=np.intp)
            self._together[groups] = (
                chosen[0] if len(chosen) == 1 else np.concatenate([none, *chosen])
            )
        return self._together[groups]


def _multiply_columns(columns: FloatArray, products: FloatArray) -> None:
    """Fill in the upper triangle (p, n), row by row, of J^T J for Jacobians (m, k, n).

    The elements come last, so that each operation runs over many at once.
    """
    width, first = columns.shape[1], 0
    for k in range(width):
        target = products[first : first + width - k]
        np.multiply(columns[0, k], columns[0, k:], out=target)
        for row in columns[1:]:
            target += row[k] * row[k:]
        first += width - k


def _weighted(jacobian: FloatArray, weight: float) -> FloatArray:
    return jacobian if weight == 1.0 else np.sqrt(weight) * jacobian


def _transposed_product(linearisation: Linearisation, linear: bool) -> FloatArray:
    """(n, k) the product J^T r of each element."""
    residual, jacobian = linearisation
    if linear and len(jacobian):
        # All elements of a linear term share one small Jacobian.
        return np.asarray(residual @ jacobian[0])
    return np.asarray(np.einsum("nm,nmk->nk", residual, jacobian))


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


def _group(members: tuple[int, ...], unknowns: IntArray, numbering: Numbering) -> _Group:
    first, second = np.triu_indices(unknowns.shape[1])
    return _Group(
        members=members,
        rows=numbering.rows(unknowns).ravel(),
        scatter=numbering.positions(unknowns, first, second).T.ravel(),
    )
