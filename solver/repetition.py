"""The exact net with few kinds of panels, edges or nodes: groups, and a pull towards their shapes.

From a net that was reached, steps along the nets (:mod:`solver.nearest`) lower how far parts are
from the shapes of their kinds, together with the distance from the design surface and the
unevenness of the lines. The pull grows from stage to stage, and shapes are the means of their
parts. Kinds are rows of parts first, which leads to surfaces that repeat along their lines and
costs least of the form; then parts that are alike already, which may change their kind on the way.
What counts is measured on the mesh itself: the number of kinds such that every part is within the
tolerance of the shape of its kind.

Source: Eigensatz et al. (2010), Paneling architectural freeform surfaces; Fu et al. (2010), K-set
tilable surfaces; Singh, Schaefer (2010), Triangle surfaces with discrete equivalence classes.
"""

from __future__ import annotations

import copy
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import cast

import numpy as np

from solver.analysis.form import off_surface
from solver.analysis.kinds import EDGES, NODES, PANELS, Kinds, kinds_within, spokes
from solver.analysis.rows import families
from solver.candidate import Candidate, judge
from solver.errors import InputError
from solver.grouping import Groups, groups_of, in_rows, merged, near_ones, stressed, unstressed
from solver.mesh.closest import TriangleSurface
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nearest import NearestNet
from solver.point import Point
from solver.problem import Problem
from solver.report import Repeated
from solver.terms.gliding import OnCurve
from solver.wishes import Wish, nearness


@dataclass(frozen=True)
class Repeat:
    """What is asked for.

    Attributes:
        of: panels, edges or nodes.
        kinds: how many there may be; None for as few as can be found.
        alike: how far a part may be from the shape of its kind, in model units, of nodes in
            degrees.
    """

    of: str
    kinds: int | None
    alike: float

    def refuse_impossible(self, mesh: QuadMesh) -> None:
        """Refuse what no net of this mesh can have.

        Raises:
            InputError: no kinds, more than there are parts, fewer than there must be.
        """
        if self.kinds is None:
            return
        net = mesh.connectivity
        counts = {PANELS: len(mesh.faces), EDGES: len(net.edges), NODES: net.referenced.sum()}
        most, least = int(counts[self.of]), 1
        if self.of == NODES:
            least = len({hubs.neighbours.shape[1] for hubs in spokes(mesh)})
        if not least <= self.kinds <= most:
            why = ", one for each number of edges that meet" if least > 1 else ""
            raise InputError(
                f"kinds: expected {least} to {most}, as the mesh has {most} {self.of}{why}, got "
                f"{self.kinds}"
            )


@dataclass(frozen=True, eq=False)
class _Found:
    """A net on the way, its kinds, and how far off the surface it is."""

    x: FloatArray
    kinds: Kinds
    off: float


