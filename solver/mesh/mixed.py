"""Connectivity of a mesh whose faces have any number of corners.

What only quads have, parameter lines across faces, diagonals, rectangles, is refused in one line by
whatever asks for it: everything of that kind begins with ``faces``.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import NoReturn

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import Connectivity
from solver.mesh.groups import IntArray, SameSize


class MixedConnectivity(Connectivity):
    """Faces of three or more corners each and what follows from them.

    Args:
        polygons: vertex numbers of each face, counter-clockwise, consistently oriented.
        vertex_count: number of vertices V; vertices that no face uses are allowed.

    Raises:
        InputError: a vertex number is out of range, a face has fewer than three corners or repeats
            a vertex, or an edge has more than two faces or two of opposite orientation.
    """

    def __init__(self, polygons: Sequence[Sequence[int]], vertex_count: int) -> None:
        refuse_bad_polygons(polygons, vertex_count)
        sizes = np.array([len(polygon) for polygon in polygons], dtype=np.int64)
        flat = np.array([corner for polygon in polygons for corner in polygon], dtype=np.int64)
        for values in (sizes, flat):
            values.setflags(write=False)
        self._vertex_count, self._sizes, self._corners = vertex_count, sizes, flat
        self.refuse_double_edges()

    def __repr__(self) -> str:
        """How many faces there are of which kind."""
        return f"MixedConnectivity({words_of_sizes(self.face_sizes)})"

    @property
    def faces(self) -> IntArray:
        """Refused: faces of different sizes are no array.

        Raises:
            InputError: saying what they are and what to do.
        """
        self.refuse("faces")

    def refuse(self, what: str) -> NoReturn:
        """Refuse faces of several sizes.

        Args:
            what: that needs quads.

        Raises:
            InputError: saying what they are and what to do.
        """
        first = int(np.argmax(self.face_sizes != 4))
        raise InputError(
            f"{what}: expected 4 vertices a face, found {words_of_sizes(self.face_sizes)}; face "
            f"{first} has {self.face_sizes[first]}; make quads of them first ('quads', in FreeCAD "
            "'Quads from triangles'), or stay with what takes faces of any size: the net planar, "
            "check, panels and beams"
        )

    @property
    def mixed(self) -> bool:
        """True."""
        return True

    @property
    def face_count(self) -> int:
        """F, number of faces."""
        return len(self.face_sizes)

    @property
    def face_sizes(self) -> IntArray:
        """(F,) number of corners of each face."""
        return self._sizes

    @cached_property
    def first_half(self) -> IntArray:
        """(F,) the half-edge that begins at each face's first corner."""
        return np.concatenate([[0], np.cumsum(self.face_sizes)[:-1]])

    @cached_property
    def half_edges(self) -> IntArray:
        """(H, 2) start and end vertex of every half-edge."""
        start = self._corners
        return np.stack([start, start[self._next(np.arange(len(start)))]], axis=1)

    @property
    def polygons(self) -> list[list[int]]:
        """Vertices of each face, counter-clockwise."""
        parts = np.split(self.half_edges[:, 0], self.first_half[1:])
        return [part.tolist() for part in parts]

    @cached_property
    def by_size(self) -> tuple[SameSize, ...]:
        """Faces with the same number of corners, together, the smallest first."""
        found = []
        for size in np.unique(self.face_sizes).tolist():
            numbers = np.flatnonzero(self.face_sizes == size)
            half = self.first_half[numbers][:, None] + np.arange(size)
            found.append(SameSize(numbers, self.half_edges[half, 0], half))
        return tuple(found)

    @property
    def quads(self) -> IntArray:
        """(Q, 4) the faces that have four corners."""
        return next(
            (group.faces for group in self.by_size if group.faces.shape[1] == 4),
            np.zeros((0, 4), dtype=np.int64),
        )

    @property
    def flat_quads(self) -> IntArray:
        """(P, 4) corners that have to lie in a plane each for all faces to be flat.

        Four in a row, from each corner of a face on: a triangle has none, a quad one.
        """
        return self._flat_quads[0]

    @property
    def flat_quads_faces(self) -> IntArray:
        """(P,) the face of each of them."""
        return self._flat_quads[1]

    @cached_property
    def _flat_quads(self) -> tuple[IntArray, IntArray]:
        corners, owners = [np.zeros((0, 4), dtype=np.int64)], [np.zeros(0, dtype=np.int64)]
        for group in self.by_size:
            size = group.faces.shape[1]
            if size == 3:
                continue
            starts = 1 if size == 4 else size
            rows = (np.arange(starts)[:, None] + np.arange(4)) % size
            corners.append(group.faces[:, rows].reshape(-1, 4))
            owners.append(np.repeat(group.numbers, starts))
        return np.concatenate(corners), np.concatenate(owners)

    @cached_property
    def triangles(self) -> IntArray:
        """(T, 3) the faces cut into triangles from their first corners, in the order of faces."""
        half = np.arange(len(self.half_edges))
        first = self.first_half[self.half_faces]
        inner = (half > first) & (half < first + self.face_sizes[self.half_faces] - 1)
        start = self.half_edges[:, 0]
        return np.column_stack([start[first[inner]], self.half_edges[inner]])

    def _next(self, half: IntArray) -> IntArray:
        first, size = self._around(half)
        return np.asarray(first + (half - first + 1) % size)

    def _previous(self, half: IntArray) -> IntArray:
        first, size = self._around(half)
        return np.asarray(first + (half - first - 1) % size)

    def _around(self, half: IntArray) -> tuple[IntArray, IntArray]:
        """First half-edge of the face of each half-edge, and how many it has."""
        face = self.half_faces[half]
        return self.first_half[face], self.face_sizes[face]


def words_of_sizes(sizes: IntArray) -> str:
    """How many faces have how many corners, as "5 triangles, 90 quads, 2 of 5 corners"."""
    said = []
    for size, count in zip(
        *(part.tolist() for part in np.unique(sizes, return_counts=True)), strict=True
    ):
        name = {3: "triangle", 4: "quad"}.get(size)
        said.append(f"{count} {name}{'s' * (count > 1)}" if name else f"{count} of {size} corners")
    return ", ".join(said)


def refuse_bad_polygons(polygons: Sequence[Sequence[int]], vertex_count: int) -> None:
    """Refuse faces with too few corners, that name missing vertices, or one vertex twice.

    Raises:
        InputError: naming the first such face.
    """
    if not len(polygons):
        raise InputError("faces: expected at least one, got none; export the mesh's faces")
    for face, polygon in enumerate(polygons):
        if len(polygon) < 3:
            raise InputError(f"faces: face {face} has fewer than 3 corners; delete it")
        if len(set(polygon)) < len(polygon):
            raise InputError(f"faces: face {face} {list(polygon)} repeats a vertex; split it")
        if min(polygon) < 0 or max(polygon) >= vertex_count:
            raise InputError(
                f"faces: face {face} names vertices {list(polygon)}, but vertices are numbered 0 "
                f"to {vertex_count - 1}; mend the face or add the vertices"
            )
