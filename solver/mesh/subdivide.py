"""Finer meshes whose parameter lines contain the old ones."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array

from solver.errors import InputError
from solver.mesh.connectivity import Connectivity, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.option import Option, Range

LEVELS = Option("levels", 1, "count", "So many times four faces are made of one", within=Range(1))
# More is a slip of the hand, and would fill the memory.
_MOST_FACES = 4_000_000


def subdivided(mesh: QuadMesh, levels: int = 1) -> QuadMesh:
    """Split each face in four at its edge midpoints and the mean of its corners.

    Old vertices keep number and place; then come the edges' midpoints, then the faces'. Old face f
    becomes faces 4 f to 4 f + 3, one a corner, each starting so that u and v stay u and v.

    Raises:
        InputError: levels below 1, or so many that the mesh gets too large.
    """
    for _ in range(_levels(mesh, levels)):
        middles = mesh.vertices[mesh.connectivity.edges].mean(axis=1)
        centres = mesh.vertices[mesh.faces].mean(axis=1)
        mesh = QuadMesh(
            np.concatenate([mesh.vertices, middles, centres]), _faces(mesh.connectivity)
        )
    return mesh


def catmull_clark(mesh: QuadMesh, levels: int = 1) -> QuadMesh:
    """Catmull-Clark subdivision, numbered as by :func:`subdivided`.

    Boundaries follow cubic B-splines, which depend on the boundary alone; corners stay.

    Source: Catmull, Clark (1978), Recursively generated B-spline surfaces on arbitrary topological
    meshes.

    Raises:
        InputError: levels below 1, or so many that the mesh gets too large.
    """
    for _ in range(_levels(mesh, levels)):
        net, points = mesh.connectivity, mesh.vertices
        centres = points[mesh.faces].mean(axis=1)
        middles = points[net.edges].mean(axis=1)
        left, right = net.edge_faces.T
        smooth = 0.5 * (middles + 0.5 * (centres[left] + centres[right]))
        edge_points = np.where(net.boundary_edges[:, None], middles, smooth)
        vertices = np.concatenate([_vertex_points(mesh, centres, middles), edge_points, centres])
        mesh = QuadMesh(vertices, _faces(net))
    return mesh


def _levels(mesh: QuadMesh, levels: int) -> int:
    LEVELS.check(levels)
    if len(mesh.faces) * 4.0**levels > _MOST_FACES:
        raise InputError(
            f"levels: {levels} would give {len(mesh.faces) * 4.0**levels:.3g} faces, more than "
            f"{_MOST_FACES}; take fewer"
        )
    return levels


def _faces(net: Connectivity) -> IntArray:
    edges, count = net.face_edges + net.vertex_count, len(net.faces)
    centre = net.vertex_count + len(net.edges) + np.arange(count)
    corner = net.faces
    quads = [
        np.stack([corner[:, 0], edges[:, 0], centre, edges[:, 3]], axis=1),
        np.stack([edges[:, 0], corner[:, 1], edges[:, 1], centre], axis=1),
        np.stack([centre, edges[:, 1], corner[:, 2], edges[:, 2]], axis=1),
        np.stack([edges[:, 3], centre, edges[:, 2], corner[:, 3]], axis=1),
    ]
    return np.stack(quads, axis=1).reshape(-1, 4)


def _vertex_points(mesh: QuadMesh, centres: FloatArray, middles: FloatArray) -> FloatArray:
    net, points = mesh.connectivity, mesh.vertices
    valence = np.maximum(net.face_valence, 1)[:, None].astype(np.float64)
    face_mean = _sums(mesh.faces, centres, len(points)) / valence
    edge_mean = _sums(net.edges, middles, len(points)) / np.maximum(net.edge_valence, 1)[:, None]
    inner = (face_mean + 2 * edge_mean + (valence - 3) * points) / valence
    rim = net.edges[net.boundary_edges]
    rim_mean = _sums(rim, middles[net.boundary_edges], len(points)) / 2
    boundary, corner = net.boundary_vertices[:, None], net.corners[:, None]
    result = np.where(boundary, 0.5 * (points + rim_mean), inner)
    return np.where(corner | ~net.referenced[:, None], points, result)


def _sums(groups: IntArray, values: FloatArray, count: int) -> FloatArray:
    """(count, 3) sum over all groups of the group's value, at each vertex of the group."""
    size = groups.shape[1]
    shape = (count, len(groups))
    entries = (np.ones(groups.size), (groups.ravel(), np.repeat(np.arange(len(groups)), size)))
    return np.asarray(coo_array(entries, shape=shape).tocsr() @ values)
