"""The system of bent panels: each row of faces between two parameter lines is one bent plate.

Where the faces are plane the row is developable and unrolls exactly, face by face.

Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.nesting.room import Room
from freecad_ortho.fabrication.part import Measures, Part
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import check_size
from freecad_ortho.fabrication.systems.bent_panels.plate import Plate, plate_of
from freecad_ortho.fabrication.systems.bent_panels.rows import Row, rows_of
from freecad_ortho.fabrication.systems.panels.geometry import (
    half_angle_tangents,
)
from freecad_ortho.fabrication.systems.sheets import SHEET_OPTIONS, room_on, split_words
from freecad_ortho.fabrication.systems.system import System, SystemParts, sums
from freecad_ortho.fabrication.workshop import Workshop
from solver.analysis.measures import diagonal_distances
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray
from solver.option import Option
from solver.unroll.measures import smallest_bend_radius

# Distance between a face's diagonals, in mean diagonals, above which it is not nearly plane.
_NEARLY_PLANE = 0.02


@dataclass(frozen=True)
class BentPanels(System):
    """One plate a row, half of its thickness to each side of the net.

    Args:
        thickness: of the plates, mm.
        gap: joint between neighbours, mm; each side shrinks by half of it, and by what plates that
            lean together need.
        sheet: size of the sheets that rows are cut short enough for, mm; None leaves them whole.
        spacing: from the rim of a sheet, mm.
        grain: "none" lets panels turn on a sheet, "along" does not.
        kerf: width of the cut, mm.

    Raises:
        InputError: a size that is not positive and finite.
    """

    thickness: float = 3.0
    gap: float = 10.0
    sheet: str | tuple[float, float] | None = None
    spacing: float = Workshop.spacing
    grain: str = Workshop.grain
    kerf: float = Workshop.kerf

    name: ClassVar[str] = "bent-panels"
    excludes: ClassVar[Mapping[str, str]] = {
        "nodes": "cannot be built together: the sheets run over the nodes; take panels, or leave "
        "the nodes out"
    }
    options: ClassVar[tuple[Option, ...]] = (
        Option("thickness", 3.0, "length", "the plates are this thick"),
        Option("gap", 10.0, "length", "the joint between two panels is this wide"),
        *SHEET_OPTIONS,
    )

    def __post_init__(self) -> None:
        check_size("panel thickness", self.thickness)
        check_size("gap", self.gap)
        _ = self._room

    @property
    def _room(self) -> Room | None:
        return room_on(self.sheet, self.spacing, self.grain, self.kerf)

    def build(self, site: Site) -> SystemParts:
        """Unroll the rows along the chosen family, those of u where both are chosen.

        Raises:
            InputError: faces that are not nearly plane, a gap that leaves nothing of a row, or a
                pattern that overlaps itself.
        """
        family = "u" if site.selection.family == "both" else site.selection.family
        rows = rows_of(site.lines, family)
        gaps = self._gaps(site)
        corner = site.mesh.vertices[site.mesh.faces]
        side = np.roll(corner, -1, axis=1) - corner
        bend = half_angle_tangents(site.mesh.connectivity, site.mesh.face_normals, side)
        insets = self.thickness / 2 * np.abs(np.nan_to_num(bend))
        chosen = [row for row in rows if _beside_chosen_line(site, row)]
        plates = [plate for row in chosen for plate in self._plates(site, row, insets)]
        others = [row for row in rows if row not in chosen]
        cut = [*(plate.row for plate in plates), *others]
        row_of_face = {face: row.name for row in cut for face in row.faces.tolist()}
        parts = tuple(
            self._part(site, family, plate.row, plate, gaps, row_of_face) for plate in plates
        )
        return SystemParts(
            *(parts, self._report(family, plates, parts)),
            split_words("row", chosen, parts, self.sheet),
            geometry=plates,
        )

    def _plates(self, site: Site, row: Row, insets: FloatArray) -> list[Plate]:
        """The plate of a row, or those of as few pieces as fit a sheet; whole where none do."""
        room, whole = self._room, [plate_of(site.mesh, row, self.thickness, self.gap, insets)]
        plates, count = whole, 1
        while room is not None and not all(room.holds(plate.outline) for plate in plates):
            count += 1
            if count > len(row.faces):
                return whole
            pieces = row.divided(whole[0].ribbon.strip.lengths, count)
            plates = [
                plate_of(site.mesh, piece, self.thickness, self.gap, insets) for piece in pieces
            ]
        return plates

    def _gaps(self, site: Site) -> FloatArray:
        """(F,) distance of each face from plane, mm."""
        gaps = diagonal_distances(site.mesh)
        corner = site.mesh.vertices[site.mesh.faces]
        diagonals = np.linalg.norm(corner[:, :2] - corner[:, 2:], axis=2).mean(axis=1)
        worst = int((gaps / diagonals).argmax())
        if gaps[worst] > _NEARLY_PLANE * diagonals[worst]:
            raise InputError(
                f"bent-panels: face {worst} is {gaps[worst]:.3g} mm from plane, "
                f"{100 * gaps[worst] / diagonals[worst]:.2g} % of its diagonals, and "
                f"{100 * _NEARLY_PLANE:g} % will do; optimise for a principal net first"
            )
        return gaps

    def _part(
        self,
        site: Site,
        family: str,
        row: Row,
        plate: Plate,
        gaps: FloatArray,
        row_of_face: dict[int, str],
    ) -> Part:
        """The part, its own coordinates in its middle face."""
        place = plate.ribbon.middle()
        bend = smallest_bend_radius(plate.ribbon.strip, plate.reach, flat_ends=False)
        return plate_part(
            site,
            row.name,
            "bent panel",
            plate.body().seen_from(*place),
            place,
            plate.pattern(_beside(site, row, row_of_face)),
            self.thickness,
            vertices=tuple(np.unique(row.rungs).tolist()),
            family=family,
            measures=Measures(
                gap_mm=float(gaps[row.faces].max()),
                min_bend_radius_mm=bend if np.isfinite(bend) else None,
            ),
        )

    def _report(
        self, family: str, plates: Sequence[Plate], parts: tuple[Part, ...]
    ) -> dict[str, Any]:
        bends = np.concatenate([plate.ribbon.strip.bends for plate in plates])
        radii = [part.measures.min_bend_radius_mm for part in parts]
        return {
            "thickness_mm": self.thickness,
            "gap_mm": self.gap,
            "family": family,
            "bend_max_deg": float(np.degrees(np.abs(bends).max())),
            "bend_radius_min_mm": min((r for r in radii if r is not None), default=None),
            "refold_max_mm": max(plate.refold_miss() for plate in plates),
            **sums(parts),
        }


def _beside_chosen_line(site: Site, row: Row) -> bool:
    """Whether one of the lines along a row is built on."""
    sides = (row.first_sides[:, None] + [1, 3]) % 4
    edges = site.mesh.connectivity.face_edges[row.faces[:, None], sides]
    return bool(site.chosen_edges[edges].any())


def _beside(site: Site, row: Row, row_of_face: dict[int, str]) -> tuple[str, str]:
    """Names of the rows on the right and left of the middle face, empty at the boundary."""
    middle = (len(row.faces) - 1) // 2
    face, side = int(row.faces[middle]), int(row.first_sides[middle])
    twins = (int(site.mesh.connectivity.twins[4 * face + (side + k) % 4]) for k in (1, 3))
    right, left = (row_of_face[twin // 4] if twin >= 0 else "" for twin in twins)
    return right, left
