"""Bent plates that a border cuts."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.cut_sheets import CutPiece, cut_pieces
from freecad_ortho.fabrication.sheet_cells import BentSheet
from freecad_ortho.fabrication.systems.bent_panels.plate import BentPlate
from freecad_ortho.fabrication.trimming import Trimming
from solver.mesh.quadmesh import FloatArray


def trimmed_plate(plate: BentPlate, trimming: Trimming) -> list[CutPiece]:
    """What a border leaves of a plate, the widest piece first; numbers of faces are its row's."""
    sheet = _sheet(plate)
    regions = {}
    for number, face in enumerate(plate.row.faces.tolist()):
        if trimming.whole[face]:
            regions[number] = [sheet.polygon(number)]
        elif face in trimming.regions:
            regions[number] = trimming.flat_regions(face, _face_corners(plate, number))
    return cut_pieces(sheet, regions) if regions else []


def _sheet(plate: BentPlate) -> BentSheet:
    """The plate with what neighbours leave of it."""
    flat = plate.flat.reshape(-1, 2)
    rungs = len(flat) // 2
    number = np.arange(rungs - 1)
    faces = np.stack([number, number + 1, number + rungs + 1, number + rungs], axis=1)
    return BentSheet(flat, plate.body().corners.reshape(2, -1, 3), faces)


def _face_corners(plate: BentPlate, number: int) -> FloatArray:
    """(4, 2) corners of a whole face of the net in the plane of the strip, in the face's order."""
    strip = plate.ribbon.strip
    points, rulings = (
        some[number : number + 2] for some in (strip.flat_points, strip.flat_rulings)
    )
    arms = plate.reach[number : number + 2, None] * rulings
    (here, there), (left, behind) = points - arms, points + arms
    side = int(plate.row.first_sides[number])
    return np.roll([left, here, there, behind], side, axis=0)
