"""Edges, faces and planes of a document that vertices glide on or stay near."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
import numpy as np

from freecad_ortho import convert
from freecad_ortho.objects import net as net_object
from freecad_ortho.objects import places
from freecad_ortho.written import plane
from solver.errors import InputError
from solver.mesh.closest import Polyline, TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.constraints import BoundaryGlide, CurveGlide, Glide, PlaneGlide, SurfaceGlide

Reference = tuple[FreeCAD.DocumentObject, str]
Triangles = tuple[FloatArray, IntArray]

# Curves and surfaces are followed to this part of a mean edge.
_CURVE_DEVIATION, _SURFACE_DEVIATION = 1e-4, 1e-3
# Size, in mm, of a mesh to which every curve and surface is coarse: only to see whether it is one.
_COARSE = 1e9
# Boundary vertices nearer than this to what they may glide on, in mean edges, do so.
_NEAR = 0.5
# Half the side of the square that stands for an endless plane, in sizes of the mesh.
_ENDLESS = 10.0
_PLANES = ("App::Plane", "PartDesign::Plane")
_EXPECTED = "expected boundary, a plane such as z=0, or an edge or face such as (object, 'Face1')"


def references(links: Sequence[tuple[Any, Any]]) -> list[Reference]:
    """One pair of object and name of edge or face for each link."""
    found = []
    for feature, names in links:
        parts = [names] if isinstance(names, str) else list(names)
        found += [(feature, part) for part in parts or [""] if feature is not None]
    return found


def glide_words(net: FreeCAD.DocumentObject) -> list[Any]:
    """What a net's vertices glide on, as ``optimise_net`` takes it."""
    named = dict(entry.split(":", 1) for entry in net.GlidingVertices if ":" in entry)
    found: list[Any] = list(net.GlideRules)
    for feature, part in references(net.GlideOn):
        numbers = named.get(f"{feature.Name}.{part}")
        vertices = [int(word) for word in numbers.split(",")] if numbers else None
        found.append((feature, part, vertices) if vertices else (feature, part))
    return found


def store_glide(net: FreeCAD.DocumentObject, entries: Sequence[Any]) -> None:
    """Write into a net's properties what its vertices glide on.

    Raises:
        InputError: an entry that nothing glides on.
    """
    rules, links, named = [], [], []
    for entry in [entries] if isinstance(entries, str) else entries:
        if isinstance(entry, str):
            _rule(entry)
            rules.append(entry)
            continue
        feature, part, *vertices = _reference("glide", entry)
        _geometry(feature, part, _COARSE)
        links.append((feature, part))
        if vertices and vertices[0]:
            numbers = ",".join(str(int(vertex)) for vertex in vertices[0])
            named.append(f"{feature.Name}.{part}:{numbers}")
    net.GlideRules, net.GlideOn, net.GlidingVertices = rules, links, named


def store_close_to(net: FreeCAD.DocumentObject, entries: Any) -> None:
    """Write into a net's property what it is to stay near.

    Raises:
        InputError: an entry that is no surface.
    """
    links = []
    for entry in _listed(entries):
        # A net that was sampled from faces stands for these.
        faces = getattr(entry, "CadFaces", None)
        if faces:
            links += references(faces)
            continue
        links.append(require_surface(entry))
    net.CloseTo = links


def require_surface(entry: Any) -> Reference:
    """Give object and face of an entry.

    Raises:
        InputError: it is an edge, or nothing at all.
    """
    feature, part, *_ = _reference("close_to", entry)
    if isinstance(_geometry(feature, part, _COARSE), Polyline):
        raise InputError(f"close_to: {feature.Label}.{part} is an edge; choose a face")
    return feature, part


