"""Closeness: vertices stay near given points."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, coordinates_of


@dataclass(frozen=True, eq=False)
class Closeness:
    """Distance of vertices from target points, in mean edges.

        r = v - target

    Three rows a vertex; ``vertices`` is (n,), ``targets`` (n, 3) in the solver's units. Linear.
    """

    vertices: IntArray
    targets: FloatArray
    name: str = "closeness"
    linear: bool = True

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 3) coordinates of each vertex."""
        return coordinates_of(self.vertices[:, None])

    @property
    def size(self) -> Size:
        """Three equations a vertex."""
        return Size(0, 3 * len(self.vertices))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 3) and (n, 3, 3)."""
        identity = np.broadcast_to(np.eye(3), (len(self.vertices), 3, 3))
        return Linearisation(x[self.unknowns] - self.targets, identity)
