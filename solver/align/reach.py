"""A design surface made to reach as far as a net that overhangs its border."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from solver.align.apron import extended
from solver.align.triangle_mesh import one_surface
from solver.errors import InputError
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.mesh.triangles import sound_triangles

# In mean edges: what lies beyond the border by more overhangs it, and by more than this lies
# elsewhere; what is added so that vertices may move; how far points say how the surface goes on.
_HARDLY, _ELSEWHERE, _SPARE, _RADIUS, _STRIPS = 0.02, 3.0, 1.0, 1.5, 6
# A vertex that is off along the normal by more than this part of its distance is off the surface.
_ALONG = 0.5


def reaching(
    mesh: QuadMesh, points: FloatArray, triangles: IntArray
) -> tuple[FloatArray, IntArray]:
    """Carry a surface on beyond its border, where a mesh overhangs it.

    Closest points of what overhangs would lie on the border and draw the net in, though the border
    is where it will be trimmed.

    Args:
        mesh: the net.
        points: (V, 3) of the surface.
        triangles: (T, 3).

    Returns:
        points and triangles; those that were given where nothing overhangs, where the net lies
        elsewhere, or where the surface is not one open sheet.
    """
    edge = mesh.mean_edge
    vertices = mesh.vertices[mesh.connectivity.referenced]
    feet, _ = TriangleSurface(points, triangles).closest(vertices)
    off = vertices - feet
    far = np.linalg.norm(off, axis=1)
    away = far > _HARDLY * edge
    if not away.any():
        return points, triangles
    try:
        surface = one_surface(*sound_triangles(points, triangles))
    except InputError:  # several sheets, or a closed one: there is no border to carry on
        return points, triangles
    rim = np.flatnonzero(surface.on_rim)
    beside = rim[cKDTree(surface.points[rim]).query(feet)[1]]
    level = np.abs((off * surface.vertex_normals[beside]).sum(axis=1)) < _ALONG * far
    border = TriangleSurface(surface.points, surface.half_edges[surface.rim][:, [0, 1, 1]])
    at_border = np.linalg.norm(feet - border.closest(feet)[0], axis=1) < _HARDLY * edge
    overhang = away & level & at_border
    if not overhang.any() or far[overhang].max() > _ELSEWHERE * edge:
        return points, triangles
    step = min(max(float(np.sqrt(2 * surface.areas.mean())), edge / _STRIPS), edge)
    width = float(far[overhang].max()) + _SPARE * edge
    larger = extended(surface, width, step, _RADIUS * edge)
    return larger.points, larger.triangles
