"""What can be seen of a field of directions: crosses on the surface, and where it has none."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.align.field import QUARTER, DirectionField, GuidingField
from solver.align.triangle_mesh import TriangleMesh
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# How many lines may meet in a singular vertex.
VALENCES = (3, 5, 6)


@dataclass(frozen=True, eq=False)
class Crosses:
    """The two directions in which a net has its lines, at places of a surface.

    Attributes:
        places: (N, 3).
        directions: (N, 2, 3) unit vectors.
        certainty: (N,) 0 where neighbours decide, 1 where curvature or a stroke does.
    """

    places: FloatArray
    directions: FloatArray
    certainty: FloatArray

    @classmethod
    def of(cls, mesh: TriangleMesh, field: DirectionField, guide: GuidingField) -> Crosses:
        """One in each of the surface's own triangles."""
        inner = guide.inner
        angles = field.angles[:inner, None] + [0.0, QUARTER]
        parts = np.stack([np.cos(angles), np.sin(angles)], axis=2)
        if guide.skew is not None:
            parts = np.einsum("tij,tkj->tki", guide.skew[:inner], parts)
            parts /= np.linalg.norm(parts, axis=2, keepdims=True)
        directions = np.einsum("tki,tij->tkj", parts, mesh.axes[:inner])
        certainty = np.minimum(1.0, guide.certainty[:inner])
        return cls(mesh.centres[:inner], directions, certainty)

    @classmethod
    def of_net(cls, net: QuadMesh) -> Crosses:
        """One in each face of a net that did not come of a field: along its middle line."""
        corners = net.vertices[net.faces]
        along = unit_rows(corners[:, 1] + corners[:, 2] - corners[:, 0] - corners[:, 3])
        across = corners[:, 2] + corners[:, 3] - corners[:, 0] - corners[:, 1]
        across = unit_rows(across - (across * along).sum(axis=1)[:, None] * along)
        return cls(corners.mean(axis=1), np.stack([along, across], axis=1), np.ones(len(corners)))


@dataclass(frozen=True, eq=False)
class Singular:
    """Where directions cannot be continued: the net has irregular vertices there.

    Attributes:
        places: (K, 3).
        valences: (K,) how many lines meet there: 3, 5 or 6.
    """

    places: FloatArray
    valences: IntArray

    @classmethod
    def of(cls, mesh: TriangleMesh, field: DirectionField, guide: GuidingField) -> Singular:
        """Those of a field, on the surface itself."""
        own = np.zeros(len(mesh.points), dtype=bool)
        own[mesh.triangles[: guide.inner]] = True
        chosen = np.flatnonzero(own & (field.quarters != 0))
        return cls(mesh.points[chosen], 4 - field.quarters[chosen])

    @classmethod
    def of_net(cls, net: QuadMesh) -> Singular:
        """The irregular vertices inside a net."""
        connected = net.connectivity
        chosen = np.flatnonzero(~connected.regular & ~connected.boundary_vertices)
        lines = np.bincount(net.faces.ravel(), minlength=len(net.vertices))
        return cls(net.vertices[chosen], lines[chosen])

    def moved(self, number: int, place: FloatArray, reach: float) -> Singular:
        """One of them at another place, joined with the one that is there.

        One with 3 and one with 5 lines vanish, two with 5 become one with 6.

        Args:
            number: its row.
            place: (3,).
            reach: how near another is there.

        Raises:
            InputError: no net has a vertex with as many lines as both would make.
        """
        apart = np.linalg.norm(self.places - place, axis=1)
        apart[number] = np.inf
        other = int(np.argmin(apart))
        if not apart[other] < reach:
            places = self.places.copy()
            places[number] = place
            return Singular(places, self.valences)
        lines = int(self.valences[number] + self.valences[other]) - 4
        if lines not in (*VALENCES, 4):
            raise InputError(
                f"singularities: {self.valences[number]} and {self.valences[other]} lines in one "
                f"place would make a vertex with {lines}, which no net has; leave them apart"
            )
        valences = self.valences.copy()
        valences[other] = lines
        kept = np.flatnonzero((np.arange(len(valences)) != number) & (valences != 4))
        return Singular(self.places[kept], valences[kept])
