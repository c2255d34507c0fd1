"""The system of bent panels: each row of faces between two parameter lines is one bent plate.

Where the faces are plane the row is developable and unrolls exactly, face by face.

Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from freecad_ortho.fabrication.cut_patterns import cut_pattern
from freecad_ortho.fabrication.cut_sheets import CutPiece
from freecad_ortho.fabrication.part import Measures, Part, piece_name
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.bent_panels.plate import BentPlate, plate_of
from freecad_ortho.fabrication.systems.bent_panels.rows import Row, rows_of
from freecad_ortho.fabrication.systems.bent_panels.trimmed import trimmed_plate
from freecad_ortho.fabrication.systems.panels.geometry import (
    half_angle_tangents,
)
from freecad_ortho.fabrication.systems.shared_options import LEAST_WIDTH, joint, plate_thickness
from freecad_ortho.fabrication.systems.sheets import (
    OVER_NODES,
    SHEET_OPTIONS,
    FromSheets,
    left_out_words,
    narrower,
    split_words,
    trimming_report,
)
from freecad_ortho.fabrication.systems.system import SystemParts, sums
from solver.analysis.measures import diagonal_distances
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray
from solver.option import Option
from solver.unroll.measures import smallest_bend_radius

# Distance between a face's diagonals, in mean diagonals, above which it is not nearly plane.
_NEARLY_PLANE = 0.02
# Part of a length that counts as the same.
_SAME = 1e-9


@dataclass(frozen=True, eq=False)
class _Cut:
    """A plate, or a piece that a border leaves of it."""

    name: str
    plate: BentPlate
    piece: CutPiece | None

    @property
    def faces(self) -> tuple[int, ...]:
        """Numbers in the row of the faces that it has a part of."""
        return tuple(range(len(self.plate.row.faces))) if self.piece is None else self.piece.faces

    @property
    def middle(self) -> int:
        """The middle one of them."""
        return self.faces[(len(self.faces) - 1) // 2]


@dataclass(frozen=True)
class BentPanels(FromSheets):
    """One plate a row, half of its thickness to each side of the net.

    Args:
        thickness: of the plates, mm.
        gap: joint between neighbours, mm; each side shrinks by half of it, and by what plates that
            lean together need.
        least_width: pieces at the border are left out where no circle of this diameter fits in, mm.
        piece_length: rows are cut along lines of the net into pieces of at most this length along
            their middle, mm; None leaves them whole.

    Raises:
        InputError: a size that is not positive and finite.
    """

    thickness: float = 3.0
    gap: float = 10.0
    least_width: float = 60.0
    piece_length: float | None = None

    trims: ClassVar[bool] = True
    name: ClassVar[str] = "bent-panels"
    excludes: ClassVar[Mapping[str, str]] = OVER_NODES
    options: ClassVar[tuple[Option, ...]] = (
        plate_thickness(3.0),
        joint(10.0),
        *SHEET_OPTIONS,
        LEAST_WIDTH,
        Option(
            "piece_length",
            None,
            "length",
            "rows are cut along lines of the net into pieces of at most this length",
            absent="whole rows",
        ),
    )

    def build(self, site: Site) -> SystemParts:
        """Unroll the rows along the chosen family, those of u where both are chosen.

        Raises:
            InputError: faces that are not nearly plane, a gap that leaves nothing of a row, or a
                pattern that overlaps itself.
        """
        family = "u" if site.selection.family == "both" else site.selection.family
        made = np.ones(len(site.mesh.faces), dtype=bool)
        if site.trimming is not None:
            made = site.trimming.made
        rows = [run for row in rows_of(site.lines, family) for run in row.runs(made)]
        gaps = self._gaps(site, made)
        corner = site.mesh.vertices[site.mesh.faces]
        side = np.roll(corner, -1, axis=1) - corner
        bend = half_angle_tangents(site.mesh.connectivity, site.mesh.face_normals, side)
        insets = self._insets(np.abs(np.nan_to_num(bend)))
        chosen = [row for row in rows if _beside_chosen_line(site, row)]
        plates = [plate for row in chosen for plate in self._plates(site, row, insets)]
        cuts, left_out = self._cuts(site, plates)
        names = {face: row.name for row in rows for face in row.faces.tolist()}
        for cut in cuts:
            names |= dict.fromkeys(cut.plate.row.faces[list(cut.faces)].tolist(), cut.name)
        parts = tuple(self._part(site, family, cut, gaps, names) for cut in cuts)
        report = self._report(family, plates, parts)
        room = self.room
        large = 0 if room is None else sum(not room.holds(plate.outline) for plate in plates)
        words = self._words(chosen, plates, large)
        if site.trimming is not None:
            trimmed = sum(cut.piece is not None for cut in cuts)
            areas = {name: piece.outline.area for name, piece in left_out.items()}
            report |= trimming_report(trimmed, areas)
            words += tuple(left_out_words(self.name, areas, narrower(self.least_width)))
        return SystemParts(parts, report, words, geometry=plates)

    def _insets(self, bend: FloatArray) -> FloatArray:
        """(F, 4) by how much more than half of the gap sides move inwards, mm.

        Two plates that meet at an angle are nearest on the side to which they lean: corners half a
        thickness off the net approach by its part of the tangent, and the gap between them is
        measured straight across, not along the plates.

        Args:
            bend: (F, 4) tangents of half the angle between the normals of faces across a side.
        """
        return self.thickness / 2 * bend + self.gap / 2 * (np.hypot(1.0, bend) - 1.0)

    def _cuts(
        self, site: Site, plates: Sequence[BentPlate]
    ) -> tuple[list[_Cut], dict[str, CutPiece]]:
        """The plates, or what a border leaves of them; by their names pieces too narrow to make."""
        cuts: list[_Cut] = []
        left_out: dict[str, CutPiece] = {}
        counts: dict[str, int] = {}
        for plate in plates:
            name = plate.row.name
            pieces: list[CutPiece | None] = [None]
            if site.trimming is not None and not site.trimming.whole[plate.row.faces].all():
                pieces = [*trimmed_plate(plate, site.trimming)]
            for piece in pieces:
                own = piece_name(name, counts.get(name, 0))
                counts[name] = counts.get(name, 0) + 1
                if piece is not None and piece.width < self.least_width:
                    left_out[own] = piece
                else:
                    cuts.append(_Cut(own, plate, piece))
        return cuts, left_out

    def _words(
        self, chosen: Sequence[Row], plates: Sequence[BentPlate], large: int
    ) -> tuple[str, ...]:
        """What is to be said where rows were cut."""
        if self.piece_length is None or len(plates) <= len(chosen):
            return split_words("row", chosen, plates, self.sheet, large)
        fit = "" if self.room is None else f"; {large or 'none'} of them too large for the sheet"
        return (
            f"piece_length: {len(chosen)} rows are cut along lines of the net into {len(plates)} "
            f"pieces, the longest of {max(plate.length for plate in plates):.1f} mm{fit}",
        )

    def _fits(self, plate: BentPlate) -> bool:
        """Whether a plate is short enough, and small enough for a sheet."""
        room = self.room
        short = self.piece_length is None or plate.length <= self.piece_length * (1 + _SAME)
        return short and (room is None or room.holds(plate.outline))

    def _plates(self, site: Site, row: Row, insets: FloatArray) -> list[BentPlate]:
        """The plate of a row, or those of as few pieces as fit; whole if no face does.

        Raises:
            InputError: a face that is longer than pieces may be.
        """

        def plate(piece: Row) -> BentPlate:
            return plate_of(site.mesh, piece, self.thickness, self.gap, insets)

        whole = [plate(row)]
        lengths = whole[0].ribbon.strip.lengths
        self._refuse_long_faces(row, lengths)
        plates, count = whole, 1
        while not all(self._fits(one) for one in plates):
            count += 1
            if count > len(row.faces):
                # Single faces by now: those that fit no sheet stay alone, the others need not.
                if not any(self._fits(one) for one in plates):
                    return whole
                return [
                    plate(piece) for piece in row.filled(lambda piece: self._fits(plate(piece)))
                ]
            plates = [plate(piece) for piece in row.divided(lengths, count)]
        return plates

    def _refuse_long_faces(self, row: Row, lengths: FloatArray) -> None:
        longest = int(lengths.argmax())
        if self.piece_length is None or lengths[longest] <= self.piece_length * (1 + _SAME):
            return
        raise InputError(
            f"piece_length: face {int(row.faces[longest])} of {row.name} is {lengths[longest]:.1f} "
            f"mm long and pieces may be {self.piece_length:g} mm; pieces are cut at lines of the "
            "net only, so allow longer ones or subdivide the net"
        )

    def _gaps(self, site: Site, made: BoolArray) -> FloatArray:
        """(F,) distance of each face from plane, mm."""
        gaps = diagonal_distances(site.mesh)
        corner = site.mesh.vertices[site.mesh.faces]
        diagonals = np.linalg.norm(corner[:, :2] - corner[:, 2:], axis=2).mean(axis=1)
        worst = int(np.where(made, gaps / diagonals, 0.0).argmax())
        if gaps[worst] > _NEARLY_PLANE * diagonals[worst]:
            raise InputError(
                f"bent-panels: face {worst} is {gaps[worst]:.3g} mm from plane, "
                f"{100 * gaps[worst] / diagonals[worst]:.2g} % of its diagonals, and "
                f"{100 * _NEARLY_PLANE:g} % will do; optimise for a principal net first"
            )
        return gaps

    def _part(
        self, site: Site, family: str, cut: _Cut, gaps: FloatArray, names: dict[int, str]
    ) -> Part:
        """The part, its own coordinates in its middle face."""
        plate, piece = cut.plate, cut.piece
        row, middle = plate.row, cut.middle
        place = plate.ribbon.in_face(cut.faces[len(cut.faces) // 2])
        bend = smallest_bend_radius(plate.ribbon.strip, plate.reach, flat_ends=False)
        pattern = plate.pattern(_beside(site, row, middle, names), middle)
        if piece is not None:
            outline, label = plate.placed_within(piece.outline), plate.placed(piece.middle)
            pattern = cut_pattern(pattern, cut.name, outline, label, piece.width)
        body = plate.body() if piece is None else piece.body
        return plate_part(
            site,
            cut.name,
            "bent panel",
            body.seen_from(*place),
            place,
            pattern,
            self.thickness,
            vertices=tuple(np.unique(row.rungs[[*cut.faces, cut.faces[-1] + 1]]).tolist()),
            family=family,
            measures=Measures(
                gap_mm=float(gaps[row.faces[list(cut.faces)]].max()),
                min_bend_radius_mm=bend if np.isfinite(bend) else None,
            ),
        )

    def _report(
        self, family: str, plates: Sequence[BentPlate], parts: tuple[Part, ...]
    ) -> dict[str, Any]:
        bends = np.concatenate([plate.ribbon.strip.bends for plate in plates])
        radii = [part.measures.min_bend_radius_mm for part in parts]
        return {
            "thickness_mm": self.thickness,
            "gap_mm": self.gap,
            "family": family,
            "bend_max_deg": float(np.degrees(np.abs(bends).max())),
            "bend_radius_min_mm": min((r for r in radii if r is not None), default=None),
            "pieces": len(plates),
            "piece_length_max_mm": max(plate.length for plate in plates),
            "refold_max_mm": max(plate.refold_miss() for plate in plates),
            **sums(parts),
        }


def _beside_chosen_line(site: Site, row: Row) -> bool:
    """Whether one of the lines along a row is built on."""
    sides = (row.first_sides[:, None] + [1, 3]) % 4
    edges = site.mesh.connectivity.face_edges[row.faces[:, None], sides]
    return bool(site.chosen_edges[edges].any())


def _beside(site: Site, row: Row, number: int, names: dict[int, str]) -> tuple[str, str]:
    """Names of the rows on the right and left of a face of a row, empty where there is none."""
    face, side = int(row.faces[number]), int(row.first_sides[number])
    twins = (int(site.mesh.connectivity.twins[4 * face + (side + k) % 4]) for k in (1, 3))
    right, left = (names.get(twin // 4, "") if twin >= 0 else "" for twin in twins)
    return right, left
