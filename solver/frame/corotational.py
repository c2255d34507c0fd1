"""Members that move far and bend little: forces by axes that go along with each member.

The x axis of a member runs from node to node, its y axis is the mean of those of its ends. By what
its ends are turned from there it bends as a linear beam does.

Source: Crisfield (1990), A consistent co-rotational formulation for non-linear, three-dimensional
beam elements; Battini (2002), Co-rotational beam elements in instability problems, 3.2.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from solver.mesh.quadmesh import FloatArray

# Real, or complex for derivatives by the complex step.
Numbers = NDArray[Any]

# Unknowns of a member that strain it: its stretch and what its ends are turned by.
_STRAINED = np.array([6, 3, 4, 5, 9, 10, 11])
# Step of the complex derivative: its square vanishes beside one, so the derivative is exact.
_STEP = 1e-40


@dataclass(frozen=True, eq=False)
class Ends:
    """Where the ends of members are and how they are turned.

    Attributes:
        places: (2, M, 3) of both ends.
        turned: (2, M, 3, 3) rotation of both ends from the start.
    """

    places: Numbers
    turned: Numbers


def forces(
    ends: Ends, axes: FloatArray, lengths: FloatArray, k: FloatArray
) -> tuple[Numbers, Numbers]:
    """Forces on the ends of members, and the same in the axes that went along.

    Args:
        ends: of the members.
        axes: (M, 3, 3) at the start, a direction a row.
        lengths: (M,) at the start.
        k: (M, 12, 12) linear stiffness in the member's axes.

    Returns:
        (M, 12) in the model's directions and (M, 12) in the member's own.
    """
    span = ends.places[1] - ends.places[0]
    length = np.sqrt(_dot(span, span))
    x = span / length[:, None]
    own_y = np.einsum("kmij,mj->kmi", ends.turned, axes[:, 1])
    mean = 0.5 * (own_y[0] + own_y[1])
    z = np.cross(x, mean)
    z = z / np.sqrt(_dot(z, z))[:, None]
    along = np.stack([x, np.cross(z, x), z], axis=1)
    bent = np.stack([_rotation(along @ turned @ np.swapaxes(axes, 1, 2)) for turned in ends.turned])
    strain = np.concatenate([(length - lengths)[:, None], bent[0], bent[1]], axis=1)
    inner = np.einsum("mij,mj->mi", k[:, :, _STRAINED], strain)
    moments = [_conjugate(bent[0], inner[:, 3:6]), _conjugate(bent[1], inner[:, 9:12])]
    own = np.zeros(inner.shape, dtype=inner.dtype)
    own[:, 0], own[:, 6] = -inner[:, 6], inner[:, 6]
    own[:, 3:6], own[:, 9:12] = moments
    own -= _with_axes(along, own_y, mean, length, moments[0] + moments[1])
    parts = own.reshape(-1, 4, 3)
    return np.einsum("mji,mkj->mki", along, parts).reshape(-1, 12), inner


def tangent(ends: Ends, axes: FloatArray, lengths: FloatArray, k: FloatArray) -> FloatArray:
    """(M, 12, 12) derivative of the forces by displacements and turns, by the complex step.

    Args:
        ends: of the members.
        axes: (M, 3, 3) at the start.
        lengths: (M,) at the start.
        k: (M, 12, 12) linear stiffness.
    """
    result = np.empty((len(lengths), 12, 12))
    for end in (0, 1):
        for c in range(3):
            places = ends.places.astype(complex)
            places[end, :, c] += 1j * _STEP
            moved, _ = forces(Ends(places, ends.turned), axes, lengths, k)
            result[:, :, 6 * end + c] = moved.imag / _STEP
            turned = ends.turned.astype(complex)
            turned[end] += 1j * _STEP * (_skew(np.eye(3)[c]) @ ends.turned[end])
            moved, _ = forces(Ends(ends.places, turned), axes, lengths, k)
            result[:, :, 6 * end + 3 + c] = moved.imag / _STEP
    # Off equilibrium it is not symmetric; what is left out vanishes there.
    return 0.5 * (result + np.swapaxes(result, 1, 2))


def turned_by(turn: FloatArray, rotations: FloatArray) -> FloatArray:
    """(N, 3, 3) rotations followed by turns (N, 3), axis times angle.

    Source: Rodrigues's formula.
    """
    angle = np.linalg.norm(turn, axis=1)
    skew = _skew(turn)
    one = np.sinc(angle / np.pi)[:, None, None]
    two = (0.5 * np.sinc(0.5 * angle / np.pi) ** 2)[:, None, None]
    return np.asarray((np.eye(3) + one * skew + two * (skew @ skew)) @ rotations)


def _with_axes(
    along: Numbers, own_y: Numbers, mean: Numbers, length: Numbers, moment: Numbers
) -> Numbers:
    """(M, 12) forces on the ends by which the moment (M, 3) turns the member's axes.

    Source: Battini (2002), equation 3.31.
    """
    y = np.einsum("mij,kmj->kmi", along, own_y)
    middle = np.einsum("mij,mj->mi", along, mean)
    lean = middle[:, 0] / middle[:, 1]
    result = np.zeros((len(length), 12), dtype=moment.dtype)
    roll, pitch, yaw = moment.T
    result[:, 1], result[:, 7] = -yaw / length, yaw / length
    result[:, 2] = (lean * roll + pitch) / length
    result[:, 8] = -result[:, 2]
    for end in (0, 1):
        half = 0.5 * roll / middle[:, 1]
        result[:, 6 * end + 3] = half * y[end, :, 1]
        result[:, 6 * end + 4] = -half * y[end, :, 0]
    return result


def _rotation(matrix: Numbers) -> Numbers:
    """(M, 3) axis times angle of rotations by less than a right angle."""
    axis = 0.5 * np.stack(
        [
            matrix[:, 2, 1] - matrix[:, 1, 2],
            matrix[:, 0, 2] - matrix[:, 2, 0],
            matrix[:, 1, 0] - matrix[:, 0, 1],
        ],
        axis=1,
    )
    square = _dot(axis, axis)
    small = np.abs(square) < 1e-3
    sine = np.sqrt(np.where(small, 0.25, square))
    series = 1 + square * (1 / 6 + square * (3 / 40 + square * (15 / 336 + square * 105 / 3456)))
    return np.asarray(np.where(small, series, np.arcsin(sine) / sine)[:, None] * axis)


def _conjugate(bent: Numbers, moment: Numbers) -> Numbers:
    """(M, 3) moments that work on small turns, of those that work on the vector ``bent``."""
    square = _dot(bent, bent)
    ratio = 1 / 12 + square * (1 / 720 + square * (1 / 30240 + square / 1209600))
    straight = (1 - square * ratio)[:, None] * moment
    return np.asarray(
        straight + (ratio * _dot(bent, moment))[:, None] * bent + 0.5 * np.cross(bent, moment)
    )


def _dot(one: Numbers, two: Numbers) -> Numbers:
    return np.asarray((one * two).sum(axis=-1))


def _skew(vectors: FloatArray) -> FloatArray:
    """(..., 3, 3) matrices of the cross product."""
    x, y, z = np.moveaxis(vectors, -1, 0)
    zero = np.zeros_like(x)
    rows = [[zero, -z, y], [z, zero, -x], [-y, x, zero]]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))
