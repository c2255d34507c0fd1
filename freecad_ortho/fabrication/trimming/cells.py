"""The cells into which a border cuts the faces of a net, and which of them are within it.

Two cells on both sides of the border are not both within; two that meet at an edge that it does not
run along are both or neither. The longest such lines are believed first. A net overhangs its
border: where it ends, it is outside.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from freecad_ortho.fabrication.trimming.course import ON_SIDE, Course
from freecad_ortho.fabrication.trimming.rays import along_side, inside_of
from solver.mesh.connectivity import BoolArray, Connectivity, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh

if TYPE_CHECKING:
    import shapely

# Shorter lines, as a part of a side, say nothing about the cells beside them.
_SHORT = 1e-9
# How far the ways of a border are led on straight, in sides of a face: beyond what is looked at.
_LONG = 100.0
# What the area of a cell counts beside the net's end, where the net has no end.
_AREA = 1e-9
_SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])


class SideStretch(NamedTuple):
    """A part of a side of a face, 0 at the side's first corner and 1 at its second."""

    side: int
    start: float
    end: float


@dataclass(frozen=True, eq=False)
class Cell:
    """A part of a face on one side of the border.

    Attributes:
        face: its number.
        polygon: in the face's (u, v); None for the whole face.
        stretches: what it has of the face's sides.
    """

    face: int
    polygon: shapely.Polygon | None
    stretches: tuple[SideStretch, ...]


_WHOLE = tuple(SideStretch(side, 0.0, 1.0) for side in range(4))


def cells_of(count: int, course: Course) -> list[Cell]:
    """Cut the faces 0 to count - 1 by the border's ways through them."""
    result = []
    for face in range(count):
        polygons = divided(course.chords.get(face, []))
        if len(polygons) < 2:
            result.append(Cell(face, None, _WHOLE))
        else:
            result += [
                Cell(face, polygon, tuple(_runs(np.array(polygon.exterior.coords))))
                for polygon in polygons
            ]
    return result


def divided(chords: Sequence[FloatArray], reach: float = 0.0) -> list[shapely.Polygon]:
    """The parts of a face, and of what lies around it, between the ways of a border.

    Args:
        chords: polylines (M, 2) in (u, v).
        reach: how far beyond the face, along (u, v).
    """
    import shapely

    lines = [line for chord in chords for line in _across(chord)]
    if not lines:
        return []
    if reach:
        lines = [_carried_on(line) for line in lines]
    ring = shapely.LinearRing(_SQUARE + reach * (2 * _SQUARE - 1))
    network = shapely.unary_union([ring, *map(shapely.LineString, lines)])
    found = shapely.get_parts(shapely.polygonize([*shapely.get_parts(network)]))
    around = shapely.Polygon(ring)
    return [part for part in found if around.covers(part.representative_point())]


def _across(chord: FloatArray) -> list[FloatArray]:
    """The stretches of a way that do not run along a side of the face."""
    breaks = np.flatnonzero(_sides_along(chord) >= 0).tolist()
    bounds = zip([0, *(place + 1 for place in breaks)], [*breaks, len(chord) - 1], strict=True)
    return [chord[start : end + 1] for start, end in bounds if end > start]


def _sides_along(line: FloatArray) -> IntArray:
    """(M - 1,) side of the face that each step of a line (M, 2) runs along, -1 for none."""
    off = np.abs(inside_of(line))
    both = np.maximum(off[:-1], off[1:])
    return np.where(both.min(axis=1) <= ON_SIDE, both.argmin(axis=1), -1)


def _runs(line: FloatArray) -> Iterable[SideStretch]:
    """The stretches of a face's sides that a line (M, 2) runs along."""
    sides = _sides_along(line)
    for step in np.flatnonzero(sides >= 0).tolist():
        side = int(sides[step])
        yield SideStretch(side, *sorted(along_side(side, line[step + k]) for k in (0, 1)))


def _carried_on(line: FloatArray) -> FloatArray:
    """A way that ends on the face's sides led straight beyond them."""
    if np.abs(line[0] - line[-1]).max() <= ON_SIDE:
        return line
    before, after = line[0] - line[1], line[-1] - line[-2]
    first = line[0] + _LONG * before / np.linalg.norm(before)
    last = line[-1] + _LONG * after / np.linalg.norm(after)
    return np.vstack([first, line, last])


def within(mesh: QuadMesh, course: Course, cells: Sequence[Cell]) -> BoolArray:
    """(C,) true for the cells that are within the border."""
    net = mesh.connectivity
    by_face: dict[int, list[int]] = {}
    for number, cell in enumerate(cells):
        by_face.setdefault(cell.face, []).append(number)
    runs = _runs_along(net, course)
    sides = _by_edge(net, cells)
    links = [*_across_border(cells, by_face), *_across_edges(net, sides, runs)]
    groups = _Sides(len(cells))
    for _, one, other, differs in sorted(links, key=lambda link: -link[0]):
        groups.link(one, other, differs)
    return groups.chosen(_votes(mesh, course, cells, by_face, sides, runs))


_Link = tuple[float, int, int, bool]
# Of each edge what its cells have of it: cell, start and end from its first vertex.
_Shares = dict[int, list[tuple[int, float, float]]]
_Runs = dict[int, list[tuple[float, float]]]


