"""Sides and corners of triangles: their mean normals, and which of them are on the border."""

from __future__ import annotations

import numpy as np

from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, unit_rows


def pseudo_normals(
    corners: FloatArray, triangles: IntArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """(T, 3) unit normals of faces, (T, 3, 3) of their sides, (V, 3) of vertices.

    Source: Baerentzen, Aanaes (2005), Signed distance computation using the angle weighted
    pseudonormal.
    """
    normals = unit_rows(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    pairs = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2), axis=2)
    edges, which = np.unique(pairs.reshape(-1, 2), axis=0, return_inverse=True)
    of_edges = _sums(which.ravel(), np.repeat(normals, 3, axis=0), len(edges))
    sides = unit_rows(np.roll(corners, -1, axis=1) - corners)
    cosine = -np.einsum("tki,tki->tk", sides, np.roll(sides, 1, axis=1))
    angle = np.arccos(np.clip(cosine, -1, 1))
    weighted = (angle[..., None] * normals[:, None]).reshape(-1, 3)
    of_vertices = _sums(triangles.ravel(), weighted, int(triangles.max()) + 1)
    return normals, of_edges[which.ravel()].reshape(-1, 3, 3), of_vertices


def _sums(places: IntArray, vectors: FloatArray, count: int) -> FloatArray:
    """(count, 3) unit vectors along the sums of the vectors of each place."""
    total = [np.bincount(places, vectors[:, k], count) for k in range(3)]
    return unit_rows(np.stack(total, axis=1))


def open_sides(vertices: FloatArray, triangles: IntArray) -> tuple[BoolArray, BoolArray]:
    """(T, 3) whether a side of a triangle is on the border, and (T, 3) whether a corner is.

    Vertices in the same place count as one, so that a surface may be given triangle by triangle.
    """
    _, place = np.unique(vertices, axis=0, return_inverse=True)
    first = place.ravel()[triangles]
    second = np.roll(first, -1, axis=1)
    sides = np.sort(np.stack([first, second], axis=2), axis=2).reshape(-1, 2)
    _, which, counts = np.unique(sides, axis=0, return_inverse=True, return_counts=True)
    alone = (counts == 1)[which.ravel()].reshape(-1, 3)
    at_border = np.zeros(len(vertices), dtype=bool)
    at_border[first[alone]] = at_border[second[alone]] = True
    return alone, at_border[first]
