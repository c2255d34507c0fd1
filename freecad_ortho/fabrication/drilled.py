"""Bodies with round holes through them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Polyhedron
from freecad_ortho.fabrication.solids import cut_solids
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

# A drill reaches this many thicknesses through the plate, enough for one that bends at the hole.
_REACH = 3.0


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
    """A body less its holes, which may lie across bends: the one cut that no corners can express.

    Attributes:
        whole: the body without holes.
        drills: the holes; they do not overlap.
    """

    whole: Body
    drills: tuple[Drill, ...]

    @property
    def points(self) -> FloatArray:
        """Points of the whole body."""
        return self.whole.points

    @property
    def volume(self) -> float:
        """Volume less a cylinder of the plate's thickness for each hole."""
        bored = (np.pi / 4 * drill.diameter**2 * drill.thickness for drill in self.drills)
        return self.whole.volume - float(sum(bored))

    def filled(self) -> Body:
        """The whole body."""
        return self.whole

    def pieces(self) -> tuple[Polyhedron, ...]:
        """Those of the whole body."""
        return self.whole.pieces()

    def filling(self) -> tuple[Polyhedron, ...]:
        """That of the whole body."""
        return self.whole.filling()

    def solid(self) -> cadquery.Solid:
        """Build the whole and cut all holes from it at once."""
        import cadquery

        tools = []
        for drill in self.drills:
            start = drill.centre - _REACH / 2 * drill.thickness * drill.direction
            tools.append(
                cadquery.Solid.makeCylinder(
                    drill.diameter / 2,
                    _REACH * drill.thickness,
                    cadquery.Vector(*start.tolist()),
                    cadquery.Vector(*drill.direction.tolist()),
                )
            )
        return cut_solids(self.whole.solid(), tools)
