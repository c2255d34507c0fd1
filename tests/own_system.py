"""A system that the project does not have, with an option of its own, in one file."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from freecad_ortho.fabrication.bodies import BOX_SIDES, Polyhedron
from freecad_ortho.fabrication.part import part_names
from freecad_ortho.fabrication.pattern import FlatPattern
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import check_size
from freecad_ortho.fabrication.systems.system import System, SystemParts, sums
from solver.mesh.quadmesh import unit_rows
from solver.option import Option


@dataclass(frozen=True)
class Tags(System):
    """A square plate in the middle of every face."""

    thickness: float
    tag_size: float

    name: ClassVar[str] = "tags"
    options: ClassVar[tuple[Option, ...]] = (
        Option("thickness", 4.0, "length", "the plates are this thick"),
        Option("tag_size", 100.0, "length", "the tags are this wide"),
    )

    def __post_init__(self) -> None:
        check_size("tag size", self.tag_size)

    def build(self, site: Site) -> SystemParts:
        """Work out the tags."""
        mesh, size = site.mesh, self.tag_size
        outline = size * np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
        ends = [np.column_stack([outline, np.full(4, z)]) for z in (0.0, self.thickness)]
        body, corners = Polyhedron(np.concatenate(ends), BOX_SIDES), mesh.vertices[mesh.faces]
        along = unit_rows(corners[:, 2] - corners[:, 0])
        frames = np.stack([along, np.cross(mesh.face_normals, along), mesh.face_normals], axis=1)
        origins = corners.mean(axis=1) - 0.5 * size * (frames[:, 0] + frames[:, 1])
        parts = tuple(
            plate_part(
                *(site, name, "tag", body, (origins[face], frames[face])),
                *(FlatPattern(outline, (), outline.mean(axis=0), 0.1 * size), self.thickness),
                face=face,
            )
            for face, name in enumerate(part_names("T", len(corners)))
        )
        return SystemParts(parts, {"tag_size_mm": size, **sums(parts)})