def glides(
    entries: Sequence[Any], mesh: QuadMesh, net: FreeCAD.DocumentObject
) -> tuple[Glide, ...]:
    """What the vertices of a net's mesh glide on, for the solver, in the net's coordinates.

    Args:
        entries: as of :func:`glide_words`.
        mesh: of the net.
        net: edges and faces in other parts are taken where they stand beside it.

    Raises:
        InputError: an edge or face that has gone, or that no vertex is near.
    """
    found: list[Glide] = []
    curved: list[Triangles] = []
    for entry in entries:
        if isinstance(entry, str):
            found.append(_rule(entry))
            continue
        feature, part, *vertices = entry
        named = np.array(vertices[0], dtype=np.int64) if vertices else None
        shape = _beside(net, feature, _geometry(feature, part, mesh.mean_edge))
        if isinstance(shape, Polyline):
            chosen = _near(mesh, shape, part) if named is None else named
            found.append(CurveGlide(shape.points, shape.closed, chosen))
        elif named is None and not _is_plane(feature, part):
            curved.append(shape)
        else:
            points, triangles = _endless(shape, mesh) if _is_plane(feature, part) else shape
            chosen = named
            if chosen is None:
                chosen = _near(mesh, TriangleSurface(points, triangles), part)
            found.append(SurfaceGlide(points, triangles, chosen))
    if curved:
        found.append(SurfaceGlide(*_joined(curved)))
    return tuple(found)


def close_to(
    entries: Sequence[Reference], mesh: QuadMesh, net: FreeCAD.DocumentObject
) -> Triangles | None:
    """Surface that a net's mesh stays near, in the net's coordinates; None where there is none."""
    parts = [_beside(net, each[0], _geometry(*each, mesh.mean_edge)) for each in entries]
    return _joined([part for part in parts if not isinstance(part, Polyline)]) if parts else None


def describe(entry: Any) -> str:
    """Words for a list: the object's label and the name of its edge or face."""
    if isinstance(entry, str):
        return entry
    feature, part, *vertices = entry
    name = f"{feature.Label}.{part}" if part else feature.Label
    return f"{name} ({len(vertices[0])})" if vertices and vertices[0] else name


def _listed(entries: Any) -> list[Any]:
    if not entries:
        return []
    single = isinstance(entries, tuple) or not isinstance(entries, list)
    return [entries] if single else entries


def _reference(word: str, entry: Any) -> tuple[Any, ...]:
    """Pair of object and name, with vertices where they are given."""
    whole = entry if isinstance(entry, (tuple, list)) else (entry, "")
    if not len(whole) or not hasattr(whole[0], "TypeId"):
        raise InputError(f"{word}: {_EXPECTED}, got {entry!r}")
    return (*whole, "") if len(whole) == 1 else tuple(whole)


def _rule(text: str) -> Glide:
    """Gliding that a text describes: ``boundary``, ``z=0``, or ``z=1.5m@1,2,3`` with vertices."""
    what, _, named = text.removeprefix("plane:").replace(" ", "").partition("@")
    found = plane(what)
    try:
        vertices = np.array([int(word) for word in named.split(",")]) if named else None
        if what == "boundary" and not named:
            return BoundaryGlide()
        if found is not None:
            return PlaneGlide(*found, vertices)
    except ValueError:
        pass
    raise InputError(f"glide: {_EXPECTED}, got '{text}'")


def _geometry(feature: FreeCAD.DocumentObject, part: str, size: float) -> Polyline | Triangles:
    """A curve, or points and triangles of a surface, followed to a fraction of ``size``, mm.

    They are in the coordinates of the part that contains the object; planes in the document's.

    Raises:
        InputError: there is no such edge or face.
    """
    if feature.TypeId in _PLANES:
        return _square(feature.getGlobalPlacement(), size)
    if net_object.is_net(feature):
        surface = TriangleSurface.from_quads(convert.quad_mesh(feature))
        return surface.vertices, surface.triangles
    if not hasattr(feature, "Shape"):
        places.refuse_link(feature)
    if hasattr(feature, "Mesh"):
        points, triangles = feature.Mesh.Topology
        return convert.array(points), np.array(triangles, dtype=np.int64)
    shape = feature.getSubObject(part) if part else getattr(feature, "Shape", None)
    if shape is None or shape.isNull():
        raise InputError(f"{feature.Label}: has no '{part}' any more; choose an edge or face anew")
    if shape.ShapeType == "Edge":
        points = shape.discretize(Deflection=_CURVE_DEVIATION * size)
        return Polyline(convert.array(points), closed=shape.isClosed())
    points, triangles = shape.tessellate(_SURFACE_DEVIATION * size)
    if not triangles:
        raise InputError(f"{feature.Label}: '{part}' is no edge or face; choose another")
    return convert.array(points), np.array(triangles, dtype=np.int64)


