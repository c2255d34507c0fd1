"""A lamella as it leaves a crossing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.systems.lamellas.axis import Lamella
from freecad_ortho.fabrication.systems.lamellas.splices import Joint, square_end
from solver.mesh.quadmesh import FloatArray


@dataclass(frozen=True, eq=False)
class Arm:
    """A lamella as it leaves a vertex, which is ``ahead`` or behind along it."""

    lamella: Lamella
    station: int
    ahead: bool

    @property
    def face(self) -> int:
        """Number of the ribbon's face along it."""
        return self.station if self.ahead else self.station - 1

    @property
    def towards(self) -> int:
        """The vertex that it comes to next."""
        place = self.lamella.stations.index(self.station)
        return self.lamella.vertices[place + (1 if self.ahead else -1)]

    @property
    def way(self) -> FloatArray:
        """(3,) unit vector along its edge, from the vertex."""
        along = self.lamella.ribbon.strip.along[self.face]
        return np.asarray(along if self.ahead else -along)

    def at(self, distance: float) -> tuple[FloatArray, FloatArray]:
        """Point of the axis so far from the vertex, mm, and normal of the plate there."""
        strip, face = self.lamella.ribbon.strip, self.face
        place = distance if self.ahead else float(strip.lengths[face]) - distance
        point, up = square_end(strip, Joint(face, place))
        return point, np.cross(strip.along[face], up)

    def place(self, distance: float) -> float:
        """Number of the face, and the share of its length, so far from the vertex."""
        share = distance / float(self.lamella.ribbon.strip.lengths[self.face])
        return self.station + (share if self.ahead else -share)

    def pattern(self, points: FloatArray) -> FloatArray:
        """(N, 2) where points (N, 3) beside the face are in the pattern."""
        ribbon, face = self.lamella.ribbon, self.face
        strip = ribbon.strip
        arms = points - strip.points[face]
        x = arms @ strip.along[face]
        angle = (strip.twists[face] * x / strip.lengths[face])[:, None]
        up = np.cos(angle) * strip.across[0][face] + np.sin(angle) * ribbon.sides[face]
        across = ribbon.flat_across[face]
        forwards = np.array([across[1], -across[0]])
        y = np.einsum("nk,nk->n", arms, up)
        return np.asarray(strip.flat_points[face] + x[:, None] * forwards + y[:, None] * across)
