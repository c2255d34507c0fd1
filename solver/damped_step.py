"""One damped Gauss-Newton step: solve, bend where the valley bends, accept only what helps.

Levenberg-Marquardt damping; where progress is slow, the step is bent by the second derivative of
the residuals along it (geodesic acceleration), which costs one more evaluation and one more solve
with the same factors.

Source: Transtrum, Sethna (2012), Improvements to the Levenberg-Marquardt algorithm for nonlinear
least-squares minimization.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple, TypeVar

import numpy as np

from solver.errors import SingularSystemError
from solver.linear.backends import SymmetricSolver
from solver.mesh.quadmesh import FloatArray
from solver.point import Point
from solver.terms.base import Linearisation
from solver.tuning import Tuning

_Result = TypeVar("_Result")


class Step(NamedTuple):
    """Result of a step.

    Attributes:
        point: where it led, or where it began where no step helps any more.
        length: largest move of an unknown.
        damping: for the next step.
        solve_seconds: time spent in factorisations and solves.
        stuck: no step helps any more.
    """

    point: Point
    length: float
    damping: float
    solve_seconds: float
    stuck: bool = False


class Stepper:
    """Takes damped steps for one system of terms.

    Args:
        solver: solves the normal equations.
        tuning: damping, bends, and how long factors serve.
    """

    def __init__(self, solver: SymmetricSolver, tuning: Tuning) -> None:
        self._solver, self._tuning = solver, tuning
        self._solving = 0.0
        self._last: Callable[[FloatArray], FloatArray] | None = None
        self._last_weights, self._reused = np.zeros(0), 0

    def step(self, here: Point, damping: float, bend: bool = False) -> Step:
        """Take one accepted step; ``bend`` asks for geodesic acceleration."""
        tuning, matrix, gradient = self._tuning, here.matrix, here.gradient
        # Changes of the energy that are no larger say nothing.
        rounding = tuning.rounding_zero * max(1, len(gradient))
        diagonal = here.system.sparsity.indptr[:-1]
        values = matrix[diagonal]
        self._solving, rejected = 0.0, False
        self._last_weights, self._reused = here.weights.copy(), 0
        while True:
            matrix[diagonal] = values + damping
            solve, move = self._solve(matrix, gradient)
            if np.isfinite(move).all():
                if bend and solve is not None:
                    move = move + self._bend(here, move, solve)
                there = here.moved(move)
                if there.energy <= here.energy * (1 + tuning.rounding) + rounding:
                    calmer = (
                        damping if rejected else max(tuning.calmer * damping, tuning.damping_min)
                    )
                    length = float(np.abs(move).max(initial=0.0))
                    return Step(there, length, calmer, self._solving)
            if damping > tuning.damping_max:
                return Step(here, 0.0, damping, self._solving, stuck=True)
            damping = max(tuning.harder * damping, tuning.damping_refused)
            rejected = True

    def follow(self, here: Point, damping: float) -> Step | None:
        """Take a step with the factors of the last one, at a fraction of its cost.

        For a problem that has changed a little since, as while a vertex is dragged. None where the
        factors are no help any more, or there are none; then :meth:`step` makes new ones.
        """
        worn = self._reused >= self._tuning.reuses or not np.array_equal(
            here.weights, self._last_weights
        )
        if self._last is None or worn:
            return None
        self._solving = 0.0
        move = self._timed(self._last, -here.gradient)
        there = here.moved(move)
        if not there.energy < here.energy:
            self._last = None
            return None
        self._reused += 1
        return Step(there, float(np.abs(move).max(initial=0.0)), damping, self._solving)

    def _solve(
        self, matrix: FloatArray, gradient: FloatArray
    ) -> tuple[Callable[[FloatArray], FloatArray] | None, FloatArray]:
        self._last = None
        try:
            solve = self._timed(self._solver.factor, matrix)
        except SingularSystemError:
            return None, np.full(len(gradient), np.nan)
        self._last = solve
        return solve, self._timed(solve, -gradient)

    def _bend(
        self, here: Point, move: FloatArray, solve: Callable[[FloatArray], FloatArray]
    ) -> FloatArray:
        """Half the acceleration along the move; zero where it is too long to be trusted."""
        full, part = here.full(move), self._tuning.probe
        # Linear terms do not curve.
        weights = np.where([term.linear for term in here.terms], 0.0, here.weights)
        probe = here.linearised(here.x + part * full, weights)
        curved = list(here.linearisations)
        for k in np.flatnonzero(weights).tolist():
            near, there = here.linearisations[k], probe[k]
            slope = np.einsum("nmk,nk->nm", near.jacobian, full[here.terms[k].unknowns])
            second = 2 / part * ((there.residual - near.residual) / part - slope)
            curved[k] = Linearisation(second, near.jacobian)
        second_gradient = replace(here, linearisations=curved, weights=weights).gradient
        bend = self._timed(solve, -0.5 * second_gradient)
        trusted = np.linalg.norm(bend) <= self._tuning.longest_bend * np.linalg.norm(move)
        return bend if trusted else np.zeros_like(move)

    def _timed(self, function: Callable[[FloatArray], _Result], argument: FloatArray) -> _Result:
        begin = time.perf_counter()
        try:
            return function(argument)
        finally:
            self._solving += time.perf_counter() - begin
