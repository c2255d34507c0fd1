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
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from solver.assembly import NormalEquations
from solver.errors import SingularSystemError
from solver.linear.backends import default_backend, symmetric_solver
from solver.linear.threads import one_thread
from solver.mesh.closest import Polyline, TriangleSurface
from solver.mesh.connectivity import Connectivity
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.point import Point
from solver.problem import Problem
from solver.terms.base import Linearisation, Term, coordinates_of, length, points_of
from solver.terms.beyond_surface import BeyondSurface
from solver.terms.closeness import Closeness
from solver.terms.corner_guard import CornerGuard
from solver.terms.edge_guard import EdgeGuard
from solver.terms.evenness import Evenness
from solver.terms.face_guard import FaceGuard
from solver.terms.fairness import Fairness
from solver.terms.gliding import OnCurve
from solver.terms.near_surface import NearSurface
from solver.terms.orthogonality import Orthogonality
from solver.terms.pull import Pull
from solver.terms.umbrella import umbrellas
from solver.tuning import Tuning

# Moves of so many mean edges are rounding.
_ROUNDING = 1e-15


class Wish(NamedTuple):
    """What the nearest net is near to.

    Attributes:
        term: its squared residuals are lowered.
        weight: factor of them.
    """

    term: Term
    weight: float


def nearness(
    problem: Problem,
    start: QuadMesh,
    surface: TriangleSurface,
    evenness: float,
    within: float | None = None,
    near: bool = False,
    early: bool = False,
) -> list[Wish]:
    """Wish for a net on a surface whose lines run as evenly as those of the start did.

    Most weighs the distance from the surface, halfway between vertices and what lies between
    them. Evenness of the lines, and a little of the motion,
    keeps them from zigzagging for the last millimetre; the border stays about where it was, though
    a net across the surface's curvature has to leave it; faces are not sheared where the net lets
    them; short edges and crossed faces are pushed
    back by guards that are silent elsewhere.

    Args:
        problem: the net.
        start: the mesh as it was drawn, with the problem's faces.
        surface: in the units of the problem's mesh.
        evenness: weight of lines that bend evenly, where that of the distance is one.
        within: distance from the surface, in model units, from which on it weighs more.
        near: the net nearly is on the surface: short edges need not give way.
        early: other attempts would follow, so that corners may stay more upright.
    """
    net, points = problem.mesh.connectivity, _in_units_of(problem, start.vertices)
    rest, tuning = problem.at(start), problem.tuning
    used = np.flatnonzero(net.referenced)
    shortest = np.linalg.norm(np.diff(points[net.edges], axis=1), axis=2).min()
    ground = TriangleSurface(_in_units_of(problem, surface.vertices), surface.triangles)
    lifts = halfway(net, points, ground, tuning)
    borders = (OnCurve(loop, Polyline(points[loop], closed=True)) for loop in net.boundary_loops)
    return [
        Wish(NearSurface(used, ground, lifts[used]), 1.0),
        *_not_beyond(problem, ground, within),
        Wish(Evenness(net.line_quadruples), evenness),
        Wish(Fairness(net.line_triples, rest, "smooth motion"), tuning.along_motion),
        *(Wish(ring, tuning.along_motion) for ring in umbrellas(net, rest)),
        Wish(Closeness(used, points[used]), tuning.along_closeness),
        Wish(Orthogonality(net.quads, name="right angles"), tuning.along_squareness * evenness),
        *(Wish(border, tuning.along_border) for border in borders),
        *_guards(net, shortest, tuning.roomy if near else tuning.room, tuning),
        Wish(CornerGuard.of(net.quads, points, tuning.slants[early]), tuning.along_guard),
    ]


