"""Bent sheets that a border cuts: cut in their flat pattern, folded with it.

A sheet is a grid of faces that are known flat and in place. What is left of each is a cell: its
corners on sides that two faces share are those of both, so the pieces are closed without any
boolean operation. Cuts are square to plane faces; across a face that is not plane they follow the
surface, as the sides of the sheet do.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freecad_ortho.fabrication.bezier import blend, through
from freecad_ortho.fabrication.plate_bodies import triangles_in
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.ruled_sides import RuledSide, Side
from freecad_ortho.fabrication.sheet_cells import BentSheet, Cells, SheetCell, steps_around
from freecad_ortho.fabrication.trimming.rays import bilinear
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import shapely

# Control points of a cubic curve in the parameters of a face, and of its image in space.
_CUBIC, _IMAGE = 4, 7
_THIRDS = np.array([[1.0], [-1.0]]) / 3


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
    cells = Cells(sheet, regions)
    pieces = [_piece(sheet, cells, some) for some in cells.pieces()]
    return sorted(pieces, key=lambda piece: -piece.width)


def _piece(sheet: BentSheet, cells: Cells, some: list[SheetCell]) -> CutPiece:
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

    def __init__(self, sheet: BentSheet, cells: Cells, some: list[SheetCell]) -> None:
        self._sheet, self._cells, self._some = sheet, cells, some
        used = np.unique(np.concatenate([loop for cell in some for loop in cell.loops]))
        self._number = {int(k): row for row, k in enumerate(used)}
        self._count = len(used)
        self._layers = np.empty((2, len(used), 3))
        self._uv: dict[tuple[int, int], FloatArray] = {}
        for cell in some:
            self._place(cell)
        self._sides: list[Side] = []
        self._sheets: list[RuledSide] = []
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

    def _place(self, cell: SheetCell) -> None:
        """Find where the points of a cell are on both sides of the sheet."""
        sheet, cells = self._sheet, self._cells
        numbers = np.unique(np.concatenate(cell.loops))
        points = np.pad(cells.points[numbers], ((0, 0), (0, 1)))
        uv = sheet.rays.feet(points, np.full(len(points), cell.face))[:, :2]
        uv = np.where(np.abs(uv - np.round(uv)) <= 1e-9, np.round(uv), uv)
        corners = sheet.sides[:, sheet.faces[cell.face]]
        both = np.stack([bilinear(layer, uv) for layer in corners])
        if sheet.plane[cell.face]:
            both = _upright(both, corners)
        for row, number in enumerate(numbers.tolist()):
            self._uv[cell.face, number] = uv[row]
            own = self._number[number]
            if number in cells.sides:
                low, high, place = cells.sides[number][0]
                ends = sheet.sides[:, [low, high]]
                self._layers[:, own] = (1 - place) * ends[:, 0] + place * ends[:, 1]
            else:
                self._layers[:, own] = both[:, row]

    def _add(self, cell: SheetCell) -> None:
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
            self._sheets += [RuledSide(upper), RuledSide(lower)]
        else:
            self._add_surfaces(cell, upper, lower)
        corners = sheet.sides[:, sheet.faces[cell.face]]
        if whole or not sheet.plane[cell.face]:
            self._blocks.append(corners.reshape(-1, 3))
            return
        ring = np.array(cell.loops[0])
        for triangle in triangles_in(self._cells.points[ring]):
            self._blocks.append(
                self._layers[:, [number[int(k)] for k in ring[triangle]]].reshape(-1, 3)
            )

    def _add_surfaces(
        self, cell: SheetCell, upper: tuple[Side, ...], lower: tuple[Side, ...]
    ) -> None:
        """Cut both surfaces of a face that is not plane along the curves around a cell."""
        corners = self._sheet.sides[:, self._sheet.faces[cell.face]]
        below, above = corners[:, [[0, 1], [3, 2]]]
        places = [
            [self._curve(cell.face, *step) for step in steps_around(loop)] for loop in cell.loops
        ]
        self._sheets.append(RuledSide(upper, above, tuple(map(tuple, places))))
        turned = [[curve[::-1] * (1, -1) + (0, 1) for curve in row[::-1]] for row in places]
        self._sheets.append(RuledSide(lower, below[::-1], tuple(map(tuple, turned))))

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
            image = bilinear(self._sheet.sides[layer, self._sheet.faces[face]], places)
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
