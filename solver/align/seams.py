"""Coordinates of a map that fits across its cut, by as few unknowns as there are.

Across a cut edge coordinates are turned by quarters and shifted by whole numbers. Every corner's
coordinates then follow from one pair for each vertex, and from whole numbers: the places of
singular vertices, and shifts round openings. What shifts there must be along a branch follows from
going round each vertex of the cut once, from the ends of a tree to its roots at the border.

Source: Bommes, Zimmer, Kobbelt (2009), Mixed-integer quadrangulation.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csr_array

from solver.align.cut import Cut
from solver.align.triangle_mesh import TriangleMesh, components, following
from solver.mesh.connectivity import BoolArray, IntArray

# Matrices of 0 to 3 quarter turns.
TURNS = np.array([[[1, 0], [0, 1]], [[0, -1], [1, 0]], [[-1, 0], [0, -1]], [[0, 1], [-1, 0]]])

# A shift or a place as a sum of whole unknowns: number of the unknown -> (2, 2) matrix.
Sum = dict[int, IntArray]


@dataclass(frozen=True, eq=False)
class SeamMap:
    """Coordinates of corners from unknowns.

    Attributes:
        copies: (T, 3) number of the pair of coordinates of each corner.
        matrix: (2 C, 2 R + 2 W) coordinates of the copies from the unknowns: first R pairs that may
            be anything, then W pairs of whole numbers.
        vertices: (R,) the vertex of each of the first pairs.
        wholes: W.
        places: which of the whole pairs are places of singular vertices.
    """

    copies: IntArray
    matrix: csr_array
    vertices: IntArray
    wholes: int
    places: list[int]

    @property
    def reals(self) -> int:
        """R."""
        return len(self.vertices)


def seams(mesh: TriangleMesh, cut: Cut, singular: BoolArray) -> SeamMap:
    """Lay out the unknowns of a map.

    Args:
        mesh: the surface.
        cut: where its directions do not agree.
        singular: (V,) inner vertices that come to whole coordinates.
    """
    copies = _copies(mesh, cut)
    links = _links(mesh, cut, copies)
    order, parents = _tree(mesh, cut, links)
    taken = set(parents.values())
    shifts = [edge for edge in np.flatnonzero(cut.edges).tolist() if edge not in taken]
    places = [vertex for vertex in order if singular[vertex]]
    number = {vertex: len(shifts) + k for k, vertex in enumerate(places)}
    known: dict[int, Sum] = {edge: {k: TURNS[0]} for k, edge in enumerate(shifts)}
    rules: dict[int, tuple[int, int, Sum]] = {}
    for vertex in reversed(order):
        found = _round(links[vertex], cut, known)
        known[parents[vertex]] = _closing(
            links[vertex], parents[vertex], cut, found, number.get(vertex)
        )
        rules |= {copy: (vertex, *rule) for copy, rule in found.items()}
    for vertex, joined in links.items():
        if mesh.on_rim[vertex]:
            found = _round(joined, cut, known)
            rules |= {copy: (vertex, *rule) for copy, rule in found.items()}
    wholes = len(shifts) + len(places)
    matrix, vertices = _matrix(mesh, copies, rules, number, wholes)
    return SeamMap(copies, matrix, vertices, wholes, list(number.values()))


def _copies(mesh: TriangleMesh, cut: Cut) -> IntArray:
    one, two = mesh.edges[~cut.edges].T
    label = components(
        3 * len(mesh.triangles),
        np.concatenate([one, following(one)]),
        np.concatenate([following(two), two]),
    )
    return label.reshape(-1, 3)


# Copies of a vertex at either side of a cut edge, and the edge.
Link = tuple[int, int, int]


def _links(mesh: TriangleMesh, cut: Cut, copies: IntArray) -> dict[int, list[Link]]:
    """Vertex -> its copies on both sides of each cut edge there."""
    flat, found = copies.ravel(), dict[int, list[Link]]()
    start, end = mesh.ends
    for edge in np.flatnonzero(cut.edges).tolist():
        one, two = (int(half) for half in mesh.edges[edge])
        sides = (
            (int(start[edge]), one, int(following(np.array(two)))),
            (int(end[edge]), int(following(np.array(one))), two),
        )
        for vertex, first, second in sides:
            found.setdefault(vertex, []).append((int(flat[first]), int(flat[second]), edge))
    return found


def _tree(
    mesh: TriangleMesh, cut: Cut, links: dict[int, list[Link]]
) -> tuple[list[int], dict[int, int]]:
    """Inner vertices of the cut from the border inwards, and the edge by which each is reached."""
    start, end = (side.tolist() for side in mesh.ends)
    order: list[int] = []
    parents: dict[int, int] = {}

    def reach(edge: int, vertex: int) -> None:
        if not mesh.on_rim[vertex] and vertex not in parents:
            parents[vertex] = edge
            order.append(vertex)

    for vertex, joined in links.items():
        if mesh.on_rim[vertex]:
            for _, _, edge in joined:
                reach(edge, end[edge] if start[edge] == vertex else start[edge])
    for vertex in order:
        for _, _, edge in links[vertex]:
            if edge != parents[vertex]:
                reach(edge, end[edge] if start[edge] == vertex else start[edge])
    return order, parents


def _plus(one: Sum, two: Sum, turned: IntArray) -> Sum:
    """``one`` plus ``turned`` times ``two``."""
    found = dict(one)
    for key, block in two.items():
        found[key] = found.get(key, 0 * block) + turned @ block
    return {key: block for key, block in found.items() if block.any()}


def _round(joined: list[Link], cut: Cut, known: dict[int, Sum]) -> dict[int, tuple[int, Sum]]:
    """Copies of a vertex as turns and shifts of the first, over the edges that are known."""
    first = joined[0][0]
    found: dict[int, tuple[int, Sum]] = {first: (0, {})}
    todo = [first]
    while todo:
        here = todo.pop()
        turn, shift = found[here]
        for one, two, edge in joined:
            if edge not in known:
                continue
            by = int(cut.turns[edge])
            if one == here and two not in found:
                found[two] = (turn + by) % 4, _plus(known[edge], shift, TURNS[by])
                todo.append(two)
            elif two == here and one not in found:
                back = _plus({}, _plus(shift, known[edge], -TURNS[0]), TURNS[-by % 4])
                found[one] = (turn - by) % 4, back
                todo.append(one)
    return found


def _closing(
    joined: list[Link],
    edge: int,
    cut: Cut,
    found: dict[int, tuple[int, Sum]],
    place: int | None,
) -> Sum:
    """The shift over the last edge at a vertex, so that going round it leads back."""
    one, two, _ = next(link for link in joined if link[2] == edge)
    (turn_one, shift_one), (turn_two, shift_two) = found[one], found[two]
    by = TURNS[cut.turns[edge]]
    shift = _plus(shift_two, shift_one, -by)
    missed = TURNS[turn_two] - by @ TURNS[turn_one]
    return shift if place is None else _plus(shift, {place: TURNS[0]}, missed)


def _matrix(
    mesh: TriangleMesh,
    copies: IntArray,
    rules: dict[int, tuple[int, int, Sum]],
    number: dict[int, int],
    wholes: int,
) -> tuple[csr_array, IntArray]:
    count = int(copies.max()) + 1
    vertices = np.empty(count, dtype=np.int64)
    vertices[copies] = mesh.triangles
    free = np.ones(len(mesh.points), dtype=bool)
    free[list(number)] = False
    column = np.cumsum(free) - 1
    reals = int(free.sum())
    for vertex, place in number.items():
        column[vertex] = reals + place
    plain = np.ones(count, dtype=bool)
    plain[list(rules)] = False
    alone = np.flatnonzero(plain)
    entries = [
        np.stack([2 * alone + k, 2 * column[vertices[alone]] + k, 0 * alone + 1]) for k in (0, 1)
    ]
    some = []
    for copy, (vertex, turn, shift) in rules.items():
        blocks = [(int(column[vertex]), TURNS[turn])]
        blocks += [(reals + key, block) for key, block in shift.items()]
        some += [
            (2 * copy + x, 2 * at + y, int(block[x, y]))
            for at, block in blocks
            for x in (0, 1)
            for y in (0, 1)
            if block[x, y]
        ]
    if some:
        entries.append(np.array(some).T)
    rows, columns, values = np.concatenate(entries, axis=1)
    shape = (2 * count, 2 * (reals + wholes))
    return coo_array((values.astype(float), (rows, columns)), shape=shape).tocsr(), np.flatnonzero(
        free
    )
