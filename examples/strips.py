"""Lamellas for the gallery: straight developable strips along the lines of an asymptotic net."""

from __future__ import annotations

import math

import numpy as np

from solver import QuadMesh
from solver.mesh.lines import ParameterLines
from solver.mesh.quadmesh import unit_rows
from solver.unroll.axes import strip_axes
from solver.unroll.measures import straightness
from solver.unroll.planes import developable_strip


def straight_strips(mesh: QuadMesh, width: float) -> tuple[QuadMesh, QuadMesh, float]:
    """Outlines of strips along all lines of three edges or more.

    Returns:
        The strips in space, their patterns one above the other in the plane z = 0, and the largest
        distance of the axis of a pattern from a straight line, in the mesh's unit.
    """
    axes = strip_axes(mesh, math.inf)
    space, flat, worst, shelf = [], [], 0.0, 0.0
    for line in ParameterLines(mesh.connectivity).all:
        if len(line.vertices) < 4 or line.closed:
            continue
        points, normals = mesh.vertices[line.vertices], axes[line.vertices]
        strip = developable_strip(points, normals, np.zeros(len(points) - 2), width=width)
        start, end = strip.across
        half = width / 2 * unit_rows(np.append(start, end[-1:], 0) + np.append(start[:1], end, 0))
        space.append(ribbon(points + half, points - half))
        ends, side = strip.flat_points[[0, -1]], np.array([0.0, width / 2])
        sides = [np.pad(ends + k * side, ((0, 0), (0, 1))) + [0, shelf, 0] for k in (1, -1)]
        flat.append(ribbon(*sides))
        worst, shelf = max(worst, straightness(strip.flat_points)), shelf - 2 * width
    return joined(space), joined(flat), worst


def ribbon(one: np.ndarray, two: np.ndarray) -> QuadMesh:
    """Quads between two polylines (n, 3)."""
    k = np.arange(len(one) - 1)
    faces = np.stack([k, k + 1, k + 1 + len(one), k + len(one)], axis=1)
    return QuadMesh(np.concatenate([one, two]), faces)


def joined(parts: list[QuadMesh]) -> QuadMesh:
    """Several meshes as one, nothing merged."""
    offsets = np.cumsum([0] + [len(part.vertices) for part in parts[:-1]])
    faces = np.concatenate([p.faces + o for p, o in zip(parts, offsets, strict=True)])
    return QuadMesh(np.concatenate([part.vertices for part in parts]), faces)


def fans(points: np.ndarray, triangles: np.ndarray) -> QuadMesh:
    """Triangles as quads with a straight corner, to be drawn."""
    middles = points[triangles[:, [0, 2]]].mean(axis=1)
    fourth = len(points) + np.arange(len(triangles))
    return QuadMesh(np.concatenate([points, middles]), np.c_[triangles, fourth])
