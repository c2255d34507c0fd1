"""Asymptotic nets at a constant angle: surfaces with one ratio of the principal curvatures."""

from __future__ import annotations

from solver.analysis import measures
from solver.nets.curvature import ASYMPTOTIC
from solver.nets.net import Measure, Net, Way
from solver.nets.options import NetOptions
from solver.nets.orthogonal import require_angle
from solver.problem import Problem, of_mesh
from solver.terms.spherical_star import SphericalStar


def asymptotic_angle(problem: Problem, options: NetOptions) -> Problem:
    """Require flat stars and one angle between the medial lines, given or free.

    Asymptotic lines meet at an angle g with tan(g / 2)^2 = -k1 / k2, so that the ratio of the
    principal curvatures is one all over the surface. At a right angle it is minimal.

    Source: Wang, Pottmann (2022), Characteristic parameterizations of surfaces with a constant
    ratio of principal curvatures.
    """
    stars = options.stars(problem)
    require_angle(problem, options, options.angle, options.diagonal)
    return problem.require(
        SphericalStar(stars, curvature=0.0, name="asymptotic"),
        of_mesh(measures.asymptotic, diagonal=options.diagonal),
    )


NETS = (
    Net(
        "asymptotic-angle",
        asymptotic_angle,
        place=101,
        title="asymptotic: one angle",
        condition="flat stars, one angle between the lines, given or free",
        purpose="straight upright lamellas and equal nodes on saddles that are not minimal",
        gives="Straight upright lamellas that all cross at one angle.",
        abbreviation="asympt. angle",
        measures=(
            Measure("even angle", measures.uneven_angle, "face", across="vertex", square=True),
            ASYMPTOTIC,
        ),
        options=("diagonal", "angle", "singular"),
        shape="saddle",
        begins_as="asymptotic-angle",
        asymptotic=lambda options: True,
        general=True,
        telling=True,
        way=Way(evenness=(3.0, 30.0)),
    ),
)
