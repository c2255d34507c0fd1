"""The only crossing between FreeCAD and the rest: plain arrays and BREP text, never pointers."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import FreeCAD
import numpy as np

from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh

if TYPE_CHECKING:
    import cadquery
    import Part


def vectors(points: FloatArray) -> list[FreeCAD.Vector]:
    """Make FreeCAD vectors from an (N, 3) array; every bit is kept."""
    return [FreeCAD.Vector(x, y, z) for x, y, z in points.tolist()]


def array(points: list[FreeCAD.Vector]) -> FloatArray:
    """Make an (N, 3) array from FreeCAD vectors; every bit is kept."""
    return np.array([(p.x, p.y, p.z) for p in points], dtype=np.float64).reshape(-1, 3)


def quad_mesh(net: FreeCAD.DocumentObject) -> QuadMesh:
    """Read the quad mesh of a net, in mm.

    Raises:
        InputError: the net's properties do not make a quad mesh.
    """
    if not net.Faces:
        raise InputError(f"{net.Label}: the net is empty; import a quad mesh first")
    if len(net.Faces) % 4:
        raise InputError(
            f"{net.Label}: 'Faces' holds {len(net.Faces)} numbers, expected four a face; undo the "
            "change or import the mesh again"
        )
    faces = np.array(net.Faces, dtype=np.int64).reshape(-1, 4)
    return QuadMesh.from_arrays(array(net.Vertices), faces)


def store_mesh(net: FreeCAD.DocumentObject, mesh: QuadMesh) -> None:
    """Write a quad mesh in mm into a net's properties."""
    # Faces first: a view that redraws in between sees faces whose vertices are still to come,
    # never vertices numbered beyond the end.
    net.Faces = []
    net.Vertices = vectors(mesh.vertices)
    net.Faces = mesh.faces.ravel().tolist()


def store_vertices(net: FreeCAD.DocumentObject, vertices: FloatArray) -> None:
    """Move a net's vertices, (V, 3) in mm; its faces stay."""
    net.Vertices = vectors(vertices)


def millimetres(value: float | str | FreeCAD.Units.Quantity, name: str) -> float:
    """Read a length: a number of mm, a quantity, or a text such as ``"0.2 m"``.

    Raises:
        InputError: not a length.
    """
    if isinstance(value, str):
        try:
            value = FreeCAD.Units.Quantity(value)
        except (ValueError, ArithmeticError, OSError) as error:
            raise InputError(f"{name}: '{value}' is not a length; give it like '12 mm'") from error
    if isinstance(value, FreeCAD.Units.Quantity):
        if value.Unit not in (FreeCAD.Units.Length, FreeCAD.Units.Unit()):
            raise InputError(f"{name}: '{value}' is not a length; give it like '12 mm'")
        value = value.Value
    try:
        return float(value)
    except TypeError:
        raise InputError(f"{name}: {value!r} is not a length; give it like '12 mm'") from None


def part_shape(shape: cadquery.Shape) -> Part.Shape:
    """Carry a cadquery shape over into FreeCAD."""
    import Part

    from freecad_ortho.fabrication import brep_text

    result = Part.Shape()
    result.importBrepFromString(brep_text(shape))
    return result


def cadquery_shape(shape: Part.Shape) -> Any:
    """Carry a FreeCAD shape over into cadquery."""
    import cadquery

    return cadquery.Shape.importBrep(io.BytesIO(shape.exportBrepToString().encode("ascii")))
