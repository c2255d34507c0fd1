"""Bodies of revolution: a profile of straight lines turned about z."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Polyhedron, prism_sides
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

# Sides of the prisms that hold a body.
_SIDES = 16


@dataclass(frozen=True, eq=False)
class TurnedBody(Body):
    """A hollow body of revolution about z.

    Attributes:
        outer: (N, 2) stations along z, increasing, and radii outside there, mm; convex, so that
            the hull of its rings is the body without its opening.
        inner: (M, 2) the same of its opening, from end to end; a station may come twice, where
            the radius steps.
    """

    outer: FloatArray
    inner: FloatArray

    quick: ClassVar[bool] = False

    @cached_property
    def points(self) -> FloatArray:
        """Corners of the polyhedron around it, ring after ring."""
        angles = 2 * np.pi * (np.arange(_SIDES) + 0.5) / _SIDES
        circle = np.stack([np.cos(angles), np.sin(angles)], axis=1) / np.cos(np.pi / _SIDES)
        rings = [
            np.column_stack([radius * circle, np.full(_SIDES, station)])
            for station, radius in self.outer.tolist()
        ]
        return np.concatenate(rings)

    @property
    def volume(self) -> float:
        """Frustums outside less those of the opening."""
        return _turned_volume(self.outer) - _turned_volume(self.inner)

    @property
    def skin(self) -> float:
        """Outer surface without its ends, mm2."""
        radii, steps = self.outer[:, 1], np.diff(self.outer, axis=0)
        return float((np.pi * (radii[1:] + radii[:-1]) * np.hypot(*steps.T)).sum())

    def pieces(self) -> tuple[Polyhedron, ...]:
        """A frustum between each ring and the next."""
        rings = self.points.reshape(-1, _SIDES, 3)
        return tuple(
            Polyhedron(np.concatenate([low, high]), prism_sides(_SIDES))
            for low, high in pairwise(rings)
        )

    def solid(self) -> cadquery.Solid:
        """Build the closed solid."""
        import cadquery

        ring = [*self.outer.tolist(), *self.inner[::-1].tolist()]
        corners = [cadquery.Vector(radius, 0, station) for station, radius in ring]
        wire = cadquery.Wire.makePolygon([*corners, corners[0]])
        base, up = cadquery.Vector(0, 0, 0), cadquery.Vector(0, 0, 1)
        solid: cadquery.Solid = cadquery.Solid.revolve(wire, [], 360.0, base, up)
        return solid


def _turned_volume(profile: FloatArray) -> float:
    """Volume within a profile (N, 2) of stations and radii, mm3."""
    steps, radii = np.diff(profile[:, 0]), profile[:, 1]
    low, high = radii[:-1], radii[1:]
    return float((np.pi / 3 * steps * (low**2 + low * high + high**2)).sum())
