"""Sides of parts as polygons: exact where all sides are plane and straight, else triangles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Polyhedron
from freecad_ortho.fabrication.part import Part
from solver.mesh.quadmesh import FloatArray

# Largest distance of triangles from a bent side, mm, and angle from one to the next.
CHORD, _ANGLE = 0.05, 0.25
# Corners that are as near, mm, are one: the CAD kernel's tolerance.
_SAME = 1e-6

Ring = tuple[int, ...]


@dataclass(frozen=True, eq=False)
class Facets:
    """A closed surface of plane polygons in a part's own coordinates.

    Attributes:
        points: (N, 3) corners, mm.
        sides: of each polygon the corners around it, counter-clockwise seen from outside, then
            those around its openings, the other way round; of triangles an array (T, 1, 3).
        exact: whether they are the part's own sides.
    """

    points: FloatArray
    sides: Sequence[Sequence[Sequence[int]]]
    exact: bool

    @property
    def triangles(self) -> FloatArray:
        """(T, 3, 3) corners of triangles that fill the polygons."""
        if isinstance(self.sides, np.ndarray):
            return np.asarray(self.points[self.sides[:, 0]])
        found = []
        for outer, *openings in self.sides:
            if len(outer) == 3:
                found.append(self.points[list(outer)][None])
            else:
                found.append(_filled(self.points, (outer, *openings)))
        return np.concatenate(found)

    @property
    def volume(self) -> float:
        """Volume within, mm3."""
        total = 0.0
        base = self.points[0]
        if isinstance(self.sides, np.ndarray):
            a, b, c = np.moveaxis(self.triangles - base, 1, 0)
            return float(np.einsum("tk,tk->", a, np.cross(b, c))) / 6
        for rings in self.sides:
            for ring in rings:
                arms = self.points[list(ring)] - base
                total += float(np.cross(arms[1:-1], arms[2:]).sum(axis=0) @ arms[0])
        return total / 6


# Of bodies whose solids were asked: several files of an export are made of them.
_known: WeakKeyDictionary[Body, Facets] = WeakKeyDictionary()


def facets(part: Part) -> Facets:
    """The sides of a part in its own coordinates; worked out once as long as its body is there."""
    if isinstance(part.body, Polyhedron):
        sides = tuple((tuple(loop),) for loop in part.body.loops)
        return Facets(np.asarray(part.body.corners), sides, exact=True)
    if part.body not in _known:
        shape = solid_of(part)
        _known[part.body] = _plane_sides(shape) or _triangles(shape)
    return _known[part.body]


def solid_of(part: Part) -> Any:
    """The CAD kernel's solid of a part in its own coordinates."""
    from OCP.TopLoc import TopLoc_Location

    return part.solid().wrapped.Located(TopLoc_Location())


def has_plane_sides(part: Part) -> bool:
    """Whether all sides of a part are plane and straight, so that its facets are they."""
    if isinstance(part.body, Polyhedron):
        return True
    if part.body in _known:
        return _known[part.body].exact
    found = _plane_sides(solid_of(part))
    if found is not None:
        _known[part.body] = found
    return found is not None


class _Corners:
    """Corners by their places, each once."""

    def __init__(self) -> None:
        self.points: list[tuple[float, float, float]] = []
        self.numbers: dict[tuple[int, int, int], int] = {}

    def number(self, place: Any) -> int:
        point = place.X(), place.Y(), place.Z()
        x, y, z = (round(value / _SAME) for value in point)
        if (x, y, z) not in self.numbers:
            self.numbers[x, y, z] = len(self.points)
            self.points.append(point)
        return self.numbers[x, y, z]


