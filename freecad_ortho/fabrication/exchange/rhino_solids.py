"""Solids for Rhino: plates and prisms as extrusions, other parts with plane sides as B-reps.

rhino3dm joins no trimmed faces, so sides of more than four corners come as triangles and quads,
which Rhino merges (*MergeAllCoplanarFaces*).
"""

from __future__ import annotations

import base64
import struct
from typing import Any

import numpy as np

from freecad_ortho.fabrication.bodies import Prism
from freecad_ortho.fabrication.exchange.facets import Facets, facets
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.place import Place
from solver.mesh.quadmesh import FloatArray

# By how much of its volume a part may differ from its flat pattern times its thickness.
_SAME = 1e-9
# Digits of mm to which corners are one.
_DIGITS = 6
# What openNURBS has for a number that was not set: edges that are made of meshes have it for a
# tolerance, and are no valid ones with it.
_UNSET = struct.pack("<d", -1.23432101234321e308)


def solid_of(rhino: Any, part: Part, place: Place) -> Any:
    """The solid of a part where it is built in; None for one with bent sides.

    Args:
        rhino: the package rhino3dm.
        part: whose solid it is.
        place: puts the part where it stands in files.
    """
    made = _extruded(rhino, part)
    if made is None:
        sides = facets(part)
        made = _joined(rhino, sides) if sides.exact else None
    if made is not None:
        made.Transform(_matrix(rhino, part, place))
    return made


def _matrix(rhino: Any, part: Part, place: Place) -> Any:
    made = rhino.Transform(1.0)
    origin = place.points(part.origin).tolist()
    for column, direction in enumerate(place.directions(part.frame).tolist()):
        for row, value in enumerate(direction):
            setattr(made, f"M{row}{column}", value)
    for row, value in enumerate(origin):
        setattr(made, f"M{row}3", value)
    return made


def _extruded(rhino: Any, part: Part) -> Any:
    """A flat plate with square sides, or a prism; None for any other part."""
    pattern, body = part.pattern, part.body
    if isinstance(body, Prism):
        holes = [(np.zeros(2), body.bore)] if body.bore > 0 else []
        return _extrusion(rhino, [np.asarray(body.outline)], holes, (body.low, body.high))
    if pattern is None or pattern.bends or pattern.bevels:
        return None
    if abs(pattern.area * part.thickness / part.volume - 1) > _SAME:
        return None
    levels = np.asarray(body.points)[:, 2]
    reach = float(levels.min()), float(levels.max())
    if abs(reach[1] - reach[0] - part.thickness) > 10.0**-_DIGITS:
        return None
    round_holes = [(hole.centre, hole.diameter) for hole in pattern.holes]
    return _extrusion(rhino, [pattern.outline, *pattern.cutouts], round_holes, reach)


def _extrusion(
    rhino: Any,
    rings: list[FloatArray],
    holes: list[tuple[FloatArray, float]],
    reach: tuple[float, float],
) -> Any:
    """From one height to another of an outline (n, 2), less openings and round holes, mm."""
    closed = [
        rhino.PolylineCurve([rhino.Point3d(x, y, 0.0) for x, y in [*ring.tolist(), ring[0]]])
        for ring in (np.asarray(ring) for ring in rings)
    ]
    made = rhino.Extrusion.Create(closed[0], reach[1] - reach[0], True)
    inner = closed[1:]
    for centre, diameter in holes:
        middle = rhino.Point3d(float(centre[0]), float(centre[1]), 0.0)
        inner.append(rhino.Circle(middle, diameter / 2).ToNurbsCurve())
    if made is None or not all(made.AddInnerProfile(curve) for curve in inner):
        return None
    low = made.GetBoundingBox().Min.Z
    made.Translate(rhino.Vector3d(0.0, 0.0, reach[0] - low))
    return made


def _joined(rhino: Any, sides: Facets) -> Any:
    """A closed B-rep of plane triangles and quads."""
    quads = [ring for ring, *openings in sides.sides if len(ring) == 4 and not openings]
    others = [rings for rings in sides.sides if len(rings[0]) != 4 or len(rings) > 1]
    points = [tuple(point) for point in sides.points.tolist()]
    numbers = {_key(point): number for number, point in enumerate(points)}
    faces = [list(map(int, ring)) for ring in quads]
    if others:
        for corners in Facets(sides.points, others, exact=True).triangles.tolist():
            faces.append([numbers[_key(corner)] for corner in corners])
    mesh = rhino.Mesh()
    mesh.Vertices.UseDoublePrecisionVertices = True
    for point in points:
        mesh.Vertices.AddPoint3d(*point)
    for face in faces:
        mesh.Faces.AddFace(*face)
    made = rhino.Brep.CreateFromMesh(mesh, True)
    if made is None:
        return None
    known = made.Encode()
    data = base64.b64decode(known["data"]).replace(_UNSET, bytes(8))
    made = rhino.CommonObject.Decode(known | {"data": base64.b64encode(data).decode()})
    return made if made.IsValid and made.IsSolid else None


def _key(point: Any) -> tuple[float, ...]:
    # Zero without a sign.
    return tuple(round(value, _DIGITS) + 0.0 for value in point)
