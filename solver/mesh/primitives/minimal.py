"""Minimal surfaces by their asymptotic lines (orthogonal on them) or by curvature lines."""

from __future__ import annotations

from typing import Literal

import numpy as np
from scipy.special import ellipj, ellipkinc

from solver.errors import InputError
from solver.mesh.grid import grid_mesh
from solver.mesh.primitives.limits import between, positive
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.multinet.rotational import rotational_net
from solver.option import one_of

Lines = Literal["asymptotic", "principal"]


def helicoid(
    m: int,
    n: int,
    *,
    lines: Lines = "asymptotic",
    pitch: float = 2 * np.pi,
    radius: float = 1.0,
    angles: tuple[float, float] = (0.0, 360.0),
) -> QuadMesh:
    """Helicoid around z, radii from -radius to radius.

    Asymptotic: helices (u) and rulings (v); stars exactly planar, diagonals exactly equal, a
    multi-net. Principal: their bisectors over a square; faces exactly planar, diagonals equal to
    second order; there ``angles`` only turns it.

    Args:
        m: vertices along u.
        n: vertices along v.
        lines: asymptotic or principal.
        pitch: rise of a turn.
        radius: half the length of the rulings.
        angles: first and last turning angle, degrees.

    Raises:
        InputError: a length that is not positive, or an empty span.
    """
    positive(radius=radius)
    rise = pitch / (2 * np.pi)
    if _asymptotic(lines):
        angle, r = np.radians(np.linspace(*_span(angles), m)), np.linspace(-radius, radius, n)
        t, s = angle[:, None] + 0 * r, 0 * angle[:, None] + r
    else:
        positive(pitch=pitch)
        span = np.arcsinh(radius / rise)
        p, q = _square(m, n)
        t, s = span * (p + q) + np.radians(angles[0]), rise * np.sinh(span * (q - p))
    return grid_mesh(np.stack([s * np.cos(t), s * np.sin(t), rise * t], axis=2))


def catenoid(
    m: int,
    n: int,
    *,
    lines: Lines = "principal",
    waist: float = 1.0,
    height: float = 1.5,
    angles: tuple[float, float] = (0.0, 360.0),
) -> QuadMesh:
    """Catenoid around z, from -height / 2 to height / 2.

    Principal: meridians and parallels, exactly planar, equal diagonals, circular, a multi-net.
    Asymptotic: their bisectors; stars planar to third, diagonals equal to second order.

    Raises:
        InputError: a length that is not positive.
    """
    positive(waist=waist, height=height)
    end = 0.5 * height / waist
    if not _asymptotic(lines):
        u = np.linspace(-end, end, n)
        return rotational_net(waist * np.stack([np.cosh(u), u], axis=1), m, angles=angles)
    p, q = _square(m, n)
    u, v = end * (p + q), end * (q - p)
    radius = waist * np.cosh(u)
    return grid_mesh(np.stack([radius * np.cos(v), radius * np.sin(v), waist * u], axis=2))


def enneper(
    m: int, n: int, *, lines: Lines = "asymptotic", reach: float = 1.0, size: float = 1.0
) -> QuadMesh:
    """Enneper's surface over the square |u|, |v| <= reach (turned by 45 degrees for asymptotic).

    Stars (asymptotic) or faces (principal) exactly planar, diagonals equal to second order.

    Raises:
        InputError: a reach outside 0 to 1.7 (beyond, the surface meets itself).
    """
    between(0.0, np.sqrt(3.0), reach=reach)
    positive(size=size)
    p, q = _square(m, n)
    u, v = (p + q, q - p) if _asymptotic(lines) else (2 * p, 2 * q)
    u, v = reach * u, reach * v
    x = u - u**3 / 3 + u * v**2
    y = -v + v**3 / 3 - u**2 * v
    return grid_mesh(size * np.stack([x, -y, u**2 - v**2], axis=2))


def scherk(
    m: int, n: int, *, lines: Lines = "asymptotic", reach: float = 1.5, size: float = 1.0
) -> QuadMesh:
    """Scherk's surface z = ln(cos y / cos x).

    With cos x = 1 / cosh p and cos y = 1 / cosh q the asymptotic lines are s = p + q = const and
    t = p - q = const. Stars planar to third, diagonals equal to second order. The metric

        cosh s cosh t / (cosh s + cosh t) (ds^2 / cosh s + dt^2 / cosh t)

    makes sigma = int ds / sqrt(cosh s), and tau of t likewise, conformal: their bisectors are the
    principal lines. There s = arsinh(sqrt(2) sn dn / cn^2) of sigma / sqrt(2) and m = 1/2. Faces
    planar to fifth, diagonals equal to second order.

    Raises:
        InputError: a length that is not positive.
    """
    positive(reach=reach, size=size)
    a, b = _square(m, n)
    if _asymptotic(lines):
        s, t = 2 * reach * b, 2 * reach * a
    else:
        half = np.sqrt(2) * np.sin(0.5 * np.arccos(1 / np.cosh(reach)))
        end = ellipkinc(np.arcsin(half), 0.5)
        s, t = _lemniscatic(end * (a + b)), _lemniscatic(end * (b - a))
    p, q = 0.5 * (s + t), 0.5 * (s - t)
    x, y = np.arctan(np.sinh(p)), np.arctan(np.sinh(q))
    return grid_mesh(size * np.stack([x, y, np.log(np.cosh(p) / np.cosh(q))], axis=2))


def _lemniscatic(sigma: FloatArray) -> FloatArray:
    """The s whose integral of 1 / sqrt(cosh s) from 0 is sqrt(2) ``sigma``."""
    sn, cn, dn, _ = ellipj(sigma, 0.5)
    return np.asarray(np.arcsinh(np.sqrt(2) * sn * dn / cn**2))


def _asymptotic(lines: str) -> bool:
    one_of("lines", lines, ("asymptotic", "principal"))
    return lines == "asymptotic"


def _square(m: int, n: int) -> tuple[FloatArray, FloatArray]:
    """(m, n) parameters from -1/2 to 1/2."""
    p, q = np.meshgrid(np.linspace(-0.5, 0.5, m), np.linspace(-0.5, 0.5, n), indexing="ij")
    return p, q


def _span(angles: tuple[float, float]) -> tuple[float, float]:
    if not angles[1] > angles[0]:
        raise InputError(f"angles: expected first < last, got {angles[0]:g} to {angles[1]:g}")
    return angles
