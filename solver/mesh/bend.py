"""A sheet bent in one direction only: the developable shape that resembles a mesh."""

from __future__ import annotations

import numpy as np

from solver.mesh.quadmesh import FloatArray, QuadMesh

# Part of the larger principal curvature that the smaller one has on a doubly curved sheet.
_DOUBLE = 0.3
# Unit vectors with a smaller part in the plane that fits the mesh best have no direction there.
_LEVEL = 0.1


def unbent(mesh: QuadMesh, direction: FloatArray) -> QuadMesh:
    """Take the mean curvature in one direction out of a mesh and leave that across it.

    A quadric is fitted over the plane that fits the mesh best; its part along ``direction`` is
    subtracted from the heights. What is left is bent like a cylinder, plus the deviations from the
    quadric.

    Args:
        mesh: a sheet without folds over its best plane.
        direction: (3,) vector, not normal to that plane.
    """
    centre, axes, form = _quadric(mesh)
    local = (mesh.vertices - centre) @ axes.T
    along = (axes @ direction)[:2]
    along = along / np.linalg.norm(along)
    way = local[:, :2] @ along
    local[:, 2] -= 0.5 * (along @ form @ along) * way**2
    return mesh.with_vertices(local @ axes + centre)


def doubly_curved(mesh: QuadMesh) -> bool:
    """Whether the quadric that fits a sheet best is bent in both its principal directions."""
    smaller, larger = sorted(np.abs(np.linalg.eigvalsh(_quadric(mesh)[2])))
    return bool(smaller > _DOUBLE * larger)


def _quadric(mesh: QuadMesh) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Centre (3,) and axes (3, 3) of the best plane, and second derivatives (2, 2) over it."""
    used = mesh.connectivity.referenced
    centre = mesh.vertices[used].mean(axis=0)
    axes = np.linalg.svd(mesh.vertices[used] - centre, full_matrices=False)[2]
    x, y, height = ((mesh.vertices[used] - centre) @ axes.T).T
    terms = np.stack([np.ones_like(x), x, y, 0.5 * x * x, x * y, 0.5 * y * y], axis=1)
    fit = np.linalg.lstsq(terms, height, rcond=None)[0]
    return centre, axes, np.array([[fit[3], fit[4]], [fit[4], fit[5]]])


def central_directions(mesh: QuadMesh) -> list[FloatArray]:
    """Unit vectors along a diagonal and a medial line of the face nearest to the middle.

    Those that stand upright on the plane that fits the mesh best, as in a tube, are left out.
    """
    corners = mesh.vertices[mesh.faces]
    middles = corners.mean(axis=1)
    face = int(np.argmin(np.linalg.norm(middles - middles.mean(axis=0), axis=1)))
    a, b, c, d = corners[face]
    level = _quadric(mesh)[1][:2]
    units = [vector / np.linalg.norm(vector) for vector in (c - a, b + c - a - d)]
    return [unit for unit in units if np.linalg.norm(level @ unit) > _LEVEL]
