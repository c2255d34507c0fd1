"""E_Cheby: edges have one length, or one length a family."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, coordinates_of, dot, points_of


@dataclass(frozen=True, eq=False)
class EqualEdges:
    """Edge lengths equal a common length l, given or unknown.

        r = (|v_j - v_i|^2 / l^2 - 1) / 2

    One row an edge; ``edges`` is (n, 2). Near zero, r is the relative deviation of the length.

    Args:
        edges: (n, 2) ends of each edge.
        length: the given length in mean edges, where it is not shared.
        shared: position of the unknown length in the flat vector, None for a given one.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 7 and E_Cheby;
    there the difference of squares is not divided by the length.
    """

    edges: IntArray
    length: float = 1.0
    shared: int | None = None
    name: str = "chebyshev"
    linear: bool = False

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 6) coordinates of both ends, or (n, 7) with the unknown length last."""
        ends = coordinates_of(self.edges)
        if self.shared is None:
            return ends
        return np.hstack([ends, np.full((len(ends), 1), self.shared, dtype=np.int64)])

    @property
    def size(self) -> Size:
        """One equation an edge; the length is counted with the unknowns."""
        return Size(0, len(self.edges))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 1) and (n, 1, 6 or 7)."""
        v = points_of(x, self.unknowns[:, :6])
        d = v[:, 1] - v[:, 0]
        square = (self.length if self.shared is None else x[self.shared]) ** 2
        ratio = dot(d, d) / square
        by_end = d / square
        columns = [-by_end, by_end]
        if self.shared is not None:
            columns.append(-(ratio / x[self.shared])[:, None])
        return Linearisation(0.5 * (ratio - 1.0)[:, None], np.hstack(columns)[:, None, :])
