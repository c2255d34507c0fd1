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
    _require_tilts(problem, combed, given)
    return problem


def _require_tilts(
    problem: Problem, combed: Combed, given: tuple[float | None, float | None]
) -> None:
    """Require one tilt of the lines of each family, given in degrees or free."""
    ends = np.stack([combed.stars[:, [3, 1]], combed.stars[:, [4, 2]]], axis=1)
    tilts = [0.0, 0.0]
    shared: list[int | None] = [None, None]
    for family, degrees in enumerate(given):
        if degrees is not None:
            tilts[family] = math.radians(degrees)
            continue
        start = lines.common_tilt(*lines.family_bends(problem.mesh, family))
        shared[family] = place = problem.scalar(start)
        number = place - 3 * len(problem.mesh.vertices)
        problem.details[f"tilt {'uv'[family]}"] = partial(_found, number)

    def off(mesh: QuadMesh, scalars: FloatArray) -> FloatArray:
        """(S,) part of the turns of the lines that is not at the tilt of their family, radians."""
        begin = 3 * len(mesh.vertices)
        now = [
            tilt if number is None else float(scalars[number - begin])
            for tilt, number in zip(tilts, shared, strict=True)
        ]
        each = [lines.off_tilt(*lines.family_bends(mesh, k), now[k]) for k in (0, 1)]
        return np.maximum(*each)

    problem.require(TiltedLine(combed.stars, ends, tuple(tilts), tuple(shared)), off)


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
        turning=("tilt_u", "tilt_v"),
        way=Way(evenness=(3.0, 30.0), calms=True),
    ),
)
