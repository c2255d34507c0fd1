"""The system of patches: whole sheets that are cut flat and bent into place.

Geodesic and Chebyshev nets with right angles lie on developable surfaces, which unroll.

Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, sections 4.1 and 4.2; Jiang et
al. (2021), Using isometries for computational design and fabrication.
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
from freecad_ortho.fabrication.sizes import check_size, positive
from freecad_ortho.fabrication.systems.patches.joints import jointed
from freecad_ortho.fabrication.systems.patches.pattern import patch_pattern
from freecad_ortho.fabrication.systems.patches.pieces import Piece, pieces_of
from freecad_ortho.fabrication.systems.patches.radius import smallest_radius
from freecad_ortho.fabrication.systems.patches.sheet import half_thicknesses, sheet_body
from freecad_ortho.fabrication.systems.patches.splitting import cuts_to_fit
from freecad_ortho.fabrication.systems.sheets import SHEET_OPTIONS, room_on, split_words
from freecad_ortho.fabrication.systems.system import System, SystemParts, Table, sums
from freecad_ortho.fabrication.workshop import Workshop
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.option import Option
from solver.unroll.patch import FlatPatch, flattened

_COLUMNS = (
    *("part", "vertex_1", "vertex_2", "length_mm", "flat_mm"),
    *("distortion_mm", "distortion_percent"),
)


@dataclass(frozen=True)
class Patches(System):
    """One plate for each connected piece of the net, cut along the lines that are chosen.

    Args:
        thickness: of the plates, half to each side of the net, mm.
        gap: joint between pieces along a cut, mm; each ends half of it before the cut.
        distortion: largest change of an edge's length from the flat pattern that is built, percent.
        sheet: size of the sheets that pieces are cut small enough for, mm; None leaves them whole.
        spacing: from the rim of a sheet, mm.
        grain: "none" lets pieces turn on a sheet, "along" does not.
        kerf: width of the cut, mm.

    Raises:
        InputError: a size that is not positive and finite.
    """

    thickness: float = 3.0
    gap: float = 10.0
    distortion: float = 1.0
    sheet: str | tuple[float, float] | None = None
    spacing: float = Workshop.spacing
    grain: str = Workshop.grain
    kerf: float = Workshop.kerf

    name: ClassVar[str] = "patches"
    excludes: ClassVar[Mapping[str, str]] = {
        "nodes": "cannot be built together: the sheets run over the nodes; take panels, or leave "
        "the nodes out"
    }
    options: ClassVar[tuple[Option, ...]] = (
        Option("thickness", 3.0, "length", "the plates are this thick"),
        Option("gap", 10.0, "length", "the joint between two patches is this wide"),
        Option("distortion", 1.0, "percent", "a patch is built up to this distortion of an edge"),
        *SHEET_OPTIONS,
    )

    def __post_init__(self) -> None:
        check_size("patch thickness", self.thickness)
        check_size("gap", self.gap)
        positive("distortion", self.distortion, "%")
        _ = self._room

    @property
    def _room(self) -> Room | None:
        return room_on(self.sheet, self.spacing, self.grain, self.kerf)

    def build(self, site: Site) -> SystemParts:
        """Lay the pieces flat.

        Raises:
            InputError: a piece that is not a grid, is not developable enough, overlaps itself when
                laid flat, is bent too sharply for its thickness, or that the gap leaves nothing of.
        """
        cuts = np.zeros(len(site.mesh.connectivity.edges), dtype=np.bool_)
        if not site.selection.everything:
            cuts |= site.chosen_edges
        whole = pieces_of(site.mesh, cuts)
        pieces, laid = self._fitting(site.mesh, cuts)
        piece_of_face = {face: piece.name for piece in pieces for face in piece.faces.tolist()}
        half = half_thicknesses(site.mesh, self.thickness)
        parts = tuple(
            self._part(site, piece, patch, half[piece.vertices], piece_of_face)
            for piece, patch in zip(pieces, laid, strict=True)
        )
        table = Table("distortion.csv", _COLUMNS, _rows(pieces, laid))
        return SystemParts(
            *(parts, self._report(laid, parts), split_words("patch", whole, parts, self.sheet)),
            geometry=laid,
            tables=(table,),
        )

    def _fitting(self, mesh: QuadMesh, cuts: BoolArray) -> tuple[list[Piece], list[FlatPatch]]:
        """Pieces of the net and the same laid flat, cut along more lines until they fit a sheet."""
        room = self._room
        known: dict[bytes, FlatPatch] = {}
        while True:
            pieces = pieces_of(mesh, cuts)
            for piece in pieces:
                faces = piece.faces.tobytes()
                known[faces] = known.get(faces) or self._laid_flat(piece)
            laid = [known[piece.faces.tobytes()] for piece in pieces]
            more = np.zeros_like(cuts)
            if room is not None:
                for piece, patch in zip(pieces, laid, strict=True):
                    more[cuts_to_fit(mesh, piece, patch, room)] = True
            if not more.any():
                return pieces, laid
            cuts = cuts | more

    def _laid_flat(self, piece: Piece) -> FlatPatch:
        try:
            patch = flattened(piece.mesh)
        except InputError as error:
            raise InputError(
                f"patches: {piece.name}: {error} (family and lines choose where to cut)"
            ) from error
        worst = int(np.abs(patch.strain).argmax())
        percent = 100 * abs(float(patch.strain[worst]))
        if percent > self.distortion:
            ends = piece.vertices[patch.bent.connectivity.edges[worst]].tolist()
            raise InputError(
                f"patches: {piece.name} is not developable: laid flat, the edge from vertex "
                f"{ends[0]} to {ends[1]} changes by {abs(patch.stretch[worst]):.3g} mm, "
                f"{percent:.3g} %, and {self.distortion:g} % are allowed; optimise for a "
                "geodesic and Chebyshev net, or choose a family and lines of it to cut along"
            )
        return patch

    def _part(
        self,
        site: Site,
        piece: Piece,
        patch: FlatPatch,
        half: FloatArray,
        piece_of_face: dict[int, str],
    ) -> Part:
        """The part, its own coordinates in the face nearest to the middle."""
        bend, stretch = smallest_radius(piece.mesh), float(np.abs(patch.stretch).max())
        patch, half = jointed(site.mesh, piece, patch, half, self.gap)
        mesh = patch.bent
        middles = mesh.vertices[mesh.faces].mean(axis=1)
        face = int(np.linalg.norm(middles - middles.mean(axis=0), axis=1).argmin())
        corner = mesh.vertices[mesh.faces[face]]
        normal = mesh.face_normals[face]
        along = corner[1] - corner[0]
        x = unit_rows((along - (along @ normal) * normal)[None])[0]
        frame = np.stack([x, np.cross(normal, x), normal])
        place = middles[face], frame
        body = sheet_body(mesh, half, self.thickness, piece.name)
        return plate_part(
            site,
            piece.name,
            "patch",
            body.seen_from(*place),
            place,
            patch_pattern(site, piece, patch, piece_of_face),
            self.thickness,
            vertices=tuple(np.unique(piece.vertices).tolist()),
            measures=Measures(
                gap_mm=stretch,
                min_bend_radius_mm=bend if np.isfinite(bend) else None,
            ),
        )

    def _report(self, laid: Sequence[FlatPatch], parts: tuple[Part, ...]) -> dict[str, Any]:
        stretch = np.abs(np.concatenate([patch.stretch for patch in laid]))
        percent = 100 * np.abs(np.concatenate([patch.strain for patch in laid]))
        radii = [part.measures.min_bend_radius_mm for part in parts]
        return {
            "thickness_mm": self.thickness,
            "gap_mm": self.gap,
            "distortion_max_mm": float(stretch.max()),
            "distortion_mean_mm": float(stretch.mean()),
            "distortion_max_percent": float(percent.max()),
            "distortion_mean_percent": float(percent.mean()),
            "bend_radius_min_mm": min((r for r in radii if r is not None), default=None),
            **sums(parts),
        }


def _rows(pieces: Sequence[Piece], laid: Sequence[FlatPatch]) -> tuple[tuple[object, ...], ...]:
    """One row an edge of a piece: what it changes by from the pattern to its place."""
    rows: list[tuple[object, ...]] = []
    for piece, patch in zip(pieces, laid, strict=True):
        ends = piece.vertices[patch.bent.connectivity.edges]
        numbers = zip(
            ends.tolist(),
            patch.bent.edge_lengths.tolist(),
            patch.flat.edge_lengths.tolist(),
            patch.stretch.tolist(),
            (100 * patch.strain).tolist(),
            strict=True,
        )
        rows += [
            (piece.name, *pair, f"{bent:.6f}", f"{flat:.6f}", f"{by:.6f}", f"{share:.6f}")
            for pair, bent, flat, by, share in numbers
        ]
    return tuple(rows)
