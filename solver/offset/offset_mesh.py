"""Offset meshes: parallel meshes at a constant distance of vertices, edges or faces.

A parallel mesh is ``v + d a`` with ``P (a_j - a_i) = 0`` for every edge (see
:mod:`solver.offset.parallelism`). Its distance from the mesh is constant

    at the vertices  where  |a_i| = 1         for circular meshes,
    at the edges     where  |P a_i| = 1       for meshes parallel to a Koebe mesh,
    at the faces     where  n_f . a_i = 1     for conical meshes.

Each condition is a function of one vertex, homogeneous of degree one: with ``g`` its gradient the
Gauss-Newton equation is ``g . a = 1``, a 3 x 3 block a vertex. Parallelism is a constraint, imposed
by the method of multipliers: each iteration minimises

    sum (g . a - 1)^2 + W |C a + m|^2 + small |a - a_before|^2,     then  m <- m + C a,

solved for the change of ``a``, so that rounding vanishes with it. So edges are parallel whatever
the net, as far as its faces are planar, and the distance is as even as the net allows: where it is
not constant, the difference is measured and reported.

Source: H. Pottmann, Y. Liu, J. Wallner, A. Bobenko, W. Wang, Geometry of multi-layer freeform
structures for architecture, 2007.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, refuse_other, unit_rows
from solver.offset.axes import torsion_free_axes
from solver.offset.parallelism import apply, edge_weights, factorised, projections
from solver.option import NOT_ZERO, number_within, one_of

# What is held constant, and the net that allows it.
KINDS = {
    "parallel": "net parallel to a Koebe net",
    "vertex": "circular net",
    "edge": "net parallel to a Koebe net",
    "face": "conical net",
}

# Pull to the iterate before: it decides what the distances leave open, and fades to let weakly
# determined parts converge.
_STAY, _FADE, _LEAST_STAY = 1e-2, 0.3, 1e-7
# Lean of the start at the boundary: upright there, an edge's distance can be on the ridge between
# two solutions, which Gauss-Newton does not leave.
_OUTWARD = 0.05
_STIFF = 1e5  # weight of parallelism; the multipliers do the rest
_ITERATIONS = 40  # at most; the pull is at its least after ten
_SETTLED = 1e-12  # change of the distances in an iteration
_LEAST_LEFT = 1e-3  # part of an edge's length that an offset must leave
_PARALLEL_DEG = 1e-4  # above it corresponding edges are said to be askew
_LEANING_DEG = 30.0  # lean worth saying
_EXACT = 1e-6  # part of the distance below which a miss is none

# Vertex of each distance (n,), and from offsets (V, 3) the distances (n,) and gradients (n, 3).
_Distances = tuple[IntArray, Callable[[FloatArray], tuple[FloatArray, FloatArray]]]


@dataclass(frozen=True, eq=False)
class OffsetMesh:
    """A parallel mesh and how well it keeps its distance; lengths in the model's unit.

    Attributes:
        mesh: the offset mesh, same connectivity.
        offsets: (V, 3) movement per unit distance.
        kind: what is held constant, a key of ``KINDS``.
        distance: that was asked for, negative for the other side.
        distances: (V,), (E,) or (F,) of each vertex, edge or face (parallel: edge), where an
            element has several the one that misses most; zero at vertices that no face uses.
        miss: (V,), (E,) or (F,) how far they are from ``abs(distance)``.
        askew_deg: (E,) angle between corresponding edges, zero for a parallel mesh.
        length_ratio: (E,) length of an edge of the offset mesh / of the mesh.
        lean_deg: (V,) angle between the offsets and the vertex normals.
    """

    mesh: QuadMesh
    offsets: FloatArray
    kind: str
    distance: float
    distances: FloatArray
    miss: FloatArray
    askew_deg: FloatArray
    length_ratio: FloatArray
    lean_deg: FloatArray

    @property
    def message(self) -> str:
        """One sentence: is the distance constant, else how far it misses, where, what to do."""
        element = "edge" if self.kind == "parallel" else self.kind
        worst, edge = int(np.argmax(self.miss)), int(np.argmax(self.askew_deg))
        miss, lean = float(self.miss[worst]), float(self.lean_deg.max())
        words = f"{element} distance {abs(self.distance):g}"
        if miss <= _EXACT * abs(self.distance):
            words += f" everywhere, within {miss:.1e}"
        else:
            words += f" misses by up to {miss:.3g} at {element} {worst}"
        if float(self.askew_deg[edge]) > _PARALLEL_DEG:
            turn = f"edges turn by up to {self.askew_deg[edge]:.2g} degrees, most edge {edge}"
            return f"not parallel: {turn}; {words}; optimise to planar faces first"
        if lean > _LEANING_DEG:
            words += f", leaning up to {lean:.0f} degrees from the normals"
        if miss > _EXACT * abs(self.distance):
            words += f"; a {KINDS[self.kind]} keeps it constant"
        return words


def offset_mesh(mesh: QuadMesh, distance: float, kind: str = "parallel") -> OffsetMesh:
    """Compute the parallel mesh whose distance is constant, or as even as the mesh allows.

    Args:
        mesh: planar faces for an exact result.
        distance: along the normals, in the model's unit; negative for the other side.
        kind: parallel (edges at an even distance by one linear solve), vertex, edge or face
            (distance constant by Gauss-Newton).

    Raises:
        InputError: an unknown kind, a distance that is zero or not finite, or so large that an edge
            of the offset mesh vanishes.
    """
    refuse_other(mesh)
    one_of("kind", kind, KINDS)
    number_within("distance", distance, NOT_ZERO)
    start, end = mesh.connectivity.edges.T
    edge = mesh.vertices[end] - mesh.vertices[start]
    _refuse_empty_edges(mesh)
    direction = unit_rows(edge)
    across = projections(direction)
    offsets = torsion_free_axes(mesh).offsets
    if kind != "parallel":
        if kind == "edge":
            offsets = offsets + _OUTWARD * _outward(mesh, direction)
        offsets = _evened(mesh, across, _conditions(mesh, across, kind), offsets)

    change = offsets[end] - offsets[start]
    along = np.einsum("ek,ek->e", change, direction) / mesh.edge_lengths
    _refuse_distance(mesh, distance, 1 + distance * along, along)
    moved = mesh.with_vertices(mesh.vertices + distance * offsets)
    new = edge + distance * change
    sine = np.linalg.norm(np.cross(direction, new), axis=1)
    askew = np.degrees(np.arctan2(sine, np.einsum("ek,ek->e", direction, new)))
    distances = abs(distance) * _measured(mesh, across, kind, offsets)
    miss = np.abs(distances - abs(distance))
    if kind == "vertex":
        miss = np.where(mesh.connectivity.referenced, miss, 0.0)
    ratio = moved.edge_lengths / mesh.edge_lengths
    sine = np.linalg.norm(np.cross(mesh.vertex_normals, offsets), axis=1)
    lean = np.arctan2(sine, np.einsum("vk,vk->v", mesh.vertex_normals, offsets))
    return OffsetMesh(
        moved, offsets, kind, distance, distances, miss, askew, ratio, np.degrees(lean)
    )


def _outward(mesh: QuadMesh, direction: FloatArray) -> FloatArray:
    """(V, 3) directions out of the mesh at its boundary, zero inside."""
    start, end = mesh.connectivity.edges.T
    inward = np.zeros_like(mesh.vertices)
    np.add.at(inward, start, direction)
    np.add.at(inward, end, -direction)
    return np.asarray(-unit_rows(inward) * mesh.connectivity.boundary_vertices[:, None])


def _conditions(mesh: QuadMesh, across: FloatArray, kind: str) -> _Distances:
    """Distances of a kind as functions of one vertex each."""
    net = mesh.connectivity
    if kind == "vertex":
        used = np.flatnonzero(net.referenced)
        return used, lambda a: _length(a[used], a[used])
    if kind == "edge":
        ends, both = net.edges.T.ravel(), np.concatenate([across, across])

        def from_edge(a: FloatArray) -> tuple[FloatArray, FloatArray]:
            beside = apply(both, a[ends])
            return _length(beside, beside)

        return ends, from_edge
    corners, normal = net.faces.ravel(), np.repeat(mesh.face_normals, 4, axis=0)
    return corners, lambda a: (np.einsum("nk,nk->n", normal, a[corners]), normal)


def _length(vectors: FloatArray, direction: FloatArray) -> tuple[FloatArray, FloatArray]:
    return np.linalg.norm(vectors, axis=1), unit_rows(direction)


def _evened(
    mesh: QuadMesh, across: FloatArray, conditions: _Distances, offsets: FloatArray
) -> FloatArray:
    """(V, 3) offsets with distances one in the sense of least squares, parallel throughout."""
    vertex, distances = conditions
    start, end = mesh.connectivity.edges.T
    coupling = np.minimum(edge_weights(mesh), _STIFF)[:, None, None] * across
    multiplier = np.zeros_like(mesh.vertices[start])
    for iteration in range(_ITERATIONS):
        distance, gradient = distances(offsets)
        stay = max(_STAY * _FADE**iteration, _LEAST_STAY)
        diagonal = np.tile(stay * np.eye(3), (len(offsets), 1, 1))
        np.add.at(diagonal, vertex, gradient[:, :, None] * gradient[:, None, :])
        right = np.zeros_like(offsets)
        np.add.at(right, vertex, (1 - distance)[:, None] * gradient)
        pull = apply(coupling, offsets[end] - offsets[start] + multiplier)
        np.add.at(right, start, pull)
        np.add.at(right, end, -pull)
        step = factorised(mesh, diagonal, coupling).solve(right.ravel()).reshape(-1, 3)
        offsets = offsets + step
        multiplier = multiplier + apply(across, offsets[end] - offsets[start])
        change = np.einsum("nk,nk->n", gradient, step[vertex])
        if float(np.abs(change).max()) <= _SETTLED:
            break
    return offsets


def _measured(mesh: QuadMesh, across: FloatArray, kind: str, offsets: FloatArray) -> FloatArray:
    """Distance of each vertex, edge or face for unit height: of its ends or corners the worst."""
    net = mesh.connectivity
    if kind == "vertex":
        return np.asarray(np.linalg.norm(offsets, axis=1))
    if kind == "face":
        each = np.einsum("fk,fck->fc", mesh.face_normals, offsets[net.faces])
    else:
        each = np.linalg.norm(np.einsum("eij,ecj->eci", across, offsets[net.edges]), axis=2)
    worst = np.abs(each - 1).argmax(axis=1)
    return np.asarray(np.take_along_axis(each, worst[:, None], axis=1)[:, 0])


def _refuse_empty_edges(mesh: QuadMesh) -> None:
    empty = mesh.edge_lengths <= 1e-9 * mesh.mean_edge
    if empty.any():
        edge = int(np.argmax(empty))
        first, second = mesh.connectivity.edges[edge]
        raise InputError(
            f"edges: {int(empty.sum())} have no length, the first is edge {edge} (vertices {first} "
            f"and {second}); remove or move its vertices"
        )


def _refuse_distance(mesh: QuadMesh, distance: float, ratio: FloatArray, along: FloatArray) -> None:
    """``ratio`` of the edges along themselves, ``along`` its change per unit distance."""
    edge = int(np.argmin(ratio))
    if ratio[edge] > _LEAST_LEFT:
        return
    first, second = mesh.connectivity.edges[edge]
    largest = float(((_LEAST_LEFT - 1) / np.minimum(along * np.sign(distance), -1e-300)).min())
    raise InputError(
        f"distance: {distance:g} folds the offset mesh at edge {edge} (vertices {first} and "
        f"{second}), where the axes meet before that; take less than {0.999 * largest:.3g}"
    )
