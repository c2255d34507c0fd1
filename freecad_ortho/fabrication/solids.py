"""Closed solids straight from corner points, without boolean operations or sewing."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from io import BytesIO
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery


class Buildable(Protocol):
    """Anything that becomes a solid."""

    def solid(self) -> cadquery.Solid:
        """Build the closed solid."""


# Axes in their cyclic order.
_NEXT, _LAST = [1, 2, 0], [2, 0, 1]


def polyhedron_solid(points: FloatArray, loops: tuple[tuple[int, ...], ...]) -> cadquery.Solid:
    """Build a solid whose sides share their edges and corners.

    Args:
        points: (N, 3) corner points, mm.
        loops: point numbers around each planar side, counter-clockwise seen from outside; every
            pair of consecutive points appears once in each direction.
    """
    from OCP.BRep import BRep_Builder
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeVertex
    from OCP.Geom import Geom_Plane
    from OCP.gp import gp_Dir, gp_Pln, gp_Pnt
    from OCP.TopoDS import TopoDS_Face, TopoDS_Wire

    builder = BRep_Builder()
    rows = points.tolist()
    vertices = [BRepBuilderAPI_MakeVertex(gp_Pnt(*row)).Vertex() for row in rows]
    edges: dict[tuple[int, int], Any] = {}
    faces = []
    for loop in loops:
        wire = TopoDS_Wire()
        builder.MakeWire(wire)
        for start, end in zip(loop, loop[1:] + loop[:1], strict=True):
            edge = edges.pop((end, start), None)
            if edge is None:
                edge = BRepBuilderAPI_MakeEdge(vertices[start], vertices[end]).Edge()
                edges[start, end] = edge
                builder.Add(wire, edge)
            else:
                builder.Add(wire, edge.Reversed())
        wire.Closed(True)
        _, normal = plane_of(points[list(loop)])
        plane = Geom_Plane(gp_Pln(gp_Pnt(*rows[loop[0]]), gp_Dir(*normal)))
        face = TopoDS_Face()
        builder.MakeFace(face, plane, 1e-7)
        builder.Add(face, wire)
        faces.append(face)
    return solid_within(faces)


def solid_within(faces: Iterable[Any]) -> cadquery.Solid:
    """The solid within faces that share their edges and close."""
    import cadquery
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Shell, TopoDS_Solid

    builder, shell, solid = BRep_Builder(), TopoDS_Shell(), TopoDS_Solid()
    builder.MakeShell(shell)
    for face in faces:
        builder.Add(shell, face)
    shell.Closed(True)
    builder.MakeSolid(solid)
    builder.Add(solid, shell)
    return cadquery.Solid(solid)


def placed(solid: cadquery.Solid, origin: FloatArray, frame: FloatArray) -> cadquery.Solid:
    """Return the solid moved from the standard frame to ``origin`` (3,) and ``frame`` (3, 3)."""
    import cadquery

    return cadquery.Solid(solid.wrapped.Located(location(origin, frame)))


def location(origin: FloatArray, frame: FloatArray) -> Any:
    """The kernel's location that moves the standard frame to an origin (3,) and a frame (3, 3)."""
    from OCP.gp import gp_Ax3, gp_Dir, gp_Pnt, gp_Trsf
    from OCP.TopLoc import TopLoc_Location

    x, _, z = frame.tolist()
    movement = gp_Trsf()
    movement.SetTransformation(gp_Ax3(gp_Pnt(*origin.tolist()), gp_Dir(*z), gp_Dir(*x)), gp_Ax3())
    return TopLoc_Location(movement)


def plane_of(loop: FloatArray) -> tuple[list[float], list[float]]:
    """Mean point and unit normal (Newell) of a planar polygon (N, 3)."""
    middle = loop.mean(axis=0)
    arms = loop - middle
    after = np.concatenate([arms[1:], arms[:1]])
    # numpy's cross product takes five times as long for so few rows.
    normal = (arms[:, _NEXT] * after[:, _LAST] - arms[:, _LAST] * after[:, _NEXT]).sum(axis=0)
    return middle.tolist(), (normal / np.linalg.norm(normal)).tolist()


def compound(solids: Iterable[cadquery.Solid]) -> cadquery.Compound:
    """Return one shape that holds the solids in their order."""
    import cadquery

    return cadquery.Compound.makeCompound(list(solids))


def solid_bytes(bodies: Sequence[Buildable]) -> list[bytes]:
    """Build the solids of bodies, each as bytes that keep every digit and travel."""
    from OCP.BinTools import BinTools

    result = []
    for body in bodies:
        stream = BytesIO()
        BinTools.Write_s(body.solid().wrapped, stream)
        result.append(stream.getvalue())
    return result


def solid_from_bytes(data: bytes) -> cadquery.Solid:
    """Read what ``solid_bytes`` wrote."""
    import cadquery
    from OCP.BinTools import BinTools
    from OCP.TopoDS import TopoDS_Shape

    shape = TopoDS_Shape()
    BinTools.Read_s(shape, BytesIO(data))
    return cadquery.Solid(shape)


def brep_text(shape: cadquery.Shape) -> str:
    """Return a shape as text that ``Part.Shape().importBrepFromString`` of FreeCAD reads.

    The oldest format version is written, so that a FreeCAD with an older kernel can read it.
    """
    from OCP.BRepTools import BRepTools
    from OCP.Message import Message_ProgressRange
    from OCP.TopTools import TopTools_FormatVersion

    stream = BytesIO()
    version = TopTools_FormatVersion.TopTools_FormatVersion_VERSION_1
    BRepTools.Write_s(shape.wrapped, stream, False, False, version, Message_ProgressRange())
    return stream.getvalue().decode("ascii")
