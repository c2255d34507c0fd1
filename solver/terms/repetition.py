"""Parts in kinds: panels and edges keep the lengths, nodes the angles, of the shape of their kind.

The shapes are not given: each is the mean of its own parts, and parts change to the kind that they
are nearest to after every step. Both lower the energy, as they do in clustering by k-means.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, coordinates_of, points_of
from solver.terms.stencils import Elements

_Term = TypeVar("_Term", bound="_Repeated")
# Edges shorter than this, in mean edges, have no direction.
_SHORT = 1e-12


@dataclass(frozen=True, eq=False)
class _Repeated(Elements):
    """Base of terms that draw parts to the shapes of their kinds.

    Args:
        groups: (n, k) vertices of each part.
        turns: (t, m) orders in which its m points may lie on those of a shape.
        shapes: (K, p) values of each kind, such as distances between all pairs of points.
        stress: (n,) factors of the parts' residuals.
        kind: (n,) kind of each part, None where they are still to be sorted.
        turn: (n,) number of the order in which it lies on the shape of its kind.
        settled: parts keep their kinds, and only shapes follow.
        shared: (K, p) positions of the shapes' values in the flat vector, where they are unknowns
            and not means.
    """

    groups: IntArray
    turns: IntArray
    shapes: FloatArray
    stress: FloatArray
    kind: IntArray | None = None
    turn: IntArray | None = None
    settled: bool = False
    shared: IntArray | None = None

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 3 k) coordinates of the vertices of each part, behind them those of its shape."""
        if self.shared is None:
            return self.coordinates
        return np.hstack([self.coordinates, self._owned(self.shared)])

    @cached_property
    def coordinates(self) -> IntArray:
        """(n, 3 k) places of the coordinates of each part."""
        return coordinates_of(self.groups)

    @cached_property
    def orders(self) -> IntArray:
        """(t, p) places of a part's values in the order of the shape, for each turn."""
        count = self.turns.shape[1]
        place = np.zeros((count, count), dtype=np.int64)
        i, j = np.triu_indices(count, 1)
        place[i, j] = place[j, i] = np.arange(len(i))
        return place[self.turns[:, i], self.turns[:, j]]

    @cached_property
    def wanted(self) -> FloatArray:
        """(n, p) values of each part's shape in the part's own order."""
        return self._owned(self.shapes)

    def _owned(self, values: NDArray[Any]) -> NDArray[Any]:
        """What belongs to shapes (K, p), for each part in its own order (n, p)."""
        assert self.kind is not None and self.turn is not None
        owned = np.empty((len(self.groups), values.shape[1]), dtype=values.dtype)
        np.put_along_axis(owned, self.orders[self.turn], values[self.kind], axis=1)
        return owned

    def _finished(self, x: FloatArray, values: FloatArray, by: FloatArray) -> Linearisation:
        """Residuals of values (n, p), and derivatives (n, p, 3 k), those by shapes behind them."""
        wanted = self.wanted if self.shared is None else x[self._owned(self.shared)]
        residual = self.stress[:, None] * (values - wanted)
        if self.shared is None:
            return Linearisation(residual, by)
        by_shape = -self.stress[:, None, None] * np.eye(values.shape[1])
        return Linearisation(residual, np.concatenate([by, by_shape], axis=2))

    def values(self, x: FloatArray) -> FloatArray:
        """(n, p) values of each part at ``x``."""
        raise NotImplementedError

    def sorted(self: _Term, x: FloatArray) -> _Term:
        """Put every part into the kind that it is nearest to."""
        values = self.values(x)
        if self.settled or self.shared is not None:
            return self
        turned = values[:, self.orders]
        # The square of the distance but for that of the part's own values.
        away = (self.shapes**2).sum(axis=1) - 2 * turned @ self.shapes.T
        best = away.reshape(len(values), -1).argmin(axis=1)
        turn, kind = np.divmod(best, len(self.shapes))
        return replace(self, kind=kind, turn=turn)

    def follow(self: _Term, x: FloatArray) -> _Term:
        """Sort the parts at the current shape, and make the shapes the means of their parts."""
        if self.shared is not None:
            return self
        found = self.sorted(x)
        assert found.kind is not None and found.turn is not None
        turned = np.take_along_axis(found.values(x), found.orders[found.turn], axis=1)
        weights = found.stress**2
        sums = np.zeros_like(self.shapes)
        np.add.at(sums, found.kind, weights[:, None] * turned)
        total = np.bincount(found.kind, weights, len(self.shapes))
        shapes = np.where(
            total[:, None] > 0, sums / np.maximum(total, 1e-300)[:, None], self.shapes
        )
        return replace(found, shapes=shapes)

    def _placed(self: _Term, x: FloatArray) -> _Term:
        return self if self.kind is not None else self.sorted(x)


