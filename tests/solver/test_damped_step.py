"""One step in a valley that bends: the bend goes along with it, and only where it is trusted."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

from solver.assembly import NormalEquations
from solver.damped_step import Stepper
from solver.linear.backends import symmetric_solver
from solver.point import Point
from solver.terms.base import Linearisation, Size
from solver.tuning import Tuning

DAMPING = 1e-12


@dataclass(frozen=True, eq=False)
class Valley:
    """A parabola y = x^2 to stay on, and a place along it: r = (y - x^2, x - goal, z)."""

    goal: float
    name: str = "valley"
    linear: bool = False

    @property
    def size(self):
        return Size(0, 3)

    @property
    def unknowns(self):
        return np.array([[0, 1, 2]])

    def linearise(self, x):
        residual = np.array([[x[1] - x[0] ** 2, x[0] - self.goal, x[2]]])
        jacobian = np.array([[[-2 * x[0], 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]])
        return Linearisation(residual, jacobian)


def stepped(goal: float, bend: bool):
    terms, x = [Valley(goal)], np.zeros(3)
    system = NormalEquations(terms, np.ones(3, dtype=bool), np.zeros((1, 3)))
    stepper = Stepper(symmetric_solver(system.sparsity, "scipy"), Tuning())
    return stepper.step(Point.at(system, terms, x), DAMPING, bend=bend).point


@pytest.mark.parametrize("goal", [0.3, -0.3])
def test_the_bend_follows_the_valley(goal):
    """The step along the tangent misses by goal^2; its second derivative is exact here."""
    straight, bent = stepped(goal, bend=False), stepped(goal, bend=True)
    assert straight.energy == pytest.approx(goal**4, rel=1e-6)
    assert bent.energy < 1e-16
    assert bent.x == pytest.approx([goal, goal**2, 0.0], abs=1e-9)


def test_a_bend_that_is_long_beside_the_step_is_not_trusted():
    straight, bent = stepped(0.5, bend=False), stepped(0.5, bend=True)
    assert np.array_equal(straight.x, bent.x)
