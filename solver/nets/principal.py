"""Principal mesh: orthogonal faces that are planar."""

from __future__ import annotations

from solver.analysis import measures
from solver.problem import Problem
from solver.terms.orthogonality import Orthogonality
from solver.terms.planarity import Planarity


def principal(problem: Problem) -> Problem:
    """Require equal diagonals and planar faces: discrete principal curvature lines.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4.1.
    """
    faces = problem.mesh.faces
    return problem.require(Orthogonality(faces), measures.orthogonality).require(
        Planarity(faces), measures.planarity
    )
