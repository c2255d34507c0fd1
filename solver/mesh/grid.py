"""Meshes of grid type: vertex (i, j) is number ``i * N + j``, i along u, j along v."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh

# More of them take more memory than there mostly is.
MOST_VERTICES = 10_000_000


@dataclass(frozen=True, eq=False)
class Grid:
    """The parameter lines of a mesh of grid type.

    Attributes:
        numbers: (M, N) vertex numbers; ``numbers[:, j]`` is a u line, ``numbers[i]`` a v line.
        closed_u: the u lines return to their start (the start is not repeated).
        closed_v: the v lines return to their start.
    """

    numbers: IntArray
    closed_u: bool = False
    closed_v: bool = False

    def points(self, mesh: QuadMesh) -> FloatArray:
        """(M, N, 3) positions in the order of the grid."""
        return mesh.vertices[self.numbers]

    @property
    def outline(self) -> IntArray:
        """(N,) vertices around an open grid, counter-clockwise."""
        number = self.numbers
        sides = [number[:-1, 0], number[-1, :-1], number[:0:-1, -1], number[0, :0:-1]]
        return np.concatenate(sides)

    @property
    def faces(self) -> IntArray:
        """(F, 4) faces of the grid in its own vertex numbers."""
        m, n = self.numbers.shape
        return self.numbers.ravel()[grid_faces(m, n, self.closed_u, self.closed_v)]


def refuse_sampling(m: int, n: int, closed_u: bool = False, closed_v: bool = False) -> None:
    """Refuse numbers of vertices along u and v that make no grid, or one that nobody can hold.

    Raises:
        InputError: fewer than two lines in a direction (three where it is closed), or more than ten
            million vertices.
    """
    least = 2 + closed_u, 2 + closed_v
    whole = all(isinstance(count, (int, np.integer)) for count in (m, n))
    if not whole or m < least[0] or n < least[1]:
        raise InputError(
            f"sampling: expected at least {least[0]} x {least[1]} vertices, got {m} x {n}; "
            "take more samples"
        )
    if m * n > MOST_VERTICES:
        raise InputError(
            f"sampling: {m} x {n} are more than {MOST_VERTICES:,} vertices; take fewer"
        )


def grid_faces(m: int, n: int, closed_u: bool = False, closed_v: bool = False) -> IntArray:
    """(F, 4) faces of an M x N grid, side 0 along u, side 1 along v.

    Raises:
        InputError: as :func:`refuse_sampling`.
    """
    refuse_sampling(m, n, closed_u, closed_v)
    number = np.arange(m * n, dtype=np.int64).reshape(m, n)
    if closed_u:
        number = np.concatenate([number, number[:1]], axis=0)
    if closed_v:
        number = np.concatenate([number, number[:, :1]], axis=1)
    corners = [number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]]
    return np.stack(corners, axis=-1).reshape(-1, 4)


def grid_mesh(points: FloatArray, closed_u: bool = False, closed_v: bool = False) -> QuadMesh:
    """Quad mesh of an (M, N, 3) array of points.

    Raises:
        InputError: too few points in a direction.
    """
    m, n = points.shape[:2]
    return QuadMesh(points.reshape(-1, 3), grid_faces(m, n, closed_u, closed_v))


def grid_of(mesh: QuadMesh) -> Grid:
    """Find rows and columns of a mesh from its connectivity alone.

    Side 0 of face 0 sets the direction of u, so a mesh numbered ``i * N + j`` is found as it was
    built.

    Raises:
        InputError: the mesh is not of grid type (irregular vertices, holes or several components).
    """
    twins = mesh.connectivity.twins
    start, closed_u = _walk(0, twins, _left)
    start, closed_v = _walk(start, twins, _below)
    rows = []
    for half in _chain(start, twins, _right):
        rows.append(_chain(half, twins, _above))
    sides = _rectangle(rows, len(mesh.faces))
    ends = mesh.faces.ravel()
    numbers = ends[sides]
    if not closed_v:
        top = ends[sides[:, -1] - sides[:, -1] % 4 + (sides[:, -1] + 3) % 4]
        numbers = np.concatenate([numbers, top[:, None]], axis=1)
    if not closed_u:
        last = sides[-1]
        right = ends[last - last % 4 + (last + 1) % 4]
        if not closed_v:
            corner = ends[last[-1] - last[-1] % 4 + (last[-1] + 2) % 4]
            right = np.append(right, corner)
        numbers = np.concatenate([numbers, right[None]], axis=0)
    grid = Grid(numbers, closed_u, closed_v)
    if len(np.unique(numbers)) != numbers.size or not _same_faces(grid.faces, mesh.faces):
        raise _not_a_grid()
    return grid


def _not_a_grid() -> InputError:
    return InputError(
        "mesh: expected grid type (rows and columns only), got irregular vertices, holes or "
        "several components; cut it into pieces of grid type first"
    )


def _same_faces(one: IntArray, two: IntArray) -> bool:
    keys = []
    for faces in (one, two):
        first = np.argmin(faces, axis=1)
        turned = np.take_along_axis(faces, (first[:, None] + np.arange(4)) % 4, axis=1)
        keys.append(turned[np.lexsort(turned.T)])
    return one.shape == two.shape and bool((keys[0] == keys[1]).all())


def _rectangle(rows: list[list[int]], face_count: int) -> IntArray:
    if len({len(row) for row in rows}) != 1 or len(rows) * len(rows[0]) != face_count:
        raise _not_a_grid()
    return np.array(rows, dtype=np.int64)


def _turn(half: int, corners: int) -> int:
    return half - half % 4 + (half + corners) % 4


# A half-edge stands for the face to its left, seen with that half-edge as its lower side.
_right, _above, _left, _below = 1, 2, 3, 0


def _step(half: int, twins: IntArray, side: int) -> int:
    """Lower side of the face beyond the given side, or -1."""
    twin = int(twins[_turn(half, side)])
    return -1 if twin < 0 else _turn(twin, (2 - side) % 4)


def _walk(half: int, twins: IntArray, side: int) -> tuple[int, bool]:
    """Go to the end of a strip of faces; a closed strip stays where it is."""
    here = half
    # Steps are one to one: what does not end comes back to where it began.
    while (following := _step(here, twins, side)) >= 0:
        if following == half:
            return half, True
        here = following
    return here, False


def _chain(half: int, twins: IntArray, side: int) -> list[int]:
    chain = [half]
    while (following := _step(chain[-1], twins, side)) >= 0 and following != half:
        chain.append(following)
    return chain
