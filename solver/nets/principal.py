"""Nets with planar faces: principal, circular, conical."""

from __future__ import annotations

from solver.analysis import measures
from solver.nets.options import NetOptions, stars_of
from solver.problem import Problem, of_mesh
from solver.terms.face_angles import CircularFace
from solver.terms.orthogonality import Orthogonality
from solver.terms.planarity import Planarity
from solver.terms.star_angles import ConicalStar


def principal(problem: Problem, options: NetOptions) -> Problem:
    """Require equal diagonals and planar faces: discrete principal curvature lines.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4.1.
    """
    faces = problem.mesh.faces
    problem.require(Orthogonality(faces), of_mesh(measures.orthogonality))
    return problem.require(Planarity(faces), of_mesh(measures.planarity))


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
