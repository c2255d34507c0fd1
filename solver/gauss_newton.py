"""Regularised Gauss-Newton with guides that fade to zero: one attempt, from start to end.

Each step linearises all terms, solves one damped sparse system and accepts it if the energy falls.
Guides (fairness and its kin) are multiplied by a factor that shrinks every step and ends at zero,
so the constraints are met to rounding error.

Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4; Tang et al. (2014),
Form-finding with polyhedral meshes made simple.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Sequence

import numpy as np

from solver.assembly import NormalEquations
from solver.damped_step import Step, Stepper
from solver.linear.backends import symmetric_solver
from solver.linear.threads import one_thread
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.plan import Attempt
from solver.point import Point
from solver.problem import Problem
from solver.relaxation import Relaxation
from solver.report import StepRecord
from solver.terms.base import Linearisation, Term
from solver.terms.pull import Pull


class Layout:
    """The equations of a problem, laid out once for attempts that use the same terms.

    Args:
        attempt: what is tried, at which problem.
        backend: name of the sparse solver.
    """

    def __init__(self, attempt: Attempt, backend: str) -> None:
        self.problem, self._used = attempt.problem, attempt.used
        problem = self.problem
        self.system = NormalEquations(
            problem.terms,
            problem.free,
            problem.mesh.vertices,
            # rslab orders the unknowns itself.
            reorder=backend == "scipy",
            used=self._used,
        )
        self.solver = symmetric_solver(self.system.sparsity, backend)
        self.stepper = Stepper(self.solver, problem.tuning)
        self.relaxation = Relaxation(self.solver, problem.tuning)

    def serves(self, attempt: Attempt) -> bool:
        """Whether all that weighs anything in an attempt has a place."""
        return attempt.problem is self.problem and all(
            here or not there for here, there in zip(self._used, attempt.used, strict=True)
        )


class Descent:
    """An attempt that is advanced one step at a time, down to the net or to where it is stuck.

    Attributes:
        attempt: what is tried.
        point: where it stands.
        fade: factor on the guides in the next step, 1 at the start, 0 at the end.
        restless: handles were let go before the mesh had come to rest: what follows depends on the
            way here.
        given_up: it is over as it came nearer to the net too slowly.

    Args:
        layout: of the attempt's problem.
        attempt: what is tried.
        restless: whether an attempt before this one was.
    """

    def __init__(self, layout: Layout, attempt: Attempt, restless: bool = False) -> None:
        self.layout, self.attempt, self.restless = layout, attempt, restless
        self._tuning = self.problem.tuning
        self.point = Point.at(layout.system, self.problem.terms, self.problem.start.copy())
        self.fade = 1.0
        self._damping = self._tuning.damping_start
        self._best_worst = self._worst_before = np.inf
        self._last_worst = 0.0
        self._idle = self._held = self._calm = 0
        self._paces: deque[float] = deque(maxlen=self._tuning.pace + 1)
        self._rested = self.given_up = False
        layout.relaxation.forget()

    @property
    def problem(self) -> Problem:
        """What is asked."""
        return self.attempt.problem

    @property
    def mesh(self) -> QuadMesh:
        """Current shape, about the problem's origin."""
        return self.problem.mesh_at(self.point.x)

    def holds(self, steps_left: int) -> bool:
        """Whether the guides stay until handles have arrived and the mesh has come to rest."""
        waiting = self._pull is not None and self.attempt.patient and not self._rested
        return waiting and self._held < self._tuning.hold_steps and steps_left > 0

    def step(
        self, number: int, steps_left: int, attempt: int = 1, follow: bool = False
    ) -> StepRecord:
        """Take one step and return its record.

        Args:
            number: of the step, for the record.
            steps_left: how many may be taken, this one included.
            attempt: number of the attempt, for the record.
            follow: take the factors of the last step again as long as they help.
        """
        begin = time.perf_counter()
        used = self.fade
        damping = max(self._damping, self._tuning.live_damping) if follow else self._damping
        here = self.point.weighed(self._weights(used))
        with one_thread():
            taken = self._taken(here, damping, steps_left, follow)
        self.point, self._damping = taken.point.followed(), taken.damping
        if taken.stuck:
            self._idle = self._tuning.patience
        record = StepRecord(
            step=number,
            attempt=attempt,
            energy=taken.point.energy,
            residuals=largest_residuals(self.problem.constraints, self.point.linearisations),
            step_length=taken.length,
            damping=damping,
            fade=used,
            seconds=time.perf_counter() - begin,
            solve_seconds=taken.solve_seconds,
        )
        self._worst_before, self._last_worst = self._last_worst, record.worst
        if used == 0.0:
            self._paces.append(record.worst)
        self._move_on(record, steps_left - 1)
        return record

    def is_over(self, record: StepRecord, tolerance: float, steps_left: int) -> bool:
        """Whether the last step reached the net, or many have led nowhere or would have to follow.

        Args:
            record: of the last step.
            tolerance: largest residual that counts as zero.
            steps_left: how many may be taken.
        """
        if self.holds(steps_left):
            return False
        if record.worst < self._tuning.progress * self._best_worst:
            self._best_worst, self._idle = record.worst, 0
        elif self.fade == 0.0:
            self._idle += 1
        tuning = self._tuning
        near = (tuning.slow_margin if self._slow else tuning.margin) * tolerance
        over = record.worst <= near or self._idle >= tuning.patience
        self.given_up = not over and self.attempt.hasty and self._hopeless(tolerance)
        return over or self.given_up

    def _hopeless(self, tolerance: float) -> bool:
        """Whether the net is many steps away at the pace of the last ones."""
        tuning, paces = self._tuning, self._paces
        if len(paces) <= tuning.pace or not 0 < paces[-1] < paces[0]:
            return False
        a_step = np.log(paces[0] / paces[-1]) / tuning.pace
        return bool(np.log(paces[-1] / tolerance) > tuning.hopeless * a_step)

    def stand_at(self, mesh: QuadMesh) -> None:
        """Go on from another shape, with the guides where handles are followed."""
        problem = self.problem
        points = (mesh.vertices - problem.centre) / problem.scale
        x = self.point.x.copy()
        x[: points.size] = points.ravel()
        self.point, self.fade = self.point.standing_at(x).followed(), self._tuning.hold

    def hold(self) -> None:
        """Follow the handles again, which have moved."""
        self.fade = max(self.fade, self._tuning.hold)
        self._held = self._calm = 0
        self._rested = False
        self.point = self.point.standing_at(self.point.x)
        self.layout.relaxation.forget()

    def count_afresh(self) -> None:
        """Count steps without progress from here on."""
        self._idle, self._best_worst, self.restless = 0, np.inf, False

    def retarget(self, term: Term) -> None:
        """Put a term in the place of the guide of that name; its stencil must be the same.

        Raises:
            KeyError: there is no such guide.
        """
        k = self.problem.retarget(term)
        self.point = self.point.with_term(len(self.problem.constraints) + k, term)

    @property
    def _slow(self) -> bool:
        """Whether the last step left much of the largest residual."""
        return self._last_worst > self._tuning.slow * self._worst_before

    @property
    def pulled(self) -> bool:
        """Whether there are handles."""
        return self._pull is not None

    @property
    def _pull(self) -> Pull | None:
        """The handles, where there are any."""
        return next((term for term in self.point.terms if isinstance(term, Pull)), None)

    def _taken(self, here: Point, damping: float, steps_left: int, follow: bool) -> Step:
        if self.holds(steps_left) and self._held:
            return self.layout.relaxation.step(here, damping)
        followed = self.layout.stepper.follow(here, damping) if follow else None
        bend = self._slow and not follow
        return followed or self.layout.stepper.step(here, damping, bend=bend)

    def _weights(self, fade: float) -> FloatArray:
        ones = [1.0] * len(self.problem.constraints)
        return np.array(ones + self.attempt.weights_of_guides(fade))

    def _move_on(self, record: StepRecord, steps_left: int) -> None:
        """Move the schedule on: guides fade, but wait for handles and the mesh to come to rest."""
        tuning, pull = self._tuning, self._pull
        if pull is not None and self.holds(steps_left) and self.fade * tuning.fade <= tuning.hold:
            if self.fade == tuning.hold and pull.arrived:
                self._held += 1
                self._calm = self._calm + 1 if record.step_length < tuning.rest else 0
                self._rested = self._calm >= tuning.calm
                if self._rested:
                    # Nothing but the shape is taken along from the way here.
                    self._damping, self._worst_before = tuning.hold_damping, np.inf
                self.restless = self._held >= tuning.hold_steps
            self.fade = tuning.hold
        holding = self.holds(steps_left)
        if not holding or self.fade > tuning.hold:
            self.fade *= tuning.fade
            if self.fade < tuning.fade_end or (record.worst < tuning.near and not holding):
                self.fade = 0.0


def largest_residuals(terms: Sequence[Term], parts: Sequence[Linearisation]) -> dict[str, float]:
    """Largest residual of the constraints of each name."""
    worst: dict[str, float] = {}
    for term, part in zip(terms, parts, strict=False):
        largest = float(np.abs(part.residual).max(initial=0.0))
        worst[term.name] = max(worst.get(term.name, 0.0), largest)
    return worst
