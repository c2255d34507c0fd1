"""Strips whose rulings follow given directions; their faces may twist about the axis."""

from __future__ import annotations

import numpy as np

from solver.mesh.quadmesh import FloatArray, unit_rows
from solver.unroll.corner import Corners
from solver.unroll.strip import Strip, refuse_empty_edges


def twisted_strip(
    points: FloatArray,
    normals: FloatArray,
    turns: FloatArray | None = None,
    *,
    closed: bool = False,
    follow: bool = False,
) -> Strip:
    """Strip with the rulings nearest to the normals that make its pattern turn as wanted.

    Its rulings stand (nearly) square to the axis, so they meet far outside of any sensible width,
    but its faces are planar only as far as the normals do not turn about the edges.

    Args:
        points: (K, 3) of the axis; a closed one repeats its first point.
        normals: (K, 3) unit directions.
        turns: (K - 2,) turns of the pattern at the inner points, (K - 1,) with the first point of
            a closed axis at the end; None: rulings as the normals, square to the mean direction.
        closed: the last point is the first.
        follow: where no turns are wanted, and at both ends, rulings are the normals themselves,
            slanted to the axis as these are.
    """
    refuse_empty_edges(points)
    along = unit_rows(np.diff(points, axis=0))
    if closed:
        corners = Corners(along, np.roll(along, -1, axis=0), normals[1:])
        inner = normals[1:] if follow and turns is None else _rulings(corners, turns)
        return Strip(points, np.concatenate([inner[-1:], inner]))
    corners = Corners(along[:-1], along[1:], normals[1:-1])
    inner = normals[1:-1] if follow and turns is None else _rulings(corners, turns)
    ends = normals[[0, -1]]
    if follow:
        return Strip(points, np.concatenate([ends[:1], inner, ends[1:]]))
    square = ends - np.einsum("ek,ek->e", ends, along[[0, -1]])[:, None] * along[[0, -1]]
    square = unit_rows(square)
    return Strip(points, np.concatenate([square[:1], inner, square[1:]]))


def _rulings(corners: Corners, turns: FloatArray | None) -> FloatArray:
    if turns is not None:
        return corners.rulings(turns)
    lean = np.einsum("ck,ck->c", corners.upright, corners.tangent)
    return unit_rows(corners.upright - lean[:, None] * corners.tangent)
