"""Hollow hubs: prisms of one wall with bolt holes square through it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from freecad_ortho.fabrication.bodies import BOX_SIDES, Body, Polyhedron
from freecad_ortho.fabrication.drilled import Drill, DrilledWalls
from freecad_ortho.fabrication.pattern import polygon_area
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.ruled_sides import Bore, RuledSide
from freecad_ortho.fabrication.systems.nodes.hubs import face_normals, outline
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery


@dataclass(frozen=True, eq=False)
class HollowPrism(Body):
    """A prism along z with an opening of as many sides.

    Attributes:
        outer: (N, 2) convex, counter-clockwise, mm.
        inner: (N, 2) its opening, with sides parallel to those.
        low: z of the lower end.
        high: z of the upper end.
    """

    outer: FloatArray
    inner: FloatArray
    low: float
    high: float

    @property
    def points(self) -> FloatArray:
        """(4 N, 3) corners: outside low and high, inside low and high."""
        return np.concatenate(
            [
                np.column_stack([ring, np.full(len(ring), level)])
                for ring in (self.outer, self.inner)
                for level in (self.low, self.high)
            ]
        )

    @property
    def volume(self) -> float:
        """Area of the ring times the height."""
        return (polygon_area(self.outer) - polygon_area(self.inner)) * (self.high - self.low)

    def pieces(self) -> tuple[Polyhedron, ...]:
        """Its walls."""
        rings = self.points.reshape(2, 2, -1, 3)
        before = np.roll(rings, 1, axis=2)
        walls = [before[0], rings[0], rings[1], before[1]]
        corners = np.stack(walls, axis=1).transpose(2, 0, 1, 3)
        return tuple(Polyhedron(each.reshape(-1, 3), BOX_SIDES) for each in corners)

    def solid(self) -> cadquery.Solid:
        """Build the closed solid."""
        return self.bored(()).solid()

    def bored(self, bores: tuple[Bore, ...]) -> RuledBody:
        """With holes through its sides: side k ends in corner k, inner sides follow outer ones."""
        count = len(self.outer)
        low, high, inner_low, inner_high = np.arange(4 * count).reshape(4, count).tolist()
        outside = [(low[k - 1], low[k], high[k], high[k - 1]) for k in range(count)]
        inside = [
            (inner_low[k], inner_low[k - 1], inner_high[k - 1], inner_high[k]) for k in range(count)
        ]
        sheets = (
            RuledSide((tuple(reversed(low)), tuple(inner_low))),
            RuledSide((tuple(high), tuple(reversed(inner_high)))),
        )
        return RuledBody(self.points, (*outside, *inside), sheets=sheets, bores=bores)


class BoltHole(NamedTuple):
    """A hole in the face of one of the beams.

    Attributes:
        beam: its number in the order of the beams around the axis.
        height: along the axis, mm.
        diameter: mm.
    """

    beam: int
    height: float
    diameter: float


def hollow_hub(
    angles: FloatArray,
    radius: float,
    wall: float,
    levels: tuple[float, float],
    holes: Sequence[BoltHole],
) -> DrilledWalls:
    """The hub of one node.

    Args:
        angles: (K,) directions of the beams around the axis, counter-clockwise, radians.
        radius: from the axis to the faces, mm.
        wall: thickness, mm.
        levels: of its lower and upper end along the axis, mm.
        holes: in the middle of the faces; they do not overlap.
    """
    normals, own = face_normals(angles)
    outer, inner = (outline(normals, reach) for reach in (radius, radius - wall))
    whole = HollowPrism(outer, inner, *levels)
    drills, bores = [], []
    for beam, height, diameter in holes:
        side, turn = int(own[beam]), float(angles[beam])
        outward = np.array([np.cos(turn), np.sin(turn), 0.0])
        start, end = (reach * outward + [0, 0, height] for reach in (radius, radius - wall))
        bores.append(Bore(start, end, diameter, (side, len(normals) + side)))
        drills.append(Drill((start + end) / 2, outward, diameter, wall))
    return DrilledWalls(whole, whole.bored(tuple(bores)), tuple(drills))
