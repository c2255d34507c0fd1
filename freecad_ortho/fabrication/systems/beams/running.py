"""Which beams run through at each vertex, and at which ones stars of plates hold all of them.

Where a net has two families of lines, those of one run through those of the other. A net with
irregular vertices mostly has none: around three or five faces what is along becomes across. There
the edges at each vertex are of two kinds in turn, and those of one kind run through. From vertex to
vertex an edge keeps its kind wherever it can; from an irregular vertex a row of edges has to go out
that change it, to another one or to the boundary: beams that run through at one end and give way
at the other. At irregular vertices lines end, and a star of plates joins them.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.lines import ParameterLines

# Vertices from which kinds are spread, one after the other.
_STARTS = 8
# How often all vertices beside edges of two kinds are gone through, at most.
_ROUNDS = 50


@dataclass(frozen=True, eq=False)
class Running:
    """What runs through where.

    Attributes:
        ends: (E, 2) true where the beam of an edge runs through at its start and end, or stands
            over the vertex as the end of one that does.
        stars: (V,) true for vertices that none runs through.
        turned: (E,) true for beams that run through at one end and give way at the other.
    """

    ends: BoolArray
    stars: BoolArray
    turned: BoolArray

    @property
    def half_edges(self) -> BoolArray:
        """(2E,) the ends in the order of half-edges, see ``Around``."""
        return np.asarray(self.ends.T.ravel())

    @classmethod
    def of(cls, lines: ParameterLines, ends: str) -> Running:
        """Sort out a net.

        Args:
            lines: of the net.
            ends: of which the last letter names the kind that runs through, u or v.

        Raises:
            InputError: a net none of whose lines runs through a vertex.
        """
        net = lines.connectivity
        refused = InputError(
            f"ends: {ends} needs lines that run through vertices, which this net has not; take "
            "stars for nodes, or mitred, hub or lapped ends"
        )
        if net.mixed:
            raise refused
        first = "uv".index(ends[-1])
        lengths = np.zeros(len(net.edges), dtype=np.int64)
        for line in lines.all:
            lengths[line.edges] = len(line.edges)
        runs = np.zeros((len(net.edges), 2), dtype=bool)
        stars = np.zeros(net.vertex_count, dtype=bool)
        linked, passed = _linked(lines), False
        beside = _beside(net.face_edges)
        around: dict[int, list[int]] = {}
        for edge, pair in enumerate(net.edges.tolist()):
            for vertex in pair:
                around.setdefault(vertex, []).append(edge)
        kinds = _kinds(lines, around)
        for vertex, edges in around.items():
            groups = linked.get(vertex, [])
            taken = {edge for pair in groups for edge in pair}
            groups = [*groups, *((edge,) for edge in edges if edge not in taken)]
            at = {edge: int(kinds[edge, int(net.edges[edge, 1] == vertex)]) for edge in edges}
            groups.sort(key=lambda g: (at[g[0]] != first, -len(g), -lengths[g[0]], g))
            chosen = next((group for group in groups if _met(group, edges, beside)), None)
            if net.singular[vertex] or chosen is None:
                stars[vertex] = True
                continue
            passed |= len(chosen) == 2
            for edge in chosen:
                runs[edge, int(net.edges[edge, 1] == vertex)] = True
        if not passed:
            raise refused
        turned = (runs[:, 0] != runs[:, 1]) & ~stars[net.edges].any(axis=1)
        return cls(runs, stars, turned & (kinds[:, 0] != kinds[:, 1]))


def _linked(lines: ParameterLines) -> dict[int, list[tuple[int, ...]]]:
    """By vertex the pairs of edges of the lines that pass it."""
    found: dict[int, list[tuple[int, ...]]] = {}
    for line in lines.all:
        edges, vertices = line.edges.tolist(), line.vertices.tolist()
        before = [edges[-1], *edges[:-1]] if line.closed else edges[:-1]
        after, nodes = (edges, vertices) if line.closed else (edges[1:], vertices[1:-1])
        for vertex, one, two in zip(nodes, before, after, strict=True):
            found.setdefault(vertex, []).append((one, two))
    return found


def _beside(face_edges: IntArray) -> set[tuple[int, int]]:
    """Pairs of edges that share a corner of a face, both ways round."""
    corners = [face_edges[:, [k, k - 1]] for k in range(4)]
    pairs = [tuple(pair) for pair in np.concatenate(corners).tolist()]
    return {(one, two) for one, two in pairs} | {(two, one) for one, two in pairs}


def _met(group: tuple[int, ...], edges: list[int], beside: set[tuple[int, int]]) -> bool:
    """Whether each of the other edges at a vertex is next to one of a group."""
    return all(edge in group or any((edge, other) in beside for other in group) for edge in edges)


def _kinds(lines: ParameterLines, around: dict[int, list[int]]) -> IntArray:
    """(E, 2) kind of each edge at its start and end: its family, or of none 0 or 1.

    ``around`` has the edges at each vertex. Of several starting points the one counts from which
    fewest edges are of two kinds.
    """
    net = lines.connectivity
    kinds = np.repeat(lines.edge_family[:, None], 2, axis=1)
    free = np.flatnonzero(net.referenced & ~net.singular)
    free = free[[int(kinds[around[vertex][0], 0]) < 0 for vertex in free.tolist()]]
    if not len(free):
        return kinds
    beside = _beside(net.face_edges)
    rings = {vertex: _alternating(around[vertex], beside) for vertex in free.tolist()}
    starts = free[np.unique(np.linspace(0, len(free) - 1, _STARTS).astype(int))].tolist()
    found = [_settled(_spread(net.edges, rings, start), net.edges, rings) for start in starts]
    best = min(found, key=lambda turned: len(_mixed(turned, net.edges, rings)))
    for vertex, turned in best.items():
        for edge, kind in rings[vertex].items():
            kinds[edge, int(net.edges[edge, 1] == vertex)] = kind ^ turned
    return kinds


def _alternating(edges: list[int], beside: set[tuple[int, int]]) -> dict[int, int]:
    """The edges at a vertex by 0 and 1 in turn, neighbours different, from its first on."""
    kinds, rest = {edges[0]: 0}, [edges[0]]
    while rest:
        edge = rest.pop()
        for other in edges:
            if other not in kinds and (edge, other) in beside:
                kinds[other] = 1 - kinds[edge]
                rest.append(other)
    return {edge: kinds.get(edge, 0) for edge in edges}


Rings = dict[int, dict[int, int]]


def _spread(ends: IntArray, rings: Rings, start: int) -> dict[int, int]:
    """1 for each vertex whose kinds are the other way round, so that those of edges agree.

    From a start on, ring by ring; where the fronts meet again behind an irregular vertex they
    cannot agree everywhere.
    """
    turned: dict[int, int] = {}
    for first in [start, *rings]:
        queue = deque([first] if first not in turned else [])
        turned.setdefault(first, 0)
        while queue:
            vertex = queue.popleft()
            for edge, kind in rings[vertex].items():
                other = int(ends[edge, 0] + ends[edge, 1]) - vertex
                if other in rings and other not in turned:
                    turned[other] = turned[vertex] ^ kind ^ rings[other][edge]
                    queue.append(other)
    return turned


def _settled(turned: dict[int, int], ends: IntArray, rings: Rings) -> dict[int, int]:
    """The same with vertices turned for as long as fewer edges are of two kinds."""
    for _ in range(_ROUNDS):
        some = {v for edge in _mixed(turned, ends, rings) for v in ends[edge].tolist()}
        moved = False
        for vertex in sorted(some):
            wrong = 0
            for edge, kind in rings[vertex].items():
                other = int(ends[edge, 0] + ends[edge, 1]) - vertex
                if other in rings:
                    unlike = turned[vertex] ^ kind ^ turned[other] ^ rings[other][edge]
                    wrong += 1 if unlike else -1
            if wrong > 0:
                turned[vertex] ^= 1
                moved = True
        if not moved:
            break
    return turned


def _mixed(turned: dict[int, int], ends: IntArray, rings: Rings) -> list[int]:
    """Edges that are of one kind at one end and of the other at the other."""
    return [
        edge
        for edge, (one, two) in enumerate(ends.tolist())
        if one in rings
        and two in rings
        and turned[one] ^ rings[one][edge] != turned[two] ^ rings[two][edge]
    ]
