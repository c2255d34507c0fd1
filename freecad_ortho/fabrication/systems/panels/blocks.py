"""Setting blocks: what panels stand on in their frames, as a list with places and loads."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from freecad_ortho.fabrication.bodies import BOX_CORNERS, BOX_SIDES, Polyhedron
from freecad_ortho.fabrication.fasteners import Supply
from freecad_ortho.fabrication.material import Material
from freecad_ortho.fabrication.part import Measures, Part
from freecad_ortho.fabrication.systems.system import Table
from solver.mesh.quadmesh import FloatArray, unit_rows

# A block is this long, and as far from the corner, mm: Technische Richtlinie des Glaserhandwerks
# No. 3, EN 12488. On short sides blocks stand at a quarter of them.
_LENGTH = 100.0
# Above the thickness of the panel, and of the block itself, mm.
_WIDER, _THICKNESS = 2.0, 5.0
# Sides that are shorter carry no panel while there is a longer one, mm.
_SHORT = 300.0
_GRAVITY = 9.81
# Polypropylene, as blocks are made of (EN 12488 asks for what bears and stays so).
PLASTIC = Material("polypropylene", 910.0, 1300.0, 25.0, 5.0)
COLUMNS = (*("panel", "block", "x_mm", "y_mm", "length_mm", "width_mm", "thickness_mm", "load_N"),)


def setting_blocks(panels: Sequence[Part]) -> Table:
    """Two blocks below the lowest side of each panel, placed in its flat pattern.

    The load is the share of the panel's weight that acts in its plane.
    """
    rows: list[tuple[object, ...]] = []
    for panel in panels:
        assert panel.pattern is not None
        places, slope = _places(panel.pattern.outline, panel.frame)
        load = panel.mass * _GRAVITY * slope / len(places)
        for number, (x, y) in enumerate(places.tolist()):
            sizes = (_LENGTH, panel.thickness + _WIDER, _THICKNESS)
            rows.append(
                (
                    *(panel.name, number + 1, f"{x:.3f}", f"{y:.3f}"),
                    *(*(f"{size:g}" for size in sizes), f"{load:.1f}"),
                )
            )
    return Table("setting-blocks.csv", COLUMNS, tuple(rows))


def block_supplies(panels: Sequence[Part]) -> tuple[Supply, ...]:
    """Setting blocks by size: two for each panel."""
    widths: dict[float, int] = {}
    for panel in panels:
        width = round(panel.thickness + _WIDER, 3)
        widths[width] = widths.get(width, 0) + 2
    return tuple(
        Supply("setting block", f"{_LENGTH:g}x{width:g}x{_THICKNESS:g}", count, "piece", "panels")
        for width, count in sorted(widths.items())
    )


def block_parts(panels: Sequence[Part], joint: float) -> Iterator[Part]:
    """Setting blocks as parts: beside the lowest side of each panel, in its plane.

    There are none where a joint, mm, has no room for those of both of its panels.
    """
    for panel in panels if joint >= 2 * _THICKNESS else ():
        assert panel.pattern is not None
        outline = panel.pattern.outline
        places, _ = _places(outline, panel.frame)
        along = unit_rows((places[1] - places[0])[None])[0]
        turn = np.array([[*along, 0.0], [-along[1], along[0], 0.0], [0.0, 0.0, 1.0]])
        wide = panel.thickness + _WIDER
        low = np.array([-_LENGTH / 2, -_THICKNESS, -_WIDER / 2])
        high = np.array([_LENGTH / 2, 0.0, wide - _WIDER / 2])
        body = Polyhedron(np.where(BOX_CORNERS, high, low), BOX_SIDES)
        for number, place in enumerate(places):
            yield replace(
                panel,
                name=f"{panel.name}-block-{number + 1}",
                kind="setting-block",
                body=body,
                origin=panel.origin + place @ panel.frame[:2],
                frame=turn @ panel.frame,
                pattern=None,
                length=_LENGTH,
                width=wide,
                thickness=_THICKNESS,
                area=_LENGTH * wide,
                volume=body.volume,
                material=PLASTIC,
                measures=Measures(),
                weighed=None,
                assembly="",
                note="",
            )


def _places(outline: FloatArray, frame: FloatArray) -> tuple[FloatArray, float]:
    """(2, 2) middles of the blocks along the lowest side, and the sine of the plane's slope."""
    side = np.roll(outline, -1, axis=0) - outline
    length = np.linalg.norm(side, axis=1)
    outward = np.column_stack([side[:, 1], -side[:, 0]]) / length[:, None]
    down = -frame[:2, 2]
    long = length >= min(_SHORT, float(length.max()))
    lowest = int(np.where(long, outward @ down, -np.inf).argmax())
    away = min(1.5 * _LENGTH, float(length[lowest]) / 4) / length[lowest]
    shares = np.array([[away], [1.0 - away]])
    return outline[lowest] + shares * side[lowest], float(np.linalg.norm(down))
