"""Where a structure's own coordinates stand in those of its files."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True, eq=False)
class Place:
    """A rotation, then a translation, mm.

    Attributes:
        rotation: (3, 3) orthonormal, turns column vectors.
        origin: (3,) where the origin of the structure's coordinates goes.
    """

    rotation: FloatArray = field(default_factory=lambda: np.eye(3))
    origin: FloatArray = field(default_factory=lambda: np.zeros(3))

    @property
    def is_here(self) -> bool:
        """Whether nothing is turned or moved."""
        return not self.origin.any() and np.array_equal(self.rotation, np.eye(3))

    def points(self, points: FloatArray) -> FloatArray:
        """(..., 3) points where they stand in the files."""
        return points if self.is_here else points @ self.rotation.T + self.origin

    def directions(self, vectors: FloatArray) -> FloatArray:
        """(..., 3) vectors turned as in the files."""
        return vectors if self.is_here else vectors @ self.rotation.T

    def near(self, other: Place) -> bool:
        """Whether both put a structure into the same place, but for rounding."""
        turned = np.abs(self.rotation - other.rotation).max() <= 1e-9
        scale = max(1.0, float(np.abs(self.origin).max()))
        return bool(turned and np.abs(self.origin - other.origin).max() <= 1e-9 * scale + 1e-6)

    def less(self, point: FloatArray) -> Place:
        """The same in coordinates measured from a (3,) point, mm."""
        return replace(self, origin=self.origin - point)
