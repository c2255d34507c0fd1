"""Webs: two families of lines and one of diagonals that are asymptotic or geodesic."""

from __future__ import annotations

from functools import partial

from solver.analysis import lines
from solver.errors import InputError
from solver.mesh.combed import Combed
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.net import Measure, Net, Way
from solver.nets.options import NetOptions, stars_of
from solver.problem import Problem
from solver.terms.tilted_line import TiltedLine

_FAMILIES = ("first", "second", "diagonal")
_WORDS = {"a": "asymptotic", "g": "geodesic"}


def web(problem: Problem, options: NetOptions) -> Problem:
    """Require that both families of lines and one of diagonals are asymptotic or geodesic.

    Source: Schling, Wang, Hoyer, Pottmann (2022), Designing asymptotic geodesic hybrid gridshells.
    """
    stars_of(problem)
    combed = Combed(problem.mesh.connectivity)
    if not combed.families:
        raise InputError(
            f"{problem.net} net: around an inner vertex of the mesh its families of lines are "
            "exchanged, and so are those of diagonals; give a mesh where an even number of faces "
            "meet at every inner vertex"
        )
    parts = lines.web_parts(problem.mesh, options.web)
    for family, letter, (ends, tilt) in zip(_FAMILIES, options.web, parts, strict=True):
        problem.require(
            TiltedLine(combed.stars, ends, (tilt,), name=f"{family} {_WORDS[letter]}"),
            partial(_off, combed.stars, ends, tilt),
        )
    return problem


def _off(
    stars: IntArray, ends: IntArray, tilt: float, mesh: QuadMesh, scalars: FloatArray
) -> FloatArray:
    """(S,) part of the turns of a family of lines that is not at its tilt, in radians."""
    return lines.off_tilt(*lines.bends(mesh, stars, ends), tilt)


NETS = (
    Net(
        "web",
        web,
        place=105,
        title="web: three layers of slats",
        condition="both families of lines and one of diagonals asymptotic or geodesic",
        purpose="grid shells braced by a third layer, all of straight slats",
        gives="Three families of straight slats, which brace each other.",
        measures=(Measure("web", lines.web, "vertex"),),
        options=("web",),
        asymptotic=lambda options: options.web == "aag",
        telling=True,
        general=True,
        way=Way(evenness=(3.0, 30.0)),
    ),
)
