"""Exactly torsion-free axes: the offset directions of a parallel mesh.

Two meshes of the same connectivity are parallel when corresponding edges are. If ``v + h a`` is
parallel to ``v``, then for every edge ``a_j - a_i`` is a multiple of the edge direction ``u``, so
the two axes and the edge lie in one plane: the beam along the edge is a planar plate.

The mathematics. With ``P = 1 - u u^T`` the projection along an edge and ``n`` the edge normal (the
mean of its faces' normals, made perpendicular to ``u``), we look for vectors ``a`` that

    minimise    sum over edges  |P a_i - n|^2 + |P a_j - n|^2      subject to    P (a_j - a_i) = 0.

``|P a|`` is the distance between an edge and its parallel copy, the height of the beam: the target
asks for height one and for beams upright on the surface at once, which the distance to the vertex
normals does not. The constraints ``C a = 0`` are redundant (4 equations a vertex, yet a planar grid
leaves about one freedom a parameter line), and on a mesh that is planar to 1e-10 only, the wanted
offsets are singular vectors of ``C`` with values near 1e-10, not 0. So the constraints are not
eliminated but filtered. With ``H`` the matrix of the target and ``W`` a large weight, one pass

    a <- (H + W C^T C)^-1 H a

divides each singular part of ``C a`` by ``1 + W s^2``: singular values well above ``1 / sqrt(W)``
vanish to rounding in two or three passes of one factorisation, those well below stay. Where faces
are not planar, a hard constraint would leave nothing but translations and scalings; the
weight of their edges falls to ``0.01 / planarity^2``, and the twist that is left is reported.
Everything is free of the model's unit.

Source: H. Pottmann, Y. Liu, J. Wallner, A. Bobenko, W. Wang, Geometry of multi-layer freeform
structures for architecture, 2007 (parallel meshes as torsion-free supports).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.offset.parallelism import apply, edge_weights, factorised, projections

_NORMAL = 1e-3  # pull to the vertex normal, decides what the edges leave open
_PASSES = 10  # at most; one that does not halve the residual is the last
_CLOSED = 1e-14  # constraint residual at which more passes gain nothing


@dataclass(frozen=True, eq=False)
class Axes:
    """Axes at the vertices and how well the beams between them fit.

    Attributes:
        offsets: (V, 3) offset per unit height; ``vertices + h * offsets`` is the parallel mesh at
            height ``h``. Zero at vertices that no face uses.
        directions: (V, 3) the offsets as unit vectors.
        twist: (E,) ``abs(det(a_i, a_j, u_ij))`` of the unit axes, dimensionless.
        heights: (E,) distance between an edge and its parallel copy per unit height, mean one.
        lean_deg: (V,) angle between axis and vertex normal, degrees.
    """

    offsets: FloatArray
    directions: FloatArray
    twist: FloatArray
    heights: FloatArray
    lean_deg: FloatArray


def torsion_free_axes(mesh: QuadMesh) -> Axes:
    """Compute the torsion-free axes nearest to the normals, one scale a component.

    Args:
        mesh: any quad mesh; the twist vanishes as far as its faces are planar.

    Returns:
        The axes; nothing is raised for meshes that are not planar, see ``Axes.twist``.
    """
    connectivity = mesh.connectivity
    start, end = connectivity.edges.T
    direction = unit_rows(mesh.vertices[end] - mesh.vertices[start])
    across = projections(direction)
    offsets = _filtered(mesh, across, _edge_normals(mesh, across))

    heights = np.linalg.norm(apply(across, offsets[start] + offsets[end]), axis=1) / 2
    component = _vertex_components(mesh)
    mean = _mean_by_label(heights, component[start], int(component.max()) + 1)
    offsets = offsets / mean[component][:, None]
    heights = heights / mean[component[start]]

    unit = unit_rows(offsets)
    twist = np.abs(np.einsum("ek,ek->e", unit[start], np.cross(unit[end], direction)))
    normal = mesh.vertex_normals
    sine = np.linalg.norm(np.cross(normal, unit), axis=1)
    cosine = np.einsum("vk,vk->v", normal, unit)
    return Axes(offsets, unit, twist, heights, np.degrees(np.arctan2(sine, cosine)))


def _edge_normals(mesh: QuadMesh, across: FloatArray) -> FloatArray:
    """(E, 3) mean unit normal of the faces at each edge, perpendicular to it."""
    faces = mesh.connectivity.edge_faces
    of_faces = np.vstack([mesh.face_normals, np.zeros((1, 3))])  # index -1: no face
    return np.asarray(unit_rows(apply(across, of_faces[faces[:, 0]] + of_faces[faces[:, 1]])))


def _filtered(mesh: QuadMesh, across: FloatArray, normals: FloatArray) -> FloatArray:
    """(V, 3) least-squares offsets with the constraints filtered in, not yet scaled."""
    count = len(mesh.vertices)
    start, end = mesh.connectivity.edges.T
    pull = np.where(mesh.connectivity.referenced, _NORMAL, 1.0)
    diagonal = np.eye(3) * pull[:, None, None]
    for ends in (start, end):
        np.add.at(diagonal, ends, across)
    factors = factorised(mesh, diagonal, edge_weights(mesh)[:, None, None] * across)

    right = mesh.vertex_normals * np.where(mesh.connectivity.referenced, _NORMAL, 0.0)[:, None]
    for ends in (start, end):
        np.add.at(right, ends, normals)
    offsets = factors.solve(right.ravel()).reshape(count, 3)
    residual = np.inf
    for _ in range(_PASSES):
        opening = apply(across, offsets[end] - offsets[start])
        largest = max(float(np.abs(offsets).max()), np.finfo(float).tiny)
        previous, residual = residual, float(np.abs(opening).max()) / largest
        if residual <= _CLOSED or residual > previous / 2:
            break
        offsets = factors.solve(apply(diagonal, offsets).ravel()).reshape(count, 3)
    return np.asarray(offsets)


def _vertex_components(mesh: QuadMesh) -> IntArray:
    """(V,) number of the component that the edges connect each vertex to."""
    count = len(mesh.vertices)
    start, end = mesh.connectivity.edges.T
    graph = coo_array((np.ones(len(start)), (start, end)), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)


def _mean_by_label(values: FloatArray, label: IntArray, labels: int) -> FloatArray:
    """(labels,) mean of the values of each label, one where there are none or all are zero."""
    total = np.bincount(label, weights=values, minlength=labels)
    mean = total / np.maximum(np.bincount(label, minlength=labels), 1)
    return np.where(mean > 0, mean, 1.0)
