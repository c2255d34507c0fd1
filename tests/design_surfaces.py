"""Surfaces by formula, as triangles: what nets are aligned on in these tests."""

import numpy as np


def triangles(formula, nu=61, nv=37):
    """Points (V, 3) and triangles (T, 3) of a formula on the unit square."""
    u, v = np.meshgrid(np.linspace(0, 1, nu), np.linspace(0, 1, nv), indexing="ij")
    points = np.stack(np.broadcast_arrays(*formula(u, v)), axis=-1).reshape(-1, 3)
    k = np.arange(nu * nv).reshape(nu, nv)
    quads = np.stack([k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]], axis=-1).reshape(-1, 4)
    return points, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def barrel(u, v):
    """Curved in both directions, more in one; its parameters are no lines of curvature."""
    w = v - 0.5
    height = 5 * np.cos(np.pi * w) * (1 + 0.4 * np.sin(2 * u))
    return 30 * u + 4 * w, 18 * w * (1 + 0.25 * u), height


def saddle(u, v):
    """Bent both ways everywhere."""
    u, v = u - 0.5, v - 0.5
    return 30 * u + 3 * v, 20 * v - 4 * u, 12 * u**2 - 20 * v**2 + 2 * u * v


def dome(u, v):
    """A dome over a rectangle, with umbilics."""
    u, v = u - 0.5, v - 0.5
    return 30 * u, 20 * v, 6 * np.cos(0.9 * np.pi * u) * np.cos(0.9 * np.pi * v)


def catenoid(u, v):
    """A minimal surface along its lines of curvature."""
    height, angle = 6 * (u - 0.5), 1.2 * np.pi * v
    radius = 5 * np.cosh(height / 5)
    return radius * np.cos(angle), radius * np.sin(angle), height


def plane(u, v):
    """Flat."""
    return 12 * u, 8 * v, 0 * u


def cap(u, v):
    """A part of a sphere of radius 10."""
    x, y = 8 * (u - 0.5), 8 * (v - 0.5)
    return x, y, np.sqrt(100 - x**2 - y**2)


def without(points, faces, inside):
    """The triangles whose centres are not in a region, with the points that they use."""
    kept = faces[~inside(points[faces].mean(axis=1))]
    used, numbers = np.unique(kept, return_inverse=True)
    return points[used], numbers.reshape(-1, 3)
