"""One damped Gauss-Newton step: solve, bend where the valley bends, accept only what helps.

Levenberg-Marquardt damping; where progress is slow, the step is bent by the second derivative of
the residuals along it (geodesic acceleration), which costs one more evaluation and one more solve
with the same factors.

Source: Transtrum, Sethna (2012), Improvements to the Levenberg-Marquardt algorithm for nonlinear
least-squares minimization.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeVar

import numpy as np

from solver.assembly import NormalEquations
from solver.errors import SingularSystemError
from solver.linear.backends import SymmetricSolver
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Term

DAMPING_START = 1e-3
_DAMPING_MIN, _DAMPING_MAX = 1e-12, 1e8
# Part of the step at which the second derivative is probed, and the longest bend that is trusted.
_PROBE, _LONGEST_BEND = 0.1, 0.375
# Steps that follow with the same factors; more of them lag visibly behind a dragged vertex.
_REUSES = 3

_Result = TypeVar("_Result")


class Step(NamedTuple):
    """Result of a step.

    Attributes:
        x: the new flat vector, or the old one where no step helps any more.
        linearisations: those at ``x``.
        energy: weighted sum of squares at ``x``.
        length: largest move of an unknown.
        damping: for the next step.
        solve_seconds: time spent in factorisations and solves.
        stuck: no step helps any more.
    """

    x: FloatArray
    linearisations: list[Linearisation]
    energy: float
    length: float
    damping: float
    solve_seconds: float
    stuck: bool


class Stepper:
    """Takes damped steps for one system of terms.

    Args:
        system: assembles the normal equations.
        solver: solves them.
    """

    def __init__(self, system: NormalEquations, solver: SymmetricSolver) -> None:
        self._system = system
        self._solver = solver
        self._solving = 0.0
        self._last: Callable[[FloatArray], FloatArray] | None = None
        self._last_weights, self._reused = np.zeros(0), 0

    def step(
        self,
        terms: Sequence[Term],
        x: FloatArray,
        linearisations: list[Linearisation],
        weights: FloatArray,
        damping: float,
        bend: bool,
    ) -> Step:
        """Move ``x`` by one accepted step; ``bend`` asks for geodesic acceleration."""
        pattern = self._system.pattern
        matrix = self._system.matrix(linearisations, weights)
        gradient = self._system.gradient(linearisations, weights)
        before = energy_of(linearisations, weights)
        # Below this, changes of the energy are rounding and say nothing.
        rounding = 1e-26 * max(1, len(gradient))
        diagonal = pattern.indptr[:-1]
        values = matrix[diagonal]
        self._solving, rejected = 0.0, False
        self._last_weights, self._reused = weights.copy(), 0
        while True:
            matrix[diagonal] = values + damping
            solve, move = self._solve(matrix, gradient)
            if np.isfinite(move).all():
                if bend and solve is not None:
                    move = move + self._bend(terms, x, linearisations, weights, move, solve)
                there = x.copy()
                there[pattern.unknowns] += move
                ahead = linearise(terms, there, linearisations, weights)
                after = energy_of(ahead, weights)
                if after <= before * (1 + 1e-9) + rounding:
                    calmer = damping if rejected else max(damping / 4, _DAMPING_MIN)
                    length = float(np.abs(move).max(initial=0.0))
                    return Step(there, ahead, after, length, calmer, self._solving, False)
            if damping > _DAMPING_MAX:
                return Step(x, linearisations, before, 0.0, damping, self._solving, True)
            damping = max(8 * damping, 1e-9)
            rejected = True

    def follow(
        self,
        terms: Sequence[Term],
        x: FloatArray,
        linearisations: list[Linearisation],
        weights: FloatArray,
        damping: float,
    ) -> Step | None:
        """Move ``x`` with the factors of the last step, at a fraction of its cost.

        For a problem that has changed a little since, as while a vertex is dragged. None where the
        factors are no help any more, or there are none; then :meth:`step` makes new ones.
        """
        worn = self._reused >= _REUSES or not np.array_equal(weights, self._last_weights)
        if self._last is None or worn:
            return None
        before = energy_of(linearisations, weights)
        self._solving = 0.0
        move = self._timed(self._last, -self._system.gradient(linearisations, weights))
        there = x.copy()
        there[self._system.pattern.unknowns] += move
        ahead = linearise(terms, there, linearisations, weights)
        after = energy_of(ahead, weights)
        if not after < before:
            self._last = None
            return None
        self._reused += 1
        length = float(np.abs(move).max(initial=0.0))
        return Step(there, ahead, after, length, damping, self._solving, False)

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
        self,
        terms: Sequence[Term],
        x: FloatArray,
        linearisations: list[Linearisation],
        weights: FloatArray,
        move: FloatArray,
        solve: Callable[[FloatArray], FloatArray],
    ) -> FloatArray:
        """Half the acceleration along the move; zero where it is too long to be trusted."""
        full = np.zeros(len(x))
        full[self._system.pattern.unknowns] = move
        # Linear terms do not curve.
        weights = np.where([term.linear for term in terms], 0.0, weights)
        probe = linearise(terms, x + _PROBE * full, linearisations, weights)
        curved = list(linearisations)
        for k in np.flatnonzero(weights).tolist():
            here, there = linearisations[k], probe[k]
            slope = np.einsum("nmk,nk->nm", here.jacobian, full[terms[k].unknowns])
            second = 2 / _PROBE * ((there.residual - here.residual) / _PROBE - slope)
            curved[k] = Linearisation(second, here.jacobian)
        bend = self._timed(solve, -0.5 * self._system.gradient(curved, weights))
        trusted = np.linalg.norm(bend) <= _LONGEST_BEND * np.linalg.norm(move)
        return bend if trusted else np.zeros_like(move)

    def _timed(self, function: Callable[[FloatArray], _Result], argument: FloatArray) -> _Result:
        begin = time.perf_counter()
        try:
            return function(argument)
        finally:
            self._solving += time.perf_counter() - begin


def linearise(
    terms: Sequence[Term], x: FloatArray, last: list[Linearisation], weights: FloatArray
) -> list[Linearisation]:
    """Linearise the terms that count; those that have faded away keep their last values."""
    return [
        term.linearise(x) if weight > 0 else old
        for term, weight, old in zip(terms, weights, last, strict=True)
    ]


def energy_of(linearisations: list[Linearisation], weights: FloatArray) -> float:
    """Weighted sum of squares."""
    # Not a dot product: its threads cost more than these sums where the machine is busy.
    return float(
        sum(
            weight * np.einsum("nm,nm->", part.residual, part.residual)
            for weight, part in zip(weights, linearisations, strict=True)
            if weight > 0
        )
    )
