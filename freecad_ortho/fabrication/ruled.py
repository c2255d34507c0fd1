"""Bodies whose sides are ruled: plane, or swept by a straight line between two edges."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Loops, Polyhedron
from freecad_ortho.fabrication.solids import plane_of
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

Side = tuple[int, ...]
# Distance from a plane, mm, below which the CAD kernel takes a side for plane.
_PLANE = 1e-8
_TOLERANCE = 1e-7
# Corners at one end of a block that has more points than its corners.
_RING = {16: 4}


@dataclass(frozen=True, eq=False)
class RuledBody(Body):
    """A closed body of plane and ruled sides.

    Attributes:
        corners: (N, 3) corner points, mm.
        sides: corner numbers around each side, counter-clockwise seen from outside. A side of four
            corners may be ruled: straight lines join the edge from the first to the second corner
            with that from the fourth to the third. All others are plane.
        handles: inner control points (2, 3) of the edges that are cubic curves, by their corners,
            the smaller number first; all other edges are straight.
        blocks: (6, 3) or (8, 3) corners of prisms that together hold the body, one end's, then the
            other's; (16, 3) with the control points of curved edges after them.
    """

    corners: FloatArray
    sides: tuple[Side, ...]
    handles: Mapping[tuple[int, int], FloatArray] = field(default_factory=dict)
    blocks: tuple[FloatArray, ...] = ()

    def pieces(self) -> tuple[Polyhedron, ...]:
        """The blocks."""
        if not self.blocks:
            return super().pieces()
        found = []
        for block in self.blocks:
            half = _RING.get(len(block), len(block) // 2)
            sides = [(k, (k + 1) % half, (k + 1) % half + half, k + half) for k in range(half)]
            ends = [tuple(range(half, 2 * half)), tuple(reversed(range(half)))]
            # Hulls of another number of points are another shape to the clash check.
            loops: Loops = tuple([*ends, *sides][:: -1 if len(block) in _RING else 1])
            found.append(Polyhedron(block, loops))
        return tuple(found)

    def seen_from(self, origin: FloatArray, frame: FloatArray) -> RuledBody:
        """The same body seen from an ``origin`` (3,), its axes the rows of ``frame`` (3, 3)."""
        return replace(
            self,
            corners=(self.corners - origin) @ frame.T,
            handles={ends: (inner - origin) @ frame.T for ends, inner in self.handles.items()},
            blocks=tuple((block - origin) @ frame.T for block in self.blocks),
        )

    @cached_property
    def points(self) -> FloatArray:
        """(N, 3) corners and control points."""
        return np.concatenate([self.corners, *self.handles.values()])

    def rails(self, side: Side) -> tuple[FloatArray, FloatArray]:
        """(4, 3) or (2, 3) control points of a side's two edges that straight lines join."""
        a, b, c, d = side
        return self._poles(a, b), self._poles(d, c)

    def _poles(self, start: int, end: int) -> FloatArray:
        inner = self.handles.get((min(start, end), max(start, end)))
        if inner is None:
            return self.corners[[start, end]]
        inner = inner if start < end else inner[::-1]
        return np.concatenate([self.corners[[start]], inner, self.corners[[end]]])

    @cached_property
    def volume(self) -> float:
        """Volume by the divergence theorem; quadrature that is exact for these sides."""
        u, weight_u = _gauss(6)
        v, weight_v = _gauss(2)
        values, slopes = _cubic(u)
        origin = self.corners[0]
        ruled = [side for side in self.sides if len(side) == 4]
        rails = np.array([[_raised(rail) - origin for rail in self.rails(each)] for each in ruled])
        one, two = np.moveaxis(np.einsum("qp,srpk->srqk", values, rails), 1, 0)
        along_one, along_two = np.moveaxis(np.einsum("qp,srpk->srqk", slopes, rails), 1, 0)
        total = 0.0
        for place, weight in zip(v, weight_v, strict=True):
            point = (1 - place) * one + place * two
            along = (1 - place) * along_one + place * along_two
            flux = np.einsum("sqk,sqk->q", point, np.cross(along, two - one))
            total += weight * float(weight_u @ flux)
        return total / 3 + self._volume_to_planes(origin)

    def _volume_to_planes(self, origin: FloatArray) -> float:
        """Volume of the cones from a point to the sides that do not have four corners."""
        fans = [
            (side[0], side[k], side[k + 1])
            for side in self.sides
            if len(side) != 4
            for k in range(1, len(side) - 1)
        ]
        if not fans:
            return 0.0
        a, b, c = np.moveaxis(self.corners[np.array(fans)] - origin, 1, 0)
        return float(np.einsum("tk,tk->", a, np.cross(b, c))) / 6

    def solid(self) -> cadquery.Solid:
        """Build the closed solid from shared edges; no boolean operation, no sewing."""
        return _Builder(self).solid()


