"""Meshes made of another mesh's diagonals and medial lines.

Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, section 2.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import breadth_first_order, connected_components

from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, Connectivity, IntArray
from solver.mesh.groups import components_of
from solver.mesh.quadmesh import FloatArray, QuadMesh, refuse_other
from solver.option import one_of


@dataclass(frozen=True, eq=False)
class DiagonalPair:
    """The two diagonal meshes M1, M2 of a mesh M, and what leads back to M.

    Attributes:
        first: M1, on the vertices of one colour (that of vertex 0's face corner).
        second: M2, on the other ones.
        first_numbers: (V1,) number in M of each vertex of M1.
        second_numbers: (V2,) number in M of each vertex of M2.
        crossings: (F, 4) corners of each face of M: two vertices of M1 and two of M2, alternating;
            the edge between the former and that between the latter correspond.
        starts: (F,) whether the face of M starts at its vertex of M1.
    """

    first: QuadMesh
    second: QuadMesh
    first_numbers: IntArray
    second_numbers: IntArray
    crossings: IntArray
    starts: BoolArray

    @property
    def edge_lengths(self) -> tuple[FloatArray, FloatArray]:
        """(F,) lengths of corresponding edges; the pair is rhombic where they agree."""
        one = self.first.vertices[self.crossings[:, [0, 2]]]
        two = self.second.vertices[self.crossings[:, [1, 3]]]
        return (
            np.linalg.norm(one[:, 1] - one[:, 0], axis=1),
            np.linalg.norm(two[:, 1] - two[:, 0], axis=1),
        )

    @property
    def mesh(self) -> QuadMesh:
        """M again, from the positions of the pair; vertex and face numbers as they were."""
        count = len(self.first_numbers) + len(self.second_numbers)
        vertices = np.empty((count, 3))
        # Vertices added at the border come last and are passed over.
        vertices[self.first_numbers] = self.first.vertices[: len(self.first_numbers)]
        vertices[self.second_numbers] = self.second.vertices[: len(self.second_numbers)]
        faces = np.empty_like(self.crossings)
        faces[:, 0::2] = self.first_numbers[self.crossings[:, 0::2]]
        faces[:, 1::2] = self.second_numbers[self.crossings[:, 1::2]]
        turned = np.where(self.starts[:, None], faces, np.roll(faces, 1, axis=1))
        return QuadMesh(vertices, turned)

    def with_vertices(self, first: FloatArray, second: FloatArray) -> DiagonalPair:
        """The same pair with other positions."""
        return DiagonalPair(
            self.first.with_vertices(first),
            self.second.with_vertices(second),
            self.first_numbers,
            self.second_numbers,
            self.crossings,
            self.starts,
        )


def diagonal_families(net: Connectivity) -> IntArray:
    """(2F,) number of the family that each face diagonal belongs to.

    In line at a regular vertex, and opposite each other around one, diagonals share a family.
    """
    key = np.sort(net.diagonal_edges, axis=1) @ np.array([net.vertex_count, 1])
    order = np.argsort(key)

    def number(one: IntArray, two: IntArray) -> IntArray:
        pair = np.minimum(one, two) * net.vertex_count + np.maximum(one, two)
        return order[np.searchsorted(key, pair, sorter=order)]

    centre, d1, d2, d3, d4 = net.diagonal_stars.T
    _, n1, n2, n3, n4 = net.stars.T
    joined = [
        (number(centre, d1), number(centre, d3)),
        (number(centre, d2), number(centre, d4)),
        (number(n1, n2), number(n3, n4)),
        (number(n2, n3), number(n4, n1)),
    ]
    one, two = (np.concatenate(side) for side in zip(*joined, strict=True))
    return components_of(one, two, len(key))


def diagonal_meshes(mesh: QuadMesh, boundary: str = "drop") -> DiagonalPair:
    """Both diagonal meshes of a mesh.

    A face of M1 surrounds each vertex of the other colour: its corners are the four neighbours.
    Interior vertices of other valence give no quad and leave a hole.

    Args:
        mesh: every vertex used by a face, faces two-colourable (no odd ring of faces).
        boundary: ``drop`` leaves a zigzag border; ``fill`` closes it by quads that use the boundary
            vertex itself as fourth corner (it is added to that diagonal mesh as an extra vertex;
            :attr:`DiagonalPair.mesh` passes over it).

    Raises:
        InputError: not two-colourable, unused vertices, or a mesh too small for a diagonal face.
    """
    refuse_other(mesh)
    one_of("boundary", boundary, ("drop", "fill"))
    net = mesh.connectivity
    if not net.referenced.all():
        raise InputError("diagonal mesh: vertices without faces; remove them first")
    colour = _colours(mesh)
    around = _neighbours(mesh)
    parts = [_part(mesh, colour == k, around, boundary) for k in (False, True)]
    place = np.empty(len(mesh.vertices), dtype=np.int64)
    numbers = [np.flatnonzero(colour == k) for k in (False, True)]
    for own in numbers:
        place[own] = np.arange(len(own))
    starts = ~colour[mesh.faces[:, 0]]
    crossings = np.where(starts[:, None], mesh.faces, np.roll(mesh.faces, -1, axis=1))
    return DiagonalPair(parts[0], parts[1], numbers[0], numbers[1], place[crossings], starts)


def _colours(mesh: QuadMesh) -> BoolArray:
    """(V,) a two-colouring along edges; in each component the lowest number is false."""
    edges, count = mesh.connectivity.edges, len(mesh.vertices)
    graph = coo_array((np.ones(len(edges)), edges.T), shape=(count, count)).tocsr()
    label = connected_components(graph, directed=False)[1]
    colour = np.zeros(count, dtype=bool)
    for seed in np.unique(label, return_index=True)[1]:
        order, before = breadth_first_order(graph, seed, directed=False)
        for vertex in order[1:]:
            colour[vertex] = not colour[before[vertex]]
    if (colour[edges[:, 0]] == colour[edges[:, 1]]).any():
        raise InputError(
            "diagonal mesh: the vertices cannot be two-coloured (a closed ring of an odd number of "
            "faces); subdivide the mesh once or cut the ring"
        )
    return colour


def _neighbours(mesh: QuadMesh) -> list[list[int]]:
    """Neighbours of each vertex counter-clockwise, at a border from its one edge to the other."""
    twins, faces = mesh.connectivity.twins, mesh.faces.ravel()
    outgoing = np.full(len(mesh.vertices), -1, dtype=np.int64)
    outgoing[faces] = np.arange(len(faces))
    border = np.flatnonzero(twins < 0)
    # Starting at the outgoing boundary edge, a turn to the left passes all faces.
    outgoing[faces[border]] = border
    result = []
    for half in outgoing.tolist():
        start, ring = half, []
        while True:
            ring.append(int(faces[half - half % 4 + (half + 1) % 4]))
            back = half - half % 4 + (half + 3) % 4
            half = int(twins[back])
            if half < 0:
                ring.append(int(faces[back]))
                break
            if half == start:
                break
        result.append(ring)
    return result


def _part(mesh: QuadMesh, own: BoolArray, around: list[list[int]], boundary: str) -> QuadMesh:
    """Diagonal mesh on the vertices ``own``; extra boundary vertices come after them."""
    edge, valence = mesh.connectivity.boundary_vertices, mesh.connectivity.face_valence
    number = np.full(len(mesh.vertices), -1, dtype=np.int64)
    kept = np.flatnonzero(own)
    number[kept] = np.arange(len(kept))
    extra: list[int] = []
    faces = []
    for vertex in np.flatnonzero(~own).tolist():
        ring = [int(number[other]) for other in around[vertex]]
        if not edge[vertex] and valence[vertex] == 4:
            faces.append(ring)
        elif boundary == "fill" and edge[vertex] and len(ring) == 3:
            faces.append([len(kept) + len(extra), *ring])
            extra.append(vertex)
    if not faces:
        raise InputError(
            f"diagonal mesh: {len(mesh.faces)} faces are too few for a diagonal face; subdivide "
            "the mesh first"
        )
    return QuadMesh(mesh.vertices[np.concatenate([kept, extra]).astype(int)], faces)


def medial_mesh(mesh: QuadMesh) -> QuadMesh:
    """Mesh of the points where the medial lines of each face cross (the mean of its corners).

    Vertex f is that of face f; a face surrounds each interior vertex of valence four. Medial lines
    bend at the midpoints of the edges, between two vertices of this mesh.

    Raises:
        InputError: no interior vertex of valence four.
    """
    net = mesh.connectivity
    centres = mesh.vertices[mesh.faces].mean(axis=1)
    inner = net.stars[:, 0]
    if not len(inner):
        raise InputError("medial mesh: no interior vertex of valence four; subdivide first")
    half_of = np.full(len(mesh.vertices), -1, dtype=np.int64)
    half_of[mesh.faces.ravel()[::-1]] = np.arange(mesh.faces.size)[::-1]
    half, faces = half_of[inner], []
    for _ in range(4):
        faces.append(half // 4)
        half = net.twins[half - half % 4 + (half + 3) % 4]
    return QuadMesh(centres, np.stack(faces, axis=1))


def checkerboard(mesh: QuadMesh) -> QuadMesh:
    """Checkerboard pattern: edge midpoints, a parallelogram in each face, a quad at each star.

    Vertex e is the midpoint of edge e; the parallelograms come first, face f of the mesh as face
    f. They are rhombi exactly where the mesh is orthogonal.

    Source: Peng et al. (2019), Checkerboard patterns with black rectangles; D section 2.
    """
    net = mesh.connectivity
    middles = mesh.vertices[net.edges].mean(axis=1)
    half_of = np.full(len(mesh.vertices), -1, dtype=np.int64)
    half_of[mesh.faces.ravel()[::-1]] = np.arange(mesh.faces.size)[::-1]
    half, around = half_of[net.stars[:, 0]], []
    for _ in range(4):
        around.append(net.face_edges.ravel()[half])
        half = net.twins[half - half % 4 + (half + 3) % 4]
    return QuadMesh(middles, np.concatenate([net.face_edges, np.stack(around, axis=1)]))
