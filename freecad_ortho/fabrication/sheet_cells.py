"""Cells: what a border leaves of the faces of a bent sheet, in its flat pattern.

Corners on sides that two faces share are those of both.
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

from freecad_ortho.fabrication.trimming.rays import Rays
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


@dataclass(frozen=True, eq=False)
class BentSheet:
    """A sheet of faces in its flat pattern and in its place.

    Attributes:
        flat: (V, 2) vertices in the pattern, in which no two faces overlap.
        sides: (2, V, 3) the same on the lower and the upper side, mm.
        faces: (F, 4) counter-clockwise, seen from the upper side and in the pattern.
    """

    flat: FloatArray
    sides: FloatArray
    faces: IntArray

    @cached_property
    def rays(self) -> Rays:
        """The pattern as coordinates: u and v in each face."""
        corners = np.pad(self.flat[self.faces], ((0, 0), (0, 0), (0, 1)))
        return Rays(corners, np.broadcast_to([0.0, 0.0, 1.0], corners.shape))

    @cached_property
    def plane(self) -> IntArray:
        """(F,) 1 for faces that are plane on both sides, 0 for others."""
        corners = self.sides[:, self.faces]
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


# Numbers of points around a cell, counter-clockwise, and around its openings, clockwise.
Loops = list[list[int]]


@dataclass(frozen=True, eq=False)
class SheetCell:
    """A part of a face."""

    face: int
    loops: Loops

    @property
    def steps(self) -> list[tuple[int, int]]:
        """From each corner to the next."""
        return [step for loop in self.loops for step in pairwise([*loop, loop[0]])]


class Cells:
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
            SheetCell(face, [_without_repeats(loops[ring]) for ring in own])
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
            for start, end in steps_around(faces[cell.face].tolist()):
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
                for start, end in steps_around(loop):
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

    def pieces(self) -> list[list[SheetCell]]:
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


def steps_around(loop: Sequence[int]) -> list[tuple[int, int]]:
    """Pairs of numbers, each with the one after it, the last with the first."""
    return list(pairwise([*loop, loop[0]]))


def _without_repeats(loop: list[int]) -> list[int]:
    return [
        number for number, before in zip(loop, [loop[-1], *loop], strict=False) if number != before
    ]
