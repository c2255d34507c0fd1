"""Solids of members with a section of the catalogue, straight from their corners and arcs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from freecad_ortho.fabrication.profiles.end import End
from freecad_ortho.fabrication.profiles.halves import Halves, Loop
from freecad_ortho.fabrication.profiles.outline import Side
from freecad_ortho.fabrication.solids import plane_of, solid_within
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

_PRECISION = 1e-7


def profiled_solid(halves: Halves, points: FloatArray, ends: tuple[End, End]) -> cadquery.Solid:
    """Build the closed solid of a member along x.

    Args:
        halves: its section.
        points: (2 M, 3) corners of the section at its beginning, then at its end, mm.
        ends: the planes that cut it there.
    """
    return solid_within(_Making(halves, points, ends).faces())


class _Making:
    """Vertices and edges of a member, each built once and shared by the faces beside it."""

    def __init__(self, halves: Halves, points: FloatArray, ends: tuple[End, End]) -> None:
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
        from OCP.gp import gp_Pnt

        self._halves, self._points, self._ends = halves, points, ends
        self._count = len(halves.corners)
        self._vertices = [
            BRepBuilderAPI_MakeVertex(gp_Pnt(*row)).Vertex() for row in points.tolist()
        ]
        # Edges by what they are: of a side at an end, along the member, across an end.
        self._edges: dict[tuple[Any, ...], Any] = {}

    def faces(self) -> list[Any]:
        """All faces: both ends, then the sides."""
        made = [face for end in (0, 1) for face in self._caps(end)]
        return made + [self._side(number) for number in range(len(self._halves.sides))]

    def _caps(self, end: int) -> list[Any]:
        halves = self._halves
        if not self._ends[end].folded:
            return [self._cap(halves.rings[0], halves.rings[1:], end, 0)]
        return [
            self._cap(loop, holes, end, half)
            for half, loops in halves.loops.items()
            for loop, holes in halves.holes(loops)
        ]

    def _cap(self, loop: Loop, holes: Sequence[Loop], end: int, half: int) -> Any:
        slope = self._ends[end].slope(half or 1)
        outward = np.array([-1.0, self._ends[end].up, slope]) * (1 if end == 0 else -1)
        start = self._points[loop[0] + end * self._count]
        wires = []
        for ring in (loop, *holes):
            steps = list(zip(ring, (*ring[1:], ring[0]), strict=True))
            edges = [self._across(*step, end, half) for step in steps]
            if end:
                edges = [edge.Reversed() for edge in reversed(edges)]
            wires.append(_wire(edges))
        return _flat(start.tolist(), outward.tolist(), wires)

    def _across(self, corner: int, following: int, end: int, half: int) -> Any:
        """The edge at an end from a corner to the next one, of a side or along the upright."""
        halves = self._halves
        if int(halves.ends[corner, 1]) == following and half in (0, int(halves.side_of[corner])):
            return self._rim(corner, end)
        low, high = sorted((corner, following))
        edge = self._straight(low + end * self._count, high + end * self._count)
        return edge if corner == low else edge.Reversed()

    def _side(self, number: int) -> Any:
        """The face of a side: round the corners from the beginning to the end and back."""
        start, following = self._halves.ends[number].tolist()
        edges = [
            self._straight(start, start + self._count),
            self._rim(number, 1),
            self._straight(following, following + self._count).Reversed(),
            self._rim(number, 0).Reversed(),
        ]
        side = self._halves.sides[number]
        if side.centre is None:
            corners = [start, start + self._count, following + self._count, following]
            return _flat(*plane_of(self._points[corners]), [_wire(edges)])
        return _bent(edges, side)

    def _straight(self, start: int, end: int) -> Any:
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge

        key = (start, end)
        if key not in self._edges:
            edge = BRepBuilderAPI_MakeEdge(self._vertices[start], self._vertices[end])
            self._edges[key] = edge.Edge()
        return self._edges[key]

    def _rim(self, number: int, end: int) -> Any:
        """The edge of a side in a plane of an end."""
        key = ("rim", number, end)
        if key not in self._edges:
            start, following = (self._halves.ends[number] + end * self._count).tolist()
            side = self._halves.sides[number]
            if side.centre is None:
                return self._edges.setdefault(key, self._straight(start, following))
            plane, half = self._ends[end], int(self._halves.side_of[number])
            turned = _curve(side, plane, plane.slope(half))
            self._edges[key] = _arc(turned, self._vertices[start], self._vertices[following])
        return self._edges[key]


def _curve(side: Side, end: End, slope: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Centre and conjugate half axes of the ellipse in which a plane cuts the cylinder of an arc.

    The second half axis is a quarter turn ahead in the direction of the arc.
    """
    assert side.centre is not None
    y, z = side.centre.tolist()
    centre = np.array([end.place + end.up * z + slope * y, z, y])
    arm = side.start - side.centre
    ahead = np.array([-arm[1], arm[0]]) * np.sign(side.sweep)
    axes = [np.array([end.up * z + slope * y, z, y]) for y, z in (arm, ahead)]
    return centre, axes[0], axes[1]


