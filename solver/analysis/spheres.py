"""Spheres through vertex stars: principal symmetric nets and constant mean curvature."""

from __future__ import annotations

import numpy as np

from solver.analysis.measures import star_spokes
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# Radii are told apart from planes up to this many mean edges.
_LARGEST_RADIUS = 1e5
_STEPS = 12
# Centres that move less, in radii, have been found; or below the second, and not less any more.
_SETTLED, _ROUNDING = 1e-15, 1e-12
# Keeps normal equations of stars that determine no sphere regular.
_SINGULAR = 1e-15


def star_curvatures(mesh: QuadMesh, diagonal: bool = False) -> tuple[FloatArray, FloatArray]:
    """Curvature of the sphere that fits each interior star best, and the normal at its centre.

    Solves s . n = k |s|^2 / 2 for the four spokes s in the least-squares sense, with n the vertex
    normal plus a tangential correction: this stays well-posed where the star is planar.

    Returns:
        (S,) signed curvatures, positive towards the vertex normal, in 1 / model unit, and
        (S, 3) unit normals.
    """
    spokes = star_spokes(mesh, diagonal)
    if not len(spokes):
        return np.zeros(0), np.zeros((0, 3))
    normal = mesh.vertex_normals[mesh.connectivity.stars[:, 0]]
    _, first, second = np.moveaxis(_frame(normal, spokes[:, 0]), 1, 0)
    size = np.linalg.norm(spokes, axis=2).mean(axis=1)[:, None]
    system = np.stack(
        [
            -np.einsum("sij,sj->si", spokes, first),
            -np.einsum("sij,sj->si", spokes, second),
            0.5 * (spokes**2).sum(axis=2) / size,
        ],
        axis=2,
    )
    right = np.einsum("sij,sj->si", spokes, normal)
    solution = least_squares(system, right)
    tilted = normal + solution[:, :1] * first + solution[:, 1:2] * second
    stretch = np.linalg.norm(tilted, axis=1)
    return solution[:, 2] / size[:, 0] / stretch, tilted / stretch[:, None]


def common_radius(mesh: QuadMesh, diagonal: bool = False) -> float:
    """Signed radius that the star spheres share best: one over the median curvature."""
    return _radius(star_curvatures(mesh, diagonal)[0])


def _radius(curvatures: FloatArray) -> float:
    median = float(np.median(curvatures)) if len(curvatures) else 0.0
    return 1.0 / median if median != 0.0 else np.inf


def star_centres(mesh: QuadMesh, radius: float, diagonal: bool = False) -> FloatArray:
    """(S, 3) centres of the spheres of signed ``radius`` nearest to the five points of each star.

    Relative to the star's own centre vertex.
    """
    normal = star_curvatures(mesh, diagonal)[1]
    return _centres(star_spokes(mesh, diagonal), normal, radius)


def _centres(spokes: FloatArray, normal: FloatArray, radius: float) -> FloatArray:
    """Centres of the nearest spheres, sought from ``radius`` along the (S, 3) normals."""
    frame = _frame(normal, spokes[:, 0])
    centre = radius * normal
    points = np.concatenate([np.zeros_like(spokes[:, :1]), spokes], axis=1)
    before = np.inf
    for _ in range(_STEPS):
        away = centre[:, None, :] - points
        distance = np.sqrt(np.einsum("sij,sij->si", away, away))
        # In the star's own frame the columns differ in size only: flat stars are no special case.
        direction = (away / distance[:, :, None]) @ frame.swapaxes(1, 2)
        move = least_squares(direction, distance - abs(radius))
        centre = centre - np.einsum("sk,skj->sj", move, frame)
        longest = float(np.abs(move).max(initial=0.0))
        rounding = longest <= _ROUNDING * abs(radius) and longest >= 0.5 * before
        if rounding or longest <= _SETTLED * abs(radius):
            break
        before = longest
    return centre


def _frame(normal: FloatArray, hint: FloatArray) -> FloatArray:
    """(S, 3, 3) rows: the unit normals and two unit vectors across them."""
    first = unit_rows(np.cross(normal, unit_rows(hint)))
    return np.stack([normal, first, np.cross(normal, first)], axis=1)


def least_squares(system: FloatArray, right: FloatArray) -> FloatArray:
    """(S, 3) least-squares solutions of many (S, m, 3) systems; zero along what is not determined.

    By normal equations of columns scaled to one length and Cramer's rule, and once more for what is
    left, which restores the digits that squaring loses.
    """
    size = np.sqrt(np.einsum("smk,smk->sk", system, system))
    size[size == 0] = 1.0
    scaled = system / size[:, None, :]
    a, b, c = np.moveaxis(scaled.swapaxes(1, 2) @ scaled + _SINGULAR * np.eye(3), 1, 0)
    rows = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], axis=1)
    inverse = rows / np.einsum("sk,sk->s", a, rows[:, 0])[:, None, None]
    solution = np.zeros((len(system), 3))
    for _ in range(2):
        left = right - np.einsum("smk,sk->sm", scaled, solution)
        slope = np.einsum("smk,sm->sk", scaled, left)
        solution += np.einsum("skj,sj->sk", inverse, slope)
    return np.asarray(solution / size)


def cmc(mesh: QuadMesh, radius: float | None = None, diagonal: bool = False) -> FloatArray:
    """(S,) worst abs(distance of a star's five points from its sphere's centre - R) / mean edge.

    One R for all stars: the given one, else the common radius. Meshes flatter than a radius of
    100,000 mean edges are measured against that radius.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 10.
    """
    spokes = star_spokes(mesh, diagonal)
    if not len(spokes):
        return np.zeros(0)
    limit = _LARGEST_RADIUS * mesh.mean_edge
    curvatures, normal = star_curvatures(mesh, diagonal)
    wanted = _radius(curvatures) if radius is None else radius
    wanted = float(np.clip(wanted, -limit, limit))
    centre = _centres(spokes, normal, wanted)
    points = np.concatenate([np.zeros_like(spokes[:, :1]), spokes], axis=1)
    distance = np.linalg.norm(centre[:, None, :] - points, axis=2)
    return np.asarray(np.abs(distance - abs(wanted)).max(axis=1) / mesh.mean_edge)


def snet(mesh: QuadMesh, diagonal: bool = False) -> FloatArray:
    """(S,) distance of a star's points from the sphere that fits them / mean edge.

    Each star has a sphere of its own.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 9.
    """
    spokes = star_spokes(mesh, diagonal)
    if not len(spokes):
        return np.zeros(0)
    curvature, normal = star_curvatures(mesh, diagonal)
    heights = np.einsum("sij,sj->si", spokes, normal)
    miss = heights - 0.5 * curvature[:, None] * (spokes**2).sum(axis=2)
    return np.asarray(np.abs(miss).max(axis=1) / mesh.mean_edge)
