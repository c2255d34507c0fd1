"""Where a patch that is larger than a sheet is cut: along lines of its grid."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.nesting.room import Room
from freecad_ortho.fabrication.systems.patches.pieces import NetPiece
from solver.mesh.connectivity import IntArray
from solver.mesh.grid import grid_of
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.unroll.patch import FlatPatch


def cuts_to_fit(mesh: QuadMesh, piece: NetPiece, patch: FlatPatch, room: Room) -> IntArray:
    """Edges of the net along which a piece is cut so that what is left may fit a sheet.

    None where the piece fits, or is a single face. Smaller pieces may have to be cut again, as
    curved ones need more room than they are long.

    Args:
        mesh: the net.
        piece: of it.
        patch: the piece in the plane.
        room: on the sheet.
    """
    grid = grid_of(patch.flat)
    if room.holds(patch.flat.vertices[grid.outline, :2]):
        return np.zeros(0, dtype=np.int64)
    found = [
        numbers[line]
        for numbers, lines in zip(
            (grid.numbers, grid.numbers.T), _lines(patch.flat, grid.numbers, room), strict=True
        )
        for line in lines
    ]
    if not found:
        return np.zeros(0, dtype=np.int64)
    pairs = np.concatenate([np.stack([line[:-1], line[1:]], axis=1) for line in found])
    ends = np.sort(piece.vertices[pairs], axis=1)
    # Edges are in the order of their vertices.
    keys = mesh.connectivity.edges @ np.array([len(mesh.vertices), 1])
    return np.asarray(np.searchsorted(keys, ends @ np.array([len(mesh.vertices), 1])))


def _lines(flat: QuadMesh, numbers: IntArray, room: Room) -> tuple[list[int], list[int]]:
    """Numbers of the lines (M, N) in both directions along which the grid is cut."""
    steps = _steps(flat, numbers), _steps(flat, numbers.T)
    sizes = [(room.width, room.height)] + [(room.height, room.width)] * room.turns
    ways = [(_divided(steps[0], one), _divided(steps[1], two)) for one, two in sizes]
    best = min(ways, key=lambda way: (len(way[0]) + 1) * (len(way[1]) + 1))
    if best[0] or best[1]:
        return best
    # Curved pieces need more room than they are long.
    one, two = (_divided(step, 0.5 * float(step.sum()))[:1] for step in steps)
    return (one, []) if one and (not two or steps[0].sum() > steps[1].sum()) else ([], two)


def _steps(flat: QuadMesh, numbers: IntArray) -> FloatArray:
    """(M - 1,) largest distance from each line (M, N) of vertices to the next."""
    away = np.linalg.norm(np.diff(flat.vertices[numbers], axis=0), axis=2)
    return np.asarray(away.max(axis=1))


def _divided(steps: FloatArray, longest: float) -> list[int]:
    """Where a row of faces is cut into as few pieces of a length as there can be, even ones first.

    A face that is longer stays whole.
    """
    ends = np.concatenate([[0.0], np.cumsum(steps)])
    filled = [0]
    for number in range(1, len(steps)):
        if ends[number + 1] - ends[filled[-1]] > longest * (1 + 1e-9):
            filled.append(number)
    wanted = ends[-1] * np.arange(1, len(filled)) / len(filled)
    even = [int(np.abs(ends - place).argmin()) for place in wanted]
    sizes = np.diff(ends[[0, *even, -1]])
    fits = sizes.min() > 0 and sizes.max() <= longest * (1 + 1e-9)
    return even if fits else filled[1:]
