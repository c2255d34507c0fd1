"""Orthogonal mesh: both diagonals of every face are equally long."""

from __future__ import annotations

import math

from solver.analysis import measures
from solver.nets.net import Measure, Net
from solver.nets.options import NetOptions
from solver.problem import Problem, of_mesh
from solver.terms.medial_angle import MedialAngle
from solver.terms.orthogonality import Orthogonality


def orthogonal(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals only, or another angle of the medial lines.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 3 and the remark
    after lemma 4.
    """
    faces = problem.mesh.faces
    if options.angle == 90.0:
        return problem.require(Orthogonality(faces), of_mesh(measures.orthogonality))
    angle = math.radians(options.angle)
    return problem.require(MedialAngle(faces, angle), of_mesh(measures.medial_angle, angle=angle))


ORTHOGONALITY = Measure("orthogonality", measures.orthogonality, "face")

NETS = (
    Net(
        "orthogonal",
        orthogonal,
        place=2,
        title="orthogonal",
        condition="equal diagonals in every face",
        purpose="layouts that look square, cladding that bends",
        gives="Lines that cross at right angles, faces not flat.",
        measures=(ORTHOGONALITY,),
        options=("angle",),
        general=True,
    ),
)
