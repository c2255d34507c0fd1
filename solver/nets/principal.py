"""Nets with planar faces: principal, planar, circular, conical."""

from __future__ import annotations

from solver.analysis import measures
from solver.nets.net import Easier, Measure, Net, Way
from solver.nets.options import NetOptions, stars_of
from solver.nets.orthogonal import ORTHOGONALITY, require_right_angles
from solver.problem import Problem, of_mesh
from solver.terms.face_angles import CircularFace
from solver.terms.planarity import Planarity
from solver.terms.star_angles import ConicalStar


def principal(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals and planar faces: discrete principal curvature lines.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4.1.
    """
    require_right_angles(problem, options)
    return problem.require(Planarity(problem.mesh.faces), of_mesh(measures.planarity))


def planar(problem: Problem, options: NetOptions) -> Problem:
    """Require flat faces and nothing else.

    Source: Liu et al. (2006), Geometric modeling with conical meshes and developable surfaces.
    """
    return problem.require(Planarity(problem.mesh.faces), of_mesh(measures.planarity))


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
        place=1,
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
        place=2,
        title="planar: flat faces",
        condition="flat faces",
        purpose="flat panels on a surface that is to stay as it is",
        gives="Flat faces of any angles, near the surface that was drawn.",
        abbreviation="planar",
        measures=(PLANARITY,),
        general=True,
        nearest=True,
    ),
    Net(
        "circular",
        circular,
        place=4,
        title="circular",
        condition="flat faces with a circle through their corners",
        purpose="flat panels, second layer at equal distance from the vertices",
        gives="Flat faces, each with a circle through its corners.",
        measures=(PLANARITY, Measure("circular", measures.circular, "face")),
        along_curvature=True,
        way=Way(easier=(Easier("principal"),)),
    ),
    Net(
        "conical",
        conical,
        place=5,
        title="conical",
        condition="flat faces that touch a cone at every vertex",
        purpose="flat panels, layers of constant thickness",
        gives="Flat faces with an exact offset at constant thickness.",
        measures=(PLANARITY, Measure("conical", measures.conical, "vertex")),
        along_curvature=True,
        way=Way(easier=(Easier("principal"),)),
    ),
)
