"""A net that somebody poses term by term, without an entry in the table of nets."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh, refuse_other
from solver.nets.constraints import Constraints, add_constraints, corners_that_stay, settled
from solver.nets.settings import Weights, add_guides, fixed_vertices
from solver.optimise import refuse_no_end
from solver.problem import Problem
from solver.report import Outcome, StepRecord
from solver.run import Optimisation
from solver.terms.base import Term


def pose(
    mesh: QuadMesh,
    name: str = "own",
    *,
    fix: str | Sequence[int | str] = "none",
    constraints: Constraints | None = None,
    weights: Weights | None = None,
) -> Problem:
    """A problem of which nothing is required yet but what holds its vertices.

    The guides that lead to every net lead to this one too. Terms are added with
    :meth:`Problem.require`, other guides with :meth:`Problem.guide`.

    Args:
        mesh: the start, in any unit, not far from the origin.
        name: what reports call the net.
        fix: ``none``, ``corners``, ``boundary``, vertex numbers or several of it (``boundary,5``);
            these vertices keep every bit.
        constraints: handles, gliding, a surface to stay near, symmetry.
        weights: of the guides at the start, by default those of every net.

    Raises:
        InputError: a vertex that does not exist, nothing to glide, no mirror image.
    """
    refuse_other(mesh)
    wanted, lead = constraints or Constraints(), weights or Weights()
    fixed = fixed_vertices(mesh, fix)
    fixed[corners_that_stay(mesh, wanted)] = True
    problem = Problem(name, mesh, fixed)
    add_constraints(problem, settled(mesh, fixed, wanted), lead.closeness)
    return add_guides(problem, [lead])


def solve(
    problem: Problem,
    *,
    tolerance: float = 1e-10,
    max_steps: int = 1000,
    backend: str | None = None,
    callback: Callable[[StepRecord], bool | None] | None = None,
) -> Outcome:
    """Move the vertices of a problem until all that it requires holds; it is not changed.

    One attempt with the problem's own guides; a net of the table has more ways than one, see
    :func:`solver.optimise`.

    Args:
        problem: from :func:`pose`, with the terms of the net.
        tolerance: largest residual that counts as zero, dimensionless.
        max_steps: largest number of steps.
        backend: ``rslab`` or ``scipy``; by default the fastest installed.
        callback: called after each step; returning True stops.

    Raises:
        InputError: nothing is required, a term whose arrays do not fit, or a setting that cannot be
            used.
    """
    if not problem.constraints:
        raise InputError(
            f"{problem.net} net: nothing is required of it; add a term with problem.require"
        )
    refuse_no_end(tolerance, max_steps)
    for term in problem.terms:
        _refuse_misfit(term, problem.start)
    return Optimisation(problem, None, tolerance, max_steps, backend).run(callback)


def _refuse_misfit(term: Term, x: FloatArray) -> None:
    """Refuse a term whose arrays do not go together, or are no numbers at the start."""
    unknowns = term.unknowns
    if unknowns.ndim != 2 or ((unknowns < 0) | (unknowns >= len(x))).any():
        raise InputError(
            f"term {term.name}: expected unknowns of shape (n, k) between 0 and {len(x) - 1}, got "
            f"shape {unknowns.shape} up to {unknowns.max(initial=0)}; those of vertex v are 3 v, "
            "3 v + 1 and 3 v + 2"
        )
    (count, width), (residual, jacobian) = unknowns.shape, term.linearise(x)
    right = residual.ndim == 2 and jacobian.shape == (*residual.shape, width)
    if not right or len(residual) != count:
        raise InputError(
            f"term {term.name}: expected residuals ({count}, m) and a Jacobian ({count}, m, "
            f"{width}), got {residual.shape} and {jacobian.shape}; one row of them an element"
        )
    if not (np.isfinite(residual).all() and np.isfinite(jacobian).all()):
        raise InputError(
            f"term {term.name}: is not finite at the start; guard against lengths of zero"
        )
