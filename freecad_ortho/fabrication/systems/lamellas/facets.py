"""A developable ribbon as a solid: its pattern cut along the bend lines and folded.

Every piece of the pattern stays plane. Its points become two corners, on both sides of the plate;
on a bend line these lie in the mitre plane, so that the pieces share them. So the solid is closed
without any boolean operation. A hole that a bend line crosses is cut with the pattern, all others
are cylinders.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from freecad_ortho.fabrication.pattern import polygon_area
from freecad_ortho.fabrication.ruled import RuledBody
from freecad_ortho.fabrication.ruled_sides import Bore, RuledSide, Side
from freecad_ortho.fabrication.systems.lamellas.ribbon import FLAT, Ribbon
from freecad_ortho.fabrication.systems.lamellas.spans import Drilled
from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray

# Distance from a bend line, mm, below which a corner of the outline lies on it.
_ON_LINE = 1e-7
# Largest angle of an arc, radians, that is one curve.
_ARC = np.pi / 2 + 1e-9

Loop = list[int]
# Loops around a piece of the pattern, counter-clockwise, and around openings, clockwise.
Region = list[Loop]


def folded_body(ribbon: Ribbon, outline: FloatArray, holes: Sequence[Drilled] = ()) -> RuledBody:
    """Fold the outline (N, 2) of the pattern of a ribbon without twist."""
    pieces = _Pieces(ribbon, list(outline))
    crossed = [hole for hole in holes if pieces.bends_at(hole)]
    pieces.cut([list(range(len(outline))), *(pieces.around(hole) for hole in crossed)])
    points = np.array(pieces.points)
    middle, half = np.empty((len(points), 3)), np.empty((len(points), 3))
    for face, loop in pieces.done:
        middle[loop], half[loop] = ribbon.placed(face, points[loop])
    for point, station in pieces.station.items():
        half[point] = ribbon.mitres[station]
    count = len(points)
    corners = np.concatenate([middle - half, middle + half])
    handles = {}
    for face, loop in pieces.done:
        for start, end in zip(loop, loop[1:] + loop[:1], strict=True):
            if (start, end) not in pieces.arcs:
                continue
            # In its own face; where it ends on a bend line it runs into the mitre plane.
            inner, _ = ribbon.placed(face, pieces.arcs[start, end])
            share = np.array([[1 / 3], [2 / 3]])
            out = (1 - share) * half[start] + share * half[end]
            order = 1 if start < end else -1
            low, high = min(start, end), max(start, end)
            handles[low, high] = (inner - out)[::order]
            handles[low + count, high + count] = (inner + out)[::order]
    loops = [loop for _, loop in pieces.done]
    sides, sheets, both = _sides(loops, count, pieces.arcs)
    prisms = (
        ()
        if holes
        else tuple(
            corners[[*corner, *(point + count for point in corner)]]
            for loop in loops
            for corner in triangles(points, loop)
        )
    )
    bores = []
    for hole in holes:
        if hole not in crossed:
            number = next(k for k, loop in enumerate(loops) if _inside(points[loop], hole.centre))
            centre, up = ribbon.placed(pieces.done[number][0], hole.centre[None])
            bores.append(Bore((centre - up)[0], (centre + up)[0], hole.diameter, both[number]))
    return RuledBody(corners, sides, handles, prisms, sheets, tuple(bores))


@dataclass
class _Pieces:
    """Points of the pattern, and the loops of them that lie in each face.

    ``station`` are the stations of points whose corners lie in mitres, ``arcs`` the inner control
    points (2, 2) of the arcs between two points, ``done`` the first station of each piece and its
    loop.
    """

    ribbon: Ribbon
    points: list[FloatArray]
    station: dict[int, int] = field(default_factory=dict)
    arcs: dict[tuple[int, int], FloatArray] = field(default_factory=dict)
    done: list[tuple[int, Loop]] = field(default_factory=list)

    @property
    def bent(self) -> list[int]:
        """Stations whose rulings bend."""
        return np.flatnonzero(np.abs(self.ribbon.strip.bends) > FLAT).tolist()

    def bends_at(self, hole: Drilled) -> list[int]:
        """Stations whose bend lines cross a hole."""
        return [
            station
            for station in self.bent
            if abs(self.ribbon.ahead(station, hole.centre[None])[0]) < hole.diameter / 2
        ]

    def around(self, hole: Drilled) -> Loop:
        """Loop of the points in which bend lines cross a hole, and others between, clockwise."""
        radius = hole.diameter / 2
        crossed: dict[float, int] = {}
        for station in self.bends_at(hole):
            up = self.ribbon.strip.flat_rulings[station]
            away = float(self.ribbon.ahead(station, hole.centre[None])[0])
            heading, spread = float(np.arctan2(-up[0], up[1])), float(np.arccos(-away / radius))
            places = ((heading + side * spread) % (2 * np.pi) for side in (-1, 1))
            crossed |= dict.fromkeys(places, station)
        angles: list[float] = []
        starts = sorted(crossed, reverse=True)
        for here, after in zip(starts, [*starts[1:], starts[0] - 2 * np.pi], strict=True):
            parts = int(np.ceil((here - after) / _ARC))
            angles += np.linspace(here, after, parts, endpoint=False).tolist()
        loop = list(range(len(self.points), len(self.points) + len(angles)))
        self.points += [hole.centre + radius * _direction(angle) for angle in angles]
        for point, angle in zip(loop, angles, strict=True):
            # Along the bolt, which stands in the mitre plane, not square to each face.
            if (bend := crossed.get(angle, hole.station)) is not None:
                self.station[point] = bend
        pairs = zip(loop, loop[1:] + loop[:1], strict=True)
        spans = zip(angles, [*angles[1:], angles[0] - 2 * np.pi], strict=True)
        for (start, end), (here, after) in zip(pairs, spans, strict=True):
            reach = 4 / 3 * np.tan((here - after) / 4) * radius
            first = self.points[start] + reach * _direction(here - np.pi / 2)
            second = self.points[end] - reach * _direction(after - np.pi / 2)
            self.arcs[start, end] = np.stack([first, second])
        return loop

    def cut(self, region: Region) -> None:
        """Cut the outline along every ruling that bends."""
        ahead, face = [region], 0
        for station in self.bent:
            behind: list[Region] = []
            further: list[Region] = []
            for each in ahead:
                one, other = self._split(each, station)
                behind += one
                further += other
            self.done += [(face, loop) for each in behind for loop in each]
            ahead, face = further, station
        self.done += [(face, loop) for each in ahead for loop in each]

    def _split(self, region: Region, station: int) -> tuple[list[Region], list[Region]]:
        """What lies behind and ahead of a ruling; a region that it misses is behind.

        Each second pair of points on the line is joined by a chord. What lies behind the line, on
        its left, runs along the chord upwards, what lies ahead downwards.
        """
        longer, found = [], []
        for loop in region:
            loop, crossed = self._with_crossings(loop, station)
            longer.append(loop)
            found += crossed
        if not found:
            return [region], []
        ends = [number for _, number in sorted(found)]
        onward = [{a: b for loop in longer for a, b in zip(loop, loop[1:] + loop[:1], strict=True)}]
        onward.append(dict(onward[0]))
        chords = list(zip(ends[::2], ends[1::2], strict=True))
        for low, high in chords:
            onward[0][low], onward[1][high] = high, low
        # A pattern that curls comes back to where the line leads: only the chords tell its sides.
        starts = [low for low, _ in chords], [high for _, high in chords]
        split = [walked(following, start) for following, start in zip(onward, starts, strict=True)]
        points = np.array(self.points)
        for loop in longer:
            if not set(loop) & set(ends):
                behind = any(_inside(points[outer], points[loop[0]]) for outer in split[0])
                split[0 if behind else 1].append(loop)
        return _regions(points, split[0]), _regions(points, split[1])

    def _with_crossings(self, loop: Loop, station: int) -> tuple[Loop, list[tuple[float, int]]]:
        """The loop with the points where it crosses a ruling, and these with their places on it."""
        strip, ribbon = self.ribbon.strip, self.ribbon
        distance = ribbon.ahead(station, np.array([self.points[k] for k in loop]))
        side = np.where(np.abs(distance) <= _ON_LINE, 0, np.sign(distance)).astype(int)
        low, high = (level * ribbon.stretch[station] for level in (ribbon.lower, ribbon.upper))

        def along(point: FloatArray) -> float:
            return float((point - strip.flat_points[station]) @ strip.flat_rulings[station])

        longer: Loop = []
        found: list[tuple[float, int]] = []
        for here in range(len(loop)):
            after = (here + 1) % len(loop)
            longer.append(loop[here])
            reach = along(self.points[loop[here]])
            inside = low - _ON_LINE <= reach <= high + _ON_LINE
            if side[here] == 0 and inside:
                self.station[loop[here]] = station
                before = next(s for s in np.roll(side[::-1], -(len(side) - here)) if s)
                behind = next(s for s in np.roll(side, -here) if s)
                if before != behind:
                    found.append((reach, loop[here]))
            elif side[here] * side[after] < 0:
                share = distance[here] / (distance[here] - distance[after])
                start, end = self.points[loop[here]], self.points[loop[after]]
                point = start + share * (end - start)
                if low - _ON_LINE <= along(point) <= high + _ON_LINE:
                    self.points.append(point)
                    self.station[len(self.points) - 1] = station
                    longer.append(len(self.points) - 1)
                    found.append((along(point), len(self.points) - 1))
        return longer, found


def walked(following: Mapping[int, int], starts: Sequence[int]) -> list[Loop]:
    """The loops through these points, each once, that lead from each point to the one after it.

    Raises:
        InputError: one does not return, as where lines cross that cut it.
    """
    loops: list[Loop] = []
    seen: set[int] = set()
    for start in starts:
        if start in seen:
            continue
        loop = [start]
        while (after := following[loop[-1]]) != start:
            if len(loop) > len(following):
                raise InputError(
                    "bent strip: its bend lines cross each other within its width; make "
                    "the lamella narrower, or optimise the net first"
                )
            loop.append(after)
        seen.update(loop)
        # Where the line runs along a side of the outline there is nothing between them.
        if len(loop) > 2:
            loops.append(loop)
    return loops


def _regions(points: FloatArray, loops: list[Loop]) -> list[Region]:
    """Loops around pieces, each with the openings that lie in it."""
    outer = [loop for loop in loops if polygon_area(points[loop]) > 0]
    regions: list[Region] = [[loop] for loop in outer]
    for loop in loops:
        if polygon_area(points[loop]) <= 0:
            owner = next(r for r in regions if _inside(points[r[0]], points[loop[0]]))
            owner.append(loop)
    return regions


def _inside(polygon: FloatArray, point: FloatArray) -> bool:
    """Whether a point lies in a simple polygon (N, 2)."""
    a, b = polygon - point, np.roll(polygon, -1, axis=0) - point
    crosses = (a[:, 1] > 0) != (b[:, 1] > 0)
    right = (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) * np.sign(b[:, 1] - a[:, 1]) > 0
    return bool((crosses & right).sum() % 2)


def _direction(angle: float) -> FloatArray:
    return np.array([np.cos(angle), np.sin(angle)])


def _sides(
    pieces: list[Loop], count: int, arcs: Mapping[tuple[int, int], FloatArray]
) -> tuple[tuple[Side, ...], tuple[RuledSide, ...], list[tuple[int, int]]]:
    """Sides of the solid: each piece on both sides of the plate, and walls along the outline.

    Returns:
        The sides, those that arcs bound, and for each piece the numbers of its lower and its upper
        side, counted through both.
    """
    sides: list[Side] = []
    sheets: list[RuledSide] = []
    numbers = []
    edges = set()
    for loop in pieces:
        around = list(zip(loop, loop[1:] + loop[:1], strict=True))
        edges.update(around)
        upper, lower = tuple(point + count for point in loop), tuple(reversed(loop))
        curved = any(pair in arcs for pair in around)
        if curved:
            sheets += [RuledSide((lower,)), RuledSide((upper,))]
        else:
            sides += [lower, upper]
        numbers.append((curved, len(sheets if curved else sides) - 2))
    for start, end in sorted(edges):
        if (end, start) not in edges:
            sides.append((start, end, end + count, start + count))
    first = [place + len(sides) * curved for curved, place in numbers]
    return tuple(sides), tuple(sheets), [(place, place + 1) for place in first]


def triangles(points: FloatArray, loop: list[int]) -> list[tuple[int, int, int]]:
    """Triangles of a simple counter-clockwise polygon, by clipping its ears."""
    left, found = list(loop), []
    while len(left) > 3:
        ear = next((k for k in range(len(left)) if _is_ear(points, left, k)), 0)
        before, here, after = left[ear - 1], left[ear], left[(ear + 1) % len(left)]
        found.append((before, here, after))
        del left[ear]
    return [*found, (left[0], left[1], left[2])]


def _is_ear(points: FloatArray, loop: list[int], place: int) -> bool:
    corner = [loop[place - 1], loop[place], loop[(place + 1) % len(loop)]]
    a, b, c = points[corner]
    steps = np.array([b - a, c - b, a - c])
    if steps[0, 0] * steps[1, 1] - steps[0, 1] * steps[1, 0] <= 0:
        return False
    others = points[[point for point in loop if point not in corner]]
    arms = others[:, None] - np.array([a, b, c])
    return not (steps[:, 0] * arms[..., 1] - steps[:, 1] * arms[..., 0] >= 0).all(axis=1).any()
