"""Quads read from a map: every unit cell of the plane that the surface meets becomes a face.

A triangle's image is cut by the whole lines into *pieces*, one a cell. Pieces of one cell that
touch along an edge are one quad; pieces on both sides of a whole line are neighbours, whose common
corners are one vertex. All is decided by whole-number arithmetic, so nothing is lost between
triangles, and small folds do no harm. A quad of which a part only is on the surface is a whole quad
all the same.

Compare Ebke, Bommes, Campen, Kobbelt (2013), QEx: robust quad mesh extraction, which follows lines.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.align.cut import Cut
from solver.align.seamless import GRID, Map
from solver.align.seams import TURNS
from solver.align.triangle_mesh import TriangleMesh, components
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# Corners of a cell, counter-clockwise.
CORNERS = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
# How often faces that lie on each other over a slit are joined.
_JOINED = 10
# A corner this far outside a triangle, in parts of its height, is in it.
_TOUCHING = 1e-9


@dataclass(frozen=True, eq=False)
class Quads:
    """Faces of a net, and where their corners are.

    Attributes:
        faces: (F, 4) vertex numbers.
        places: (V, 3); of vertices beyond the triangles not to be relied on.
        beyond: (V,) no triangle has the vertex.
        triangles: (V,) the triangle that has each vertex, or one that is near.
        coordinates: (V, 2) of the vertex in that triangle's map.
        joined: how many pairs of faces lay on each other, over a slit or an opening.
    """

    faces: IntArray
    places: FloatArray
    beyond: BoolArray
    triangles: IntArray
    coordinates: IntArray
    joined: int


@dataclass(frozen=True, eq=False)
class CellPieces:
    """Which triangle meets which cell.

    Attributes:
        corners: (T, 3, 2) the map, in units of 1 / GRID.
        triangles: (P,) and ``cells`` (P, 2): a piece's triangle and its cell's lower corner.
    """

    corners: IntArray
    triangles: IntArray
    cells: IntArray

    @classmethod
    def of(cls, corners: IntArray) -> CellPieces:
        """Cut the images of triangles by the whole lines."""
        low, high = corners.min(axis=1), corners.max(axis=1)
        triangle, cell = _cells_between(low // GRID, -(-high // GRID))
        live = _doubled(corners)[triangle] != 0
        triangle, cell = triangle[live], cell[live]
        sides = _sides(corners, triangle, (cell[:, None] + CORNERS) * GRID)
        met = (sides.max(axis=1) > 0).all(axis=1)
        return cls(corners, triangle[met], cell[met])

    def some(self, kept: BoolArray) -> CellPieces:
        """Only the pieces of a mask."""
        return CellPieces(self.corners, self.triangles[kept], self.cells[kept])

    @cached_property
    def _sorted(self) -> tuple[IntArray, IntArray]:
        keys = self._keys(self.triangles, self.cells)
        order = np.argsort(keys)
        return keys[order], order

    def _keys(self, triangles: IntArray, cells: IntArray) -> IntArray:
        low = self.cells.min(axis=0) - 1
        span = self.cells.max(axis=0) - low + 2
        place = np.clip(cells - low, 0, span - 1)
        keys: IntArray = (triangles * span[0] + place[:, 0]) * span[1] + place[:, 1]
        return keys

    def find(self, triangles: IntArray, cells: IntArray) -> IntArray:
        """Numbers of pieces, -1 where there is none."""
        keys, order = self._sorted
        wanted = self._keys(triangles, cells)
        at = np.minimum(np.searchsorted(keys, wanted), len(keys) - 1)
        return np.where(keys[at] == wanted, order[at], -1)


class _Joins:
    """Corners of pieces that are one vertex: corner c of piece p is ``4 p + c``."""

    def __init__(self, count: int) -> None:
        self._count = 4 * count
        self._one: list[IntArray] = []
        self._two: list[IntArray] = []

    def add(self, one: IntArray, two: IntArray) -> None:
        self._one.append(one)
        self._two.append(two)

    def cells(self, one: IntArray, two: IntArray, turned: IntArray | int) -> None:
        """Corner c of cells ``one`` is corner c + ``turned`` of cells ``two``."""
        for corner in range(4):
            self.add(4 * one + corner, 4 * two + (corner + turned) % 4)

    def vertices(self) -> IntArray:
        """(P, 4) vertex of each corner."""
        found = components(self._count, np.concatenate(self._one), np.concatenate(self._two))
        return found.reshape(-1, 4)


def quads(mesh: TriangleMesh, cut: Cut, made: Map, covered: int) -> Quads:
    """Read the quads of a map that the surface meets, or what else is to be covered.

    Args:
        mesh: the surface, with its apron.
        cut: how the map is turned over its cut.
        made: the map.
        covered: how many of the triangles are to be covered.
    """
    pieces = CellPieces.of(made.corners)
    label = _over_edges(mesh, cut, pieces, _Joins(len(pieces.triangles)))
    own = np.zeros(label.max() + 1, dtype=bool)
    own[label[pieces.triangles < covered]] = True
    # The rest of the apron says nothing of the net, and may be folded.
    pieces = pieces.some(own[label])
    joins = _Joins(len(pieces.triangles))
    label = _over_edges(mesh, cut, pieces, joins)
    _over_lines(pieces, joins)
    rim = np.isin(pieces.triangles, mesh.rim // 3)
    label, joined = _over_slits(label, rim, joins)
    vertices = joins.vertices()
    first = np.unique(label, return_index=True)[1]
    own = np.zeros(len(first), dtype=bool)
    own[label[pieces.triangles < covered]] = True
    return _placed(mesh, pieces, vertices, vertices[first][own], joined)


def _doubled(corners: IntArray) -> IntArray:
    one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area: IntArray = one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]
    return area


def _cells_between(low: IntArray, high: IntArray) -> tuple[IntArray, IntArray]:
    """All cells from low to below high: (N,) row of the range, (N, 2) cell."""
    wide = np.maximum(high - low, 0)
    counts = wide.prod(axis=1)
    row = np.repeat(np.arange(len(low)), counts)
    number = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    tall = np.maximum(wide[row, 1], 1)
    return row, low[row] + np.stack([number // tall, number % tall], axis=1)


def _sides(corners: IntArray, triangles: IntArray, points: IntArray) -> IntArray:
    """(N, M, 3) doubled areas of points (N, M, 2) with each side, positive within."""
    sign = np.sign(_doubled(corners))[triangles][:, None]
    found = []
    for k in range(3):
        start, end = corners[triangles, k][:, None], corners[triangles, (k + 1) % 3][:, None]
        run, to = end - start, points - start
        found.append((run[..., 0] * to[..., 1] - run[..., 1] * to[..., 0]) * sign)
    return np.stack(found, axis=2)


def turned(turns: IntArray, vectors: IntArray) -> IntArray:
    """(N, 2) vectors by (N,) quarter turns."""
    found: IntArray = np.einsum("nij,nj->ni", TURNS[turns], vectors)
    return found


def transitions(mesh: TriangleMesh, cut: Cut, corners: IntArray) -> IntArray:
    """(E, 2) shift over each inner edge, in units of 1 / GRID: second = turned first + shift."""
    one, two = mesh.edges.T
    start = corners[one // 3, one % 3]
    same = corners[two // 3, (two + 1) % 3]
    shift: IntArray = same - turned(cut.turns, start)
    return shift


def _over_edges(mesh: TriangleMesh, cut: Cut, pieces: CellPieces, joins: _Joins) -> IntArray:
    """Join pieces of one cell at both sides of an edge; return the (P,) quad of each piece."""
    corners = pieces.corners
    one, two = mesh.edges.T
    first, second = one // 3, two // 3
    start, end = corners[first, one % 3], corners[first, (one + 1) % 3]
    shift = transitions(mesh, cut, corners) // GRID
    edge, cell = _cells_between(np.minimum(start, end) // GRID, -(-np.maximum(start, end) // GRID))
    run = (end - start)[edge][:, None]
    to = (cell[:, None] + CORNERS) * GRID - start[edge][:, None]
    side = run[..., 0] * to[..., 1] - run[..., 1] * to[..., 0]
    crosses = (side.max(axis=1) > 0) & (side.min(axis=1) < 0)
    edge, cell = edge[crosses], cell[crosses]
    here = pieces.find(first[edge], cell)
    there = pieces.find(second[edge], _across(cell, cut.turns[edge], shift[edge]))
    both = (here >= 0) & (there >= 0)
    here, there, edge = here[both], there[both], edge[both]
    joins.cells(here, there, cut.turns[edge])
    _along_lines(pieces, joins, (first, second), (start, end), cut.turns, shift)
    return components(len(pieces.triangles), here, there)


def _across(cells: IntArray, turns: IntArray, shift: IntArray) -> IntArray:
    """Cells of the first triangle in the second's coordinates."""
    return (turned(turns, 2 * cells + 1) + 2 * shift - 1) // 2


