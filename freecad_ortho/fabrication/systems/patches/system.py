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

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.patches.parts import PatchMaker
from freecad_ortho.fabrication.systems.patches.pieces import NetPiece, pieces_of
from freecad_ortho.fabrication.systems.patches.sheet import half_thicknesses
from freecad_ortho.fabrication.systems.patches.splitting import cuts_to_fit
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
from freecad_ortho.fabrication.systems.system import SystemParts, Table, sums
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import QuadMesh
from solver.option import POSITIVE, Option
from solver.unroll.patch import FlatPatch, flattened

_COLUMNS = (
    *("part", "vertex_1", "vertex_2", "length_mm", "flat_mm"),
    *("distortion_mm", "distortion_percent"),
)


@dataclass(frozen=True)
class Patches(FromSheets):
    """One plate for each connected piece of the net, cut along the lines that are chosen.

    Args:
        thickness: of the plates, half to each side of the net, mm.
        gap: joint between pieces along a cut, mm; each ends half of it before the cut.
        distortion: largest change of an edge's length from the flat pattern that is built, percent.
        least_width: pieces at the border are left out where no circle of this diameter fits in, mm.

    Raises:
        InputError: a size that is not positive and finite.
    """

    thickness: float = 3.0
    gap: float = 10.0
    distortion: float = 1.0
    least_width: float = 60.0

    trims: ClassVar[bool] = True
    name: ClassVar[str] = "patches"
    excludes: ClassVar[Mapping[str, str]] = OVER_NODES
    options: ClassVar[tuple[Option, ...]] = (
        plate_thickness(3.0),
        joint(10.0, "patches"),
        Option(
            *("distortion", 1.0, "percent", "a patch is built up to this distortion of an edge"),
            within=POSITIVE,
        ),
        *SHEET_OPTIONS,
        LEAST_WIDTH,
    )

    def build(self, site: Site) -> SystemParts:
        """Lay the pieces flat.

        Raises:
            InputError: a piece that is not a grid, is not developable enough, overlaps itself when
                laid flat, is bent too sharply for its thickness, or that the gap leaves nothing of.
        """
        cuts = np.zeros(len(site.mesh.connectivity.edges), dtype=np.bool_)
        if not site.selection.everything:
            cuts |= site.chosen_edges
        made = np.ones(len(site.mesh.faces), dtype=np.bool_)
        if site.trimming is not None:
            made = site.trimming.made
        whole = _made(site.mesh, cuts, made)
        pieces, laid = self._fitting(site.mesh, cuts, made)
        piece_of_face = {face: piece.name for piece in pieces for face in piece.faces.tolist()}
        half = half_thicknesses(site.mesh, self.thickness)
        parts: list[Part] = []
        left_out: dict[str, float] = {}
        trimmed = 0
        for piece, patch in zip(pieces, laid, strict=True):
            maker = PatchMaker(
                *(site, piece, patch, half[piece.vertices], self.thickness, self.gap)
            )
            some, narrow = maker.parts(piece_of_face, self.least_width)
            parts += some
            left_out |= narrow
            if site.trimming is not None and not site.trimming.whole[piece.faces].all():
                trimmed += len(some)
        report = self._report(laid, tuple(parts))
        words = split_words("patch", whole, pieces, self.sheet)
        if site.trimming is not None:
            report |= trimming_report(trimmed, left_out)
            words += tuple(left_out_words(self.name, left_out, narrower(self.least_width)))
        table = Table("distortion.csv", _COLUMNS, _rows(pieces, laid))
        return SystemParts(tuple(parts), report, words, geometry=laid, tables=(table,))

    def _fitting(
        self, mesh: QuadMesh, cuts: BoolArray, made: BoolArray
    ) -> tuple[list[NetPiece], list[FlatPatch]]:
        """Pieces of the net and the same laid flat, cut along more lines until they fit a sheet.

        Those without faces that are made, (F,) true, are left out.
        """
        room = self.room
        known: dict[bytes, FlatPatch] = {}
        while True:
            pieces = _made(mesh, cuts, made)
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

    def _laid_flat(self, piece: NetPiece) -> FlatPatch:
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


def _made(mesh: QuadMesh, cuts: BoolArray, made: BoolArray) -> list[NetPiece]:
    """The pieces of a net that have faces which are made, (F,) true."""
    return [piece for piece in pieces_of(mesh, cuts) if made[piece.faces].any()]


def _rows(pieces: Sequence[NetPiece], laid: Sequence[FlatPatch]) -> tuple[tuple[object, ...], ...]:
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
