"""Isothermic nets: circular ones that have a Christoffel dual."""

from __future__ import annotations

from solver.analysis import measures
from solver.analysis.koenigs import koenigs
from solver.nets.net import Easier, Measure, Net, Way
from solver.nets.options import NetOptions, stars_of
from solver.nets.principal import PLANARITY, circular
from solver.problem import Problem, of_mesh
from solver.terms.koenigs_star import KoenigsStar


def isothermic(problem: Problem, options: NetOptions) -> Problem:
    """Require a circle through the corners of each flat face, and a dual around each vertex.

    Source: Bobenko, Suris (2009), Discrete Koenigs nets and discrete isothermic surfaces.
    """
    stars_of(problem)
    circular(problem, options)
    net = problem.mesh.connectivity
    return problem.require(KoenigsStar(net.stars, net.diagonal_stars[:, 1:]), of_mesh(koenigs))


NETS = (
    Net(
        "isothermic",
        isothermic,
        place=55,
        title="isothermic: has a dual",
        condition="circular, the ratios of the diagonals multiply to one around every vertex",
        purpose="panels as near to squares as the surface allows, minimal surfaces by the dual",
        gives="Flat faces of steady proportions, and a dual net with parallel edges.",
        abbreviation="isothermic",
        measures=(
            PLANARITY,
            Measure("circular", measures.circular, "face"),
            Measure("dual ratio", koenigs, "vertex"),
        ),
        along_curvature=True,
        way=Way(easier=(Easier("circular"),), calms=True),
    ),
)