class Repetition:
    """Moves along the nets of a problem towards few kinds of parts, one step at a time.

    Args:
        net: a net that was reached.
        original: the net from its start, against which results are judged.
        surface: the design surface, in model units.
        asked: what is to repeat.
        tolerance: largest residual of a net.
        within: how far from the surface it may be, in model units.
        backend: name of the sparse solver.

    Attributes:
        found: the best so far; at first the net itself.
        damping: of the next step.
        finished: true where no further step helps.
    """

    def __init__(
        self,
        net: Candidate,
        original: Problem,
        surface: TriangleSurface,
        asked: Repeat,
        tolerance: float,
        within: float | None = None,
        backend: str | None = None,
    ) -> None:
        self.problem, self.asked, self._backend = net.problem, asked, backend
        self._tuning = net.tuning
        self._net, self._original, self._tolerance = net, original, tolerance
        self._surface, self._within = surface, within
        evenness = self._tuning.kinds_evenness
        self._wishes = nearness(net.problem, original.mesh, surface, evenness, within)
        self.found = self._first = self._counted(net.x)
        self._stages = self._way()
        self._nearest: NearestNet | None = None
        self._terms: list[Groups] = []
        self._taken = 0
        self.finished = self._enough or not net.problem.free.any() or not self._next()

    @property
    def point(self) -> Point:
        """Where it stands."""
        assert self._nearest is not None
        return self._nearest.point

    @property
    def damping(self) -> float:
        """Added to the matrix in the next step."""
        return self._nearest.damping if self._nearest is not None else 0.0

    @property
    def wishes(self) -> float:
        """Weighted sum of squares of what is lowered."""
        return self._nearest.wishes if self._nearest is not None else 0.0

    @property
    def mesh(self) -> QuadMesh:
        """Current shape, in the units of the problem's mesh."""
        return self.problem.mesh_at(self._net.x if self._nearest is None else self.point.x)

    def step(self) -> tuple[float, float]:
        """Take one step; ``finished`` turns true where there is nothing left to try."""
        assert self._nearest is not None
        result = self._nearest.step()
        self._taken += 1
        if self._nearest.finished or self._taken >= self._tuning.stage_steps:
            self.finished = not self._next()
        return result

    def judged(self) -> Candidate:
        """The net with the fewest kinds, their parts equal to the last digit where they can be."""
        if self.found is not self._first and self._enough:
            equal = self._equal(self.found.x)
            if equal is not None:
                self.found = self._counted(equal)
        return self._judge(self.found.x)

    def report(self) -> Repeated:
        """What was found, as the report of a run says it."""
        asked, kinds = self.asked, self.found.kinds
        return Repeated(
            of=asked.of,
            kinds=kinds.number,
            asked=asked.kinds,
            alike=asked.alike,
            largest_miss=kinds.worst,
            kinds_before=self._first.kinds.number,
            counts=cast(list[int], kinds.counts.tolist()),
            kind=cast(list[int], kinds.kind.tolist()),
            is_reached=asked.kinds is None or self._enough,
        )

    @property
    def _enough(self) -> bool:
        asked = self.asked.kinds
        return asked is not None and self.found.kinds.number <= asked

    def _next(self) -> bool:
        """Begin the next stage; return whether there is one."""
        try:
            self._nearest, self._taken = next(self._stages), 0
        except StopIteration:
            return False
        return True

    def _way(self) -> Iterator[NearestNet]:
        """The stages of all groups that are tried, each from the net itself."""
        for border in self._tuning.kinds_borders:
            wishes = [
                wish._replace(weight=border) if isinstance(wish.term, OnCurve) else wish
                for wish in self._wishes
            ]
            for x, terms in self._groups():
                yield from self._staged(wishes, x, terms)
            if self._enough or self.asked.kinds is None:
                return

    def _staged(
        self, wishes: list[Wish], x: FloatArray, terms: list[Groups]
    ) -> Iterator[NearestNet]:
        """Pull groups together, more from stage to stage."""
        for weight in self._tuning.stages:
            pulls = [Wish(stressed(term, x, self._tuning), weight) for term in terms]
            nearest = NearestNet(self.problem, x, [*wishes, *pulls], self._backend)
            if nearest.finished:
                return
            yield nearest
            x, terms = nearest.exact(), groups_of(nearest.point.terms)
            if self._weigh(x, terms):
                return

    def _groups(self) -> Iterator[tuple[FloatArray, list[Groups]]]:
        """Where to begin and with which groups: rows along either family of lines at first.

        Of both families that which stays nearer to the surface is kept. Where rows are too many,
        those that have come out alike become one; last come parts that are alike from the first.
        """
        mesh, of, asked, x = self.problem.mesh, self.asked.of, self.asked.kinds, self._net.x
        if families(mesh) > 1:
            for family in range(families(mesh)):
                yield x, in_rows(mesh, x, of, family, asked)
        for part in self._tuning.kinds_fewer:
            if asked is not None and not self._enough and self._terms:
                yield self.found.x, merged(self._terms, round(part * asked), self.found.x)
        if self._enough:
            return
        before = self._first.kinds.number
        numbers = (
            [round(part * before) for part in self._tuning.kinds_tries]
            if asked is None
            else [asked]
        )
        for number in dict.fromkeys(max(1, number) for number in numbers):
            if number < self.found.kinds.number:
                yield x, near_ones(mesh, x, of, number, self._tuning.kinds_rounds)

    def _weigh(self, x: FloatArray, terms: list[Groups]) -> bool:
        """Keep a net that is better; return whether its kinds are few enough."""
        found, best, asked = self._counted(x), self.found, self.asked.kinds
        enough = asked is not None and found.kinds.number <= asked
        if enough and self._enough:
            better = found.off < best.off
        else:
            better = found.kinds.number < best.kinds.number
        if better and self._sound(x):
            self.found, self._terms = found, terms
        return enough

    def _counted(self, x: FloatArray) -> _Found:
        mesh = self.problem.mesh_at(x)
        off = float(off_surface(mesh, self._surface).max())
        return _Found(x, kinds_within(mesh, self.asked.of, self.asked.alike), off)

    def _equal(self, x: FloatArray) -> FloatArray | None:
        """The same net with parts that are equal to the last digit, where that can be."""
        assert self._nearest is not None
        problem = copy.copy(self.problem)
        problem.constraints = list(self.problem.constraints)
        for term in self._terms:
            placed = unstressed(term.follow(x))
            shared = problem.scalars(placed.shapes.ravel()).reshape(placed.shapes.shape)
            problem.constraints.append(replace(placed, shared=shared))
        begin = np.concatenate([x, problem.start[len(x) :]])
        there = NearestNet(problem, begin, [], self._backend).exact()
        rest = [np.abs(term.linearise(there).residual).max() for term in problem.constraints]
        there = there[: len(x)]
        good = (
            max(rest) <= self._tuning.equal
            and self._counted(there).kinds.number <= self.found.kinds.number
        )
        return there if good and self._sound(there) else None

    def _judge(self, x: FloatArray) -> Candidate:
        return judge(self.problem, x, self._tolerance, self._original)

    def _sound(self, x: FloatArray) -> bool:
        """Whether a net with fewer kinds of parts is still what was drawn."""
        before, found, tuning = self._net, self._judge(x), self._tuning
        whole = found.area_ratio >= tuning.still_whole * before.area_ratio
        rough = (found.creased and not before.creased) or (found.uneven and not before.uneven)
        if not (found.valid and whole and found.kept >= tuning.still_roomy) or rough:
            return False
        far = [float(off_surface(net.mesh, self._surface).max()) for net in (before, found)]
        # As reports say it: the net from which it sets out may have drawn back already.
        size = float(np.linalg.norm(np.ptp(self._original.mesh.vertices, axis=0)))
        return far[1] <= max(self._within or tuning.far_off * size, far[0])
