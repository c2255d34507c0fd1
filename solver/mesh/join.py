"""Meshes joined along seams whose vertices nearly meet."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial import cKDTree

from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.intake import quad_mesh
from solver.mesh.merge import merged
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Vertices of two meshes are one where they are mutually nearest within this part of an edge.
_REACH = 0.35


def joined(meshes: Sequence[QuadMesh], sizes: Sequence[float]) -> tuple[QuadMesh, int]:
    """One mesh of several whose border vertices nearly meet, orientation made consistent.

    Border vertices of different meshes become one where each is the other's nearest within a third
    of the shorter border edge there; it lies where the earlier one has it.

    Args:
        meshes: at least two meshes.
        sizes: of the meshes, in the model's unit; vertices that meet at the thousandth of it
            always become one.

    Returns:
        The mesh, and how many border vertices lie near another mesh without being joined.

    Raises:
        InputError: a face that collapses, or edges with more than two faces.
    """
    offsets = np.cumsum([0] + [len(one.vertices) for one in meshes])
    points = np.concatenate([one.vertices for one in meshes])
    borders = [np.flatnonzero(one.connectivity.boundary_vertices) for one in meshes]
    reach = np.concatenate([_shortest_border_edges(one) for one in meshes])
    pairs, near = [], np.zeros(len(points), dtype=bool)
    for a in range(len(meshes)):
        for b in range(a + 1, len(meshes)):
            one, two = borders[a] + offsets[a], borders[b] + offsets[b]
            if not (len(one) and len(two)):
                continue
            least = 1e-3 * min(sizes[a], sizes[b])
            pairs.append(_mutual(points, one, two, reach, least))
            near |= _beside(points, one, two, reach)
    links = np.concatenate(pairs) if pairs else np.zeros((0, 2), dtype=np.int64)
    kept, number = merged(links, len(points))
    faces = np.concatenate([p.faces + o for p, o in zip(meshes, offsets, strict=False)])
    mesh = quad_mesh(points[kept], number[faces].tolist())[0]
    met = np.zeros(len(points), dtype=bool)
    met[links.ravel()] = True
    return mesh, int((near & ~met).sum())


def _shortest_border_edges(mesh: QuadMesh) -> FloatArray:
    """(V,) length of the shorter border edge at each border vertex, infinite elsewhere."""
    net = mesh.connectivity
    rim = net.edges[net.boundary_edges]
    lengths = np.linalg.norm(mesh.vertices[rim[:, 1]] - mesh.vertices[rim[:, 0]], axis=1)
    shortest = np.full(len(mesh.vertices), np.inf)
    for end in (0, 1):
        np.minimum.at(shortest, rim[:, end], lengths)
    return shortest


def _mutual(
    points: FloatArray, one: IntArray, two: IntArray, reach: FloatArray, least: float
) -> IntArray:
    """(K, 2) vertices that are each other's nearest and near enough."""
    there, back = cKDTree(points[two]), cKDTree(points[one])
    apart, forth = there.query(points[one])
    return_way = back.query(points[two])[1]
    mutual = return_way[forth] == np.arange(len(one))
    limit = np.maximum(_REACH * np.minimum(reach[one], reach[two[forth]]), least)
    limit = np.minimum(limit, 0.49 * np.minimum(reach[one], reach[two[forth]]))
    good = mutual & (apart <= limit)
    return np.stack([one[good], two[forth[good]]], axis=1)


def _beside(points: FloatArray, one: IntArray, two: IntArray, reach: FloatArray) -> BoolArray:
    """(V,) vertices of each side within half an edge of a vertex of the other."""
    flags = np.zeros(len(points), dtype=bool)
    for these, those in ((one, two), (two, one)):
        apart = cKDTree(points[those]).query(points[these])[0]
        flags[these[apart < 0.5 * reach[these]]] = True
    return flags
