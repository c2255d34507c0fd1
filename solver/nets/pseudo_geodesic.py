"""Pseudo-geodesic nets: strips at one angle to the surface that unroll straight."""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from solver.analysis import lines
from solver.errors import InputError
from solver.mesh.combed import Combed
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.net import Measure, Net, Way
from solver.nets.options import NetOptions, stars_of
from solver.nets.orthogonal import require_angle
from solver.problem import Problem
from solver.terms.tilted_line import TiltedLine

# Tilts that do not ask which way a line runs, degrees.
_EITHER_WAY = (0.0, 90.0, 180.0)


def pseudo_geodesic(problem: Problem, options: NetOptions) -> Problem:
    """Require that the lines of each family bend at one angle to the surface normal.

    The strip along such a line that unrolls straight stands at that angle to the surface: upright
    along asymptotic lines, lying along geodesics. Given or free angles, one for each family.

    Source: Wang et al. (2023), Rectifying strip patterns.
    """
    stars_of(problem)
    if options.angle is not None:
        require_angle(problem, options, options.angle)
    combed = Combed(problem.mesh.connectivity)
    given = (options.tilt_u, options.tilt_v)
    if not combed.oriented and not all(tilt in _EITHER_WAY for tilt in given):
        raise InputError(
            f"{problem.net} net: around an inner vertex of the mesh its lines come back the other "
            "way, so that strips would lean to both sides; give --tilt-u and --tilt-v of 90 "
            "(upright) or 180 (lying), or a mesh without irregular vertices inside"
        )
    for family, tilt in enumerate(given):
        _require_tilt(problem, combed, family, tilt)
    return problem


def _require_tilt(problem: Problem, combed: Combed, family: int, degrees: float | None) -> None:
    """Require one tilt of the lines of a family, given in degrees or free."""
    ends = combed.stars[:, [3 + family, 1 + family]]
    name = f"tilt {'uv'[family]}"
    if degrees is not None:
        wanted = math.radians(degrees)
        problem.require(
            TiltedLine(combed.stars, ends, tilt=wanted, name=name),
            lambda mesh, _: _off(mesh, family, wanted),
        )
        return
    start = lines.common_tilt(*lines.family_bends(problem.mesh, family))
    shared = problem.scalar(start)
    number = shared - 3 * len(problem.mesh.vertices)
    problem.details[name] = partial(_found, number)
    problem.require(
        TiltedLine(combed.stars, ends, shared=shared, name=name),
        lambda mesh, scalars: _off(mesh, family, float(scalars[number])),
    )


def _off(mesh: QuadMesh, family: int, tilt: float) -> FloatArray:
    """(S,) part of the turns of the lines of a family that is not at a tilt in radians."""
    return lines.off_tilt(*lines.family_bends(mesh, family), tilt)


def _found(number: int, mesh: QuadMesh, scalars: FloatArray) -> float:
    """The tilt that was found, degrees from 0 to 180."""
    return float(np.degrees(scalars[number]) % 180.0)


NETS = (
    Net(
        "pseudo-geodesic",
        pseudo_geodesic,
        place=103,
        title="pseudo-geodesic: tilted",
        condition="lines bend at one angle to the surface, given or free, for each family",
        purpose="lamellas at one angle to the surface that unroll straight",
        gives="Tilted lamellas that unroll straight, one angle a family.",
        abbreviation="pseudo-geod.",
        measures=(Measure("tilt", lines.tilt, "vertex"),),
        options=("tilt_u", "tilt_v", "angle", "singular"),
        general=True,
        telling=True,
        stays=True,
        way=Way(evenness=(3.0, 30.0)),
    ),
)
