"""A net that shows a quadric itself, for drawing on it."""

from __future__ import annotations

import numpy as np

from solver.mesh.grid import grid_mesh
from solver.mesh.mirror import welded
from solver.mesh.quadmesh import QuadMesh
from solver.multinet import Quadric

# How far hyperboloids are shown, as the parameter of their hyperbolas, and the poles' distance.
_REACH, _POLE = 1.2, 0.12
_AROUND, _ALONG = 32, 17


def quadric_mesh(quadric: Quadric) -> QuadMesh:
    """Part of an ellipsoid or hyperboloid by two families of its plane curves."""
    lengths = 1.0 / np.sqrt(np.abs(quadric.curvatures))
    angle = np.linspace(0, 2 * np.pi, _AROUND, endpoint=False)[:, None]
    negative = int((quadric.curvatures < 0).sum())
    if negative == 2:
        place = np.linspace(_POLE, _REACH, _ALONG)[None, :]
        sheets = [_sheet(quadric, lengths, sign, angle, place) for sign in (1.0, -1.0)]
        return welded(sheets)
    if negative == 1:
        place = np.linspace(-_REACH, _REACH, _ALONG)[None, :]
        parts = np.cos(angle) * np.cosh(place), np.sin(angle) * np.cosh(place), np.sinh(place)
    else:
        place = np.linspace(_POLE, np.pi - _POLE, _ALONG)[None, :]
        parts = np.cos(angle) * np.sin(place), np.sin(angle) * np.sin(place), np.cos(place)
    points = np.stack(np.broadcast_arrays(*parts), axis=2) * lengths
    return grid_mesh(quadric.from_frame(points), closed_u=True)


def _sheet(
    quadric: Quadric, lengths: np.ndarray, sign: float, angle: np.ndarray, place: np.ndarray
) -> QuadMesh:
    across = np.sinh(place)
    parts = sign * np.cosh(place), np.cos(angle) * across, np.sin(angle) * across
    points = np.stack(np.broadcast_arrays(*parts), axis=2) * lengths
    return grid_mesh(quadric.from_frame(points), closed_u=True)
