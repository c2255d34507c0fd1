"""A field of directions with the singular vertices that somebody asks for, and no others.

The smooth field that has its own is turned, in each triangle by an angle, so that it misses itself
by as many quarter turns round each vertex as it should: of all such turns the gentlest, which are
differences of a potential of the vertices. From there the field goes back to its guide, as far as
that takes no other singular vertex: between where curvature has one and where it is wanted the
guide is silent.

Source: Crane, Desbrun, Schroeder (2010), Trivial connections on discrete surfaces.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csc_array, diags_array
from scipy.sparse.linalg import splu
from scipy.spatial import cKDTree

from solver.align.crosses import VALENCES, Singular
from solver.align.field import QUARTER, DirectionField, GuidingField, quarters_of, smoothness, turns
from solver.align.prepare import Work
from solver.align.triangle_mesh import TriangleMesh, components, spanning
from solver.errors import InputError
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray
from solver.sentence import at

_WORDS = "3, 5 or 6"
# In edges, how far from the surface a singular vertex may be given.
_OFF = 1.0
# How fast a guide is silenced where the field leaves it, and in edges, how far round a singular
# vertex that it does not have.
_SILENCED, _ROUND = 4, 2.0
# How much stiffer directions are that a border or a stroke says.
_STIFF = 100.0
# Triangles round a vertex with six lines.
_AROUND = 6
# Parts of the guide that are tried where another singular vertex comes with it.
_PARTS = (1.0, 0.1, 1e-2, 0.0)


@dataclass(frozen=True, eq=False)
class Wanted:
    """Singular vertices that are asked for.

    Attributes:
        given: (V,) quarter turns round each vertex: 1 where three lines are to meet, -1 five, -2
            six; 0 elsewhere.
        own: (V,) which vertices are the surface's own; beyond them nothing is asked.
        bound: whether the net follows the border, which says what the turns have to add up to.
    """

    given: IntArray
    own: BoolArray
    bound: bool

    @classmethod
    def of(cls, work: Work, singular: Singular, edge: float, bound: BoolArray) -> Wanted:
        """Take the vertices that are nearest to places; several at one count together.

        Args:
            work: the surface.
            singular: places, and how many lines are to meet there.
            edge: wanted edge length.
            bound: (V,) the border's vertices if the net follows it; nothing is singular there.

        Raises:
            InputError: a number of lines that no net has, or a place that is off the surface.
        """
        mesh = work.mesh
        own = np.zeros(len(mesh.points), dtype=bool)
        own[mesh.triangles[: work.inner]] = True
        places, valences = _checked(work, singular, edge)
        free = own & ~mesh.on_rim & ~bound
        given = np.zeros(len(own), dtype=np.int64)
        np.add.at(given, _nearest(mesh, free, places), 4 - valences)
        # Half a turn round one vertex takes triangles enough to tell which way it goes.
        twice, around = np.flatnonzero(np.abs(given) > 1), np.bincount(mesh.triangles.ravel())
        halves, given[twice] = given[twice], 0
        np.add.at(given, _nearest(mesh, free & (around >= _AROUND), mesh.points[twice]), halves)
        wrong = np.flatnonzero((given != 0) & ~np.isin(4 - given, VALENCES))
        if len(wrong):
            raise InputError(
                f"singularities: those at {at(mesh.points[wrong[0]])} make a vertex with "
                f"{4 - given[wrong[0]]} lines, nets have {_WORDS}; move them apart"
            )
        return cls(given, own, bool(bound.any()))

    def misfit(self, automatic: DirectionField) -> str:
        """What is wrong if a net that follows the border cannot have these, in a sentence."""
        there, needed = int(self.given.sum()), int(automatic.quarters[self.own].sum())
        if not self.bound or there == needed:
            return ""
        lines = (3, 5) if needed > there else (5, 3)
        return (
            f"singularities: they add up to {there:+d} (3 lines +1, 5 lines -1, 6 lines -2), to "
            f"follow this border they need {needed:+d}: add {abs(needed - there)} with {lines[0]} "
            f"lines, or leave out as many with {lines[1]}"
        )

    def quarters(self, automatic: DirectionField) -> IntArray:
        """(V,) by how many quarter turns a field is to miss itself; beyond the border as it did."""
        return np.where(self.own, self.given, automatic.quarters)


def _nearest(mesh: TriangleMesh, free: BoolArray, places: FloatArray) -> IntArray:
    """The vertices, of those that are free (V,), nearest to places."""
    numbers = np.flatnonzero(free)
    return numbers[cKDTree(mesh.points[numbers]).query(places)[1]] if len(places) else numbers[:0]


def _checked(work: Work, singular: Singular, edge: float) -> tuple[FloatArray, IntArray]:
    places = np.asarray(singular.places, dtype=np.float64).reshape(-1, 3)
    valences = np.asarray(singular.valences)
    wrong = valences[~np.isin(valences, VALENCES)]
    if len(wrong):
        raise InputError(f"singularities: expected {_WORDS} lines in each, got {wrong[0]:g}")
    if len(places):
        surface = TriangleSurface(work.mesh.points, work.mesh.triangles[: work.inner])
        feet, _ = surface.closest(places)
        off = np.linalg.norm(places - feet, axis=1)
        far = int(np.argmax(off))
        if off[far] > _OFF * edge:
            raise InputError(
                f"singularities: {at(places[far])} is {off[far]:.3g} off the surface, more than "
                "an edge; put it onto it (is the unit right?)"
            )
    return places, valences.astype(np.int64)


def given_field(
    mesh: TriangleMesh,
    guide: GuidingField,
    calm: float,
    edge: float,
    automatic: DirectionField,
    quarters: IntArray,
) -> DirectionField:
    """The field with given singular vertices that is nearest to a smooth one with its own.

    Args:
        mesh: the surface, with its apron.
        guide: wanted directions.
        calm: how much of the guide counts.
        edge: wanted edge length.
        automatic: the smooth field near the guide.
        quarters: (V,) by how many quarter turns the field has to miss itself.

    Raises:
        InputError: triangles that are too coarse for such a field.
    """
    more = quarters - automatic.quarters
    if not more.any():
        return automatic
    # A border that is followed, or a stroke, holds where curvature has to give way.
    bound = guide.certainty > 1.0
    weight = _even(mesh, smoothness(mesh), quarters != 0)
    stiff = np.where(bound[mesh.edges // 3].all(axis=1), _STIFF * weight, weight)
    turned = _turned(mesh, stiff, more)
    shift = (calm * guide.certainty * mesh.areas * np.exp(4j * turned)).sum()
    plain = automatic.angles + turned - np.angle(shift) / 4
    changed = mesh.points[more != 0]
    near = np.minimum(1.0, cKDTree(changed).query(mesh.centres)[0] / (_ROUND * edge)) ** 4
    for part in _PARTS:
        heeded = np.where(bound, 1.0, part * near)
        angles = _towards(mesh, guide.calmed(calm), plain, heeded, bound, weight, edge)
        found = quarters_of(mesh, angles)
        if (found == quarters).all():
            return DirectionField(angles, found)
    where = mesh.points[np.flatnonzero(found != quarters)[0]]
    raise InputError(
        f"singularities: the triangles near {at(where)} are too coarse to turn so much there; "
        "move them, or give a finer surface"
    )


def _even(mesh: TriangleMesh, weight: FloatArray, singular: BoolArray) -> FloatArray:
    """(E,) weights that are alike round singular vertices, so that no edge there turns alone."""
    start, end = mesh.ends
    at = singular[start] | singular[end]
    return np.where(at, np.median(weight), weight)


def _turned(mesh: TriangleMesh, weight: FloatArray, more: IntArray) -> FloatArray:
    """(T,) angles by which triangles turn, so that ``more`` (V,) quarters are missed.

    A turn over an inner edge counts by its weight (E,).
    """
    start, end = mesh.ends
    ease = 1.0 / weight
    # Round an opening the field has to come back to one of its four directions as well.
    groups = components(len(mesh.points), *mesh.half_edges[mesh.rim].T)
    groups = np.where(mesh.on_rim, groups, -1)
    loops = np.unique(groups[mesh.on_rim])
    largest = max(loops.tolist(), key=lambda loop: int((groups == loop).sum()))
    potential = _potential(mesh, ease, more, np.full(len(mesh.points), -1), {})
    if len(loops) > 1:
        over = ease * (potential[end] - potential[start])
        missed = {
            int(loop): round(
                float(over[groups[end] == loop].sum() - over[groups[start] == loop].sum()) / QUARTER
            )
            for loop in loops.tolist()
            if loop != largest
        }
        potential = _potential(mesh, ease, more, groups, missed)
    over = ease * (potential[end] - potential[start])
    turned = np.zeros(len(mesh.triangles))
    for triangle, before, edge, forwards in spanning(mesh):
        turned[triangle] = turned[before] + (over[edge] if forwards else -over[edge])
    return turned


def _potential(
    mesh: TriangleMesh,
    ease: FloatArray,
    more: IntArray,
    groups: IntArray,
    missed: dict[int, int],
) -> FloatArray:
    """(V,) the potential that is zero at the border, or constant along openings with a flow.

    Args:
        mesh: the surface.
        ease: (E,) how easily directions turn over each inner edge.
        more: (V,) quarter turns to be missed round vertices.
        groups: (V,) which loop of the border a vertex is on.
        missed: quarter turns to be missed round loops; round others any.
    """
    count = len(mesh.points)
    unknown = np.cumsum(~mesh.on_rim) - 1
    total = int((~mesh.on_rim).sum())
    unknown[mesh.on_rim] = -1
    right = QUARTER * more[~mesh.on_rim].astype(float)
    for loop, quarters in missed.items():
        unknown[groups == loop] = total
        right = np.append(right, QUARTER * quarters)
        total += 1
    rows = np.flatnonzero(unknown >= 0)
    spread = coo_array((np.ones(len(rows)), (rows, unknown[rows])), shape=(count, total))
    start, end = mesh.ends
    edges = np.arange(len(start))
    over = coo_array(
        (
            np.concatenate([np.ones(len(start)), -np.ones(len(start))]),
            (np.concatenate([edges, edges]), np.concatenate([end, start])),
        ),
        shape=(len(start), count),
    )
    slopes = (over.tocsr() @ spread.tocsr()).tocsr()
    found: FloatArray = spread.tocsr() @ _solved((slopes.T @ diags_array(ease) @ slopes), right)
    return found


def _towards(
    mesh: TriangleMesh,
    guide: GuidingField,
    plain: FloatArray,
    part: FloatArray,
    bound: BoolArray,
    weight: FloatArray,
    edge: float,
) -> FloatArray:
    """Directions (T,) that turn from plain ones to a guide, a part (T,) of it, without a jump.

    Where they are not bound, the less the further they would have to turn.
    """
    apart = guide.angles - plain
    apart -= QUARTER * np.round(apart / QUARTER)
    agrees = np.maximum(0.0, np.cos(4 * apart)) ** _SILENCED
    held = part * np.where(bound, 1.0, agrees) * guide.certainty * mesh.areas / edge**2
    held = np.maximum(held, 1e-9 * float(mesh.areas.mean()) / edge**2)
    left = turns(mesh, plain)[1]
    first, second = (mesh.edges // 3).T
    count = len(mesh.triangles)
    matrix = coo_array(
        (
            np.concatenate([weight, weight, -weight, -weight]),
            (
                np.concatenate([first, second, first, second]),
                np.concatenate([first, second, second, first]),
            ),
        ),
        shape=(count, count),
    ) + diags_array(held)
    right = held * apart
    np.add.at(right, first, weight * left)
    np.subtract.at(right, second, weight * left)
    return plain + _solved(matrix, right)


def _solved(matrix: csc_array, right: FloatArray) -> FloatArray:
    factors = splu(
        matrix.tocsc(),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )
    found: FloatArray = factors.solve(right)
    return found
