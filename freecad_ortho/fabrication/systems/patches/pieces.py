"""A net cut along edges into pieces that are meshes of their own."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from freecad_ortho.fabrication.part import part_names
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import QuadMesh


@dataclass(frozen=True, eq=False)
class NetPiece:
    """A connected piece of a net.

    Attributes:
        name: of the part; pieces are counted in the order of their smallest faces.
        mesh: of the piece alone; vertices on both sides of a cut are two.
        vertices: (K,) vertex of the net for each vertex of the piece.
        faces: (G,) face of the net for each face of the piece.
    """

    name: str
    mesh: QuadMesh
    vertices: IntArray
    faces: IntArray


def pieces_of(mesh: QuadMesh, cuts: BoolArray) -> list[NetPiece]:
    """Cut a net along edges.

    Corners of faces are one vertex of a piece where edges that are not cut join them; so a ring
    that is cut once opens.

    Args:
        mesh: the net.
        cuts: (E,) true where an edge is cut.
    """
    net = mesh.connectivity
    half = np.flatnonzero((net.twins >= 0) & ~cuts[net.face_edges.ravel()])
    twin = net.twins[half]
    following, twin_following = _following(half), _following(twin)
    corner_of = _joined(
        np.concatenate([half, following]),
        np.concatenate([twin_following, twin]),
        4 * len(net.faces),
    ).reshape(-1, 4)
    piece_of = _joined(half // 4, twin // 4, len(net.faces))
    _, first, order = np.unique(piece_of, return_index=True, return_inverse=True)
    ranks = np.argsort(np.argsort(first))[order]
    names = part_names("D", len(first))
    pieces = []
    for number, name in enumerate(names):
        faces = np.flatnonzero(ranks == number)
        _, place, corners = np.unique(corner_of[faces], return_index=True, return_inverse=True)
        vertices = net.faces[faces].ravel()[place]
        alone = QuadMesh(mesh.vertices[vertices], corners.reshape(-1, 4))
        pieces.append(NetPiece(name, alone, vertices, faces))
    return pieces


def _following(half: IntArray) -> IntArray:
    """Corners at the ends of half-edges."""
    return half - half % 4 + (half + 1) % 4


def _joined(one: IntArray, two: IntArray, count: int) -> IntArray:
    """(count,) number of the connected component of each element."""
    graph = coo_array((np.ones(len(one)), (one, two)), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1])
