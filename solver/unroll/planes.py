"""Developable strips: planes through the edges, rulings where neighbouring planes meet.

Each plane is free to turn about its edge by one angle. The angles nearest to zero (the wanted
directions) that make the pattern turn as wanted at every corner solve

    minimise |theta|^2   subject to   sin((alpha + beta) / 2) = q cos((alpha - beta) / 2)

at every corner, where alpha and beta are the leans of the planes before and after (see
:mod:`solver.unroll.corner`). Where a corner is straight the equation says nothing about the planes:
there both shall be the same plane, so that the ruling does not fall into the axis.

Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, sections 4.3 and 4.4.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.linalg import solveh_banded

from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, unit_rows
from solver.unroll.corner import Corners
from solver.unroll.strip import Strip, refuse_empty_edges

# Newton steps at most, the largest turn in one, radians, as a larger one overshoots, and the turn
# of each plane below which they are solved.
_STEPS = 60
_LARGEST_STEP = 0.3
_SOLVED = 1e-14
# Added to the diagonal of equations that repeat each other.
_DAMPING = 1e-15
# Residual up to which they hold.
_HOLDS = 1e-9
# Offsets of alternating sign that are tried when rulings meet inside the width, radians.
_TRIALS = tuple(sign * 0.005 * 2.0**k for k in range(6) for sign in (1, -1))


def wanted_directions(points: FloatArray, normals: FloatArray) -> FloatArray:
    """(K - 1, 3) unit vectors normal to each edge, from the mean of the normals at its ends."""
    along = unit_rows(np.diff(points, axis=0))
    mean = normals[:-1] + normals[1:]
    return unit_rows(mean - np.einsum("ek,ek->e", mean, along)[:, None] * along)


def developable_strip(
    points: FloatArray,
    normals: FloatArray,
    turns: FloatArray | None = None,
    *,
    width: float = 0.0,
    closed: bool = False,
) -> Strip:
    """Strip of planar faces whose planes are nearest to the normals.

    Args:
        points: (K, 3) of the axis; a closed one repeats its first point.
        normals: (K, 3) unit directions that the strip's planes shall contain.
        turns: (K - 2,) by how much the pattern shall turn at the inner points; None leaves the
            pattern free and puts the planes through the mean normals of their edges.
        width: where the rulings nearest to the normals meet inside this width, planes farther from
            the normals are tried.
        closed: the last point is the first.

    Raises:
        InputError: no planes make the pattern turn so.
    """
    refuse_empty_edges(points)
    along = unit_rows(np.diff(points, axis=0))
    toward = wanted_directions(points, normals)
    if turns is None:
        return _strip(points, normals, toward, closed)
    planes = _Planes(points, normals, toward, turns)
    solved = planes.angles(np.zeros(len(toward)))
    if solved is None:
        raise InputError(
            "strip: no planes through its edges make this pattern; choose a free pattern, or "
            "optimise the net until it has the property"
        )
    best = _strip(points, normals, turned_about_edges(along, toward, solved), closed)
    if width <= best.admissible_width()[0]:
        return best
    alternating = np.where(np.arange(len(toward)) % 2, -1.0, 1.0)
    for offset in _TRIALS:
        angles = planes.angles(offset * alternating)
        if angles is None:
            continue
        strip = _strip(points, normals, turned_about_edges(along, toward, angles), closed)
        if strip.admissible_width()[0] > best.admissible_width()[0]:
            best = strip
        if width <= best.admissible_width()[0]:
            break
    return best


@dataclass(frozen=True, eq=False)
class _Planes:
    """The equations of the planes' angles along one strip."""

    points: FloatArray
    normals: FloatArray
    toward: FloatArray
    turns: FloatArray

    @cached_property
    def along(self) -> FloatArray:
        """(K - 1, 3) unit directions of the edges."""
        return unit_rows(np.diff(self.points, axis=0))

    @cached_property
    def corners(self) -> Corners:
        """The inner points."""
        return Corners(self.along[:-1], self.along[1:], self.normals[1:-1])

    def angles(self, target: FloatArray) -> FloatArray | None:
        """(K - 1,) angles nearest to ``target`` that solve the equations, None where none do."""
        corners = self.corners
        ratio, straight = corners.turn_ratio(self.turns), corners.straight
        theta, value = target.copy(), np.zeros(0)
        for _ in range(_STEPS):
            up = turned_about_edges(self.along, self.toward, theta)
            alpha, beta = corners.leans(up[:-1], up[1:])
            half_sum, half_gap = (alpha + beta) / 2, (alpha - beta) / 2
            slant = ratio * np.sin(half_gap)
            same = np.cos(alpha - beta)
            value = np.where(
                straight, np.sin(alpha - beta), np.sin(half_sum) - ratio * np.cos(half_gap)
            )
            by_alpha = np.where(straight, same, 0.5 * (np.cos(half_sum) + slant))
            by_beta = np.where(straight, -same, 0.5 * (np.cos(half_sum) - slant))
            back = target - theta
            step = _nearest_step(-corners.side * by_alpha, -corners.side * by_beta, value, back)
            size = float(np.abs(step).max())
            theta = theta + step * min(1.0, _LARGEST_STEP / max(size, 1e-300))
            if size <= _SOLVED * len(theta):
                break
        return theta if np.abs(value).max(initial=0.0) <= _HOLDS else None


def _nearest_step(
    first: FloatArray, second: FloatArray, value: FloatArray, back: FloatArray
) -> FloatArray:
    """Step nearest to ``back`` (E,) with first * step[:-1] + second * step[1:] = -value."""
    if not len(value):
        return back
    miss = -value - first * back[:-1] - second * back[1:]
    bands = np.zeros((2, len(value)))
    bands[1] = first**2 + second**2
    bands[1] += _DAMPING * max(1.0, float(bands[1].max()))
    bands[0, 1:] = second[:-1] * first[1:]
    # A single equation has no second diagonal, and LAPACK refuses an empty one.
    multipliers = np.asarray(solveh_banded(bands[-len(value) :], miss))
    step = back.copy()
    step[:-1] += first * multipliers
    step[1:] += second * multipliers
    return step


def turned_about_edges(along: FloatArray, toward: FloatArray, angles: FloatArray) -> FloatArray:
    """(K - 1, 3) the vectors ``toward`` turned by angles (K - 1,) about the edges ``along``."""
    sine, cosine = np.sin(angles)[:, None], np.cos(angles)[:, None]
    return np.asarray(cosine * toward + sine * np.cross(along, toward))


def _strip(points: FloatArray, normals: FloatArray, up: FloatArray, closed: bool) -> Strip:
    """Rulings of the planes that contain each edge and its direction ``up`` (K - 1, 3)."""
    along = unit_rows(np.diff(points, axis=0))
    if closed:
        corners = Corners(along, np.roll(along, -1, axis=0), normals[1:])
        inner = corners.meets(up, np.roll(up, -1, axis=0))
        return Strip(points, np.concatenate([inner[-1:], inner]))
    corners = Corners(along[:-1], along[1:], normals[1:-1])
    inner = corners.meets(up[:-1], up[1:])
    return Strip(points, np.concatenate([up[:1], inner, up[-1:]]))
