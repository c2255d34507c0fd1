"""Spheres through vertex stars: principal symmetric nets and constant mean curvature."""

from __future__ import annotations

import numpy as np

from solver.analysis.measures import star_spokes
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# Radii are told apart from planes up to this many mean edges.
_LARGEST_RADIUS = 1e5
_STEPS = 12


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
    first = unit_rows(np.cross(normal, unit_rows(spokes[:, 0])))
    second = np.cross(normal, first)
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
    solution = np.einsum("sij,sj->si", np.linalg.pinv(system), right)
    tilted = normal + solution[:, :1] * first + solution[:, 1:2] * second
    stretch = np.linalg.norm(tilted, axis=1)
    return solution[:, 2] / size[:, 0] / stretch, tilted / stretch[:, None]


def common_radius(mesh: QuadMesh, diagonal: bool = False) -> float:
    """Signed radius that the star spheres share best: one over the median curvature."""
    curvatures, _ = star_curvatures(mesh, diagonal)
    if not len(curvatures):
        return np.inf
    median = float(np.median(curvatures))
    return 1.0 / median if median != 0.0 else np.inf


def star_centres(mesh: QuadMesh, radius: float, diagonal: bool = False) -> FloatArray:
    """(S, 3) centres of the spheres of signed ``radius`` nearest to the five points of each star.

    Relative to the star's own centre vertex.
    """
    spokes = star_spokes(mesh, diagonal)
    _, normal = star_curvatures(mesh, diagonal)
    centre = radius * normal
    points = np.concatenate([np.zeros_like(spokes[:, :1]), spokes], axis=1)
    for _ in range(_STEPS):
        away = centre[:, None, :] - points
        distance = np.linalg.norm(away, axis=2)
        direction = away / distance[:, :, None]
        miss = distance - abs(radius)
        centre = centre - np.einsum("sij,sj->si", np.linalg.pinv(direction), miss)
    return centre


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
    wanted = common_radius(mesh, diagonal) if radius is None else radius
    wanted = float(np.clip(wanted, -limit, limit))
    centre = star_centres(mesh, wanted, diagonal)
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