def _along_lines(
    pieces: CellPieces,
    joins: _Joins,
    triangles: tuple[IntArray, IntArray],
    ends: tuple[IntArray, IntArray],
    turns: IntArray,
    shift: IntArray,
) -> None:
    """Join neighbours at edges that lie on a whole line, which cross no cell."""
    start, end = ends
    for axis in (0, 1):
        on = (start[:, axis] == end[:, axis]) & (start[:, axis] % GRID == 0)
        on &= start[:, 1 - axis] != end[:, 1 - axis]
        rows = np.flatnonzero(on)
        if not len(rows):
            continue
        low = np.minimum(start, end)[rows] // GRID
        high = -(-np.maximum(start, end)[rows] // GRID)
        high[:, axis] = low[:, axis] + 1
        row, cell = _cells_between(low, high)
        edge = rows[row]
        back = cell.copy()
        back[:, axis] -= 1
        # Corners of the cell at its line, and of the one before it.
        at_line, before = (((0, 3), (1, 2)), ((0, 1), (3, 2)))[axis]
        for near, far, here, there in (
            (cell, back, at_line, before),
            (back, cell, before, at_line),
        ):
            one = pieces.find(triangles[0][edge], near)
            two = pieces.find(triangles[1][edge], _across(far, turns[edge], shift[edge]))
            both = (one >= 0) & (two >= 0)
            for p, q in zip(here, there, strict=True):
                joins.add(4 * one[both] + p, 4 * two[both] + (q + turns[edge][both]) % 4)


def _over_lines(pieces: CellPieces, joins: _Joins) -> None:
    """Join pieces of neighbouring cells within a triangle."""
    low, high = pieces.corners.min(axis=1), pieces.corners.max(axis=1)
    for axis, here, there in ((0, (1, 2), (0, 3)), (1, (3, 2), (0, 1))):
        step = np.eye(2, dtype=np.int64)[axis]
        found = pieces.find(pieces.triangles, pieces.cells + step)
        one = np.flatnonzero(found >= 0)
        triangle = pieces.triangles[one]
        ends = (pieces.cells[one, None] + CORNERS[list(here)]) * GRID
        meets = (_sides(pieces.corners, triangle, ends).max(axis=1) > 0).all(axis=1)
        line = ends[:, 0, axis]
        meets &= (low[triangle, axis] < line) & (line < high[triangle, axis])
        other = ends[:, :, 1 - axis]
        meets &= low[triangle, 1 - axis] < other[:, 1]
        meets &= other[:, 0] < high[triangle, 1 - axis]
        one, two = one[meets], found[one[meets]]
        for p, q in zip(here, there, strict=True):
            joins.add(4 * one + p, 4 * two + q)


def _over_slits(label: IntArray, rim: BoolArray, joins: _Joins) -> tuple[IntArray, int]:
    """Join quads at the border that share a side: one cell, seen from both sides of an opening."""
    total = 0
    for _ in range(_JOINED):
        vertices = joins.vertices()
        first = np.unique(label, return_index=True)[1]
        faces = vertices[first]
        open_ = np.zeros(len(faces), dtype=bool)
        open_[label[rim]] = True
        sides = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
        order = np.lexsort(sides.T)
        same = (sides[order[1:]] == sides[order[:-1]]).all(axis=1)
        same &= open_[order[1:] // 4] & open_[order[:-1] // 4]
        one, two = order[:-1][same], order[1:][same]
        apart = one // 4 != two // 4
        one, two = one[apart], two[apart]
        if not len(one):
            break
        total += len(one)
        for k in range(4):
            joins.add(4 * first[one // 4] + (one + k) % 4, 4 * first[two // 4] + (two + k) % 4)
        label = components(len(faces), one // 4, two // 4)[label]
    return label, total


def _placed(
    mesh: TriangleMesh, pieces: CellPieces, vertices: IntArray, faces: IntArray, joined: int
) -> Quads:
    """Where the vertices of faces are, from the triangle that has them most surely."""
    area = _doubled(pieces.corners)
    at = (pieces.cells[:, None] + CORNERS) * GRID
    sides = _sides(pieces.corners, pieces.triangles, at).astype(float)
    shares = sides / np.abs(area[pieces.triangles])[:, None, None]
    inside = shares.min(axis=2)
    # One that lies the wrong way round has a vertex only where no other has it.
    wrong = (area[pieces.triangles] < 0)[:, None] & (inside >= -_TOUCHING)
    inside = np.where(wrong, -0.5 * _TOUCHING, inside)
    order = np.lexsort((-inside.ravel(), vertices.ravel()))
    best = order[np.unique(vertices.ravel()[order], return_index=True)[1]]
    used, numbers = np.unique(faces, return_inverse=True)
    best = best[used]
    triangles = pieces.triangles[best // 4]
    weights = shares.reshape(-1, 3)[best][:, [1, 2, 0]]
    places = np.einsum("vk,vkx->vx", weights, mesh.points[mesh.triangles[triangles]])
    return Quads(
        numbers.reshape(-1, 4),
        places,
        inside.ravel()[best] < -_TOUCHING,
        triangles,
        at.reshape(-1, 2)[best],
        joined,
    )


def crossing(found: Quads) -> FloatArray | None:
    """A place where faces overlap, if there is one."""
    sides = np.stack([found.faces, np.roll(found.faces, -1, axis=1)], axis=2).reshape(-1, 2)
    pairs, counts = np.unique(sides, axis=0, return_counts=True)
    wrong = np.concatenate(
        [
            pairs[counts > 1][:, 0],
            found.faces[found.faces[:, 0] == found.faces[:, 2]][:, 0],
            found.faces[found.faces[:, 1] == found.faces[:, 3]][:, 1],
            pairs[pairs[:, 0] == pairs[:, 1]][:, 0],
        ]
    )
    return found.places[wrong[0]] if len(wrong) else None
