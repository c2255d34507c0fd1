"""DXF: the true outline of every part, as blocks or plain, together or one file a part."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.dxf_form import VERSIONS, DxfForm
from freecad_ortho.fabrication.dxf_pen import FAR_SIDE, STYLE, DxfPen
from freecad_ortho.fabrication.pattern import Bevel, FlatPattern, fitted_text_size
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.layouts import Modelspace

    from freecad_ortho.fabrication.nesting import Sheet

SPACING = 30.0
# Name and colour, in the order in which a workshop looks at them.
DXF_LAYERS = {"CUT": 7, "HOLE": 5, "AXIS": 4, "BEND": 6, "BEVEL": 2, "ENGRAVE": 1, "LABEL": 3}
# A stroke font: letters are single lines for a plotter, a laser or an engraver to follow.
_FONT = "txt.shx"
_MILLIMETRES = 4
# Text height of what a sheet is, above its rim, mm.
_TITLE = 40.0
# Largest text height of a bevel's angle, mm.
_ANGLE = 6.0


_USUAL = DxfForm()


def write_dxf(path: Path, patterns: Mapping[str, FlatPattern], form: DxfForm = _USUAL) -> None:
    """Write flat patterns in rows, in mm.

    Layers: CUT the closed outlines and cutouts, HOLE circles, AXIS the unrolled parameter line,
    BEND bend lines, BEVEL where bevelled sides begin (dashed: on the far side of the plate) and
    their angles, ENGRAVE lines and texts, LABEL the names.

    Args:
        path: file to write.
        patterns: by the parts' names.
        form: how; with blocks each pattern is a block of its part's name and one insert of it.

    Raises:
        OSError: the file cannot be written.
    """
    places = row_layout(list(patterns.values()))
    with _drawing(path, form) as space:
        for (name, pattern), place in zip(patterns.items(), places, strict=True):
            _place(space, name, pattern, place, 0.0, form)


def write_sheet(path: Path, sheet: Sheet, form: DxfForm = _USUAL) -> None:
    """Write one nested sheet in mm, its parts turned; rim and title on layer SHEET.

    Raises:
        OSError: the file cannot be written.
    """
    with _drawing(path, form) as space:
        space.doc.layers.add("SHEET", color=8)
        pen = DxfPen(space, form.text)
        rim = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * [sheet.width, sheet.height]
        pen.polyline("SHEET", rim, closed=True)
        size = min(_TITLE, 0.05 * sheet.height)
        middle = np.array([sheet.width / 2, sheet.height + size])
        pen.words("SHEET", sheet.title, middle, size, 0.0)
        for placed in sheet.placements:
            _place(space, placed.name, placed.pattern, placed.shift, placed.angle_deg, form)


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


@contextmanager
def _drawing(path: Path, form: DxfForm) -> Iterator[Modelspace]:
    """An empty drawing's model space, which is written in the end."""
    with _fixed_meta_data():
        drawing = _empty_drawing(VERSIONS[form.version])
        yield drawing.modelspace()
        # The library would add them in the order of a set, which differs from one run to the next.
        for kind in sorted(drawing.entitydb.dxf_types_in_use()):
            drawing.classes.add_class(kind)
        drawing.saveas(path)


def _empty_drawing(version: str) -> Drawing:
    # Not ezdxf.new, which complains in R12 about a unit that nobody asked for.
    from ezdxf.document import Drawing

    drawing = Drawing.new(version)
    if drawing.dxfversion > "AC1009":
        # R12 knows no units.
        drawing.header["$INSUNITS"] = _MILLIMETRES
        drawing.header["$MEASUREMENT"] = 1
    drawing.linetypes.add(FAR_SIDE, pattern=[6.0, 4.0, -2.0], description="on the far side")
    drawing.styles.add(STYLE, font=_FONT)
    for name, colour in DXF_LAYERS.items():
        drawing.layers.add(name, color=colour)
    return drawing


def _place(
    space: Modelspace,
    name: str,
    pattern: FlatPattern,
    shift: FloatArray,
    angle: float,
    form: DxfForm,
) -> None:
    """Draw a pattern turned and then moved: as an insert of its block, or line by line."""
    if form.layout != "blocks":
        _draw(DxfPen(space, form.text, angle, shift), name, pattern)
        return
    _draw(DxfPen(space.doc.blocks.new(name), form.text), name, pattern)
    space.add_blockref(name, shift.tolist(), dxfattribs={"rotation": angle})


def _draw(pen: DxfPen, name: str, pattern: FlatPattern) -> None:
    for polygon in (pattern.outline, *pattern.cutouts):
        pen.polyline("CUT", polygon, closed=True)
    for hole in pattern.holes:
        pen.circle("HOLE", hole.centre, hole.diameter / 2)
    if pattern.axis is not None:
        pen.polyline("AXIS", pattern.axis)
    for bend in pattern.bends:
        pen.line("BEND", bend.points)
    for bevel in pattern.bevels:
        pen.line("BEVEL", bevel.points, bevel.hidden)
        _write_angle(pen, bevel, pattern.label)
    for mark in pattern.marks:
        if mark.text:
            pen.words("ENGRAVE", mark.text, mark.points[0], mark.size, mark.angle)
        else:
            pen.line("ENGRAVE", mark.points)
    pen.words("LABEL", name, pattern.label, pattern.label_size, pattern.label_angle)


def _write_angle(pen: DxfPen, bevel: Bevel, middle: FloatArray) -> None:
    """Write a bevel's angle along its line, on the side of the plate's middle.

    Those of the two sides of a plate stand near different ends, where other texts are not.
    """
    start, end = bevel.points
    if bevel.hidden:
        start, end = end, start
    length = float(np.linalg.norm(end - start))
    words = f"{bevel.angle_deg:+.1f}"
    size = min(_ANGLE, fitted_text_size(words, 0.2 * length, length))
    along = (end - start) / length
    inward = np.array([-along[1], along[0]])
    inward *= math.copysign(1.0, float(inward @ (middle - start)))
    place = start + 0.16 * length * along + size * inward
    turn = math.degrees(math.atan2(along[1], along[0]))
    pen.words("BEVEL", words, place, size, turn)


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
