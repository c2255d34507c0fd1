"""Rotational surfaces by meridians and parallels, and the unduloid."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import ellipe, ellipk

from solver.errors import InputError
from solver.mesh.grid import grid_mesh
from solver.mesh.primitives.limits import between, positive
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.multinet.rotational import rotational_net
from solver.option import one_of


def rotational(
    m: int, profile: ArrayLike, *, angles: tuple[float, float] = (0.0, 360.0)
) -> QuadMesh:
    """Profile (n, 2) of radius and height turned about z: faces are isosceles trapezoids.

    Exactly planar, equal diagonals, circular, and a multi-net.

    Raises:
        InputError: a profile that reaches the axis, or too few points.
    """
    return rotational_net(profile, m, angles=angles)


def sphere(
    m: int,
    n: int,
    *,
    radius: float = 1.0,
    angles: tuple[float, float] = (0.0, 360.0),
    latitudes: tuple[float, float] = (-75.0, 75.0),
) -> QuadMesh:
    """Sphere by meridians and parallels; planar, circular, equal diagonals, vertices on the sphere.

    Raises:
        InputError: a radius that is not positive, or latitudes that reach the poles.
    """
    positive(radius=radius)
    between(-90.0, 90.0, **{"first latitude": latitudes[0], "last latitude": latitudes[1]})
    latitude = np.radians(np.linspace(*latitudes, n))
    profile = radius * np.stack([np.cos(latitude), np.sin(latitude)], axis=1)
    return rotational_net(profile, m, angles=angles)


def unduloid(
    m: int,
    n: int,
    *,
    widest: float = 1.0,
    narrowest: float = 0.4,
    periods: float = 1.0,
    lines: Literal["principal", "cmc"] = "principal",
) -> QuadMesh:
    """Unduloid (Delaunay), mean curvature 1 / (widest + narrowest) as the mean of both principals.

    With ``principal`` lines its meridians and parallels, exactly planar with equal diagonals, m of
    them around. With ``cmc`` lines the bisectors of the curvature lines, whose stars lie on spheres
    of radius widest + narrowest in the limit (to second order): a rectangle of m x n lines around
    the widest place, spanning ``periods`` periods from corner to corner.

    Source: Delaunay (1841); radius a dn, a = widest, in conformal parameters.

    Raises:
        InputError: unless widest > narrowest > 0 and periods > 0.
    """
    positive(narrowest=narrowest, periods=periods)
    if not widest > narrowest:
        raise InputError(
            f"widest: expected more than narrowest = {narrowest:g}, got {widest:g}; exchange them"
        )
    half = _half_period(widest, narrowest)
    if lines == "principal":
        radius, height = _profile(np.linspace(-1, 1, n) * periods * half, widest, narrowest)
        return rotational_net(np.stack([radius, height], axis=1), m)
    one_of("lines", lines, ("principal", "cmc"))
    p, q = np.meshgrid(np.linspace(-0.5, 0.5, m), np.linspace(-0.5, 0.5, n), indexing="ij")
    along, around = periods * half * (p + q), periods * half * (q - p)
    radius, height = _profile(along, widest, narrowest)
    points = np.stack([radius * np.cos(around), radius * np.sin(around), height], axis=2)
    return grid_mesh(points)


def _half_period(a: float, b: float) -> float:
    return float(ellipk(1 - (b / a) ** 2)) * (a + b) / a


def _profile(u: FloatArray, a: float, b: float) -> tuple[FloatArray, FloatArray]:
    """Radius and height at conformal parameters u, r = a dn(a u / (a + b))."""
    modulus = 1 - (b / a) ** 2
    dn, second = _jacobi(a * u / (a + b), modulus)
    return a * dn, a * second + a * b * u / (a + b)


def _jacobi(u: FloatArray, modulus: float) -> tuple[FloatArray, FloatArray]:
    """dn(u) and the integral of dn^2 from 0 to u, by the arithmetic-geometric mean.

    Not scipy.special.ellipeinc: version 1.17 is wrong by several percent at single arguments.

    Source: Abramowitz, Stegun (1964), 16.4 and 17.6.
    """
    mean, other = 1.0, float(np.sqrt(1 - modulus))
    halves: list[float] = []
    ratios: list[float] = []
    while mean - other > 1e-15 and len(halves) < 20:
        halves.append(0.5 * (mean - other))
        mean, other = 0.5 * (mean + other), float(np.sqrt(mean * other))
        ratios.append(halves[-1] / mean)
    angle = 2.0 ** len(ratios) * mean * np.asarray(u)
    second = float(ellipe(modulus) / ellipk(modulus)) * np.asarray(u)
    for half, ratio in zip(reversed(halves), reversed(ratios), strict=True):
        second = second + half * np.sin(angle)
        angle = 0.5 * (angle + np.arcsin(ratio * np.sin(angle)))
    return np.sqrt(1 - modulus * np.sin(angle) ** 2), second
