"""Ruled bodies as solids of the CAD kernel: shared edges, no boolean operation, no sewing."""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from OCP.BRep import BRep_Builder
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeVertex
from OCP.Geom import Geom_BezierCurve, Geom_BezierSurface, Geom_CylindricalSurface, Geom_Plane
from OCP.Geom2d import Geom2d_BezierCurve, Geom2d_BSplineCurve, Geom2d_Line
from OCP.gp import gp_Ax2, gp_Ax3, gp_Circ, gp_Dir, gp_Dir2d, gp_Pln, gp_Pnt, gp_Pnt2d, gp_Vec
from OCP.TColgp import TColgp_Array1OfPnt, TColgp_Array1OfPnt2d, TColgp_Array2OfPnt
from OCP.TColStd import TColStd_Array1OfInteger, TColStd_Array1OfReal
from OCP.TopoDS import TopoDS_Face, TopoDS_Shell, TopoDS_Solid, TopoDS_Wire

from freecad_ortho.fabrication.ruled_sides import Bore, RuledSide, Side
from freecad_ortho.fabrication.solids import plane_of
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

# Distance from a plane, mm, below which the CAD kernel takes a side for plane.
_PLANE = 1e-8
_TOLERANCE = 1e-7
_SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
_AROUND = tuple(_SQUARE[[k, (k + 1) % 4]] for k in range(4))


class Ruled(Protocol):
    """A body of plane and ruled sides, see :class:`freecad_ortho.fabrication.ruled.RuledBody`."""

    @property
    def corners(self) -> FloatArray:
        """(N, 3) corner points, mm."""

    @property
    def sides(self) -> tuple[Side, ...]:
        """Plane or ruled sides."""

    @property
    def sheets(self) -> tuple[RuledSide, ...]:
        """Further sides, cut from surfaces."""

    @property
    def bores(self) -> tuple[Bore, ...]:
        """Holes."""

    def poles(self, start: int, end: int) -> FloatArray:
        """(P, 3) control points of an edge."""

    def rails(self, side: Side) -> tuple[FloatArray, FloatArray]:
        """(P, 3) twice: control points of a side's two edges that straight lines join."""


def ruled_solid(body: Ruled) -> cadquery.Solid:
    """Build the closed solid of a body."""
    return _Builder(body).solid()


