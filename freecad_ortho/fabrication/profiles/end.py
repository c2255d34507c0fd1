"""Planes that cut a member off, as heights above its section."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True)
class End:
    """One or two planes that cut a member; they meet above the upright of its section.

    Attributes:
        place: along the member above the middle of the section's box, mm.
        up: by which the planes move along the member per mm up.
        right: per mm to the right, on the right half.
        left: per mm to the left, on the left half.
    """

    place: float
    up: float
    right: float
    left: float

    @property
    def folded(self) -> bool:
        """Whether these are two planes."""
        return abs(self.right + self.left) > 1e-12

    @property
    def planes(self) -> FloatArray:
        """(2, 3) place and slopes per mm to the right and up, on the right half and the left."""
        return np.array([[self.place, self.slope(half), self.up] for half in (1, -1)])

    def slope(self, half: int) -> float:
        """Per mm to the right, on the right half, 1, or the left one, -1."""
        return self.right if half > 0 else -self.left

    def at(self, points: FloatArray) -> FloatArray:
        """(n,) along the member above points (n, 2) of the section, mm."""
        across = np.where(points[:, 0] > 0, self.right, -self.left) * points[:, 0]
        return np.asarray(self.place + self.up * points[:, 1] + across)
