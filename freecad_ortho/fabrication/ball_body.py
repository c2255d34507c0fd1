"""Balls with plane seats and threaded holes towards their middle."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Polyhedron
from freecad_ortho.fabrication.solids import placed
from solver.mesh.quadmesh import FloatArray, unit_rows

if TYPE_CHECKING:
    import cadquery

# Sides of the prism that panels keep clear of, and of the polyhedron that holds a ball.
SIDES = 12
_LATITUDES = np.radians([-60.0, -30.0, 0.0, 30.0, 60.0])


@dataclass(frozen=True, eq=False)
class Ball(Body):
    """A ball about its origin.

    Attributes:
        radius: mm.
        ways: (K, 3) unit directions of its holes.
        seat: from its middle to the plane seats around the holes, mm.
        hole: diameter of the holes, mm.
        depth: of the holes below their seats, flat at their end, mm.
    """

    radius: float
    ways: FloatArray
    seat: float
    hole: float
    depth: float

    @cached_property
    def points(self) -> FloatArray:
        """Both poles, the middles of the seats, and around each of these a square about z.

        All turn with the holes, so that equal balls have equal points.
        """
        level = unit_rows(self.ways * [1.0, 1.0, 0.0])
        side = np.stack([-level[:, 1], level[:, 0], 0 * level[:, 2]], axis=1)
        squares = [
            self.radius * sign * (level + turn * side) for sign in (1, -1) for turn in (1, -1)
        ]
        poles = self.radius * np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])
        return np.concatenate([poles, self.seat * self.ways, *squares])

    @property
    def volume(self) -> float:
        """The ball less the caps above its seats and its holes."""
        cap = self.radius - self.seat
        caps = np.pi * cap**2 * (3 * self.radius - cap) / 3
        bored = np.pi / 4 * self.hole**2 * self.depth
        return float(4 / 3 * np.pi * self.radius**3 - len(self.ways) * (caps + bored))

    def around(self) -> FloatArray:
        """(2, SIDES, 3) lower and upper corners of the upright prism that holds it."""
        angles = 2 * np.pi * np.arange(SIDES) / SIDES
        reach = self.radius / np.cos(np.pi / SIDES)
        circle = reach * np.stack([np.cos(angles), np.sin(angles)], axis=1)
        return np.stack(
            [
                np.column_stack([circle, np.full(SIDES, level)])
                for level in (-self.radius, self.radius)
            ]
        )

    def pieces(self) -> tuple[Polyhedron, ...]:
        """What lies within its seats and within planes that touch it all around."""
        from scipy.spatial import ConvexHull, HalfspaceIntersection

        turns = 2 * np.pi * np.arange(SIDES) / SIDES
        around = [
            [np.cos(lift) * np.cos(turn), np.cos(lift) * np.sin(turn), np.sin(lift)]
            for lift in _LATITUDES
            for turn in turns
        ]
        free = np.array([*around, [0, 0, 1.0], [0, 0, -1.0]])
        # Of planes that nearly lie in a seat the seat alone counts.
        free = free[(free @ self.ways.T).max(axis=1) < 1 - 1e-4]
        planes = np.concatenate(
            [
                np.column_stack([self.ways, np.full(len(self.ways), -self.seat)]),
                np.column_stack([free, np.full(len(free), -self.radius)]),
            ]
        )
        corners = HalfspaceIntersection(planes, np.zeros(3)).intersections
        corners = corners[ConvexHull(corners).vertices]
        triangles = ConvexHull(corners)
        loops = []
        for triangle, plane in zip(triangles.simplices, triangles.equations, strict=True):
            a, b, c = corners[triangle]
            outward = np.cross(b - a, c - a) @ plane[:3] > 0
            loops.append(tuple(triangle.tolist() if outward else triangle[::-1].tolist()))
        return (Polyhedron(corners, tuple(loops)),)

    def solid(self) -> cadquery.Solid:
        """Build the closed solid: a ball less all seats and holes at once, in one cut."""
        import cadquery

        up, base = cadquery.Vector(0, 0, 1), cadquery.Vector(0, 0, 0)
        # Its seam ends nowhere near a seat: it lies in the middle of the widest gap.
        turns = np.sort(np.arctan2(self.ways[:, 1], self.ways[:, 0]))
        gaps = np.diff(np.append(turns, turns[0] + 2 * np.pi))
        seam = float(turns[gaps.argmax()] + gaps.max() / 2)
        ball = cadquery.Solid.makeSphere(self.radius, base, up, -90, 90, 360)
        ball = ball.rotate(base, up, np.degrees(seam))
        tools = [tool for way in self.ways for tool in self._tools(way)]
        cut: cadquery.Solid = ball.cut(*tools).Solids()[0]
        return cut

    def _tools(self, way: FloatArray) -> list[cadquery.Solid]:
        """What is milled and drilled off in one direction."""
        import cadquery

        base, up = cadquery.Vector(0, 0, 0), cadquery.Vector(0, 0, 1)
        first = unit_rows(np.cross(way, np.eye(3)[np.abs(way).argmin()])[None])[0]
        frame = np.stack([first, np.cross(way, first), way])
        mill = cadquery.Solid.makeCylinder(self.radius, self.radius, base, up)
        drill = cadquery.Solid.makeCylinder(self.hole / 2, self.depth + 1.0, base, up)
        return [
            placed(mill, self.seat * way, frame),
            placed(drill, (self.seat - self.depth) * way, frame),
        ]
