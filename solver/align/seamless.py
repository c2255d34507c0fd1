"""A map of a surface to the plane whose whole lines are the lines of a net.

Coordinates u and v grow by one an edge along the directions of a field. Lines of equal u must
follow the field closely, where it is certain; how far apart they are may give way, since curvature
lines have a spacing of their own. Coordinates of singular vertices, and shifts round openings, are
rounded to whole numbers one after the other, the surest first, then exchanged while that helps.
Where triangles fold over, spacing counts more and direction less, until none does.

Source: Bommes, Zimmer, Kobbelt (2009), Mixed-integer quadrangulation.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csr_array, diags_array, eye_array, hstack, vstack

from solver.align.cut import Cut
from solver.align.features import Features
from solver.align.seams import SeamMap
from solver.align.triangle_mesh import TriangleMesh
from solver.align.whole_lines import WholeLines
from solver.linear.definite import DefiniteSolver
from solver.linear.squares import WeightedSquares
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, unit_rows

# What a line's direction counts where it is certain, beside its spacing; less where lines that
# follow it closely would run into each other.
FIRM = (1000.0, 30.0, 2.0)
# How often a map is made stiffer where it folds, by how much, and how wide round the fold.
_STIFFER, _BY, _RINGS = 12, 4.0, 4
# How many times as dense lines may be asked for, so that there are as many as are wanted.
_DENSER = 2.0
# A map with so many times as many faces as are wanted is asked for once more.
_TOO_DENSE = 1.15
# A triangle smaller than this part of its wanted size counts as folded.
_FOLDED = 1e-3
# Coordinates are rounded to this, so that turns and whole shifts of them are exact.
GRID = 1 << 20
# How much more than all else a coordinate of a whole line counts.
_HEAVY = 1e3
# How far apart u and v are kept, in sizes of the surface, to be numbered for a factorisation.
_APART = 3.0
# How firmly a vertex stays where whole lines may say otherwise.
_LOOSE = 1e-3
# Exchanges of whole numbers, at most.
_EXCHANGES = 100


@dataclass(frozen=True, eq=False)
class Map:
    """Coordinates of a surface's corners, in edges of the net.

    Attributes:
        corners: (T, 3, 2) coordinates in units of 1 / ``GRID``.
        folded: triangles that lie the wrong way round, or have no size.
    """

    corners: IntArray
    folded: IntArray


def seamless_map(
    mesh: TriangleMesh,
    cut: Cut,
    layout: SeamMap,
    certainty: FloatArray,
    edges: tuple[float, float],
    covered: int,
    firm: float = FIRM[0],
    features: Features | None = None,
    skew: FloatArray | None = None,
    step: Callable[[], object] = lambda: None,
) -> Map:
    """Solve for the map.

    Args:
        mesh: the surface, with its apron.
        cut: its directions.
        layout: its unknowns.
        certainty: (T,) how certain the directions are, 0 to 1.
        edges: wanted edge lengths along u and along v.
        covered: how many of the triangles are to be covered; only these must not fold.
        firm: what direction counts where it is certain, beside spacing.
        features: lines that have to lie on whole lines.
        skew: (T, 2, 2) from right-angled crosses to the lines' directions, by default none.
        step: called before each solution; what it raises is passed on.
    """
    whole = WholeLines.none() if features is None else WholeLines.along(mesh, cut, layout, features)
    system = _Equations(mesh, cut, layout, whole, edges, skew)
    wanted = 2 * mesh.areas / (edges[0] * edges[1])
    if skew is not None:
        wanted = wanted / np.linalg.det(skew)
    neighbours = _neighbours(mesh)
    spacing, direction = np.ones(len(mesh.areas)), 1 + firm * certainty
    step()
    # Lines that draw together and apart come out too far apart in all: ask for shorter edges.
    plain = _on_grid(layout, system.solved(spacing, direction, None, whole=False), None)
    mapped = _doubled_areas(plain)[:covered].sum() / GRID**2
    scale = float(np.clip(np.sqrt(wanted[:covered].sum() / max(mapped, 1e-300)), 1.0, _DENSER))
    system.shorter(scale)
    wholes: FloatArray | None = None
    for _ in range(_STIFFER):
        step()
        unknowns = system.solved(spacing, direction, wholes)
        wholes = unknowns[2 * layout.reals :]
        corners = _on_grid(layout, unknowns, whole)
        signed = _doubled_areas(corners) / GRID**2
        bad = signed < _FOLDED * wanted
        if not bad[:covered].any():
            break
        near = _widened(neighbours, bad)
        spacing = np.where(near, _BY * spacing, spacing)
        direction = np.where(near, 1 + (direction - 1) / _BY**1.5, direction)
    dense = signed[:covered].sum() / wanted[:covered].sum()
    found = Map(corners, np.flatnonzero(bad[:covered]))
    if dense > _TOO_DENSE:
        # Stiffer as it is now, it has more lines than were wanted.
        system.shorter(dense**-0.5)
        step()
        corners = _on_grid(layout, system.solved(spacing, direction, None), whole)
        bad = _doubled_areas(corners) / GRID**2 < _FOLDED * wanted
        fewer = Map(corners, np.flatnonzero(bad[:covered]))
        found = fewer if len(fewer.folded) <= len(found.folded) else found
    return found


def _doubled_areas(corners: IntArray) -> FloatArray:
    one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return (one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]).astype(float)


def _on_grid(layout: SeamMap, unknowns: FloatArray, whole: WholeLines | None) -> IntArray:
    rounded = np.round(unknowns[: layout.matrix.shape[1]] * GRID)
    if whole is not None:
        whole.snapped(layout.matrix, layout.reals, rounded, GRID)
    found: IntArray = np.round(layout.matrix @ rounded).astype(np.int64)
    return found.reshape(-1, 2)[layout.copies]


def _neighbours(mesh: TriangleMesh) -> csr_array:
    one, two = (mesh.edges // 3).T
    count = len(mesh.triangles)
    graph = coo_array((np.ones(len(one)), (one, two)), shape=(count, count)).tocsr()
    return csr_array(graph + graph.T + eye_array(count))


def _widened(neighbours: csr_array, some: BoolArray) -> BoolArray:
    for _ in range(_RINGS):
        some = (neighbours @ some.astype(float)) > 0
    return some


class _Equations:
    """What the map is asked for: four rows a triangle, spacing and direction of u and of v.

    Args:
        mesh: the surface, with its apron.
        cut: its directions.
        layout: the unknowns.
        whole: what lies on whole lines; their values are the last unknowns.
        edges: wanted edge lengths along u and along v.
        skew: (T, 2, 2) from right-angled crosses to the lines' directions, None for none.
    """

    def __init__(
        self,
        mesh: TriangleMesh,
        cut: Cut,
        layout: SeamMap,
        whole: WholeLines,
        edges: tuple[float, float],
        skew: FloatArray | None,
    ) -> None:
        count = len(mesh.triangles)
        slopes = _slopes(mesh, cut, layout, skew)
        asked = csr_array(hstack([slopes, csr_array((4 * count, whole.count))]))
        runs = np.arange(len(whole.runs))
        values = coo_array(
            (np.full(len(runs), -1.0), (runs, whole.runs)), shape=(len(runs), whole.count)
        )
        held = csr_array(hstack([whole.held(layout.matrix), values]))
        self._areas, self._layout, self._held = mesh.areas, layout, held.shape[0]
        matrix = csr_array(vstack([asked, held]))
        reals = 2 * layout.reals
        self._free, self._last = matrix[:, :reals], matrix[:, reals:]
        self._right = np.repeat([1 / edges[0], 1 / edges[1], 0.0, 0.0], count)
        self._right = np.concatenate([self._right, np.zeros(self._held)])
        self._squares = WeightedSquares(self._free)
        # u and v meet at the cut only: apart in space they are told apart first.
        lift = np.tile([0.0, _APART], layout.reals)[:, None] * np.ptp(mesh.points, axis=0).max()
        places = np.repeat(mesh.points[layout.vertices], 2, axis=0) + lift * [0.0, 0.0, 1.0]
        self._solver = DefiniteSolver(self._squares.of(np.ones(len(self._right))), places)

    def shorter(self, factor: float) -> None:
        """Ask for edges that are shorter by a factor."""
        self._right = factor * self._right

    def solved(
        self,
        spacing: FloatArray,
        direction: FloatArray,
        wholes: FloatArray | None,
        whole: bool = True,
    ) -> FloatArray:
        """The unknowns with least energy; whole ones, if not given, rounded on demand."""
        solve, weight = self._factored(spacing, direction)
        weighted = diags_array(weight)
        right = self._free.T @ (weight * self._right)
        if not self._last.shape[1]:
            return solve(right)
        mixed = (self._free.T @ weighted @ self._last).toarray()
        if wholes is not None:
            return np.concatenate([solve(right - mixed @ wholes), wholes])
        alone, along = solve(right), solve(mixed)
        squares = (self._last.T @ weighted @ self._last).toarray() - mixed.T @ along
        pull = self._last.T @ (weight * self._right) - mixed.T @ alone
        if whole:
            wholes = rounded(squares, pull, self._layout.places)
        else:
            wholes = np.linalg.lstsq(squares, pull, rcond=1e-12)[0]
        return np.concatenate([alone - along @ wholes, wholes])

    def _factored(
        self, spacing: FloatArray, direction: FloatArray
    ) -> tuple[Callable[[FloatArray], FloatArray], FloatArray]:
        """What solves for the unknowns that need not be whole, and the weight of each row."""
        weight = np.concatenate([spacing, spacing, spacing * direction, spacing * direction])
        weight *= np.tile(self._areas, 4)
        if self._held:
            size = self._squares.of(np.append(weight, np.zeros(self._held))).diagonal().mean()
            weight = np.append(weight, np.full(self._held, _HEAVY**2 * size))
        normal = self._squares.of(weight)
        if not self._layout.places:
            # Nothing says where the map lies, or whole lines do in one direction only: the first
            # vertex stays, loosely where these say otherwise.
            shift = np.zeros(normal.shape[0])
            shift[:2] = normal.diagonal().mean() * (_LOOSE if self._held else 1.0)
            normal.setdiag(normal.diagonal() + shift)
        return self._solver.factor(normal), weight


def _slopes(mesh: TriangleMesh, cut: Cut, layout: SeamMap, skew: FloatArray | None) -> csr_array:
    """(4 T, unknowns) slope of u along it and of v across it; of u across it and of v along it."""
    gradients, count = mesh.gradients(), len(mesh.triangles)
    along = np.stack([np.cos(cut.angles), np.sin(cut.angles)], axis=1)
    across = np.stack([-along[:, 1], along[:, 0]], axis=1)
    if skew is not None:
        along, across = (unit_rows(np.einsum("tij,tj->ti", skew, way)) for way in (along, across))
    rows, columns, values = [], [], []
    for number, (way, part) in enumerate(((along, 0), (across, 1), (across, 0), (along, 1))):
        slopes = np.einsum("tkx,tx->tk", gradients, way)
        for k in range(3):
            rows.append(number * count + np.arange(count))
            columns.append(2 * layout.copies[:, k] + part)
            values.append(slopes[:, k])
    matrix = coo_array(
        (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
        shape=(4 * count, layout.matrix.shape[0]),
    )
    return csr_array(matrix.tocsr() @ layout.matrix)


def rounded(squares: FloatArray, pull: FloatArray, places: list[int]) -> FloatArray:
    """Whole numbers z with small ``z squares z - 2 pull z``.

    Args:
        squares: (N, N) symmetric, not negative.
        pull: (N,).
        places: pairs of unknowns that may all be shifted alike; the first comes to zero.
    """
    count = len(pull)
    found, fixed = np.zeros(count), np.zeros(count, dtype=bool)
    if places:
        fixed[2 * places[0] : 2 * places[0] + 2] = True
    free = np.flatnonzero(~fixed)
    while not fixed.all():
        left = np.flatnonzero(~fixed)
        right = pull[left] - squares[np.ix_(left, fixed)] @ found[fixed]
        best = np.linalg.lstsq(squares[np.ix_(left, left)], right, rcond=1e-12)[0]
        surest = int(np.argmin(np.abs(best - np.round(best))))
        found[left[surest]] = np.round(best[surest])
        fixed[left[surest]] = True
    return _exchanged(squares, pull, found, free)


def _exchanged(
    squares: FloatArray, pull: FloatArray, found: FloatArray, free: IntArray
) -> FloatArray:
    """Change one number by one, or two, while the energy falls."""
    one, two = np.triu_indices(len(free))
    one, two = free[one], free[two]
    least = -1e-9 * max(float(abs(found @ squares @ found - 2 * pull @ found)), 1e-300)
    for _ in range(_EXCHANGES):
        slope = 2 * (squares @ found - pull)
        best, move = least, None
        for s in (1.0, -1.0):
            for t in (1.0, -1.0):
                gain = s * slope[one] + squares[one, one]
                more = t * slope[two] + squares[two, two] + 2 * s * t * squares[one, two]
                gain = gain + np.where(one == two, 0.0, more)
                k = int(np.argmin(gain)) if len(gain) else 0
                if len(gain) and gain[k] < best:
                    best, move = gain[k], (one[k], two[k], s, t)
        if move is None:
            break
        a, b, s, t = move
        found[a] += s
        if a != b:
            found[b] += t
    return found
