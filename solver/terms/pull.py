"""Handles: a few vertices are drawn towards their targets, not all at once."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from solver.mesh.quadmesh import FloatArray
from solver.terms.base import length
from solver.terms.closeness import Closeness


@dataclass(frozen=True, eq=False)
class Pull(Closeness):
    """Distance of handles from targets that move towards their goals as the solver steps.

        r = v - target

    Three rows a handle. Far goals are approached through shapes in between, so that the mesh
    follows as it does when it is dragged by hand.

    Args:
        vertices: (n,) handles.
        targets: (n, 3) where they are drawn to now, in the solver's units.
        goals: (n, 3) where the targets end.
        stride: how far the targets move a step, in mean edges.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, Interactive Design.
    """

    goals: FloatArray | None = None
    stride: float = 0.25
    name: str = "handles"

    @property
    def arrived(self) -> bool:
        """Whether all targets are at their goals."""
        return self.goals is None or np.array_equal(self.targets, self.goals)

    def follow(self, x: FloatArray) -> Pull:
        """Move the targets one stride on; the last one arrives with the others."""
        if self.goals is None or self.arrived:
            return self
        way = self.goals - self.targets
        farthest = float(length(way).max())
        if farthest <= self.stride:
            return replace(self, targets=self.goals)
        return replace(self, targets=self.targets + self.stride / farthest * way)