def _plane_sides(shape: Any) -> Facets | None:
    """The faces of a solid, None where one is bent or has a bent edge."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepAdaptor import BRepAdaptor_Curve, BRepAdaptor_Surface
    from OCP.BRepTools import BRepTools, BRepTools_WireExplorer
    from OCP.GeomAbs import GeomAbs_CurveType, GeomAbs_SurfaceType
    from OCP.TopAbs import TopAbs_Orientation, TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    def ring(wire: Any, face: Any) -> Ring | None:
        around = BRepTools_WireExplorer(wire, face)
        found = []
        while around.More():
            curve = BRepAdaptor_Curve(around.Current())
            if curve.GetType() != GeomAbs_CurveType.GeomAbs_Line:
                return None
            found.append(corners.number(BRep_Tool.Pnt_s(around.CurrentVertex())))
            around.Next()
        return tuple(found)

    corners, sides = _Corners(), []
    faces = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE)
    while faces.More():
        face = TopoDS.Face_s(faces.Current())
        surface = BRepAdaptor_Surface(face)
        if surface.GetType() != GeomAbs_SurfaceType.GeomAbs_Plane:
            return None
        axes = surface.Plane().Position()
        outwards = np.cross(_vector(axes.XDirection()), _vector(axes.YDirection()))
        if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED:
            outwards = -outwards
        outer = BRepTools.OuterWire_s(face)
        rings: list[Ring] = []
        wires = TopExp_Explorer(face, TopAbs_ShapeEnum.TopAbs_WIRE)
        while wires.More():
            wire = TopoDS.Wire_s(wires.Current())
            found = ring(wire, face)
            if found is None:
                return None
            rings.insert(0 if wire.IsSame(outer) else len(rings), found)
            wires.Next()
        sides.append((rings, outwards))
        faces.Next()
    points = np.array(corners.points)
    return Facets(points, tuple(_turned(points, *side) for side in sides), exact=True)


def _vector(direction: Any) -> tuple[float, float, float]:
    return direction.X(), direction.Y(), direction.Z()


def _turned(points: FloatArray, rings: list[Ring], outwards: FloatArray) -> tuple[Ring, ...]:
    """The outer ring counter-clockwise about a normal, the others clockwise."""
    found = []
    for number, ring in enumerate(rings):
        arms = points[list(ring)] - points[ring[0]]
        area = float(np.cross(arms[1:-1], arms[2:]).sum(axis=0) @ outwards)
        found.append(ring if (area > 0) == (number == 0) else ring[::-1])
    return tuple(found)


def _triangles(shape: Any) -> Facets:
    """Triangles within ``CHORD`` of a solid's sides."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.TopAbs import TopAbs_Orientation, TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopLoc import TopLoc_Location
    from OCP.TopoDS import TopoDS

    BRepMesh_IncrementalMesh(shape, CHORD, False, _ANGLE, False)
    points: list[tuple[float, float, float]] = []
    triangles: list[FloatArray] = []
    faces = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE)
    while faces.More():
        face = TopoDS.Face_s(faces.Current())
        mesh = BRep_Tool.Triangulation_s(face, TopLoc_Location())
        corners = [mesh.Triangle(k + 1).Get() for k in range(mesh.NbTriangles())]
        around = np.array(corners) + (len(points) - 1)
        turned = face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED
        triangles.append(around[:, ::-1] if turned else around)
        nodes = [mesh.Node(k + 1) for k in range(mesh.NbNodes())]
        points += [(node.X(), node.Y(), node.Z()) for node in nodes]
        faces.Next()
    places = np.array(points)
    _, first, same = np.unique(
        np.round(places / _SAME), axis=0, return_index=True, return_inverse=True
    )
    found = same.reshape(-1)[np.concatenate(triangles)].astype(np.int32)
    found = found[(found != np.roll(found, 1, axis=1)).all(axis=1)]
    return Facets(places[first], found[:, None], exact=False)


def _filled(points: FloatArray, rings: Sequence[Sequence[int]]) -> FloatArray:
    """(T, 3, 3) triangles of a plane polygon with openings, as its outer ring turns."""
    import shapely

    outer = points[list(rings[0])]
    arms = outer - outer[0]
    normal = np.cross(arms[1:-1], arms[2:]).sum(axis=0)
    normal = normal / np.linalg.norm(normal)
    along = arms[np.argmax(np.linalg.norm(arms, axis=1))]
    along = along / np.linalg.norm(along)
    axes = np.stack([along, np.cross(normal, along)])
    flat = [(points[list(ring)] - outer[0]) @ axes.T for ring in rings]
    polygon = shapely.Polygon(flat[0], flat[1:])
    pieces = shapely.get_parts(shapely.constrained_delaunay_triangles(polygon))
    found = np.array([np.array(piece.exterior.coords)[:3] for piece in pieces])
    one, two = found[:, 1] - found[:, 0], found[:, 2] - found[:, 0]
    turned = one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0] < 0
    found[turned] = found[turned, ::-1]
    return np.asarray(outer[0] + found @ axes)
