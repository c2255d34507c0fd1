"""Bodies with round holes through them, which the clash check fills."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freecad_ortho.fabrication.bodies import Body, Polyhedron
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery


@dataclass(frozen=True, eq=False)
class Drill:
    """A round hole square through a plate.

    Attributes:
        centre: (3,) in the middle of the plate, mm.
        direction: (3,) unit vector through the plate.
        diameter: mm.
        thickness: of the plate, mm.
    """

    centre: FloatArray
    direction: FloatArray
    diameter: float
    thickness: float


@dataclass(frozen=True, eq=False)
class DrilledBody(Body):
    """A body with its holes, and the same without.

    Attributes:
        whole: the body without holes.
        cut: the body with them.
        drills: the holes; they do not overlap.
    """

    whole: Body
    cut: Body
    drills: tuple[Drill, ...]

    @property
    def points(self) -> FloatArray:
        """Points of the whole body."""
        return self.whole.points

    @property
    def volume(self) -> float:
        """Volume of the body with its holes."""
        return self.cut.volume

    def pieces(self) -> tuple[Polyhedron, ...]:
        """Those of the whole body."""
        return self.whole.pieces()

    def filling(self) -> tuple[Polyhedron, ...]:
        """That of the whole body."""
        return self.whole.filling()

    def solid(self) -> cadquery.Solid:
        """Build the closed solid with its holes."""
        return self.cut.solid()
