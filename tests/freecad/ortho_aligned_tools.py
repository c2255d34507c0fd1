"""CAD faces on which suites align nets."""

import math

import FreeCAD
import Part


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
