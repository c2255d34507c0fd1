"""The way to a net: what is tried from which start, in which order, and what it is followed by.

A way is read from above: each ``yield`` is an attempt, and gives back what that attempt reached.
Whoever makes the attempts stops asking as soon as one of them is good enough.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from solver.analysis.start import bent_lines
from solver.candidate import Candidate
from solver.mesh.bend import central_directions, doubly_curved, unbent
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import QuadMesh
from solver.nets import NETS, Easier, Net
from solver.nets.constraints import Constraints, SurfaceGlide, add_constraints
from solver.nets.options import NetOptions
from solver.nets.settings import Weights, add_guides
from solver.problem import Problem
from solver.terms.evenness import Evenness
from solver.tuning import Tuning


@dataclass(frozen=True)
class Attempt:
    """A problem, and how its guides lead.

    Attributes:
        problem: several attempts may share one, so that its equations are laid out once.
        weights: of the guides; by default each has its own.
        patient: the guides wait until handles have arrived and the mesh has come to rest.
        easier: the net is not the wanted one but one on the way to it.
        last: no other attempt at this problem follows.
        hasty: it is given up where its pace shows that the net is far out of reach.
    """

    problem: Problem
    weights: Weights | None = None
    patient: bool = True
    easier: bool = False
    last: bool = True
    hasty: bool = False

    def weights_of_guides(self, fade: float) -> list[float]:
        """Weight of each guide where those that fade have faded to ``fade``."""
        return [
            (self.weights.of(guide) if self.weights else guide.weight)
            * (1.0 if guide.lasting else fade)
            for guide in self.problem.guides
        ]

    @property
    def used(self) -> list[bool]:
        """Whether each term of the problem, constraints first, weighs anything in it."""
        guides = [weight > 0 for weight in self.weights_of_guides(1.0)]
        return [True] * len(self.problem.constraints) + guides

    def leads_on(self, reached: Candidate) -> bool:
        """Whether what an easier net reached is a start for the wanted one."""
        return self.easier and (reached.good or (reached.valid and self.last))


# Yields attempts and is sent what each of them reached, judged as the net that it was at.
Attempts = Generator[Attempt, Candidate, None]


def alone(problem: Problem) -> Attempts:
    """The way of a problem that somebody posed: one attempt."""
    yield Attempt(problem)


@dataclass(frozen=True, eq=False)
class Plan:
    """A net with all that was said about it.

    Attributes:
        net: what is wanted.
        mesh: the start.
        fixed: (V,) true for vertices that must not move.
        weights: of the guides in the first attempt.
        once: one attempt with these weights, and no other.
        tuning: the numbers of the solver.
        supports: (V,) true for vertices that carry its loads, by default the fixed ones.
        rectangle: faces along and across the patches of the multi-net guide.
    """

    net: Net
    mesh: QuadMesh
    fixed: BoolArray
    options: NetOptions
    constraints: Constraints
    weights: Weights
    once: bool = False
    tuning: Tuning = field(default_factory=Tuning)
    supports: BoolArray | None = None
    rectangle: tuple[int, int] = (1, 2)

    def way(self) -> Attempts:
        """From the start to the net."""
        if self.once:
            return self._first()
        if self.net.way.bent:
            return self._of_a_sheet()
        return self._round_by_easier_nets() if self.net.way.easier else self._first()

    @cached_property
    def original(self) -> Problem:
        """The net from the start as it is, against which results are judged."""
        return self._pose(self.net, self.mesh, self._at_first)

    def _first(self) -> Attempts:
        """The wanted net from the start, with one set of guides after the other.

        Where one leads to a surface of another size, faces that keep their shape lead next, once.
        Not where nothing is left of the shape: no such net is like it, and it would crumple.
        """
        keep = not self.once
        for attempt in _attempts(self.original, self._at_first, hasty=self._hasty):
            reached = yield attempt
            if reached.flattened and self._futile:
                return
            keep = keep and not reached.gone
            if keep and reached.resized:
                keep = False
                keeping = [replace(self.weights, isometry=weight) for weight in self.tuning.keeping]
                yield from self._tries(self.mesh, keeping)

    def _round_by_easier_nets(self) -> Attempts:
        """The net; where that is not good, an easier net and from it the net; then other guides."""
        yield from self._first()
        for easier in self.net.way.easier:
            yield from self._by(easier)
        yield from self._tries(self.mesh, self._ladder[1:])

    def _by(self, easier: Easier) -> Attempts:
        """The easier net, until it is reached; from what was reached the wanted one."""
        ladder = self._ladder
        smoother = [replace(one, fairness=easier.fairness * one.fairness) for one in ladder]
        if easier.evenness:
            ladder = smoother = [
                one.even(easier.evenness) for one in smoother[: self.tuning.drawn_even]
            ]
        problem = self._pose(NETS[easier.net], self.mesh, smoother)
        for attempt in _attempts(problem, smoother, easier=True):
            reached = yield attempt
            if attempt.leads_on(reached):
                yield from self._tries(reached.mesh, ladder)
                return

    def _of_a_sheet(self) -> Attempts:
        """The sheet as it is, then bent in one direction only, then as it is with other guides.

        A net that no doubly curved start reaches begins with the bent ones.
        """
        if self._double and self.net.way.rigid:
            yield from self._from_bent_starts()
            yield from self._first()
        else:
            yield from self._first()
            yield from self._from_bent_starts()
        yield from self._tries(self.mesh, self._ladder[len(self._at_first) :])

    def _from_bent_starts(self) -> Attempts:
        """The net from the sheet without its curvature in one direction, then in the other."""
        if self.fixed.any() or self.constraints != Constraints():
            return
        ladder = [*self._even(self.tuning.bent), *self.weights.ladder(self.tuning)]
        for direction in central_directions(self.mesh):
            yield from self._tries(unbent(self.mesh, direction), ladder)

    def _tries(self, mesh: QuadMesh, ladder: Sequence[Weights]) -> Attempts:
        """The wanted net from a mesh, with one set of guides after the other."""
        problem = self._pose(self.net, mesh, ladder)
        yield from _attempts(problem, ladder, hasty=self._hasty)

    def _pose(self, net: Net, mesh: QuadMesh, ladder: Sequence[Weights]) -> Problem:
        """Pose the wanted net, or another with the same options, for all attempts of a ladder."""
        empty = Problem(
            net.name,
            mesh,
            self.fixed,
            may_flatten=self._may_flatten,
            may_resize=bool(self.net.flat or self.constraints.handles),
            tuning=self.tuning,
            supports=self.supports,
        )
        problem = net.recipe(empty, self.options)
        add_constraints(problem, self.constraints, ladder[0].closeness)
        return add_guides(problem, ladder, self.rectangle)

    @property
    def _hasty(self) -> bool:
        """Whether attempts whose pace leads nowhere are given up; whoever drags has time."""
        return self.net.way.rigid and not self.constraints.handles

    @cached_property
    def _futile(self) -> bool:
        """Whether a surface that flattened would do so again, whatever the guides."""
        if not self.net.asymptotic(self.options):
            return False
        return bent_lines(self.mesh, self.options.diagonal) is not None

    @property
    def _may_flatten(self) -> bool:
        """Whether a plane was asked for: by a net of sheets, or by saying where vertices are."""
        wanted = self.constraints
        surface = any(isinstance(glide, SurfaceGlide) for glide in wanted.glide)
        return bool(self.net.flat or wanted.handles or wanted.close_to is not None or surface)

    @cached_property
    def _double(self) -> bool:
        """Whether the start is curved in both directions."""
        return doubly_curved(self.mesh)

    @cached_property
    def _ladder(self) -> list[Weights]:
        """Weights of all attempts from the start, the first ones as asked for."""
        first, *rest = self.weights.ladder(self.tuning)
        if self.net.way.guarded:
            weight = self.tuning.guard
            guards = {"edge_guard": weight, "face_guard": weight}
            guarded = [replace(one, **guards) for one in (first, *rest)]
            # Some differ by their guards only.
            return list(dict.fromkeys(guarded))
        if not self.net.way.bent:
            return [first, *self._even(self.net.way.evenness), *rest]
        even = self._even(self.tuning.domes if self._double else self.tuning.sheets)
        return [first, *even, *rest] if self._smooth else [*even, first, *rest]

    @cached_property
    def _at_first(self) -> list[Weights]:
        """Weights of the attempts that come before any way round."""
        way = self.net.way
        if way.bent:
            count = 1 if self._smooth or self._double else len(self.tuning.sheets)
        else:
            count = 1 if way.easier else len(self._ladder)
        return self._ladder[: 1 if self.once else count]

    @cached_property
    def _smooth(self) -> bool:
        """Whether a sheet is bent in one direction and has no noise: it needs no evenness."""
        straight = not self._double and not self.net.way.rigid
        return straight and _unevenness(self.mesh) < self.tuning.smooth

    def _even(self, weights: Sequence[float]) -> list[Weights]:
        return [self.weights.even(weight) for weight in weights]


def _attempts(
    problem: Problem, ladder: Sequence[Weights], easier: bool = False, hasty: bool = False
) -> Attempts:
    """One attempt for each set of guides, the first of them patient."""
    for number, weights in enumerate(ladder, 1):
        yield Attempt(problem, weights, number == 1, easier, number == len(ladder), hasty)


def _unevenness(mesh: QuadMesh) -> float:
    """Root mean square of the third differences along parameter lines, in mean edges."""
    term = Evenness(mesh.connectivity.line_quadruples)
    residual = term.linearise(mesh.vertices.ravel()).residual
    return float(np.sqrt((residual**2).sum(axis=1).mean()) / mesh.mean_edge) if len(residual) else 0
