"""Isogonal nets: all lines cross at one angle, which is given or found."""

from __future__ import annotations

from solver.analysis import measures
from solver.nets.net import Measure, Net, Way
from solver.nets.options import NetOptions
from solver.nets.orthogonal import require_angle
from solver.problem import Problem


def isogonal(problem: Problem, options: NetOptions) -> Problem:
    """Require one angle between the medial lines of all faces, given or free.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 2, after lemma 4, on
    medial lines as tangents of the lines.
    """
    return require_angle(problem, options, options.angle)


NETS = (
    Net(
        "isogonal",
        isogonal,
        place=35,
        title="isogonal: one angle",
        condition="one angle between the lines, given or free",
        purpose="layouts of equal parallelograms, nodes at which all lines cross alike",
        gives="Lines that all cross at one angle, faces not flat.",
        measures=(
            Measure("even angle", measures.uneven_angle, "face", across="vertex", square=True),
        ),
        options=("angle", "singular"),
        general=True,
        way=Way(calms=True),
    ),
)
