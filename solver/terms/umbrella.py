"""Vertices where no parameter line runs on move as their neighbours do on average."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import Connectivity, IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, coordinates_of, points_of


@dataclass(frozen=True, eq=False)
class Umbrella:
    """Difference to the mean of the neighbours, as it is at rest.

        r = (v0 - mean(v1 .. vk)) - (the same at rest)

    Three rows a ring; ``rings`` is (n, 1 + k) with the centre first, ``rest`` the flat vector of
    the reference shape. Linear; any motion that is the same all over costs nothing.

    Source: Taubin (1995), A signal processing approach to fair surface design.
    """

    rings: IntArray
    rest: FloatArray
    name: str = "smooth motion"
    linear: bool = True

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 3 + 3 k) coordinates of the centre and its neighbours."""
        return coordinates_of(self.rings)

    @property
    def size(self) -> Size:
        """Three equations a ring."""
        return Size(0, 3 * len(self.rings))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 3) and (n, 3, 3 + 3 k)."""
        v = points_of(x - self.rest, self.unknowns)
        count = self.rings.shape[1] - 1
        by_vertex = np.concatenate([[1.0], np.full(count, -1.0 / count)])
        jacobian = np.kron(by_vertex, np.eye(3))
        residual = np.einsum("k,nkd->nd", by_vertex, v)
        return Linearisation(residual, np.broadcast_to(jacobian, (len(v), *jacobian.shape)))


def umbrellas(net: Connectivity, rest: FloatArray, name: str = "smooth motion") -> list[Umbrella]:
    """Those of all vertices of a mesh with faces of several sizes where no line runs on.

    Inside all neighbours count, at the boundary the two along it.

    Args:
        net: the connectivity; one of quads has lines to be smooth along, and gets none.
        rest: flat vector of the reference shape.
        name: of the terms.
    """
    if not net.mixed:
        return []
    edges = net.edges
    alike = net.boundary_vertices[edges].any(axis=1) & ~net.boundary_edges
    both = np.concatenate([edges, edges[:, ::-1]])
    # What runs inwards from the boundary says nothing of how the boundary runs.
    inwards = np.tile(alike, 2) & net.boundary_vertices[both[:, 0]]
    wanted = ~net.regular[both[:, 0]] & ~inwards
    both = both[wanted]
    both = both[np.lexsort(both.T[::-1])]
    counts = np.bincount(both[:, 0], minlength=net.vertex_count)
    first = np.concatenate([[0], np.cumsum(counts)[:-1]])
    found = []
    for count in np.unique(counts[counts > 1]).tolist():
        centres = np.flatnonzero(counts == count)
        around = both[first[centres][:, None] + np.arange(count), 1]
        found.append(Umbrella(np.column_stack([centres, around]), rest, name))
    return found
