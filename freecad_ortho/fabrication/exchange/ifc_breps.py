"""Solids of parts with bent sides in IFC, exact: boundaries of trimmed surfaces.

Planes, cylinders, lines, circles and ellipses are themselves, other surfaces and curves B-splines
with the same poles (IfcAdvancedBrep of ISO 16739-1).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from solver.mesh.quadmesh import FloatArray

Make = Callable[..., Any]
# A knot or a weight that differs by less is the same.
_SAME = 1e-12


def advanced_brep(make: Make, shape: Any) -> Any | None:
    """The solid as an IfcAdvancedBrep.

    Args:
        make: an entity of its kind and attributes.
        shape: solid of the CAD kernel, where it is to be.

    Returns:
        None where a side is a ball, a cone or a torus, which have sides without an edge.
    """
    from OCP.BRepAdaptor import BRepAdaptor_Surface
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp
    from OCP.TopoDS import TopoDS
    from OCP.TopTools import TopTools_IndexedMapOfShape

    found = TopTools_IndexedMapOfShape()
    TopExp.MapShapes_s(shape, TopAbs_ShapeEnum.TopAbs_FACE, found)
    faces = [TopoDS.Face_s(found(k + 1)) for k in range(found.Extent())]
    kinds = {BRepAdaptor_Surface(face).GetType().name.rpartition("_")[2] for face in faces}
    splines = {"BezierSurface", "BSplineSurface", "SurfaceOfExtrusion"}
    if not kinds <= {"Plane", "Cylinder"} | splines:
        return None
    writer = _Boundary(make)
    return make("IfcAdvancedBrep", make("IfcClosedShell", [writer.face(face) for face in faces]))


class _Boundary:
    """Faces, edges and corners of a solid, each edge and corner once."""

    def __init__(self, make: Make) -> None:
        from OCP.TopTools import TopTools_IndexedMapOfShape

        self.make = make
        self.known = TopTools_IndexedMapOfShape()
        self.made: dict[int, Any] = {}

    def face(self, face: Any) -> Any:
        """A side with its rings of edges, counter-clockwise seen from outside."""
        from OCP.BRepTools import BRepTools
        from OCP.TopAbs import TopAbs_Orientation, TopAbs_ShapeEnum
        from OCP.TopExp import TopExp_Explorer
        from OCP.TopoDS import TopoDS

        reversed_face = face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED
        forward = TopoDS.Face_s(face.Oriented(TopAbs_Orientation.TopAbs_FORWARD))
        outer = BRepTools.OuterWire_s(forward)
        bounds = []
        wires = TopExp_Explorer(forward, TopAbs_ShapeEnum.TopAbs_WIRE)
        while wires.More():
            wire = TopoDS.Wire_s(wires.Current())
            loop = self.make("IfcEdgeLoop", self._ring(wire, forward, reversed_face))
            kind = "IfcFaceOuterBound" if wire.IsSame(outer) else "IfcFaceBound"
            bounds.append(self.make(kind, loop, True))
            wires.Next()
        surface, as_ours = self._surface(forward)
        return self.make("IfcAdvancedFace", bounds, surface, as_ours != reversed_face)

    def _ring(self, wire: Any, face: Any, turned: bool) -> list[Any]:
        from OCP.BRepTools import BRepTools_WireExplorer
        from OCP.TopAbs import TopAbs_Orientation

        around, found = BRepTools_WireExplorer(wire, face), []
        while around.More():
            edge = around.Current()
            along = edge.Orientation() == TopAbs_Orientation.TopAbs_FORWARD
            made = self._once(edge, self._edge)
            found.append(self.make("IfcOrientedEdge", None, None, made, along != turned))
            around.Next()
        return found[::-1] if turned else found

    def _once(self, shape: Any, made_of: Callable[[Any], Any]) -> Any:
        number = self.known.Add(shape)
        if number not in self.made:
            self.made[number] = made_of(shape)
        return self.made[number]

    def _edge(self, edge: Any) -> Any:
        from OCP.TopAbs import TopAbs_Orientation
        from OCP.TopExp import TopExp
        from OCP.TopoDS import TopoDS

        forward = TopoDS.Edge_s(edge.Oriented(TopAbs_Orientation.TopAbs_FORWARD))
        corners = TopExp.FirstVertex_s(forward), TopExp.LastVertex_s(forward)
        ends = [self._once(corner, self._vertex) for corner in corners]
        return self.make("IfcEdgeCurve", *ends, self._curve(forward), True)

    def _vertex(self, vertex: Any) -> Any:
        from OCP.BRep import BRep_Tool

        return self.make("IfcVertexPoint", self._point(BRep_Tool.Pnt_s(vertex)))

    def _point(self, place: Any) -> Any:
        return self.make("IfcCartesianPoint", [place.X(), place.Y(), place.Z()])

    def _direction(self, vector: FloatArray) -> Any:
        return self.make("IfcDirection", vector.tolist())

    def _axes(self, position: Any) -> tuple[Any, bool]:
        """A place whose z is x cross y, and whether the kernel's is as well."""
        x, y, z = (
            np.array([way.X(), way.Y(), way.Z()])
            for way in (position.XDirection(), position.YDirection(), position.Direction())
        )
        upright = np.cross(x, y)
        directions = self._direction(upright), self._direction(x)
        made = self.make("IfcAxis2Placement3D", self._point(position.Location()), *directions)
        return made, bool(upright @ z > 0)

    def _curve(self, edge: Any) -> Any:
        """The curve that an edge is a piece of."""
        from OCP.BRep import BRep_Tool
        from OCP.BRepAdaptor import BRepAdaptor_Curve
        from OCP.Geom import Geom_TrimmedCurve
        from OCP.GeomConvert import GeomConvert

        curve = BRepAdaptor_Curve(edge)
        kind = curve.GetType().name.rpartition("_")[2]
        if kind == "Line":
            line = curve.Line()
            way = line.Direction()
            along = self._direction(np.array([way.X(), way.Y(), way.Z()]))
            vector = self.make("IfcVector", along, 1.0)
            return self.make("IfcLine", self._point(line.Location()), vector)
        if kind == "Circle":
            place, _ = self._axes(curve.Circle().Position())
            return self.make("IfcCircle", place, curve.Circle().Radius())
        if kind == "Ellipse":
            ellipse = curve.Ellipse()
            place, _ = self._axes(ellipse.Position())
            return self.make("IfcEllipse", place, ellipse.MajorRadius(), ellipse.MinorRadius())
        first, last = curve.FirstParameter(), curve.LastParameter()
        known = BRep_Tool.Curve_s(edge, first, last)
        spline = GeomConvert.CurveToBSplineCurve_s(Geom_TrimmedCurve(known, first, last))
        return self._spline_curve(spline)

    def _spline_curve(self, spline: Any) -> Any:
        count = spline.NbPoles()
        poles = [self._point(spline.Pole(k + 1)) for k in range(count)]
        weights = [spline.Weight(k + 1) for k in range(count)]
        values = [spline.Degree(), poles, "UNSPECIFIED", spline.IsClosed(), False]
        rows = range(1, spline.NbKnots() + 1)
        values += [[spline.Multiplicity(k) for k in rows], [spline.Knot(k) for k in rows]]
        if np.ptp(weights) < _SAME:
            return self.make("IfcBSplineCurveWithKnots", *values, "UNSPECIFIED")
        return self.make("IfcRationalBSplineCurveWithKnots", *values, "UNSPECIFIED", weights)

    def _surface(self, face: Any) -> tuple[Any, bool]:
        """The surface that a side is a piece of, and whether its normal is the kernel's."""
        from OCP.BRep import BRep_Tool
        from OCP.BRepAdaptor import BRepAdaptor_Surface
        from OCP.BRepTools import BRepTools
        from OCP.Geom import Geom_RectangularTrimmedSurface
        from OCP.GeomConvert import GeomConvert

        surface = BRepAdaptor_Surface(face)
        kind = surface.GetType().name.rpartition("_")[2]
        if kind == "Plane":
            return self.make("IfcPlane", self._axes(surface.Plane().Position())[0]), True
        if kind == "Cylinder":
            cylinder = surface.Cylinder()
            place, as_ours = self._axes(cylinder.Position())
            return self.make("IfcCylindricalSurface", place, cylinder.Radius()), as_ours
        known = BRep_Tool.Surface_s(face)
        if kind == "SurfaceOfExtrusion":
            reach = BRepTools.UVBounds_s(face)
            known = Geom_RectangularTrimmedSurface(known, *reach)
        return self._spline_surface(GeomConvert.SurfaceToBSplineSurface_s(known)), True

    def _spline_surface(self, spline: Any) -> Any:
        rows, columns = range(1, spline.NbUPoles() + 1), range(1, spline.NbVPoles() + 1)
        poles = [[self._point(spline.Pole(u, v)) for v in columns] for u in rows]
        weights = [[spline.Weight(u, v) for v in columns] for u in rows]
        u, v = range(1, spline.NbUKnots() + 1), range(1, spline.NbVKnots() + 1)
        values = [spline.UDegree(), spline.VDegree(), poles, "UNSPECIFIED"]
        values += [spline.IsUClosed(), spline.IsVClosed(), False]
        values += [[spline.UMultiplicity(k) for k in u], [spline.VMultiplicity(k) for k in v]]
        values += [[spline.UKnot(k) for k in u], [spline.VKnot(k) for k in v], "UNSPECIFIED"]
        if np.ptp(weights) < _SAME:
            return self.make("IfcBSplineSurfaceWithKnots", *values)
        return self.make("IfcRationalBSplineSurfaceWithKnots", *values, weights)
