"""A design surface made to reach as far as a net that overhangs its border."""

from __future__ import annotations

from weakref import WeakKeyDictionary

import numpy as np
from scipy.spatial import cKDTree

from solver.align.prepare import carried, smoothed
from solver.align.triangle_mesh import TriangleMesh, one_surface
from solver.errors import InputError
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.mesh.triangles import sound_triangles

# In mean edges: what lies beyond the border by more overhangs it, and by more than this lies
# elsewhere; what is added so that vertices may move.
_HARDLY, _ELSEWHERE, _SPARE = 0.02, 3.0, 1.0
# A vertex that is off along the normal by more than this part of its distance is off the surface.
_ALONG = 0.5
# Room for lines that have to curve, as part of the diagonal of a net.
_ROOM = 0.12


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
    found = carried_to(mesh, TriangleSurface(points, triangles))
    return (points, triangles) if found is None else (found.vertices, found.triangles)


def beyond(mesh: QuadMesh, points: FloatArray, triangles: IntArray) -> tuple[FloatArray, IntArray]:
    """Carry a surface on beyond its border, by a part of the size of a net whose lines leave it.

    Lines that have to curve in a surface do not keep to its border: held there, they zigzag.

    Args:
        mesh: the net.
        points: (V, 3) of the surface.
        triangles: (T, 3).

    Returns:
        points and triangles; those that were given where the surface is not one open sheet.
    """
    surface = _sheet(TriangleSurface(points, triangles))
    if surface is None:
        return points, triangles
    size = float(np.linalg.norm(np.ptp(mesh.vertices[mesh.connectivity.referenced], axis=0)))
    found = _carried_on(surface, max(_ROOM * size, mesh.mean_edge), mesh.mean_edge)
    return found.vertices, found.triangles


# What a surface is as one sheet: asked for as often as a net is drawn while it is dragged.
_SHEETS: WeakKeyDictionary[TriangleSurface, TriangleMesh | None] = WeakKeyDictionary()


def _sheet(ground: TriangleSurface) -> TriangleMesh | None:
    """The triangles as one open sheet; None where they are several, or closed."""
    try:
        return one_surface(*sound_triangles(ground.vertices, ground.triangles))
    except InputError:
        return None


def carried_to(mesh: QuadMesh, ground: TriangleSurface) -> TriangleSurface | None:
    """A surface that reaches as far as a mesh overhangs it; None where nothing does, as above."""
    edge = mesh.mean_edge
    vertices = mesh.vertices[mesh.connectivity.referenced]
    feet, _ = ground.closest(vertices)
    off = vertices - feet
    far = np.linalg.norm(off, axis=1)
    away = far > _HARDLY * edge
    if not away.any():
        return None
    if ground not in _SHEETS:
        _SHEETS[ground] = _sheet(ground)
    surface = _SHEETS[ground]
    if surface is None:
        return None
    rim = np.flatnonzero(surface.on_rim)
    beside = rim[cKDTree(surface.points[rim]).query(feet)[1]]
    level = np.abs((off * surface.vertex_normals[beside]).sum(axis=1)) < _ALONG * far
    border = TriangleSurface(surface.points, surface.half_edges[surface.rim][:, [0, 1, 1]])
    at_border = np.linalg.norm(feet - border.closest(feet)[0], axis=1) < _HARDLY * edge
    overhang = away & level & at_border
    if not overhang.any() or far[overhang].max() > _ELSEWHERE * edge:
        return None
    width = float(far[overhang].max()) + _SPARE * edge
    return _carried_on(surface, width, edge)


def _carried_on(surface: TriangleMesh, width: float, edge: float) -> TriangleSurface:
    """The surface as it is, and a strip of a width along its border."""
    smooth, rough = smoothed(surface, edge)
    larger, _ = carried(smooth, width, edge, rough > 0)
    points = np.concatenate([surface.points, larger.points[len(surface.points) :]])
    return TriangleSurface(points, larger.triangles)
