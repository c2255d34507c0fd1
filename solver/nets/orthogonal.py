"""Orthogonal mesh: both diagonals of every face are equally long."""

from __future__ import annotations

import math

import numpy as np

from solver.analysis import measures
from solver.errors import InputError
from solver.mesh.combed import Combed
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.net import Measure, Net, Way
from solver.nets.options import NetOptions, stars_of
from solver.problem import Problem, of_mesh
from solver.terms.medial_angle import MedialAngle
from solver.terms.orthogonality import Orthogonality


def orthogonal(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals only, or another angle of the medial lines.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 3 and the remark
    after lemma 4.
    """
    return require_angle(problem, options, 90.0 if options.angle is None else options.angle)


def require_angle(
    problem: Problem, options: NetOptions, degrees: float | None, across: bool = False
) -> Problem:
    """Require one angle between the medial lines, given in degrees or free.

    Args:
        problem: to which it is added.
        options: of the net.
        degrees: from family u to family v; None for one free angle of all faces.
        across: ask it of the diagonal meshes, from the diagonal before family u to the one after.

    Raises:
        InputError: the families of the mesh cannot be told apart.
    """
    if degrees == 90.0:
        return require_right_angles(problem, options, across)
    combed = Combed(problem.mesh.connectivity)
    if not combed.families:
        raise InputError(
            f"{problem.net} net: around an inner vertex of the mesh its two families of lines are "
            "exchanged, so that only a right angle is the same for all faces; give --angle 90"
        )
    chosen = _asked(problem, options, across)
    quads = combed.stars[:, 1:] if across else combed.faces
    start = float(np.median(measures.medial_angles(problem.mesh.vertices[quads[chosen]])))
    what = "vertex" if across else "face"
    numbers = problem.mesh.connectivity.stars[chosen, 0] if across else np.flatnonzero(chosen)

    def place(index: int) -> str:
        return f"{what} {numbers[index]}"

    if degrees is not None:
        wanted = math.radians(degrees)
        judged = of_mesh(measures.medial_angle, angle=wanted, chosen=chosen, diagonal=across)
        return problem.require(MedialAngle(quads[chosen], wanted), judged, place)
    shared = problem.scalar(start)
    number = shared - 3 * len(problem.mesh.vertices)
    problem.details["angle"] = lambda mesh, scalars: math.degrees(float(scalars[number]))

    def uneven(mesh: QuadMesh, scalars: FloatArray) -> FloatArray:
        wanted = float(scalars[number])
        return measures.medial_angle(mesh, angle=wanted, chosen=chosen, diagonal=across)

    return problem.require(MedialAngle(quads[chosen], shared=shared), uneven, place)


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
        place=30,
        title="orthogonal",
        condition="equal diagonals in every face",
        purpose="layouts that look square, cladding that bends",
        gives="Lines that cross at right angles, faces not flat.",
        measures=(ORTHOGONALITY,),
        options=("angle", "singular"),
        general=True,
        way=Way(calms=True),
    ),
)
