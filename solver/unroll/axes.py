"""Directions that the strips along both families share at each vertex."""

from __future__ import annotations

import math

import numpy as np

from solver.analysis.measures import star_spokes
from solver.analysis.spheres import star_centres
from solver.errors import InputError
from solver.mesh.combed import Combed
from solver.mesh.lines import ParameterLines
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.unroll.strip import refuse_empty_edges

# Sine of an angle below which two strips are one, and lines have no direction.
_MEET = 1e-9


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


def tilted_axes(mesh: QuadMesh, tilts: tuple[float, float]) -> FloatArray:
    """(V, 3) unit directions that strips along both families share where they tilt.

    The strip along a line of direction t, at an angle to the surface of normal n, has the normal
    b = cos(tilt) n + sin(tilt) (n x t), to which a pseudo-geodesic line of that tilt bends. The two
    strips of a vertex meet in the line square to both such normals. That is square to how either
    line bends, so that strips with these rulings unroll straight.

    Args:
        mesh: of which directions of lines can be told apart.
        tilts: of the families u and v, in radians, pi / 2 upright.

    Source: Wang et al. (2023), Rectifying strip patterns.
    """
    normals = mesh.vertex_normals.copy()
    stars = mesh.connectivity.stars
    a, b = (mesh.vertices[stars[:, k]] - mesh.vertices[stars[:, k + 2]] for k in (1, 2))
    normals[stars[:, 0]] = unit_rows(np.cross(a, b))
    bent = []
    for tangent, tilt in zip(_tangents(mesh), tilts, strict=True):
        left = unit_rows(np.cross(normals, tangent))
        upright = np.cross(tangent, left)
        bent.append(math.cos(tilt) * upright + math.sin(tilt) * left)
    both = np.cross(bent[0], bent[1])
    side = np.where(np.einsum("vk,vk->v", both, normals) < 0, -1.0, 1.0)
    size = np.linalg.norm(both, axis=1)
    return np.where((size > _MEET)[:, None], side[:, None] * unit_rows(both), normals)


def _tangents(mesh: QuadMesh) -> list[FloatArray]:
    """(V, 3) unit directions of the u and of the v lines; square to the normal where none runs."""
    net = mesh.connectivity
    family, sign = ParameterLines(net).edge_family, Combed(net).edge_signs
    start, end = net.edges.T
    along = sign[:, None] * unit_rows(mesh.vertices[end] - mesh.vertices[start])
    found = []
    for number in (0, 1):
        total = np.zeros_like(mesh.vertices)
        for vertex in (start, end):
            np.add.at(total, vertex[family == number], along[family == number])
        found.append(total)
    for own, other in ((0, 1), (1, 0)):
        alone = np.linalg.norm(found[own], axis=1) <= _MEET
        turned = np.cross(mesh.vertex_normals[alone], found[other][alone])
        found[own][alone] = turned if other else -turned
    return [unit_rows(each) for each in found]


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
