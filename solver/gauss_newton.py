"""Regularised Gauss-Newton with guides that fade to zero.

Each step linearises all terms, solves one damped sparse system and accepts it if the energy falls.
Guides (fairness and its kin) are multiplied by a factor that shrinks every step and ends at zero,
so the constraints are met to rounding error. An attempt that ends folded, collapsed, creased or
stuck is repeated from the start with other guides; the best result of all attempts is kept.

Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 4; Tang et al. (2014),
Form-finding with polyhedral meshes made simple.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import cast

import numpy as np

from solver.analysis.start import Remark
from solver.assembly import NormalEquations
from solver.best import Best
from solver.candidate import Candidate, judge
from solver.damped_step import DAMPING_START, Stepper
from solver.linear.backends import default_backend, symmetric_solver
from solver.linear.threads import one_thread
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.problem import Problem
from solver.relaxation import Relaxation
from solver.report import COLLAPSED, CONVERGED, STALLED, STOPPED, Outcome, StepRecord
from solver.summary import summarise
from solver.terms.base import FollowingTerm, Linearisation, Term, follows
from solver.terms.pull import Pull

_FADE = 0.3
_FADE_END = 1e-12
# With every residual below this, the net is near enough to be reached without guides.
_NEAR = 1e-6
# Steps without halving the worst residual, with the guides gone, after which it counts as stuck.
_PATIENCE = 25
# Of so many attempts that reached the net, though with short edges or creases, the best is taken.
_ENOUGH = 3
# Handles are followed with the guides at this factor, where the mesh is nearly a net, until so many
# steps in turn are this small: what follows depends on where the handles are, not on the way there.
_HOLD, _CALM, _REST, _HOLD_STEPS, _HOLD_DAMPING = 3e-3, 2, 1e-10, 250, 1e-9
# While a vertex is dragged no step is damped less: each refused one is a frame that comes late.
_LIVE_DAMPING = 1e-5
# Stop this far below the tolerance: the last Gauss-Newton step costs little and squares the error.
_MARGIN = 1e-2


@dataclass
class _State:
    """Where an attempt stands."""

    x: FloatArray
    linearisations: list[Linearisation]
    damping: float = DAMPING_START
    fade: float = 1.0
    best_worst: float = np.inf
    worst_before: float = np.inf
    last_worst: float = 0.0
    idle: int = 0
    held: int = 0
    calm: int = 0
    rested: bool = False

    @property
    def slow(self) -> bool:
        """Whether the last step left more than half of the largest residual."""
        return self.last_worst > 0.5 * self.worst_before


class Optimisation:
    """An optimisation that is advanced one step at a time.

    The problem is not changed. Between steps the current shape can be read from ``mesh``; after
    any number of steps ``outcome`` gives the best mesh so far and its report.

    Args:
        problems: what is asked; further problems are the same net from other starts, and are tried
            one after the other where a result is not good.
        tolerance: largest measure of the net, over all faces or stars, that counts as zero.
        max_steps: steps of all attempts together.
        backend: name of the sparse solver, by default the fastest installed.
        accept_start: a start that already is the net is returned untouched.
        original: the problem against whose start results are judged, by default the first.
        remarks: what stands in the way of the net, for the report and its advice.
        held: what keeps vertices from moving freely, such as "fixed vertices", for the advice.
        origin: what the problems' coordinates are measured from; what comes out is in the model's.
    """

    def __init__(
        self,
        problems: Problem | Sequence[Problem],
        tolerance: float = 1e-10,
        max_steps: int = 1000,
        backend: str | None = None,
        accept_start: bool = True,
        original: Problem | None = None,
        remarks: Sequence[Remark] = (),
        held: Sequence[str] = (),
        origin: LocalOrigin | None = None,
    ) -> None:
        begin = time.perf_counter()
        self._problems = [problems] if isinstance(problems, Problem) else list(problems)
        self.original = original or self._problems[0]
        self.remarks, self.held = tuple(remarks), tuple(held)
        self.origin = origin or LocalOrigin(np.zeros(3))
        self.tolerance = tolerance
        self.max_steps = max_steps
        self.backend = backend or default_backend(int(self._problems[0].free.sum()))
        self.history: list[StepRecord] = []
        self.status: str | None = None
        self._turn, self._attempt, self.attempts = 0, 1, 1
        self._best = Best()
        self._solved = 0
        self.restless = False
        self._prepare()
        self.seconds_setup = time.perf_counter() - begin
        if not self.problem.free.any():
            self._conclude(STALLED)
        elif accept_start:
            start = judge(self.original, self.original.start, tolerance)
            if start.valid:
                self._best.consider(start)
                self.status = CONVERGED

    @property
    def problem(self) -> Problem:
        """The problem that is being tried."""
        return self._problems[self._turn]

    @property
    def finished(self) -> bool:
        """True when no further step will be taken."""
        return self.status is not None

    @property
    def mesh(self) -> QuadMesh:
        """Current shape in model units."""
        return self.origin.back_mesh(self.problem.mesh_at(self._state.x))

    @property
    def vertices(self) -> FloatArray:
        """(V, 3) current positions in model units."""
        return self.mesh.vertices

    def step(self) -> StepRecord:
        """Take one step and return its record; ``finished`` may turn true.

        Raises:
            RuntimeError: the optimisation has finished.
        """
        if self.finished:
            raise RuntimeError("the optimisation has finished; start a new one")
        record = self.advance()
        if not self.holding:
            self._decide(record)
        return record

    def advance(self, reuse: bool = False) -> StepRecord:
        """Take one step without asking whether it was the last: for live editing.

        With ``reuse`` the factors of the last step serve again as long as they help.
        """
        begin = time.perf_counter()
        state = self._state
        used = state.fade
        damping = max(state.damping, _LIVE_DAMPING) if reuse else state.damping
        system = (self._terms, state.x, state.linearisations, self._weights(used), damping)
        with one_thread():
            if self.holding and state.held:
                step = self._relaxation.step(*system)
            else:
                followed = self._stepper.follow(*system) if reuse else None
                step = followed or self._stepper.step(*system, bend=state.slow and not reuse)
        state.x, state.linearisations, state.damping = step.x, step.linearisations, step.damping
        if step.stuck:
            state.idle = _PATIENCE
        self._follow(state)
        record = StepRecord(
            step=len(self.history) + 1,
            attempt=self.attempts,
            energy=step.energy,
            residuals=self._residuals(state.linearisations),
            step_length=step.length,
            damping=damping,
            fade=used,
            seconds=time.perf_counter() - begin,
            solve_seconds=step.solve_seconds,
        )
        self.history.append(record)
        state.worst_before, state.last_worst = state.last_worst, record.worst
        self._fade(record)
        return record

    @property
    def holding(self) -> bool:
        """Whether the guides stay until handles have arrived and the mesh has come to rest."""
        waiting = self._pull is not None and self._attempt == 1 and not self._state.rested
        return waiting and self._state.held < _HOLD_STEPS and len(self.history) < self.max_steps

    def hold(self) -> None:
        """Go on from the shape reached, with handles that have moved: for live editing."""
        if self.finished or self._turn or self._attempt > 1:
            mesh = self._found().mesh if self.finished else self.problem.mesh_at(self._state.x)
            self.restart()
            problem, state = self.problem, self._state
            points = (mesh.vertices - problem.centre) / problem.scale
            state.x[: points.size] = points.ravel()
            self._follow(state)
            state.fade = _HOLD
        state = self._state
        state.fade, state.held, state.calm = max(state.fade, _HOLD), 0, 0
        state.rested = False
        state.linearisations = [term.linearise(state.x) for term in self._terms]
        self._relaxation.forget()
        self.resume()

    def resume(self) -> None:
        """Count steps and look for the best shape from here on."""
        self._best, self.status, self._solved, self.restless = Best(), None, 0, False
        self._state.idle, self._state.best_worst = 0, np.inf
        self.history.clear()

    def retarget(self, name: str, term: Term) -> None:
        """Put ``term`` in the place of the guide with that name; its stencil must be the same."""
        first = len(self.problem.constraints)
        for k, guide in enumerate(self.problem.guides):
            if guide.term.name == name:
                self.problem.guides[k] = replace(guide, term=term)
                self._terms[first + k] = term
                self._state.linearisations[first + k] = term.linearise(self._state.x)
                return
        raise KeyError(name)

    def restart(self) -> None:
        """Go back to the start and the first attempt; pattern and analysis are kept."""
        stay = self._turn == 0
        self._turn, self._attempt, self.attempts = 0, 1, 1
        if stay:
            self._restart()
        else:
            self._prepare()
        self.resume()

    def stop(self) -> None:
        """End here; the outcome is the best mesh so far."""
        if not self.finished:
            self._conclude(STOPPED)

    def run(self, callback: Callable[[StepRecord], bool | None] | None = None) -> Outcome:
        """Take all steps that are left and return the outcome.

        ``callback`` is called after each step; returning True stops. So does a
        ``KeyboardInterrupt``, in the same clean way.
        """
        try:
            while not self.finished:
                record = self.step()
                if callback is not None and callback(record):
                    self.stop()
        except KeyboardInterrupt:
            self.stop()
        return self.outcome()

    def outcome(self) -> Outcome:
        """Best mesh so far and its report; the status is ``stopped`` while steps are left."""
        return summarise(self, self._found())

    def _found(self) -> Candidate:
        return self._best.so_far() or self._judge(self._state.x)

    def _prepare(self) -> None:
        """Lay out the equations of the current problem and stand at its start."""
        problem = self.problem
        terms = [*problem.constraints, *(guide.term for guide in problem.guides)]
        self._system = NormalEquations(
            terms,
            problem.free,
            problem.mesh.vertices,
            # rslab orders the unknowns itself.
            reorder=self.backend == "scipy",
        )
        self.solver = symmetric_solver(self._system.pattern, self.backend)
        self._stepper = Stepper(self._system, self.solver)
        self._relaxation = Relaxation(self._system, self.solver)
        self._restart()

    def _restart(self) -> None:
        problem = self.problem
        self._terms: list[Term] = [
            *problem.constraints,
            *(guide.term for guide in problem.guides),
        ]
        self._following = [k for k, term in enumerate(self._terms) if follows(term)]
        x = problem.start.copy()
        self._state = _State(x, [term.linearise(x) for term in self._terms])
        self._relaxation.forget()

    @property
    def _pull(self) -> Pull | None:
        """The handles, where there are any."""
        return next((term for term in self._terms if isinstance(term, Pull)), None)

    def _fade(self, record: StepRecord) -> None:
        """Move the schedule on: guides fade, but wait for handles and the mesh to come to rest."""
        state, pull = self._state, self._pull
        if pull is not None and self.holding and state.fade * _FADE <= _HOLD:
            if state.fade == _HOLD and pull.arrived:
                state.held += 1
                state.calm = state.calm + 1 if record.step_length < _REST else 0
                state.rested = state.calm >= _CALM
                if state.rested:
                    # Nothing but the shape is taken along from the way here.
                    state.damping, state.worst_before = _HOLD_DAMPING, np.inf
                self.restless = state.held >= _HOLD_STEPS
            state.fade = _HOLD
        if not self.holding or state.fade > _HOLD:
            state.fade *= _FADE
            if state.fade < _FADE_END or (record.worst < _NEAR and not self.holding):
                state.fade = 0.0

    def _follow(self, state: _State) -> None:
        """Let terms that depend on where the mesh is (closest points, loads) look again."""
        for k in self._following:
            self._terms[k] = cast(FollowingTerm, self._terms[k]).follow(state.x)
            state.linearisations[k] = self._terms[k].linearise(state.x)

    def _judge(self, x: FloatArray, problem: Problem | None = None) -> Candidate:
        problem = problem or self.problem
        if problem.easier:
            # The shape counts by what was asked for; the easier net has no scalars in common.
            mesh, wanted = problem.mesh_at(x), self.original
            x = wanted.start.copy()
            x[: 3 * len(mesh.vertices)] = ((mesh.vertices - wanted.centre) / wanted.scale).ravel()
            return judge(wanted, x, self.tolerance)
        return judge(problem, x, self.tolerance, self.original)

    def _weights(self, fade: float) -> FloatArray:
        guides = [
            guide.weight(self._attempt) * (1.0 if guide.lasting else fade)
            for guide in self.problem.guides
        ]
        return np.array([1.0] * len(self.problem.constraints) + guides)

    def _residuals(self, linearisations: list[Linearisation]) -> dict[str, float]:
        worst: dict[str, float] = {}
        for term, part in zip(self.problem.constraints, linearisations, strict=False):
            largest = float(np.abs(part.residual).max(initial=0.0))
            worst[term.name] = max(worst.get(term.name, 0.0), largest)
        return worst

    def _decide(self, record: StepRecord) -> None:
        """Finish the attempt where it has converged, is stuck, or the steps are used up."""
        state = self._state
        if record.worst < 0.5 * state.best_worst:
            state.best_worst, state.idle = record.worst, 0
        elif state.fade == 0.0:
            state.idle += 1
        self._best.note(record.worst, partial(self._judge, state.x, self.problem))
        steps_left = self.max_steps - len(self.history)
        near = 0.25 * self.tolerance if state.slow else _MARGIN * self.tolerance
        if record.worst <= near or state.idle >= _PATIENCE:
            self._end_attempt(steps_left)
        elif steps_left <= 0:
            self._conclude(STOPPED)

    def _end_attempt(self, steps_left: int) -> None:
        if self.problem.easier and self._follow_up(steps_left):
            return
        candidate = self._judge(self._state.x)
        self._best.consider(candidate)
        if candidate.valid and not candidate.flattened:
            self._solved += 1
        # Whoever drags a mesh may crease it.
        good = candidate.valid if self._pull is not None else candidate.good
        enough = good or self._solved >= _ENOUGH or steps_left <= 0
        if enough or not self._next_attempt():
            self._conclude(STALLED)

    def _follow_up(self, steps_left: int) -> bool:
        """Start the wanted net from what an easier one found; return whether that was possible."""
        problem = self.problem
        found = judge(problem, self._state.x, self.tolerance, self.original)
        last = self._attempt >= problem.attempts
        usable = found.good or (found.valid and last)
        if not usable or steps_left <= 0 or problem.easier is None:
            return False
        self._problems[self._turn] = problem.easier(found.mesh)
        self._attempt, self.attempts = 1, self.attempts + 1
        self._prepare()
        return True

    def _next_attempt(self) -> bool:
        """Start the next attempt, of this problem or the next; return whether there is one."""
        if self._attempt < self.problem.attempts:
            self._attempt += 1
            self._restart()
        elif self._turn + 1 < len(self._problems):
            self._turn, self._attempt = self._turn + 1, 1
            self._prepare()
        else:
            return False
        self.attempts += 1
        return True

    def _conclude(self, status: str) -> None:
        best = self._best.consider(self._judge(self._state.x))
        self.status = (COLLAPSED if best.gone else CONVERGED) if best.valid else status
