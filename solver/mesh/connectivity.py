"""Connectivity of a quad mesh: who is next to whom, without any positions.

Everything here depends on the faces alone, is computed at most once, and never changes. What does
not need four corners a face is inherited by :mod:`solver.mesh.mixed`.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from solver.errors import InputError
from solver.mesh.groups import BoolArray, IntArray, SameSize, components_of

__all__ = ["BoolArray", "Connectivity", "IntArray", "SameSize"]


class Connectivity:
    """Faces of a quad mesh and all that follows from them; immutable.

    A half-edge ``4 * f + k`` runs from corner ``k`` of face ``f`` to the next corner.

    Args:
        faces: (F, 4) vertex numbers, counter-clockwise, consistently oriented.
        vertex_count: number of vertices V; vertices that no face uses are allowed.

    Raises:
        InputError: a vertex number is out of range, a face repeats a vertex, or an edge
            has more than two faces or two faces of opposite orientation.
    """

    def __init__(self, faces: IntArray, vertex_count: int) -> None:
        faces = np.ascontiguousarray(faces, dtype=np.int64)
        if faces.ndim != 2 or faces.shape[1] != 4 or len(faces) == 0:
            raise InputError(
                f"faces: expected an array of shape (F, 4) with F > 0, got {faces.shape}; "
                "give quads only"
            )
        faces.setflags(write=False)
        self.check_corners(faces, vertex_count)
        self._faces, self._vertex_count = faces, vertex_count
        self.refuse_double_edges()

    @property
    def faces(self) -> IntArray:
        """(F, 4) vertex numbers, counter-clockwise."""
        return self._faces

    @property
    def vertex_count(self) -> int:
        """V, number of vertices."""
        return self._vertex_count

    def refuse_double_edges(self) -> None:
        """Refuse edges with more than two faces or two of opposite orientation.

        Raises:
            InputError: naming the first.
        """
        key = self.half_edges[:, 0] * self.vertex_count + self.half_edges[:, 1]
        unique, counts = np.unique(key, return_counts=True)
        if (counts > 1).any():
            bad = int(unique[np.argmax(counts > 1)])
            raise InputError(
                f"edges: edge {bad // self.vertex_count} - {bad % self.vertex_count} is used twice "
                "in the same direction; unify the orientation and remove double faces"
            )

    @staticmethod
    def check_corners(faces: IntArray, vertex_count: int) -> None:
        """Refuse (F, 4) faces that name vertices which do not exist, or one vertex twice.

        Raises:
            InputError: naming the first such face.
        """
        out_of_range = ((faces < 0) | (faces >= vertex_count)).any(axis=1)
        if out_of_range.any():
            face = int(np.argmax(out_of_range))
            raise InputError(
                f"faces: face {face} names vertices {faces[face].tolist()}, but vertices are "
                f"numbered 0 to {vertex_count - 1}; mend the face or add the vertices"
            )
        ordered = np.sort(faces, axis=1)
        repeated = (ordered[:, 1:] == ordered[:, :-1]).any(axis=1)
        if repeated.any():
            face = int(np.argmax(repeated))
            raise InputError(
                f"faces: {int(repeated.sum())} repeat a vertex, the first is face {face} "
                f"{faces[face].tolist()}; split or delete it"
            )

    @property
    def mixed(self) -> bool:
        """Whether some faces have other than four corners."""
        return False

    @property
    def face_count(self) -> int:
        """F, number of faces."""
        return len(self.faces)

    @property
    def quads(self) -> IntArray:
        """(Q, 4) the faces that have four corners."""
        return self.faces

    @property
    def polygons(self) -> list[list[int]]:
        """Vertices of each face, counter-clockwise."""
        found: list[list[int]] = self.faces.tolist()
        return found

    @property
    def face_sizes(self) -> IntArray:
        """(F,) number of corners of each face."""
        return np.full(self.face_count, 4, dtype=np.int64)

    @property
    def by_size(self) -> tuple[SameSize, ...]:
        """Faces with the same number of corners, together."""
        every = np.arange(self.face_count)
        return (SameSize(every, self.faces, np.arange(4 * len(every)).reshape(-1, 4)),)

    @property
    def flat_quads(self) -> IntArray:
        """(P, 4) corners that have to lie in a plane each for all faces to be flat."""
        return self.faces

    @property
    def flat_quads_faces(self) -> IntArray:
        """(P,) the face of each of them."""
        return np.arange(self.face_count)

    @property
    def triangles(self) -> IntArray:
        """(T, 3) the faces cut into triangles, in the order of the faces."""
        return self.faces[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)

    @cached_property
    def half_faces(self) -> IntArray:
        """(H,) the face of each half-edge."""
        return np.repeat(np.arange(self.face_count), self.face_sizes)

    @cached_property
    def following(self) -> IntArray:
        """(H,) the half-edge that follows each half-edge around its face."""
        return self._next(np.arange(len(self.half_edges)))

    def _next(self, half: IntArray) -> IntArray:
        """The half-edge that follows each half-edge around its face."""
        return half - half % 4 + (half + 1) % 4

    def _previous(self, half: IntArray) -> IntArray:
        return half - half % 4 + (half + 3) % 4

    @cached_property
    def half_edges(self) -> IntArray:
        """(H, 2) start and end vertex of every half-edge; H is 4F where all faces are quads."""
        return np.stack([self.faces, np.roll(self.faces, -1, axis=1)], axis=2).reshape(-1, 2)

    @cached_property
    def twins(self) -> IntArray:
        """(4F,) the opposite half-edge of each half-edge, -1 at the boundary."""
        start, end = self.half_edges.T
        forward = start * self.vertex_count + end
        backward = end * self.vertex_count + start
        order = np.argsort(forward)
        place = np.searchsorted(forward, backward, sorter=order)
        candidate = order[np.minimum(place, len(order) - 1)]
        return np.where(forward[candidate] == backward, candidate, -1)

    @cached_property
    def _edge_table(self) -> tuple[IntArray, IntArray]:
        pairs = np.sort(self.half_edges, axis=1)
        edges, inverse = np.unique(pairs, axis=0, return_inverse=True)
        return edges, inverse.ravel()

    @property
    def edges(self) -> IntArray:
        """(E, 2) vertex pairs, the smaller number first, in lexicographic order."""
        return self._edge_table[0]

    @property
    def face_edges(self) -> IntArray:
        """(F, 4) edge number of each side; side k joins corners k and k + 1."""
        return self.half_edge_edges.reshape(self.faces.shape)

    @property
    def half_edge_edges(self) -> IntArray:
        """(H,) edge number of each half-edge."""
        return self._edge_table[1]

    @cached_property
    def edge_faces(self) -> IntArray:
        """(E, 2) faces left and right of each edge seen from its smaller vertex, -1 for none."""
        result = np.full((len(self.edges), 2), -1, dtype=np.int64)
        start, end = self.half_edges.T
        side = (start > end).astype(np.int64)
        result[self.half_edge_edges, side] = self.half_faces
        return result

    @cached_property
    def boundary_edges(self) -> BoolArray:
        """(E,) true where an edge has one face only."""
        return np.asarray((self.edge_faces < 0).any(axis=1))

    @cached_property
    def boundary_vertices(self) -> BoolArray:
        """(V,) true where a vertex lies on a boundary edge."""
        result = np.zeros(self.vertex_count, dtype=bool)
        result[self.edges[self.boundary_edges].ravel()] = True
        return result

    @cached_property
    def referenced(self) -> BoolArray:
        """(V,) true where at least one face uses the vertex."""
        result = np.zeros(self.vertex_count, dtype=bool)
        result[self.half_edges[:, 0]] = True
        return result

    @cached_property
    def face_valence(self) -> IntArray:
        """(V,) number of faces at each vertex."""
        return np.bincount(self.half_edges[:, 0], minlength=self.vertex_count)

    @cached_property
    def edge_valence(self) -> IntArray:
        """(V,) number of edges at each vertex."""
        return np.bincount(self.edges.ravel(), minlength=self.vertex_count)

    @cached_property
    def regular(self) -> BoolArray:
        """(V,) true where parameter lines pass: four faces inside, two faces on the boundary."""
        boundary = self.boundary_vertices
        inside = ~boundary & (self.face_valence == 4)
        rim = boundary & (self.face_valence == 2) & (self.edge_valence == 3)
        return np.asarray(inside | rim)

    @cached_property
    def singular(self) -> BoolArray:
        """(V,) true inside the mesh where more or fewer than four faces meet."""
        return self.referenced & ~self.boundary_vertices & ~self.regular

    @cached_property
    def singular_faces(self) -> BoolArray:
        """(F,) true where a corner of a face is a singular vertex."""
        return np.bincount(
            self.half_faces, self.singular[self.half_edges[:, 0]], self.face_count
        ).astype(bool)

    @cached_property
    def singular_stars(self) -> BoolArray:
        """(S,) true where a neighbour of a star's centre is a singular vertex."""
        return np.asarray(self.singular[self.stars[:, 1:]].any(axis=1))

    @cached_property
    def corners(self) -> BoolArray:
        """(V,) boundary vertices where no parameter line runs along the boundary."""
        return self.boundary_vertices & ~self.regular

    @cached_property
    def continuation(self) -> IntArray:
        """(4F,) the half-edge that goes straight on at the end of each half-edge, or -1."""
        after = self.following
        across = self.twins[after]
        straight = np.where(across >= 0, self._next(across), -1)
        return np.where(self.regular[self.half_edges[:, 1]], straight, -1)

    @cached_property
    def boundary_loops(self) -> tuple[IntArray, ...]:
        """Vertices of each boundary loop in order; loops may touch, but do not cross."""
        half = np.flatnonzero(self.twins < 0)
        onward = self._next(half)
        while (inner := self.twins[onward] >= 0).any():
            onward[inner] = self._next(self.twins[onward[inner]])
        start = self.half_edges[:, 0]
        after = dict(zip(half.tolist(), onward.tolist(), strict=True))
        return tuple(start[loop] for loop in cycles(after))

    @cached_property
    def line_triples(self) -> IntArray:
        """(T, 3) consecutive vertices left, centre, right on a parameter line, each once."""
        here = np.flatnonzero(self.continuation >= 0)
        left, centre = self.half_edges[here].T
        right = self.half_edges[self.continuation[here], 1]
        triples = np.stack([np.minimum(left, right), centre, np.maximum(left, right)], axis=1)
        return np.unique(triples, axis=0)

    @cached_property
    def line_quadruples(self) -> IntArray:
        """(Q, 4) four consecutive vertices on a parameter line, each once."""
        first = np.flatnonzero(self.continuation >= 0)
        second = self.continuation[first]
        longer = self.continuation[second] >= 0
        ends = self.half_edges[self.continuation[second[longer]], 1]
        lines = np.column_stack(
            [self.half_edges[first[longer]], self.half_edges[second[longer], 1], ends]
        )
        backward = lines[:, 0] > lines[:, 3]
        lines[backward] = lines[backward, ::-1]
        return np.unique(lines, axis=0)

    @cached_property
    def face_pairs(self) -> IntArray:
        """(P, 4) outer corners a, c, b, d of each pair of neighbouring faces.

        ``a - c`` and ``b - d`` are the diagonals of the one-by-two rectangle.
        """
        half = np.flatnonzero((self.twins >= 0) & (self.twins > np.arange(4 * len(self.faces))))
        twin = self.twins[half]
        d = self.half_edges[self._next(half), 1]
        a = self.half_edges[self._next(self._next(half)), 1]
        e = self.half_edges[self._next(twin), 1]
        f = self.half_edges[self._next(self._next(twin)), 1]
        return np.stack([a, f, d, e], axis=1)

    def rectangles(self, rows: int, columns: int) -> IntArray:
        """(P, 4) corners, in cyclic order, of all rectangles of ``rows`` x ``columns`` faces.

        Walks along parameter lines and keeps the walks that come back to where they began. Each
        rectangle is found from two corners, a square one from four; one of them is kept.
        """
        half = np.arange(4 * len(self.faces))
        begin, corners = half, []
        for count in (rows, columns, rows, columns):
            corners.append(np.where(half >= 0, self.half_edges[half, 0], -1))
            for _ in range(count - 1):
                half = np.where(half >= 0, self.continuation[half], -1)
            half = self._turned(half)
        found = np.stack(corners, axis=1)[(half == begin) & (half >= 0)]
        rival = found[:, 1:] if rows == columns else found[:, 2:3]
        return np.asarray(found[found[:, 0] < rival.min(axis=1)])

    def _turned(self, half: IntArray) -> IntArray:
        """Half-edge that turns left, inside the rectangle, at the end of each half-edge."""
        return np.where(half >= 0, self._next(half), -1)

    @cached_property
    def stars(self) -> IntArray:
        """(S, 5) centre and its four neighbours in cyclic order, interior valence four only."""
        return self._stars_and_corners[0]

    @cached_property
    def diagonal_stars(self) -> IntArray:
        """(S, 5) centre and the four opposite corners of its faces, in the order of ``stars``."""
        return self._stars_and_corners[1]

    @cached_property
    def _stars_and_corners(self) -> tuple[IntArray, IntArray]:
        centres = np.flatnonzero(self.regular & ~self.boundary_vertices)
        outgoing = np.full(self.vertex_count, -1, dtype=np.int64)
        outgoing[self.half_edges[::-1, 0]] = np.arange(4 * len(self.faces))[::-1]
        half = outgoing[centres]
        star, diagonal = [centres], [centres]
        for _ in range(4):
            star.append(self.half_edges[half, 1])
            diagonal.append(self.half_edges[self._next(half), 1])
            half = self.twins[self._previous(half)]
        return np.stack(star, axis=1), np.stack(diagonal, axis=1)

    @cached_property
    def edge_families(self) -> IntArray:
        """(E,) number of the family of parameter lines that each edge belongs to.

        Opposite edges of a face share a family, and so do edges in line at a regular vertex. A grid
        has two; irregular vertices can join them into one.
        """
        sides = self.face_edges
        half = np.flatnonzero(self.continuation >= 0)
        edge_of = sides.ravel()
        one = np.concatenate([sides[:, 0], sides[:, 1], edge_of[half]])
        two = np.concatenate([sides[:, 2], sides[:, 3], edge_of[self.continuation[half]]])
        count = len(self.edges)
        return components_of(one, two, count)

    @cached_property
    def diagonal_edges(self) -> IntArray:
        """(2F, 2) ends of the face diagonals: of face f numbers 2f and 2f + 1."""
        return self.faces[:, [0, 2, 1, 3]].reshape(-1, 2)

    @cached_property
    def components(self) -> IntArray:
        """(F,) number of the connected component of each face."""
        left, right = self.edge_faces[~self.boundary_edges].T
        return components_of(left, right, self.face_count)


def cycles(after: dict[int, int]) -> list[list[int]]:
    """Items in the order in which each is followed by another; the given table is emptied."""
    found = []
    while after:
        first = next(iter(after))
        cycle, here = [first], after.pop(first)
        while here != first:
            cycle.append(here)
            here = after.pop(here)
        found.append(cycle)
    return found
