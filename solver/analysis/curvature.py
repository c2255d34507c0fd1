"""Gauss and mean curvature at the vertices of a quad mesh.

Each face is split along one diagonal and along the other, and both splits count half. So no
diagonal is preferred, torsion along the parameter lines counts as it should, and on samplings of a
smooth surface both curvatures are right to second order in the mesh size at every regular inner
vertex, whatever the angles of the net. At irregular vertices their integrals are right, their
values not.

Source: Meyer, Desbrun, Schroeder, Barr (2003), Discrete differential-geometry operators for
triangulated 2-manifolds; averaged over the splits.
"""

from __future__ import annotations

import numpy as np

from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Corners of the four triangles that the two splits of a face make.
_SPLITS = np.array([[0, 1, 2], [0, 2, 3], [0, 1, 3], [1, 2, 3]])


def gauss_curvature(mesh: QuadMesh) -> FloatArray:
    """(V,) angle defect / vertex area, in 1 / unit^2; NaN at the boundary."""
    return angle_defects(mesh) / _positive(vertex_areas(mesh))


def mean_curvature(mesh: QuadMesh) -> FloatArray:
    """(V,) mean of the two principal curvatures, in 1 / unit; NaN at the boundary.

    Positive where the surface bends towards its vertex normal: a sphere of radius R with normals
    outwards has -1 / R. Half the cotangent Laplacian of the positions, the gradient of the mean
    area of both splits.
    """
    count = len(mesh.vertices)
    along_normal = np.zeros(count)
    triangles = mesh.faces[:, _SPLITS].reshape(-1, 3)
    for k in range(3):
        apex, start, end = (triangles[:, (k + j) % 3] for j in range(3))
        one, two = (mesh.vertices[tip] - mesh.vertices[apex] for tip in (start, end))
        double_area = np.linalg.norm(np.cross(one, two), axis=1)
        # Half for each split, half of the sum of two cotangents.
        weight = 0.25 * np.einsum("ij,ij->i", one, two) / _positive(double_area)
        pull = weight[:, None] * (two - one)
        for tip, sign in ((start, 1.0), (end, -1.0)):
            share = sign * np.einsum("ij,ij->i", pull, mesh.vertex_normals[tip])
            along_normal += np.bincount(tip, share, count)
    result = 0.5 * along_normal / _positive(vertex_areas(mesh))
    return np.where(inner_vertices(mesh), result, np.nan)


def angle_defects(mesh: QuadMesh) -> FloatArray:
    """(V,) integrated Gauss curvature in radians: 2 pi - sum of angles; NaN at the boundary.

    On a closed mesh the sum is 2 pi times the Euler characteristic, exactly.
    """
    count = len(mesh.vertices)
    triangles = mesh.faces[:, _SPLITS].reshape(-1, 3)
    total = np.zeros(count)
    for k in range(3):
        apex, start, end = (triangles[:, (k + j) % 3] for j in range(3))
        one, two = (mesh.vertices[tip] - mesh.vertices[apex] for tip in (start, end))
        sine = np.linalg.norm(np.cross(one, two), axis=1)
        total += np.bincount(apex, 0.5 * np.arctan2(sine, np.einsum("ij,ij->i", one, two)), count)
    return np.where(inner_vertices(mesh), 2 * np.pi - total, np.nan)


def vertex_areas(mesh: QuadMesh) -> FloatArray:
    """(V,) a quarter of the area of the faces around, in unit^2."""
    area = np.linalg.norm(mesh.face_area_vectors, axis=1)
    total = np.bincount(mesh.faces.ravel(), np.repeat(area / 4, 4), len(mesh.vertices))
    return total.astype(np.float64)


def inner_vertices(mesh: QuadMesh) -> BoolArray:
    """(V,) true where faces close up around a vertex."""
    net = mesh.connectivity
    return net.referenced & ~net.boundary_vertices


def _positive(values: FloatArray) -> FloatArray:
    """Divisors in which zero, of what has no area, has become one."""
    return np.where(values > 0, values, 1.0)
