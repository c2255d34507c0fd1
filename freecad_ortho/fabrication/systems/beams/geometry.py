"""Beams: a plate along every edge, mitred against its neighbours around each axis.

Seen along an axis, a beam is a strip of the plate's thickness. Between neighbouring strips the
half-plane that contains the axis and bisects their angle cuts both; where they are more than a
straight angle apart (the outer side of a boundary), both are cut square instead. So every beam
stays in a wedge of its own and no two overlap. All sides of the solid are planar: the cut planes
contain the axis, which is parallel to the plate's faces, hence the corner lines are parallel to it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_ortho.fabrication.sizes import rounded_down
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.offset.axes import Axes

# Corners of a beam, one ring at the lower and one at the upper level: on the axis at the start,
# right, right, on the axis at the end, left, left; counter-clockwise from above.
LEFT_TOP = (6, 11, 10, 9)
RIGHT_TOP = (6, 7, 8, 9)
LOOPS = (
    tuple(range(6, 12)),
    tuple(range(5, -1, -1)),
    *((k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6) for k in range(6)),
)
# Part of a beam's length that its cuts must leave.
_LEAST_LEFT = 1e-3


@dataclass(frozen=True, eq=False)
class BeamGeometry:
    """All beams of a mesh as arrays, one row an edge; mm.

    Attributes:
        points: (E, 12, 3) corners, see ``LOOPS``.
        origin: (E, 3) where the lower left corner of the flat pattern's box is.
        frame: (E, 3, 3) rows along the edge, up in the plate, across it to the right.
        outline: (E, 4, 2) the plate in its plane, along the edge and across: lower start, lower
            end, upper end, upper start.
        setback: (E, 4) how far the plate's faces stop short of the axes: right at the start,
            right at the end, left at the end, left at the start.
        height: (E,) of the plate.
        volume: (E,) from the formula.
        twist_mm: (E,) largest distance of the axes' ends from the plate's mid plane.
        levels: lower and upper level along the axes, mm from the mesh.
    """

    points: FloatArray
    origin: FloatArray
    frame: FloatArray
    outline: FloatArray
    setback: FloatArray
    height: FloatArray
    volume: FloatArray
    twist_mm: FloatArray
    levels: tuple[float, float]


@dataclass(frozen=True, eq=False)
class _Frames:
    """Plane of each beam: ``along`` the edge, ``up`` in the plane, ``left`` across; (E, 3) each.

    ``slope`` (E, 2) is how far the axis at the start and end moves along the edge per unit level,
    ``rise`` (E,) the plate's height per unit level, ``miss`` (E, 2) how far it leaves the plane.
    """

    along: FloatArray
    up: FloatArray
    left: FloatArray
    slope: FloatArray
    rise: FloatArray
    miss: FloatArray


def beam_geometry(
    mesh: QuadMesh, axes: Axes, levels: tuple[float, float], thickness: float
) -> BeamGeometry:
    """Compute the corners of all beams.

    Args:
        mesh: positions in mm.
        axes: of the same mesh.
        levels: lower and upper level along the axes, mm from the mesh.
        thickness: of the plates, mm.

    Raises:
        InputError: an edge without length, or a height or thickness that does not fit an edge.
    """
    frames = _frames(mesh, axes)
    lower, upper = levels
    half = thickness / 2
    setback = half * _cotangents(mesh, axes, frames)
    lengths = mesh.edge_lengths
    level_lengths = np.stack(
        [lengths + level * (frames.slope[:, 1] - frames.slope[:, 0]) for level in levels],
        axis=1,
    )
    _refuse_height(mesh, upper - lower, level_lengths)
    _refuse_thickness(mesh, thickness, level_lengths.min(axis=1), setback)

    origin = mesh.vertices[mesh.connectivity.edges[:, 0]]
    rings, outlines = [], []
    for level in (lower, upper):
        ring, outline = _at_level(level, half, lengths, setback, frames)
        rings.append(origin[:, None] + ring)
        outlines.append(outline)
    height = (upper - lower) * frames.rise
    mean_length = level_lengths.mean(axis=1)
    quadrilateral = np.concatenate([outlines[0], outlines[1][:, ::-1]], axis=1)
    frame = np.stack([frames.along, frames.up, -frames.left], axis=1)
    low = quadrilateral.min(axis=1)
    return BeamGeometry(
        points=np.concatenate(rings, axis=1),
        origin=origin + np.einsum("ed,edk->ek", low, frame[:, :2]),
        frame=frame,
        outline=quadrilateral,
        setback=setback,
        height=height,
        volume=height * thickness * (mean_length - setback.sum(axis=1) / 4),
        twist_mm=np.abs(frames.miss).max(axis=1) * max(abs(lower), abs(upper)),
        levels=levels,
    )


def _at_level(
    level: float, half: float, lengths: FloatArray, setback: FloatArray, frames: _Frames
) -> tuple[FloatArray, FloatArray]:
    """Ring of corners (E, 6, 3) from each edge's start, and the outline's two corners (E, 2, 2)."""
    first = level * frames.slope[:, 0]
    last = lengths + level * frames.slope[:, 1]
    rise = level * frames.rise
    right = first + setback[:, 0], last - setback[:, 1]
    left = last - setback[:, 2], first + setback[:, 3]
    stations = np.stack([first, *right, last, *left], axis=1)
    sides = half * np.array([0.0, -1.0, -1.0, 0.0, 1.0, 1.0])
    ring = (
        (rise[:, None] * frames.up)[:, None]
        + stations[:, :, None] * frames.along[:, None]
        + sides[None, :, None] * frames.left[:, None]
    )
    ends = np.stack([first, last], axis=1)
    return ring, np.stack([ends, np.broadcast_to(rise[:, None], ends.shape)], axis=2)


def _frames(mesh: QuadMesh, axes: Axes) -> _Frames:
    start, end = mesh.connectivity.edges.T
    empty = mesh.edge_lengths <= 1e-9 * mesh.mean_edge
    if empty.any():
        raise InputError(
            f"edges: {int(empty.sum())} have no length, the first is {_edge_name(mesh, empty)}; "
            "remove or move its vertices"
        )
    along = unit_rows(mesh.vertices[end] - mesh.vertices[start])
    both = unit_rows(axes.directions[start]) + axes.directions[end]
    across = both - np.einsum("ek,ek->e", both, along)[:, None] * along
    up = unit_rows(across)
    left = np.cross(up, along)
    offsets = np.stack([axes.offsets[start], axes.offsets[end]], axis=1)
    rises = np.einsum("eik,ek->ei", offsets, up)
    lying = rises.min(axis=1) < 0.1
    if lying.any():
        raise InputError(
            f"axes: at {_edge_name(mesh, lying)} an axis lies almost along the surface, so no "
            "upright beam contains it; optimise the mesh first or remove folded faces"
        )
    rise = rises.mean(axis=1)
    slope = np.einsum("eik,ek->ei", offsets, along) * (rise[:, None] / rises)
    return _Frames(along, up, left, slope, rise, np.einsum("eik,ek->ei", offsets, left))


def _cotangents(mesh: QuadMesh, axes: Axes, frames: _Frames) -> FloatArray:
    """(E, 4) setback per half thickness, in the order of ``BeamGeometry.setback``."""
    count = len(frames.along)
    vertex = mesh.connectivity.edges.T.ravel()
    outward = np.concatenate([frames.along, -frames.along])
    reference = np.eye(3)[np.abs(axes.directions).argmin(axis=1)]
    first = unit_rows(np.cross(reference, axes.directions))
    second = np.cross(axes.directions, first)
    angle = np.arctan2(
        np.einsum("hk,hk->h", outward, second[vertex]),
        np.einsum("hk,hk->h", outward, first[vertex]),
    )
    order = np.lexsort((angle, vertex))
    following = np.roll(order, -1)
    last = np.flatnonzero(vertex[order] != vertex[following])
    first_of = np.concatenate([[0], last[:-1] + 1])
    following[last] = order[first_of]
    gap = (angle[following] - angle[order]) % (2 * math.pi)
    gap[following == order] = 2 * math.pi

    # Across the edge, a setback along the beam grows by the slant of the axis in the plate.
    slant = np.hypot(frames.slope, frames.rise[:, None]) / frames.rise[:, None]
    with np.errstate(divide="ignore"):
        cotangent = np.where(gap >= math.pi, 0.0, 1.0 / np.tan(gap / 2))
    left, right = np.empty(2 * count), np.empty(2 * count)
    left[order] = cotangent
    right[following] = cotangent
    return np.stack([right[:count], left[count:], right[count:], left[:count]], axis=1) * np.stack(
        [slant[:, 0], slant[:, 1], slant[:, 1], slant[:, 0]], axis=1
    )


def _refuse_height(mesh: QuadMesh, height: float, lengths: FloatArray) -> None:
    wrong = lengths.min(axis=1) <= _LEAST_LEFT * mesh.edge_lengths
    if wrong.any():
        shrink = (mesh.edge_lengths - lengths.min(axis=1)) / height
        largest = float((mesh.edge_lengths[wrong] / shrink[wrong]).min())
        raise InputError(
            f"beam height: {height:g} mm does not fit {_edge_name(mesh, wrong)}, where "
            f"the axes meet before that; take less than {rounded_down(largest)} mm or "
            "another offset"
        )


def _refuse_thickness(
    mesh: QuadMesh, thickness: float, available: FloatArray, setback: FloatArray
) -> None:
    needed = np.maximum(setback[:, 0] + setback[:, 1], setback[:, 2] + setback[:, 3])
    room = available * (1 - _LEAST_LEFT)
    if (needed > room).any():
        worst = needed / room
        edge = int(np.argmax(worst))
        largest = thickness / float(worst[edge])
        raise InputError(
            f"beam thickness: {thickness:g} mm does not fit "
            f"{_edge_name(mesh, np.arange(len(worst)) == edge)}, whose mitres need "
            f"{needed[edge]:.1f} of its {available[edge]:.1f} mm; take at most "
            f"{rounded_down(largest)} mm"
        )


def _edge_name(mesh: QuadMesh, chosen: BoolArray) -> str:
    edge = int(np.argmax(chosen))
    first, second = mesh.connectivity.edges[edge]
    return f"edge {edge} (vertices {first} and {second})"
