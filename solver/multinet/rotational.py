"""Rotational multi-nets: meridians and parallel circles, all parameter lines planar."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError
from solver.mesh.grid import grid_mesh
from solver.mesh.quadmesh import FloatArray, QuadMesh


def rotational_net(
    profile: ArrayLike,
    sides: int,
    *,
    angles: tuple[float, float] = (0.0, 360.0),
) -> QuadMesh:
    """Net of a profile turned about the z axis; i along the parallels, j along the profile.

    Every rectangle is an isosceles trapezoid: the net is an exact multi-net, and principal and
    circular as well, whatever the profile and the angles.

    Args:
        profile: (N, 2) radius and height of its points, radii positive, in the model's unit.
        sides: number M of meridians.
        angles: first and last meridian in degrees; a whole turn closes the parallels.

    Raises:
        InputError: radii that are not positive, or too few points or meridians.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 3.2, and its
    reference 20.
    """
    points = np.asarray(profile, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 2 or len(points) < 2:
        raise InputError(
            f"profile: expected at least two points (radius, height), got shape {points.shape}"
        )
    if not (points[:, 0] > 0).all():
        bad = int(np.argmin(points[:, 0]))
        raise InputError(
            f"profile: expected positive radii, point {bad} has {points[bad, 0]:g}; "
            "stop short of the axis"
        )
    angle, closed = meridians(sides, angles)
    radius, height = points.T
    x, y = np.cos(angle)[:, None] * radius, np.sin(angle)[:, None] * radius
    return grid_mesh(np.stack([x, y, 0 * x + height], axis=2), closed_u=closed)


def meridians(sides: int, angles: tuple[float, float]) -> tuple[FloatArray, bool]:
    """(M,) angles in radians, and whether they close.

    Raises:
        InputError: an empty span or more than a turn.
    """
    span = angles[1] - angles[0]
    if not 0 < span <= 360.0 + 1e-9:
        raise InputError(
            f"angles: expected a span up to 360 degrees, got {angles[0]:g} to {angles[1]:g}"
        )
    closed = span >= 360.0 - 1e-9
    count = max(int(sides), 0) + closed
    return np.radians(np.linspace(angles[0], angles[1], count)[: count - closed]), closed
