"""The exact net with few kinds of panels, edges or nodes: groups, and a pull towards their shapes.

From a net that was reached, steps along the nets (:mod:`solver.nearest`) lower how far parts are
from the shapes of their kinds, together with the distance from the design surface and the
unevenness of the lines. The pull grows from stage to stage; within a stage parts may change their
kind, and shapes are the means of their parts. What counts is measured on the mesh itself: the
number of kinds such that every part is within the tolerance of the shape of its kind. Where that is
more than was asked for, other numbers of groups are tried, and the least that was found is kept.

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
from solver.candidate import Candidate, judge
from solver.errors import InputError
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nearest import NearestNet, Wish, nearness
from solver.point import Point
from solver.problem import Problem
from solver.report import Repeated
from solver.terms.repetition import SameAngles, SameLengths

# Weights of the pull, one stage each, where that of the distance from the surface is one.
_STAGES = (1.0, 30.0, 1e3, 3e4)
# Steps of a stage at most.
_STEPS = 25
# Weight of lines that bend evenly: that lengths jump from kind to kind works against it.
_EVENNESS = 1.0
# Parts farther from their shape are pulled the more: sums of this power, not of squares.
_POWER, _LEAST_STRESS = 4, 0.1
# Rounds in which parts find their first kinds.
_ROUNDS = 30
# Numbers of groups that are tried in turn, as parts of the number of kinds there was.
_TRIES = (0.5, 0.25, 0.12)
# Less of the area, or shorter edges than these parts, and it is another shape.
_STILL_WHOLE, _STILL_ROOMY = 0.85, 0.4
# With this residual parts of a kind are equal as far as numbers tell.
_EQUAL = 1e-11


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
        if not (np.isfinite(self.alike) and self.alike > 0):
            name = "alike_angle" if self.of == NODES else "alike"
            raise InputError(f"{name}: expected more than 0, got {self.alike}")
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
    """A net on the way, and its kinds."""

    x: FloatArray
    kinds: Kinds


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
        self._net, self._original, self._tolerance = net, original, tolerance
        self._surface, self._within = surface, within
        self._wishes = nearness(net.problem, original.mesh, surface, _EVENNESS, within)
        self.found = self._first = self._counted(net.x)
        self._stages = self._way()
        self._nearest: NearestNet | None = None
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
        if self._nearest.finished or self._taken >= _STEPS:
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
        """The stages of every number of groups that is tried, each from the net itself."""
        for number in self._numbers():
            x, terms = self._net.x, self._groups(number)
            for weight in _STAGES:
                terms = [_stressed(term, x) for term in terms]
                wishes = [*self._wishes, *(Wish(term, weight) for term in terms)]
                nearest = NearestNet(self.problem, x, wishes, self._backend)
                if nearest.finished:
                    break
                yield nearest
                x = nearest.exact()
                terms = [
                    term
                    for term in nearest.point.terms
                    if isinstance(term, SameLengths | SameAngles)
                ]
                if self._weigh(x):
                    return

    def _numbers(self) -> Iterator[int]:
        """Of groups: what was asked for, then some between that and the least that was found."""
        asked, before = self.asked.kinds, self._first.kinds.number
        if asked is None:
            yield from dict.fromkeys(max(1, round(part * before)) for part in _TRIES)
            return
        yield asked
        for _ in range(2):
            between = round(np.sqrt(asked * self.found.kinds.number))
            if not asked < between < self.found.kinds.number:
                return
            yield between

    def _weigh(self, x: FloatArray) -> bool:
        """Keep a net that has fewer kinds and is as good; return whether they are few enough."""
        counted = self._counted(x)
        if counted.kinds.number < self.found.kinds.number and self._sound(x):
            self.found = counted
        return self._enough

    def _counted(self, x: FloatArray) -> _Found:
        mesh = self.problem.mesh_at(x)
        return _Found(x, kinds_within(mesh, self.asked.of, self.asked.alike))

    def _groups(self, number: int) -> list[SameLengths | SameAngles]:
        """The parts in so many groups as they are at the beginning."""
        rng = np.random.default_rng(0)
        blank, x = _blank(self.problem.mesh, self.asked.of), self._net.x
        whole = sum(len(term.groups) for term in blank)
        shares = [max(1, round(number * len(term.groups) / whole)) for term in blank]
        found = []
        for term, share in zip(blank, shares, strict=True):
            term = replace(term, shapes=_seeds(term, x, share, rng))
            for _ in range(_ROUNDS):
                before, term = term.shapes, term.follow(x)
                if np.array_equal(before, term.shapes):
                    break
            found.append(term)
        return found

    def _equal(self, x: FloatArray) -> FloatArray | None:
        """The same net with parts that are equal to the last digit, where that can be."""
        assert self._nearest is not None
        terms = [t for t in self.point.terms if isinstance(t, SameLengths | SameAngles)]
        problem = copy.copy(self.problem)
        problem.constraints = [*self.problem.constraints, *(_even(term) for term in terms)]
        there = NearestNet(problem, x, [], self._backend).exact()
        rest = [np.abs(term.linearise(there).residual).max() for term in problem.constraints]
        counted = self._counted(there)
        good = max(rest) <= _EQUAL and counted.kinds.number <= self.found.kinds.number
        return there if good and self._sound(there) else None

    def _judge(self, x: FloatArray) -> Candidate:
        return judge(self.problem, x, self._tolerance, self._original)

    def _sound(self, x: FloatArray) -> bool:
        """Whether a net with fewer kinds of parts is still what was drawn."""
        before, found = self._net, self._judge(x)
        whole = found.area_ratio >= _STILL_WHOLE * before.area_ratio
        creased = found.creased and not before.creased
        if not (found.valid and whole and found.kept >= _STILL_ROOMY) or creased:
            return False
        far = [float(off_surface(net.mesh, self._surface).max()) for net in (before, found)]
        return self._within is None or far[1] <= max(self._within, far[0])


def _blank(mesh: QuadMesh, of: str) -> list[SameLengths | SameAngles]:
    """The parts, in no groups yet; nodes with different numbers of edges apart."""
    if of == NODES:
        found: list[SameLengths | SameAngles] = []
        for hubs in spokes(mesh):
            groups = np.column_stack([hubs.vertices, hubs.neighbours])
            turns = _around(hubs.neighbours.shape[1])
            some = turns if hubs.closed else turns[:1]
            found.append(SameAngles(groups, some, np.zeros((1, 1)), np.ones(len(groups))))
        return found
    if of == EDGES:
        edges = mesh.connectivity.edges
        return [SameLengths(edges, np.array([[0, 1]]), np.zeros((1, 1)), np.ones(len(edges)))]
    faces = mesh.faces
    return [SameLengths(faces, _around(4), np.zeros((1, 6)), np.ones(len(faces)))]


def _around(count: int) -> IntArray:
    return (np.arange(count)[:, None] + np.arange(count)) % count


def _seeds(
    term: SameLengths | SameAngles, x: FloatArray, number: int, rng: np.random.Generator
) -> FloatArray:
    """Values of so many parts that are far from each other.

    Source: Arthur, Vassilvitskii (2007), k-means++: the advantages of careful seeding.
    """
    values = term.values(x)
    turned, chosen = values[:, term.orders], [int(rng.integers(len(values)))]
    away = np.full(len(values), np.inf)
    while len(chosen) < number:
        last = ((turned - values[chosen[-1]]) ** 2).sum(axis=2).min(axis=1)
        away = np.minimum(away, last)
        if away.max() <= 1e-24:
            break
        chosen.append(int(rng.choice(len(values), p=away / away.sum())))
    return np.asarray(values[chosen])


def _stressed(term: SameLengths | SameAngles, x: FloatArray) -> SameLengths | SameAngles:
    """The same with more weight on parts that are far from their shapes."""
    placed = term.sorted(x)
    miss = np.abs(placed.values(x) - placed.wanted).max(axis=1)
    share = np.clip(miss / max(float(miss.max()), 1e-300), _LEAST_STRESS, 1.0)
    stress = share ** (_POWER / 2 - 1)
    return replace(placed, stress=stress / np.sqrt((stress**2).mean()))


def _even(term: SameLengths | SameAngles) -> SameLengths | SameAngles:
    """The same without more weight on some."""
    return replace(term, stress=np.ones(len(term.groups)))
