"""Nets on minimal surfaces and surfaces of constant mean curvature."""

from __future__ import annotations

import numpy as np

from solver.analysis import measures, spheres
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.net import Measure, Net, Way
from solver.nets.options import NetOptions
from solver.nets.orthogonal import ORTHOGONALITY, require_right_angles
from solver.problem import Problem, of_mesh
from solver.terms.spherical_star import SphericalStar


def asymptotic(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals and planar stars (E_Anet): asymptotic lines of a minimal surface.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4.3.
    """
    stars = options.stars(problem)
    require_right_angles(problem, options, options.diagonal)
    return problem.require(
        SphericalStar(stars, curvature=0.0, name="asymptotic"),
        of_mesh(measures.asymptotic, diagonal=options.diagonal),
    )


def cmc(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals and star spheres of one radius, given or free.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 10.
    """
    stars = options.stars(problem)
    require_right_angles(problem, options, options.diagonal)
    curvatures, _ = spheres.star_curvatures(problem.mesh, options.diagonal)
    mean = float(np.median(curvatures)) * problem.scale
    radius = options.radius
    if radius is not None:
        _refuse_small(problem, radius, options.diagonal)
        radius = float(np.copysign(radius, mean))
        term = SphericalStar(stars, curvature=problem.scale / radius, name="cmc")
    else:
        shared = problem.scalar(mean)
        term = SphericalStar(stars, shared=shared, name="cmc")
        number = shared - 3 * len(problem.mesh.vertices)

        def found(mesh: QuadMesh, scalars: FloatArray) -> float:
            curvature = float(abs(scalars[number])) / problem.scale
            return 1 / curvature if curvature > 0 else 0.0

        problem.details["radius"] = found
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
    require_right_angles(problem, options, options.diagonal)
    return problem.require(
        SphericalStar(stars, name="snet"),
        of_mesh(spheres.snet, diagonal=options.diagonal),
    )


ASYMPTOTIC = Measure("asymptotic", measures.asymptotic, "vertex", across="vertex")

NETS = (
    Net(
        "asymptotic",
        asymptotic,
        place=100,
        title="asymptotic: minimal",
        condition="equal diagonals, flat stars",
        purpose="minimal surfaces; straight lamellas upright on the surface",
        gives="A minimal surface with straight upright lamellas.",
        measures=(
            ORTHOGONALITY,
            ASYMPTOTIC,
        ),
        options=("diagonal", "singular"),
        begins_as="asymptotic",
        shape="minimal",
        way=Way(evenness=(3.0, 30.0)),
    ),
    Net(
        "cmc",
        cmc,
        place=110,
        title="constant mean curvature",
        condition="equal diagonals, stars on spheres of one radius",
        purpose="pneumatic shapes; lamellas that are arcs of one radius",
        gives="Constant mean curvature; lamellas unroll to equal arcs.",
        abbreviation="CMC",
        colours="Mean curvature",
        measures=(
            ORTHOGONALITY,
            Measure("cmc", spheres.cmc, "vertex", across="vertex", shown="CMC"),
        ),
        options=("diagonal", "radius", "singular"),
        begins_as="cmc",
        way=Way(evenness=(3.0, 30.0), righted=True),
    ),
    Net(
        "snet",
        snet,
        place=120,
        title="spherical stars",
        abbreviation="S-net",
        condition="equal diagonals, stars on spheres",
        purpose="lamellas that are arcs",
        gives="Each vertex lies on one sphere with its neighbours.",
        measures=(
            ORTHOGONALITY,
            Measure("snet", spheres.snet, "vertex", across="vertex", shown="Spherical stars"),
        ),
        options=("diagonal", "singular"),
        begins_as="cmc",
        general=True,
    ),
)
