"""Edges, wires and sketches of a document as curves that lines of a net run along."""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.objects import cad_faces, places
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

Stroke = tuple[FreeCAD.DocumentObject, str]
# How far polylines stray from edges, in parts of the edge's size.
_DEFLECTION = 1e-4


def strokes_of(given: Any) -> list[Stroke]:
    """Strokes as (shape, name of an edge) from edges, from shapes without faces, or links to them.

    The name is empty where a whole wire or sketch is meant.

    Raises:
        InputError: something that is no edge, or a shape with faces.
    """
    found: list[Stroke] = []
    for feature, names in cad_faces.links_of(given):
        places.refuse_link(feature)
        shape = getattr(feature, "Shape", None)
        if shape is None or not shape.Edges:
            label = getattr(feature, "Label", feature)
            raise InputError(f"strokes: {label} has no edges; select an edge, a wire or a sketch")
        if not names and shape.Faces:
            raise InputError(f"strokes: {feature.Label} has faces; select edges of it")
        for name in names or [""]:
            _require_edge(feature, shape, name)
            found.append((feature, name))
    return list(dict.fromkeys(found))


def curves(strokes: list[Stroke]) -> list[FloatArray]:
    """Polylines (n, 3) of strokes, where they stand in the document, mm.

    Raises:
        InputError: an edge that has gone.
    """
    found = []
    for feature, name in strokes:
        _require_edge(feature, feature.Shape, name)
        place = places.container(feature)
        for edge in [feature.Shape.getElement(name)] if name else feature.Shape.Edges:
            points = edge.discretize(Deflection=_DEFLECTION * edge.BoundBox.DiagonalLength)
            found.append(places.moved(convert.array(points), place))
    return found


def _require_edge(feature: FreeCAD.DocumentObject, shape: Any, name: str) -> None:
    number, count = name.removeprefix("Edge"), len(shape.Edges)
    if name and not (number.isdigit() and 1 <= int(number) <= count):
        raise InputError(
            f"strokes: {feature.Label} has Edge1 to Edge{count}, not '{name}'; select an edge"
        )
