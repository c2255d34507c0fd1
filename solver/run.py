"""An optimisation: attempts are made one by one, and what came of each decides on the next."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from solver.along import Along
from solver.analysis.start import Remark
from solver.candidate import Candidate, judge
from solver.gauss_newton import Descent, Layout
from solver.last_phase import Aim
from solver.linear.backends import default_backend
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nearest import NearestNet
from solver.plan import Attempt, Attempts, alone
from solver.problem import Problem
from solver.repetition import Repeat
from solver.report import STOPPED, Outcome, StepRecord
from solver.summary import RunSummary, summarise
from solver.whole_plan import Ended, WholePlan

# Residuals, and moves in mean edges, that come of coordinates with seven digits.
_ROUNDED = 1e-5


class Optimisation:
    """An optimisation that is advanced one step at a time.

    No problem is changed. Between steps the current shape can be read from ``mesh``; after any
    number of steps ``outcome`` gives the best mesh so far and its report.

    Args:
        original: the net from its start, against which results are judged.
        way: begins the way to it, by default one attempt at the original.
        tolerance: largest measure of the net, over all faces or stars, that counts as zero.
        max_steps: steps of all attempts together.
        backend: name of the sparse solver, by default the fastest installed.
        accept_start: a start that already is the net is returned untouched.
        remarks: what stands in the way of the net, for the report and its advice.
        held: what keeps vertices from moving freely, such as "fixed vertices", for the advice.
        origin: what the problems' coordinates are measured from; what comes out is in the model's.
        descent: the first attempt where it is under way already.
        aim: which of all such nets is wanted.
        repeat: parts of which few kinds are wanted, once the net is reached.
    """

    def __init__(
        self,
        original: Problem,
        way: Callable[[], Attempts] | None = None,
        tolerance: float = 1e-10,
        max_steps: int = 1000,
        backend: str | None = None,
        accept_start: bool = True,
        remarks: Sequence[Remark] = (),
        held: Sequence[str] = (),
        origin: LocalOrigin | None = None,
        descent: Descent | None = None,
        aim: Aim | None = None,
        repeat: Repeat | None = None,
    ) -> None:
        begun = time.perf_counter()
        self.original, self._begin_way = original, way or partial(alone, original)
        self.remarks, self.held = tuple(remarks), tuple(held)
        self.origin = origin or LocalOrigin(np.zeros(3))
        self.tolerance, self.max_steps = tolerance, max_steps
        self.backend = backend or default_backend(int(original.free.sum()))
        self.history: list[StepRecord] = []
        self.status: str | None = None
        self.aim, self._repeat = aim or Aim(), repeat
        asked = self.aim, repeat, tolerance, max_steps, self.backend, self.history
        self._plan = WholePlan(original, self._begin_way, *asked)
        self._way = self._plan.way()
        attempt = next(self._way)
        assert isinstance(attempt, Attempt)
        self.descent = descent or Descent(Layout(attempt, self.backend), attempt)
        self._now: Descent | Along = self.descent
        self.attempts = 1
        self.seconds_setup = time.perf_counter() - begun
        if not original.free.any():
            self._go_on(self._ended())
        elif accept_start:
            start = self._rounded(judge(original, original.start, tolerance))
            if start.valid:
                self._way = self._plan.from_net(self._plan.best.consider(start))
                self._go_on(None)

    def _rounded(self, start: Candidate) -> Candidate:
        """A net that its file rounded, exact again by corrections of least length."""
        if start.valid or start.worst > _ROUNDED:
            return start
        exact = NearestNet(self.original, start.x, [], self.backend).exact()
        found = judge(self.original, exact, self.tolerance)
        moved = np.linalg.norm(found.mesh.vertices - start.mesh.vertices, axis=1).max()
        return found if found.valid and moved < _ROUNDED * start.mesh.mean_edge else start

    def afresh(self, descent: Descent) -> Optimisation:
        """The same from the beginning, with its first attempt under way already.

        Args:
            descent: of the first attempt.
        """
        return Optimisation(
            self.original,
            self._begin_way,
            self.tolerance,
            self.max_steps,
            self.backend,
            False,
            self.remarks,
            self.held,
            self.origin,
            descent,
            self.aim,
            self._repeat,
        )

    @property
    def problem(self) -> Problem:
        """The problem that is being tried."""
        return self._now.problem

    @property
    def finished(self) -> bool:
        """True when no further step will be taken."""
        return self.status is not None

    @property
    def shape(self) -> QuadMesh:
        """What is in sight, about the origin: the best where all is over, else where it stands."""
        return self._found().mesh if self.finished else self._now.mesh

    @property
    def mesh(self) -> QuadMesh:
        """Current shape in model units."""
        return self.origin.back_mesh(self._now.mesh)

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
        left = self.max_steps - len(self.history) - 1
        record = self._now.step(len(self.history) + 1, left + 1, self.attempts)
        self.history.append(record)
        over = self._now.is_over(record, self.tolerance, left)
        if isinstance(self._now, Descent) and not self._now.holds(left):
            here = partial(self._plan.judged, self._now.attempt, self._now.point.x)
            self._plan.best.note(record.worst, here)
        if over or left <= 0:
            self._go_on(self._ended(stopped=not over))
        return record

    def stop(self) -> None:
        """End here; the outcome is the best mesh so far."""
        if not self.finished:
            self._go_on(self._ended(stopped=True))

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
        course = RunSummary(
            self.original,
            self.status or STOPPED,
            self.history,
            self.attempts,
            self.max_steps,
            self.seconds_setup,
            self.backend,
            self.descent.layout.solver.remark,
            self.remarks,
            self.held,
            self.origin,
            self.aim.surface,
            self.aim.within,
            self._plan.given_up > 0,
            self._plan.repetition,
        )
        return summarise(course, self._found())

    def _go_on(self, ended: Ended | None) -> None:
        """Begin the attempt that follows on how one ended; where there is none, all has ended."""
        try:
            attempt = next(self._way) if ended is None else self._way.send(ended)
        except StopIteration as end:
            # Interrupted within, it has no answer.
            self.status = end.value or self._plan.status_of(self._found(), stopped=True)
            return
        self.attempts += 1
        self._now = self._begun(attempt)
        nothing_helps = isinstance(attempt, Along) and attempt.over
        if nothing_helps or len(self.history) >= self.max_steps:
            self._go_on(self._ended())

    def _begun(self, attempt: Attempt | Along) -> Descent | Along:
        """An attempt that is ready for its first step."""
        if isinstance(attempt, Along):
            return attempt
        before = self.descent
        shared = before.layout.serves(attempt)
        layout = before.layout if shared else Layout(attempt, self.backend)
        self.descent = Descent(layout, attempt, before.restless)
        return self.descent

    def _ended(self, stopped: bool = False) -> Ended:
        """How the present attempt ended."""
        if isinstance(self._now, Along):
            return Ended(self._now.reached(), stopped)
        now = self._now
        reached = judge(now.problem, now.point.x, self.tolerance, self.original)
        return Ended(reached, stopped, now.given_up)

    def _found(self) -> Candidate:
        """The best so far; where nothing was judged yet, where it stands."""
        attempt, x = self.descent.attempt, self.descent.point.x
        return self._plan.best.so_far() or self._plan.judged(attempt, x)
