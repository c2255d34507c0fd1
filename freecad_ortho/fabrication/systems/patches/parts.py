"""Patches as parts: whole, or what a border leaves of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from freecad_ortho.fabrication.cut_patterns import cut_pattern
from freecad_ortho.fabrication.cut_sheets import CutPiece, cut_pieces
from freecad_ortho.fabrication.part import Measures, Part, piece_name
from freecad_ortho.fabrication.pattern import FlatPattern
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.sheet_cells import BentSheet
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.patches.joints import jointed
from freecad_ortho.fabrication.systems.patches.pattern import patch_pattern
from freecad_ortho.fabrication.systems.patches.pieces import NetPiece
from freecad_ortho.fabrication.systems.patches.radius import smallest_radius
from freecad_ortho.fabrication.systems.patches.sheet import sheet_body
from freecad_ortho.fabrication.trimming import Trimming
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.unroll.patch import FlatPatch


class PatchMaker:
    """Makes the parts of one piece of the net."""

    def __init__(
        self,
        site: Site,
        piece: NetPiece,
        laid: FlatPatch,
        half: FloatArray,
        thickness: float,
        gap: float,
    ) -> None:
        """Shorten a piece along its joints.

        Args:
            site: of the net.
            piece: of it.
            laid: the piece in space and in the plane.
            half: (K, 3) from its vertices to the upper side of the plate.
            thickness: of the plate, mm.
            gap: between two pieces, mm.

        Raises:
            InputError: a gap that leaves nothing of a face, or a thickness at which it folds over.
        """
        self._site, self._piece, self._laid, self._thickness = site, piece, laid, thickness
        self._patch, self._half = jointed(site.mesh, piece, laid, half, gap)
        self._body = sheet_body(self._patch.bent, self._half, thickness, piece.name)

    def parts(
        self, piece_of_face: Mapping[int, str], least_width: float
    ) -> tuple[list[Part], dict[str, float]]:
        """The parts, and by their names areas of pieces too narrow to make, mm2.

        Args:
            piece_of_face: name of the piece that each face of the net belongs to.
            least_width: of the largest circle that fits into a piece, mm.

        Raises:
            InputError: the pattern overlaps itself.
        """
        import shapely

        site, piece = self._site, self._piece
        whole = patch_pattern(site, piece, self._patch, piece_of_face)
        trimming = site.trimming
        if trimming is None or trimming.whole[piece.faces].all():
            every = np.arange(len(piece.faces))
            return [self._part(piece.name, self._body, whole, every)], {}
        parts, left_out = [], {}
        low = self._patch.flat.vertices[:, :2].min(axis=0)
        for number, cut in enumerate(self._cut(trimming)):
            name = piece_name(piece.name, number)
            if cut.width < least_width:
                left_out[name] = cut.outline.area
                continue
            outline = shapely.transform(cut.outline, lambda points: points - low)
            pattern = cut_pattern(whole, name, outline, cut.middle - low, cut.width)
            parts.append(self._part(name, cut.body, pattern, cut.faces))
        return parts, left_out

    def _cut(self, trimming: Trimming) -> list[CutPiece]:
        """What a border leaves of the patch, the widest piece first."""
        bent, flat = self._patch.bent.vertices, self._patch.flat
        sides = np.stack([bent - self._half, bent + self._half])
        sheet = BentSheet(flat.vertices[:, :2], sides, flat.faces)
        corners = self._laid.flat.vertices[flat.faces, :2]
        regions = {}
        for number, face in enumerate(self._piece.faces.tolist()):
            if trimming.whole[face]:
                regions[number] = [sheet.polygon(number)]
            elif face in trimming.regions:
                regions[number] = trimming.flat_regions(face, corners[number])
        return cut_pieces(sheet, regions)

    def _part(self, name: str, body: RuledBody, pattern: FlatPattern, faces: Iterable[int]) -> Part:
        """The part on some faces of the piece."""
        chosen = list(faces)
        bend, stretch = smallest_radius(self._piece.mesh), np.abs(self._laid.stretch)
        place = _place(self._patch.bent, chosen)
        vertices = self._piece.vertices[self._patch.bent.faces[chosen]]
        return plate_part(
            self._site,
            name,
            "patch",
            body.seen_from(*place),
            place,
            pattern,
            self._thickness,
            vertices=tuple(np.unique(vertices).tolist()),
            measures=Measures(
                gap_mm=float(stretch.max()),
                min_bend_radius_mm=bend if np.isfinite(bend) else None,
            ),
        )


def _place(mesh: QuadMesh, faces: list[int]) -> tuple[FloatArray, FloatArray]:
    """Origin (3,) and directions (3, 3) in that of some faces which is nearest to their middle."""
    middles = mesh.vertices[mesh.faces[faces]].mean(axis=1)
    nearest = int(np.linalg.norm(middles - middles.mean(axis=0), axis=1).argmin())
    corner, normal = mesh.vertices[mesh.faces[faces[nearest]]], mesh.face_normals[faces[nearest]]
    along = corner[1] - corner[0]
    x = unit_rows((along - (along @ normal) * normal)[None])[0]
    return middles[nearest], np.stack([x, np.cross(normal, x), normal])
