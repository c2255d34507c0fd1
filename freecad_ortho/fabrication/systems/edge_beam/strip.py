"""An edge beam of strips: flat plates that are bent where the pieces of the way meet.

A strip ends where the stock does, and where the border turns too sharply to bend a plate; between
its bends it is plane, so it unrolls exactly.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from freecad_ortho.fabrication.folded import Chain, FoldedPlate, folded_plate
from freecad_ortho.fabrication.level_plate import LevelPlate
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.pattern import FlatPattern, overlaps_itself
from freecad_ortho.fabrication.plates import plate_part
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from freecad_ortho.fabrication.systems.edge_beam.parts import bends, edge_table
from freecad_ortho.fabrication.systems.edge_beam.sections import EdgeSection
from freecad_ortho.fabrication.systems.system import Table
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# Turns that are no bend, degrees.
_STRAIGHT = 0.05


def strip_parts(
    site: Site, geometry: EdgeGeometry, section: EdgeSection
) -> tuple[tuple[Part, ...], Table, dict[str, Any]]:
    """The strips, the table of their lengths and joints, and what the report says of bends.

    Args:
        site: the net.
        geometry: of the pieces, laid for a strip.
        section: a strip.

    Raises:
        InputError: a strip that overlaps itself when it is flat.
    """
    assert geometry.strips is not None
    runs, rulings = geometry.strips.runs, geometry.strips.rulings
    names = _names([int(geometry.way[run[0]]) for run in runs])
    starting = {run[0]: name for run, name in zip(runs, names, strict=True)}
    ending = {run[-1]: name for run, name in zip(runs, names, strict=True)}
    angles = bends(geometry)
    parts, rows = [], []
    for run, name in zip(runs, names, strict=True):
        beside = ending[int(geometry.before[run[0]])], starting[int(geometry.behind[run[-1]])]
        plate = folded_plate(_chain(geometry, section, run, rulings))
        if overlaps_itself(plate.outline):
            raise InputError(
                f"edge beam: the flat pattern of {name} overlaps itself; take a shorter stock"
            )
        place = geometry.start[run[0]], geometry.frame[run[0]]
        pattern = _pattern(name, plate, beside)
        body = plate.body
        parts.append(
            plate_part(
                *(site, name, "edge-beam", body, place, pattern, section.width),
                height=section.height,
            )
        )
        length = round(float(geometry.length[run].sum()), 3)
        rows.append((name, section.words, length, beside[1], *np.round(angles[run[-1]], 6)))
    bent = [abs(bend.angle_deg) for part in parts if part.pattern for bend in part.pattern.bends]
    said = {
        "strips": len(parts),
        "bends_in_strips": len(bent),
        "strip_bend_max_deg": max(bent, default=0.0),
    }
    return tuple(parts), edge_table(rows), said


def _names(ways: list[int]) -> list[str]:
    """E1-001 for the first strip of the first way."""
    digits = max(3, len(str(len(ways))))
    return [f"E{way + 1}-{k - ways.index(way) + 1:0{digits}d}" for k, way in enumerate(ways)]


def _offsets(geometry: EdgeGeometry, run: IntArray, rulings: FloatArray) -> FloatArray:
    """(K + 1, 3) along the bend lines per mm of height: as high as the strip in their plates' mean.

    A line that leans is longer than the strip is high.
    """
    along = geometry.frame[run, 0]
    lean = np.einsum("nek,nk->ne", rulings[run], along)
    rise = np.sqrt(1 - lean**2)
    rise = np.concatenate([rise[:1, 0], (rise[:-1, 1] + rise[1:, 0]) / 2, rise[-1:, 1]])
    lines = np.concatenate([rulings[run, 0], rulings[run[-1:], 1]])
    return np.asarray(lines / rise[:, None])


def _chain(
    geometry: EdgeGeometry, section: EdgeSection, run: IntArray, rulings: FloatArray
) -> Chain:
    """The plates of a strip; its vertices lie on its upper side."""
    nodes = np.append(run, geometry.behind[run[-1]])
    first, last = geometry.mitres[run[0], 0], geometry.mitres[run[-1], 1]
    slopes = [normal[2] / normal[0] for normal in (first, last)]
    return Chain(
        geometry.start[nodes],
        _offsets(geometry, run, rulings),
        geometry.frame[run],
        (-section.height, 0.0),
        section.width / 2,
        (None,) * len(nodes),
        ((-slopes[0], slopes[0]), (slopes[1], -slopes[1])),
        (0.0, 0.0),
    )


def _pattern(name: str, plate: FoldedPlate, beside: tuple[str, str]) -> FlatPattern:
    """The unrolled strip, its ends level, with the names of those that it meets."""
    level = LevelPlate.of(plate)
    marks = [
        level.mark(text, step, ahead, 0.24, 0.4, 15.0)
        for text, step, ahead in ((beside[0], 0, -0.32), (beside[1], -1, 0.32))
    ]
    pattern = level.pattern(name, marks, 0.0, 0.3, 0.5)
    bends = (bend for bend in pattern.bends if abs(bend.angle_deg) > _STRAIGHT)
    return replace(pattern, bends=tuple(bends))
