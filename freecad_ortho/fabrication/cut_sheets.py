"""Bent sheets that a border cuts: cut in their flat pattern, folded with it.

A sheet is a grid of faces that are known flat and in place. What is left of each is a cell: its
corners on sides that two faces share are those of both, so the pieces are closed without any
boolean operation. Cuts are square to plane faces; across a face that is not plane they follow the
surface, as the sides of the sheet do.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from freecad_ortho.fabrication.bezier import blend, through
from freecad_ortho.fabrication.plate_bodies import triangles_in
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.ruled_sides import Sheet, Side
from freecad_ortho.fabrication.trimming.rays import Rays, bilinear
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import shapely

# The border is made of straight pieces that leave it by this much at most, mm.
_TRUE = 0.05
# Points of the pattern that are nearer to each other or to a side, mm, are one, or on it.
_ONE = 1e-5
# Distance from a plane, mm, below which the CAD kernel takes a side for plane.
_PLANE = 1e-8
# Cells with less area, mm2, are none.
_NOTHING = 1e-2
# Control points of a cubic curve in the parameters of a face, and of its image in space.
_CUBIC, _IMAGE = 4, 7
_THIRDS = np.array([[1.0], [-1.0]]) / 3


@dataclass(frozen=True, eq=False)
class BentSheet:
    """A sheet of faces in its flat pattern and in its place.

    Attributes:
        flat: (V, 2) vertices in the pattern, in which no two faces overlap.
        layers: (2, V, 3) the same on the lower and the upper side, mm.
        faces: (F, 4) counter-clockwise, seen from the upper side and in the pattern.
    """

    flat: FloatArray
    layers: FloatArray
    faces: IntArray

    @cached_property
    def rays(self) -> Rays:
        """The pattern as coordinates: u and v in each face."""
        corners = np.pad(self.flat[self.faces], ((0, 0), (0, 0), (0, 1)))
        return Rays(corners, np.broadcast_to([0.0, 0.0, 1.0], corners.shape))

    @cached_property
    def plane(self) -> IntArray:
        """(F,) 1 for faces that are plane on both sides, 0 for others."""
        corners = self.layers[:, self.faces]
        normals = np.cross(
            corners[..., 2, :] - corners[..., 0, :], corners[..., 3, :] - corners[..., 1, :]
        )
        normals = normals / np.linalg.norm(normals, axis=-1, keepdims=True)
        arms = corners - corners.mean(axis=2, keepdims=True)
        off = np.abs(np.einsum("lfck,lfk->lfc", arms, normals)).max(axis=(0, 2))
        return np.asarray(off <= _PLANE, dtype=np.int64)

    def polygon(self, face: int) -> shapely.Polygon:
        """A face in the pattern."""
        import shapely

        return shapely.Polygon(self.flat[self.faces[face]])


@dataclass(frozen=True, eq=False)
class CutPiece:
    """A connected piece of a sheet.

    Attributes:
        outline: what it is cut from in the pattern, with its openings.
        body: in the coordinates of the sheet.
        faces: of the sheet that it has a part of, in their order.
        middle: (2,) the middle of the largest circle in it.
        width: diameter of that circle, mm.
    """

    outline: shapely.Polygon
    body: RuledBody
    faces: tuple[int, ...]
    middle: FloatArray
    width: float


def cut_pieces(
    sheet: BentSheet, regions: Mapping[int, Sequence[shapely.Polygon]]
) -> list[CutPiece]:
    """Cut a sheet.

    Args:
        sheet: flat and in place.
        regions: by face what is left of it, polygons in the pattern that may reach beyond it; the
            face itself where it is whole. Faces that are not named are left out.

    Returns:
        The pieces, the widest first.
    """
    cells = _Cells(sheet, regions)
    pieces = [_piece(sheet, cells, some) for some in cells.pieces()]
    return sorted(pieces, key=lambda piece: -piece.width)


# Numbers of points around a cell, counter-clockwise, and around its openings, clockwise.
_Loops = list[list[int]]


@dataclass(frozen=True, eq=False)
class _Cell:
    """A part of a face."""

    face: int
    loops: _Loops

    @property
    def steps(self) -> list[tuple[int, int]]:
        """From each corner to the next."""
        return [step for loop in self.loops for step in pairwise([*loop, loop[0]])]


class _Cells:
    """All cells of a sheet, with common points.

    ``points`` (N, 2) lie in the pattern; ``sides`` has for those on sides of faces the vertices at
    its ends and the place between, 0 to 1.
    """

    def __init__(self, sheet: BentSheet, regions: Mapping[int, Sequence[shapely.Polygon]]) -> None:
        from shapely.geometry.polygon import orient

        self._sheet = sheet
        rings: list[FloatArray] = []
        owners: list[list[int]] = []
        faces = []
        for face, some in regions.items():
            for part in _parts(sheet, face, some):
                polygon = orient(part)
                around = [polygon.exterior, *polygon.interiors]
                owners.append(list(range(len(rings), len(rings) + len(around))))
                rings += [np.array(ring.coords)[:-1] for ring in around]
                faces.append(face)
        numbers = self._joined(np.concatenate([sheet.flat, *rings]))
        bounds = np.cumsum([len(sheet.flat), *map(len, rings)])
        loops = [numbers[start:end].tolist() for start, end in pairwise(bounds.tolist())]
        self.cells = [
            _Cell(face, [_without_repeats(loops[ring]) for ring in own])
            for face, own in zip(faces, owners, strict=True)
        ]
        self.sides: dict[int, list[tuple[int, int, float]]] = {}
        self._find_sides()
        self._divide()

    def _joined(self, points: FloatArray) -> IntArray:
        """Numbers of points of which those near each other are one; first come the vertices."""
        pairs = cKDTree(points).query_pairs(_ONE, output_type="ndarray")
        graph = coo_array((np.ones(len(pairs)), pairs.T), shape=(len(points), len(points)))
        _, group = connected_components(graph, directed=False)
        _, first, numbers = np.unique(group, return_index=True, return_inverse=True)
        rank = np.argsort(np.argsort(first))
        self.points = points[np.sort(first)]
        return np.asarray(rank[numbers])

    def _find_sides(self) -> None:
        """Note which points lie on sides of their faces."""
        faces = self._sheet.faces
        flat = self._sheet.flat
        on: dict[int, set[tuple[int, int]]] = {}
        for cell in self.cells:
            numbers = np.unique(np.concatenate(cell.loops))
            for start, end in _around(faces[cell.face].tolist()):
                low, high = min(start, end), max(start, end)
                step = flat[high] - flat[low]
                arms = self.points[numbers] - flat[low]
                off = np.abs(step[0] * arms[:, 1] - step[1] * arms[:, 0]) / np.linalg.norm(step)
                for number in numbers[off <= _ONE].tolist():
                    on.setdefault(number, set()).add((low, high))
        for number, some in on.items():
            for low, high in sorted(some):
                step = flat[high] - flat[low]
                place = float((self.points[number] - flat[low]) @ step / (step @ step))
                self.sides.setdefault(number, []).append((low, high, place))

    def _divide(self) -> None:
        """Give both cells at a side the points that either of them has there."""
        along: dict[tuple[int, int], list[tuple[float, int]]] = {}
        for number, some in self.sides.items():
            for low, high, place in some:
                along.setdefault((low, high), []).append((place, number))
        for cell in self.cells:
            for row, loop in enumerate(cell.loops):
                longer = []
                for start, end in _around(loop):
                    longer += [start, *self._between(start, end, along)]
                cell.loops[row] = longer

    def _between(
        self, start: int, end: int, along: Mapping[tuple[int, int], list[tuple[float, int]]]
    ) -> list[int]:
        side = self.side_of(start, end)
        if side is None:
            return []
        here, there = (self._place(number, side) for number in (start, end))
        low, high = min(here, there), max(here, there)
        found = sorted(place for place in along[side] if low < place[0] < high)
        numbers = [number for _, number in found if number not in (start, end)]
        return numbers if here < there else numbers[::-1]

    def _place(self, number: int, side: tuple[int, int]) -> float:
        return next(place for low, high, place in self.sides[number] if (low, high) == side)

    def side_of(self, start: int, end: int) -> tuple[int, int] | None:
        """The side of a face that two points lie on, by its vertices."""
        sides = ({(low, high) for low, high, _ in self.sides.get(k, ())} for k in (start, end))
        common = set.intersection(*sides)
        return min(common) if common else None

    def pieces(self) -> list[list[_Cell]]:
        """Cells that hang together by their sides."""
        owner: dict[tuple[int, int], int] = {}
        pairs = []
        for number, cell in enumerate(self.cells):
            for start, end in cell.steps:
                if (end, start) in owner:
                    pairs.append((owner[end, start], number))
                owner[start, end] = number
        count = len(self.cells)
        rows = np.array(pairs, dtype=np.int64).reshape(-1, 2).T
        graph = coo_array((np.ones(rows.shape[1]), tuple(rows)), shape=(count, count))
        found, group = connected_components(graph, directed=False)
        return [
            [self.cells[k] for k in np.flatnonzero(group == number).tolist()]
            for number in range(found)
        ]


def _parts(
    sheet: BentSheet, face: int, regions: Iterable[shapely.Polygon]
) -> list[shapely.Polygon]:
    """What is left of a face, its border of straight pieces."""
    import shapely

    around = sheet.polygon(face)
    shapely.prepare(around)
    found = []
    for region in regions:
        if region.covers(around):
            return [around]
        for part in shapely.get_parts(around.intersection(region)):
            if part.geom_type == "Polygon" and part.area > _NOTHING:
                rings = [_straightened(ring, around) for ring in (part.exterior, *part.interiors)]
                found.append(shapely.Polygon(rings[0], rings[1:]))
    return found


def _straightened(ring: shapely.LinearRing, around: shapely.Polygon) -> FloatArray:
    """A ring without points that say little, those on the sides of the face left alone."""
    import shapely

    points = np.array(ring.coords)[:-1]
    fixed = np.flatnonzero(shapely.distance(shapely.points(points), around.exterior) <= _ONE)
    if len(fixed) < 2:
        return np.array(ring.simplify(_TRUE).coords)[:-1]
    points = np.roll(points, -int(fixed[0]), axis=0)
    ends = [*(fixed - fixed[0]).tolist(), len(points)]
    points = np.concatenate([points, points[:1]])
    chains = [
        np.array(shapely.LineString(points[start : end + 1]).simplify(_TRUE).coords)[:-1]
        for start, end in pairwise(ends)
    ]
    return np.concatenate(chains)


def _around(loop: Sequence[int]) -> list[tuple[int, int]]:
    return list(pairwise([*loop, loop[0]]))


def _without_repeats(loop: list[int]) -> list[int]:
    return [
        number for number, before in zip(loop, [loop[-1], *loop], strict=False) if number != before
    ]


def _piece(sheet: BentSheet, cells: _Cells, some: list[_Cell]) -> CutPiece:
    import shapely
    from shapely.ops import polylabel

    polygons = [
        shapely.Polygon(cells.points[cell.loops[0]], [cells.points[k] for k in cell.loops[1:]])
        for cell in some
    ]
    outline = shapely.unary_union(polygons)
    if outline.geom_type != "Polygon":
        outline = max(shapely.get_parts(outline), key=lambda part: part.area)
    point = polylabel(outline, 1.0)
    return CutPiece(
        outline,
        _Folder(sheet, cells, some).body(),
        tuple(sorted({cell.face for cell in some})),
        np.array(point.coords[0]),
        2 * float(point.distance(outline.boundary)),
    )


class _Folder:
    """Makes the body of a piece from its cells."""

    def __init__(self, sheet: BentSheet, cells: _Cells, some: list[_Cell]) -> None:
        self._sheet, self._cells, self._some = sheet, cells, some
        used = np.unique(np.concatenate([loop for cell in some for loop in cell.loops]))
        self._number = {int(k): row for row, k in enumerate(used)}
        self._count = len(used)
        self._layers = np.empty((2, len(used), 3))
        self._uv: dict[tuple[int, int], FloatArray] = {}
        for cell in some:
            self._place(cell)
        self._sides: list[Side] = []
        self._sheets: list[Sheet] = []
        self._handles: dict[tuple[int, int], FloatArray] = {}
        self._blocks: list[FloatArray] = []

    def body(self) -> RuledBody:
        """The closed body."""
        for cell in self._some:
            self._add(cell)
        steps = {step for cell in self._some for step in cell.steps}
        count, number = self._count, self._number
        for start, end in sorted(steps):
            if (end, start) not in steps:
                low, high = number[start], number[end]
                self._sides.append((low, high, high + count, low + count))
        return RuledBody(
            self._layers.reshape(-1, 3),
            tuple(self._sides),
            self._handles,
            tuple(self._blocks),
            tuple(self._sheets),
        )

    def _place(self, cell: _Cell) -> None:
        """Find where the points of a cell are on both sides of the sheet."""
        sheet, cells = self._sheet, self._cells
        numbers = np.unique(np.concatenate(cell.loops))
        points = np.pad(cells.points[numbers], ((0, 0), (0, 1)))
        uv = sheet.rays.feet(points, np.full(len(points), cell.face))[:, :2]
        uv = np.where(np.abs(uv - np.round(uv)) <= 1e-9, np.round(uv), uv)
        corners = sheet.layers[:, sheet.faces[cell.face]]
        both = np.stack([bilinear(layer, uv) for layer in corners])
        if sheet.plane[cell.face]:
            both = _upright(both, corners)
        for row, number in enumerate(numbers.tolist()):
            self._uv[cell.face, number] = uv[row]
            own = self._number[number]
            if number in cells.sides:
                low, high, place = cells.sides[number][0]
                ends = sheet.layers[:, [low, high]]
                self._layers[:, own] = (1 - place) * ends[:, 0] + place * ends[:, 1]
            else:
                self._layers[:, own] = both[:, row]

    def _add(self, cell: _Cell) -> None:
        """Add both sides of a cell, and the blocks that hold it."""
        sheet, number, count = self._sheet, self._number, self._count
        loops = [tuple(number[k] for k in loop) for loop in cell.loops]
        upper = tuple(tuple(k + count for k in loop) for loop in loops)
        # From the same corner on, so that the curves around it are the same in reverse.
        lower = tuple((loop[0], *loop[:0:-1]) for loop in loops)
        whole = len(loops) == 1 and set(cell.loops[0]) == set(sheet.faces[cell.face].tolist())
        if len(loops) == 1 and (sheet.plane[cell.face] or whole):
            self._sides += [upper[0], lower[0]]
        elif sheet.plane[cell.face]:
            self._sheets += [Sheet(upper), Sheet(lower)]
        else:
            self._add_surfaces(cell, upper, lower)
        corners = sheet.layers[:, sheet.faces[cell.face]]
        if whole or not sheet.plane[cell.face]:
            self._blocks.append(corners.reshape(-1, 3))
            return
        ring = np.array(cell.loops[0])
        for triangle in triangles_in(self._cells.points[ring]):
            self._blocks.append(
                self._layers[:, [number[int(k)] for k in ring[triangle]]].reshape(-1, 3)
            )

    def _add_surfaces(self, cell: _Cell, upper: tuple[Side, ...], lower: tuple[Side, ...]) -> None:
        """Cut both surfaces of a face that is not plane along the curves around a cell."""
        corners = self._sheet.layers[:, self._sheet.faces[cell.face]]
        below, above = corners[:, [[0, 1], [3, 2]]]
        places = [[self._curve(cell.face, *step) for step in _around(loop)] for loop in cell.loops]
        self._sheets.append(Sheet(upper, above, tuple(map(tuple, places))))
        turned = [[curve[::-1] * (1, -1) + (0, 1) for curve in row[::-1]] for row in places]
        self._sheets.append(Sheet(lower, below[::-1], tuple(map(tuple, turned))))

    def _curve(self, face: int, start: int, end: int) -> FloatArray:
        """Control points in u and v of the straight line of the pattern between two points."""
        ends = np.stack([self._uv[face, start], self._uv[face, end]])
        if self._cells.side_of(start, end) is not None:
            return ends
        step = self._cells.points[end] - self._cells.points[start]
        handles = ends + _THIRDS * self._moved(face, ends, step)
        curve = np.stack([ends[0], *handles, ends[1]])
        places = blend(_CUBIC, np.linspace(0.0, 1.0, _IMAGE)) @ curve
        low, high = self._number[start], self._number[end]
        for layer, shift in ((0, 0), (1, self._count)):
            image = bilinear(self._sheet.layers[layer, self._sheet.faces[face]], places)
            inner = through(image)[1:-1]
            pair = min(low, high) + shift, max(low, high) + shift
            self._handles[pair] = inner if low < high else inner[::-1]
        return curve

    def _moved(self, face: int, places: FloatArray, step: FloatArray) -> FloatArray:
        """(N, 2) by how much u and v change at places (N, 2) for a step (2,) in the pattern."""
        a, b, c, d = self._sheet.flat[self._sheet.faces[face]]
        u, v = places[:, :1], places[:, 1:]
        by_u, by_v = (1 - v) * (b - a) + v * (c - d), (1 - u) * (d - a) + u * (c - b)
        matrices = np.stack([by_u, by_v], axis=2)
        return np.asarray(np.linalg.solve(matrices, np.broadcast_to(step, (len(u), 2))[..., None]))[
            ..., 0
        ]


def _upright(both: FloatArray, corners: FloatArray) -> FloatArray:
    """(2, N, 3) points within a plane face moved along it until they stand square to it."""
    diagonals = corners[0, 2] - corners[0, 0], corners[0, 3] - corners[0, 1]
    normal = np.cross(*diagonals)
    normal = normal / np.linalg.norm(normal)
    middle = both.mean(axis=0)
    half = np.einsum("nk,k->n", both[1] - both[0], normal) / 2
    arms = half[:, None] * normal
    return np.stack([middle - arms, middle + arms])
