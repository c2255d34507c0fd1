"""Where vertices may go: handles, gliding, a surface to stay near, symmetry."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from scipy.spatial import cKDTree

from solver.errors import InputError
from solver.mesh.closest import Polyline, TriangleSurface
from solver.mesh.connectivity import Connectivity, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.problem import Problem
from solver.terms.gliding import Mirrored, OnCurve, OnPlane, OnSurface
from solver.terms.pull import Pull

_AXES = "xyz"
# Boundary vertices nearer than this to a plane or curve, in mean edges, glide on it.
_NEAR = 0.5
# Mirror images are told from strangers up to this many mean edges.
_TWIN = 0.25
_HANDLE_WEIGHT = 10.0


@dataclass(frozen=True)
class PlaneGlide:
    """Vertices on the plane where a coordinate has a value, in model units."""

    axis: int
    place: float
    vertices: IntArray | None = None


@dataclass(frozen=True)
class CurveGlide:
    """Vertices on a polyline given by (m, 3) points in model units."""

    points: FloatArray
    closed: bool = False
    vertices: IntArray | None = None


@dataclass(frozen=True)
class SurfaceGlide:
    """Vertices on a triangle surface in model units; all of them where none are named."""

    points: FloatArray
    triangles: IntArray
    vertices: IntArray | None = None


@dataclass(frozen=True)
class BoundaryGlide:
    """Boundary vertices on their own start curve; corners stay."""


Glide = PlaneGlide | CurveGlide | SurfaceGlide | BoundaryGlide


@dataclass(frozen=True)
class Constraints:
    """Where vertices may go besides those that are fixed.

    Attributes:
        handles: target position of some vertices, in model units; soft.
        glide: what vertices glide on; exact.
        close_to: points and triangles of a surface that guides the way, in model units; soft.
        symmetry: coordinate planes, any of ``x``, ``y``, ``z``; exact.
    """

    handles: Mapping[int, FloatArray] = field(default_factory=dict)
    glide: tuple[Glide, ...] = ()
    close_to: tuple[FloatArray, IntArray] | None = None
    symmetry: str = ""


def add_constraints(problem: Problem, wanted: Constraints, closeness: float) -> Problem:
    """Add the terms of all constraints to a problem.

    Raises:
        InputError: a vertex that does not exist, nothing to glide, no mirror image.
    """
    _add_handles(problem, wanted.handles)
    for glide in wanted.glide:
        _add_glide(problem, glide)
    if wanted.close_to is not None:
        points, triangles = wanted.close_to
        surface = TriangleSurface(_to_solver(problem, points), triangles)
        used = np.flatnonzero(problem.mesh.connectivity.referenced)
        problem.guide(OnSurface(used, surface, name="close to surface"), 30 * closeness)
    for word in wanted.symmetry:
        if word not in _AXES:
            raise InputError(f"symmetry: expected letters out of x, y, z, got '{word}'")
        _add_symmetry(problem, _AXES.index(word))
    return problem


def corners_that_stay(mesh: QuadMesh, wanted: Constraints) -> IntArray:
    """Corners of a boundary that glides on its own start curve: they would round it off."""
    if any(isinstance(glide, BoundaryGlide) for glide in wanted.glide):
        return np.flatnonzero(mesh.connectivity.corners)
    return np.zeros(0, dtype=np.int64)


def _add_handles(problem: Problem, handles: Mapping[int, FloatArray]) -> None:
    count = problem.mesh.connectivity.vertex_count
    for vertex, target in handles.items():
        if not 0 <= vertex < count:
            raise InputError(
                f"handle: vertex {vertex} does not exist; vertices are numbered 0 to {count - 1}"
            )
        if problem.fixed[vertex]:
            raise InputError(
                f"handle: vertex {vertex} is fixed too; either fix it or drag it, not both"
            )
        if not np.isfinite(target).all():
            raise InputError(f"handle: the target of vertex {vertex} is not finite; mend it")
    if handles:
        targets = _to_solver(problem, np.array(list(handles.values()), dtype=np.float64))
        vertices = np.array(list(handles), dtype=np.int64)
        begin = _to_solver(problem, problem.mesh.vertices[vertices])
        problem.guide(Pull(vertices, begin, goals=targets), _HANDLE_WEIGHT)


def _add_glide(problem: Problem, glide: Glide) -> None:
    if isinstance(glide, BoundaryGlide):
        for loop in boundary_loops(problem.mesh.connectivity):
            curve = Polyline(_to_solver(problem, problem.mesh.vertices[loop]), closed=True)
            chosen = loop[~problem.fixed[loop]]
            problem.require(OnCurve(chosen, curve), problem.own_residual("glide"))
        return
    if isinstance(glide, PlaneGlide):
        normal = np.eye(3)[glide.axis]
        place = float((glide.place - problem.centre[glide.axis]) / problem.scale)
        miss = problem.mesh.vertices[:, glide.axis] - glide.place
        chosen = _chosen(
            problem, glide.vertices, miss, f"plane {_AXES[glide.axis]}={glide.place:g}"
        )
        problem.require(OnPlane(chosen, normal, place), problem.own_residual("glide"))
    elif isinstance(glide, CurveGlide):
        curve = Polyline(_to_solver(problem, glide.points), closed=glide.closed)
        feet, _ = Polyline(glide.points, closed=glide.closed).closest(problem.mesh.vertices)
        miss = np.linalg.norm(problem.mesh.vertices - feet, axis=1)
        chosen = _chosen(problem, glide.vertices, miss, "curve")
        problem.require(OnCurve(chosen, curve), problem.own_residual("glide"))
    else:
        surface = TriangleSurface(_to_solver(problem, glide.points), glide.triangles)
        used = problem.mesh.connectivity.referenced & ~problem.fixed
        chosen = np.flatnonzero(used) if glide.vertices is None else glide.vertices
        problem.require(OnSurface(chosen, surface), problem.own_residual("glide"))


def _chosen(problem: Problem, named: IntArray | None, miss: FloatArray, what: str) -> IntArray:
    """Vertices that were named, or free boundary vertices near the guide."""
    if named is not None:
        count = len(problem.mesh.vertices)
        if len(named) and (named.min() < 0 or named.max() >= count):
            raise InputError(f"glide: vertices are numbered 0 to {count - 1}, got {named.max()}")
        return named
    rim = problem.mesh.connectivity.boundary_vertices & ~problem.fixed
    near = rim & (np.abs(miss) <= _NEAR * problem.scale)
    if not near.any():
        raise InputError(
            f"glide: no free boundary vertex lies within half a mean edge of the {what}; "
            "move the mesh there or name the vertices"
        )
    return np.flatnonzero(near)


def _add_symmetry(problem: Problem, axis: int) -> None:
    points = problem.mesh.vertices
    used = np.flatnonzero(problem.mesh.connectivity.referenced)
    image = points[used].copy()
    image[:, axis] *= -1.0
    distance, twin = cKDTree(points[used]).query(image)
    if (distance > _TWIN * problem.scale).any():
        worst = int(used[np.argmax(distance)])
        raise InputError(
            f"symmetry: vertex {worst} has no mirror image in the plane {_AXES[axis]}=0; "
            "centre the mesh there or leave the symmetry out"
        )
    twin = used[twin]
    place = float(-problem.centre[axis] / problem.scale)
    pairs = np.stack([used, twin], axis=1)[used < twin]
    if len(pairs):
        problem.require(Mirrored(pairs, axis, place), problem.own_residual("symmetry"))
    middle = used[used == twin]
    if len(middle):
        term = OnPlane(middle, np.eye(3)[axis], place, name="symmetry")
        problem.require(term, problem.own_residual("symmetry"))


def boundary_loops(net: Connectivity) -> list[IntArray]:
    """Vertices of each boundary loop, in order."""
    half = np.flatnonzero(net.twins < 0)
    start = net.faces.ravel()[half]
    end = np.roll(net.faces, -1, axis=1).ravel()[half]
    after = dict(zip(start.tolist(), end.tolist(), strict=True))
    loops = []
    while after:
        first, vertex = next(iter(after.items()))
        loop = [first]
        del after[first]
        while vertex != first:
            loop.append(vertex)
            vertex = after.pop(vertex)
        loops.append(np.array(loop, dtype=np.int64))
    return loops


def _to_solver(problem: Problem, points: FloatArray) -> FloatArray:
    return (np.asarray(points, dtype=np.float64) - problem.centre) / problem.scale
