"""Polynomial heights over tangent planes: curvature of a triangle mesh, and how it goes on.

Source: Cazals and Pouget (2005), Estimating differential quantities using polynomial fitting of
osculating jets.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from solver.align.triangle_mesh import TriangleMesh
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, unit_rows

# Exponents of a cubic in two variables, by degree.
_POWERS = np.array([(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)])
# How much each is held down where points say nothing of it; degree 2 little, since it is wanted.
_HELD = np.array([1e-4, 1e-4, 1e-4, 0.1, 0.1, 0.1, 1, 1, 1, 1])
_DAMPING = 1e-5
# Points that a fit takes at most, about, and at least; the cloud is thinned to that.
_MOST, _LEAST = 90, 18
_CELLS_ACROSS = 5
# Normals that differ by more than this (cosine) belong to another part of the surface.
_ALIKE = 0.3
# Rows that are fitted at once; bounds the memory.
_BLOCK = 4000


@dataclass(frozen=True, eq=False)
class Jets:
    """Heights over planes, as polynomials of degree 3.

    Attributes:
        places: (N, 3) where each plane stands.
        axes: (N, 3, 3) its two directions and its normal.
        coefficients: (N, 10) of heights and coordinates over ``scale``.
        scale: (N,) the radius of the fit.
    """

    places: FloatArray
    axes: FloatArray
    coefficients: FloatArray
    scale: FloatArray

    def beside(self, rows: IntArray, first: FloatArray, second: FloatArray) -> FloatArray:
        """Points (M, 3) of the surfaces of ``rows`` at plane coordinates from their places.

        The polynomial is shifted so that each place itself is on it.
        """
        scale = self.scale[rows]
        terms = _terms(first / scale, second / scale)
        terms[:, 0] = 0.0
        height = scale * (terms * self.coefficients[rows]).sum(axis=1)
        plane = np.stack([first, second, height], axis=1)
        found: FloatArray = self.places[rows] + np.einsum("nk,nkx->nx", plane, self.axes[rows])
        return found

    def shape_tensors(self) -> FloatArray:
        """(N, 3, 3) shape operators, their image in the tangent plane.

        A normal curvature is positive where the surface bends towards the normal.
        """
        c, scale = self.coefficients, self.scale
        slope = c[:, 1:3]
        bend = np.empty((len(c), 2, 2))
        bend[:, 0, 0], bend[:, 1, 1] = 2 * c[:, 3] / scale, 2 * c[:, 5] / scale
        bend[:, 0, 1] = bend[:, 1, 0] = c[:, 4] / scale
        bend /= np.sqrt(1 + (slope * slope).sum(axis=1))[:, None, None]
        metric = np.eye(2) + slope[:, :, None] * slope[:, None, :]
        tangents = self.axes[:, :2] + slope[:, :, None] * self.axes[:, 2:]
        raised = np.linalg.inv(metric) @ tangents
        found: FloatArray = raised.transpose(0, 2, 1) @ bend @ raised
        return found


def fitted(mesh: TriangleMesh, vertices: IntArray, radius: float, degree: int = 3) -> Jets:
    """Fit a height to the vertices round each of some vertices.

    Args:
        mesh: the surface.
        vertices: (N,) where.
        radius: how far points count; wider where there are few.
        degree: 3, or 2 where the points are noisy.
    """
    powers = int((_POWERS.sum(axis=1) <= degree).sum())
    cloud = _thinned(mesh.points, radius / _CELLS_ACROSS)
    points, normals = mesh.points[cloud], mesh.vertex_normals[cloud]
    tree, most = cKDTree(points), min(_MOST, len(cloud))
    places, up = mesh.points[vertices], mesh.vertex_normals[vertices]
    first: FloatArray = unit_rows(np.cross(up, np.eye(3)[np.argmin(np.abs(up), axis=1)]))
    axes: FloatArray = np.stack([first, np.cross(up, first), up], axis=1)
    coefficients, scale = np.zeros((len(places), len(_POWERS))), np.empty(len(places))
    for start in range(0, len(places), _BLOCK):
        part = slice(start, start + _BLOCK)
        far, near = tree.query(places[part], k=most)
        reach = np.maximum(radius, 1.2 * far[:, min(_LEAST, most) - 1])
        local = (points[near] - places[part, None]) @ axes[part].transpose(0, 2, 1)
        alike = (normals[near] @ up[part, :, None])[..., 0] > _ALIKE
        weight = np.where(
            alike & (far < reach[:, None]), 1.02 - np.minimum(far / reach[:, None], 1) ** 2, 0.0
        )
        scale[part] = reach
        coefficients[part, :powers] = _fit(local / reach[:, None, None], weight, powers)
    return Jets(places, axes, coefficients, scale)


def face_tensors(mesh: TriangleMesh, of_vertices: FloatArray) -> FloatArray:
    """(T, 2, 2) shape operators in the triangles' frames, means of those of the corners."""
    mean = of_vertices[mesh.triangles].mean(axis=1)
    found: FloatArray = mesh.axes @ mean @ mesh.axes.transpose(0, 2, 1)
    return found


def _thinned(points: FloatArray, cell: float) -> IntArray:
    """One vertex of each occupied cube."""
    cubes = np.floor((points - points.min(axis=0)) / cell).astype(np.int64)
    chosen: IntArray = np.unique(cubes, axis=0, return_index=True)[1]
    return chosen


def _terms(first: FloatArray, second: FloatArray) -> FloatArray:
    one, two = np.ones_like(first), np.ones_like(second)
    powers = [(one, two), (first, second), (first**2, second**2), (first**3, second**3)]
    return np.stack([powers[a][0] * powers[b][1] for a, b in _POWERS], axis=-1)


def _fit(local: FloatArray, weight: FloatArray, powers: int) -> FloatArray:
    terms = _terms(local[..., 0], local[..., 1])[..., :powers]
    weighted = (terms * weight[..., None]).transpose(0, 2, 1)
    normal: FloatArray = weighted @ terms
    # A point without any like it is on a plane.
    held = np.maximum(_DAMPING / powers * np.trace(normal, axis1=1, axis2=2), _DAMPING)
    normal[:, np.arange(powers), np.arange(powers)] += held[:, None] * _HELD[:powers]
    return np.asarray(np.linalg.solve(normal, weighted @ local[..., 2:])[..., 0], dtype=np.float64)
