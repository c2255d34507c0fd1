"""Kinds of parts: which panels, edges and nodes of a mesh are alike, within a length or an angle.

A panel is alike another where it can be laid on it, turned but not flipped over, and no corner is
farther off than a length. Edges are alike where their lengths are. Nodes are alike where the
directions of their edges can be turned onto each other within an angle.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.option import number_within, one_of

PANELS, EDGES, NODES = "panels", "edges", "nodes"
REPEATED = (PANELS, EDGES, NODES)
# Where nothing else is said: parts of the mean edge, and degrees.
ALIKE, ALIKE_DEG = 1e-3, 0.5
# Pairs that are compared at once, and at all.
_PAIRS, _MOST_PAIRS = 100_000, 400_000
# How far parts (n, k, 3) are from others: (n,).
Miss = Callable[[FloatArray, FloatArray], FloatArray]
# Part of a tolerance by which rounding may exceed it.
_ROUNDING = 1e-9


@dataclass(frozen=True, eq=False)
class Kinds:
    """Parts in kinds.

    Attributes:
        of: panels, edges or nodes.
        kind: (N,) number of the kind of each part, the most frequent kind first; N counts faces,
            edges or vertices, and vertices of no face have -1.
        miss: (N,) how far each is from the shape of its kind: model units, degrees of nodes.
    """

    of: str
    kind: IntArray
    miss: FloatArray

    @property
    def counts(self) -> IntArray:
        """(K,) how many parts there are of each kind."""
        return np.bincount(self.kind[self.kind >= 0])

    @property
    def number(self) -> int:
        """How many kinds there are."""
        return len(self.counts)

    @property
    def worst(self) -> float:
        """Largest miss of all."""
        return float(self.miss.max(initial=0.0))


class Alike(NamedTuple):
    """Parts of one make that are compared with each other.

    Attributes:
        numbers: (n,) of faces or vertices.
        points: (n, k, 3) what must coincide: corners about their middle, or unit directions.
        turns: (t, k) orders in which the points of one may lie on those of another.
    """

    numbers: IntArray
    points: FloatArray
    turns: IntArray


def kinds_within(mesh: QuadMesh, of: str, within: float) -> Kinds:
    """Few kinds such that every part is so near to the shape of its kind.

    Lengths of edges are in as few groups as possible: none spans more than twice the tolerance, and
    the shape of a kind is the middle of its lengths. Of panels and nodes the shape of a kind is one
    of its own parts, chosen greedily: the one that most of the parts left are alike.

    Args:
        mesh: the mesh.
        of: panels, edges or nodes.
        within: the tolerance, in model units, of nodes in degrees.

    Raises:
        InputError: another word, or a tolerance that is no positive number.
    """
    refuse_unknown_parts(of)
    number_within("tolerance of kinds", within)
    if of == EDGES:
        return _lengths(mesh.edge_lengths, within)
    count = len(mesh.faces) if of == PANELS else len(mesh.vertices)
    kind, miss, before = np.full(count, -1), np.zeros(count), 0
    for alike in makes(mesh, of):
        number, far = _covered(alike, _measured(of), within)
        kind[alike.numbers], miss[alike.numbers] = number + before, far
        before += int(number.max(initial=-1)) + 1
    return Kinds(of, _by_frequency(kind), miss)


def refuse_unknown_parts(of: str) -> None:
    """Refuse a word for parts that there are not.

    Raises:
        InputError: another word than panels, edges and nodes.
    """
    one_of("repeat", of, REPEATED)


def makes(mesh: QuadMesh, of: str) -> list[Alike]:
    """Panels, or nodes with the same number of edges, ready to be compared."""
    if of == PANELS:
        corners = mesh.vertices[mesh.faces]
        turns = (np.arange(4)[:, None] + np.arange(4)) % 4
        middles = corners.mean(axis=1, keepdims=True)
        return [Alike(np.arange(len(corners)), corners - middles, turns)]
    found = []
    for hubs in spokes(mesh):
        arms = mesh.vertices[hubs.neighbours] - mesh.vertices[hubs.vertices][:, None]
        count = hubs.neighbours.shape[1]
        turns = np.arange(count)[None]
        if hubs.closed:
            turns = (np.arange(count)[:, None] + np.arange(count)) % count
        found.append(Alike(hubs.vertices, unit_rows(arms), turns))
    return found


class Hubs(NamedTuple):
    """Vertices with the same number of edges.

    Attributes:
        vertices: (n,).
        neighbours: (n, k) in their order about the vertex, counter-clockwise; at the border from
            one border edge to the other.
        closed: whether faces lie all around.
    """

    vertices: IntArray
    neighbours: IntArray
    closed: bool


def spokes(mesh: QuadMesh) -> list[Hubs]:
    """The neighbours of every vertex of a face, by their number and by whether it is inside."""
    faces, net = mesh.faces, mesh.connectivity
    # About its k-th corner a face leads from the next corner to the previous one.
    ahead = {(int(f[k]), int(f[(k + 1) % 4])): int(f[k - 1]) for f in faces for k in range(4)}
    first: dict[int, int] = {}
    for vertex, neighbour in ahead:
        first.setdefault(vertex, neighbour)
    reached = {(vertex, behind) for (vertex, _), behind in ahead.items()}
    for vertex, neighbour in ahead:
        if (vertex, neighbour) not in reached:
            first[vertex] = neighbour
    groups: dict[tuple[int, bool], list[list[int]]] = {}
    for vertex, start in first.items():
        ring, last = [start], ahead.get((vertex, start))
        while last is not None and last != start:
            ring.append(last)
            last = ahead.get((vertex, last))
        closed = not net.boundary_vertices[vertex]
        groups.setdefault((len(ring), closed), []).append([vertex, *ring])
    rows = [(np.array(sorted(group)), closed) for (_, closed), group in sorted(groups.items())]
    return [Hubs(row[:, 0], row[:, 1:], closed) for row, closed in rows]


def _lengths(lengths: FloatArray, within: float) -> Kinds:
    """As few groups as possible: the shortest that is left begins the next one."""
    order = np.argsort(lengths, kind="stable")
    kind, miss, first, number = np.zeros(len(lengths), dtype=np.int64), np.zeros(len(lengths)), 0, 0
    limit = 2 * within * (1 + _ROUNDING)
    while first < len(order):
        end = int(np.searchsorted(lengths[order], lengths[order[first]] + limit, side="right"))
        group = order[first:end]
        middle = 0.5 * (lengths[group[0]] + lengths[group[-1]])
        kind[group], miss[group] = number, np.abs(lengths[group] - middle)
        first, number = end, number + 1
    return Kinds(EDGES, _by_frequency(kind), miss)


def _measured(of: str) -> Miss:
    return corner_miss if of == PANELS else spoke_miss


def corner_miss(one: FloatArray, other: FloatArray) -> FloatArray:
    """(n,) largest distance of corners (n, k, 3) from others, laid on them as well as can be."""
    return np.asarray(np.linalg.norm(laid(one, other) - other, axis=2).max(axis=1))


def spoke_miss(one: FloatArray, other: FloatArray) -> FloatArray:
    """(n,) largest angle between unit directions (n, k, 3) turned onto others, in degrees."""
    chord = np.linalg.norm(laid(one, other) - other, axis=2).max(axis=1)
    return np.asarray(np.degrees(2 * np.arcsin(np.clip(0.5 * chord, 0.0, 1.0))))


def laid(one: FloatArray, other: FloatArray) -> FloatArray:
    """Points turned onto others by the rotation of least squares, which mirrors nothing.

    Source: Kabsch (1976), A solution for the best rotation to relate two sets of vectors.
    """
    left, _, right = np.linalg.svd(np.swapaxes(one, 1, 2) @ other)
    mirrored = np.linalg.det(left @ right) < 0
    left[mirrored, :, 2] *= -1
    return np.asarray(one @ (left @ right))


def distances(points: FloatArray) -> FloatArray:
    """(n, k (k - 1) / 2) distances between the points (n, k, 3) of each part."""
    i, j = np.triu_indices(points.shape[1], 1)
    return np.asarray(np.linalg.norm(points[:, i] - points[:, j], axis=2))


def _covered(alike: Alike, miss: Miss, within: float) -> tuple[IntArray, FloatArray]:
    """Number of the kind of each part, and its miss, by a greedy choice of shapes.

    The shape that most parts are alike comes first; where there are too many pairs to compare, as
    of thousands of equal panels, the first part that is left.
    """
    search = _Search(alike, miss, within * (1 + _ROUNDING))
    near, count = search.pairs() if search.few else [], len(alike.points)
    sizes = np.array([len(numbers) for numbers, _ in near] or [1] * count)
    kind, far, number = np.full(count, -1), np.zeros(count), 0
    while (kind < 0).any():
        # A free one: the shape of a kind is one of its own parts.
        leader = int(np.argmax(np.where(kind < 0, sizes, -1)))
        numbers, misses = near[leader] if near else search.around(leader)
        free = kind[numbers] < 0
        kind[numbers[free]], far[numbers[free]] = number, misses[free]
        for taken in numbers[free] if near else ():
            # Misses are mutual, so whoever is near to it counts one fewer.
            sizes[near[taken][0]] -= 1
        number += 1
    return kind, far


class _Search:
    """Finds parts that are alike: by the distances between their points first."""

    def __init__(self, alike: Alike, miss: Miss, limit: float) -> None:
        self._points, self._turns = alike.points, alike.turns
        self._miss, self._limit = miss, limit
        # Directions that miss by an angle are so far apart.
        chord = 2 * np.sin(0.5 * np.radians(min(limit, 180.0)))
        self._reach = 2 * (chord if miss is spoke_miss else limit) * (1 + _ROUNDING)
        self._distances = distances(alike.points)
        self._tree = cKDTree(self._distances)

    @property
    def few(self) -> bool:
        """Whether all pairs can be compared."""
        return bool(self._tree.count_neighbors(self._tree, self._reach, p=np.inf) <= _MOST_PAIRS)

    def around(self, leader: int) -> tuple[IntArray, FloatArray]:
        """Parts that are alike one, itself among them, and by how much they miss."""
        best = np.full(len(self._points), np.inf)
        for turn in self._turns:
            turned = self._points[leader][turn][None]
            near = self._tree.query_ball_point(distances(turned)[0], self._reach, p=np.inf)
            others = self._points[near]
            far = self._miss(np.broadcast_to(turned, others.shape), others)
            best[near] = np.minimum(best[near], far)
        best[leader] = 0.0
        numbers = np.flatnonzero(best <= self._limit)
        return numbers, best[numbers]

    def pairs(self) -> list[tuple[IntArray, FloatArray]]:
        """For each part what :meth:`around` finds."""
        count = len(self._points)
        one, other, far = [np.arange(count)], [np.arange(count)], [np.zeros(count)]
        for turn in self._turns:
            turned = self._points[:, turn]
            near = self._tree.query_ball_point(distances(turned), self._reach, p=np.inf)
            i = np.repeat(np.arange(count), [len(others) for others in near])
            j = np.concatenate([np.asarray(others, dtype=np.int64) for others in near])
            i, j = i[i < j], j[i < j]
            parts = range(0, len(i), _PAIRS)
            found = [
                self._miss(turned[i[k : k + _PAIRS]], self._points[j[k : k + _PAIRS]])
                for k in parts
            ]
            value = np.concatenate([*found, np.zeros(0)])
            keep = value <= self._limit
            one += [i[keep], j[keep]]
            other += [j[keep], i[keep]]
            far += [value[keep], value[keep]]
        rows, columns, values = (np.concatenate(parts) for parts in (one, other, far))
        # Of several turns that fit the one that fits best.
        order = np.lexsort((values, columns, rows))
        rows, columns, values = rows[order], columns[order], values[order]
        first = np.append(True, (np.diff(rows) != 0) | (np.diff(columns) != 0))
        ends = np.searchsorted(rows[first], np.arange(1, count))
        return list(zip(np.split(columns[first], ends), np.split(values[first], ends), strict=True))


def _by_frequency(kind: IntArray) -> IntArray:
    """The same kinds, numbered from the most frequent one on."""
    known = kind >= 0
    counts = np.bincount(kind[known])
    rank = np.empty(len(counts), dtype=np.int64)
    rank[np.argsort(-counts, kind="stable")] = np.arange(len(counts))
    result = kind.copy()
    result[known] = rank[kind[known]]
    return result