def halfway(
    net: Connectivity, points: FloatArray, surface: TriangleSurface, tuning: Tuning
) -> FloatArray:
    """How far beside a curved surface vertices lie for whole faces to be off it the least.

    The surface rises over an edge with both ends on it, and over the middle of a face by as much as
    over two of its edges together. The mean rise of the edges at a vertex is half of that: lifted
    by it, vertices are off on one side by what the middles are off on the other.

    Args:
        net: the connectivity.
        points: (V, 3) vertices near the surface.
        surface: in the same unit.
        tuning: which edges cut across.

    Returns:
        (V, 3) from the surface to where a vertex is wanted.
    """
    ends = surface.closest(points)[0][net.edges]
    middles = ends.mean(axis=1)
    rises = surface.closest(middles)[0] - middles
    # Over a crease, a step or a hole edges cut across, and no lift would help.
    rises[length(rises) > tuning.across * length(ends[:, 1] - ends[:, 0])] = 0.0
    sides, sums = net.half_edge_edges, np.zeros_like(points)
    # By faces: edges inside, which run across the border, count twice, those along it once.
    np.add.at(sums, net.edges[sides].ravel(), np.repeat(rises[sides], 2, axis=0))
    counts = np.bincount(net.edges[sides].ravel(), minlength=len(points))
    found: FloatArray = sums / np.maximum(counts, 1)[:, None]
    return found


def drawn(problem: Problem, start: QuadMesh, pull: Pull) -> list[Wish]:
    """Wish for handles at their goals and neighbours that move alike.

    Args:
        problem: the net.
        start: the mesh as it was drawn, with the problem's faces.
        pull: of the problem.
    """
    net, rest = problem.mesh.connectivity, problem.at(start)
    goals = pull.targets if pull.goals is None else pull.goals
    ends = points_of(rest, coordinates_of(net.edges))
    shortest = float(length(ends[:, 1] - ends[:, 0]).min())
    return [
        Wish(Closeness(pull.vertices, goals, name=pull.name), 1.0),
        Wish(Fairness(net.line_triples, rest, "smooth motion"), problem.tuning.along_motion),
        *_guards(net, shortest, problem.tuning.room, problem.tuning),
    ]


def limit_in_reach(far: float, start: QuadMesh, tuning: Tuning) -> float | None:
    """How far off a surface a net may be where nobody says so; None where it is far from that.

    Args:
        far: how far it is, in model units.
        start: the mesh as it was drawn.
        tuning: how far that is.
    """
    limit = tuning.on_surface * float(np.linalg.norm(np.ptp(start.vertices, axis=0)))
    return limit if far <= tuning.in_reach * limit else None


def missing(problem: Problem, x: FloatArray) -> FloatArray:
    """(n,) distances of the handles of a problem from their goals, in model units."""
    pull = pull_of(problem)
    if pull is None:
        return np.zeros(0)
    goals = pull.targets if pull.goals is None else pull.goals
    return problem.scale * length(x[pull.unknowns] - goals)


def pull_of(problem: Problem) -> Pull | None:
    """The handles of a problem, where it has any."""
    terms = (guide.term for guide in problem.guides)
    return next((term for term in terms if isinstance(term, Pull)), None)


def _guards(net: Connectivity, shortest: float, room: float, tuning: Tuning) -> list[Wish]:
    """Edges stay long and faces open, and what is so already feels nothing."""
    return [
        Wish(EdgeGuard(net.edges, room * shortest), tuning.along_guard),
        Wish(FaceGuard(net.quads, tuning.upright), tuning.along_guard),
    ]


def _not_beyond(problem: Problem, ground: TriangleSurface, within: float | None) -> Iterator[Wish]:
    """Wishes for vertices and middles of faces that are no farther from the surface than that."""
    if within is None:
        return
    net, tuning = problem.mesh.connectivity, problem.tuning
    limit = tuning.inside * within / problem.scale
    groups = [same.faces for same in net.by_size]
    for chosen in (np.flatnonzero(net.referenced)[:, None], *groups):
        yield Wish(BeyondSurface(chosen, ground, limit), tuning.forbidden)


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
        self.finished = not wishes or not len(system.sparsity.unknowns)

    @property
    def mesh(self) -> QuadMesh:
        """Current shape, in the units of the problem's mesh."""
        return self.problem.mesh_at(self.point.x)

    @property
    def wishes(self) -> float:
        """Weighted sum of squares of the wishes where it stands."""
        return self.point.weighed(self._wished).energy

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
                    self.finished = done or gain < tuning.along_worth * before
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


def _in_units_of(problem: Problem, points: FloatArray) -> FloatArray:
    return np.asarray((np.asarray(points, dtype=np.float64) - problem.centre) / problem.scale)
