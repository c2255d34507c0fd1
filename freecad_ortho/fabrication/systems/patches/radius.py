"""Smallest radius to which a developable sheet is bent, from a mesh of any coarseness.

A mesh knows the curvature at its inner vertices, each a mean over the faces around. The sharpest
place lies beside or between them, on a cone at its narrow border. So the curvature is taken to rise
beyond a vertex as it rose up to it: all the way to a border, and steeper there, as 1 / r does; by a
quarter of the way between vertices, where it has to bend back. Bend lines know it at both of their
ends. The largest of all of these counts: a radius may be said too small, hardly ever too large.
"""

from __future__ import annotations

import numpy as np

from solver.analysis.curvature import mean_curvature
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# Angle of a bend line below which a sheet is flat there, radians.
_BENT = 1e-6
# How much of its rise up to a vertex the curvature goes on by: towards a border or a vertex.
_TO_BORDER, _TO_VERTEX = 1.5, 0.25
# No further than this many times its value.
_MOST = 3.0


def smallest_radius(mesh: QuadMesh) -> float:
    """Smallest radius of a developable mesh, inf where it is flat.

    On samplings of cylinders and cones by at least six faces each way, along their rulings or at
    any angle, graded or not, at most 1 % too large where the radius doubles within the sheet.
    """
    curvature = 2 * np.abs(mean_curvature(mesh))
    known = np.isfinite(curvature)
    found = (curvature[known], _beyond(mesh, curvature), _at_bend_lines(mesh, known.any()))
    sharpest = max(float(values.max(initial=0.0)) for values in found)
    return 1 / sharpest if sharpest * mesh.mean_edge > 1e-9 else np.inf


def _beyond(mesh: QuadMesh, curvature: FloatArray) -> FloatArray:
    """(S,) curvature beside each regular inner vertex, along both of its lines together."""
    stars = mesh.connectivity.stars
    centre, ring = stars[:, 0], stars[:, 1:]
    here, around = curvature[centre][:, None], curvature[ring]
    away = np.linalg.norm(mesh.vertices[ring] - mesh.vertices[centre][:, None], axis=2)
    behind, distance = np.roll(around, 2, axis=1), np.roll(away, 2, axis=1)
    rise = np.where(np.isfinite(behind), np.maximum(here - behind, 0), 0) * away / distance
    rise *= np.where(np.isfinite(around), _TO_VERTEX, _TO_BORDER)
    both = np.maximum(rise[:, 0], rise[:, 2]) + np.maximum(rise[:, 1], rise[:, 3])
    return np.asarray(here[:, 0] + np.minimum(both, (_MOST - 1) * here[:, 0]))


def _at_bend_lines(mesh: QuadMesh, steep_only: bool) -> FloatArray:
    """(I, 2) principal curvature at both ends of each inner edge of a developable mesh.

    Across the edge the mesh has the curvature L, the angle between its faces about the edge over
    half of their widths. Where the rulings slant, faces warp: with the twist M of the faces and
    L N = M^2 the principal curvature is L + N.

    Args:
        mesh: any.
        steep_only: zero at edges that lie nearer to the rulings' normals than to the rulings: what
            is not quite developable is far off there.
    """
    net, corner = mesh.connectivity, mesh.vertices[mesh.faces]
    edges = np.flatnonzero((net.edge_faces >= 0).all(axis=1))
    sides = net.edge_faces[edges]
    along = unit_rows(np.diff(mesh.vertices[net.edges[edges]], axis=1)[:, 0])
    one, two = np.moveaxis(mesh.face_normals[sides], 1, 0)
    sine = np.einsum("ik,ik->i", np.cross(one, two), along)
    angle = np.abs(np.arctan2(sine, np.einsum("ik,ik->i", one, two)))
    across = angle[:, None] / _widths(mesh, edges, along).mean(axis=1)
    mixed = np.einsum("fck,c,fk->f", corner, [1.0, -1.0, 1.0, -1.0], mesh.face_normals)
    warp = (mixed / np.linalg.norm(mesh.face_area_vectors, axis=1))[sides]
    twist = np.broadcast_to((warp**2).mean(axis=1)[:, None], across.shape)
    bent = across * mesh.mean_edge > _BENT
    if steep_only:
        bent &= across**2 >= twist
        across = np.where(bent, across, 0.0)
    return np.asarray(across + np.divide(twist, across, out=np.zeros_like(across), where=bent))


def _widths(mesh: QuadMesh, edges: IntArray, along: FloatArray) -> FloatArray:
    """(I, 2, 2) widths of both faces of edges (I,) square to ``along`` (I, 3), at both ends."""
    net = mesh.connectivity
    faces = net.edge_faces[edges]
    side = (net.face_edges[faces] == edges[:, None, None]).argmax(axis=2)
    start, end, after, before = (net.faces[faces, (side + k) % 4] for k in range(4))
    swapped = start != net.edges[edges][:, :1]
    wide = []
    for corner, neighbour in ((start, before), (end, after)):
        arms = mesh.vertices[neighbour] - mesh.vertices[corner]
        wide.append(np.linalg.norm(np.cross(arms, along[:, None]), axis=2))
    first, second = np.where(swapped, wide[1], wide[0]), np.where(swapped, wide[0], wide[1])
    return np.stack([first, second], axis=2)
