"""Directions that the strips along both families share at each vertex."""

from __future__ import annotations

import math

import numpy as np

from solver.analysis.measures import star_spokes
from solver.analysis.spheres import star_centres
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.unroll.strip import refuse_empty_edges


def strip_axes(mesh: QuadMesh, radius: float | None = None) -> FloatArray:
    """(V, 3) unit directions, near the vertex normals, that standing strips contain.

    With ``radius`` (signed, positive towards the normals; inf for planar stars) they are, at inner
    stars, the normals of the star spheres of that radius: the rulings of strips that unroll to arcs
    of that radius (to straight strips) in both families at once, exactly so on an exact net.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, sections 4.3 and 4.4.
    """
    result = mesh.vertex_normals.copy()
    if radius is None or not len(mesh.connectivity.stars):
        return result
    centres = mesh.connectivity.stars[:, 0]
    if math.isinf(radius):
        normal = np.linalg.svd(star_spokes(mesh))[2][:, 2]
        side = np.einsum("sk,sk->s", normal, result[centres])
        result[centres] = np.where(side < 0, -1.0, 1.0)[:, None] * normal
    else:
        result[centres] = math.copysign(1.0, radius) * unit_rows(star_centres(mesh, radius))
    return result


def arc_turns(points: FloatArray, radius: float, closed: bool = False) -> FloatArray:
    """Turns that put the points of a polyline on a circle in the pattern.

    Args:
        points: (K, 3), a closed polyline repeats its first point.
        radius: signed, positive when the centre lies where the rulings point; inf: straight.
        closed: add the turn at the first point, at the end.

    Returns:
        (K - 2,) turns at the inner points, (K - 1,) of a closed polyline.

    Raises:
        InputError: an edge is longer than the circle is wide.
    """
    refuse_empty_edges(points)
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)
    if lengths.max() >= 2 * abs(radius):
        raise InputError(
            f"radius: expected more than half the longest edge, {lengths.max() / 2:.4g}, got "
            f"{abs(radius):.4g}; optimise the net for a larger radius"
        )
    half = np.arcsin(lengths / (2 * radius))
    turns = half[:-1] + half[1:]
    return np.append(turns, half[-1] + half[0]) if closed else turns
