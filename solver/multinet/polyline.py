"""Multi-net from a quadric and a polyline on it."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.interpolate import CubicSpline

from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray
from solver.multinet.net import MultiNet
from solver.multinet.quadric import Quadric

# How far, in parts of its size, a polyline may lie off the quadric and still be meant to be on it.
ON_QUADRIC = 1e-6


def multi_net(
    quadric: Quadric,
    polyline: ArrayLike,
    *,
    closed: bool = False,
    snap: bool = False,
    t_range: tuple[float, float] | None = None,
) -> MultiNet:
    """The multi-net v_ij = sqrt(t_j S + I) v_i0 of a polyline v_i0 on a quadric.

    Between its points the curve is a :class:`Spline`, scaled onto the quadric; at s = i / (n - 1)
    (i / n where closed) it passes through point i.

    Args:
        quadric: the quadric.
        polyline: (n, 3) points on it, in the model's unit; a closed one does not repeat its start.
        closed: join the last point with the first.
        snap: move points that lie off the quadric to its nearest points first.
        t_range: default ends of t.

    Raises:
        InputError: too few points, repeated points, or a point off the quadric.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 3.2.
    """
    points = np.array(polyline, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3 or len(points) < 2 + closed:
        raise InputError(
            f"polyline: expected at least {2 + closed} points of three coordinates, got an array "
            f"of shape {points.shape}"
        )
    if not np.isfinite(points).all():
        raise InputError("polyline: expected finite numbers, got NaN or infinite ones; mend it")
    if snap:
        points = quadric.project(points)
    _check(quadric, points)
    return MultiNet(quadric, Spline(points, closed), closed=closed, t_range=t_range)


def _check(quadric: Quadric, points: FloatArray) -> None:
    size = float(np.linalg.norm(points.max(axis=0) - points.min(axis=0)))
    distance = quadric.distance(points)
    worst = int(np.argmax(distance))
    if distance[worst] > ON_QUADRIC * size:
        raise InputError(
            f"polyline: expected points on the {quadric.kind}, point {worst} lies "
            f"{distance[worst]:.3g} off it; snap the points to it first"
        )
    if (quadric.curvatures > 0).sum() == 1 and (quadric.curvatures < 0).any():
        axis = int(np.argmax(quadric.curvatures))
        sheet = np.sign(quadric.to_frame(points)[:, axis])
        if (sheet != sheet[0]).any():
            raise InputError(
                "polyline: jumps from one sheet of the hyperboloid to the other at point "
                f"{int(np.argmax(sheet != sheet[0]))}; stay on one sheet"
            )


class Spline:
    """Interpolating curve through (n, k) points; s = i / (n - 1) at point i, i / n where closed.

    A cubic spline over centripetal knots, which does not overshoot where points lie unevenly.

    Source: Lee (1989), Choosing nodes in parametric curve interpolation.

    Raises:
        InputError: two consecutive points coincide.
    """

    def __init__(self, points: FloatArray, closed: bool) -> None:
        through = np.concatenate([points, points[:1]]) if closed else points
        steps = np.linalg.norm(np.diff(through, axis=0), axis=1)
        if not (steps > 1e-12 * steps.sum()).all():
            raise InputError(
                "curve: two consecutive points coincide; remove one (a closed curve does not "
                "repeat its start)"
            )
        self._points, self._last = through, len(through) - 1
        self._knots = np.concatenate([[0.0], np.cumsum(np.sqrt(steps))])
        ends = "periodic" if closed else "natural"
        self._curve = CubicSpline(self._knots, through, bc_type=ends)

    def __call__(self, s: FloatArray) -> FloatArray:
        """(m, k) points at parameters s; exactly the given points at theirs."""
        place = np.asarray(s) * self._last
        nearest = np.clip(np.rint(place), 0, self._last).astype(np.int64)
        at_knot = np.abs(place - nearest) < 1e-9
        knot = np.interp(place, np.arange(self._last + 1), self._knots)
        return np.where(at_knot[:, None], self._points[nearest], self._curve(knot))
