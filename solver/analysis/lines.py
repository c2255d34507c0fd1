"""Measures of the lines of a mesh: how they bend beside the surface normal, which are plane."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from solver.mesh.combed import Combed
from solver.mesh.connectivity import IntArray
from solver.mesh.lines import ParameterLine, ParameterLines
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# Vertices of a line up to this number are always in one plane.
_PLANE = 3
# Turns in radians up to which a line is straight.
_STRAIGHT = 1e-9


def bends(mesh: QuadMesh, stars: IntArray, ends: IntArray) -> tuple[FloatArray, FloatArray]:
    """How much lines bend at stars, and at which angle to the surface normal.

    Args:
        mesh: to be measured.
        stars: (n, 5) centre and neighbours in cyclic order; the normal is square to the lines
            through opposite ones.
        ends: (n, 2) vertices before and after on the line.

    Returns:
        (n,) turns in radians, and (n,) angles in radians between the normal and the side to which
        the line bends, positive to the left, in (-pi, pi].
    """
    centre, before, after = (mesh.vertices[k] for k in (stars[:, 0], ends[:, 0], ends[:, 1]))
    spokes = mesh.vertices[stars[:, 1:]]
    normal = unit_rows(np.cross(spokes[:, 0] - spokes[:, 2], spokes[:, 1] - spokes[:, 3]))
    into, out = unit_rows(centre - before), unit_rows(after - centre)
    left = unit_rows(np.cross(normal, into + out))
    upright = unit_rows(np.cross(into + out, left))
    side = out - into
    turn = 2 * np.arctan2(np.linalg.norm(side, axis=1), np.linalg.norm(into + out, axis=1))
    up, across = np.einsum("ij,ij->i", side, upright), np.einsum("ij,ij->i", side, left)
    return turn, np.arctan2(across, up)


def common_tilt(turns: FloatArray, angles: FloatArray) -> float:
    """The tilt in radians, in [0, pi), nearest to those of bends that turn by ``turns`` (n,).

    Lines that do not bend can have any: strips along them stand upright.
    """
    if turns.max(initial=0.0) <= _STRAIGHT:
        return np.pi / 2
    double = (turns**2) @ np.exp(2j * angles)
    return float(np.angle(double) / 2 % np.pi)


def off_tilt(turns: FloatArray, angles: FloatArray, tilt: float) -> FloatArray:
    """(n,) part of each turn that is not at the tilt, in radians."""
    return np.abs(turns * np.sin(angles - tilt))


def family_bends(mesh: QuadMesh, family: int) -> tuple[FloatArray, FloatArray]:
    """The bends of the u (0) or v (1) lines at the stars of a mesh."""
    stars = Combed(mesh.connectivity).stars
    return bends(mesh, stars, stars[:, [3 + family, 1 + family]])


def tilt(mesh: QuadMesh) -> FloatArray:
    """(S,) part of the turns of both lines that is not at the common tilt of their families.

    Where lines cannot be told apart, or which way they run, the common tilt is one that they can
    have all the same: upright or lying, whichever is nearer.
    """
    combed = Combed(mesh.connectivity)
    found = np.zeros(len(combed.stars))
    for family in (0, 1):
        turns, angles = family_bends(mesh, family)
        tilts: list[float] = [0.0, np.pi / 2]
        if combed.oriented and len(turns):
            tilts = [common_tilt(turns, angles)]
        off = [off_tilt(turns, angles, one) for one in tilts]
        found = np.maximum(found, min(off, key=lambda each: float((each**2).sum())))
    return found


def long_lines(mesh: QuadMesh, families: str = "uv") -> list[ParameterLine]:
    """The lines of families that have enough vertices not to lie in a plane by themselves."""
    lines = ParameterLines(mesh.connectivity).all
    return [one for one in lines if one.family in families and len(one.vertices) > _PLANE]


def nearest_plane(points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Unit normal (3,) and centre (3,) of the plane nearest to (n, 3) points."""
    centre = points.mean(axis=0)
    return np.linalg.svd(points - centre, full_matrices=False)[2][2], centre


def off_plane(mesh: QuadMesh, families: str = "uv") -> FloatArray:
    """(E,) distance of the ends of each edge from the plane nearest to its line / mean edge.

    Zero of the edges of other families and of lines of up to three vertices.
    """
    result = np.zeros(len(mesh.connectivity.edges))
    far = np.zeros(len(mesh.vertices))
    for line in long_lines(mesh, families):
        points = mesh.vertices[line.vertices]
        normal, centre = nearest_plane(points)
        far[line.vertices] = np.abs((points - centre) @ normal)
        result[line.edges] = far[mesh.connectivity.edges[line.edges]].max(axis=1)
    return result / mesh.mean_edge


def plane_lines(mesh: QuadMesh) -> FloatArray:
    """(E,) :func:`off_plane` of the family whose lines are nearer to planes of their own."""
    off = [off_plane(mesh, family) for family in "uv"]
    return min(off, key=lambda each: float((each**2).sum()))


def web_parts(mesh: QuadMesh, kind: str) -> list[tuple[IntArray, float]]:
    """What lines a web has, in the way of all that it can have that is nearest to a mesh.

    Args:
        mesh: to be compared.
        kind: a letter for two families of lines and one of diagonals: a asymptotic, g geodesic.

    Returns:
        (S, 2) vertices before and after each star of the ``Combed`` mesh, and the tilt of the
        strips in radians, for the three families.
    """
    combed = Combed(mesh.connectivity)
    stars, corners = combed.stars, combed.diagonal_stars
    tilts = [np.pi / 2 if letter == "a" else 0.0 for letter in kind]
    along = [stars[:, [3 + k, 1 + k]] for k in (0, 1)]
    across = [corners[:, [3 + k, 1 + k]] for k in (0, 1)]
    orders = ((0, 1),) if kind[0] == kind[1] else ((0, 1), (1, 0))
    ways: list[list[IntArray]] = [
        [along[i], along[j], diagonal] for i, j in orders for diagonal in across
    ]

    def miss(way: Iterable[IntArray]) -> float:
        off = [off_tilt(*bends(mesh, stars, e), t) for e, t in zip(way, tilts, strict=True)]
        return float(np.square(off).sum())

    return list(zip(min(ways, key=miss), tilts, strict=True))


def web(mesh: QuadMesh, kind: str = "aag") -> FloatArray:
    """(S,) largest part of the turns of the three lines of a web that is not as it should be."""
    stars = Combed(mesh.connectivity).stars
    off = [off_tilt(*bends(mesh, stars, ends), tilt) for ends, tilt in web_parts(mesh, kind)]
    return np.asarray(np.max(off, axis=0)) if len(stars) else np.zeros(0)
