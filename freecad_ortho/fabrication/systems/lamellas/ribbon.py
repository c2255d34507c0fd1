"""A strip between two levels along its rulings, and the map from its pattern into space."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.mesh.quadmesh import FloatArray, unit_rows
from solver.unroll.strip import Strip

# Angles about a ruling or an edge, radians, below which a strip counts as plane there.
FLAT = 1e-9


@dataclass(frozen=True, eq=False)
class Ribbon:
    """A strip of constant width and thickness.

    Attributes:
        strip: axis and rulings; its points are the stations of the ribbon.
        lower: level of the lower edge, mm from the axis, square to it in the pattern.
        upper: level of the upper edge.
        thickness: of the plate, mm.
    """

    strip: Strip
    lower: float
    upper: float
    thickness: float

    @property
    def width(self) -> float:
        """Distance of the edges in the pattern, mm."""
        return self.upper - self.lower

    @cached_property
    def stretch(self) -> FloatArray:
        """(K,) length along the ruling per unit of level."""
        return self.strip.reach(1.0)

    def middle(self) -> tuple[FloatArray, FloatArray]:
        """Start (3,) of the edge in the middle, and the directions (3, 3) along, across and up."""
        return self.in_face(len(self.strip.lengths) // 2)

    def in_face(self, face: int) -> tuple[FloatArray, FloatArray]:
        """The same of any edge."""
        strip = self.strip
        along, up, side = strip.along[face], strip.across[0][face], self.sides[face]
        return strip.points[face], np.stack([along, up, side])

    def edge(self, level: float) -> FloatArray:
        """(K, 2) where the rulings reach a level, in the pattern."""
        strip = self.strip
        return np.asarray(strip.flat_points + (level * self.stretch)[:, None] * strip.flat_rulings)

    @cached_property
    def face_normals(self) -> tuple[FloatArray, FloatArray]:
        """(K - 1, 3) twice: normals of each face at its start and at its end."""
        start, end = self.strip.across
        return np.cross(self.strip.along, start), np.cross(self.strip.along, end)

    @cached_property
    def mitres(self) -> FloatArray:
        """(K, 3) from the middle of the plate to its upper side, along the mitre plane."""
        start, end = self.face_normals
        both = np.concatenate([start[:1], end[:-1] + start[1:], end[-1:]])
        cosine = np.concatenate([[1.0], np.einsum("fk,fk->f", end[:-1], start[1:]), [1.0]])
        scale = np.concatenate([[1.0], 1 + cosine[1:-1], [1.0]])
        return np.asarray(0.5 * self.thickness * both / scale[:, None])

    @cached_property
    def sides(self) -> FloatArray:
        """(K - 1, 3) unit normals of the faces where they begin."""
        return np.cross(self.strip.along, self.strip.across[0])

    @cached_property
    def flat_across(self) -> FloatArray:
        """(K - 1, 2) unit normals to each edge in the pattern, on the left."""
        steps = unit_rows(np.diff(self.strip.flat_points, axis=0))
        return np.stack([-steps[:, 1], steps[:, 0]], axis=1)

    def placed(self, face: int, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Map points (N, 2) of the pattern into space with one face.

        Returns:
            (N, 3) points in the middle of the plate and (N, 3) from there to its upper side.
        """
        strip = self.strip
        along, up, side = strip.along[face], strip.across[0][face], self.sides[face]
        arms = points - strip.flat_points[face]
        across = self.flat_across[face]
        x, y = arms @ np.array([across[1], -across[0]]), arms @ across
        angle = strip.twists[face] * x / strip.lengths[face]
        sine, cosine = np.sin(angle)[:, None], np.cos(angle)[:, None]
        place = strip.points[face] + x[:, None] * along + y[:, None] * (cosine * up + sine * side)
        return place, 0.5 * self.thickness * (cosine * side - sine * up)

    def ahead(self, station: int, points: FloatArray) -> FloatArray:
        """(N,) signed distance of points (N, 2) of the pattern from a ruling, ahead of it > 0."""
        ruling = self.strip.flat_rulings[station]
        arms = points - self.strip.flat_points[station]
        return np.asarray(arms[:, 0] * ruling[1] - arms[:, 1] * ruling[0])
