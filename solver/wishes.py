"""What the exact net nearest to what was drawn is near to: a surface, or handles at their goals."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from solver.mesh.closest import Polyline, TriangleSurface
from solver.mesh.connectivity import Connectivity
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.problem import Problem
from solver.terms.base import Term, coordinates_of, length, points_of
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
    righted: bool = False,
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
        righted: corners are to turn upright, also where those of the start are not; border and
            edges hold the more.
    """
    net, points = problem.mesh.connectivity, _in_units_of(problem, start.vertices)
    rest, tuning = problem.at(start), problem.tuning
    used = np.flatnonzero(net.referenced)
    shortest = np.linalg.norm(np.diff(points[net.edges], axis=1), axis=2).min()
    ground = surface.scaled(problem.centre, problem.scale)
    lifts = halfway(net, points, ground, tuning)
    room = tuning.roomy if near or righted else tuning.room
    corners = CornerGuard.of(net.quads, points, tuning.slants[early])
    guard, held = tuning.along_guard, tuning.along_border
    if righted:
        corners = CornerGuard(net.quads, np.full((len(net.quads), 4), tuning.righting))
        guard, held = tuning.righted_guard, tuning.righted_border
    borders = (OnCurve(loop, Polyline(points[loop], closed=True)) for loop in net.boundary_loops)
    return [
        Wish(NearSurface(used, ground, lifts[used]), 1.0),
        *_not_beyond(problem, ground, within),
        Wish(Evenness(net.line_quadruples), evenness),
        Wish(Fairness(net.line_triples, rest, "smooth motion"), tuning.along_motion),
        *(Wish(ring, tuning.along_motion) for ring in umbrellas(net, rest)),
        Wish(Closeness(used, points[used]), tuning.along_closeness),
        Wish(Orthogonality(net.quads, name="right angles"), tuning.along_squareness * evenness),
        *(Wish(border, held) for border in borders),
        *_guards(net, shortest, room, tuning, guard),
        Wish(corners, guard),
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
        *_guards(net, shortest, problem.tuning.room, problem.tuning, problem.tuning.along_guard),
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


def _guards(
    net: Connectivity, shortest: float, room: float, tuning: Tuning, weight: float
) -> list[Wish]:
    """Edges stay long and faces open, and what is so already feels nothing."""
    return [
        Wish(EdgeGuard(net.edges, room * shortest), weight),
        Wish(FaceGuard(net.quads, tuning.upright), weight),
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


def _in_units_of(problem: Problem, points: FloatArray) -> FloatArray:
    return np.asarray((np.asarray(points, dtype=np.float64) - problem.centre) / problem.scale)
