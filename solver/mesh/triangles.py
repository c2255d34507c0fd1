"""Triangle meshes as they come from files, made sound or refused."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial import cKDTree

from solver.errors import InputError
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.mirror import SAME_PLACE, size_of
from solver.mesh.quadmesh import FloatArray


def sound_triangles(vertices: ArrayLike, triangles: ArrayLike) -> tuple[FloatArray, IntArray]:
    """Merge vertices at one place, drop what has no area, refuse what is no surface.

    Args:
        vertices: (V, 3) coordinates.
        triangles: (T, 3) vertex numbers.

    Returns:
        (W, 3) points that are used and (S, 3) triangles of them.

    Raises:
        InputError: nothing with an area, edges with more than two triangles, or loose triangles.
    """
    points = np.asarray(vertices, dtype=np.float64).reshape(-1, 3)
    corners = np.asarray(triangles, dtype=np.int64)
    TriangleSurface(points, corners)
    tree = cKDTree(points)
    first = np.array(
        [min(near) for near in tree.query_ball_point(points, SAME_PLACE * size_of(points))]
    )
    corners = first[corners]
    two, three = (points[corners[:, k]] - points[corners[:, 0]] for k in (1, 2))
    corners = corners[np.linalg.norm(np.cross(two, three), axis=1) > 0]
    if not len(corners):
        raise InputError("triangles: none has an area; export the surface again")
    kept, numbers = np.unique(corners, return_inverse=True)
    points, corners = points[kept], numbers.reshape(-1, 3)
    sides = np.sort(np.concatenate([corners[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    edges, counts = np.unique(sides, axis=0, return_counts=True)
    if (counts > 2).any():
        place = ", ".join(f"{x:.4g}" for x in points[edges[counts > 2][0]].mean(axis=0))
        raise InputError(
            f"triangles: more than two of them share an edge, {int((counts > 2).sum())} times, "
            f"near ({place}) for one; separate the sheets that meet there first"
        )
    if (counts == 1).sum() > 0.75 * 3 * len(corners) and len(corners) > 2:
        raise InputError(
            "triangles: a soup of loose triangles, not a surface; join vertices at the same place "
            "(a larger tolerance) and export again"
        )
    return points, corners
