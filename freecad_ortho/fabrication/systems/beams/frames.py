"""The plane of each beam, and the angles between neighbouring beams seen along their axis."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.offset.axes import Axes


@dataclass(frozen=True, eq=False)
class Frames:
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

    @property
    def slant(self) -> FloatArray:
        """(E, 2) distance along the edge per distance square to the axis, at the start and end."""
        return np.asarray(np.hypot(self.slope, self.rise[:, None]) / self.rise[:, None])


@dataclass(frozen=True, eq=False)
class Around:
    """Half-edges in their order around the axes; half-edge ``e`` leaves the start of edge ``e``.

    Half-edge ``E + e`` leaves its end.

    Attributes:
        vertex: (2E,) where each half-edge begins.
        left: (2E,) the next half-edge counter-clockwise seen from the axis' tip, itself where it is
            alone; -1 for half-edges that are left out.
        right: (2E,) the next one clockwise.
        angle: (2E,) to the one on the left, radians, 2 pi where it is alone; 0 for those left out.
    """

    vertex: IntArray
    left: IntArray
    right: IntArray
    angle: FloatArray


def beam_frames(mesh: QuadMesh, axes: Axes) -> Frames:
    """Work out the planes of all beams.

    Raises:
        InputError: an edge without length, or an axis that lies along the surface.
    """
    start, end = mesh.connectivity.edges.T
    empty = mesh.edge_lengths <= 1e-9 * mesh.mean_edge
    if empty.any():
        raise InputError(
            f"edges: {int(empty.sum())} have no length, the first is {edge_name(mesh, empty)}; "
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
            f"axes: at {edge_name(mesh, lying)} an axis lies almost along the surface, so no "
            "upright beam contains it; optimise the mesh first or remove folded faces"
        )
    rise = rises.mean(axis=1)
    slope = np.einsum("eik,ek->ei", offsets, along) * (rise[:, None] / rises)
    return Frames(along, up, left, slope, rise, np.einsum("eik,ek->ei", offsets, left))


def around_axes(mesh: QuadMesh, axes: Axes, along: FloatArray, built: BoolArray) -> Around:
    """Sort the half-edges of the edges that are built, (E,), around the axis of their vertex."""
    vertex = mesh.connectivity.edges.T.ravel()
    outward = np.concatenate([along, -along])
    reference = np.eye(3)[np.abs(axes.directions).argmin(axis=1)]
    first = unit_rows(np.cross(reference, axes.directions))
    second = np.cross(axes.directions, first)
    angle = np.arctan2(
        np.einsum("hk,hk->h", outward, second[vertex]),
        np.einsum("hk,hk->h", outward, first[vertex]),
    )
    order = np.lexsort((angle, vertex))
    order = order[np.concatenate([built, built])[order]]
    following = np.roll(order, -1)
    last = np.flatnonzero(vertex[order] != vertex[following])
    if len(last):
        following[last] = order[np.concatenate([[0], last[:-1] + 1])]
    gap = (angle[following] - angle[order]) % (2 * math.pi)
    gap[following == order] = 2 * math.pi
    left, right = np.full((2, len(vertex)), -1)
    left[order], right[following] = following, order
    between = np.zeros(len(vertex))
    between[order] = gap
    return Around(vertex, left, right, between)


def edge_name(mesh: QuadMesh, chosen: BoolArray) -> str:
    """Name the first of the chosen edges, (E,), for a message."""
    edge = int(np.argmax(chosen))
    first, second = mesh.connectivity.edges[edge]
    return f"edge {edge} (vertices {first} and {second})"
