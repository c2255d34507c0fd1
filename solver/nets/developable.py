"""Nets on developable surfaces: geodesic, stricter geodesic, Chebyshev, isometric."""

from __future__ import annotations

from functools import partial

import numpy as np

from solver.analysis import measures
from solver.errors import InputError
from solver.mesh.diagonal import diagonal_families
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.net import Measure, Net, Way
from solver.nets.options import NetOptions
from solver.nets.orthogonal import ORTHOGONALITY, require_right_angles
from solver.problem import Problem, of_mesh
from solver.terms.chebyshev import EqualEdges
from solver.terms.isometry import Isometry
from solver.terms.star_angles import EqualAngleStar, GeodesicStar


def geodesic(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals and equal opposite angles at every star.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 6.
    """
    stars = options.stars(problem)
    require_right_angles(problem, options, options.diagonal)
    return problem.require(
        GeodesicStar(stars), of_mesh(measures.geodesic, diagonal=options.diagonal)
    )


def dog(problem: Problem, options: NetOptions) -> Problem:
    """Require four equal angles at every star.

    Source: Rabinovich, Hoffmann, Sorkine-Hornung (2018), Discrete geodesic nets for modeling
    developable surfaces.
    """
    return problem.require(
        EqualAngleStar(options.stars(problem)),
        of_mesh(measures.equal_angles, diagonal=options.diagonal),
    )


def chebyshev(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals and equal edges, or equal edges in each family.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 7.
    """
    require_right_angles(problem, options, options.diagonal)
    return _equal_edges(problem, options)


def geodesic_chebyshev(problem: Problem, options: NetOptions) -> Problem:
    """Require a net that is geodesic and Chebyshev at once.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, figure 14 (e, f).
    """
    return _equal_edges(geodesic(problem, options), options)


def isometric(problem: Problem, options: NetOptions) -> Problem:
    """Require that every face keeps the shape it has in the reference.

    Source: Jiang et al. (2021), Using isometries for computational design and fabrication.
    """
    reference = problem.mesh.vertices if options.reference is None else options.reference
    if reference.shape != problem.mesh.vertices.shape:
        raise InputError(
            f"reference: expected {len(problem.mesh.vertices)} vertices as in the mesh, got "
            f"{len(reference)}; give the same mesh in another shape"
        )
    return problem.require(
        Isometry(problem.mesh.faces, reference / problem.scale),
        of_mesh(measures.isometry, reference=reference),
    )


def _equal_edges(problem: Problem, options: NetOptions) -> Problem:
    net, across = problem.mesh.connectivity, options.diagonal
    edges = net.diagonal_edges if across else net.edges
    family = np.zeros(len(edges), dtype=np.int64)
    if options.per_family:
        family = diagonal_families(net) if across else net.edge_families
    ends = problem.mesh.vertices[edges]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) / problem.scale
    for number in range(int(family.max()) + 1):
        chosen = family == number
        name = "chebyshev" if number == 0 else f"chebyshev {number + 1}"
        if options.length is not None:
            term = EqualEdges(edges[chosen], length=options.length / problem.scale, name=name)
        else:
            shared = problem.scalar(float(lengths[chosen].mean()))
            term = EqualEdges(edges[chosen], shared=shared, name=name)
            word = "length" if number == 0 else f"length {number + 1}"
            problem.details[word] = partial(_length, problem, shared)
        measure = of_mesh(
            measures.equal_edges, chosen=chosen, length=options.length, diagonal=across
        )
        problem.require(term, measure)
    return problem


def _length(problem: Problem, shared: int, mesh: QuadMesh, scalars: FloatArray) -> float:
    """The edge length that was found, in model units."""
    return float(scalars[shared - 3 * len(mesh.vertices)]) * problem.scale


GEODESIC = Measure("geodesic", measures.geodesic, "vertex", across="vertex")
EQUAL_ANGLES = Measure("equal angles", measures.equal_angles, "vertex", across="vertex")
CHEBYSHEV = Measure("chebyshev", measures.chebyshev, "edge", across="face")

NETS = (
    Net(
        "geodesic",
        geodesic,
        place=60,
        title="geodesic: developable",
        condition="equal diagonals, equal opposite angles in every star",
        purpose="sheet bent from flat, ribs that unroll straight",
        gives="A developable surface: it is bent from flat sheet.",
        measures=(ORTHOGONALITY, GEODESIC),
        options=("diagonal", "singular"),
        shape="developable",
        flat=True,
        way=Way(bent=True),
    ),
    Net(
        "dog",
        dog,
        place=70,
        title="geodesic, four equal angles",
        abbreviation="DOG",
        condition="four equal angles in every star",
        purpose="the same, stricter",
        gives="A developable surface, by the stricter definition.",
        measures=(EQUAL_ANGLES,),
        options=("diagonal",),
        shape="developable",
        flat=True,
        way=Way(bent=True),
    ),
    Net(
        "chebyshev",
        chebyshev,
        place=80,
        title="Chebyshev: equal edges",
        condition="equal diagonals, all edges equally long",
        purpose="rods or fabric of one mesh width",
        gives="A developable surface of squares, all edges equal.",
        measures=(ORTHOGONALITY, CHEBYSHEV),
        options=("diagonal", "length", "per_family", "singular"),
        shape="developable",
        flat=True,
        way=Way(bent=True),
    ),
    Net(
        "geodesic-chebyshev",
        geodesic_chebyshev,
        place=90,
        title="geodesic and Chebyshev",
        abbreviation="geod.-Cheb.",
        condition="both",
        purpose="sheet with a regular grid on it",
        gives="A developable surface of geodesic squares.",
        measures=(ORTHOGONALITY, GEODESIC, CHEBYSHEV),
        options=("diagonal", "length", "per_family", "singular"),
        shape="developable",
        flat=True,
        way=Way(bent=True, rigid=True),
    ),
    Net(
        "isometric",
        isometric,
        place=140,
        title="isometric: faces keep shape",
        condition="every face keeps its shape",
        purpose="bending a developed sheet",
        gives="Faces keep the shape they have: paper that is bent.",
        options=("reference",),
        flat=True,
    ),
)