class _Builder:
    """Turns a body into a solid of the CAD kernel."""

    def __init__(self, body: RuledBody) -> None:
        from OCP.BRep import BRep_Builder
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
        from OCP.gp import gp_Pnt

        self.body = body
        self.builder = BRep_Builder()
        rows = body.corners.tolist()
        self.vertices = [BRepBuilderAPI_MakeVertex(gp_Pnt(*row)).Vertex() for row in rows]
        self.edges: dict[tuple[int, int], tuple[Any, float]] = {}

    def solid(self) -> cadquery.Solid:
        import cadquery
        from OCP.TopoDS import TopoDS_Shell, TopoDS_Solid

        shell = TopoDS_Shell()
        self.builder.MakeShell(shell)
        for side in self.body.sides:
            self.builder.Add(shell, self._face(side))
        shell.Closed(True)
        solid = TopoDS_Solid()
        self.builder.MakeSolid(solid)
        self.builder.Add(solid, shell)
        return cadquery.Solid(solid)

    def _edge(self, start: int, end: int) -> tuple[Any, float, bool]:
        """The edge, the end of its parameter range, and whether it runs from start to end."""
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
        from OCP.Geom import Geom_BezierCurve

        low, high = min(start, end), max(start, end)
        if (low, high) not in self.edges:
            ends = self.vertices[low], self.vertices[high]
            poles = self.body._poles(low, high)
            if len(poles) == 2:
                edge = BRepBuilderAPI_MakeEdge(*ends).Edge()
                length = float(np.linalg.norm(poles[1] - poles[0]))
            else:
                curve = Geom_BezierCurve(_point_array(poles))
                edge, length = BRepBuilderAPI_MakeEdge(curve, *ends).Edge(), 1.0
            self.edges[low, high] = edge, length
        return *self.edges[low, high], start < end

    def _face(self, side: Side) -> Any:
        from OCP.TopoDS import TopoDS_Face, TopoDS_Wire

        surface, plane = self._surface(side)
        face, wire = TopoDS_Face(), TopoDS_Wire()
        self.builder.MakeFace(face, surface, _TOLERANCE)
        self.builder.MakeWire(wire)
        square = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
        for number, (start, end) in enumerate(zip(side, side[1:] + side[:1], strict=True)):
            edge, length, forward = self._edge(start, end)
            if not plane:
                ends = (square[number], square[(number + 1) % 4])[:: 1 if forward else -1]
                self.builder.UpdateEdge(edge, _flat_line(*ends, length), face, _TOLERANCE)
            self.builder.Add(wire, edge if forward else edge.Reversed())
        wire.Closed(True)
        self.builder.Add(face, wire)
        return face

    def _surface(self, side: Side) -> tuple[Any, bool]:
        """The side's surface, and whether it is a plane."""
        from OCP.Geom import Geom_BezierSurface, Geom_Plane
        from OCP.gp import gp_Dir, gp_Pln, gp_Pnt
        from OCP.TColgp import TColgp_Array2OfPnt

        if len(side) == 4:
            first, second = self.body.rails(side)
            outline = np.concatenate([first, second[::-1]])
        else:
            first = second = outline = self.body.corners[list(side)]
        middle, normal = plane_of(outline)
        miss = float(np.abs((outline - middle) @ np.array(normal)).max())
        if miss <= _PLANE or len(side) != 4:
            return Geom_Plane(gp_Pln(gp_Pnt(*middle), gp_Dir(*normal))), True
        degree = max(len(first), len(second))
        if degree > 2:
            first, second = _raised(first), _raised(second)
        poles = TColgp_Array2OfPnt(1, degree, 1, 2)
        for row, pair in enumerate(zip(first.tolist(), second.tolist(), strict=True), start=1):
            for column, pole in enumerate(pair, start=1):
                poles.SetValue(row, column, gp_Pnt(*pole))
        return Geom_BezierSurface(poles), False


def _flat_line(start: tuple[float, float], end: tuple[float, float], length: float) -> Any:
    """Straight curve in the parameters of a surface, run through as its edge is."""
    from OCP.Geom2d import Geom2d_BSplineCurve
    from OCP.gp import gp_Pnt2d
    from OCP.TColgp import TColgp_Array1OfPnt2d
    from OCP.TColStd import TColStd_Array1OfInteger, TColStd_Array1OfReal

    poles = TColgp_Array1OfPnt2d(1, 2)
    knots, counts = TColStd_Array1OfReal(1, 2), TColStd_Array1OfInteger(1, 2)
    for index, (pole, knot) in enumerate(((start, 0.0), (end, length)), start=1):
        poles.SetValue(index, gp_Pnt2d(*pole))
        knots.SetValue(index, knot)
        counts.SetValue(index, 2)
    return Geom2d_BSplineCurve(poles, knots, counts, 1)


def _point_array(points: FloatArray) -> Any:
    from OCP.gp import gp_Pnt
    from OCP.TColgp import TColgp_Array1OfPnt

    result = TColgp_Array1OfPnt(1, len(points))
    for index, row in enumerate(points.tolist(), start=1):
        result.SetValue(index, gp_Pnt(*row))
    return result


def _raised(poles: FloatArray) -> FloatArray:
    """(4, 3) control points of the same curve as a cubic."""
    if len(poles) == 4:
        return poles
    share = np.arange(4)[:, None] / 3
    return np.asarray((1 - share) * poles[0] + share * poles[1])


def _gauss(count: int) -> tuple[FloatArray, FloatArray]:
    """Places and weights of Gauss quadrature on [0, 1]."""
    places, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (places + 1), 0.5 * weights


def _cubic(u: FloatArray) -> tuple[FloatArray, FloatArray]:
    """(Q, 4) Bernstein polynomials of degree three and their derivatives."""
    v = 1 - u
    values = np.stack([v**3, 3 * u * v**2, 3 * u**2 * v, u**3], axis=1)
    slopes = np.stack([-3 * v**2, 3 * v**2 - 6 * u * v, 6 * u * v - 3 * u**2, 3 * u**2], axis=1)
    return values, slopes
