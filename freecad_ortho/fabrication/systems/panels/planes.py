"""The planes of faces: where panels lie before they have a thickness."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.connectivity import IntArray, SameSize
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows


@dataclass(frozen=True, eq=False)
class Planes:
    """The best planes of faces, one row a face; mm.

    The letters are those of a quad mesh; of faces with n corners each 4 is n.

    Attributes:
        faces: (F, 4) vertices.
        middle: (F, 3) origins.
        frame: (F, 3, 3) rows along the first side, across it, normal.
        flat: (F, 4, 2) the faces' corners in them, counter-clockwise.
    """

    faces: IntArray
    middle: FloatArray
    frame: FloatArray
    flat: FloatArray

    @classmethod
    def of(cls, mesh: QuadMesh, same: SameSize | None = None) -> Planes:
        """Work out the planes of a mesh, or of some of its faces with equally many corners."""
        chosen = same or mesh.connectivity.by_size[0]
        corner = mesh.vertices[chosen.faces]
        middle = corner.mean(axis=1)
        normal = mesh.face_normals[chosen.numbers]
        side = corner[:, 1] - corner[:, 0]
        first = unit_rows(side - np.einsum("fk,fk->f", side, normal)[:, None] * normal)
        frame = np.stack([first, np.cross(normal, first), normal], axis=1)
        flat = np.einsum("fck,fdk->fcd", corner - middle[:, None], frame[:, :2])
        return cls(chosen.faces, middle, frame, flat)

    def in_space(self, points: FloatArray, level: FloatArray) -> FloatArray:
        """Points (F, 4, 2, 2) at levels (F,) above the planes as (F, 4, 2, 3)."""
        flat = np.einsum("fsed,fdk->fsek", points, self.frame[:, :2])
        foot = self.middle + level[:, None] * self.frame[:, 2]
        return np.asarray(foot[:, None, None] + flat)
