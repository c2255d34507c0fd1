"""Where vertices may go: handles, gliding, a surface to stay near, symmetry."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from scipy.spatial import cKDTree

from solver.errors import InputError
from solver.mesh.closest import Polyline, TriangleSurface
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.problem import Problem
from solver.terms.gliding import Mirrored, OnCurve, OnPlane, OnSurface
from solver.terms.pull import Pull

_AXES = "xyz"
# Boundary vertices nearer than this to a plane or curve, in mean edges, glide on it.
_NEAR = 0.5
# Mirror images are told from strangers up to this many mean edges.
_TWIN = 0.25


@dataclass(frozen=True)
class PlaneGlide:
    """Vertices on the plane where a coordinate has a value, in model units."""

    axis: int
    place: float
    vertices: IntArray | None = None

    def about(self, origin: LocalOrigin) -> PlaneGlide:
        """The same plane in coordinates about a local origin."""
        return replace(self, place=float(self.place - origin.shift[self.axis]))


@dataclass(frozen=True)
class CurveGlide:
    """Vertices on a polyline given by (m, 3) points in model units."""

    points: FloatArray
    closed: bool = False
    vertices: IntArray | None = None

    def about(self, origin: LocalOrigin) -> CurveGlide:
        """The same curve in coordinates about a local origin."""
        return replace(self, points=origin.near(self.points))


@dataclass(frozen=True)
class SurfaceGlide:
    """Vertices on a triangle surface in model units; all of them where none are named."""

    points: FloatArray
    triangles: IntArray
    vertices: IntArray | None = None

    def about(self, origin: LocalOrigin) -> SurfaceGlide:
        """The same surface in coordinates about a local origin."""
        return replace(self, points=origin.near(self.points))


@dataclass(frozen=True)
class BoundaryGlide:
    """Boundary vertices on their own start curve; corners stay."""

    def about(self, origin: LocalOrigin) -> BoundaryGlide:
        """The same: it goes wherever the mesh goes."""
        return self


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

    @cached_property
    def ground(self) -> TriangleSurface | None:
        """The surface to stay near, which answers where its closest points are; made once."""
        return None if self.close_to is None else TriangleSurface(*self.close_to)

    def about(self, origin: LocalOrigin) -> Constraints:
        """The same in coordinates about a local origin.

        Raises:
            InputError: the mesh is far from a plane of its symmetry.
        """
        if not origin.far:
            return self
        for word in self.symmetry:
            if word in _AXES and origin.shift[_AXES.index(word)]:
                raise InputError(
                    f"symmetry: the mesh is far from the plane {word}=0, so that no vertex has a "
                    "mirror image; centre the mesh there or leave the symmetry out"
                )
        near = None
        if self.close_to is not None:
            points, triangles = self.close_to
            near = origin.near(points), triangles
        return replace(
            self,
            handles={
                vertex: origin.near(np.asarray(target, dtype=np.float64))
                for vertex, target in self.handles.items()
            },
            glide=tuple(glide.about(origin) for glide in self.glide),
            close_to=near,
        )


def add_constraints(problem: Problem, wanted: Constraints, closeness: float) -> Problem:
    """Add the terms of all constraints to a problem.

    Raises:
        InputError: a vertex that does not exist, nothing to glide, no mirror image.
    """
    _add_handles(problem, wanted.handles)
    for glide in wanted.glide:
        _add_glide(problem, glide)
    if wanted.ground is not None:
        surface = wanted.ground.scaled(problem.centre, problem.scale)
        used = np.flatnonzero(problem.mesh.connectivity.referenced)
        weight = problem.tuning.close_to * closeness
        problem.guide(OnSurface(used, surface, name="close to surface"), weight)
    for word in wanted.symmetry:
        if word not in _AXES:
            raise InputError(f"symmetry: expected letters out of x, y, z, got '{word}'")
        _add_symmetry(problem, _AXES.index(word))
    return problem


def settled(mesh: QuadMesh, fixed: BoolArray, wanted: Constraints) -> Constraints:
    """Settle by the start what glides where.

    A net that is reached through an easier one is posed from other shapes on the way, whose
    boundary is no longer the curve that was asked for.

    Raises:
        InputError: a vertex that does not exist, nothing to glide.
    """
    glide = [one for each in wanted.glide for one in _settled(mesh, fixed, each)]
    return replace(wanted, glide=tuple(glide))


def corners_that_stay(mesh: QuadMesh, wanted: Constraints) -> IntArray:
    """Corners of a boundary that glides on its own start curve: they would round it off."""
    if any(isinstance(glide, BoundaryGlide) for glide in wanted.glide):
        return np.flatnonzero(mesh.connectivity.corners)
    return np.zeros(0, dtype=np.int64)


def on_curves(mesh: QuadMesh, wanted: Constraints) -> BoolArray:
    """(V,) true for vertices that glide along a curve; ``wanted`` is settled."""
    found = np.zeros(len(mesh.vertices), dtype=bool)
    for glide in wanted.glide:
        if isinstance(glide, CurveGlide):
            found[glide.vertices] = True
    return found


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
        problem.guide(Pull(vertices, begin, goals=targets), problem.tuning.handles)


def _add_glide(problem: Problem, glide: Glide) -> None:
    if isinstance(glide, BoundaryGlide) or glide.vertices is None:
        for one in _settled(problem.mesh, problem.fixed, glide):
            _add_glide(problem, one)
        return
    term: OnPlane | OnCurve | OnSurface
    if isinstance(glide, PlaneGlide):
        place = float((glide.place - problem.centre[glide.axis]) / problem.scale)
        term = OnPlane(glide.vertices, np.eye(3)[glide.axis], place)
    elif isinstance(glide, CurveGlide):
        curve = Polyline(_to_solver(problem, glide.points), closed=glide.closed)
        term = OnCurve(glide.vertices, curve)
    else:
        surface = TriangleSurface(_to_solver(problem, glide.points), glide.triangles)
        term = OnSurface(glide.vertices, surface)
    problem.require(term)


def _settled(mesh: QuadMesh, fixed: BoolArray, glide: Glide) -> list[Glide]:
    """The same with its vertices named, one for each loop of a boundary."""
    net = mesh.connectivity
    if isinstance(glide, BoundaryGlide):
        return [
            CurveGlide(mesh.vertices[loop], closed=True, vertices=loop[~fixed[loop]])
            for loop in net.boundary_loops
        ]
    if glide.vertices is not None:
        strangers = glide.vertices[(glide.vertices < 0) | (glide.vertices >= len(fixed))]
        if len(strangers):
            raise InputError(
                f"glide: vertex {strangers[0]} does not exist; vertices are numbered 0 to "
                f"{len(fixed) - 1}"
            )
        return [glide]
    chosen = net.referenced & ~fixed
    if not isinstance(glide, SurfaceGlide):
        if isinstance(glide, PlaneGlide):
            miss = np.abs(mesh.vertices[:, glide.axis] - glide.place)
            what = f"plane {_AXES[glide.axis]}={glide.place:g}"
        else:
            feet, _ = Polyline(glide.points, closed=glide.closed).closest(mesh.vertices)
            miss, what = np.linalg.norm(mesh.vertices - feet, axis=1), "curve"
        chosen &= net.boundary_vertices & (miss <= _NEAR * mesh.mean_edge)
        if not chosen.any():
            raise InputError(
                f"glide: no free boundary vertex lies within half a mean edge of the {what}; "
                "move the mesh there or name the vertices"
            )
    return [replace(glide, vertices=np.flatnonzero(chosen))]


def _add_symmetry(problem: Problem, axis: int) -> None:
    points = problem.mesh.vertices
    used = np.flatnonzero(problem.mesh.connectivity.referenced)
    image = points[used].copy()
    image[:, axis] *= -1.0
    distance, twin = cKDTree(points[used]).query(image)
    # Where vertices lie close, one may be the nearest of two images.
    alone = np.where(twin[twin] == np.arange(len(used)), distance, np.inf)
    if alone.max() > _TWIN * problem.scale:
        raise InputError(
            f"symmetry: vertex {used[np.argmax(alone)]} has no mirror image in the plane "
            f"{_AXES[axis]}=0; centre the mesh there or leave the symmetry out"
        )
    twin = used[twin]
    place = float(-problem.centre[axis] / problem.scale)
    pairs = np.stack([used, twin], axis=1)[used < twin]
    if len(pairs):
        problem.require(Mirrored(pairs, axis, place))
    middle = used[used == twin]
    if len(middle):
        term = OnPlane(middle, np.eye(3)[axis], place, name="symmetry")
        problem.require(term)


def _to_solver(problem: Problem, points: FloatArray) -> FloatArray:
    return np.asarray((np.asarray(points, dtype=np.float64) - problem.centre) / problem.scale)
