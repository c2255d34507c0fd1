"""Vertices of quads spread out over a face whose sides are given.

In a plane each vertex inside is the mean of its neighbours, so that nothing folds where the face is
convex. Where the quads are no grid, edges pull the more the longer they are: that evens them out.

Source: Tutte (1963), How to draw a graph.
"""

from __future__ import annotations

import numpy as np
from scipy.interpolate import LinearNDInterpolator
from scipy.sparse import coo_array, csr_array, diags_array
from scipy.sparse.linalg import spsolve

from solver.align.triangle_mesh import TriangleMesh
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# How often edges are made more even: the sum of the cubes of their lengths falls.
_EVENED = 15
# How often vertices on a face that is not flat move along it, half way to where edges pull them.
_ROUNDS = 20
# A face is flat whose points are no farther off its plane, in edges.
_FLAT = 1e-6


def spread(
    mesh: TriangleMesh,
    triangles: IntArray,
    places: FloatArray,
    free: BoolArray,
    quads: IntArray,
    edge: float,
    evened: bool,
) -> FloatArray:
    """Where the vertices inside a face are to be.

    Args:
        mesh: the surface.
        triangles: of the face.
        places: (N, 3) vertices of its quads; those that are free may be anything.
        free: (N,) which are inside.
        quads: (F, 4) numbers of these vertices.
        edge: wanted edge length.
        evened: whether longer edges pull more.

    Returns:
        (N, 3) vertices.
    """
    used, numbers = np.unique(mesh.triangles[triangles], return_inverse=True)
    points = mesh.points[used]
    middle = points.mean(axis=0)
    normal = (mesh.normals[triangles] * mesh.areas[triangles, None]).sum(axis=0)
    axes = np.linalg.svd(normal[None])[2]
    edges = _edges(quads)
    flat = _in_plane((places - middle) @ axes[1:].T, free, edges, evened)
    found = places.copy()
    found[free] = middle + flat[free] @ axes[1:]
    heights = (points - middle) @ axes[0]
    if np.abs(heights).max() > _FLAT * edge:
        own = TriangleSurface(points, numbers.reshape(-1, 3))
        lift = LinearNDInterpolator((points - middle) @ axes[1:].T, heights, 0.0)
        found[free] += lift(flat[free])[:, None] * axes[0]
        for _ in range(_ROUNDS):
            pull = _pull(edges, _weights(found, edges, evened), len(found))
            found[free] -= (0.5 * (pull @ found) / pull.diagonal()[:, None])[free]
            found[free] = own.closest(found[free])[0]
    return found


def _in_plane(places: FloatArray, free: BoolArray, edges: IntArray, evened: bool) -> FloatArray:
    found = places.copy()
    weights = np.ones(len(edges))
    for _ in range(_EVENED if evened else 1):
        pull = _pull(edges, weights, len(found))[free]
        right = -(pull[:, ~free] @ found[~free])
        found[free] = spsolve(pull[:, free].tocsc(), right).reshape(-1, 2)
        weights = _weights(found, edges, evened)
    return found


def _weights(places: FloatArray, edges: IntArray, evened: bool) -> FloatArray:
    if not evened:
        return np.ones(len(edges))
    lengths: FloatArray = np.linalg.norm(places[edges[:, 0]] - places[edges[:, 1]], axis=1)
    return lengths


def _edges(quads: IntArray) -> IntArray:
    """(E, 2) the edges of quads."""
    pairs = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2)
    found: IntArray = np.unique(np.sort(pairs, axis=1), axis=0)
    return found


def _pull(edges: IntArray, weights: FloatArray, count: int) -> csr_array:
    """(count, count) matrix of springs with weights along edges."""
    one, two = edges.T
    row, column = np.concatenate([one, two]), np.concatenate([two, one])
    springs = coo_array((np.tile(weights, 2), (row, column)), shape=(count, count))
    return csr_array(diags_array(springs.sum(axis=1)) - springs)
