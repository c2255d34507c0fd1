"""Sparse Cholesky factorisation by dense blocks, the multifrontal method.

Each part of a nested dissection is eliminated as one dense block, by LAPACK: its own unknowns (the
pivot) and the later unknowns that it touches (the border). What the elimination does to the border
is handed to the part above. The blocks and the places of all numbers in them are found once.

Source: Duff, Reid (1983), The multifrontal solution of indefinite sparse symmetric linear systems;
Liu (1992), The multifrontal method for sparse matrix solution: theory and practice.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from scipy.linalg.blas import dsyrk, dtrsm, dtrsv
from scipy.linalg.lapack import dpotrf

from solver.errors import SingularSystemError
from solver.linear.sparsity import Sparsity
from solver.linear.threads import one_thread
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# Borders that fall into more runs than this are added entry by entry.
_MOST_RUNS = 40

_Run: TypeAlias = tuple[slice | IntArray, slice | IntArray]
_Index: TypeAlias = tuple[slice | IntArray, slice | IntArray]
_Block: TypeAlias = tuple[_Index, _Index]


@dataclass(frozen=True)
class _Child:
    """A front below, and where its update is added: blocks as pairs (there, here).

    Attributes:
        number: of the front.
        to_square: blocks for the pivot's square.
        to_below: blocks for the rows below it.
        to_border: blocks for the front's own update.
    """

    number: int
    to_square: list[_Block]
    to_below: list[_Block]
    to_border: list[_Block]


@dataclass(frozen=True)
class _Front:
    """One dense block.

    Attributes:
        number: its place in the order of elimination.
        begin, end: its pivot among the unknowns.
        border: (b,) later unknowns that it touches, ascending.
        entries: where its entries of the matrix begin and end among all.
        places: their places in the pivot's columns, square part first.
        children: the fronts whose updates go here.
    """

    number: int
    begin: int
    end: int
    border: IntArray
    entries: slice
    places: IntArray
    children: list[_Child]


class Multifrontal:
    """Factors matrices of one sparsity that was numbered by nested dissection.

    Args:
        sparsity: of the lower triangle, with its parts.
    """

    remark = ""

    def __init__(self, sparsity: Sparsity) -> None:
        self._fronts = list(_fronts(sparsity))

    def factor(self, lower: FloatArray) -> Callable[[FloatArray], FloatArray]:
        """Factor the lower triangle (nnz,); return what solves for right sides (n,) or (n, k).

        Raises:
            SingularSystemError: the matrix is not positive definite.
        """
        updates: dict[int, FloatArray] = {}
        factors = []
        with one_thread():
            for front in self._fronts:
                square, below = _pivot(front, lower[front.entries], updates)
                if len(front.border):
                    updates[front.number] = _update(front, below, updates)
                factors.append((front, square, below))
        return lambda right: self._solve(factors, right)

    def _solve(
        self, factors: list[tuple[_Front, FloatArray, FloatArray]], right: FloatArray
    ) -> FloatArray:
        x = np.array(right, dtype=np.float64)
        with one_thread():
            for front, square, below in factors:
                own = _triangular(square, x[front.begin : front.end], 0)
                x[front.begin : front.end] = own
                x[front.border] -= below @ own
            for front, square, below in reversed(factors):
                own = x[front.begin : front.end] - below.T @ x[front.border]
                x[front.begin : front.end] = _triangular(square, own, 1)
        return x


def _triangular(square: FloatArray, right: FloatArray, transposed: int) -> FloatArray:
    """Solve by a lower triangle, or by it transposed, for right sides (n,) or (n, k)."""
    if right.ndim == 1:
        return np.asarray(dtrsv(square, right, lower=1, trans=transposed))
    return np.asarray(dtrsm(1.0, square, right, lower=1, trans_a=transposed))


def _pivot(
    front: _Front, entries: FloatArray, updates: dict[int, FloatArray]
) -> tuple[FloatArray, FloatArray]:
    """Cholesky factor of the pivot, and the rows of the factor below it."""
    width, height = front.end - front.begin, len(front.border)
    panel = np.zeros(width * (width + height))
    panel[front.places] = entries
    square = panel[: width * width].reshape(width, width).T
    below = panel[width * width :].reshape(width, height).T
    for child in front.children:
        update = updates[child.number]
        for target, blocks in ((square, child.to_square), (below, child.to_below)):
            for there, here in blocks:
                target[there] += update[here]
    square, failed = dpotrf(square, lower=1, clean=0, overwrite_a=1)
    if failed:
        raise SingularSystemError(
            "linear system: the matrix is not positive definite; raise the damping"
        )
    if height:
        below = dtrsm(1.0, square, below, side=1, lower=1, trans_a=1, overwrite_b=1)
    return square, below


def _update(front: _Front, below: FloatArray, updates: dict[int, FloatArray]) -> FloatArray:
    """(b, b) what is to be added to the border, lower triangle; takes in that of the children."""
    border: FloatArray = dsyrk(-1.0, below, lower=1)
    for child in front.children:
        update = updates.pop(child.number)
        for there, here in child.to_border:
            border[there] += update[here]
    return border


def _fronts(sparsity: Sparsity) -> Iterator[_Front]:
    """Find the fronts, in the order of elimination."""
    borders: list[IntArray] = []
    below: list[list[int]] = [[] for _ in sparsity.parts[1:]]
    for number, (begin, end) in enumerate(itertools.pairwise(sparsity.parts.tolist())):
        entries = slice(int(sparsity.indptr[begin]), int(sparsity.indptr[end]))
        rows = sparsity.indices[entries]
        touched = np.concatenate([rows, *(borders[child] for child in below[number])])
        border = np.unique(touched[touched >= end])
        column = np.repeat(np.arange(end - begin), np.diff(sparsity.indptr[begin : end + 1]))
        children = [_child(k, borders[k], begin, end, border) for k in below[number]]
        borders.append(border)
        if len(border):
            # The elimination tree: all of the border meets in the part where it begins.
            parent = np.searchsorted(sparsity.parts, border[0], side="right") - 1
            below[parent].append(number)
        places = _places(rows, column, begin, end, border)
        yield _Front(number, begin, end, border, entries, places, children)


def _places(rows: IntArray, column: IntArray, begin: int, end: int, border: IntArray) -> IntArray:
    """Place of each entry in the pivot's columns: the square by columns, then the rows below."""
    width = end - begin
    inside = rows - begin + width * column
    outside = width * width + np.searchsorted(border, rows) + len(border) * column
    return np.where(rows < end, inside, outside)


