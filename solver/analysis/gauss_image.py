"""Area of the Gauss image: how far the normals spread in two directions.

The normals of a developable surface lie on curves of the unit sphere: their image has no area.
"""

from __future__ import annotations

import numpy as np

from solver.analysis.curvature import inner_vertices
from solver.mesh.quadmesh import FloatArray, QuadMesh


def gauss_image(mesh: QuadMesh) -> FloatArray:
    """(V,) signed solid angle that the normals of the faces around a vertex enclose, steradians.

    Positive where K > 0, NaN at the boundary. Where the faces are planar it equals the angle defect
    exactly.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, figure 13 (e).
    """
    net, normals, around = mesh.connectivity, mesh.face_normals, mesh.vertex_normals
    inner = ~net.boundary_edges
    start, end = net.edges[inner].T
    left, right = net.edge_faces[inner].T
    count = len(mesh.vertices)
    total = np.bincount(
        start, _solid_angles(around[start], normals[right], normals[left]), count
    ) + np.bincount(end, _solid_angles(around[end], normals[left], normals[right]), count)
    return np.where(inner_vertices(mesh), total, np.nan)


def gauss_image_area(mesh: QuadMesh) -> float:
    """Sum of the unsigned solid angles of all inner vertices, in steradians."""
    return float(np.nansum(np.abs(gauss_image(mesh))))


def _solid_angles(a: FloatArray, b: FloatArray, c: FloatArray) -> FloatArray:
    """(n,) signed solid angle of spherical triangles of unit vectors, in steradians.

    Source: Van Oosterom, Strackee (1983), The solid angle of a plane triangle.
    """
    triple = np.einsum("ij,ij->i", a, np.cross(b, c))
    dots = [np.einsum("ij,ij->i", one, two) for one, two in ((a, b), (b, c), (c, a))]
    return np.asarray(2 * np.arctan2(triple, 1 + dots[0] + dots[1] + dots[2]))
