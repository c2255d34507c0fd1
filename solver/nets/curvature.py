"""Nets on minimal surfaces and surfaces of constant mean curvature."""

from __future__ import annotations

import numpy as np

from solver.analysis import measures, spheres
from solver.errors import InputError
from solver.nets.options import NetOptions
from solver.problem import Problem, of_mesh
from solver.terms.orthogonality import Orthogonality
from solver.terms.spherical_star import SphericalStar


def asymptotic(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals and planar stars: asymptotic lines of a minimal surface.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4.3.
    """
    stars = options.stars(problem)
    problem.require(Orthogonality(problem.mesh.faces), of_mesh(measures.orthogonality))
    return problem.require(
        SphericalStar(stars, curvature=0.0, name="asymptotic"),
        of_mesh(measures.asymptotic, diagonal=options.diagonal),
    )


def cmc(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals and star spheres of one radius, given or free.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 10.
    """
    stars = options.stars(problem)
    problem.require(Orthogonality(problem.mesh.faces), of_mesh(measures.orthogonality))
    curvatures, _ = spheres.star_curvatures(problem.mesh, options.diagonal)
    mean = float(np.median(curvatures)) * problem.scale
    radius = options.radius
    if radius is not None:
        _refuse_small(problem, radius, options.diagonal)
        radius = float(np.copysign(radius, mean))
        term = SphericalStar(stars, curvature=problem.scale / radius, name="cmc")
    else:
        term = SphericalStar(stars, shared=problem.scalar(mean), name="cmc")
    return problem.require(term, of_mesh(spheres.cmc, radius=radius, diagonal=options.diagonal))


def _refuse_small(problem: Problem, radius: float, diagonal: bool) -> None:
    """Say where a sphere of that radius could not hold a star."""
    spokes = np.linalg.norm(measures.star_spokes(problem.mesh, diagonal), axis=2).max(axis=1)
    smallest = 0.5 * float(spokes.max())
    if radius <= smallest:
        net = problem.mesh.connectivity
        vertex = (net.diagonal_stars if diagonal else net.stars)[int(np.argmax(spokes)), 0]
        raise InputError(
            f"radius: {radius:g} is too small for the star of vertex {vertex}, whose longest edge "
            f"is {spokes.max():.4g}; give more than {smallest:.4g}, or a finer mesh"
        )


def snet(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals and star spheres, each with a radius of its own.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 9.
    """
    stars = options.stars(problem)
    problem.require(Orthogonality(problem.mesh.faces), of_mesh(measures.orthogonality))
    return problem.require(
        SphericalStar(stars, name="snet"),
        of_mesh(spheres.snet, diagonal=options.diagonal),
    )
