"""Nested dissection: an order of elimination in which a sparse factorisation fills in little.

The bundles of a graph are halved by a plane; as few as possible next to it become a separator that
is eliminated after both halves; and the halves are treated alike until they are small. All parts of
one level are split together, so that the cost hardly depends on their number.

Source: George (1973), Nested dissection of a regular finite element mesh; Gilbert, Miller, Teng
(1998), Geometric mesh partitioning.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.sparse import csc_array, csr_array
from scipy.sparse.csgraph import breadth_first_order, maximum_flow

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# Parts of no more unknowns than this are not split: dense arithmetic handles them faster.
_LEAF = 100


class Dissection(NamedTuple):
    """Bundles in parts; a part is eliminated after all parts below it.

    Attributes:
        order: (n,) bundles in the order of elimination.
        begins: (p + 1,) first place in ``order`` of each part, and n.
    """

    order: IntArray
    begins: IntArray


def dissect(graph: csc_array, points: FloatArray, weights: IntArray) -> Dissection:
    """Dissect a graph whose bundles lie in space.

    Args:
        graph: (n, n) symmetric, with an entry where two bundles meet; its values do not matter.
        points: (n, 3) where the bundles are; any place is right, neighbours near each other best.
        weights: (n,) unknowns of each bundle; those with none count for nothing.
    """
    count = graph.shape[0]
    path = np.ones(count, dtype=np.int64)
    along = np.zeros(count)
    column = np.repeat(np.arange(count), np.diff(graph.indptr))
    links = np.stack([graph.indices.astype(np.int64), column])
    links = links[:, (links[0] != links[1]) & (weights[links] > 0).all(axis=0)]
    bundles = np.flatnonzero(weights > 0)
    while True:
        part = np.unique(path[bundles], return_inverse=True)[1]
        large = np.bincount(part, weights[bundles])[part] > _LEAF
        bundles = bundles[large]
        if not len(bundles):
            return _in_order(path, along)
        links = links[:, (path[links[0]] == path[links[1]])]
        side, along[bundles] = _split(bundles, path, links, points, weights)
        kept = side < 2
        path[bundles[kept]] = 2 * path[bundles[kept]] + side[kept]
        bundles = bundles[kept]


def _split(
    bundles: IntArray, path: IntArray, links: IntArray, points: FloatArray, weights: IntArray
) -> tuple[IntArray, FloatArray]:
    """Halve every part across its longest direction.

    Returns:
        (k,) 0 or 1 for the halves, 2 for the separator; (k,) places along the separator.
    """
    part = np.unique(path[bundles], return_inverse=True)[1]
    weight = weights[bundles]
    total: FloatArray = np.bincount(part, weight).astype(np.float64)
    offset, axes = _principal_axes(points[bundles], part, weight, total)
    across, along = np.einsum("kc,kdc->dk", offset, axes[part, :2])
    sequence = np.lexsort((across, part))
    passed = np.empty(len(bundles))
    passed[sequence] = np.cumsum(weight[sequence])
    before = np.cumsum(total) - total
    half = (passed - before[part] > 0.5 * total[part]).astype(np.int64)
    side = np.zeros(len(path), dtype=np.int64)
    side[bundles] = half
    cut = links[:, side[links[0]] < side[links[1]]]
    side[_lightest_cover(cut, weights)] = 2
    return side[bundles], along


def _principal_axes(
    points: FloatArray, part: IntArray, weight: IntArray, total: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Offsets (k, 3) of points from the middle of their part, and axes (p, 3, 3), longest first."""

    def mean(values: FloatArray) -> FloatArray:
        return np.bincount(part, weight * values) / total

    middle = np.stack([mean(points[:, c]) for c in range(3)], axis=1)
    offset = points - middle[part]
    spread = np.empty((len(total), 3, 3))
    for a in range(3):
        for b in range(a, 3):
            spread[:, a, b] = spread[:, b, a] = mean(offset[:, a] * offset[:, b])
    return offset, np.linalg.eigh(spread)[1].swapaxes(1, 2)[:, ::-1]


def _lightest_cover(links: IntArray, weights: IntArray) -> IntArray:
    """Bundles of the least weight that leave no link (2, m) without one of them.

    By the theorem of König, in the form for weights: they are a least cut between a source that
    feeds every left end and a sink that drains every right end.
    """
    left, first = np.unique(links[0], return_inverse=True)
    right, second = np.unique(links[1], return_inverse=True)
    source, sink = len(left) + len(right), len(left) + len(right) + 1
    tail = [np.full(len(left), source), first, np.arange(len(left), source)]
    head = [np.arange(len(left)), len(left) + second, np.full(len(right), sink)]
    ample = np.full(len(first), 1 + weights[left].sum())
    capacity = csr_array(
        (
            np.concatenate([weights[left], ample, weights[right]]).astype(np.int32),
            (np.concatenate(tail), np.concatenate(head)),
        ),
        shape=(sink + 1, sink + 1),
    )
    spare = capacity - maximum_flow(capacity, source, sink).flow
    spare.eliminate_zeros()
    fed = np.zeros(sink + 1, dtype=bool)
    fed[breadth_first_order(spare, source, return_predecessors=False)] = True
    return np.concatenate([left[~fed[: len(left)]], right[fed[len(left) : source]]])


def _in_order(path: IntArray, along: FloatArray) -> Dissection:
    """Number the parts so that each follows directly on those below it.

    The path of a part is 1 followed by the side taken at each split, in binary.
    """
    depth = np.frexp(path)[1]
    last = ((path + 1) << (depth.max(initial=0) - depth)) - 1
    order = np.lexsort((along, -depth, last))
    begins = np.flatnonzero(np.diff(path[order], prepend=0))
    return Dissection(order, np.append(begins, len(path)))
