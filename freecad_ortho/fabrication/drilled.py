"""Bodies with round holes through them, which the clash check fills."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Polyhedron, prism_sides
from freecad_ortho.fabrication.pattern import FlatPattern, Hole
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.ruled_sides import Bore
from solver.mesh.quadmesh import FloatArray, unit_rows

if TYPE_CHECKING:
    import cadquery


# Sides of a prism around a hole, and how much wider it is than the hole: in twisted plates the
# walls of holes lean a little.
_SIDES, _WIDER = 8, 1.05


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

    def around(self) -> Polyhedron:
        """A prism that holds the hole and reaches beyond the plate."""
        first = unit_rows(
            np.cross(self.direction, np.eye(3)[np.abs(self.direction).argmin()])[None]
        )[0]
        second = np.cross(self.direction, first)
        angles = 2 * np.pi * np.arange(_SIDES) / _SIDES
        radius = _WIDER * self.diameter / 2 / np.cos(np.pi / _SIDES)
        ring = self.centre + radius * (
            np.cos(angles)[:, None] * first + np.sin(angles)[:, None] * second
        )
        lift = self.thickness * self.direction
        return Polyhedron(np.concatenate([ring - lift, ring + lift]), prism_sides(_SIDES))


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

    def filling(self, finer: int = 1) -> tuple[Polyhedron, ...]:
        """That of the whole body."""
        return self.whole.filling(finer)

    def holes(self) -> tuple[Polyhedron, ...]:
        """Prisms that hold the holes and reach beyond the plate."""
        return tuple(drill.around() for drill in self.drills)

    def solid(self) -> cadquery.Solid:
        """Build the closed solid with its holes."""
        return self.cut.solid()


@dataclass(frozen=True, eq=False)
class DrilledWalls(DrilledBody):
    """A body whose holes lead square through plane walls."""

    @property
    def volume(self) -> float:
        """That of the whole body less its cylindrical holes."""
        bored = sum(drill.thickness * drill.diameter**2 for drill in self.drills)
        return float(self.whole.volume - np.pi / 4 * bored)


def drilled_plate(pattern: FlatPattern, thickness: float) -> DrilledWalls:
    """The body of a plate with the holes of its pattern, from z = 0 up; x and y are the pattern's.

    Args:
        pattern: a convex outline.
        thickness: of the plate, mm.
    """
    count = len(pattern.outline)
    levels = np.repeat([0.0, thickness], count)
    corners = np.column_stack([np.tile(pattern.outline, (2, 1)), levels])
    # Of the sides of a prism the first is the upper one, the second the lower one.
    return drilled(Polyhedron(corners, prism_sides(count)), pattern.holes, (0.0, thickness), (1, 0))


def drilled(
    whole: Polyhedron,
    holes: Sequence[Hole],
    levels: tuple[float, float],
    sides: tuple[int, int],
) -> DrilledWalls:
    """A plate with holes along z.

    Args:
        whole: the plate without them.
        holes: in x and y.
        levels: z of its two faces, mm.
        sides: the numbers of these among its sides, the lower one first.
    """
    low, high = levels
    feet = [(np.append(hole.centre, low), hole.diameter) for hole in holes]
    lift = np.array([0.0, 0.0, high - low])
    drills = tuple(
        Drill(foot + lift / 2, lift / (high - low), diameter, high - low) for foot, diameter in feet
    )
    bores = tuple(Bore(foot, foot + lift, diameter, sides) for foot, diameter in feet)
    return DrilledWalls(whole, RuledBody(whole.corners, whole.loops, bores=bores), drills)
