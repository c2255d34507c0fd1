"""Faces of a mesh that cross each other."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh


def crossing_faces(mesh: QuadMesh) -> IntArray:
    """(K, 2) pairs of faces, apart by their vertices, of which one pierces the other.

    Each face counts as two triangles. Faces that only touch do not cross.

    Source: Moeller, Trumbore (1997), Fast, minimum storage ray-triangle intersection.
    """
    corners = mesh.vertices[mesh.faces]
    centres = corners.mean(axis=1)
    radii = np.linalg.norm(corners - centres[:, None], axis=2).max(axis=1)
    pairs = _near(centres, radii)
    low, high = corners.min(axis=1), corners.max(axis=1)
    one, two = pairs.T
    boxes = (low[one] <= high[two]).all(axis=1) & (low[two] <= high[one]).all(axis=1)
    pairs = pairs[boxes]
    common = (mesh.faces[pairs[:, 0], :, None] == mesh.faces[pairs[:, 1], None, :]).any(axis=(1, 2))
    pairs = pairs[~common]
    hits = np.zeros(len(pairs), dtype=bool)
    for first, second in (pairs.T, pairs.T[::-1]):
        for side in range(4):
            start, end = corners[first, side], corners[first, (side + 1) % 4]
            for triangle in ((0, 1, 2), (0, 2, 3)):
                hits |= _pierces(start, end, corners[second][:, triangle])
    return np.asarray(pairs[hits])


def _near(centres: FloatArray, radii: FloatArray) -> IntArray:
    """(K, 2) pairs whose bounding balls may meet.

    Balls are sorted into sizes, each within a factor of two, and every size is held against itself
    and all smaller ones: a few large faces among many small ones do not make all of these near.
    """
    size = np.frexp(radii)[1]
    found = [np.zeros((0, 2), dtype=np.int64)]
    for level in np.unique(size):
        large, all_up_to = np.flatnonzero(size == level), np.flatnonzero(size <= level)
        met = cKDTree(centres[large]).sparse_distance_matrix(
            cKDTree(centres[all_up_to]), 2 * float(radii[large].max()), output_type="ndarray"
        )
        one, two = large[met["i"]], all_up_to[met["j"]]
        near = (met["v"] < radii[one] + radii[two]) & ((size[two] < level) | (one < two))
        found.append(np.sort(np.stack([one[near], two[near]], axis=1), axis=1))
    pairs = np.concatenate(found)
    return pairs[np.lexsort(pairs.T[::-1])]


def _pierces(start: FloatArray, end: FloatArray, triangle: FloatArray) -> np.ndarray:
    """(K,) whether segments pass through the inside of triangles (K, 3, 3)."""
    along = end - start
    one, two = triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0]
    cross = np.cross(along, two)
    det = np.einsum("ij,ij->i", one, cross)
    scale = np.linalg.norm(along, axis=1) * np.linalg.norm(np.cross(one, two), axis=1)
    good = np.abs(det) > 1e-9 * scale
    inverse = 1.0 / np.where(good, det, 1.0)
    arm = start - triangle[:, 0]
    a = np.einsum("ij,ij->i", arm, cross) * inverse
    turned = np.cross(arm, one)
    b = np.einsum("ij,ij->i", along, turned) * inverse
    t = np.einsum("ij,ij->i", two, turned) * inverse
    # The segment's ends do not count (faces may touch), the triangle's sides do (lines may meet).
    hair = 1e-6
    inside = (a > -hair) & (b > -hair) & (a + b < 1 + hair) & (t > hair) & (t < 1 - hair)
    return np.asarray(good & inside)
