"""Panels where hubs stand: how far they are lifted over them, or how far corners are cut back.

A hub is as high as the beams, but wider, and its end is square to the node axis: where that leans
from a face's normal, its rim stands above the face's plane.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.systems.panels.corners import PanelCorners
from freecad_ortho.fabrication.systems.panels.planes import Planes
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray, unit_rows

# What stands out by less, mm, is flush.
_FLUSH = 1e-3
# Lower and upper corners (2, K, 3) of the hub at each vertex that has one, mm.
Hubs = Mapping[int, FloatArray]


@dataclass(frozen=True, eq=False)
class Stands:
    """Hubs in the way of panels.

    Attributes:
        hubs: by the vertices at which they stand, in the site's mesh.
        cut: true to cut corners off beside them, false to lift panels over them.
        clearance: between panel and hub, mm.
    """

    hubs: Hubs
    cut: bool
    clearance: float


def lift_over(planes: Planes, hubs: Hubs) -> FloatArray:
    """(F,) how far the hubs' upper ends stand above each face, within its outline; 0 at least.

    Args:
        planes: of the faces.
        hubs: in the same place.
    """
    faces = planes.faces
    lift = np.zeros(len(faces))
    for vertices in _by_count(hubs).values():
        tops = np.array([hubs[vertex][1] for vertex in vertices])
        number = np.full(max(int(faces.max()), *vertices) + 1, -1)
        number[vertices] = np.arange(len(vertices))
        face, corner = np.nonzero(number[faces] >= 0)
        if len(face):
            arms = tops[number[faces[face, corner]]] - planes.middle[face][:, None]
            local = np.einsum("nck,ndk->ncd", arms, planes.frame[face])
            np.maximum.at(lift, face, _highest(local, planes.flat[face]))
    return lift


def _by_count(hubs: Hubs) -> dict[int, list[int]]:
    """Vertices by how many corners their hub has."""
    groups: dict[int, list[int]] = {}
    for vertex, ends in hubs.items():
        groups.setdefault(ends.shape[1], []).append(vertex)
    return groups


def _highest(top: FloatArray, flat: FloatArray) -> FloatArray:
    """(N,) largest z of plane convex polygons (N, C, 3) where convex ones (N, D, 2) lie under them.

    Where they overlap, the highest point is a corner of one inside the other, or a crossing of
    their sides.
    """
    low = np.full(len(top), -np.inf)
    candidates = [(_inside(top[..., :2], flat), top[..., 2])]
    slope, level = _planes(top)
    candidates.append(
        (_inside(flat, top[..., :2]), np.einsum("ndk,nk->nd", flat, slope) + level[:, None])
    )
    ahead, across = np.roll(top, -1, axis=1) - top, np.roll(flat, -1, axis=1) - flat
    divisor = _cross(ahead[:, :, None, :2], across[:, None])
    between = flat[:, None] - top[:, :, None, :2]
    with np.errstate(divide="ignore", invalid="ignore"):
        on_top = _cross(between, across[:, None]) / divisor
        on_flat = _cross(between, ahead[:, :, None, :2]) / divisor
    meets = (on_top >= 0) & (on_top <= 1) & (on_flat >= 0) & (on_flat <= 1)
    height = top[:, :, None, 2] + np.where(meets, on_top, 0.0) * ahead[:, :, None, 2]
    candidates.append((meets.reshape(len(top), -1), height.reshape(len(top), -1)))
    for holds, heights in candidates:
        low = np.maximum(low, np.where(holds, heights, -np.inf).max(axis=1))
    return low


def _inside(points: FloatArray, polygon: FloatArray) -> BoolArray:
    """(N, P) true for points (N, P, 2) in convex counter-clockwise polygons (N, C, 2)."""
    side = np.roll(polygon, -1, axis=1) - polygon
    arms = points[:, :, None] - polygon[:, None]
    return np.asarray((_cross(side[:, None], arms) >= 0).all(axis=2))


def _planes(polygon: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Slopes (N, 2) and level (N,) at the origin of plane polygons (N, C, 3), none upright."""
    following = np.roll(polygon, -1, axis=1)
    normal = np.cross(polygon, following).sum(axis=1)
    slope = -normal[:, :2] / normal[:, 2:]
    first = polygon[:, 0]
    return slope, first[:, 2] - np.einsum("nk,nk->n", first[:, :2], slope)


def _cross(one: FloatArray, other: FloatArray) -> FloatArray:
    return np.asarray(one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0])


def corner_cuts(planes: Planes, levels: FloatArray, stands: Stands) -> PanelCorners:
    """Lines that cut the corners of panels off beside the hubs, square to the corners' bisectors.

    Args:
        planes: of the faces.
        levels: (2, F) lower and upper level of the plates above them, mm.
        stands: hubs, and the clearance beside them.
    """
    faces, flat = planes.faces, planes.flat
    ahead = unit_rows(np.roll(flat, -1, axis=1) - flat)
    between = ahead - np.roll(ahead, 1, axis=1)
    # At a straight corner the bisector is square to its sides.
    inwards = np.where(
        np.linalg.norm(between, axis=2, keepdims=True) > 1e-6,
        between,
        np.stack([-ahead[..., 1], ahead[..., 0]], axis=2),
    )
    inwards = unit_rows(inwards)
    begins = np.full(faces.shape, -np.inf)
    for face, corner in np.argwhere(np.isin(faces, list(stands.hubs))).tolist():
        local = (stands.hubs[int(faces[face, corner])] - planes.middle[face]) @ planes.frame[face].T
        points = _between(local, *levels[:, face].tolist())
        if len(points):
            reach = float((points @ inwards[face, corner]).max())
            begins[face, corner] = reach + stands.clearance
    return PanelCorners(inwards, begins)


def _between(ends: FloatArray, low: float, high: float) -> FloatArray:
    """(P, 2) ends of that part of a hub's upright edges (2, K, 3) that lies between two levels."""
    bottom, top = ends
    if top[:, 2].max() <= low + _FLUSH or bottom[:, 2].min() >= high - _FLUSH:
        return np.empty((0, 2))
    share = (np.array([[low], [high]]) - bottom[:, 2]) / (top[:, 2] - bottom[:, 2])
    points = bottom[:, :2] + np.clip(share, 0.0, 1.0)[..., None] * (top - bottom)[:, :2]
    return np.asarray(points.reshape(-1, 2))
