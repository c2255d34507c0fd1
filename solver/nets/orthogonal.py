"""Orthogonal mesh: both diagonals of every face are equally long."""

from __future__ import annotations

import math

import numpy as np

from solver.analysis import measures
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.nets.net import Measure, Net
from solver.nets.options import NetOptions, stars_of
from solver.problem import Problem, of_mesh
from solver.terms.medial_angle import MedialAngle
from solver.terms.orthogonality import Orthogonality


def orthogonal(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals only, or another angle of the medial lines.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 3 and the remark
    after lemma 4.
    """
    if options.angle == 90.0:
        return require_right_angles(problem, options)
    faces, chosen = problem.mesh.faces, _asked(problem, options, diagonal=False)
    angle, numbers = math.radians(options.angle), np.flatnonzero(chosen)
    return problem.require(
        MedialAngle(faces[chosen], angle),
        of_mesh(measures.medial_angle, angle=angle, chosen=chosen),
        lambda index: f"face {numbers[index]}",
    )


def require_right_angles(problem: Problem, options: NetOptions, across: bool = False) -> Problem:
    """Require equal diagonals of all faces, or ``across`` them of those of the diagonal meshes.

    What is asked of the lines through a star's opposite corners belongs to a net of these lines,
    and they have to cross at right angles, not the edges. A face of a diagonal mesh has the four
    neighbours of a vertex for corners. Faces at singular vertices are left out unless
    ``options.singular`` says otherwise: with other than four of them around a vertex, equal
    diagonals in each would crease the smooth surface there.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, sections 2 and 4.3.
    """
    net = problem.mesh.connectivity
    quads: IntArray = stars_of(problem)[:, 1:] if across else net.faces
    chosen = _asked(problem, options, across)
    numbers = net.stars[chosen, 0] if across else np.flatnonzero(chosen)
    what = "vertex" if across else "face"
    return problem.require(
        Orthogonality(quads[chosen]),
        of_mesh(measures.orthogonality, diagonal=across, chosen=chosen),
        lambda index: f"{what} {numbers[index]}",
    )


def _asked(problem: Problem, options: NetOptions, diagonal: bool) -> BoolArray:
    """Which faces, or stars, have to have right angles.

    Raises:
        InputError: none would be left.
    """
    left_out = ORTHOGONALITY.left_out(problem.mesh, diagonal)
    if options.singular == "include":
        return np.ones_like(left_out)
    if left_out.all():
        raise InputError(
            f"{problem.net} net: every face touches an inner vertex where more or fewer than four "
            "faces meet, where no right angles are asked; subdivide the mesh, or include them "
            "(--singular include)"
        )
    problem.exempt = int(left_out.sum())
    return ~left_out


ORTHOGONALITY = Measure(
    "orthogonality", measures.orthogonality, "face", across="vertex", square=True
)

NETS = (
    Net(
        "orthogonal",
        orthogonal,
        place=3,
        title="orthogonal",
        condition="equal diagonals in every face",
        purpose="layouts that look square, cladding that bends",
        gives="Lines that cross at right angles, faces not flat.",
        measures=(ORTHOGONALITY,),
        options=("angle", "singular"),
        general=True,
    ),
)