@dataclass(frozen=True, eq=False)
class SameLengths(_Repeated):
    """The points of a part are as far from each other as those of its kind's shape.

        r_ij = w (|v_i - v_j| - L_ij)

    One row for each pair of points: six of a panel, one of an edge.

    Source: the residual of an isometry; Eigensatz et al. (2010), Paneling architectural freeform
    surfaces, and Fu et al. (2010), K-set tilable surfaces, alternate such groups and shapes.
    """

    name: str = "repetition"

    def values(self, x: FloatArray) -> FloatArray:
        """(n, p) distances."""
        return np.asarray(np.linalg.norm(_between(points_of(x, self.coordinates)), axis=2))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, p) and (n, p, 3 k)."""
        term = self._placed(x)
        between = _between(points_of(x, self.coordinates))
        size = np.maximum(np.linalg.norm(between, axis=2), _SHORT)
        by = (term.stress[:, None] / size)[:, :, None] * between
        return term._finished(x, size, _at_pairs(by, self.groups.shape[1]))


@dataclass(frozen=True, eq=False)
class SameAngles(_Repeated):
    """The edges of a node make the same angles with each other as those of its kind's shape.

        r_ij = w (|u_i - u_j| - C_ij),   u_i = (v_i - v_0) / |v_i - v_0|

    One row for each pair of edges; ``groups`` is (n, 1 + k), the node and its neighbours, and C are
    chords of the unit circle, 2 sin(angle / 2).

    Source: the idea of Liu et al. (2023), Reducing the number of different nodes in space frame
    structures through clustering and optimization.
    """

    name: str = "repetition"

    def values(self, x: FloatArray) -> FloatArray:
        """(n, p) chords."""
        return np.asarray(np.linalg.norm(_between(self._directions(x)[0]), axis=2))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, p) and (n, p, 3 (k + 1))."""
        term = self._placed(x)
        unit, size = self._directions(x)
        between = _between(unit)
        chord = np.maximum(np.linalg.norm(between, axis=2), _SHORT)
        by_unit = _at_pairs((term.stress[:, None] / chord)[:, :, None] * between, unit.shape[1])
        by_unit = by_unit.reshape(*chord.shape, unit.shape[1], 3)
        # A direction changes only square to itself.
        along = np.einsum("npki,nki->npk", by_unit, unit)
        by_end = (by_unit - along[..., None] * unit[:, None]) / size[:, None, :, None]
        jacobian = np.concatenate([-by_end.sum(axis=2, keepdims=True), by_end], axis=2)
        return term._finished(x, chord, jacobian.reshape(*chord.shape, -1))

    def _directions(self, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        points = points_of(x, self.coordinates)
        arms = points[:, 1:] - points[:, :1]
        size = np.maximum(np.linalg.norm(arms, axis=2), _SHORT)
        return arms / size[:, :, None], size


def _between(points: FloatArray) -> FloatArray:
    """(n, p, 3) from the second to the first point of each pair of (n, k, 3)."""
    i, j = np.triu_indices(points.shape[1], 1)
    return points[:, i] - points[:, j]


def _at_pairs(by: FloatArray, count: int) -> FloatArray:
    """(n, p, 3 k) derivatives by all points from those (n, p, 3) by the first point of a pair."""
    i, j = np.triu_indices(count, 1)
    found = np.zeros((*by.shape[:2], count, 3))
    rows = np.arange(len(i))
    found[:, rows, i] = by
    found[:, rows, j] = -by
    return found.reshape(*by.shape[:2], -1)
