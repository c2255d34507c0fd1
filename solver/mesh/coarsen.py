"""Coarser and smaller meshes: every k-th parameter line, and rows cut off."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import Connectivity, IntArray
from solver.mesh.grid import grid_mesh, grid_of
from solver.mesh.quadmesh import QuadMesh
from solver.option import Range, whole_number


def coarsened(mesh: QuadMesh, every: int = 2, seed: int | None = None) -> QuadMesh:
    """Keep every k-th parameter line, from a corner or irregular vertex on.

    Works on any mesh whose irregular vertices and corners lie k, 2k, ... edges apart along the
    parameter lines, as after subdivision. Orthogonality of a multi-net survives exactly.

    Args:
        mesh: the mesh.
        every: k >= 2.
        seed: a vertex of the coarse mesh; by default the first irregular one, else the first
            corner, else vertex 0.

    Raises:
        InputError: k below 2, or lines that do not fit; a mesh of grid type goes through
            :func:`coarsened_grid` instead, which can keep the last line.
    """
    whole_number("every", every, Range(2))
    net = mesh.connectivity
    faces = _blocks(net, every, _seed(net) if seed is None else seed)
    if len(faces) * every**2 != len(mesh.faces):
        raise InputError(
            f"coarsen: {len(mesh.faces)} faces do not divide into blocks of {every} x {every} "
            "between irregular vertices and corners; trim rows, or choose another number"
        )
    return compact(mesh, faces)


def _seed(net: Connectivity) -> int:
    for special in (net.referenced & ~net.regular & ~net.boundary_vertices, net.corners):
        if special.any():
            return int(np.argmax(special))
    return 0


def _blocks(net: Connectivity, every: int, seed: int) -> IntArray:
    """(F, 4) corners of all blocks reached from a vertex."""
    ends, twins, straight = net.faces.ravel(), net.twins, net.continuation

    def turn(half: int, corners: int) -> int:
        return half - half % 4 + (half + corners) % 4

    def block(half: int) -> list[int] | None:
        """Half-edges that leave the corners of the block to the left, or None."""
        sides = []
        for _ in range(4):
            sides.append(half)
            for _ in range(every - 1):
                half = int(straight[half])
                if half < 0:
                    return None
            half = turn(half, 1)
        return sides if half == sides[0] else None

    waiting = np.flatnonzero(ends == seed).tolist()
    known = set(waiting)
    found: dict[frozenset[int], list[int]] = {}
    while waiting:
        sides = block(waiting.pop())
        if sides is None:
            continue
        lead = next((k for k in range(4) if sides[k] % 4 == 0), 0)
        corners = [int(ends[sides[(lead + k) % 4]]) for k in range(4)]
        found.setdefault(frozenset(sides), corners)
        for side in sides:
            # All faces at this corner start blocks too: turn around it both ways.
            for half in _around(side, twins, turn):
                if half not in known:
                    known.add(half)
                    waiting.append(half)
    return np.array(list(found.values()), dtype=np.int64).reshape(-1, 4)


def _around(half: int, twins: IntArray, turn: Callable[[int, int], int]) -> list[int]:
    """Half-edges that leave the same vertex."""
    result, here = [half], half
    while True:
        here = int(twins[turn(here, 3)])
        if here == half:
            return result
        if here < 0:
            break
        result.append(here)
    here = half
    while twins[here] >= 0:
        here = turn(int(twins[here]), 1)
        result.append(here)
    return result


def compact(mesh: QuadMesh, faces: IntArray) -> QuadMesh:
    """The mesh of some faces on the vertices that they use, in their old order."""
    if not len(faces):
        raise InputError("mesh: no face is left; keep more")
    kept, numbers = np.unique(faces, return_inverse=True)
    return QuadMesh(mesh.vertices[kept], numbers.reshape(-1, 4))


def coarsened_grid(mesh: QuadMesh, u: int = 2, v: int = 2, keep_border: bool = True) -> QuadMesh:
    """Every u-th and v-th line of a mesh of grid type, numbered ``i * N + j`` anew.

    Args:
        mesh: a mesh of grid type.
        u: step along u, at least 1.
        v: step along v, at least 1.
        keep_border: keep the last line where the step does not meet it.

    Raises:
        InputError: not of grid type, steps below 1 or too large, or a closed direction that the
            step does not divide.
    """
    grid = grid_of(mesh)
    chosen = []
    for name, step, count, closed in (
        ("u", u, grid.numbers.shape[0], grid.closed_u),
        ("v", v, grid.numbers.shape[1], grid.closed_v),
    ):
        if step < 1 or (closed and count % step):
            raise InputError(
                f"{name}: expected a step of at least 1"
                + (f" that divides the {count} lines around" if closed else "")
                + f", got {step}"
            )
        lines = np.arange(0, count, step)
        if keep_border and not closed and lines[-1] != count - 1:
            lines = np.append(lines, count - 1)
        chosen.append(lines)
    points = grid.points(mesh)[np.ix_(chosen[0], chosen[1])]
    return grid_mesh(points, grid.closed_u, grid.closed_v)


def trimmed(mesh: QuadMesh, first: tuple[int, int], last: tuple[int, int]) -> QuadMesh:
    """Cut rows off a mesh of grid type: ``first`` = rows at the starts of u and v, ``last`` = ends.

    Raises:
        InputError: not of grid type, negative numbers, too many rows, or a closed direction.
    """
    grid = grid_of(mesh)
    cuts = []
    for k, (name, closed) in enumerate((("u", grid.closed_u), ("v", grid.closed_v))):
        count = grid.numbers.shape[k]
        if min(first[k], last[k]) < 0 or first[k] + last[k] > count - 2:
            raise InputError(
                f"{name}: expected to cut 0 to {count - 2} of {count - 1} rows, got "
                f"{first[k]} and {last[k]}"
            )
        if closed and first[k] + last[k]:
            raise InputError(f"{name}: runs around, it has no first or last row; cut the other way")
        cuts.append(slice(first[k], count - last[k]))
    points = grid.points(mesh)[cuts[0], cuts[1]]
    return grid_mesh(points, grid.closed_u, grid.closed_v)


def without_border(mesh: QuadMesh, rings: int = 1) -> QuadMesh:
    """Remove all faces that touch the boundary, so many times; any mesh.

    Raises:
        InputError: fewer than one ring, or nothing left.
    """
    whole_number("rings", rings, Range(1))
    for _ in range(rings):
        touched = mesh.connectivity.boundary_vertices[mesh.faces].any(axis=1)
        mesh = compact(mesh, mesh.faces[~touched])
    return mesh
