"""Nets with planar faces: principal, planar, circular, conical."""

from __future__ import annotations

import numpy as np

from solver.analysis import measures
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.net import Easier, Measure, Net, Way
from solver.nets.options import NetOptions, stars_of
from solver.nets.orthogonal import ORTHOGONALITY, require_right_angles
from solver.problem import Problem, of_mesh
from solver.terms.face_angles import CircularFace
from solver.terms.flatness import FlatWithin, slack_of
from solver.terms.planarity import Planarity
from solver.terms.star_angles import ConicalStar


def principal(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals and planar faces: discrete principal curvature lines.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4.1.
    """
    require_right_angles(problem, options)
    return problem.require(Planarity(problem.mesh.faces), of_mesh(measures.planarity))


def planar(problem: Problem, options: NetOptions) -> Problem:
    """Require flat faces and nothing else, exactly or to a length.

    Source: Liu et al. (2006), Geometric modeling with conical meshes and developable surfaces.
    """
    if options.flatness is not None:
        return _flat_within(problem, options.flatness)
    if problem.mesh.connectivity.mixed:
        return _flat_polygons(problem)
    return problem.require(Planarity(problem.mesh.faces), of_mesh(measures.planarity))


def _flat_polygons(problem: Problem) -> Problem:
    """Require flat faces of any number of corners: any four in a row of a face lie in a plane.

    Raises:
        InputError: there are only triangles.
    """
    net = problem.mesh.connectivity
    if not len(net.flat_quads):
        raise InputError(
            "planar net: all faces are triangles, which are flat as they are; nothing is to be done"
        )
    face = net.flat_quads_faces
    return problem.require(
        Planarity(net.flat_quads),
        of_mesh(measures.four_in_plane),
        lambda index: f"face {face[index]}",
    )


def _flat_within(problem: Problem, flatness: float) -> Problem:
    """Require faces whose diagonals are no further apart than ``flatness``, in model units."""
    faces, limit = problem.mesh.faces, flatness / problem.scale
    a, b, c, d = problem.mesh.vertices[faces].transpose(1, 0, 2)
    signed = np.einsum("ij,ij->i", 0.5 * (a + c - b - d), problem.mesh.face_normals)
    slack = problem.scalars(slack_of(signed / problem.scale, limit))

    def beyond(mesh: QuadMesh, scalars: FloatArray) -> FloatArray:
        gaps = measures.diagonal_distances(mesh)
        return np.asarray(np.maximum(gaps - flatness, 0.0) / problem.scale)

    return problem.require(FlatWithin(faces, slack, limit), beyond)


def circular(problem: Problem, options: NetOptions) -> Problem:
    """Require planar faces with a circle through their corners.

    Source: Bobenko, Suris (2008), Discrete Differential Geometry.
    """
    faces = problem.mesh.faces
    problem.require(Planarity(faces), of_mesh(measures.planarity))
    return problem.require(CircularFace(faces), of_mesh(measures.circular))


def conical(problem: Problem, options: NetOptions) -> Problem:
    """Require planar faces that touch a common cone at every vertex.

    Source: Liu et al. (2006), Geometric modeling with conical meshes and developable surfaces.
    """
    stars = stars_of(problem)
    problem.require(Planarity(problem.mesh.faces), of_mesh(measures.planarity))
    return problem.require(ConicalStar(stars), of_mesh(measures.conical))


PLANARITY = Measure("planarity", measures.planarity, "face")

NETS = (
    Net(
        "principal",
        principal,
        place=10,
        title="principal: flat panels",
        condition="equal diagonals, flat faces",
        purpose="flat panels on beams without twist",
        gives="Flat faces with right angles; torsion-free beams.",
        measures=(ORTHOGONALITY, PLANARITY),
        options=("singular",),
        along_curvature=True,
    ),
    Net(
        "planar",
        planar,
        place=20,
        title="planar: flat faces",
        condition="flat faces",
        purpose="flat panels on a surface that is to stay as it is",
        gives="Flat faces of any angles, near the surface that was drawn.",
        abbreviation="planar",
        measures=(PLANARITY,),
        options=("flatness",),
        general=True,
        conjugate=True,
        nearest=True,
        any_faces=True,
    ),
    Net(
        "circular",
        circular,
        place=40,
        title="circular",
        condition="flat faces with a circle through their corners",
        purpose="flat panels, second layer at equal distance from the vertices",
        gives="Flat faces, each with a circle through its corners.",
        measures=(PLANARITY, Measure("circular", measures.circular, "face")),
        along_curvature=True,
        way=Way(easier=(Easier("principal"),), righted=True),
    ),
    Net(
        "conical",
        conical,
        place=50,
        title="conical",
        condition="flat faces that touch a cone at every vertex",
        purpose="flat panels, layers of constant thickness",
        gives="Flat faces with an exact offset at constant thickness.",
        measures=(PLANARITY, Measure("conical", measures.conical, "vertex")),
        along_curvature=True,
        way=Way(easier=(Easier("principal"),)),
    ),
)
