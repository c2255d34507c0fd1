"""CAD faces and FreeCAD's triangle meshes as plain functions and arrays."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import FreeCAD
import numpy as np

from freecad_ortho import convert
from freecad_ortho.objects import places
from freecad_ortho.triangles import read_triangles
from freecad_ortho.units import millimetres_per
from solver.errors import InputError
from solver.mesh.border import closed_loops
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray
from solver.mesh.sampling import ParametricSurface

if TYPE_CHECKING:
    import Part

Face = tuple[FreeCAD.DocumentObject, str]
# Areas that differ by less than this part: the border is that of the parameters.
_SAME_AREA = 1e-6
# How far polylines stray from edges, in parts of the face's size.
_DEFLECTION = 2e-5
# How far triangles that stand in for a face stray from it, likewise.
_COARSE = 5e-4


def faces_of(given: Any) -> list[Face]:
    """Faces as (shape, name) from a shape, a face, FreeCAD's links, or a list of these.

    A shape stands for all its faces.

    Raises:
        InputError: something without a face of that name.
    """
    result: list[Face] = []
    for feature, names in links_of(given):
        shape = getattr(feature, "Shape", None)
        if shape is None or not shape.Faces:
            label = getattr(feature, "Label", feature)
            raise InputError(f"faces: {label} has no faces; select a face of a shape")
        count = len(shape.Faces)
        for name in names or [f"Face{k + 1}" for k in range(count)]:
            number = name.removeprefix("Face")
            if not (number.isdigit() and 1 <= int(number) <= count):
                raise InputError(
                    f"faces: {feature.Label} has Face1 to Face{count}, not '{name}'; select a face"
                )
            result.append((feature, name))
    return result


def links_of(given: Any) -> Iterable[tuple[Any, list[str]]]:
    """Objects with names of their parts, from an object, a link, or a list of these.

    Raises:
        InputError: something else.
    """
    if hasattr(given, "Document"):
        yield given, []
    elif isinstance(given, (tuple, list)) and len(given) == 2 and _is_name(given[1]):
        names = [given[1]] if isinstance(given[1], str) else list(given[1])
        yield given[0], [name for name in names if name]
    elif isinstance(given, (tuple, list)):
        for item in given:
            yield from links_of(item)
    else:
        raise InputError(f"faces: expected shapes or (shape, 'Face1'), got {given!r}")


def _is_name(value: Any) -> bool:
    several = isinstance(value, (tuple, list)) and all(isinstance(x, str) for x in value)
    return isinstance(value, str) or (several and len(value) > 0)


def parametric_surface(feature: FreeCAD.DocumentObject, name: str) -> ParametricSurface:
    """One face as functions of its parameters, in mm; normals as those of the face."""
    face = _face(feature, name)
    first, last, low, high = face.ParameterRange
    turned = face.Orientation == "Reversed"

    def evaluate(u: FloatArray, v: FloatArray) -> FloatArray:
        # Backwards along u where the face shows its surface's other side.
        places = first + last - u if turned else u
        pairs = zip(places.tolist(), v.tolist(), strict=True)
        return convert.array([face.valueAt(*pair) for pair in pairs])

    def inside(u: FloatArray, v: FloatArray) -> BoolArray:
        places = first + last - u if turned else u
        pairs = zip(places.tolist(), v.tolist(), strict=True)
        return np.array([face.isPartOfDomain(*pair) for pair in pairs], dtype=bool)

    def foot(points: FloatArray) -> FloatArray:
        surface = face.Surface
        return convert.array(
            [face.valueAt(*surface.parameter(point)) for point in convert.vectors(points)]
        )

    trimmed = _is_trimmed(face)
    return ParametricSurface(
        evaluate,
        (first, last),
        (low, high),
        inside if trimmed else None,
        _border(face) if trimmed else (),
        f"{feature.Label}.{name}",
        foot,
    )


def triangulated(faces: Iterable[Face]) -> TriangleSurface:
    """Faces as triangles near to them, where they stand in the document, mm: what a ray meets."""
    vertices, triangles, count = [], [], 0
    for feature, name in faces:
        face = _face(feature, name)
        points, corners = face.tessellate(_COARSE * face.BoundBox.DiagonalLength)
        vertices.append(convert.array(points))
        triangles.append(count + np.array(corners, dtype=np.int64).reshape(-1, 3))
        count += len(points)
    return TriangleSurface(np.concatenate(vertices), np.concatenate(triangles))


def face_word(feature: FreeCAD.DocumentObject, name: str) -> str:
    """A text that is another for another face, or for one that stands elsewhere."""
    text: str = _face(feature, name).exportBrepToString()
    return text


def _face(feature: FreeCAD.DocumentObject, name: str) -> Part.Face:
    """A face where it stands in the document, whatever parts and bodies it is in."""
    # A copy, without the triangles that it may be drawn with: it belongs to no document, so that it
    # may be sampled in another thread, and is the same again whether it was drawn or not.
    face = feature.Shape.getElement(name).copy()
    around = places.container(feature)
    if not around.isIdentity():
        face.Placement = around.multiply(face.Placement)
    return face


def _is_trimmed(face: Part.Face) -> bool:
    whole = face.Surface.toShape(*face.ParameterRange)
    return abs(whole.Area - face.Area) > _SAME_AREA * whole.Area


def _border(face: Part.Face) -> tuple[FloatArray, ...]:
    """Closed polylines along the border, without seams, close to it."""
    fine = _DEFLECTION * face.BoundBox.DiagonalLength
    near = 10 * fine
    # Seams cut loops open, so loops are put together by their ends and not as the wires have them.
    pieces = [
        convert.array(edge.discretize(Deflection=fine))
        for edge in face.Edges
        if not edge.isSeam(face) and edge.Length > near
    ]
    return closed_loops(pieces, near)


def triangles_of(given: Any, unit: str | None = None) -> tuple[FloatArray, IntArray]:
    """Vertices (V, 3) in mm and triangles (T, 3) of a Mesh object or of a file.

    Raises:
        InputError: neither, or without triangles.
    """
    if isinstance(given, (str, os.PathLike)):
        points, triangles, named = read_triangles(given)
        return points * millimetres_per(unit or named or "mm"), triangles
    places.refuse_link(given)
    mesh = getattr(given, "Mesh", None)
    if mesh is None or not mesh.CountFacets:
        label = getattr(given, "Label", given)
        raise InputError(f"mesh: {label} holds no triangles; select a Mesh object or give a file")
    points, corners = mesh.Topology
    standing = places.moved(convert.array(points), places.container(given))
    return standing, np.array(corners, dtype=np.int64).reshape(-1, 3)
