"""From the start to the net that is wanted: a plan's attempts, and from what they reach the rest.

As in :mod:`solver.plan` a way is read from above: each ``yield`` is an attempt, and gives back how
that attempt ended. The last phase is made of attempts too: those move along the nets.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from typing import NamedTuple

import numpy as np

from solver import last_phase
from solver.along import Along
from solver.analysis.form import surface_of
from solver.best import Best
from solver.candidate import Candidate, judge
from solver.last_phase import Aim, AlongCourse, course_from
from solver.mesh.closest import TriangleSurface
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nearest import NearestNet
from solver.plan import Attempt, Attempts
from solver.problem import Problem
from solver.repetition import Repeat, Repetition
from solver.report import CONVERGED, STALLED, STOPPED, Repeated, StepRecord
from solver.wishes import limit_in_reach, pull_of


class Ended(NamedTuple):
    """How an attempt ended.

    Attributes:
        reached: the shape at its end, judged as the net that it was at.
        stopped: it was broken off, and no other is wanted.
        given_up: it came nearer to the net too slowly.
    """

    reached: Candidate
    stopped: bool = False
    given_up: bool = False


class WholePlan:
    """All that comes one after the other until there is nothing left to try.

    Args:
        original: the net from its start, against which results are judged.
        begin: begins the plan's way to the net.
        aim: which of all such nets is wanted.
        repeat: parts of which few kinds are wanted, once the net is reached.
        tolerance: largest measure of the net that counts as zero.
        max_steps: steps of all attempts together.
        backend: name of the sparse solver.
        history: records of all steps so far, to which whoever makes the attempts adds.

    Attributes:
        best: the best shape so far.
        given_up: attempts that came nearer too slowly.
        repetition: kinds of parts, where few were asked for and the net was reached.
    """

    def __init__(
        self,
        original: Problem,
        begin: Callable[[], Attempts],
        aim: Aim,
        repeat: Repeat | None,
        tolerance: float,
        max_steps: int,
        backend: str,
        history: Sequence[StepRecord],
    ) -> None:
        self.original, self.begin, self.aim, self.repeat = original, begin, aim, repeat
        self._tolerance, self._backend, self._history = tolerance, backend, history
        self._most = max_steps if original.free.any() else 0
        self._tuning = original.tuning
        self.best, self.given_up = Best(self._tuning.worth), 0
        self.repetition: Repeated | None = None
        self._stopped = self._pressed = False
        self._mended: Candidate | None = None
        # Of the last two nets: many points are looked up for each.
        self._distances: list[tuple[Candidate, float]] = []

    def way(self) -> WholeWay:
        """A net, from it the one nearest to what was drawn, and from that one of few kinds."""
        net = yield from self._to_a_net()
        if self._may_go_nearer(net):
            net = yield from self._nearer(net)
        elif self._may_be_righted(net):
            net = yield from self._righted(net)
        return (yield from self.from_net(net))

    def from_net(self, net: Candidate) -> WholeWay:
        """From the nearest net to one with few kinds of parts, where that is asked for.

        Returns the status with which all ends.
        """
        status = self.status_of(net, self._stopped)
        if status == CONVERGED and self.repeat is not None and not self._stopped:
            ground = self.aim.surface or surface_of(self.original.mesh)
            limits = self._tolerance, self.aim.within
            few = Repetition(net, self.original, ground, self.repeat, *limits, self._backend)
            kinds = yield Along(few, few.judged)
            self._keep(kinds.reached)
            self.repetition = few.report()
        return status

    def status_of(self, best: Candidate, stopped: bool = False) -> str:
        """With which status all ends where that is the best that was found."""
        if best.valid:
            return last_phase.verdict(best, self.aim.meant and not self.original.may_flatten)
        return STOPPED if stopped else STALLED

    def judged(self, attempt: Attempt, x: FloatArray) -> Candidate:
        """A shape of an attempt, judged as the wanted net."""
        if attempt.easier:
            return self._as_wanted(attempt.problem.mesh_at(x))
        return judge(attempt.problem, x, self._tolerance, self.original)

    def _as_wanted(self, mesh: QuadMesh) -> Candidate:
        """A shape that counts by what was asked for: an easier net has no scalars in common."""
        return judge(self.original, self.original.at(mesh), self._tolerance)

    def _to_a_net(self) -> Whole:
        """The plan's attempts until one is good enough, or none is left; then the best of all.

        The first that reached a net, though a bad one, is led on along the nets before the next.
        """
        way, solved = self.begin(), 0
        attempt: Attempt | None = next(way)
        while attempt is not None:
            ended = yield attempt
            reached = self._ended(ended)
            if attempt.leads_on(reached) and self._steps_left > 0 and not self._stopped:
                attempt = _after(way, reached)
                continue
            net = self._as_wanted(reached.mesh) if attempt.easier else reached
            best = self.best.consider(net)
            solved += net.valid and not net.flattened
            if self._stopped or self._is_enough(net, solved):
                break
            if solved == 1 and self._may_be_mended(net):
                # Along the nets lines turn even and edges long in less time than in other attempts.
                best = self._mended = yield from self._nearer(net, early=True)
                if last_phase.is_enough(best) or not self._may_go_on:
                    break
            attempt = _after(way, reached)
        return best

    def _nearer(self, net: Candidate, early: bool = False) -> Whole:
        """Along the nets to the surface, or to handles; then the best of what there is now.

        Where that spoilt the net, once more with evener lines; where the net is farther off than
        it may be, once more with what is beyond that weighing more.
        """
        best, pulled = self.best.so_far() or net, self._ground is None
        rough = self.aim.nearest or self.aim.early
        course = course_from(net, self._far(net), self.original, pulled, rough, early)
        found = yield from self._along(net, course, early)
        spoilt = not last_phase.is_sound(found, best)
        if spoilt and self._may_go_on and not early and not self._pressed:
            course = AlongCourse(self._tuning.along_evener, course.near)
            found = yield from self._along(best, course, early)
        best = self._kept(found, best)
        near = course.near and self.aim.within is None
        limit = self._in_reach(best) if near else self.aim.within
        free = self._may_go_on and not self._pressed
        if free and limit is not None and self._far(best) > limit:
            self._pressed = True
            course = course._replace(sharp=False, late=False)
            found = yield from self._along(best, course, early, limit)
            best = self._kept(found, best)
        return best

    def _righted(self, net: Candidate) -> Whole:
        """Along the nets to one that is more like the start, with even lines weighing ever less."""
        best, tuning = self.best.so_far() or net, self._tuning
        before = best
        for evenness in tuning.righted_evenness:
            course = AlongCourse(evenness, righted=True)
            found = yield from self._along(before, course, early=False)
            sound = last_phase.is_sound(found, best) and last_phase.is_as_whole(found, before)
            if sound and self._faithful(found) > self._faithful(best):
                best = self._keep(found)
            if not self._may_go_on or (best.good and last_phase.is_upright(best)):
                break
        return best

    def _faithful(self, net: Candidate) -> float:
        size = np.linalg.norm(np.ptp(self.original.mesh.vertices, axis=0))
        return last_phase.faithful(net, self._far(net) / float(size))

    def _along(
        self, net: Candidate, course: AlongCourse, early: bool, limit: float | None = None
    ) -> Whole:
        """One attempt along the nets, and one more for the largest distance: what they reached."""
        tuning, near = self._tuning, course.near
        asks = self.original, self.aim.surface, course.evenness, limit, near, early
        wishes = last_phase.wishes_of(net.problem, *asks, course.righted)
        nearest = NearestNet(net.problem, net.x, wishes, self._backend)
        # Nobody asked for what is tried beside a surface, so that it may not take long.
        asked = limit is not None and self.aim.within is not None
        before = len(self._history) if asked or not self._pressed else 0
        if course.righted:
            # All of these together may take as long as what came before.
            before //= len(tuning.righted_evenness)
        most = last_phase.most_steps(tuning, before, asked or self.aim.nearest, early)

        def reached() -> Candidate:
            return judge(net.problem, nearest.exact(), self._tolerance, self.original)

        if course.sharp:
            nearest.worth = tuning.peak_begin
        attempt = Along(nearest, reached, round(tuning.peak_late * most) if course.late else most)
        found = self._ended((yield attempt))
        if not (course.sharp or course.late) or not self._may_go_on:
            return found
        nearest.sharpen(tuning.along_worth if course.late else tuning.peak_worth)
        sharp = self._ended((yield Along(nearest, reached, most - attempt.taken)))
        kept = sharp.smoothness >= min(found.smoothness - tuning.peak_cost, tuning.peak_even)
        kept = kept and last_phase.is_sound(sharp, found) and last_phase.is_whole(sharp, net)
        if kept and self._far(sharp) < self._far(found):
            return sharp
        plain = course._replace(sharp=False, late=False)
        return (yield from self._along(found, plain, early)) if self._may_go_on else found

    def _ended(self, ended: Ended) -> Candidate:
        self._stopped = ended.stopped
        self.given_up += ended.given_up
        return ended.reached

    def _kept(self, found: Candidate, before: Candidate) -> Candidate:
        """What an attempt along the nets reached, unless it lost what made the net before good."""
        if not (last_phase.is_sound(found, before) and last_phase.is_whole(found, before)):
            return before
        if found.good and not before.good:
            return self._keep(found)
        asked = self.aim.within is not None or not self._pressed
        nearer = self._far(found) < self._far(before)
        worth = nearer and (asked or not found.dearer_than(before))
        return self._keep(found) if worth or self._mends(found, before) else before

    def _mends(self, found: Candidate, before: Candidate) -> bool:
        """Whether lines that zigzagged are even now, and the net on its surface all the same."""
        tuning, size = self._tuning, np.ptp(self.original.mesh.vertices, axis=0)
        near = self._ground is not None and self.aim.within is None
        near = near and self._far(found) <= tuning.on_surface * float(np.linalg.norm(size))
        return near and before.smoothness < tuning.crumpled <= found.smoothness

    def _keep(self, net: Candidate) -> Candidate:
        """Take a net for the best, whatever there was before it."""
        self.best = Best(self._tuning.worth)
        return self.best.consider(net)

    def _is_enough(self, net: Candidate, solved: int) -> bool:
        """Whether no further attempt is to be made, so many having reached the net."""
        # Whoever drags a mesh may crease it.
        good = net.valid if self._pulled else net.good
        tries = solved >= self._tuning.enough or self.given_up >= self._tuning.futile
        return good or tries or self._steps_left <= 0

    def _may_be_mended(self, net: Candidate) -> bool:
        """Whether a net that is not good may become so along the nets, which is tried once."""
        tried = self._pulled or self._mended is not None or not self.aim.early
        return not tried and net.valid and not net.flattened and self._has_a_wish(net)

    def _may_go_nearer(self, net: Candidate) -> bool:
        """Whether the last phase follows; not on what came of one already."""
        wanted = net is not self._mended and (self.aim.late or self._pulled)
        sound = wanted and not self._stopped and net.valid and not net.gone
        return sound and self._has_a_wish(net)

    def _may_be_righted(self, net: Candidate) -> bool:
        """Whether what is left of the start is to grow along the nets."""
        wanted = self.aim.righted and not self._pulled and not self._stopped
        sound = wanted and self._steps_left > 0 and net.valid and not net.flattened
        return sound and not (net.good and last_phase.is_upright(net))

    def _has_a_wish(self, net: Candidate) -> bool:
        best = self.best.so_far() or net
        wishes = self._steps_left > 0
        return wishes and last_phase.has_a_wish(best, self.original, self.aim.surface)

    @property
    def _may_go_on(self) -> bool:
        return not self._stopped and self._steps_left > 0 and not self._pulled

    @property
    def _steps_left(self) -> int:
        return self._most - len(self._history)

    @property
    def _pulled(self) -> bool:
        """Whether there are handles."""
        return pull_of(self.original) is not None

    def _in_reach(self, net: Candidate) -> float | None:
        """How near a net may come that is nearly on its surface already."""
        if self._ground is None:
            return None
        return limit_in_reach(self._far(net), self.original.mesh, self._tuning)

    def _far(self, net: Candidate) -> float:
        """What the last phase lowers: the largest distance of handles, else from the surface."""
        for known, far in self._distances:
            if known is net:
                return far
        self._distances = [*self._distances[-1:], (net, last_phase.far_off(net, self._ground))]
        return self._distances[-1][1]

    @property
    def _ground(self) -> TriangleSurface | None:
        return None if self._pulled else self.aim.surface


# Yields attempts, is sent how each of them ended, and returns a net or the status of all.
Whole = Generator[Attempt | Along, Ended, Candidate]
WholeWay = Generator[Attempt | Along, Ended, str]


def _after(way: Attempts, reached: Candidate) -> Attempt | None:
    """The next attempt of a way, None at its end."""
    try:
        return way.send(reached)
    except StopIteration:
        return None
