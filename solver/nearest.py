"""The exact net nearest to what was drawn: steps along the nets, not away from them.

What guides the way to a net fades to nothing and leaves the result wherever it lets go. From there
this module goes on: it lowers the weighted squares of wishes (distance from the design surface,
evenness of the motion, edges that stay long) while every constraint of the net stays met. A step

1. takes that part of the wishes' gradient that no constraint resists: what is left of it after the
   constraints have pushed back, with multipliers of least squares;
2. divides it by the curvature of the wishes along the net (Gauss-Newton: their residuals are small,
   so that the multipliers are, and how the constraints curve counts little);
3. returns onto the net by corrections of least length with the factors at hand, and
4. is accepted if the wishes fall. Else it is damped more, as is the next one where they fell by
   little of what step 2 promised.

So each shape on the way is a net, and where the wishes fall no more is a stationary point.

Source: Nocedal, Wright (2006), Numerical Optimization, sections 4.1 (damping by gain over promise),
18.1 and 18.3 (sequential quadratic programming, multipliers of least squares, second-order
corrections).
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from solver.assembly import NormalEquations
from solver.errors import SingularSystemError
from solver.linear.backends import default_backend, symmetric_solver
from solver.linear.threads import one_thread
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.point import Point
from solver.problem import Problem
from solver.terms.base import Linearisation, Term
from solver.terms.near_surface import NearSurface
from solver.wishes import Wish

# Moves of so many mean edges are rounding.
_ROUNDING = 1e-15


class NearestNet:
    """Moves along the nets of a problem, one step at a time, until the wishes fall no more.

    Args:
        problem: the net; its guides are not looked at.
        x: flat vector that meets the constraints to 1e-4 at least.
        wishes: what to be near to.
        backend: name of the sparse solver, by default the fastest installed.

    Attributes:
        point: where it stands; its first terms are the constraints.
        damping: added to the matrix in the next step.
        finished: true where no further step helps.
        worth: a step that lowers the wishes by a smaller part of them is the last.
    """

    def __init__(
        self,
        problem: Problem,
        x: FloatArray,
        wishes: Sequence[Wish],
        backend: str | None = None,
    ) -> None:
        wishes = [wish for wish in wishes if wish.weight > 0 and len(wish.term.unknowns)]
        terms: list[Term] = [*problem.constraints, *(wish.term for wish in wishes)]
        name = backend or default_backend(int(problem.free.sum()))
        system = NormalEquations(
            terms, problem.free, problem.mesh.vertices, reorder=name == "scipy"
        )
        self._along, self._across = (symmetric_solver(system.sparsity, name) for _ in range(2))
        self._count = len(problem.constraints)
        self._net = np.array([1.0] * self._count + [0.0] * len(wishes))
        self._wished = np.array([0.0] * self._count + [wish.weight for wish in wishes])
        self.problem, self._tuning = problem, problem.tuning
        self.point = Point.at(system, terms, x.copy()).followed()
        self.damping = self._tuning.along_damping_start
        self.worth = self._tuning.along_worth
        self.finished = not wishes or not len(system.sparsity.unknowns)

    @property
    def mesh(self) -> QuadMesh:
        """Current shape, in the units of the problem's mesh."""
        return self.problem.mesh_at(self.point.x)

    @property
    def wishes(self) -> float:
        """Weighted sum of squares of the wishes where it stands."""
        return self.point.weighed(self._wished).energy

    def sharpen(self, worth: float) -> None:
        """From now on what is farthest from a surface counts most: the largest distance falls.

        Args:
            worth: a step that lowers the wishes by a smaller part of them is the last.
        """
        for number, term in enumerate(self.point.terms):
            if isinstance(term, NearSurface):
                sharper = term.peaked(self.point.x, self._tuning.peak)
                self.point = self.point.with_term(number, sharper)
        self.worth, self.finished = worth, False

    def run(self, most: int = 50) -> FloatArray:
        """Take steps until none helps, or so many; return the exact flat vector."""
        for _ in range(most):
            if self.finished:
                break
            self.step()
        return self.exact()

    def step(self) -> tuple[float, float]:
        """Take one step; ``finished`` turns true where it brought little, or none was found.

        Returns:
            The largest move of an unknown, and the seconds spent in factorisations and solves.
        """
        with one_thread():
            return self._step()

    def exact(self) -> FloatArray:
        """The flat vector reached, on the net to rounding error."""
        point, tuning = self.point.weighed(self._net), self._tuning
        first, length = tuning.last_corrections, 0.0
        back: Callable[[FloatArray], FloatArray] | None = None
        with one_thread():
            for number in range(tuning.most_corrections):
                if number >= first and self._worst(point) <= tuning.exact:
                    break
                # Where constraints all but touch, such as those of a sheet that is nearly flat,
                # what is added would stand in the way.
                tangent = tuning.last_tangents[0 if number < first else 1]
                try:
                    # Factors of a shape nearby serve as long as moves with them shrink.
                    back = back or self._back(point, tangent * tuning.tangent)
                    move = back(-point.gradient)
                except SingularSystemError:
                    # Rounding is larger than what is added: nothing nearer is to be found.
                    break
                # Loads and closest points are those of the shape that is kept.
                point = point.moved(move).followed(weighty=True)
                before, length = length, float(np.abs(move).max(initial=0.0))
                if length <= _ROUNDING:
                    break
                if length > tuning.shrinking * before and self._worst(point) > tuning.exact:
                    back = None
        return point.x

    def _step(self) -> tuple[float, float]:
        begin = time.perf_counter()
        here, before = self.point, self.wishes
        net, tuning = here.weighed(self._net), self._tuning
        back = self._back(net, tuning.tangent)
        # Multipliers of least squares take away all of the gradient but a motion along the net.
        free = tuning.tangent * back(here.weighed(self._wished).gradient)
        gradient = net.gradient + tuning.share * free
        both = here.weighed(self._net + tuning.share * self._wished)
        matrix, diagonal = both.matrix, here.system.sparsity.indptr[:-1]
        values = matrix[diagonal]
        solving, limit = time.perf_counter() - begin, max(tuning.near_net, self._worst(here))
        refused = False
        while self.damping <= tuning.along_damping_max:
            used = self.damping
            matrix[diagonal] = values + used
            begin = time.perf_counter()
            move = -self._across.factor(matrix)(gradient)
            solving += time.perf_counter() - begin
            length = float(np.abs(move).max(initial=0.0))
            if np.isfinite(length) and length <= tuning.along_longest:
                there = self._returned(net, net.moved(move), back)
                gain = before - there.weighed(self._wished).energy
                if gain > 0 and limit < self._worst(there) <= tuning.off_net:
                    # A step that is worth it is worth new factors, with which it comes back.
                    there = self._brought_back(there)
                    gain = before - there.weighed(self._wished).energy
                if gain > 0 and self._worst(there) <= limit:
                    # Of what it promised, were wishes quadratic along the net, damping took a part.
                    taken = used / tuning.share * float(move @ move)
                    promised = taken - float(free @ move)
                    self.point = there
                    self.damping = self._damping_after(used, gain / promised, refused)
                    done = taken < tuning.undamped * promised
                    done = done and promised < tuning.along_enough * before
                    # One that had to be shortened does not say what the next will bring.
                    little = gain < self.worth * before and not refused
                    self.finished = done or little
                    return length, solving
            self.damping = max(tuning.along_harder * used, tuning.along_refused)
            refused = True
        self.finished = True
        return 0.0, solving

    def _damping_after(self, used: float, kept: float, refused: bool) -> float:
        """Damping of the next step, after one that kept so much of what it promised.

        Args:
            used: in the step.
            kept: part of the promise by which the wishes fell.
            refused: it was tried with less damping before.
        """
        tuning = self._tuning
        if kept < tuning.kept_little:
            return max(tuning.along_harder * used, tuning.along_refused)
        calmer = max(tuning.along_calmer * used, tuning.along_damping_min)
        return used if refused or kept < tuning.kept_much else calmer

    def _returned(
        self, net: Point, there: Point, back: Callable[[FloatArray], FloatArray]
    ) -> Point:
        """Where corrections lead back onto the net, all terms linearised there.

        Args:
            net: the point whose derivatives the factors are made of.
            there: from where they set out.
            back: the factors.
        """
        there = there.followed(weighty=True)
        for _ in range(self._tuning.corrections):
            if not self._tuning.on_net < self._worst(there) < np.inf:
                break
            # New residuals with the derivatives of the step: the factors at hand are for those.
            mixed = [
                Linearisation(new.residual, old.jacobian)
                for new, old in zip(there.linearisations, net.linearisations, strict=True)
            ]
            there = there.moved(back(-replace(there, linearisations=mixed).gradient))
            there = there.followed(weighty=True)
        return there.standing_at(there.x).followed()

    def _brought_back(self, there: Point) -> Point:
        """The same with factors made where it stands; as it is where there are none."""
        net = there.weighed(self._net)
        try:
            return self._returned(net, net, self._back(net, self._tuning.tangent))
        except SingularSystemError:
            return there

    def _back(self, net: Point, tangent: float) -> Callable[[FloatArray], FloatArray]:
        """Factors of the constraints' own matrix: they answer with moves of least length."""
        matrix = net.matrix
        matrix[net.system.sparsity.indptr[:-1]] += tangent
        return self._along.factor(matrix)

    def _worst(self, point: Point) -> float:
        parts = point.linearisations[: self._count]
        return max((float(np.abs(part.residual).max(initial=0.0)) for part in parts), default=0.0)
