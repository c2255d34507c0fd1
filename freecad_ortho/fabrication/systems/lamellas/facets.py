"""A developable ribbon as a solid: its pattern cut along the bend lines and folded.

Every piece of the pattern stays plane. Its points become two corners, on both sides of the plate;
on a bend line these lie in the mitre plane, so that the pieces share them. So the solid is closed
without any boolean operation.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from freecad_ortho.fabrication.ruled import RuledBody, Side
from freecad_ortho.fabrication.systems.lamellas.ribbon import FLAT, Ribbon
from solver.mesh.quadmesh import FloatArray

# Distance from a bend line, mm, below which a corner of the outline lies on it.
_ON_LINE = 1e-7

Piece = tuple[int, list[int]]


def folded_body(ribbon: Ribbon, outline: FloatArray) -> RuledBody:
    """Fold the outline (N, 2) of the pattern of a ribbon without twist."""
    pieces = _Pieces(ribbon, list(outline))
    pieces.cut()
    points = np.array(pieces.points)
    middle, half = np.empty((len(points), 3)), np.empty((len(points), 3))
    for face, loop in pieces.done:
        middle[loop], half[loop] = ribbon.placed(face, points[loop])
    for point, station in pieces.station.items():
        half[point] = ribbon.mitres[station]
    corners = np.concatenate([middle - half, middle + half])
    loops = [loop for _, loop in pieces.done]
    prisms = tuple(
        corners[[*corner, *(point + len(points) for point in corner)]]
        for loop in loops
        for corner in triangles(points, loop)
    )
    return RuledBody(corners, _sides(loops, len(points)), blocks=prisms)


@dataclass
class _Pieces:
    """Points of the pattern, and the loops of them that lie in each face."""

    ribbon: Ribbon
    points: list[FloatArray]
    station: dict[int, int] = field(default_factory=dict)
    done: list[Piece] = field(default_factory=list)

    def cut(self) -> None:
        """Cut the outline along every ruling that bends."""
        ahead, face = [list(range(len(self.points)))], 0
        for station in np.flatnonzero(np.abs(self.ribbon.strip.bends) > FLAT).tolist():
            behind, ahead = self._split_all(ahead, station)
            self.done += [(face, loop) for loop in behind]
            face = station
        self.done += [(face, loop) for loop in ahead]

    def _split_all(
        self, loops: list[list[int]], station: int
    ) -> tuple[list[list[int]], list[list[int]]]:
        """Loops behind and ahead of a ruling; those that it misses are behind."""
        behind, ahead = [], []
        for loop in loops:
            loop, ends = self._with_crossings(loop, station)
            if not ends:
                behind.append(loop)
                continue
            for part, is_ahead in self._split(loop, ends):
                (ahead if is_ahead else behind).append(part)
        return behind, ahead

    def _with_crossings(self, loop: list[int], station: int) -> tuple[list[int], list[int]]:
        """The loop with the points where it crosses a ruling, and these in order along it."""
        strip, ribbon = self.ribbon.strip, self.ribbon
        distance = ribbon.ahead(station, np.array([self.points[k] for k in loop]))
        side = np.where(np.abs(distance) <= _ON_LINE, 0, np.sign(distance)).astype(int)
        low, high = (level * ribbon.stretch[station] for level in (ribbon.lower, ribbon.upper))

        def along(point: FloatArray) -> float:
            return float((point - strip.flat_points[station]) @ strip.flat_rulings[station])

        longer: list[int] = []
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
        return longer, [number for _, number in sorted(found)]

    @staticmethod
    def _split(loop: list[int], ends: list[int]) -> list[tuple[list[int], bool]]:
        """Cut a loop along the chords between each second pair of points on a line.

        A counter-clockwise loop behind the line runs along its chord upwards, one ahead downwards.
        """
        parts = [(loop, True)]
        for low, high in zip(ends[::2], ends[1::2], strict=True):
            found = next(each for each in parts if low in each[0] and high in each[0])
            parts.remove(found)
            part = found[0]
            start, end = part.index(low), part.index(high)
            down, up = (part[start:] + part[:start]), (part[end:] + part[:end])
            parts += [(down[: down.index(high) + 1], True), (up[: up.index(low) + 1], False)]
        return parts


def _sides(pieces: list[list[int]], count: int) -> tuple[Side, ...]:
    """Sides of the solid: each piece on both sides of the plate, and walls along the outline."""
    sides: list[Side] = []
    edges = set()
    for loop in pieces:
        sides.append(tuple(point + count for point in loop))
        sides.append(tuple(reversed(loop)))
        edges.update(zip(loop, loop[1:] + loop[:1], strict=True))
    for start, end in sorted(edges):
        if (end, start) not in edges:
            sides.append((start, end, end + count, start + count))
    return tuple(sides)


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
