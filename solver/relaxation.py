"""Steps towards the minimum of an energy whose weights stay as they are.

Where constraints and guides pull against each other, Gauss-Newton neglects how the constraints
curve and comes to rest slowly, or not at all. The gradients of its last steps tell what it
neglects: the quasi-Newton update of Broyden, Fletcher, Goldfarb and Shanno with limited memory,
started from the factored Gauss-Newton matrix of each step.

Source: Nocedal, Wright (2006), Numerical Optimization, algorithm 7.4.
"""

from __future__ import annotations

import time

import numpy as np

from solver.damped_step import Step, Stepper
from solver.errors import SingularSystemError
from solver.linear.backends import SymmetricSolver
from solver.mesh.quadmesh import FloatArray
from solver.point import Point
from solver.tuning import Tuning


class Relaxation:
    """Takes Gauss-Newton steps with memory for one system of terms.

    Args:
        solver: solves the normal equations.
        tuning: memory and line search.
    """

    def __init__(self, solver: SymmetricSolver, tuning: Tuning) -> None:
        self._solver, self._tuning = solver, tuning
        self._damped = Stepper(solver, tuning)
        self._pairs: list[tuple[FloatArray, FloatArray]] = []

    def forget(self) -> None:
        """Drop the memory: the weights are others from now on."""
        self._pairs.clear()

    def step(self, here: Point, damping: float) -> Step:
        """Take one step that lowers the energy; a damped step where memory misleads."""
        begin = time.perf_counter()
        move = self._direction(here)
        solve_seconds = time.perf_counter() - begin
        slope, part = float(move @ here.gradient), 1.0
        while slope < 0 and part >= self._tuning.shortest:
            there = here.moved(part * move)
            least = self._tuning.decrease * part * slope
            if there.energy <= here.energy * (1 + self._tuning.relaxation_rounding) + least:
                self._remember(part * move, there.gradient - here.gradient)
                length = part * float(np.abs(move).max(initial=0.0))
                return Step(there, length, damping, solve_seconds)
            part *= 0.5
        self.forget()
        return self._damped.step(here, damping)

    def _direction(self, here: Point) -> FloatArray:
        """Minus the gradient through the inverse of the matrix as memory corrects it."""
        matrix, gradient = here.matrix, here.gradient
        matrix[here.system.sparsity.indptr[:-1]] += self._tuning.relaxation_damping
        try:
            solve = self._solver.factor(matrix)
        except SingularSystemError:
            return np.zeros_like(gradient)
        left, parts = gradient.copy(), []
        for move, change in reversed(self._pairs):
            parts.append(move @ left / (move @ change))
            left -= parts[-1] * change
        direction = solve(left)
        for (move, change), part in zip(self._pairs, reversed(parts), strict=True):
            direction += move * (part - change @ direction / (move @ change))
        return -direction if np.isfinite(direction).all() else np.zeros_like(gradient)

    def _remember(self, move: FloatArray, change: FloatArray) -> None:
        least = self._tuning.memorable * np.linalg.norm(move) * np.linalg.norm(change)
        if move @ change > least:
            self._pairs = [*self._pairs[1 - self._tuning.memory :], (move, change)]
