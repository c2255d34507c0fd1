"""The parameter lines of a mesh, sorted into the families u and v."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from itertools import combinations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from solver.mesh.connectivity import BoolArray, Connectivity, IntArray
from solver.mesh.quadmesh import QuadMesh, unit_rows

FAMILIES = ("u", "v")
# Degrees that a line may turn at a border vertex and still run on: more than lines of a usable net
# turn, and a third of the 45 from where another edge would go on as straight.
STRAIGHT_ON = 15.0


@dataclass(frozen=True, eq=False)
class ParameterLine:
    """One parameter line.

    Attributes:
        family: "u" or "v", or "" where the mesh has no two families.
        number: counted from 0 in its family.
        vertices: (K,) in the order of the line; a closed line does not repeat its first.
        edges: (K - 1,) edge numbers, (K,) of a closed line.
        closed: true where the line returns to its first vertex.
    """

    family: str
    number: int
    vertices: IntArray
    edges: IntArray
    closed: bool


@dataclass(frozen=True, eq=False)
class ParameterLines:
    """All parameter lines of a connectivity.

    Side 0 of the first face of each component is a u line. Lines end at the boundary and at
    irregular vertices, but for ``joined``. They are numbered, in each family, in the order of their
    smallest edge, and run away from the smaller of their ends.

    Attributes:
        connectivity: that the lines are of.
        joined: (J, 2) further pairs of edges of one family that follow each other on a line, each
            edge at each end once.
    """

    connectivity: Connectivity
    joined: IntArray = field(default_factory=lambda: np.empty((0, 2), dtype=np.int64))

    @classmethod
    def of(cls, mesh: QuadMesh) -> ParameterLines:
        """Lines that run on through border vertices where they are nearly straight.

        The border of a diagonal mesh is a zigzag: where three faces meet at one of its vertices two
        lines cross that the connectivity alone would end there.
        """
        if mesh.connectivity.mixed:
            return cls(mesh.connectivity)
        return cls(mesh.connectivity, joined_at_border(mesh))

    @cached_property
    def passed(self) -> BoolArray:
        """(V,) true where a line goes on: at regular vertices and between joined edges."""
        result = self.connectivity.regular.copy()
        one, two = self.connectivity.edges[self.joined[:, 0]], self.joined[:, 1]
        other = self.connectivity.edges[two]
        shared = (one == other[:, :1]) | (one == other[:, 1:])
        result[one[shared]] = True
        return result

    @cached_property
    def edge_family(self) -> IntArray:
        """(E,) 0 where the edge belongs to u, 1 to v, -1 where families cannot be told apart.

        The sides of a face alternate between the families, which contradicts itself where an odd
        number of faces meet inside the mesh. Edges are coloured by the components of a graph that
        holds every edge twice, once in each colour.
        """
        if self.connectivity.mixed:
            return np.full(len(self.connectivity.edges), -1)
        sides, count = self.connectivity.face_edges, len(self.connectivity.edges)
        one = np.concatenate([sides[:, k] + colour * count for k in range(3) for colour in (0, 1)])
        two = np.concatenate(
            [sides[:, k + 1] + (1 - colour) * count for k in range(3) for colour in (0, 1)]
        )
        graph = coo_array((np.ones(len(one)), (one, two)), shape=(2 * count, 2 * count))
        label = connected_components(graph, directed=False)[1].reshape(2, count)
        _, first = np.unique(self.connectivity.components, return_index=True)
        base = np.empty(count, dtype=np.int64)
        base[sides] = sides[first, 0][self.connectivity.components][:, None]
        as_u, as_v = label[0] == label[0, base], label[0] == label[1, base]
        return np.where(as_u & as_v, -1, np.where(as_u, 0, 1)).astype(np.int64)

    @cached_property
    def _links(self) -> IntArray:
        """(L, 2) pairs of edges that follow each other on a line."""
        onward = self.connectivity.continuation
        half = np.flatnonzero(onward >= 0)
        edge_of = self.connectivity.half_edge_edges
        pairs = np.stack([edge_of[half], edge_of[onward[half]]], axis=1)
        return np.unique(np.sort(np.concatenate([pairs, self.joined]), axis=1), axis=0)

    @cached_property
    def all(self) -> tuple[ParameterLine, ...]:
        """Every line: those of u, those of v, then those of neither."""
        count = len(self.connectivity.edges)
        one, two = self._links.T
        graph = coo_array((np.ones(len(one)), (one, two)), shape=(count, count))
        label = connected_components(graph, directed=False)[1]
        beside: list[list[int]] = [[] for _ in range(count)]
        for first, second in self._links.tolist():
            beside[first].append(second)
            beside[second].append(first)
        order = np.argsort(label, kind="stable")
        chains = np.split(order, np.flatnonzero(np.diff(label[order])) + 1)
        numbers = dict.fromkeys((0, 1, -1), 0)
        found: dict[int, list[ParameterLine]] = {0: [], 1: [], -1: []}
        for chain in sorted(chains, key=lambda chain: int(chain[0])):
            family = int(self.edge_family[chain[0]])
            vertices, edges, closed = self._walked(chain.tolist(), beside)
            letter = "" if family < 0 else FAMILIES[family]
            line = ParameterLine(letter, numbers[family], vertices, edges, closed)
            found[family].append(line)
            numbers[family] += 1
        return (*found[0], *found[1], *found[-1])

    @cached_property
    def edge_line(self) -> IntArray:
        """(E,) number, in its family, of the line that each edge lies on."""
        result = np.empty(len(self.connectivity.edges), dtype=np.int64)
        for line in self.all:
            result[line.edges] = line.number
        return result

    def of_family(self, family: str) -> tuple[ParameterLine, ...]:
        """The lines of a family, in the order of their numbers."""
        return tuple(line for line in self.all if line.family == family)

    def _walked(self, chain: list[int], beside: list[list[int]]) -> tuple[IntArray, IntArray, bool]:
        """Vertices and edges of one line in order, and whether it is closed."""
        ends = self.connectivity.edges
        outer = [edge for edge in chain if len(beside[edge]) < 2]
        closed = not outer and len(chain) > 2
        if len(chain) == 1:
            return ends[chain[0]].copy(), np.array(chain), False
        if closed:
            around = _walk(min(chain), beside, len(chain))
            walks = [around, [around[0], *reversed(around[1:])]]
        else:
            walks = [_walk(start, beside, len(chain)) for start in outer]
        paths = [(_vertices(walk, ends), walk) for walk in walks]
        vertices, edges = min(paths, key=lambda path: path[0][0])
        return np.array(vertices[: len(vertices) - closed]), np.array(edges), closed


def joined_at_border(mesh: QuadMesh) -> IntArray:
    """(J, 2) pairs of edges that go straight on at border vertices where connectivity ends them.

    Both are of one family (or neither has one), share no face and turn by at most ``STRAIGHT_ON``
    degrees; of several that could go on, those that turn least.
    """
    net = mesh.connectivity
    at = np.flatnonzero(net.boundary_vertices & ~net.regular & (net.edge_valence > 3))
    if not len(at):
        return np.empty((0, 2), dtype=np.int64)
    family = ParameterLines(net).edge_family
    sides = net.face_edges
    beside = {(min(pair), max(pair)) for k in range(4) for pair in sides[:, [k, k - 1]].tolist()}
    around: dict[int, list[int]] = {vertex: [] for vertex in at.tolist()}
    for edge, ends in enumerate(net.edges.tolist()):
        for vertex in ends:
            if vertex in around:
                around[vertex].append(edge)
    found: list[tuple[int, int]] = []
    least = -np.cos(np.radians(STRAIGHT_ON))
    for vertex, edges in around.items():
        away = mesh.vertices[net.edges[edges].sum(axis=1) - vertex] - mesh.vertices[vertex]
        turned = unit_rows(away) @ unit_rows(away).T
        pairs = [
            (turned[i, j], edges[i], edges[j])
            for i, j in combinations(range(len(edges)), 2)
            if turned[i, j] <= least
            and family[edges[i]] == family[edges[j]]
            and (edges[i], edges[j]) not in beside
        ]
        free = set(edges)
        for _, one, two in sorted(pairs):
            if {one, two} <= free:
                free -= {one, two}
                found.append((one, two))
    return np.array(found, dtype=np.int64).reshape(-1, 2)


def _walk(start: int, beside: list[list[int]], length: int) -> list[int]:
    """Edges from ``start`` on, each once."""
    walk, previous = [start], -1
    while len(walk) < length:
        here = walk[-1]
        onward = [edge for edge in beside[here] if edge != previous]
        previous = here
        walk.append(min(onward))
    return walk


def _vertices(edges: list[int], ends: IntArray) -> list[int]:
    """Vertices along consecutive edges."""
    pairs = [tuple(pair) for pair in ends[edges].tolist()]
    first = pairs[0]
    here = first[0] if first[1] in pairs[1] else first[1]
    path = [here]
    for pair in pairs:
        here = pair[1] if pair[0] == here else pair[0]
        path.append(here)
    return path
