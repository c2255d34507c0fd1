"""CAD faces on which suites align nets."""

import math

import FreeCAD
import numpy as np
import Part

from freecad_ortho import convert


def roof(rise=900.0, size=2000.0):
    """A B-spline face over 8 m x 6 m, or as many times as large as its size is 2 m."""
    rows = [
        [
            FreeCAD.Vector(size * i, 0.75 * size * j, rise * math.sin(0.9 * i) * math.cos(0.7 * j))
            for j in range(5)
        ]
        for i in range(5)
    ]
    surface = Part.BSplineSurface()
    surface.interpolate(rows)
    return surface.toShape()


def dome():
    """A B-spline face over 30 m x 20 m with four umbilics, as of a dome over a rectangle."""
    across = np.linspace(-0.5, 0.5, 13)
    rows = [
        [
            FreeCAD.Vector(
                3e4 * u, 2e4 * v, 6e3 * math.cos(0.9 * math.pi * u) * math.cos(0.9 * math.pi * v)
            )
            for v in across.tolist()
        ]
        for u in across.tolist()
    ]
    surface = Part.BSplineSurface()
    surface.interpolate(rows)
    return surface.toShape()


def turned(net, line):
    """Mean angle in degrees, 0 to 45, of the edges that begin near a polyline to that."""
    mesh = convert.quad_mesh(net)
    ends = mesh.vertices[mesh.connectivity.edges]
    along = np.diff(line, axis=0)
    apart = np.linalg.norm(ends[:, :1] - line[None, :-1], axis=2)
    near = apart.min(axis=1) < 0.5 * mesh.mean_edge
    run = (ends[:, 1] - ends[:, 0])[near]
    way = along[apart.argmin(axis=1)[near]]
    cosine = (run * way).sum(axis=1) / np.linalg.norm(run, axis=1) / np.linalg.norm(way, axis=1)
    angle = np.degrees(np.arccos(np.clip(np.abs(cosine), 0, 1)))
    return float(np.minimum(angle, 90 - angle).mean())
