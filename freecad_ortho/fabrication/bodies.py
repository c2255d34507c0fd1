"""What a part is made of in space, in its own coordinates; each body knows how to become a solid.

Bodies hold arrays only, so that they travel between processes; solids of the CAD kernel do not.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

Loops = tuple[tuple[int, ...], ...]
# Corners of a box, lower ring then upper ring, true where the upper bound is meant; its sides.
_BOX = np.array([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]) == 1
_BOX_SIDES: Loops = ((4, 5, 6, 7), (3, 2, 1, 0)) + tuple(
    (k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4) for k in range(4)
)


class Body(ABC):
    """The closed body of a part, in the part's own coordinates, mm."""

    @property
    @abstractmethod
    def points(self) -> FloatArray:
        """(N, 3) points whose box holds the body."""

    @property
    @abstractmethod
    def volume(self) -> float:
        """Volume by formula, mm3."""

    @abstractmethod
    def solid(self) -> cadquery.Solid:
        """Build the closed solid."""

    def pieces(self) -> tuple[Polyhedron, ...]:
        """Convex polyhedra that together contain the body; the closer, the faster the clash check.

        By default its box in its own coordinates.
        """
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        return (Polyhedron(np.where(_BOX, high, low), _BOX_SIDES),)


@dataclass(frozen=True, eq=False)
class Polyhedron(Body):
    """A body with plane sides.

    Attributes:
        corners: (N, 3) corner points, mm.
        loops: point numbers around each side, counter-clockwise seen from outside.
    """

    corners: FloatArray
    loops: Loops

    @property
    def points(self) -> FloatArray:
        """(N, 3) the corners."""
        return self.corners

    @cached_property
    def volume(self) -> float:
        """Volume by the divergence theorem: cones from the first corner to the sides."""
        arms = self.corners - self.corners[0]
        total = 0.0
        for loop in self.loops:
            side = arms[list(loop)]
            total += side[0] @ np.cross(side[1:-1], side[2:]).sum(axis=0)
        return float(total) / 6

    def solid(self) -> cadquery.Solid:
        """Build the closed solid; no boolean operation, no sewing."""
        from freecad_ortho.fabrication.solids import polyhedron_solid

        return polyhedron_solid(self.corners, self.loops)

    def pieces(self) -> tuple[Polyhedron, ...]:
        """The body itself, or what its convex hull contains of it."""
        return (self,)
