"""The flat pattern of a patch: outline, parameter lines, names of lines and neighbours."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

import numpy as np

from freecad_ortho.fabrication.pattern import FlatPattern, Mark, fitted_text_size, overlaps_itself
from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.patches.pieces import NetPiece
from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.grid import Grid, grid_of
from solver.mesh.quadmesh import FloatArray
from solver.unroll.patch import FlatPatch


def patch_pattern(
    site: Site, piece: NetPiece, patch: FlatPatch, piece_of_face: Mapping[int, str]
) -> FlatPattern:
    """Return the flat pattern of a piece.

    Args:
        site: of the net.
        piece: that is laid flat.
        patch: the piece in space and in the plane.
        piece_of_face: name of the piece that each face of the net belongs to.

    Raises:
        InputError: the pattern overlaps itself.
    """
    grid = grid_of(patch.flat)
    points = patch.flat.vertices[:, :2]
    around = grid.outline
    outline = points[around]
    if overlaps_itself(outline):
        raise InputError(
            f"patches: laid flat {piece.name} overlaps itself; cut it along parameter lines by "
            "family and lines"
        )
    low = outline.min(axis=0)
    points = points - low
    writer = _Writer(site, piece, points)
    marks = [*writer.lines(grid), *writer.neighbours(around, piece_of_face)]
    rows, columns = (count // 2 for count in grid.numbers.shape)
    middle = points[grid.numbers[rows - 1 : rows + 1, columns - 1 : columns + 1]].reshape(-1, 2)
    box = np.ptp(middle, axis=0)
    size = fitted_text_size(piece.name, *(0.9 * box).tolist())
    label = middle.mean(axis=0)
    return FlatPattern(points[around], tuple(marks), label, size, seen="above")


class _Writer:
    """Engraves the lines of a piece and the names beside them."""

    def __init__(self, site: Site, piece: NetPiece, points: FloatArray) -> None:
        self.site, self.piece, self.points = site, piece, points
        edges = site.mesh.connectivity.edges
        self.edge = {pair: number for number, pair in enumerate(map(tuple, edges.tolist()))}
        self.room = 0.3 * piece.mesh.mean_edge

    def lines(self, grid: Grid) -> Iterator[Mark]:
        """All inner parameter lines, the name of each in the middle of its first edge."""
        number = grid.numbers
        for line in (*number.T[1:-1], *number[1:-1]):
            path = self.points[line]
            for step in pairwise(path):
                yield Mark(np.stack(step))
            edge = self._edge(int(line[0]), int(line[1]))
            family = self.site.edge_family[edge].upper()
            name = f"{family}{int(self.site.lines.edge_line[edge]):03d}"
            yield self._beside(path[0], path[1], name, 8.0)

    def neighbours(self, around: IntArray, piece_of_face: Mapping[int, str]) -> Iterator[Mark]:
        """The name of each neighbour in the middle of the cut that it shares."""
        ends = np.roll(around, -1)
        beyond = [self._beyond(*pair) for pair in zip(around.tolist(), ends.tolist(), strict=True)]
        names = [piece_of_face.get(face, "") for face in beyond]
        for name in sorted(set(names) - {""}):
            places = [place for place, other in enumerate(names) if other == name]
            place = places[len(places) // 2]
            yield self._beside(self.points[around[place]], self.points[ends[place]], name, 12.0)

    def _beyond(self, start: int, end: int) -> int:
        """Face of the net beyond an edge on the outline, -1 for none."""
        faces = self.site.mesh.connectivity.edge_faces[self._edge(start, end)]
        vertices = self.piece.vertices
        return int(faces[1 if vertices[start] < vertices[end] else 0])

    def _edge(self, start: int, end: int) -> int:
        one, two = self.piece.vertices[[start, end]].tolist()
        return self.edge[min(one, two), max(one, two)]

    def _beside(self, start: FloatArray, end: FloatArray, text: str, largest: float) -> Mark:
        """A text on the left of an edge, along it."""
        step = end - start
        length = float(np.linalg.norm(step))
        size = fitted_text_size(text, 0.6 * length, self.room, largest)
        place = 0.5 * (start + end) + size * np.array([-step[1], step[0]]) / length
        return Mark(place[None], text, size, float(np.degrees(np.arctan2(step[1], step[0]))))
