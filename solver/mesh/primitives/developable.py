"""Developable surfaces by their rulings: planar faces along each ruling's strip, exactly."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError
from solver.mesh.grid import grid_mesh
from solver.mesh.primitives.limits import between, positive
from solver.mesh.quadmesh import QuadMesh
from solver.multinet.rotational import rotational_net


def cylinder(
    m: int,
    n: int,
    *,
    radius: float = 1.0,
    height: float = 2.0,
    angles: tuple[float, float] = (0.0, 360.0),
) -> QuadMesh:
    """Circular cylinder around z, rulings along v; faces are rectangles.

    Raises:
        InputError: a length that is not positive.
    """
    positive(radius=radius, height=height)
    z = np.linspace(0.0, height, n)
    return rotational_net(np.stack([radius + 0 * z, z], axis=1), m, angles=angles)


def cone(
    m: int,
    n: int,
    *,
    radius: float = 1.0,
    top_radius: float = 0.4,
    height: float = 1.5,
    angles: tuple[float, float] = (0.0, 360.0),
) -> QuadMesh:
    """Circular cone around z, cut off at the top, rulings along v; isosceles trapezoids.

    Raises:
        InputError: a length that is not positive.
    """
    positive(radius=radius, top_radius=top_radius, height=height)
    share = np.linspace(0.0, 1.0, n)
    profile = np.stack([radius + (top_radius - radius) * share, height * share], axis=1)
    return rotational_net(profile, m, angles=angles)


def tangent_developable(
    m: int,
    n: int,
    *,
    spine: ArrayLike | None = None,
    radius: float = 1.0,
    pitch: float = 4.0,
    angle: float = 120.0,
    width: float = 1.0,
) -> QuadMesh:
    """Sheet of the tangents of a spine, by rulings (v) and involutes (u).

    The rulings carry the edges of a polyline, so neighbours meet in a vertex of it, and both are
    cut at equal distances from there: every face is an isosceles trapezoid, exactly planar,
    circular and of equal diagonals, and the strip unrolls exactly.

    Args:
        m: rulings.
        n: vertices on each.
        spine: (m + 1, 3) points of the polyline; by default a helix of radius, pitch and angle.
        radius: of the helix.
        pitch: rise of its turn.
        angle: its turning angle, degrees.
        width: length of the rulings that is used, beyond the end of the spine.

    Raises:
        InputError: a spine of another length, or edges of no length or in one line.
    """
    positive(width=width)
    if spine is None:
        positive(radius=radius, pitch=pitch)
        between(0.0, 3600.0, angle=angle)
        t = np.radians(np.linspace(0.0, angle, m + 1))
        rise = pitch * t / (2 * np.pi)
        points = np.stack([radius * np.cos(t), radius * np.sin(t), rise], axis=1)
    else:
        points = np.asarray(spine, dtype=np.float64)
    if points.shape != (m + 1, 3):
        raise InputError(f"spine: expected {m + 1} points for {m} rulings, got {len(points)}")
    edges = np.diff(points, axis=0)
    lengths = np.linalg.norm(edges, axis=1)
    if not (lengths > 0).all():
        raise InputError("spine: two consecutive points coincide; remove one of them")
    tangents = edges / lengths[:, None]
    bends = np.linalg.norm(np.cross(tangents[1:], tangents[:-1]), axis=1)
    if (bends < 1e-9).any():
        raise InputError("spine: three consecutive points in a line; bend the spine or remove one")
    run = np.concatenate([[0.0], np.cumsum(lengths)])[:-1]
    reach = run[-1] + lengths[-1] + np.linspace(0.02, 1.0, n) * width
    along = reach[None, :] - run[:, None]
    return grid_mesh(points[:-1, None, :] + along[..., None] * tangents[:, None, :])