class _Builder:
    """Turns a body into a solid."""

    def __init__(self, body: Ruled) -> None:
        self.body = body
        self.builder = BRep_Builder()
        rows = body.corners.tolist()
        self.vertices = [BRepBuilderAPI_MakeVertex(gp_Pnt(*row)).Vertex() for row in rows]
        self.edges: dict[tuple[int, int], tuple[Any, float]] = {}

    def solid(self) -> cadquery.Solid:
        import cadquery

        shell = TopoDS_Shell()
        self.builder.MakeShell(shell)
        faces = [self._side(side) for side in self.body.sides]
        faces += [self._sheet(sheet) for sheet in self.body.sheets]
        faces += [self._wall(bore, faces) for bore in self.body.bores]
        for face in faces:
            self.builder.Add(shell, face)
        shell.Closed(True)
        solid = TopoDS_Solid()
        self.builder.MakeSolid(solid)
        self.builder.Add(solid, shell)
        return cadquery.Solid(solid)

    def _edge(self, start: int, end: int) -> tuple[Any, float, bool]:
        """The edge, the end of its parameter range, and whether it runs from start to end."""
        low, high = min(start, end), max(start, end)
        if (low, high) not in self.edges:
            ends = self.vertices[low], self.vertices[high]
            poles = self.body.poles(low, high)
            if len(poles) == 2:
                edge = BRepBuilderAPI_MakeEdge(*ends).Edge()
                length = float(np.linalg.norm(poles[1] - poles[0]))
            else:
                curve = Geom_BezierCurve(_point_array(poles))
                edge, length = BRepBuilderAPI_MakeEdge(curve, *ends).Edge(), 1.0
            self.edges[low, high] = edge, length
        return *self.edges[low, high], start < end

    def _side(self, side: Side) -> Any:
        surface = self._surface(side)
        if surface is None:
            return self._face(_plane(self._outline(side)), (side,), None)
        return self._face(surface, (side,), (_AROUND,))

    def _sheet(self, sheet: RuledSide) -> Any:
        if sheet.rails is None:
            return self._face(_plane(self._outline(sheet.loops[0])), sheet.loops, None)
        return self._face(_bezier_surface(*sheet.rails), sheet.loops, sheet.places)

    def _face(
        self,
        surface: Any,
        loops: tuple[Side, ...],
        places: tuple[tuple[FloatArray, ...], ...] | None,
    ) -> Any:
        """A face of the edges around it; ``places`` are their curves in its parameters."""
        face = TopoDS_Face()
        self.builder.MakeFace(face, surface, _TOLERANCE)
        for row, loop in enumerate(loops):
            wire = TopoDS_Wire()
            self.builder.MakeWire(wire)
            for number, (start, end) in enumerate(zip(loop, loop[1:] + loop[:1], strict=True)):
                edge, length, forward = self._edge(start, end)
                if places is not None:
                    flat = places[row][number][:: 1 if forward else -1]
                    self.builder.UpdateEdge(edge, _flat_curve(flat, length), face, _TOLERANCE)
                self.builder.Add(wire, edge if forward else edge.Reversed())
            wire.Closed(True)
            self.builder.Add(face, wire)
        return face

    def _outline(self, loop: Side) -> FloatArray:
        """(N, 3) control points around a side."""
        pairs = zip(loop, loop[1:] + loop[:1], strict=True)
        return np.concatenate([self.body.poles(start, end)[:-1] for start, end in pairs])

    def _surface(self, side: Side) -> Any:
        """The surface of a side, None where it is plane."""
        if len(side) != 4:
            return None
        first, second = self.body.rails(side)
        outline = np.concatenate([first, second[::-1]])
        middle, normal = plane_of(outline)
        if np.abs((outline - middle) @ np.array(normal)).max() <= _PLANE:
            return None
        return _bezier_surface(first, second)

    def _wall(self, bore: Bore, faces: list[Any]) -> Any:
        """The wall of a hole, whose rims become openings of the sides that it leads through."""
        axis = bore.end - bore.start
        height = float(np.linalg.norm(axis))
        upwards = gp_Dir(*axis.tolist())
        low, high = (gp_Ax2(gp_Pnt(*centre.tolist()), upwards) for centre in (bore.start, bore.end))
        high.SetXDirection(low.XDirection())
        rims = []
        for place in (low, high):
            circle = gp_Circ(place, bore.diameter / 2)
            # The circle and the seam share a vertex.
            reach = place.Location().Translated(
                gp_Vec(place.XDirection()).Multiplied(bore.diameter / 2)
            )
            vertex = BRepBuilderAPI_MakeVertex(reach).Vertex()
            rims.append((BRepBuilderAPI_MakeEdge(circle, vertex, vertex).Edge(), vertex))
        for (edge, _), number, turned in zip(rims, bore.sides, (False, True), strict=True):
            opening = TopoDS_Wire()
            self.builder.MakeWire(opening)
            self.builder.Add(opening, edge.Reversed() if turned else edge)
            opening.Closed(True)
            self.builder.Add(faces[number], opening)
        return self._tube(low, height, bore.diameter / 2, rims)

    def _tube(
        self, place: gp_Ax2, height: float, radius: float, rims: list[tuple[Any, Any]]
    ) -> Any:
        """A cylinder seen from inside, from its two rims and their vertices."""
        (entry, first), (leave, second) = rims
        line = BRepBuilderAPI_MakeEdge(first, second).Edge()
        face = TopoDS_Face()
        self.builder.MakeFace(face, Geom_CylindricalSurface(gp_Ax3(place), radius), _TOLERANCE)
        along, across = gp_Dir2d(0, 1), gp_Dir2d(1, 0)
        for edge, level in ((entry, 0.0), (leave, height)):
            rim = Geom2d_Line(gp_Pnt2d(0, level), across)
            self.builder.UpdateEdge(edge, rim, face, _TOLERANCE)
        seams = (Geom2d_Line(gp_Pnt2d(turn, 0), along) for turn in (2 * pi, 0.0))
        self.builder.UpdateEdge(line, *seams, face, _TOLERANCE)
        wire = TopoDS_Wire()
        self.builder.MakeWire(wire)
        for edge in (entry, line, leave.Reversed(), line.Reversed()):
            self.builder.Add(wire, edge)
        wire.Closed(True)
        self.builder.Add(face, wire)
        return face.Reversed()


def _plane(outline: FloatArray) -> Any:
    middle, normal = plane_of(outline)
    return Geom_Plane(gp_Pln(gp_Pnt(*middle), gp_Dir(*normal)))


def _bezier_surface(first: FloatArray, second: FloatArray) -> Any:
    """The surface of the straight lines between two curves (P, 3)."""
    poles = TColgp_Array2OfPnt(1, len(first), 1, 2)
    for row, pair in enumerate(zip(first.tolist(), second.tolist(), strict=True), start=1):
        for column, pole in enumerate(pair, start=1):
            poles.SetValue(row, column, gp_Pnt(*pole))
    return Geom_BezierSurface(poles)


def _flat_curve(flat: FloatArray, length: float) -> Any:
    """Curve (M, 2) in the parameters of a surface, run through as its edge is."""
    poles = TColgp_Array1OfPnt2d(1, len(flat))
    for index, pole in enumerate(flat.tolist(), start=1):
        poles.SetValue(index, gp_Pnt2d(*pole))
    if length == 1.0:
        return Geom2d_BezierCurve(poles)
    knots, counts = TColStd_Array1OfReal(1, 2), TColStd_Array1OfInteger(1, 2)
    for index, knot in enumerate((0.0, length), start=1):
        knots.SetValue(index, knot)
        counts.SetValue(index, len(flat))
    return Geom2d_BSplineCurve(poles, knots, counts, len(flat) - 1)


def _point_array(points: FloatArray) -> Any:
    result = TColgp_Array1OfPnt(1, len(points))
    for index, row in enumerate(points.tolist(), start=1):
        result.SetValue(index, gp_Pnt(*row))
    return result
