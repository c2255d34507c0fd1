"""Matrices of all members at once, in their own axes: 12 unknowns a member, six an end."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.errors import InputError
from solver.frame.model import Frame
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray

# Displacement and rotation at both ends, of bending along y and along z.
_ALONG_Y, _ALONG_Z = [1, 5, 7, 11], [2, 4, 8, 10]
# A turn about y takes x to minus z.
_SIGNS = np.array([1.0, -1.0, 1.0, -1.0])


def stiffness(frame: Frame) -> FloatArray:
    """(M, 12, 12) elastic stiffness of the members without their springs.

    Source: Przemieniecki (1968), Theory of Matrix Structural Analysis, 5.6 (with shear).
    """
    of, length = frame.stiffness, frame.lengths
    k = np.zeros((len(length), 12, 12))
    for first, value in ((0, of.youngs * of.area), (3, of.shear * of.torsion)):
        _couple(k, first, value / length)
    along_y = _bending(of.youngs * of.about_z, of.shear * of.shear_area_y, length)
    along_z = _bending(of.youngs * of.about_y, of.shear * of.shear_area_z, length)
    k[:, np.array(_ALONG_Y)[:, None], _ALONG_Y] = along_y
    k[:, np.array(_ALONG_Z)[:, None], _ALONG_Z] = along_z * np.outer(_SIGNS, _SIGNS)
    return k


def _couple(k: FloatArray, first: int, value: FloatArray) -> None:
    k[:, first, first] = k[:, first + 6, first + 6] = value
    k[:, first, first + 6] = k[:, first + 6, first] = -value


def _bending(ei: FloatArray, ga: FloatArray, length: FloatArray) -> FloatArray:
    """(M, 4, 4) stiffness for deflection and rotation at both ends."""
    soft = 12 * ei / (ga * length**2)
    one = np.ones_like(length)
    rows = [
        [12 * one, 6 * length, -12 * one, 6 * length],
        [6 * length, (4 + soft) * length**2, -6 * length, (2 - soft) * length**2],
        [-12 * one, -6 * length, 12 * one, -6 * length],
        [6 * length, (2 - soft) * length**2, -6 * length, (4 + soft) * length**2],
    ]
    factor = ei / (length**3 * (1 + soft))
    return np.asarray(np.moveaxis(np.array(rows), 2, 0) * factor[:, None, None])


def spread_at_ends(frame: Frame, spread: FloatArray) -> FloatArray:
    """(M, 12) forces and moments on the nodes from even loads ``spread`` (M, 3) in own axes.

    They make the nodes move exactly as the load along the members does, with shear too.
    """
    length = frame.lengths[:, None]
    half, twelfth = 0.5 * length * spread, length**2 * spread / 12
    zero = np.zeros(len(length))
    moment = np.stack([zero, -twelfth[:, 2], twelfth[:, 1]], axis=1)
    return np.concatenate([half, moment, half, -moment], axis=1)


def geometric(frame: Frame, ends: FloatArray) -> FloatArray:
    """(M, 12, 12) what the forces in members add to their stiffness.

    With the axial force, the torque and the bending moments, so that members buckle sideways and
    by twisting as well.

    Args:
        frame: the frame.
        ends: (M, 12) forces and moments on the ends, in own axes.

    Source: McGuire, Gallagher, Ziemian (2000), Matrix Structural Analysis, 9.2 and 9.3.
    """
    length, of = frame.lengths, frame.stiffness
    n = 0.5 * (ends[:, 6] - ends[:, 0])
    upper = np.zeros((len(length), 12, 12))

    def put(row: int, column: int, value: FloatArray) -> None:
        upper[:, row, column] = value

    polar = n * (of.about_y + of.about_z) / (of.area * length)
    # A stretch does not turn the axial force: it has no term, unlike in the source.
    put(3, 3, polar)
    put(3, 9, -polar)
    put(9, 9, polar)
    for (a, b, c, d), sign in ((_ALONG_Y, 1.0), (_ALONG_Z, -1.0)):
        for row, column, value in (
            (a, a, 1.2 * n / length), (a, c, -1.2 * n / length), (c, c, 1.2 * n / length),
            (a, b, sign * n / 10), (a, d, sign * n / 10), (b, c, -sign * n / 10),
            (c, d, -sign * n / 10), (b, b, 2 * n * length / 15), (d, d, 2 * n * length / 15),
            (b, d, -n * length / 30),
        ):  # fmt: skip
            put(min(row, column), max(row, column), value)
    _add_moments(upper, ends, length)
    lower = np.swapaxes(np.triu(np.ones((12, 12)), 1) * upper, 1, 2)
    return np.asarray(upper + lower)


def _add_moments(upper: FloatArray, ends: FloatArray, length: FloatArray) -> None:
    """Add what torque and bending moments do to the upper triangle of the geometric stiffness."""
    t, y1, z1, y2, z2 = (ends[:, k] for k in (9, 4, 5, 10, 11))
    sum_y, sum_z = (y1 + y2) / 6, (z1 + z2) / 6
    for row, column, value in (
        (1, 3, y1 / length), (1, 4, t / length), (1, 9, y2 / length), (1, 10, -t / length),
        (2, 3, z1 / length), (2, 5, t / length), (2, 9, z2 / length), (2, 11, -t / length),
        (3, 4, (z2 - 2 * z1) / 6), (3, 5, (2 * y1 - y2) / 6), (3, 7, -y1 / length),
        (3, 8, -z1 / length), (3, 10, -sum_z), (3, 11, sum_y), (4, 7, -t / length),
        (4, 9, -sum_z), (4, 11, t / 2), (5, 8, -t / length), (5, 9, sum_y), (5, 10, -t / 2),
        (7, 9, -y2 / length), (7, 10, t / length), (8, 9, -z2 / length), (8, 11, t / length),
        (9, 10, (z1 - 2 * z2) / 6), (9, 11, (2 * y2 - y1) / 6),
    ):  # fmt: skip
        upper[:, row, column] += value


@dataclass(frozen=True, eq=False)
class Joined:
    """Members with the springs at their ends.

    Attributes:
        stiffness: (M, 12, 12) between the nodes.
        follow: (M, 12, 12) movement of the member's own ends for one of its nodes; the identity
            where all joints are rigid.
    """

    stiffness: FloatArray
    follow: FloatArray


def joined(frame: Frame, k: FloatArray) -> Joined:
    """Put springs between members and nodes: the ends of members find their own balance.

    Args:
        frame: with its springs.
        k: (M, 12, 12) stiffness of the members alone.

    Raises:
        InputError: a member that moves freely between its nodes.
    """
    let_go = np.isfinite(frame.springs)
    kept, follow = k.copy(), np.broadcast_to(np.eye(12), k.shape).copy()
    members = np.flatnonzero(let_go.any(axis=1))
    patterns, of = np.unique(let_go[members], axis=0, return_inverse=True)
    for number, pattern in enumerate(patterns):
        rows = members[of.ravel() == number]
        _join(frame, rows, pattern, kept, follow)
    return Joined(kept, follow)


def _join(
    frame: Frame, rows: FloatArray, pattern: BoolArray, kept: FloatArray, follow: FloatArray
) -> None:
    """The same for members whose joints let go in the same directions."""
    soft = np.flatnonzero(pattern)
    k = kept[rows]
    spring = np.zeros((len(rows), len(soft), len(soft)))
    each = np.arange(len(soft))
    spring[:, each, each] = frame.springs[rows][:, soft]
    inner = k[:, soft[:, None], soft] + spring
    # Lengths are in the unit of the model: made comparable by the diagonal.
    scale = np.sqrt(k[:, soft, soft] + spring[:, each, each])
    weakest = np.linalg.eigvalsh(inner / scale[:, :, None] / scale[:, None, :])[:, 0]
    free = np.flatnonzero(weakest < 1e-12)
    if len(free):
        raise InputError(
            f"member {rows[free[0]]}: moves freely between its nodes; let the joint of one of its "
            "ends hold it"
        )
    right = -k[:, soft, :]
    right[:, :, soft] = spring
    own = np.broadcast_to(np.eye(12), k.shape).copy()
    own[:, soft, :] = np.linalg.solve(inner, right)
    gap = -own[:, soft, :]
    gap[:, each, soft] += 1.0
    kept[rows] = np.swapaxes(own, 1, 2) @ k @ own + np.swapaxes(gap, 1, 2) @ spring @ gap
    follow[rows] = own
