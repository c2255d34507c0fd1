"""Groups of faces, edges or vertices: those of one size, and those that hang together."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class SameSize:
    """Faces of a mesh that have the same number n of corners.

    Attributes:
        numbers: (F_n,) of these faces in the mesh.
        faces: (F_n, n) vertex numbers.
        half_edges: (F_n, n) the half-edge that begins at each corner.
    """

    numbers: IntArray
    faces: IntArray
    half_edges: IntArray


def components_of(one: IntArray, two: IntArray, count: int) -> IntArray:
    """(count,) number of the component of each item, where ``one[k]`` is tied to ``two[k]``."""
    graph = coo_array((np.ones(len(one)), (one, two)), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)
