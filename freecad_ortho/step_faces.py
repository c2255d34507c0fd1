"""Faces of STEP files as surfaces to sample, through cadquery; needs no FreeCAD."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from solver.errors import InputError
from solver.io.reading import read_bytes
from solver.mesh.border import closed_loops
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.poles import stand_in
from solver.mesh.quadmesh import FloatArray
from solver.mesh.sampling import ParametricSurface, SampledNet, sampled

if TYPE_CHECKING:
    import cadquery
    from OCP.Geom import Geom_Surface

_ENDINGS = (".step", ".stp")
# Points of the triangles that stand for faces, about.
_POINTS = 12_000
_SAME_AREA = 1e-6
# How far polylines stray from edges, in parts of the face's size.
_DEFLECTION = 2e-5
_TOLERANCE = 1e-7


def is_step(path: str | os.PathLike[str]) -> bool:
    """Whether a file's name says that it is one of STEP."""
    return Path(path).suffix.lower() in _ENDINGS


def triangles_from_step(
    path: str | os.PathLike[str], faces: Sequence[int] = ()
) -> tuple[FloatArray, IntArray]:
    """Vertices (V, 3) in mm and triangles (T, 3) on faces of a STEP file, by default on all.

    Raises:
        InputError: as :func:`step_surfaces`, or a face that cannot be sampled.
    """
    return triangles_on(step_surfaces(path, faces))


def triangles_on(surfaces: Sequence[ParametricSurface]) -> tuple[FloatArray, IntArray]:
    """Vertices (V, 3) and triangles (T, 3) on faces, in their unit.

    Raises:
        InputError: a face that cannot be sampled.
    """
    area = sum(surface.area for surface in surfaces)
    return stand_in(surfaces, math.sqrt(area / _POINTS))


def net_from_step(
    path: str | os.PathLike[str],
    faces: Sequence[int] = (),
    *,
    counts: tuple[int, int] | None = None,
    edge: float | None = None,
    spacing: str = "length",
    outside: str = "snap",
    u_part: tuple[float, float] = (0.0, 1.0),
    v_part: tuple[float, float] = (0.0, 1.0),
) -> SampledNet:
    """Sample a net, in mm, from faces of a STEP file, joined where they meet.

    Args:
        path: the STEP file.
        faces: numbers from 1, in the order of the file; by default all.
        counts: vertices along u and v of the first face.
        edge: wanted edge length in mm instead.
        spacing: ``length`` or ``parameter``.
        outside: ``snap`` or ``drop`` what a border cuts.
        u_part: part of each face's range of u, 0 to 1.
        v_part: the same for v.

    Raises:
        InputError: no such file or face, or a face that cannot be sampled so.
    """
    surfaces = [surface.part(u_part, v_part) for surface in step_surfaces(path, faces)]
    return sampled(surfaces, counts=counts, edge=edge, spacing=spacing, outside=outside)


def step_surfaces(
    path: str | os.PathLike[str], faces: Sequence[int] = ()
) -> list[ParametricSurface]:
    """Faces of a STEP file, numbered from 1; by default all.

    Raises:
        InputError: the file is missing or holds no faces, cadquery is missing, or no such face.
    """
    if not Path(path).is_file():
        raise InputError(f"{path}: no such file; check the path")
    if b"ISO-10303-21" not in read_bytes(path)[:1000]:
        raise InputError(
            f"{path}: is no STEP file, it does not begin with ISO-10303-21; export STEP"
        )
    try:
        import cadquery
    except ImportError:
        raise InputError(f"{path}: reading STEP needs cadquery; install it") from None
    try:
        items = cadquery.importers.importStep(os.fspath(path)).faces().vals()
    except Exception as error:  # cadquery raises whatever its kernel raises
        reason = (str(error).splitlines() or ["damaged"])[0][:80]
        raise InputError(f"{path}: cannot be read as STEP ({reason}); export it again") from None
    found = [item for item in items if isinstance(item, cadquery.Face)]
    if not found:
        raise InputError(f"{path}: holds no faces; export surfaces or solids")
    numbers = list(faces) or list(range(1, len(found) + 1))
    for number in numbers:
        if not 1 <= number <= len(found):
            raise InputError(f"faces: {path} has faces 1 to {len(found)}, not {number}")
    return [_surface(found[number - 1], f"face {number}") for number in numbers]


def _surface(face: cadquery.Face, name: str) -> ParametricSurface:
    from OCP.BRepAdaptor import BRepAdaptor_Surface
    from OCP.BRepTopAdaptor import BRepTopAdaptor_FClass2d
    from OCP.gp import gp_Pnt, gp_Pnt2d
    from OCP.ShapeAnalysis import ShapeAnalysis_Surface
    from OCP.TopAbs import TopAbs_Orientation, TopAbs_State

    surface = BRepAdaptor_Surface(face.wrapped)
    domain = BRepTopAdaptor_FClass2d(face.wrapped, _TOLERANCE)
    geometry = face._geomAdaptor()
    feet = ShapeAnalysis_Surface(geometry)
    u = surface.FirstUParameter(), surface.LastUParameter()
    v = surface.FirstVParameter(), surface.LastVParameter()
    turned = face.wrapped.Orientation() == TopAbs_Orientation.TopAbs_REVERSED

    def places(first: FloatArray, second: FloatArray) -> Any:
        # Backwards along u where the face shows its surface's other side.
        first = u[0] + u[1] - first if turned else first
        return zip(first.tolist(), second.tolist(), strict=True)

    def evaluate(first: FloatArray, second: FloatArray) -> FloatArray:
        return np.array([_xyz(surface.Value(*pair)) for pair in places(first, second)])

    def inside(first: FloatArray, second: FloatArray) -> BoolArray:
        states = (domain.Perform(gp_Pnt2d(*pair)) for pair in places(first, second))
        return np.array([state != TopAbs_State.TopAbs_OUT for state in states], dtype=bool)

    def foot(points: FloatArray) -> FloatArray:
        found = (feet.ValueOfUV(gp_Pnt(*point), _TOLERANCE) for point in points.tolist())
        return np.array([_xyz(surface.Value(place.X(), place.Y())) for place in found])

    trimmed = _is_trimmed(face, geometry, (*u, *v))
    border = _border(face) if trimmed else ()
    return ParametricSurface(evaluate, u, v, inside if trimmed else None, border, name, foot)


def _is_trimmed(face: cadquery.Face, geometry: Geom_Surface, ends: tuple[float, ...]) -> bool:
    import cadquery
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace

    whole = cadquery.Face(BRepBuilderAPI_MakeFace(geometry, *ends, _TOLERANCE).Face()).Area()
    return bool(abs(whole - face.Area()) > _SAME_AREA * whole)


def _border(face: cadquery.Face) -> tuple[FloatArray, ...]:
    """Closed polylines along the border, without seams, close to it."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepAdaptor import BRepAdaptor_Curve
    from OCP.GCPnts import GCPnts_QuasiUniformDeflection

    fine = _DEFLECTION * face.BoundingBox().DiagonalLength
    pieces = []
    for edge in face.Edges():
        if BRep_Tool.IsClosed_s(edge.wrapped, face.wrapped) or BRep_Tool.Degenerated_s(
            edge.wrapped
        ):
            continue
        made = GCPnts_QuasiUniformDeflection(BRepAdaptor_Curve(edge.wrapped), fine)
        pieces.append(np.array([_xyz(made.Value(k + 1)) for k in range(made.NbPoints())]))
    return closed_loops(pieces, 10 * fine)


def _xyz(point: Any) -> tuple[float, float, float]:
    return point.X(), point.Y(), point.Z()