def _arc(ellipse: tuple[FloatArray, FloatArray, FloatArray], start: Any, end: Any) -> Any:
    """The edge of an ellipse between two vertices, in the direction of its half axes."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
    from OCP.gp import gp_Ax2, gp_Circ, gp_Dir, gp_Elips, gp_Pnt

    centre, one, two = ellipse
    # Of p cos t + q sin t the principal half axes are where its square is stationary (Rytz).
    turn = np.arctan2(2 * one @ two, one @ one - two @ two) / 2
    major, minor = one * np.cos(turn) + two * np.sin(turn), two * np.cos(turn) - one * np.sin(turn)
    lengths = np.linalg.norm(major), np.linalg.norm(minor)
    if lengths[0] < lengths[1]:
        major, minor, lengths = minor, -major, lengths[::-1]
    normal = np.cross(major, minor)
    frame = gp_Ax2(gp_Pnt(*centre.tolist()), gp_Dir(*normal.tolist()), gp_Dir(*major.tolist()))
    long, short = map(float, lengths)
    curve = (
        gp_Circ(frame, long) if long - short <= _PRECISION / 10 else gp_Elips(frame, long, short)
    )
    return BRepBuilderAPI_MakeEdge(curve, start, end).Edge()


def _flat(point: list[float], normal: list[float], wires: Sequence[Any]) -> Any:
    """A plane face within wires, the first of them around the others."""
    from OCP.BRep import BRep_Builder
    from OCP.Geom import Geom_Plane
    from OCP.gp import gp_Dir, gp_Pln, gp_Pnt
    from OCP.TopoDS import TopoDS_Face

    face, builder = TopoDS_Face(), BRep_Builder()
    builder.MakeFace(face, Geom_Plane(gp_Pln(gp_Pnt(*point), gp_Dir(*normal))), _PRECISION)
    for wire in wires:
        builder.Add(face, wire)
    return face


def _bent(edges: list[Any], side: Side) -> Any:
    """A face on the cylinder of an arc; its seam is on the other side."""
    from OCP.BRep import BRep_Builder
    from OCP.Geom import Geom_CylindricalSurface
    from OCP.gp import gp_Ax3, gp_Dir, gp_Pnt
    from OCP.ShapeFix import ShapeFix_Edge
    from OCP.TopoDS import TopoDS, TopoDS_Face

    assert side.centre is not None
    y, z = side.centre.tolist()
    away = side.centre - side.at(np.array([0.5]))[0]
    frame = gp_Ax3(gp_Pnt(0, z, y), gp_Dir(-1, 0, 0), gp_Dir(0, float(away[1]), float(away[0])))
    surface = Geom_CylindricalSurface(frame, side.radius)
    face, builder = TopoDS_Face(), BRep_Builder()
    builder.MakeFace(face, surface, _PRECISION)
    fixing = ShapeFix_Edge()
    for edge in map(TopoDS.Edge_s, edges):
        fixing.FixAddPCurve(edge, face, False, _PRECISION)
        fixing.FixSameParameter(edge)
    if side.sweep > 0:
        builder.Add(face, _wire(edges))
        return face
    # Around the cylinder's own normal, which points into the hollow.
    builder.Add(face, _wire([edge.Reversed() for edge in reversed(edges)]))
    return face.Reversed()


def _wire(edges: Sequence[Any]) -> Any:
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Wire

    wire, builder = TopoDS_Wire(), BRep_Builder()
    builder.MakeWire(wire)
    for edge in edges:
        builder.Add(wire, edge)
    wire.Closed(True)
    return wire
