"""Vertices that become one, numbered anew."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from solver.mesh.connectivity import IntArray


def merged(pairs: IntArray, count: int) -> tuple[IntArray, IntArray]:
    """Make one of all vertices that pairs (K, 2) join, directly or through others.

    Returns:
        (M,) the first of the ``count`` vertices in each group, ascending, and (count,) the number
        among those of the group that each vertex belongs to.
    """
    graph = coo_array((np.ones(len(pairs)), pairs.T), shape=(count, count))
    label = connected_components(graph, directed=False)[1]
    _, first, group = np.unique(label, return_index=True, return_inverse=True)
    order = np.argsort(first)
    number = np.empty_like(order)
    number[order] = np.arange(len(order))
    return first[order], number[group]
