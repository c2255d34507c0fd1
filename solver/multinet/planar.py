"""Multi-nets in the plane: confocal conics (Ivory's theorem)."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError
from solver.mesh.grid import grid_mesh
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.multinet.net import MultiNet
from solver.multinet.quadric import Quadric


def confocal_conics(
    a: float,
    b: float,
    *,
    angles: tuple[float, float] = (0.0, 360.0),
    t_range: tuple[float, float] | None = None,
) -> MultiNet:
    """Net of the confocal ellipses x^2/(a + t) + y^2/(b + t) = 1 and their hyperbolas, z = 0.

    Args:
        a: square of the larger semi-axis for t = 0.
        b: square of the smaller one.
        angles: first and last eccentric angle along the ellipse t = 0, in degrees; a whole turn
            closes the ellipses.
        t_range: default ends of t, by default 0 to a.

    Raises:
        InputError: unless a > b > 0 and the angles span at most a turn.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, theorem 5.
    """
    if not (np.isfinite([a, b]).all() and a > b > 0):
        raise InputError(f"axes: expected a > b > 0, got {a:g}, {b:g}; give the larger one first")
    first, last = np.radians(angles)
    turn = 2 * np.pi
    if not 0 < last - first <= turn * (1 + 1e-12):
        raise InputError(
            f"angles: expected a span up to 360 degrees, got {angles[0]:g} to {angles[1]:g}"
        )

    def ellipse(s: FloatArray) -> FloatArray:
        angle = first + (last - first) * s
        return np.stack([np.sqrt(a) * np.cos(angle), np.sqrt(b) * np.sin(angle), 0 * s], axis=1)

    closed = bool(last - first >= turn * (1 - 1e-12))
    ends = (0.0, float(a)) if t_range is None else t_range
    return MultiNet(Quadric(np.array([1 / a, 1 / b, 0.0])), ellipse, 0.0, closed, ends)


def confocal_parabolas(u: ArrayLike, v: ArrayLike) -> QuadMesh:
    """Net of two families of confocal parabolas, focus at the origin, axis x, z = 0.

    Args:
        u: (M,) increasing parameters of the parabolas that open to the left, square root of length.
        v: (N,) increasing parameters of those that open to the right; one of u and v positive.

    Raises:
        InputError: parameters that do not increase.
    """
    one, two = increasing("u", u), increasing("v", v)
    x = 0.5 * (one[:, None] ** 2 - two[None, :] ** 2)
    y = one[:, None] * two[None, :]
    return grid_mesh(np.stack([x, y, 0 * x], axis=2))


def increasing(name: str, values: ArrayLike) -> FloatArray:
    """(n,) float64 values, strictly increasing and at least two.

    Raises:
        InputError: they are not.
    """
    array = np.asarray(values, dtype=np.float64)
    if array.ndim != 1 or len(array) < 2 or not (np.diff(array) > 0).all():
        raise InputError(f"{name}: expected at least two increasing numbers; sort them")
    return array
