"""Orthogonal mesh: both diagonals of every face are equally long."""

from __future__ import annotations

from solver.analysis import measures
from solver.problem import Problem
from solver.terms.orthogonality import Orthogonality


def orthogonal(problem: Problem) -> Problem:
    """Require equal diagonals only.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 3.
    """
    return problem.require(Orthogonality(problem.mesh.faces), measures.orthogonality)