def _runs_along(net: Connectivity, course: Course) -> _Runs:
    """By edge, the stretches that the border runs along, from the edge's first vertex."""
    runs: _Runs = {}
    for face, chords in course.chords.items():
        for stretch in (run for chord in chords for run in _runs(chord)):
            edge, first, last = _on_edge(net, face, stretch)
            runs.setdefault(edge, []).append((first, last))
    return runs


def _on_edge(net: Connectivity, face: int, stretch: SideStretch) -> tuple[int, float, float]:
    """Edge of a stretch, and where on it the stretch begins and ends."""
    side, start, end = stretch
    first, second = net.faces[face, [side, (side + 1) % 4]]
    edge = int(net.face_edges[face, side])
    return (edge, start, end) if first < second else (edge, 1 - end, 1 - start)


def _by_edge(net: Connectivity, cells: Sequence[Cell]) -> _Shares:
    found: _Shares = {}
    for number, cell in enumerate(cells):
        for stretch in cell.stretches:
            edge, start, end = _on_edge(net, cell.face, stretch)
            found.setdefault(edge, []).append((number, start, end))
    return found


def spans_of(
    net: Connectivity, cells: Sequence[Cell]
) -> dict[int, tuple[tuple[float, float], ...]]:
    """By edge, the stretches that any of the cells has of it, from the edge's first vertex."""
    found = {}
    for edge, shares in _by_edge(net, cells).items():
        spans: list[tuple[float, float]] = []
        for start, end in sorted((start, end) for _, start, end in shares):
            if spans and start <= spans[-1][1] + _SHORT:
                spans[-1] = spans[-1][0], max(spans[-1][1], end)
            elif end - start > _SHORT:
                spans.append((start, end))
        if spans:
            found[edge] = tuple(spans)
    return found


def _across_border(cells: Sequence[Cell], by_face: dict[int, list[int]]) -> Iterable[_Link]:
    for numbers in by_face.values():
        for place, one in enumerate(numbers):
            for other in numbers[place + 1 :]:
                polygon, beside = cells[one].polygon, cells[other].polygon
                assert polygon is not None and beside is not None
                shared = polygon.intersection(beside).length
                if shared > _SHORT:
                    yield shared, one, other, True


def _across_edges(net: Connectivity, sides: _Shares, runs: _Runs) -> Iterable[_Link]:
    for edge, shares in sides.items():
        for place, (one, start, end) in enumerate(shares):
            for other, begins, ends in shares[place + 1 :]:
                low, high = max(start, begins), min(end, ends)
                if high - low <= _SHORT:
                    continue
                along = _covered(low, high, runs.get(edge, ()))
                for length, differs in ((high - low - along, False), (along, True)):
                    if length > _SHORT:
                        yield length, one, other, differs


def _covered(low: float, high: float, runs: Iterable[tuple[float, float]]) -> float:
    return sum(max(min(high, last) - max(low, first), 0.0) for first, last in runs)


def _votes(
    mesh: QuadMesh,
    course: Course,
    cells: Sequence[Cell],
    by_face: dict[int, list[int]],
    sides: _Shares,
    runs: _Runs,
) -> FloatArray:
    """(C,) how much speaks for each cell to be within the border.

    Where the net ends, it is outside, unless the border runs there or does not come as far.
    """
    net = mesh.connectivity
    votes = np.array([1.0 if cell.polygon is None else cell.polygon.area for cell in cells])
    votes *= _AREA
    for edge in np.flatnonzero(net.boundary_edges).tolist():
        for cell, start, end in sides.get(edge, ()):
            votes[cell] += 2 * _covered(start, end, runs.get(edge, ())) - (end - start)
    for miss in course.beyond:
        share = miss.length / mesh.edge_lengths[net.face_edges[miss.face, miss.side]]
        for cell in by_face[miss.face]:
            if any(
                side == miss.side and start <= miss.place <= end
                for side, start, end in cells[cell].stretches
            ):
                votes[cell] += 2 * share
                break
    return votes


class _Sides:
    """Cells of which it is known whether they are on the same side of the border."""

    def __init__(self, count: int) -> None:
        self._above = list(range(count))
        self._differs = [False] * count

    def _root(self, cell: int) -> tuple[int, bool]:
        way, differs = [], False
        while self._above[cell] != cell:
            way.append(cell)
            cell = self._above[cell]
        # The next time it is one step.
        for passed in reversed(way):
            differs ^= self._differs[passed]
            self._above[passed], self._differs[passed] = cell, differs
        return cell, differs

    def link(self, one: int, other: int, differs: bool) -> None:
        """Note that two cells are on one side, or not, where that is not known yet."""
        (first, turned), (second, back) = self._root(one), self._root(other)
        if first != second:
            self._above[second], self._differs[second] = first, turned ^ back ^ differs

    def chosen(self, votes: FloatArray) -> BoolArray:
        """(C,) the side of each group that is voted for; all of a group that nothing cuts."""
        roots = [self._root(cell) for cell in range(len(votes))]
        total: dict[int, float] = {}
        cut: set[int] = set()
        for (root, differs), vote in zip(roots, votes.tolist(), strict=True):
            total[root] = total.get(root, 0.0) + (-vote if differs else vote)
            if differs:
                cut.add(root)
        return np.array(
            [root not in cut or (total[root] > 0) != differs for root, differs in roots]
        )
