"""Triangles on a surface of which a side shrinks to a point, as a dome's does at its crown."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.mesh.sampling import ParametricSurface, sampled

# Points along a line in which lengths are measured; lines across them.
_FINE, _LINES = 129, 9
# A side or a gap shorter than this part of the size is a point.
_POINT = 1e-6
# Triangles that meet in the point of a closed ring, at least.
_FEWEST = 6


def stand_in(surfaces: Sequence[ParametricSurface], edge: float) -> tuple[FloatArray, IntArray]:
    """Points (V, 3) and triangles (T, 3) on faces, with edges of about a length.

    Raises:
        InputError: faces that cannot be sampled.
    """
    crowned = triangles_round_poles(surfaces[0], edge) if len(surfaces) == 1 else None
    if crowned is not None:
        return crowned
    made = TriangleSurface.from_quads(sampled(surfaces, edge=edge).mesh)
    return made.vertices, made.triangles


def triangles_round_poles(
    surface: ParametricSurface, edge: float
) -> tuple[FloatArray, IntArray] | None:
    """Even triangles on a surface with a side that is a point: rings round it.

    With equal counts on all rings points would crowd near it, and field and map follow them.

    Args:
        surface: with one such side, or two opposite ones.
        edge: wanted length of edges.

    Returns:
        points (V, 3) and triangles (T, 3); None where no side is a point, or where a border trims
        the surface.
    """
    if surface.inside is not None:
        return None
    for along in (0, 1):
        grid = _grid(surface, along)
        size = float(np.linalg.norm(np.ptp(grid.reshape(-1, 3), axis=0)))
        around = np.linalg.norm(np.diff(grid, axis=1), axis=2).sum(axis=1)
        if min(around[0], around[-1]) < _POINT * size:
            break
    else:
        return None
    closed = bool(np.abs(grid[:, 0] - grid[:, -1]).max() < _POINT * size)
    steps = np.linalg.norm(np.diff(grid, axis=0), axis=2).mean(axis=1)
    run = np.append(0.0, np.cumsum(steps))
    count = max(round(run[-1] / edge), 2)
    ends = (surface.u, surface.v)[along]
    rows = np.interp(np.linspace(0, run[-1], count + 1), run, np.linspace(*ends, _FINE))
    rings = [_ring(surface, along, float(row), edge, closed, _POINT * size) for row in rows]
    points = np.concatenate(rings)
    numbers = np.split(np.arange(len(points)), np.cumsum([len(ring) for ring in rings])[:-1])
    triangles = np.concatenate([_between(*pair, closed) for pair in pairwise(numbers)])
    # Rows go along u or v; the side that a face shows stays the same.
    return points, triangles if along == 1 else triangles[:, ::-1]


def _grid(surface: ParametricSurface, along: int) -> FloatArray:
    """(_FINE, _FINE, 3) points, the direction that runs to the point first."""
    u, v = (np.linspace(*ends, _FINE) for ends in (surface.u, surface.v))
    grid = surface.grid(u, v)
    return grid if along == 0 else grid.transpose(1, 0, 2)


def _ring(
    surface: ParametricSurface, along: int, row: float, edge: float, closed: bool, point: float
) -> FloatArray:
    """Points at even lengths round the point; one where the ring has shrunk to it."""
    across = np.linspace(*(surface.v, surface.u)[along], _FINE)
    rows = np.full(_FINE, row)
    line = surface.evaluate(*((rows, across) if along == 0 else (across, rows)))
    run = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1)))
    if run[-1] < point:
        return line[:1]
    count = max(round(run[-1] / edge), _FEWEST if closed else 1)
    places = np.interp(np.linspace(0, run[-1], count + 1), run, across)
    places[0], places[-1] = across[0], across[-1]
    places = places[:-1] if closed else places
    rows = np.full(len(places), row)
    found: FloatArray = surface.evaluate(*((rows, places) if along == 0 else (places, rows)))
    return found


def _between(one: IntArray, two: IntArray, closed: bool) -> IntArray:
    """Triangles between two rings, whichever has its next point first."""
    first, second = (np.append(x, x[:1]) if closed and len(x) > 1 else x for x in (one, two))
    (many, others), found = (len(first) - 1, len(second) - 1), []
    i = j = 0
    while i < many or j < others:
        if j == others or (i < many and (i + 1) * others <= (j + 1) * many):
            found.append((first[i], first[i + 1], second[j]))
            i += 1
        else:
            found.append((first[i], second[j + 1], second[j]))
            j += 1
    return np.array(found)
