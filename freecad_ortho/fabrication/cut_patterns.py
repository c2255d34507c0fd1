"""What is left of a flat pattern within an outline."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.pattern import Bend, FlatPattern, Mark, longest_within
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import shapely

# Bend lines that are shorter, mm, are none.
_SHORT = 1e-2


def cut_pattern(
    whole: FlatPattern, name: str, outline: shapely.Polygon, label: FloatArray, width: float
) -> FlatPattern:
    """The pattern of a piece: its lines end at the outline, texts that reach over it are left out.

    Args:
        whole: the pattern that it is cut from.
        name: of the piece.
        outline: of the piece, in the whole pattern.
        label: (2,) the middle of the largest circle in it.
        width: diameter of that circle, mm.
    """
    from shapely.geometry.polygon import orient

    outline = orient(outline)
    low = np.array(outline.bounds[:2])
    marks = [mark for mark in whole.marks if mark.text and _holds(outline, mark)]
    for mark in whole.marks:
        if not mark.text and (line := longest_within(mark.points, outline)) is not None:
            marks.append(Mark(line))
    return FlatPattern(
        outline=np.array(outline.exterior.coords)[:-1] - low,
        marks=tuple(replace(mark, points=mark.points - low) for mark in marks),
        label=label - low,
        label_size=min(0.55 * width / float(np.hypot(len(name), 1)), 30.0),
        cutouts=tuple(np.array(ring.coords)[:-1] - low for ring in outline.interiors),
        bends=tuple(bend for one in whole.bends for bend in _bends(outline, one, low)),
    )


def _holds(outline: shapely.Polygon, text: Mark) -> bool:
    """Whether a text lies within an outline."""
    import shapely

    angle = np.radians(text.angle)
    reach = 0.5 * text.size * len(text.text) * np.array([np.cos(angle), np.sin(angle)])
    line = shapely.LineString([text.points[0] - reach, text.points[0] + reach])
    return bool(outline.covers(line.buffer(text.size / 2)))


def _bends(outline: shapely.Polygon, bend: Bend, low: FloatArray) -> list[Bend]:
    """The parts of a bend line that lie within an outline."""
    import shapely

    cut = shapely.LineString(bend.points).intersection(outline)
    start, step = bend.points[0], bend.points[1] - bend.points[0]
    found = []
    for part in shapely.get_parts(cut):
        if part.length > _SHORT:
            ends = np.array(part.coords)[[0, -1]]
            # In the direction of the whole line, which its angle belongs to.
            order = np.argsort((ends - start) @ step)
            found.append(replace(bend, points=ends[order] - low))
    return found
