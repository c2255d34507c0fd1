"""Bezier curves: values and slopes, degree elevation, the curve through points; and quadrature."""

from __future__ import annotations

from functools import cache
from math import comb

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray


def bernstein(count: int, t: FloatArray) -> tuple[FloatArray, FloatArray]:
    """(Q, count) Bernstein polynomials of ``count`` control points and their derivatives."""
    values, degree = blend(count, t), count - 1
    slopes = np.zeros_like(values)
    if degree:
        lower = blend(degree, t)
        slopes[:, 1:] += degree * lower
        slopes[:, :-1] -= degree * lower
    return values, slopes


def blend(count: int, t: FloatArray) -> FloatArray:
    """(Q, count) Bernstein polynomials of ``count`` control points."""
    powers, binomial = _powers(count)
    return np.asarray(binomial * t[:, None] ** powers * (1 - t[:, None]) ** powers[::-1])


def raised(poles: FloatArray, count: int) -> FloatArray:
    """(..., count, D) control points of the same curves as (..., P, D), P at most ``count``."""
    while (size := poles.shape[-2]) < count:
        share = np.arange(1, size)[:, None] / size
        inner = share * poles[..., :-1, :] + (1 - share) * poles[..., 1:, :]
        poles = np.concatenate([poles[..., :1, :], inner, poles[..., -1:, :]], axis=-2)
    return poles


def through(points: FloatArray) -> FloatArray:
    """(..., P, D) control points of curves through points at equal steps of their parameter."""
    return np.asarray(_fit(points.shape[-2]) @ points)


@cache
def _fit(count: int) -> FloatArray:
    return np.asarray(np.linalg.inv(blend(count, np.linspace(0.0, 1.0, count))))


@cache
def _powers(count: int) -> tuple[IntArray, FloatArray]:
    """Powers of t in the polynomials, and their factors."""
    return np.arange(count), np.array([comb(count - 1, k) for k in range(count)], dtype=float)


@cache
def gauss(count: int) -> tuple[FloatArray, FloatArray]:
    """Places and weights of Gauss quadrature on [0, 1]."""
    places, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (places + 1), 0.5 * weights
