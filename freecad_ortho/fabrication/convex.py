"""Convex pieces of bodies, and the volume that they share, without the CAD kernel.

A convex piece is the intersection of the half-spaces below its sides. Clipping one piece by the
sides of another leaves what both share; its volume follows from its corners. Neither parts that
touch nor sides that lie in one plane need care, as they do in boolean operations on boundaries: a
plane that cuts nothing off is left out.

Coordinates are plain numbers here: pieces have a dozen corners, too few for arrays to pay.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from freecad_ortho.fabrication.bodies import BOX_CORNERS, BOX_SIDES, Loops
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray

# Points this near to a plane, mm, lie on it: a hundredth of what the CAD kernel takes for a point.
_ON_PLANE = 1e-9
# Corners further above a side, mm, make a piece that is not convex, or a side that is not plane.
_CONVEX = 1e-7
_BATCH = 4096

_Point = tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class ConvexHull:
    """The convex hull of corners, or a little more where sides are not plane.

    Attributes:
        corners: (P, 3) mm.
        box: (2, 3) their least and largest coordinates.
        loops: corner numbers around each side, counter-clockwise seen from outside.
        normals: (A, 3) unit normals of the sides; zero for a side without area.
        levels: (A,) how far the corners reach along these, mm.
        least: (A,) how far each of a side's own corners reaches at least.
        convex: true where the sides are plane and all corners lie below them.
    """

    corners: FloatArray
    box: FloatArray
    loops: Loops
    normals: FloatArray
    levels: FloatArray
    least: FloatArray
    convex: bool


def convex_pieces(bodies: Sequence[tuple[FloatArray, Loops]]) -> list[ConvexHull]:
    """Make pieces of corners (P, 3) and sides, many at once."""
    kinds: dict[Loops, list[int]] = defaultdict(list)
    for number, (_, loops) in enumerate(bodies):
        kinds[loops].append(number)
    made: dict[int, ConvexHull] = {}
    for loops, numbers in kinds.items():
        points = np.array([bodies[number][0] for number in numbers])
        normals = _side_normals(points, loops)
        heights = np.einsum("nak,npk->nap", normals, points)
        levels = heights.max(axis=2)
        boxes = np.stack([points.min(axis=1), points.max(axis=1)], axis=1)
        least = np.stack(
            [heights[:, a, list(loop)].min(axis=1) for a, loop in enumerate(loops)], axis=1
        )
        convex = (levels - least).max(axis=1) <= _CONVEX
        for row, number in enumerate(numbers):
            corners, _ = bodies[number]
            sides = normals[row], levels[row], least[row]
            made[number] = ConvexHull(corners, boxes[row], loops, *sides, bool(convex[row]))
    return [made[number] for number in range(len(bodies))]


def core(piece: ConvexHull) -> ConvexHull:
    """What lies below all corners of each side: within whatever these sides bound, bent or not."""
    return piece if piece.convex else replace(piece, levels=piece.least)


def shared_volume(
    one: Sequence[ConvexHull], other: Sequence[ConvexHull], taken: Sequence[ConvexHull] = ()
) -> float:
    """Volume that two bodies share, mm3, both as pieces that do not overlap one another.

    Where the pieces are more than a body, it is an upper bound. What lies in pieces that are
    ``taken`` off both does not count, twice where these overlap: then it is a lower bound.
    """
    taken_off: dict[int, list[ConvexHull]] = defaultdict(list)
    for i, hole in overlapping(one, taken):
        taken_off[i].append(taken[hole])
    total = 0.0
    for i, j in overlapping(one, other):
        base = one[i].corners.mean(axis=0)
        left = _shared(one[i], other[j], base)
        if left is not None:
            total += left.volume()
            total -= sum(left.within(_planes(hole, base)) for hole in taken_off[i])
    return max(total, 0.0)


def volume_bounds(pieces: Sequence[ConvexHull], pairs: IntArray) -> FloatArray:
    """(N,) upper bound of the volume that each pair of pieces (N, 2) shares, mm3.

    It is zero where a side of either separates them.
    """
    kinds: dict[tuple[Loops, Loops], list[int]] = defaultdict(list)
    for number, (i, j) in enumerate(pairs.tolist()):
        kinds[pieces[i].loops, pieces[j].loops].append(number)
    result = np.empty(len(pairs))
    for numbers in kinds.values():
        for start in range(0, len(numbers), _BATCH):
            some = numbers[start : start + _BATCH]
            one, other = ([pieces[k] for k in pairs[some, column].tolist()] for column in (0, 1))
            result[some] = _bound(one, other)
    return result


def overlapping(one: Sequence[ConvexHull], other: Sequence[ConvexHull]) -> list[tuple[int, int]]:
    """Numbers of pieces of two bodies that neither their boxes nor their sides separate."""
    if not one or not other:
        return []
    first, second = (np.array([piece.box for piece in pieces]) for pieces in (one, other))
    # Most pieces of long bodies are far from the other body.
    here, there = (
        np.flatnonzero(boxes_meet(boxes, (others[:, 0].min(axis=0), others[:, 1].max(axis=0))))
        for boxes, others in ((first, second), (second, first))
    )
    meets = boxes_meet(first[here, None], (second[there, 0], second[there, 1]))
    rows, columns = np.nonzero(meets)
    pairs = np.column_stack([here[rows], there[columns]])
    kept = volume_bounds([*one, *other], pairs + np.array([0, len(one)])) > 0
    return [(i, j) for i, j in pairs[kept].tolist()]


def boxes_meet(boxes: FloatArray, others: tuple[FloatArray, FloatArray]) -> BoolArray:
    """Whether boxes (..., 2, 3) overlap others, given by their least and largest coordinates."""
    low, high = others
    return np.asarray(((boxes[..., 0, :] < high) & (boxes[..., 1, :] > low)).all(axis=-1))


def _bound(one: Sequence[ConvexHull], other: Sequence[ConvexHull]) -> FloatArray:
    """(N,) the bounds for pieces of one shape each."""
    normals = np.concatenate(
        [np.array([piece.normals for piece in some]) for some in (one, other)], axis=1
    )
    first, second = (np.array([piece.corners for piece in some]) for some in (one, other))
    boxes = (np.array([piece.box for piece in some]) for some in (one, other))
    spans = [normals @ np.moveaxis(points, 1, 2) for points in (first, second)]
    overlap = np.minimum(
        spans[0].max(axis=2) - spans[1].min(axis=2), spans[1].max(axis=2) - spans[0].min(axis=2)
    )
    depth = np.maximum(overlap.min(axis=1), 0.0)
    (low, high), (other_low, other_high) = (np.moveaxis(box, 1, 0) for box in boxes)
    box = np.minimum(high, other_high) - np.maximum(low, other_low)
    return np.asarray(depth * (box**2).sum(axis=1))


def _shared(one: ConvexHull, other: ConvexHull, base: FloatArray) -> _Clipped | None:
    """What two pieces share, seen from a base point; None for nothing."""
    cutting = [_planes(other, base)]
    if one.convex:
        left = _Clipped((one.corners - base).tolist(), one.loops)
    else:
        box = np.where(BOX_CORNERS, one.box[1], one.box[0])
        left = _Clipped((box - base).tolist(), BOX_SIDES)
        cutting.append(_planes(one, base))
    planes = (plane for planes in cutting for plane in planes)
    return left if all(left.cut(*plane) for plane in planes) else None


def _planes(piece: ConvexHull, base: FloatArray) -> list[tuple[_Point, float]]:
    """Normals of the sides, and their levels seen from a base point."""
    levels = piece.levels - piece.normals @ base
    return list(zip(map(tuple, piece.normals.tolist()), levels.tolist(), strict=True))


class _Clipped:
    """A convex polyhedron that half-spaces cut down."""

    def __init__(self, points: Sequence[Sequence[float]], sides: Sequence[Sequence[int]]) -> None:
        self.points: list[_Point] = [(x, y, z) for x, y, z in points]
        self.sides: list[Sequence[int]] = list(sides)

    def cut(self, normal: _Point, level: float) -> bool:
        """Keep what lies below a plane; false where nothing does."""
        x, y, z = normal
        heights = [x * p + y * q + z * r - level for p, q, r in self.points]
        heights = [0.0 if abs(height) <= _ON_PLANE else height for height in heights]
        used = {number for side in self.sides for number in side}
        if all(heights[number] <= 0 for number in used):
            return True
        if all(heights[number] >= 0 for number in used):
            return False
        crossings: dict[tuple[int, int], int] = {}
        sides = [self._below(side, heights, crossings) for side in self.sides]
        self.sides = [side for side in sides if len(side) > 2]
        used = {number for side in self.sides for number in side}
        rim = [k for k in used if k >= len(heights) or heights[k] == 0]
        if len(rim) > 2:
            self.sides.append(self._around(sorted(rim), normal))
        return True

    def within(self, planes: Sequence[tuple[_Point, float]]) -> float:
        """Volume of what lies below planes, mm3."""
        part = _Clipped(self.points, self.sides)
        return part.volume() if all(part.cut(*plane) for plane in planes) else 0.0

    def _below(
        self, side: Sequence[int], heights: list[float], crossings: dict[tuple[int, int], int]
    ) -> list[int]:
        """What is left of a side; where its edges cross the plane there are new points."""
        kept: list[int] = []
        for start, end in pairwise([*side, side[0]]):
            if heights[start] <= 0:
                kept.append(start)
            if heights[start] * heights[end] < 0:
                ends = (start, end) if start < end else (end, start)
                if ends not in crossings:
                    crossings[ends] = len(self.points)
                    self.points.append(self._between(*ends, heights))
                kept.append(crossings[ends])
        return kept

    def _between(self, start: int, end: int, heights: list[float]) -> _Point:
        share = heights[start] / (heights[start] - heights[end])
        (a, b, c), (d, e, f) = self.points[start], self.points[end]
        return a + share * (d - a), b + share * (e - b), c + share * (f - c)

    def _around(self, corners: list[int], normal: _Point) -> list[int]:
        """Corners of a convex polygon, counter-clockwise about its normal."""
        middle = _mean([self.points[number] for number in corners])
        arms = [_less(self.points[number], middle) for number in corners]
        first = max(arms, key=lambda arm: _dot(arm, arm))
        second = _cross(normal, first)
        angles = [math.atan2(_dot(arm, second), _dot(arm, first)) for arm in arms]
        return [number for _, number in sorted(zip(angles, corners, strict=True))]

    def volume(self) -> float:
        """Volume by cones from a point inside to the sides, mm3."""
        if not self.sides:
            return 0.0
        inside = _mean([self.points[side[0]] for side in self.sides])
        total = 0.0
        for side in self.sides:
            first, *others = (_less(self.points[number], inside) for number in side)
            total += sum(_dot(first, _cross(two, three)) for two, three in pairwise(others))
        return max(total / 6, 0.0)


def _side_normals(points: FloatArray, loops: Loops) -> FloatArray:
    """(N, A, 3) unit normals of the sides of bodies (N, P, 3)."""
    rows = []
    for loop in loops:
        side = points[:, list(loop)] - points[:, loop[:1]]
        area = np.cross(side[:, 1:-1], side[:, 2:]).sum(axis=1)
        length = np.linalg.norm(area, axis=1, keepdims=True)
        rows.append(area / np.where(length > 0, length, 1.0))
    return np.stack(rows, axis=1)


def _mean(points: Sequence[_Point]) -> _Point:
    x, y, z = (math.fsum(axis) / len(points) for axis in zip(*points, strict=True))
    return x, y, z


def _less(one: _Point, two: _Point) -> _Point:
    return one[0] - two[0], one[1] - two[1], one[2] - two[2]


def _dot(one: _Point, two: _Point) -> float:
    return one[0] * two[0] + one[1] * two[1] + one[2] * two[2]


def _cross(one: _Point, two: _Point) -> _Point:
    (a, b, c), (d, e, f) = one, two
    return b * f - c * e, c * d - a * f, a * e - b * d
