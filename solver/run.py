"""An optimisation: the attempts of a plan one by one, and the best of what they reached."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from solver import last_phase
from solver.analysis.form import surface_of
from solver.analysis.start import Remark
from solver.best import Best
from solver.candidate import Candidate, judge
from solver.gauss_newton import Descent, Layout, largest_residuals
from solver.linear.backends import default_backend
from solver.mesh.closest import TriangleSurface
from solver.mesh.local_origin import LocalOrigin
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nearest import NearestNet
from solver.plan import Attempt, Way, alone
from solver.problem import Problem
from solver.repetition import Repeat, Repetition
from solver.report import CONVERGED, STALLED, STOPPED, Outcome, Repeated, StepRecord
from solver.summary import Course, summarise

# A net that so many attempts have given up is.
_GIVEN_UP = 2


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
        way: Callable[[], Way] | None = None,
        tolerance: float = 1e-10,
        max_steps: int = 1000,
        backend: str | None = None,
        accept_start: bool = True,
        remarks: Sequence[Remark] = (),
        held: Sequence[str] = (),
        origin: LocalOrigin | None = None,
        descent: Descent | None = None,
        aim: last_phase.Aim | None = None,
        repeat: Repeat | None = None,
    ) -> None:
        begin = time.perf_counter()
        self.original, self._begin_way = original, way or partial(alone, original)
        self.remarks, self.held = tuple(remarks), tuple(held)
        self.origin = origin or LocalOrigin(np.zeros(3))
        self.tolerance, self.max_steps = tolerance, max_steps
        self.backend = backend or default_backend(int(original.free.sum()))
        self.history: list[StepRecord] = []
        self.status: str | None = None
        self.attempts, self._solved, self._best = 1, 0, Best(original.tuning.worth)
        self.aim = aim or last_phase.Aim()
        self._nearest: NearestNet | Repetition | None = None
        self._repeat = repeat
        self.repetition: Repeated | None = None
        self._most, self._given_up = 0, 0
        self._evenness, self._near, self._pressed = last_phase.EVENNESS, False, False
        self._hope: Candidate | None = None
        self._neared: Candidate | None = None
        self._way = self._begin_way()
        attempt = next(self._way)
        self.descent = descent or Descent(Layout(attempt.problem, self.backend), attempt)
        self.seconds_setup = time.perf_counter() - begin
        if not original.free.any():
            self._conclude(STALLED)
        elif accept_start:
            start = judge(original, original.start, tolerance)
            if start.valid:
                self._end(self._best.consider(start))

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
        return self._nearest.problem if self._nearest is not None else self.descent.problem

    @property
    def finished(self) -> bool:
        """True when no further step will be taken."""
        return self.status is not None

    @property
    def shape(self) -> QuadMesh:
        """What is in sight, about the origin: the best where all is over, else where it stands."""
        return self._found().mesh if self.finished else self._standing

    @property
    def mesh(self) -> QuadMesh:
        """Current shape in model units."""
        return self.origin.back_mesh(self._standing)

    @property
    def _standing(self) -> QuadMesh:
        return self._nearest.mesh if self._nearest is not None else self.descent.mesh

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
        if self._nearest is not None:
            return self._step_nearer(self._nearest)
        done = len(self.history)
        record = self.descent.step(done + 1, self.max_steps - done, self.attempts)
        self.history.append(record)
        steps_left = self.max_steps - len(self.history)
        if not self.descent.holds(steps_left):
            self._decide(record, steps_left)
        return record

    def stop(self) -> None:
        """End here; the outcome is the best mesh so far."""
        if self.finished:
            return
        if isinstance(self._nearest, Repetition):
            self._end_repetition(self._nearest)
        elif self._nearest is not None:
            self._end_nearest(self._nearest, again=False)
        else:
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
        course = Course(
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
            self._given_up > 0,
            self.repetition,
        )
        return summarise(course, self._found())

    def _found(self) -> Candidate:
        return self._best.so_far() or self._judged()

    def _decide(self, record: StepRecord, steps_left: int) -> None:
        """End the attempt where it is over, or everything where the steps are used up."""
        over = self.descent.is_over(record, self.tolerance)
        if not over and self.descent.attempt.hasty and self.descent.hopeless(self.tolerance):
            self._given_up += 1
            over = True
        attempt, x = self.descent.attempt, self.descent.point.x
        self._best.note(record.worst, partial(self._judge, attempt, x))
        if over:
            self._end_attempt(steps_left)
        elif steps_left <= 0:
            self._conclude(STOPPED)

    def _end_attempt(self, steps_left: int) -> None:
        """Weigh what an attempt reached; from what folded or creased the way goes on elsewhere."""
        attempt, x = self.descent.attempt, self.descent.point.x
        reached = judge(attempt.problem, x, self.tolerance, self.original)
        if attempt.leads_on(reached) and steps_left > 0:
            self._go_on(reached)
            return
        candidate = self._judge(attempt, x) if attempt.easier else reached
        self._best.consider(candidate)
        if candidate.valid and not candidate.flattened:
            self._solved += 1
        # Whoever drags a mesh may crease it.
        good = candidate.valid if self.descent.pulled else candidate.good
        enough = good or self._solved >= self.original.tuning.enough or steps_left <= 0
        enough = enough or self._given_up >= _GIVEN_UP
        if not enough and self._solved == 1 and self._hopeful(candidate):
            # Along the nets lines turn even and edges long in less time than another attempt takes.
            self._hope = reached
            self._begin_nearest(candidate, last_phase.EARLY)
        elif enough or not self._go_on(reached):
            self._conclude(STALLED)

    def _hopeful(self, net: Candidate) -> bool:
        """Whether a net that is not good may become so along the nets, which is tried once."""
        tried = self.descent.pulled or self._neared is not None or not self.aim.early
        return not tried and net.valid and not net.flattened and self._may_go_nearer

    def _go_on(self, reached: Candidate) -> bool:
        """Begin the next attempt of the way; return whether there is one."""
        try:
            attempt = self._way.send(reached)
        except StopIteration:
            return False
        before = self.descent
        shared = attempt.problem is before.problem
        layout = before.layout if shared else Layout(attempt.problem, self.backend)
        self.descent = Descent(layout, attempt, before.restless)
        self.attempts += 1
        return True

    def _judge(self, attempt: Attempt, x: FloatArray) -> Candidate:
        """Judge a shape as the wanted net."""
        if attempt.easier:
            # It counts by what was asked for; the easier net has no scalars in common.
            mesh = attempt.problem.mesh_at(x)
            return judge(self.original, self.original.at(mesh), self.tolerance)
        return judge(attempt.problem, x, self.tolerance, self.original)

    def _judged(self) -> Candidate:
        """The shape where it stands."""
        return self._judge(self.descent.attempt, self.descent.point.x)

    def _conclude(self, status: str) -> None:
        best = self._best.consider(self._judged())
        # What came of a last phase already is not led on by another.
        wanted = best is not self._neared and (self.aim.late or self.descent.pulled)
        sound = wanted and best.valid and not best.gone
        if status == STALLED and sound and self._may_go_nearer:
            rough = self.aim.nearest or self.aim.early
            self._near = not rough and self._in_reach(best) is not None
            evenness = last_phase.NEARLY if self._near else last_phase.EVENNESS
            self._begin_nearest(best, evenness)
        elif best.valid:
            self._end(best, goes_on=status == STALLED)
        else:
            self.status = status

    def _end(self, net: Candidate, goes_on: bool = True) -> None:
        """End with a net, or go on from it to one with few kinds of parts."""
        self.status = last_phase.verdict(net, self.aim.meant and not self.original.may_flatten)
        if self.status != CONVERGED or not goes_on or self._repeat is None:
            return
        ground = self.aim.surface or surface_of(self.original.mesh)
        limits = self.tolerance, self.aim.within
        phase = Repetition(net, self.original, ground, self._repeat, *limits, self.backend)
        self._nearest, self.status, self.attempts = phase, None, self.attempts + 1
        if phase.finished or len(self.history) >= self.max_steps:
            self._end_repetition(phase)

    def _end_repetition(self, repetition: Repetition) -> None:
        """Keep the net with the fewest kinds of parts."""
        self._best = Best(self.original.tuning.worth)
        self._best.consider(repetition.judged())
        self.repetition, self.status = repetition.report(), CONVERGED

    @property
    def _may_go_nearer(self) -> bool:
        if len(self.history) >= self.max_steps or not self.original.free.any():
            return False
        return last_phase.has_a_wish(self._found(), self.original, self.aim.surface)

    def _begin_nearest(self, best: Candidate, evenness: float, within: float | None = None) -> None:
        """Begin the last phase."""
        asks = self.original, self.aim.surface, evenness, within, self._near
        wishes = last_phase.wishes_of(best.problem, *asks)
        self._nearest = NearestNet(best.problem, best.x, wishes, self.backend)
        self._evenness, done = evenness, len(self.history)
        # Nobody asked for what is tried beside a surface, so that it may not take long.
        asked = within is not None and self.aim.within is not None
        before = done if asked or not self._pressed else 0
        wanted, hoped = asked or self.aim.nearest, self._hope is not None
        self._most = min(self.max_steps, done + last_phase.most_steps(before, wanted, hoped))
        self.attempts += 1

    def _step_nearer(self, nearest: NearestNet | Repetition) -> StepRecord:
        begin, damping = time.perf_counter(), nearest.damping
        length, solving = nearest.step()
        record = StepRecord(
            step=len(self.history) + 1,
            attempt=self.attempts,
            energy=nearest.wishes,
            residuals=largest_residuals(nearest.problem.constraints, nearest.point.linearisations),
            step_length=length,
            damping=damping,
            fade=0.0,
            seconds=time.perf_counter() - begin,
            solve_seconds=solving,
        )
        self.history.append(record)
        if isinstance(nearest, Repetition):
            if nearest.finished or len(self.history) >= self.max_steps:
                self._end_repetition(nearest)
        elif nearest.finished or len(self.history) >= self._most:
            self._end_nearest(nearest)
        return record

    def _end_nearest(self, nearest: NearestNet, again: bool = True) -> None:
        """Keep what the last phase reached, unless it lost what made the shape before it good.

        Then it is tried ``again``, once, with more weight on even lines.
        """
        before = self._found()
        found = judge(nearest.problem, nearest.exact(), self.tolerance, self.original)
        better = found.good and not before.good
        sound = last_phase.is_sound(found, before)
        again = again and len(self.history) < self.max_steps and not self.descent.pulled
        once = self._pressed or self._hope is not None
        if again and not sound and self._evenness < last_phase.EVENER and not once:
            self._begin_nearest(before, last_phase.EVENER)
            return
        far = self._far(before)
        if sound and last_phase.is_whole(found, before):
            near = self._far(found)
            asked = self.aim.within is not None or not self._pressed
            if better or (near < far and (asked or not found.dearer_than(before))):
                self._best, far = Best(self.original.tuning.worth), near
                self._best.consider(found)
        limit = self.aim.within
        if limit is None and self._near:
            limit = self._in_reach(self._found())
        if again and not self._pressed and limit is not None and far > limit:
            self._pressed = True
            self._begin_nearest(self._found(), self._evenness, limit)
        elif not (again and self._resumes()):
            self._end(self._found(), goes_on=again)

    def _resumes(self) -> bool:
        """Take up the way again where a last phase that came early led to no good net."""
        hope, self._hope, self._neared = self._hope, None, self._found()
        if hope is None or last_phase.is_enough(self._neared) or not self._go_on(hope):
            return False
        self._nearest = None
        return True

    def _in_reach(self, net: Candidate) -> float | None:
        """How near a net may come that is nearly on its surface already."""
        return last_phase.in_reach(net, self._ground, self.original)

    def _far(self, net: Candidate) -> float:
        """What the last phase lowers: the largest distance of handles, else from the surface."""
        return last_phase.far_off(net, self._ground)

    @property
    def _ground(self) -> TriangleSurface | None:
        return None if self.descent.pulled else self.aim.surface