def _beside(
    net: FreeCAD.DocumentObject, feature: FreeCAD.DocumentObject, shape: Polyline | Triangles
) -> Polyline | Triangles:
    """Geometry as :func:`_geometry` gives it, in the coordinates of a net."""
    place = places.between(net, feature)
    if feature.TypeId in _PLANES:
        place = places.container(net).inverse()
    if place.isIdentity():
        return shape
    if isinstance(shape, Polyline):
        return Polyline(places.moved(shape.points, place), closed=shape.closed)
    return places.moved(shape[0], place), shape[1]


def _is_plane(feature: FreeCAD.DocumentObject, part: str) -> bool:
    if feature.TypeId in _PLANES:
        return True
    shape = feature.getSubObject(part) if part.startswith("Face") else None
    return shape is not None and shape.Surface.TypeId == "Part::GeomPlane"


def _endless(flat: Triangles, mesh: QuadMesh) -> Triangles:
    """A square in the plane of a flat surface, far wider than the mesh."""
    points, triangles = flat
    a, b, c = points[triangles[0]]
    rotation = FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), FreeCAD.Vector(*np.cross(b - a, c - a)))
    middle = mesh.vertices.mean(axis=0)
    normal = np.array(rotation.multVec(FreeCAD.Vector(0, 0, 1)))
    foot = middle - normal * ((middle - a) @ normal)
    extent = float(np.linalg.norm(np.ptp(mesh.vertices, axis=0)))
    return _square(FreeCAD.Placement(FreeCAD.Vector(*foot), rotation), _ENDLESS * extent)


def _square(placement: FreeCAD.Placement, half: float) -> Triangles:
    corners = [(-half, -half), (half, -half), (half, half), (-half, half)]
    points = [placement.multVec(FreeCAD.Vector(x, y, 0)) for x, y in corners]
    return convert.array(points), np.array([[0, 1, 2], [0, 2, 3]])


def _near(mesh: QuadMesh, rail: Polyline | TriangleSurface, part: str) -> IntArray:
    """Boundary vertices within half a mean edge of what they glide on."""
    rim = np.flatnonzero(mesh.connectivity.boundary_vertices)
    feet, _ = rail.closest(mesh.vertices[rim])
    distance = np.linalg.norm(mesh.vertices[rim] - feet, axis=1)
    chosen = rim[distance <= _NEAR * mesh.mean_edge]
    if not len(chosen):
        raise InputError(
            f"glide: no boundary vertex lies within half a mean edge of {part or 'the plane'}; "
            "move the net there or name the vertices"
        )
    return chosen


def _joined(parts: list[Triangles]) -> Triangles:
    """One surface of several."""
    counts = np.cumsum([0] + [len(points) for points, _ in parts])
    triangles = [each + first for (_, each), first in zip(parts, counts, strict=False)]
    return np.concatenate([points for points, _ in parts]), np.concatenate(triangles)


def reference_surface(net: FreeCAD.DocumentObject, mesh: QuadMesh) -> TriangleSurface | None:
    """What a net is held against: the faces it stays near, else those that it was sampled from."""
    entries = references(net.CloseTo) or references(getattr(net, "CadFaces", None) or ())
    near = close_to(entries, mesh, net)
    return None if near is None else TriangleSurface(*near)
