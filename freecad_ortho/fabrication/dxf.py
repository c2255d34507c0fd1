"""DXF: the true outline of every part, one block a part, laid out in rows."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.part import FlatPattern, Part
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.layouts import BlockLayout

SPACING = 30.0
_LAYERS = (("CUT", 7), ("MARK", 1), ("LABEL", 3))
_MILLIMETRES = 4


def write_dxf(path: Path, parts: Sequence[Part]) -> None:
    """Write the flat patterns in mm.

    Layers: CUT the closed outlines, MARK lines and texts to scribe (dashed: on the far side of the
    plate), LABEL the names.

    Args:
        path: file to write.
        parts: each becomes a block of its name and one insert of it.

    Raises:
        OSError: the file cannot be written.
    """
    with _fixed_meta_data():
        drawing = _empty_drawing()
        space = drawing.modelspace()
        patterns = [part.pattern for part in parts]
        for part, place in zip(parts, row_layout(patterns), strict=True):
            _fill_block(drawing.blocks.new(part.name), part)
            space.add_blockref(part.name, place.tolist())
        drawing.saveas(path)


def row_layout(patterns: Sequence[FlatPattern]) -> FloatArray:
    """(N, 2) lower left corners of the patterns in rows of a roughly square sheet, mm."""
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
    for name, colour in _LAYERS:
        drawing.layers.add(name, color=colour)
    return drawing


def _fill_block(block: BlockLayout, part: Part) -> None:
    from ezdxf.enums import TextEntityAlignment

    pattern = part.pattern
    block.add_lwpolyline(pattern.outline.tolist(), close=True, dxfattribs={"layer": "CUT"})
    for mark in pattern.marks:
        attributes = {"layer": "MARK"}
        if mark.text:
            text = block.add_text(
                mark.text, height=mark.size, rotation=mark.angle, dxfattribs=attributes
            )
            text.set_placement(mark.points[0].tolist(), align=TextEntityAlignment.MIDDLE_CENTER)
        else:
            if mark.hidden:
                attributes["linetype"] = "FAR_SIDE"
            block.add_line(*mark.points.tolist(), dxfattribs=attributes)
    label = block.add_text(part.name, height=pattern.label_size, dxfattribs={"layer": "LABEL"})
    label.set_placement(pattern.label.tolist(), align=TextEntityAlignment.MIDDLE_CENTER)


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
