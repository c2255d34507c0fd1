"""Small faults of a triangle mesh that would stand in the way of a map.

A hole smaller than a face of the net, such as the slit that a lost triangle leaves, is no opening
that lines could run round; directions are not defined in a triangle without height; and where noise
has folded triangles over, directions run backwards.
"""

from __future__ import annotations

import numpy as np

from solver.align.triangle_mesh import TriangleMesh
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# Height over longest edge below which a triangle is a sliver; how well the normals of the triangles
# that take its place must agree.
_SLIVER, _ALIKE = 0.03, 0.8
_ROUNDS = 10


def mended(mesh: TriangleMesh, smallest: float) -> TriangleMesh:
    """Close openings less than ``smallest`` across, unfold, and turn the long edges of slivers.

    Returns:
        the mesh; points of the given one come first, in their order. Only inner ones that triangles
        fold over at are moved.
    """
    mesh = _unfolded(_closed(mesh, smallest))
    for _ in range(_ROUNDS):
        turned = _turned(mesh)
        if turned is None:
            break
        mesh = TriangleMesh(mesh.points, turned)
    return mesh


def _closed(mesh: TriangleMesh, smallest: float) -> TriangleMesh:
    points, triangles = mesh.points, mesh.triangles
    loops = mesh.loops()
    spans = [float(np.linalg.norm(np.ptp(points[loop], axis=0))) for loop in loops]
    outer = int(np.argmax(spans))
    small = [k for k, span in enumerate(spans) if span < smallest and k != outer]
    for loop in (loops[k] for k in small):
        filling = [loop[::-1]]
        if len(loop) > 3:
            middle = len(points)
            points = np.concatenate([points, points[loop].mean(axis=0)[None]])
            filling = [[b, a, middle] for a, b in zip(loop, [*loop[1:], loop[0]], strict=True)]
        triangles = np.concatenate([triangles, np.array(filling)])
    return TriangleMesh(points, triangles) if small else mesh


def _unfolded(mesh: TriangleMesh) -> TriangleMesh:
    """Move inner vertices to the middle of their neighbours where triangles face backwards."""
    for _ in range(_ROUNDS):
        facing = np.einsum("tkx,tx->t", mesh.vertex_normals[mesh.triangles], mesh.normals)
        bad = np.zeros(len(mesh.points), dtype=bool)
        bad[mesh.triangles[facing < 0]] = True
        bad &= ~mesh.on_rim
        if not bad.any():
            break
        points = np.where(bad[:, None], _middles(mesh), mesh.points)
        mesh = TriangleMesh(points, mesh.triangles)
    return mesh


def relaxed(mesh: TriangleMesh, rounds: int) -> TriangleMesh:
    """Move inner points along the surface to the middle of their neighbours, several times."""
    for _ in range(rounds):
        move = _middles(mesh) - mesh.points
        normals = mesh.vertex_normals
        move -= (move * normals).sum(axis=1)[:, None] * normals
        points = np.where(mesh.on_rim[:, None], mesh.points, mesh.points + move)
        mesh = TriangleMesh(points, mesh.triangles)
    return mesh


def _middles(mesh: TriangleMesh) -> FloatArray:
    """(V, 3) mean of the neighbours of each point that follow it in a triangle."""
    start, end = mesh.half_edges.T
    sums, counts = np.zeros_like(mesh.points), np.bincount(start, minlength=len(mesh.points))
    np.add.at(sums, start, mesh.points[end])
    found: FloatArray = sums / counts[:, None]
    return found


def _turned(mesh: TriangleMesh) -> IntArray | None:
    """Triangles after edges between slivers and their neighbours are turned, if any can be."""
    points, triangles = mesh.points, mesh.triangles
    height = _heights(points[triangles])
    worst = height.min(initial=1.0)
    if worst >= _SLIVER:
        return None
    one, two = mesh.edges.T
    first, second = one // 3, two // 3
    rows = np.flatnonzero(np.minimum(height[first], height[second]) < _SLIVER)
    first, second = first[rows], second[rows]
    start, end = (side[rows] for side in mesh.ends)
    # Corners opposite the edge, and the two triangles on either side of the line between them.
    left, right = (triangles[half[rows] // 3, (half[rows] % 3 + 2) % 3] for half in (one, two))
    new = np.stack(
        [np.stack([start, right, left], axis=1), np.stack([end, left, right], axis=1)], axis=1
    )
    normals = np.cross(
        points[new[:, :, 1]] - points[new[:, :, 0]], points[new[:, :, 2]] - points[new[:, :, 0]]
    )
    sizes = np.linalg.norm(normals, axis=2)
    around = mesh.vertex_normals[start] + mesh.vertex_normals[end]
    around /= np.maximum(np.linalg.norm(around, axis=1), np.finfo(float).tiny)[:, None]
    facing = np.einsum("ekx,ex->ek", normals, around) > _ALIKE * sizes
    before = np.minimum(height[first], height[second])
    after = _heights(points[new]).min(axis=1)
    known = {tuple(pair) for pair in np.sort(mesh.half_edges, axis=1).tolist()}
    found, taken = triangles.copy(), np.zeros(len(triangles), dtype=bool)
    order = np.argsort(before - after)
    changed = False
    for k in order[(after > 2 * before)[order] & facing.all(axis=1)[order]].tolist():
        pair = (int(min(left[k], right[k])), int(max(left[k], right[k])))
        if taken[first[k]] or taken[second[k]] or pair in known:
            continue
        known.add(pair)
        taken[[first[k], second[k]]] = changed = True
        found[first[k]], found[second[k]] = new[k]
    return found if changed else None


def _heights(corners: FloatArray) -> FloatArray:
    """Height over longest edge of triangles (..., 3, 3)."""
    sides = np.roll(corners, -1, axis=-2) - corners
    longest = (sides**2).sum(axis=-1).max(axis=-1)
    area = np.linalg.norm(np.cross(sides[..., 0, :], sides[..., 1, :]), axis=-1)
    found: FloatArray = area / np.maximum(longest, np.finfo(float).tiny)
    return found