def _child(number: int, touched: IntArray, begin: int, end: int, border: IntArray) -> _Child:
    """Where the update of a front goes that touches these unknowns."""
    split = int(np.searchsorted(touched, end))
    pivot = _runs(touched[:split] - begin, 0)
    rest = _runs(np.searchsorted(border, touched[split:]), split)
    return _Child(number, _lower(pivot), _rectangles(rest, pivot), _lower(rest))


def _runs(places: IntArray, first: int) -> list[_Run]:
    """Runs of neighbouring places, as (there, here); all in one list where they are many."""
    if not len(places):
        return []
    starts = np.flatnonzero(np.diff(places, prepend=-2, append=-2) != 1)
    if len(starts) > _MOST_RUNS + 1:
        return [(places, np.arange(first, first + len(places)))]
    return [
        (slice(int(places[a]), int(places[a]) + b - a), slice(first + a, first + b))
        for a, b in itertools.pairwise(starts.tolist())
    ]


def _lower(runs: list[_Run]) -> list[_Block]:
    return [block for k, run in enumerate(runs) for block in _rectangles([run], runs[: k + 1])]


def _rectangles(rows: list[_Run], columns: list[_Run]) -> list[_Block]:
    return [
        (_index(row[0], column[0]), _index(row[1], column[1])) for row in rows for column in columns
    ]


def _index(rows: slice | IntArray, columns: slice | IntArray) -> _Index:
    return (rows[:, None] if isinstance(rows, np.ndarray) else rows), columns
