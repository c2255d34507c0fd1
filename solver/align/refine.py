"""Long edges of a triangle mesh halved, with what is known at its vertices."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from solver.align.triangle_mesh import TriangleMesh
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# Which parts of a triangle are left, by which of its edges are halved (edge k starts at corner k);
# 3 to 5 are the middles of the edges.
_PARTS = {
    (True, False, False): ((0, 3, 2), (3, 1, 2)),
    (True, True, False): ((3, 1, 4), (0, 3, 4), (0, 4, 2)),
    (True, True, True): ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)),
}
# Times that a mesh is gone over, and triangles that it may come to.
_ROUNDS, _MOST = 12, 600_000


def refined(
    mesh: TriangleMesh, values: FloatArray, counts: Sequence[int], longest: float
) -> tuple[TriangleMesh, FloatArray, list[int]]:
    """Halve edges until none is longer.

    Args:
        mesh: the surface.
        values: (V, ...) of its vertices; those of new ones are means.
        counts: of triangles that come first, and stay first: so many of the first, so many more.
        longest: in the unit of the points.

    Returns:
        the finer mesh, its values, and how many of its triangles come from each of these.
    """
    points, triangles = mesh.points, mesh.triangles
    of = np.searchsorted(np.cumsum(counts), np.arange(len(triangles)), side="right")
    for _ in range(_ROUNDS):
        half_edges = np.stack([triangles, np.roll(triangles, -1, axis=1)], -1).reshape(-1, 2)
        pairs, edge = np.unique(np.sort(half_edges, axis=1), axis=0, return_inverse=True)
        long = np.linalg.norm(points[pairs[:, 1]] - points[pairs[:, 0]], axis=1) > longest
        if not long.any() or len(triangles) > _MOST:
            break
        number = np.cumsum(long) - 1 + len(points)
        halved = pairs[long]
        points = np.concatenate([points, points[halved].mean(axis=1)])
        values = np.concatenate([values, values[halved].mean(axis=1)])
        edge = edge.reshape(-1, 3)
        triangles, of = _parted(triangles, of, long[edge], number[edge])
    order = np.argsort(of, kind="stable")
    sizes = np.bincount(of, minlength=len(counts) + 1)[: len(counts)]
    return TriangleMesh(points, triangles[order]), values, sizes.tolist()


def _parted(
    triangles: IntArray, of: IntArray, long: BoolArray, middle: IntArray
) -> tuple[IntArray, IntArray]:
    """Replace triangles by their parts, with the numbers of what they belong to."""
    whole = ~long.any(axis=1)
    found, belong = [triangles[whole]], [of[whole]]
    corners = np.concatenate([triangles, middle], axis=1)
    for pattern, parts in _PARTS.items():
        for turn in range(1 if all(pattern) else 3):
            rows = (np.roll(long, -turn, axis=1) == pattern).all(axis=1)
            order = [(k + turn) % 3 for k in range(3)] + [3 + (k + turn) % 3 for k in range(3)]
            local = corners[rows][:, order]
            for part in parts:
                found.append(local[:, part])
                belong.append(of[rows])
    return np.concatenate(found), np.concatenate(belong)
