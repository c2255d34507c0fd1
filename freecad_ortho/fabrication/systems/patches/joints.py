"""Joints between patches: beside a cut every piece ends half a gap before it."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.systems.patches.pieces import NetPiece
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.grid import grid_of
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.unroll.patch import FlatPatch

# Share of the faces beside a cut that must be left.
_LEFT_OVER = 0.05


def jointed(
    mesh: QuadMesh, piece: NetPiece, patch: FlatPatch, half: FloatArray, gap: float
) -> tuple[FlatPatch, FloatArray]:
    """Shorten a piece along its cuts: by half a gap in the pattern, by the same shares in space.

    Args:
        mesh: the net.
        piece: of it.
        patch: the piece in space and in the plane.
        half: (K, 3) from its vertices to the upper side of the plate.
        gap: between two pieces, mm.

    Returns:
        The patch and the vectors to the upper side, shortened.

    Raises:
        InputError: a gap that leaves nothing of a face.
    """
    numbers = grid_of(patch.flat).numbers
    cut = _cut_edges(mesh, piece)
    flat, bent = patch.flat.vertices, patch.bent.vertices
    for lines in (numbers, numbers.T):
        shares = _shares(flat[lines], gap)
        shares[[not _along(lines[end], cut) for end in (0, -1)]] = 0.0
        taken = shares.sum(axis=0) if len(lines) == 2 else shares.max(axis=0)
        if taken.max() > 1 - _LEFT_OVER:
            raise InputError(
                f"gap: {gap:g} mm leaves nothing of the faces along a cut of {piece.name}; take a "
                "smaller gap, or cut along fewer lines"
            )
        flat, bent, half = (_drawn_in(values, lines, shares) for values in (flat, bent, half))
    return FlatPatch(patch.bent.with_vertices(bent), patch.flat.with_vertices(flat)), half


def _cut_edges(mesh: QuadMesh, piece: NetPiece) -> set[tuple[int, int]]:
    """Ends of the edges on the outline of a piece beyond which the net goes on."""
    net = piece.mesh.connectivity
    outer = np.flatnonzero(net.twins < 0)
    face, side = outer // 4, outer % 4
    on = mesh.connectivity.twins[4 * piece.faces[face] + side] >= 0
    ends = np.stack([net.faces[face, side], net.faces[face, (side + 1) % 4]], axis=1)[on]
    return {(one, other) for one, other in np.sort(ends, axis=1).tolist()}


def _along(line: IntArray, cut: set[tuple[int, int]]) -> bool:
    """Whether a line of vertices runs along a cut."""
    pairs = np.sort(np.stack([line[:-1], line[1:]], axis=1), axis=1).tolist()
    return any((one, other) in cut for one, other in pairs)


def _shares(flat: FloatArray, gap: float) -> FloatArray:
    """(2, N) share of its face by which the first and last line of (M, N, 3) points move inwards.

    Half a gap square to the line.
    """
    shares = []
    for line, behind in ((flat[0], flat[1]), (flat[-1], flat[-2])):
        along = np.gradient(line, axis=0)
        step = behind - line
        across = np.linalg.norm(np.cross(along, step), axis=1) / np.linalg.norm(along, axis=1)
        shares.append(gap / 2 / np.maximum(across, 1e-9 * gap))
    return np.array(shares)


def _drawn_in(values: FloatArray, lines: IntArray, shares: FloatArray) -> FloatArray:
    """Values (V, 3) at vertices whose first and last line have moved towards those behind."""
    result = values.copy()
    for end, behind, share in ((0, 1, shares[0]), (-1, -2, shares[1])):
        result[lines[end]] += share[:, None] * (values[lines[behind]] - values[lines[end]])
    return result
