"""How far a mesh is from having a Christoffel dual."""

from __future__ import annotations

import numpy as np

from solver.mesh.quadmesh import FloatArray, QuadMesh


def koenigs(mesh: QuadMesh) -> FloatArray:
    """(S,) abs(log) of the product, over the faces of a star, of how the diagonals cut each other.

    In each face that between its two neighbours of the centre is cut by the other one, and the
    quotient of its parts counts. Zero around each star: the net has a dual.

    Source: Bobenko, Suris (2009), Discrete Koenigs nets and discrete isothermic surfaces.
    """
    net = mesh.connectivity
    if not len(net.stars):
        return np.zeros(0)
    around, corners = mesh.vertices[net.stars], mesh.vertices[net.diagonal_stars[:, 1:]]
    centre, one = around[:, :1], around[:, 1:]
    two = np.roll(one, -1, axis=1)
    # Where one + share (two - one) meets the line from the centre to the corner, seen from above.
    ray, side = corners - centre, two - one
    normal = np.cross(ray, side)
    share = _dot(np.cross(centre - one, ray), normal) / -_dot(normal, normal)
    share = np.clip(share, 1e-12, 1 - 1e-12)
    return np.asarray(np.abs(np.log((1 - share) / share).sum(axis=1)))


def _dot(one: FloatArray, two: FloatArray) -> FloatArray:
    return np.asarray(np.einsum("ski,ski->sk", one, two))
