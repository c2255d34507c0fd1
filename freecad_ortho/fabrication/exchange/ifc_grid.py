"""The net's lines in IFC: a grid whose axes have their names, and the lines in space."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from freecad_ortho.fabrication.exchange.drawings.view import eye
from freecad_ortho.fabrication.structure import Structure
from solver.mesh.lines import FAMILIES, ParameterLine
from solver.mesh.quadmesh import FloatArray

Make = Callable[..., Any]
# Points on a line that are as near, mm, are one where the line is seen.
_SAME = 1e-3
# Of points in mm: far below the CAD kernel's tolerance of points.
_DIGITS = 7


def grid(
    make: Make, guid: Callable[[str], str], structure: Structure, storey: Any, context: Any
) -> Any | None:
    """A grid of the lines that are built on, named as in all files.

    Axes of an ``IfcGrid`` are plane: lines as they are seen from above, of what stands upright from
    its side, as in the plan of the drawings. Its representation *Axis* has them in space.

    Args:
        make: an entity of attributes in their order.
        guid: the identifier of a key.
        structure: the site of it has the lines.
        storey: what it stands on.
        context: of the model.

    Returns:
        The grid; None where one of the families has no line.
    """
    site, place = structure.site, structure.place
    normals = place.directions(site.mesh.face_area_vectors)
    frame = eye(normals)[1] @ place.rotation
    seen = site.mesh.vertices @ frame.T
    chosen = [line for line in site.chosen_lines if len(_apart(seen[_along(line), :2])) > 1]
    families = [[line for line in chosen if line.family == family] for family in FAMILIES]
    if not all(families):
        return None
    axes, flat, bent = [], [], []
    for lines in families:
        row = []
        for line in lines:
            points = seen[_along(line)]
            curve = _polyline(make, _apart(points[:, :2]))
            flat.append(curve)
            bent.append(_polyline(make, points))
            row.append(make("IfcGridAxis", f"{line.family}{line.number}", curve, True))
        axes.append(row)
    form = make("IfcProductDefinitionShape", None, None, _shapes(make, context, flat, bent))
    origin = make("IfcCartesianPoint", site.shift.tolist())
    z, x = (make("IfcDirection", frame[row].tolist()) for row in (2, 0))
    own = make("IfcAxis2Placement3D", origin, z, x)
    placement = make("IfcLocalPlacement", storey.ObjectPlacement, own)
    known = [guid("grid"), None, "net", None, None, placement, form]
    return make("IfcGrid", *known, *axes, None, None)


def _shapes(make: Make, context: Any, flat: Sequence[Any], bent: Sequence[Any]) -> list[Any]:
    """Both representations, each in its own part of the model's context."""
    made = []
    for name, view, kind, items in (
        ("FootPrint", "PLAN_VIEW", "GeometricCurveSet", [make("IfcGeometricCurveSet", flat)]),
        ("Axis", "GRAPH_VIEW", "Curve3D", bent),
    ):
        own = make(
            *("IfcGeometricRepresentationSubContext", name, "Model", None, None, None, None),
            *(context, None, view, None),
        )
        made.append(make("IfcShapeRepresentation", own, name, kind, items))
    return made


def _along(line: ParameterLine) -> list[int]:
    """Vertices of a line, of a closed one the first again."""
    numbers: list[int] = line.vertices.tolist()
    return [*numbers, numbers[0]] if line.closed else numbers


def _apart(points: FloatArray) -> FloatArray:
    """Points (n, 2) without those that lie on the one before."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return np.asarray(points[np.concatenate([[True], steps > _SAME])])


def _polyline(make: Make, points: FloatArray) -> Any:
    corners = [make("IfcCartesianPoint", row) for row in np.round(points, _DIGITS).tolist()]
    return make("IfcPolyline", corners)
