"""Translational surfaces: one polyline moved along another."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError
from solver.mesh.grid import grid_mesh
from solver.mesh.quadmesh import QuadMesh


def translational(first: ArrayLike, second: ArrayLike) -> QuadMesh:
    """Net v_ij = a_i + b_j - b_0: every face is a parallelogram, exactly planar.

    If both polylines have one edge length it is a Chebyshev net, exactly.

    Args:
        first: (m, 3) points a_i.
        second: (n, 3) points b_j.

    Raises:
        InputError: other shapes.
    """
    a, b = np.asarray(first, dtype=np.float64), np.asarray(second, dtype=np.float64)
    for name, points in (("first", a), ("second", b)):
        if points.ndim != 2 or points.shape[1] != 3 or len(points) < 2:
            raise InputError(
                f"{name} polyline: expected at least two points of three coordinates, got shape "
                f"{points.shape}"
            )
    return grid_mesh(a[:, None, :] + (b - b[0])[None, :, :])


def arch(count: int, span: float, rise: float, direction: ArrayLike) -> np.ndarray:
    """(count, 3) points of a circular arch with equal edges, over the origin, ends at height 0.

    Args:
        count: points.
        span: distance between the ends.
        rise: height of the middle, negative to hang.
        direction: horizontal (3,) unit vector of the span.
    """
    share = np.linspace(-1.0, 1.0, count)
    along = np.asarray(direction, dtype=np.float64)
    up = np.array([0.0, 0.0, 1.0])
    if rise == 0:
        return np.asarray(0.5 * span * share[:, None] * along)
    radius = (0.25 * span**2 + rise**2) / (2 * abs(rise))
    half = 2 * np.arctan2(2 * abs(rise), span)
    across = radius * np.sin(half * share)
    height = np.sign(rise) * (radius * np.cos(half * share) - radius + abs(rise))
    return np.asarray(across[:, None] * along + height[:, None] * up)
