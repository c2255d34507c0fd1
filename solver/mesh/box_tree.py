"""A tree of boxes around triangles, which finds the nearest one to each of many points.

It rejects what cannot be nearest; what is left is compared exactly. Nothing is sampled and no
neighbourhood is guessed.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, cross_rows

# Pairs of point and box that are looked at together; bounds the memory, about 100 bytes each.
_PAIRS = 1_000_000
# Triangles beside a point that are looked at before the tree is climbed.
_NEIGHBOURS = 8
# A triangle flatter than this counts as its three sides only.
_FLAT = 1e-12
# The feature that is hit where it is no side and no corner.
FACE = -1


class Hit(NamedTuple):
    """(N,) triangle hit; (N,) face -1, side 0 to 2 or corner 3 to 5 of it; (N, 3) feet."""

    item: IntArray
    feature: IntArray
    feet: FloatArray


class BoxTree:
    """A complete binary tree of axis-parallel boxes around triangles.

    Level by level the triangles of a box are halved at the median of their middles along the
    longest side. Empty places have boxes that are infinitely far away.

    Args:
        corners: (T, 3, 3) of the triangles.
        order: of the tree of the same triangles elsewhere or in another unit, which serves here.
    """

    def __init__(self, corners: FloatArray, order: IntArray | None = None) -> None:
        lower, upper = corners.min(axis=1), corners.max(axis=1)
        middles = corners.mean(axis=1)
        self.sizes = np.linalg.norm(upper - lower, axis=1)
        self._middles = cKDTree(middles)
        self._spans = np.stack([lower, upper], axis=1)
        count = len(corners)
        # How far each reaches from its middle, with rounding to spare.
        arms = np.linalg.norm(corners - middles[:, None], axis=2).max(axis=1)
        self._radii = arms + 1e-9 * (arms + np.abs(corners).max(initial=0.0))
        self._widest = self._radii.max()
        # Numbers of neighbours: of a list, a query gives a row to each point even of one.
        self._neighbours = list(range(1, 1 + min(_NEIGHBOURS, count)))
        depth = int(np.ceil(np.log2(count))) if count > 1 else 0
        if order is None:
            order = np.concatenate([np.arange(count), np.full(2**depth - count, -1)])
            for level in range(depth):
                order = _halve(order.reshape(2**level, -1), middles).ravel()
        self.order = order
        empty = (order < 0)[:, None]
        self._lower = [np.where(empty, np.inf, lower[order])]
        self._upper = [np.where(empty, -np.inf, upper[order])]
        for _ in range(depth):
            self._lower.insert(0, self._lower[0].reshape(-1, 2, 3).min(axis=1))
            self._upper.insert(0, self._upper[0].reshape(-1, 2, 3).max(axis=1))

    def nearest(self, points: FloatArray, corners: FloatArray) -> Hit:
        """Return what is nearest to each of the (N, 3) points; ties go to the smaller number."""
        away, beside = self._middles.query(points, k=self._neighbours)
        guess = beside[:, 0].copy()
        feet, feature, bound = _closest_on_triangles(points, corners[guess])
        result = Hit(guess, feature, feet)
        # What is as near counts too.
        reach = bound * (1 + 1e-9) + 1e-300
        for index, item in self._candidates(points, reach, away, beside):
            near, kind, distance = _closest_on_triangles(points[index], corners[item])
            first = _first_of_nearest(index, item, distance)
            place, square = index[first], distance[first]
            tie = (square == bound[place]) & (item[first] < result.item[place])
            first = first[(square < bound[place]) | tie]
            place = index[first]
            result.item[place], result.feature[place] = item[first], kind[first]
            result.feet[place] = near[first]
        return result

    def _candidates(
        self, points: FloatArray, reach: FloatArray, away: FloatArray, beside: IntArray
    ) -> Iterator[tuple[IntArray, IntArray]]:
        """Yield pairs (point, triangle) with all that are no further than the square of a reach.

        Where the triangles ``beside`` a point, whose middles are so far ``away``, must be all of
        these, the tree is not climbed.
        """
        limit = np.sqrt(reach)
        settled = np.full(len(points), beside.shape[1] == len(self._radii))
        settled |= away[:, -1] - self._widest > limit
        close = (away - self._radii[beside] <= limit[:, None]) & settled[:, None]
        # The first of them is known.
        close[:, 0] = False
        index, item = np.nonzero(close)[0], beside[close]
        lower, upper = self._spans[item, 0], self._spans[item, 1]
        gap = np.maximum(np.maximum(lower - points[index], points[index] - upper), 0.0)
        near = np.einsum("ij,ij->i", gap, gap) <= reach[index]
        yield index[near], item[near]
        yield from self._in_boxes(points, reach, np.flatnonzero(~settled))

    def _in_boxes(
        self, points: FloatArray, reach: FloatArray, asked: IntArray
    ) -> Iterator[tuple[IntArray, IntArray]]:
        """Yield pairs (point, triangle) whose box is no further than the square of a reach."""
        block = 20_000
        waiting = [asked[k : k + block] for k in range(0, len(asked), block)]
        while waiting:
            chosen = waiting.pop()
            index, box = chosen, np.zeros(len(chosen), dtype=np.int64)
            for level, (lower, upper) in enumerate(zip(self._lower, self._upper, strict=True)):
                if level:
                    index = np.repeat(index, 2)
                    box = np.repeat(2 * box, 2)
                    box[1::2] += 1
                here = points[index]
                gap = np.maximum(np.maximum(lower[box] - here, here - upper[box]), 0.0)
                near = np.einsum("ij,ij->i", gap, gap) <= reach[index]
                index, box = index[near], box[near]
                if len(index) > _PAIRS and len(chosen) > 1:
                    waiting += np.array_split(chosen, 2)
                    break
            else:
                yield index, self.order[box]


def _first_of_nearest(index: IntArray, item: IntArray, distance: FloatArray) -> IntArray:
    """Of each number in the rising ``index`` the place of the least distance, then least item."""
    begins = np.flatnonzero(np.diff(index, prepend=-1))
    if not len(begins):
        return begins
    least = np.minimum.reduceat(distance, begins)
    counts = np.diff(begins, append=len(index))
    near = np.flatnonzero(distance == np.repeat(least, counts))
    near = near[np.lexsort((item[near], index[near]))]
    return near[np.diff(index[near], prepend=-1) > 0]


def _halve(groups: IntArray, middles: FloatArray) -> IntArray:
    """Sort each row of numbers (-1 for none, last) along the longest side of its middles."""
    empty = (groups < 0)[..., None]
    here = middles[groups]
    low = np.where(empty, np.inf, here).min(axis=1)
    high = np.where(empty, -np.inf, here).max(axis=1)
    # A row without triangles has no sides: inf - inf, minus infinity here.
    axis = np.argmax(np.where(low <= high, high, -np.inf) - np.where(low <= high, low, 0), axis=1)
    key = np.take_along_axis(here, axis[:, None, None], axis=2)[..., 0]
    order = np.argsort(np.where(empty[..., 0], np.inf, key), axis=1, kind="stable")
    return np.take_along_axis(groups, order, axis=1)


def _closest_on_triangles(
    points: FloatArray, corners: FloatArray
) -> tuple[FloatArray, IntArray, FloatArray]:
    """Return the closest point of one triangle a point: (N, 3) feet, (N,) features, (N,) squares.

    The foot is on the best of the three sides, unless the foot on the plane lies inside.
    """
    inside, feet = _feet_inside(points, corners)
    feature = np.full(len(points), FACE)
    best = _squares(points - feet)
    beside = np.flatnonzero(~inside)
    feet[beside], feature[beside], best[beside] = _closest_on_sides(points[beside], corners[beside])
    return feet, feature, best


def _closest_on_sides(
    points: FloatArray, corners: FloatArray
) -> tuple[FloatArray, IntArray, FloatArray]:
    """The same of the three sides alone."""
    feet = np.empty_like(points)
    feature = np.empty(len(points), dtype=np.int64)
    best = np.full(len(points), np.inf)
    for k in range(3):
        start, end = corners[:, k], corners[:, (k + 1) % 3]
        side = end - start
        length = np.einsum("ij,ij->i", side, side)
        along = np.einsum("ij,ij->i", points - start, side) / np.where(length > 0, length, 1.0)
        t = np.clip(along, 0.0, 1.0)
        # Measured from the end where that is nearer, so that an end is met exactly.
        first = t < 0.5
        near = np.where(first[:, None], start, end) + np.where(first, t, t - 1)[:, None] * side
        square = _squares(points - near)
        kind = np.where(t <= 0, 3 + k, np.where(t >= 1, 3 + (k + 1) % 3, k))
        better = square < best
        feet[better], feature[better], best[better] = near[better], kind[better], square[better]
    return feet, feature, best


def _feet_inside(points: FloatArray, corners: FloatArray) -> tuple[BoolArray, FloatArray]:
    """(N,) whether the foot on the triangle's plane lies inside, and (N, 3) that foot."""
    a = corners[:, 0]
    u, v, w = corners[:, 1] - a, corners[:, 2] - a, points - a
    normal = cross_rows(u, v)
    area = np.einsum("ij,ij->i", normal, normal)
    solid = area > (_FLAT * np.maximum(_squares(u), _squares(v))) ** 2
    safe = np.where(solid, area, 1.0)
    second = np.einsum("ij,ij->i", cross_rows(w, v), normal) / safe
    third = np.einsum("ij,ij->i", cross_rows(u, w), normal) / safe
    inside = solid & (second > 0) & (third > 0) & (second + third < 1)
    return inside, a + second[:, None] * u + third[:, None] * v


def _squares(vectors: FloatArray) -> FloatArray:
    return np.asarray(np.einsum("ij,ij->i", vectors, vectors))
