"""What a part is made of in space, in its own coordinates; each body knows how to become a solid.

Bodies hold arrays only, so that they travel between processes; solids of the CAD kernel do not.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from freecad_ortho.fabrication.pattern import polygon_area
from freecad_ortho.fabrication.solids import polyhedron_solid
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

Loops = tuple[tuple[int, ...], ...]


def prism_sides(count: int) -> Loops:
    """Sides of a body with a lower ring of corners, then an upper one, ``count`` each."""
    sides = tuple((k, (k + 1) % count, (k + 1) % count + count, k + count) for k in range(count))
    return (tuple(range(count, 2 * count)), tuple(reversed(range(count))), *sides)


# Sides of a body with the corners of a box.
BOX_SIDES = prism_sides(4)
# The corners of a box in this order, true where its upper bound is meant.
BOX_CORNERS = np.array(
    [(x, y, upper) for upper in (False, True) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
).astype(bool)


class Body(ABC):
    """The closed body of a part, in the part's own coordinates, mm.

    Attributes:
        quick: its solid is built faster than it travels between processes.
    """

    quick: ClassVar[bool] = False

    @property
    def in_cells(self) -> bool:
        """Whether its filling are cells that share sides only, bent sides within their corners."""
        return False

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
        return (Polyhedron(np.where(BOX_CORNERS, high, low), BOX_SIDES),)

    def filling(self, finer: int = 1) -> tuple[Polyhedron, ...]:
        """The same as exactly as the body can tell: at best these are the body without its holes.

        They are where their volumes add up to its own. Bent bodies are held by ``finer`` times as
        many of them.
        """
        return self.pieces()


@dataclass(frozen=True, eq=False)
class Polyhedron(Body):
    """A body with plane sides.

    Attributes:
        corners: (N, 3) corner points, mm.
        loops: point numbers around each side, counter-clockwise seen from outside.
    """

    corners: FloatArray
    loops: Loops

    quick: ClassVar[bool] = True

    @property
    def points(self) -> FloatArray:
        """(N, 3) the corners."""
        return self.corners

    @cached_property
    def volume(self) -> float:
        """Volume by the divergence theorem: cones from the first corner to the sides."""
        arms = self.corners - self.corners[0]
        fans = [
            (loop[0], loop[k], loop[k + 1]) for loop in self.loops for k in range(1, len(loop) - 1)
        ]
        a, b, c = np.moveaxis(arms[np.array(fans)], 1, 0)
        return float(np.einsum("tk,tk->", a, np.cross(b, c))) / 6

    def solid(self) -> cadquery.Solid:
        """Build the closed solid; no boolean operation, no sewing."""
        return polyhedron_solid(self.corners, self.loops)

    def pieces(self) -> tuple[Polyhedron, ...]:
        """The body itself, or what its convex hull contains of it."""
        return (self,)


@dataclass(frozen=True, eq=False)
class Divided(Polyhedron):
    """A polyhedron with recesses that is known to lie in convex ones.

    Attributes:
        blocks: convex polyhedra that together contain the body.
    """

    blocks: tuple[Polyhedron, ...]

    def pieces(self) -> tuple[Polyhedron, ...]:
        """The blocks."""
        return self.blocks

    def moved(self, by: Sequence[float]) -> Divided:
        """The same body elsewhere."""
        blocks = tuple(replace(block, corners=block.corners + by) for block in self.blocks)
        return replace(self, corners=self.corners + by, blocks=blocks)


@dataclass(frozen=True, eq=False)
class Hollow(Polyhedron):
    """A tube: few corners from outside, several convex walls when looked into.

    Attributes:
        walls: convex polyhedra that together are the body.
    """

    walls: tuple[Polyhedron, ...]

    def filling(self, finer: int = 1) -> tuple[Polyhedron, ...]:
        """The walls."""
        return self.walls


@dataclass(frozen=True, eq=False)
class Prism(Body):
    """A convex outline along z, with an optional round hole.

    Attributes:
        outline: (N, 2) convex, counter-clockwise, mm.
        low: z of the lower end.
        high: z of the upper end.
        bore: diameter of the hole along the z axis, 0 for none.
    """

    outline: FloatArray
    low: float
    high: float
    bore: float = 0.0

    @property
    def points(self) -> FloatArray:
        """(2 N, 3) the corners, lower ones first."""
        ends = [np.full(len(self.outline), z) for z in (self.low, self.high)]
        return np.concatenate([np.column_stack([self.outline, end]) for end in ends])

    @property
    def volume(self) -> float:
        """Area of the outline less the hole, times the height."""
        area = polygon_area(self.outline) - np.pi * self.bore**2 / 4
        return float(area * (self.high - self.low))

    def solid(self) -> cadquery.Solid:
        """Build the closed solid."""
        import cadquery

        corners = [cadquery.Vector(x, y, self.low) for x, y in self.outline.tolist()]
        holes = []
        if self.bore > 0:
            base, up = cadquery.Vector(0, 0, self.low), cadquery.Vector(0, 0, 1)
            holes.append(cadquery.Wire.makeCircle(self.bore / 2, base, up))
        outer = cadquery.Wire.makePolygon([*corners, corners[0]])
        height = cadquery.Vector(0, 0, self.high - self.low)
        return cadquery.Solid.extrudeLinear(outer, holes, height)

    def pieces(self) -> tuple[Polyhedron, ...]:
        """The prism without its hole."""
        return (Polyhedron(self.points, prism_sides(len(self.outline))),)
