"""Turns of a pattern that a strip can have without leaning far, nearest to those wanted.

A ruling square to the axis that leans by phi from the normal n of the osculating plane towards b
(see :mod:`solver.unroll.corner`) makes the pattern turn by delta with

    tan(delta / 2) = tan(kappa / 2) sin(phi),

so a largest lean from the surface normal bounds the turn at every corner. Where a corner is nearly
straight and its osculating plane lies flat, as at the border of a net, the wanted turn may lie
outside. Then the turns are chosen, all within their bounds, that keep the pattern nearest to the
wanted one: with s the lengths along the axis and e the errors of the turns,

    minimise |P S e|^2,   (S e)_i = sum over corners k before i of (s_i - s_k) e_k,

where P takes away the best straight line, which is how the pattern is laid.
"""

from __future__ import annotations

import numpy as np
from scipy.optimize import lsq_linear

from solver.mesh.quadmesh import FloatArray, unit_rows
from solver.unroll.corner import STRAIGHT, Corners
from solver.unroll.strip import refuse_empty_edges

# Weight of the turns themselves beside the offsets that they make, so that there is one solution.
_SMALL = 1e-3


def nearest_turns(
    points: FloatArray, normals: FloatArray, turns: FloatArray, lean: float
) -> FloatArray:
    """(K - 2,) turns of an open axis within reach of a lean.

    Args:
        points: (K, 3) of the axis.
        normals: (K, 3) unit directions to lean from.
        turns: (K - 2,) wanted.
        lean: largest angle from the normals, radians.
    """
    refuse_empty_edges(points)
    along = unit_rows(np.diff(points, axis=0))
    corners = Corners(along[:-1], along[1:], normals[1:-1])
    slope = np.einsum("ck,ck->c", corners.upright, corners.tangent)
    plain = unit_rows(corners.upright - slope[:, None] * corners.tangent)
    angle = np.arcsin(np.clip(np.einsum("ck,ck->c", plain, corners.inward), -1.0, 1.0))
    tangent = np.tan(np.maximum(corners.half_turn, STRAIGHT))
    low, high = (
        2 * np.arctan(tangent * np.sin(np.clip(angle + side * lean, -np.pi / 2, np.pi / 2))) - turns
        for side in (-1, 1)
    )
    if low.max() <= 0 <= high.min():
        return turns
    places = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    offsets = np.maximum(places[:, None] - places[None, 1:-1], 0.0)
    line = np.column_stack([np.ones_like(places), places])
    offsets = offsets - line @ np.linalg.lstsq(line, offsets, rcond=None)[0]
    size = float(np.diff(places).mean())
    system = np.concatenate([offsets / size, _SMALL * np.eye(len(turns))])
    spare = np.maximum(high - low, 1e-12)
    found = lsq_linear(system, np.zeros(len(system)), (low, low + spare))
    return np.asarray(turns + found.x)
