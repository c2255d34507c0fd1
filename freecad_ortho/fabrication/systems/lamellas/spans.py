"""A ribbon that may twist, or bends smoothly, as a solid: on each side one ruled surface a face.

Between two stations the sides of the plate are surfaces of straight lines from the lower to the
upper edge. With u from station to station and v from edge to edge, slots and holes are loops in u
and v, the same on both sides, and their walls join the two curves that these make: so everything
is closed without any boolean operation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from freecad_ortho.fabrication.bezier import blend, through
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.ruled_sides import RuledSide, Side
from freecad_ortho.fabrication.systems.lamellas.cells import Rails, slot_side
from freecad_ortho.fabrication.systems.lamellas.outline import Slot
from freecad_ortho.fabrication.systems.lamellas.ribbon import Ribbon
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

# Length of the handles of a quarter of a circle, in radii.
QUARTER = 4 / 3 * np.tan(np.pi / 8)
_STEPS = 8
# Newton's method squares what is left, so after a step this small nothing is.
_SMALL_STEP = 1e-9


@dataclass(frozen=True, eq=False)
class Drilled:
    """A bolt hole in the pattern of a ribbon.

    Attributes:
        face: that it lies in, None where it lies across a station.
        station: whose ruling runs through its middle, None where it lies in a face.
        centre: (2,) in the pattern, mm.
        diameter: mm.
    """

    face: int | None
    station: int | None
    centre: FloatArray
    diameter: float


def span_body(
    ribbon: Ribbon,
    slots: Sequence[Slot],
    holes: Sequence[Drilled],
    smooth: bool,
    name: str,
    blocks: tuple[FloatArray, ...] = (),
) -> RuledBody:
    """Make the solid of a ribbon.

    Args:
        ribbon: that may twist.
        slots: that stand along its rulings.
        holes: that lie in one face, or about a station's ruling.
        smooth: its edges are cubic splines.
        name: of the lamella, for messages.
        blocks: convex hulls that hold the body.

    Raises:
        InputError: a slot or hole that is wider than the face beside it.
    """
    solid = _Solid(ribbon, smooth, name)
    at_slot = {slot.station: slot for slot in slots}
    at_hole = {hole.station: hole for hole in holes if hole.station is not None}
    inside: dict[int, list[Drilled]] = {}
    for hole in holes:
        if hole.face is not None:
            inside.setdefault(hole.face, []).append(hole)
    for face in range(len(ribbon.strip.lengths)):
        ends = [
            solid.end(face, station, at_slot.get(station), at_hole.get(station))
            for station in (face, face + 1)
        ]
        openings = [solid.opening(face, hole) for hole in inside.get(face, ())]
        solid.add(face, [_around(*ends), *openings])
    return RuledBody(
        np.array(solid.corners), tuple(solid.walls), solid.handles, blocks, tuple(solid.sheets)
    )


class _Solid:
    """Corners, curves and sides as they are found; corner 2 k is below corner 2 k + 1."""

    def __init__(self, ribbon: Ribbon, smooth: bool, name: str) -> None:
        self.ribbon, self.name = ribbon, name
        strip = ribbon.strip
        levels = np.array([ribbon.lower, ribbon.upper])
        rails = Rails(ribbon, levels, smooth)
        # (face, side, edge, P, 3)
        self.rails = rails.poles()
        self.flat = (
            strip.flat_points[:, None]
            + (levels * ribbon.stretch[:, None])[..., None] * strip.flat_rulings[:, None]
        )
        self.last = len(strip.points) - 1
        self.corners: list[FloatArray] = []
        self.handles: dict[tuple[int, int], FloatArray] = {}
        self.walls: list[Side] = []
        self.sheets: list[RuledSide] = []
        self.on_station: dict[tuple[int, float], int] = {}

    def share(self, level: float) -> float:
        """The v of a level."""
        return (level - self.ribbon.lower) / self.ribbon.width

    def corner(self, face: int, place: FloatArray) -> int:
        """Number of the pair of corners at u and v of a face; faces share those on a station."""
        station = face + int(place[0])
        key = station, float(place[1])
        if place[0] in (0.0, 1.0) and key in self.on_station:
            return self.on_station[key]
        number = len(self.corners) // 2
        self.corners += list(self._at(face, place[None])[:, 0])
        if place[0] in (0.0, 1.0):
            self.on_station[key] = number
        return number

    def _at(self, face: int, places: FloatArray) -> FloatArray:
        """(2, N, 3) points on both sides at (N, 2) u and v."""
        rails = self.rails[face]
        points = blend(rails.shape[2], places[:, 0]) @ rails
        v = places[:, 1][:, None]
        return np.asarray((1 - v) * points[:, 0] + v * points[:, 1])

    def end(
        self, face: int, station: int, slot: Slot | None, hole: Drilled | None
    ) -> list[FloatArray]:
        """Curves in u and v along an end of a face, from its lower to its upper edge."""
        at = float(station - face)
        if hole is not None:
            return self._beside_hole(face, station, hole)
        places = [np.array([at, 0.0]), np.array([at, 1.0])]
        if slot is not None:
            floor = slot.floor * (1 if slot.upward else -1)
            levels = np.array([floor, self.ribbon.upper if slot.upward else self.ribbon.lower])
            along = slot_side(self.ribbon, slot, levels, -1 if at else 1) - face
            if along.min() <= 0 or along.max() >= 1:
                raise InputError(
                    f"lamellas: a slot of {self.name} is wider than the edge beside it; take "
                    "thinner lamellas or leave out parameter lines"
                )
            inner, outer = np.column_stack([along, [self.share(floor), float(slot.upward)]])
            on_line = np.array([at, inner[1]])
            places = (
                [places[0], on_line, inner, outer]
                if slot.upward
                else [outer, inner, on_line, places[1]]
            )
        return [np.stack(pair) for pair in pairwise(places)]

    def _beside_hole(self, face: int, station: int, hole: Drilled) -> list[FloatArray]:
        """The same along a station whose ruling runs through the middle of a hole."""
        strip, at = self.ribbon.strip, float(station - face)
        up = strip.flat_rulings[station]
        ahead = (1 - 2 * at) * np.array([up[1], -up[0]])
        radius = hole.diameter / 2
        level = float((hole.centre - strip.flat_points[station]) @ up)
        low, high = (
            np.array([at, self.share((level + side * radius) / self.ribbon.stretch[station])])
            for side in (-1, 1)
        )
        (middle,) = self._places(face, (hole.centre + radius * ahead)[None], hole)
        first = self._quarter(face, (low, middle), (radius * ahead, radius * up))
        second = self._quarter(face, (middle, high), (radius * up, -radius * ahead))
        return [
            np.stack([np.array([at, 0.0]), low]),
            first,
            second,
            np.stack([high, np.array([at, 1.0])]),
        ]

    def opening(self, face: int, hole: Drilled) -> list[FloatArray]:
        """Curves in u and v around a hole in a face, clockwise."""
        radius = hole.diameter / 2
        arms = radius * np.array([[1.0, 0.0], [0.0, -1.0], [-1.0, 0.0], [0.0, 1.0]])
        places = self._places(face, hole.centre + arms, hole)
        order = [(k, (k + 1) % 4) for k in range(4)]
        return [
            self._quarter(face, (places[here], places[after]), (arms[after], -arms[here]))
            for here, after in order
        ]

    def _quarter(
        self,
        face: int,
        ends: tuple[FloatArray, FloatArray],
        tangents: tuple[FloatArray, FloatArray],
    ) -> FloatArray:
        """(4, 2) curve in u and v of a quarter of a circle, its tangents as long as its radius."""
        places = np.array(ends)
        handles = QUARTER * np.array([[1], [-1]]) * self._step(face, places, np.array(tangents))
        return np.stack([ends[0], *(places + handles), ends[1]])

    def _step(self, face: int, places: FloatArray, moves: FloatArray) -> FloatArray:
        """(N, 2) by how much u and v change at places (N, 2) for moves (N, 2) in the pattern."""
        (a, b), (c, d) = self.flat[face], self.flat[face + 1]
        u, v = places[:, :1], places[:, 1:]
        by_u, by_v = (1 - v) * (c - a) + v * (d - b), (1 - u) * (b - a) + u * (d - c)

        def area(one: FloatArray, two: FloatArray) -> FloatArray:
            return np.asarray(one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0])

        steps = np.stack([area(moves, by_v), area(by_u, moves)], axis=1)
        return np.asarray(steps / area(by_u, by_v)[:, None])

    def _places(self, face: int, points: FloatArray, hole: Drilled) -> FloatArray:
        """(N, 2) u and v of points (N, 2) of the pattern, by Newton's method.

        Raises:
            InputError: one lies outside of the face.
        """
        (a, b), (c, d) = self.flat[face], self.flat[face + 1]
        places = np.full((len(points), 2), 0.5)
        for _ in range(_STEPS):
            u, v = places[:, :1], places[:, 1:]
            found = (1 - u) * ((1 - v) * a + v * b) + u * ((1 - v) * c + v * d)
            step = self._step(face, places, points - found)
            places = places + step
            if np.abs(step).max() <= _SMALL_STEP:
                break
        if places.min() <= 0 or places.max() >= 1:
            raise InputError(
                f"hole: {hole.diameter:g} mm is wider than an edge or the width of {self.name}; "
                "take smaller holes or leave out parameter lines"
            )
        return places

    def add(self, face: int, loops: list[list[FloatArray]]) -> None:
        """Add both sides of a face and the walls along its loops."""
        corners = [[self.corner(face, curve[0]) for curve in loop] for loop in loops]
        for ring, loop in zip(corners, loops, strict=True):
            for start, end, curve in zip(ring, ring[1:] + ring[:1], loop, strict=True):
                self._keep_handles(face, start, end, curve)
                # Along a station the next face goes on.
                if not self._shared(face, curve):
                    self.walls.append((2 * start, 2 * end, 2 * end + 1, 2 * start + 1))
        above, below = self.rails[face, 1], self.rails[face, 0, ::-1]
        self.sheets.append(
            RuledSide(
                tuple(tuple(2 * corner + 1 for corner in ring) for ring in corners),
                above,
                tuple(tuple(loop) for loop in loops),
            )
        )
        turned = [[curve[::-1] * (1, -1) + (0, 1) for curve in loop[::-1]] for loop in loops]
        self.sheets.append(
            RuledSide(
                tuple((2 * ring[0], *(2 * c for c in ring[:0:-1])) for ring in corners),
                below,
                tuple(tuple(loop) for loop in turned),
            )
        )

    def _shared(self, face: int, curve: FloatArray) -> bool:
        """Whether a curve lies on a station beyond which the next face goes on."""
        u = curve[:, 0]
        return any((u == at).all() and 0 < face + at < self.last for at in (0, 1))

    def _keep_handles(self, face: int, start: int, end: int, curve: FloatArray) -> None:
        """Keep the control points of a curve on both sides of the plate, where it is one."""
        degree = self.rails.shape[3] - 1
        if np.ptp(curve[:, 0]) == 0:
            return
        count = degree + 1 if np.ptp(curve[:, 1]) == 0 else (degree + 1) * (len(curve) - 1) + 1
        if count == 2:
            return
        places = blend(len(curve), np.linspace(0, 1, count)) @ curve
        for side, points in enumerate(self._at(face, places)):
            ends, inner = (2 * start + side, 2 * end + side), through(points)[1:-1]
            self.handles[min(ends), max(ends)] = inner if ends[0] < ends[1] else inner[::-1]


def _around(begin: list[FloatArray], end: list[FloatArray]) -> list[FloatArray]:
    """Curves around a face, counter-clockwise, from those along its ends."""
    below, above = np.stack([begin[0][0], end[0][0]]), np.stack([end[-1][-1], begin[-1][-1]])
    return [below, *end, above, *(curve[::-1] for curve in reversed(begin))]
