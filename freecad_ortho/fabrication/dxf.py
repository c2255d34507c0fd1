"""DXF: the true outline of every part, one block a part, laid out in rows."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.pattern import FlatPattern
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.layouts import BaseLayout, BlockLayout

    from freecad_ortho.fabrication.nesting import Sheet

SPACING = 30.0
# Name and colour, in the order in which a workshop looks at them.
LAYERS = {"CUT": 7, "HOLE": 5, "AXIS": 4, "BEND": 6, "ENGRAVE": 1, "LABEL": 3}
# A stroke font: letters are single lines for a plotter, a laser or an engraver to follow.
_STYLE, _FONT = "SINGLE_STROKE", "txt.shx"
_MILLIMETRES = 4
# Text height of what a sheet is, above its rim, mm.
_TITLE = 40.0


def write_dxf(path: Path, patterns: Mapping[str, FlatPattern]) -> None:
    """Write flat patterns in rows, in mm.

    Layers: CUT the closed outlines and cutouts, HOLE circles, AXIS the unrolled parameter line,
    BEND bend lines, ENGRAVE lines and texts (dashed: on the far side of the plate), LABEL the
    names.

    Args:
        path: file to write.
        patterns: by the parts' names; each becomes a block of that name and one insert of it.

    Raises:
        OSError: the file cannot be written.
    """
    places = row_layout(list(patterns.values()))
    with _fixed_meta_data():
        drawing = _empty_drawing()
        space = drawing.modelspace()
        for (name, pattern), place in zip(patterns.items(), places, strict=True):
            _fill_block(drawing.blocks.new(name), name, pattern)
            space.add_blockref(name, place.tolist())
        drawing.saveas(path)


def write_sheet(path: Path, sheet: Sheet) -> None:
    """Write one nested sheet in mm, a turned block a part; rim and title on layer SHEET.

    Raises:
        OSError: the file cannot be written.
    """
    with _fixed_meta_data():
        drawing = _empty_drawing()
        drawing.layers.add("SHEET", color=8)
        space = drawing.modelspace()
        rim = [(0, 0), (sheet.width, 0), (sheet.width, sheet.height), (0, sheet.height)]
        space.add_lwpolyline(rim, close=True, dxfattribs={"layer": "SHEET"})
        size = min(_TITLE, 0.05 * sheet.height)
        middle = np.array([sheet.width / 2, sheet.height + size])
        _add_text(space, "SHEET", sheet.title, middle, size, 0.0)
        for placement in sheet.placements:
            _fill_block(drawing.blocks.new(placement.name), placement.name, placement.pattern)
            turn = {"rotation": placement.angle_deg}
            space.add_blockref(placement.name, placement.shift.tolist(), dxfattribs=turn)
        drawing.saveas(path)


def row_layout(patterns: Sequence[FlatPattern]) -> FloatArray:
    """(N, 2) lower left corners of the patterns in rows of a roughly square sheet, mm."""
    if not patterns:
        return np.empty((0, 2))
    sizes = np.array([pattern.size for pattern in patterns]) + SPACING
    width = max(math.sqrt(float(sizes.prod(axis=1).sum()) * 1.3), float(sizes[:, 0].max()))
    places = np.empty_like(sizes)
    x = y = row_height = 0.0
    for number, (across, up) in enumerate(sizes.tolist()):
        if x > 0 and x + across > width:
            x, y, row_height = 0.0, y + row_height, 0.0
        places[number] = x, y
        x += across
        row_height = max(row_height, up)
    return places


def _empty_drawing() -> Drawing:
    import ezdxf

    drawing = ezdxf.new("R2010")
    drawing.header["$INSUNITS"] = _MILLIMETRES
    drawing.header["$MEASUREMENT"] = 1
    drawing.linetypes.add("FAR_SIDE", pattern=[6.0, 4.0, -2.0], description="on the far side")
    drawing.styles.add(_STYLE, font=_FONT)
    for name, colour in LAYERS.items():
        drawing.layers.add(name, color=colour)
    return drawing


def _fill_block(block: BlockLayout, name: str, pattern: FlatPattern) -> None:
    for polygon in (pattern.outline, *pattern.cutouts):
        block.add_lwpolyline(polygon.tolist(), close=True, dxfattribs={"layer": "CUT"})
    for hole in pattern.holes:
        radius = hole.diameter / 2
        block.add_circle(hole.centre.tolist(), radius, dxfattribs={"layer": "HOLE"})
    if pattern.axis is not None:
        block.add_lwpolyline(pattern.axis.tolist(), dxfattribs={"layer": "AXIS"})
    for bend in pattern.bends:
        block.add_line(*bend.points.tolist(), dxfattribs={"layer": "BEND"})
    for mark in pattern.marks:
        if mark.text:
            _add_text(block, "ENGRAVE", mark.text, mark.points[0], mark.size, mark.angle)
        else:
            side = {"linetype": "FAR_SIDE"} if mark.hidden else {}
            block.add_line(*mark.points.tolist(), dxfattribs={"layer": "ENGRAVE", **side})
    _add_text(block, "LABEL", name, pattern.label, pattern.label_size, pattern.label_angle)


def _add_text(
    block: BaseLayout, layer: str, words: str, place: FloatArray, size: float, angle: float
) -> None:
    from ezdxf.enums import TextEntityAlignment

    text = block.add_text(
        words, height=size, rotation=angle, dxfattribs={"layer": layer, "style": _STYLE}
    )
    text.set_placement(place.tolist(), align=TextEntityAlignment.MIDDLE_CENTER)


@contextmanager
def _fixed_meta_data() -> Iterator[None]:
    """The same structure gives the same file: no clock, no random identifiers."""
    import ezdxf

    before = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before
