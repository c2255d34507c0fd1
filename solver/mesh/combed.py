"""Which way the lines of both families run, told alike over a whole mesh.

Opposite sides of a face and edges in line at a regular vertex run the same way. Around an irregular
vertex that may contradict itself: after half a turn the directions come back reversed, after a
quarter of one the families are exchanged.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from solver.mesh.connectivity import Connectivity, IntArray


@dataclass(frozen=True, eq=False)
class Combed:
    """Directions of the sides of faces: 0 along u, 1 along v, 2 against u, 3 against v.

    Side 0 of the first face of each component runs along u, as in ``ParameterLines``.

    Attributes:
        connectivity: that the directions are of.
    """

    connectivity: Connectivity

    @property
    def families(self) -> bool:
        """Whether the two families can be told apart."""
        return self._holonomy % 2 == 0

    @property
    def oriented(self) -> bool:
        """Whether the directions can be told apart too."""
        return self._holonomy == 0

    @cached_property
    def _labels(self) -> IntArray:
        """(2 E,) component of each edge run from its smaller to its larger vertex, and back."""
        net = self.connectivity
        side = np.arange(4 * len(net.faces))
        here = self._node
        opposite = here[side - side % 4 + (side + 2) % 4] ^ 1
        on = net.continuation >= 0
        one = np.concatenate([here, here[on]])
        two = np.concatenate([opposite, here[net.continuation[on]]])
        one, two = np.concatenate([one, one ^ 1]), np.concatenate([two, two ^ 1])
        count = 2 * len(net.edges)
        graph = coo_array((np.ones(len(one)), (one, two)), shape=(count, count))
        return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)

    @cached_property
    def _node(self) -> IntArray:
        """(4F,) number of each side of a face as an edge with a direction."""
        start = self.connectivity.faces.ravel()
        end = np.roll(self.connectivity.faces, -1, axis=1).ravel()
        return 2 * self.connectivity.face_edges.ravel() + (start > end)

    @cached_property
    def _base(self) -> IntArray:
        """(F, 4) labels of the four directions in the component of each face."""
        _, first = np.unique(self.connectivity.components, return_index=True)
        labels = self._labels[self._node].reshape(-1, 4)
        return labels[first][self.connectivity.components]

    @cached_property
    def _holonomy(self) -> int:
        """0: all four directions differ; 2: those of a family are one; 1: families are one."""
        base = self._base
        if (base[:, 0] == base[:, 1]).any() or (base[:, 0] == base[:, 3]).any():
            return 1
        return 2 if (base[:, 0] == base[:, 2]).any() or (base[:, 1] == base[:, 3]).any() else 0

    @cached_property
    def edge_signs(self) -> IntArray:
        """(E,) 1 where an edge runs along its family from its smaller vertex, -1 from the larger.

        It says nothing where directions cannot be told apart.
        """
        net = self.connectivity
        base = np.empty((len(net.edges), 2), dtype=np.int64)
        base[net.face_edges] = self._base[:, None, :2]
        return np.where((self._labels[::2, None] == base).any(axis=1), 1, -1)

    @cached_property
    def faces(self) -> IntArray:
        """(F, 4) the faces, each from the corner where a side along u begins.

        Where only families are told apart that is any side of u; where not even they are, faces
        stay as they are.
        """
        labels = self._labels[self._node].reshape(-1, 4)
        first = np.argmax(labels == self._base[:, :1], axis=1)
        turned = (first[:, None] + np.arange(4)) % 4
        return np.take_along_axis(self.connectivity.faces, turned, axis=1)

    @cached_property
    def _shift(self) -> IntArray:
        """(S,) place in each star, from 0, of the neighbour along u."""
        net = self.connectivity
        stars = net.stars
        key = net.edges @ np.array([net.vertex_count, 1])
        centre, others = stars[:, :1], stars[:, 1:]
        low, high = np.minimum(centre, others), np.maximum(centre, others)
        node = 2 * np.searchsorted(key, low * net.vertex_count + high) + (centre > others)
        face = np.full(net.vertex_count, -1, dtype=np.int64)
        face[net.faces.ravel()] = np.repeat(np.arange(len(net.faces)), 4)
        return np.asarray(
            np.argmax(self._labels[node] == self._base[face[stars[:, 0]], :1], axis=1)
        )

    @cached_property
    def stars(self) -> IntArray:
        """(S, 5) the stars: centre, then the neighbours along u, v, against u, against v."""
        return self._turned(self.connectivity.stars)

    @cached_property
    def diagonal_stars(self) -> IntArray:
        """(S, 5) the diagonal stars: the first corner lies between u and v."""
        return self._turned(self.connectivity.diagonal_stars)

    def _turned(self, stars: IntArray) -> IntArray:
        places = (self._shift[:, None] + np.arange(4)) % 4
        return np.hstack([stars[:, :1], np.take_along_axis(stars[:, 1:], places, axis=1)])
