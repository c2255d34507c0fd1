"""Forces in a surface that stands as a thin shell and carries its own weight.

Flat triangles of constant strain carry in their planes, and their edges resist bending like hinges
with springs, as in a shell of a two-hundredth of its size thick: so little that what a membrane can
carry it carries as one. Loads are vertical and even over the surface, supports do not move, and
Poisson's ratio is zero, as in a grid of bars.

Source: Zienkiewicz, Taylor (2000), The Finite Element Method 1, section 4.2 (the triangles);
Grinspun, Hirani, Desbrun, Schroeder (2003), Discrete shells (the hinges).
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.linalg import splu
from scipy.spatial import cKDTree

from solver.align.features import corners_of
from solver.align.triangle_mesh import TriangleMesh
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# What a shell may stand on.
STANDS_ON = ("boundary", "corners")
# Thickness of the shell over the root of its area.
_THIN = 1 / 200
# A shell whose normals differ by less from one another carries no load as a membrane.
_LEVEL = 1e-4
# Corners that hold a shell, at least.
_CORNERS = 3


def membrane_forces(mesh: TriangleMesh, inner: int, stands_on: str, edge: float) -> FloatArray:
    """Find the forces under a vertical load that is even over the surface.

    Args:
        mesh: the surface, with its apron.
        inner: how many of the triangles are the surface's own; only these carry.
        stands_on: one of :data:`STANDS_ON`.
        edge: wanted edge length; shorter teeth of the border are no corners.

    Returns:
        (V, 3, 3) forces a length at the vertices, tension positive; beyond the border those of the
        nearest vertex. Of the order of one for a load of one a unit of area.

    Raises:
        InputError: a flat surface, or one with too few corners to stand on.
    """
    own = TriangleMesh(*_alone(mesh, inner))
    if np.ptp(own.normals, axis=0).max() < _LEVEL:
        raise InputError(
            "net: a flat surface carries no load as a shell, and has no lines of stress; raise its "
            "middle, or choose principal"
        )
    free = ~np.repeat(_held(own, stands_on, edge), 3)
    strain = _strains(own)
    count = 3 * len(own.points)
    stiffness = _stiffness(own, strain)[free][:, free]
    load = np.zeros((len(own.points), 3))
    for k in range(3):
        np.add.at(load[:, 2], own.triangles[:, k], -own.areas / 3)
    factors = splu(
        stiffness.tocsc(),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    moved = np.zeros(count)
    moved[free] = factors.solve(load.ravel()[free])
    found = np.einsum("tik,tk->ti", strain, moved[_coordinates(own.triangles)])
    plane = np.stack([found[:, [0, 2]], found[:, [2, 1]]], axis=1) * [[1, 0.5], [0.5, 1]]
    forces = own.axes.transpose(0, 2, 1) @ plane @ own.axes
    nearest: IntArray = cKDTree(own.points).query(mesh.points)[1]
    return _at_vertices(own, forces)[nearest]


def _alone(mesh: TriangleMesh, inner: int) -> tuple[FloatArray, IntArray]:
    """Points and triangles of the surface without its apron."""
    used, numbers = np.unique(mesh.triangles[:inner], return_inverse=True)
    return mesh.points[used], numbers.reshape(-1, 3)


def _held(mesh: TriangleMesh, stands_on: str, edge: float) -> BoolArray:
    """(V,) what the shell stands on."""
    if stands_on == "boundary":
        return mesh.on_rim
    held = np.zeros(len(mesh.points), dtype=bool)
    for loop in mesh.loops():
        held[np.array(loop)[corners_of(mesh.points[loop], edge)]] = True
    if held.sum() < _CORNERS:
        raise InputError(
            f"stands_on: the border has {int(held.sum())} corners, and a shell needs "
            f"{_CORNERS} to stand on; let it stand on the boundary"
        )
    return held


def _coordinates(vertices: IntArray) -> IntArray:
    """(n, 3 k) numbers of the coordinates of vertices (n, k)."""
    found: IntArray = 3 * np.repeat(vertices, 3, axis=1) + np.tile(range(3), vertices.shape[1])
    return found


def _strains(mesh: TriangleMesh) -> FloatArray:
    """(T, 3, 9) stretch along both axes, and shear, of a triangle whose corners move."""
    slopes = mesh.gradients()[:, :, None, :]
    first, second = (mesh.axes[:, None, k] for k in (0, 1))
    along, across = slopes[..., 0] * first, slopes[..., 1] * second
    shear = slopes[..., 0] * second + slopes[..., 1] * first
    return np.stack([along, across, shear], axis=1).reshape(-1, 3, 9)


def _stiffness(mesh: TriangleMesh, strain: FloatArray) -> coo_array:
    """(3 V, 3 V) of the membrane, a unit stiff, and of its hinges."""
    size = np.array([1.0, 1.0, 0.5])[:, None] * mesh.areas[:, None, None]
    membrane = strain.transpose(0, 2, 1) @ (size * strain)
    turns, weights, hinges = _hinges(mesh)
    bending = _THIN**2 * mesh.areas.sum() / 12
    bent = (bending * weights)[:, None, None] * turns[:, :, None] * turns[:, None, :]
    rows, columns, values = [], [], []
    for block, vertices in ((membrane, mesh.triangles), (bent, hinges)):
        numbers = _coordinates(vertices)
        rows.append(np.repeat(numbers, numbers.shape[1], axis=1).ravel())
        columns.append(np.tile(numbers, numbers.shape[1]).ravel())
        values.append(block.ravel())
    count = 3 * len(mesh.points)
    return coo_array(
        (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
        shape=(count, count),
    ).tocsr()


def _hinges(mesh: TriangleMesh) -> tuple[FloatArray, FloatArray, IntArray]:
    """How hinges turn when their four vertices move.

    Returns:
        (E, 12) angle over displacement, (E,) weights, and (E, 4) the vertices: ends of the edge and
        the corners opposite.
    """
    start, end = mesh.ends
    run = mesh.points[end] - mesh.points[start]
    square = (run * run).sum(axis=1)
    turns, opposite, area = np.zeros((len(run), 4, 3)), [], np.zeros(len(run))
    for side, half in enumerate(mesh.edges.T):
        triangle = half // 3
        corner = mesh.triangles[triangle, (half % 3 + 2) % 3]
        part = ((mesh.points[corner] - mesh.points[start]) * run).sum(axis=1) / square
        high = 2 * mesh.areas[triangle] / np.sqrt(square)
        across = mesh.normals[triangle] / high[:, None]
        turns[:, 2 + side] = across
        turns[:, 0] -= (1 - part)[:, None] * across
        turns[:, 1] -= part[:, None] * across
        opposite.append(corner)
        area += mesh.areas[triangle]
    return turns.reshape(-1, 12), 3 * square / area, np.stack([start, end, *opposite], axis=1)


def _at_vertices(mesh: TriangleMesh, values: FloatArray) -> FloatArray:
    """(V, 3, 3) means of the triangles around, by area."""
    sums, areas = np.zeros((len(mesh.points), 3, 3)), np.zeros(len(mesh.points))
    for k in range(3):
        np.add.at(sums, mesh.triangles[:, k], mesh.areas[:, None, None] * values)
        np.add.at(areas, mesh.triangles[:, k], mesh.areas)
    found: FloatArray = sums / areas[:, None, None]
    return found
