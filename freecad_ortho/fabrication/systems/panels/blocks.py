"""Setting blocks: what panels stand on in their frames, as a list with places and loads."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freecad_ortho.fabrication.fasteners import Supply
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.systems.system import Table
from solver.mesh.quadmesh import FloatArray

# A block is this long, and as far from the corner, mm: Technische Richtlinie des Glaserhandwerks
# No. 3, EN 12488. On short sides blocks stand at a quarter of them.
_LENGTH = 100.0
# Above the thickness of the panel, and of the block itself, mm.
_WIDER, _THICKNESS = 2.0, 5.0
# Sides that are shorter carry no panel while there is a longer one, mm.
_SHORT = 300.0
_GRAVITY = 9.81
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
