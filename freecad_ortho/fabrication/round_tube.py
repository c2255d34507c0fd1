"""Round tubes between two planes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Polyhedron, prism_sides
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

# Sides of the prism that holds a tube.
_SIDES = 16


@dataclass(frozen=True, eq=False)
class RoundTube(Body):
    """A tube along x that ends in planes, each mitred or square.

    Attributes:
        middle: (3,) a point of its axis.
        stations: (2,) where the planes cross the axis, mm.
        ends: (2, 3) their normals, ahead.
        diameter: outside, mm.
        wall: its thickness, mm.
    """

    middle: FloatArray
    stations: FloatArray
    ends: FloatArray
    diameter: float
    wall: float

    @property
    def points(self) -> FloatArray:
        """Corners of the prism around it."""
        return self.around().corners

    @property
    def volume(self) -> float:
        """Area of the ring times the length of the axis: a plane cuts as much off as it leaves."""
        inside = self.diameter - 2 * self.wall
        ring = np.pi / 4 * (self.diameter**2 - inside**2)
        return float(ring * (self.stations[1] - self.stations[0]))

    def around(self) -> Polyhedron:
        """A prism that holds the tube."""
        angles = 2 * np.pi * np.arange(_SIDES) / _SIDES
        radius = self.diameter / 2 / np.cos(np.pi / _SIDES)
        ring = radius * np.column_stack([-np.cos(angles), np.sin(angles)])
        rings = []
        for station, normal in zip(self.stations, self.ends, strict=True):
            along = station - ring @ normal[1:] / normal[0]
            rings.append(np.column_stack([along, self.middle[1:] + ring]))
        return Polyhedron(np.concatenate(rings), prism_sides(_SIDES))

    def pieces(self) -> tuple[Polyhedron, ...]:
        """The prism around it."""
        return (self.around(),)

    def solid(self) -> cadquery.Solid:
        """Build the closed solid: a longer tube cut by both planes, as no corners bound it."""
        import cadquery

        points = self.around().corners
        low, high = float(points[:, 0].min()) - 1.0, float(points[:, 0].max()) + 1.0
        base = cadquery.Vector(low, *self.middle[1:].tolist())
        ahead = cadquery.Vector(1, 0, 0)
        radii = self.diameter / 2, self.diameter / 2 - self.wall
        outside, inside = (
            cadquery.Solid.makeCylinder(radius, high - low, base, ahead) for radius in radii
        )
        tube = outside.cut(inside)
        for station, normal, sign in zip(self.stations, self.ends, (-1.0, 1.0), strict=True):
            tube = tube.cut(self._beyond(station, sign * normal, high - low))
        solid: cadquery.Solid = tube.Solids()[0]
        return solid

    def _beyond(self, station: float, normal: FloatArray, reach: float) -> cadquery.Solid:
        """What lies beyond a plane, as far as the tube comes."""
        import cadquery

        centre = cadquery.Vector(station, *self.middle[1:].tolist())
        place = cadquery.Plane(centre, normal=cadquery.Vector(*normal.tolist()))
        size = 4 * (self.diameter + reach)
        wire = cadquery.Wire.makePolygon(
            [
                place.toWorldCoords((x * size / 2, y * size / 2, 0))
                for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))
            ],
            close=True,
        )
        away = cadquery.Vector(*(size * normal).tolist())
        return cadquery.Solid.extrudeLinear(wire, [], away)
