"""What a net on a surface follows, as plain arrays: its field, singular points, strokes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial import cKDTree

from freecad_ortho.view.overlay_shapes import Colour, Lines, Points, Shape
from solver.align.crosses import Crosses, Singular
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

_FIRST: Colour = (0.85, 0.20, 0.10)
_SECOND: Colour = (0.02, 0.10, 0.60)
_GREY: Colour = (0.62, 0.62, 0.64)
_GREEN: Colour = (0.10, 0.52, 0.30)
# By the number of lines that meet there.
_SINGULAR: dict[int, Colour] = {3: (0.90, 0.15, 0.45), 5: (0.94, 0.58, 0.17), 6: (0.48, 0.20, 0.58)}
# In edges: a cross from end to end, how far two of them are apart at least.
_LONG, _APART = 0.7, 0.55
# Crosses that are less certain than these are grey, and half grey.
_CERTAIN = (0.1, 0.5)


def crosses(field: Crosses, edge: float) -> list[Shape]:
    """About one cross for each face of a net, the greyer the less certain.

    Args:
        field: directions in each triangle of the surface, mm.
        edge: mean edge of the net, mm.
    """
    chosen = _spread(field.places, edge)
    reach = 0.5 * _LONG * edge * field.directions[chosen]
    places = field.places[chosen, None]
    ends = np.stack([places - reach, places + reach], axis=2)
    step = np.digitize(field.certainty[chosen], _CERTAIN)
    found: list[Shape] = []
    for number in range(len(_CERTAIN) + 1):
        part = number / len(_CERTAIN)
        for family, colour in enumerate((_FIRST, _SECOND)):
            mixed = part * np.array(colour) + (1 - part) * np.array(_GREY)
            lines = ends[step == number, family]
            if len(lines):
                found.append(Lines(lines, tuple(mixed.tolist()), 2.0))
    return found


def singular_points(singular: Singular) -> list[Shape]:
    """A mark at each point where the field cannot be continued, coloured by its lines."""
    return [
        Points(singular.places[singular.valences == lines], _SINGULAR.get(lines, _GREY), 11.0)
        for lines in np.unique(singular.valences).tolist()
    ]


def stroke_lines(strokes: Sequence[FloatArray]) -> list[Shape]:
    """The curves that lines of a net run along."""
    pieces = [np.stack([line[:-1], line[1:]], axis=1) for line in strokes]
    return [Lines(np.concatenate(pieces), _GREEN, 5.0)] if pieces else []


def _spread(places: FloatArray, edge: float) -> IntArray:
    """One place in each cube of the size of an edge, without those that are near to another."""
    cubes = np.floor(places / edge)
    inner = np.linalg.norm(places / edge - cubes - 0.5, axis=1)
    order = np.argsort(inner)
    _, first = np.unique(cubes[order], axis=0, return_index=True)
    chosen: IntArray = order[np.sort(first)]
    pairs = cKDTree(places[chosen]).query_pairs(_APART * edge, output_type="ndarray")
    dropped = np.zeros(len(chosen), dtype=bool)
    for one, two in pairs[np.lexsort(pairs.T[::-1])].tolist():
        if not dropped[one]:
            dropped[two] = True
    return chosen[~dropped]
