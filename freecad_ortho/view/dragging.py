"""Where a dragged vertex goes when the mouse aims along a ray."""

from __future__ import annotations

import numpy as np

from freecad_ortho.view.screen import Ray
from solver.mesh.closest import TriangleSurface
from solver.mesh.quadmesh import FloatArray

VIEW_PLANE, ALONG_NORMAL, ON_SURFACE = "view", "normal", "surface"
AXES = {"x": np.eye(3)[0], "y": np.eye(3)[1], "z": np.eye(3)[2]}
MODES = (VIEW_PLANE, *AXES, ALONG_NORMAL, ON_SURFACE)

# Seen more steeply than this, an axis or a plane leads anywhere; the vertex stays.
_STEEP = 1e-3


def on_plane(ray: Ray, place: FloatArray, normal: FloatArray) -> FloatArray:
    """Where the ray meets the plane through a place; the place itself where it runs along it."""
    along = ray.direction @ normal
    if abs(along) < _STEEP:
        return place
    return ray.origin + ray.direction * ((place - ray.origin) @ normal / along)


def on_axis(ray: Ray, place: FloatArray, axis: FloatArray) -> FloatArray:
    """The point nearest to the ray on the line through a place along a unit vector."""
    across = ray.direction @ axis
    lean = 1.0 - across * across
    if lean < _STEEP:
        return place
    apart = place - ray.origin
    return place + axis * ((across * (apart @ ray.direction) - apart @ axis) / lean)


def on_surface(ray: Ray, place: FloatArray, surface: TriangleSurface) -> FloatArray:
    """Where the ray meets the surface first; beside it, the surface's point nearest to the aim."""
    hit = first_hit(ray, surface)
    if hit is not None:
        return hit
    aim = on_plane(ray, place, ray.direction)
    return surface.closest(aim[None])[0][0]


def first_hit(ray: Ray, surface: TriangleSurface) -> FloatArray | None:
    """The ray's first point on a triangle surface, None where it passes by.

    Source: Moeller, Trumbore (1997), Fast, minimum storage ray/triangle intersection.
    """
    a, b, c = np.moveaxis(surface.vertices[surface.triangles], 1, 0)
    one, two, apart = b - a, c - a, ray.origin - a
    across = np.cross(ray.direction, two)
    volume = np.einsum("ij,ij->i", one, across)
    with np.errstate(divide="ignore", invalid="ignore"):
        u = np.einsum("ij,ij->i", apart, across) / volume
        turned = np.cross(apart, one)
        v = turned @ ray.direction / volume
        way = np.einsum("ij,ij->i", two, turned) / volume
        inside = (u >= 0) & (v >= 0) & (u + v <= 1) & (way > 0)
    if not inside.any():
        return None
    return ray.origin + way[inside].min() * ray.direction
