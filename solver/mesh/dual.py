"""The Christoffel dual of a net: parallel edges, the other diagonals parallel."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components
from scipy.sparse.linalg import splu

from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.lines import ParameterLines
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Least share of a diagonal on either side of where the other one meets it.
_SHARE = 1e-9


class Dual(NamedTuple):
    """The dual of a net.

    Attributes:
        mesh: as large as the net and about the same middle.
        misfit: largest distance between an edge and what it has to be, over the mean edge: zero
            where the net has a dual.
        edge: where that is.
    """

    mesh: QuadMesh
    misfit: float
    edge: int


def christoffel_dual(mesh: QuadMesh) -> Dual:
    """The net with parallel edges of which each diagonal is parallel to the other one of the net.

    In a plane face whose diagonals meet in M the edge from A to B becomes that edge divided by
    the product of the signed distances of A and B from M, times a factor of the face. These
    factors make the edges of neighbours equal, which is possible for Koenigs nets only: for others
    it is done in the sense of least squares, and ``misfit`` says how far it is off. The dual of an
    isothermic net on a sphere is a minimal surface.

    Args:
        mesh: one sheet or several, of which lines have two families.

    Raises:
        InputError: families that cannot be told apart, or a face that is not convex.

    Source: Bobenko, Suris (2009), Discrete Koenigs nets and discrete isothermic surfaces.
    """
    net, family = mesh.connectivity, ParameterLines(mesh.connectivity).edge_family
    if (family < 0).any():
        raise InputError(
            "dual: the lines of the mesh have no two families, as an odd number of faces meet at "
            "an inner vertex; cut the mesh there"
        )
    logs, sides = _log_factors(mesh), net.face_edges
    factors = _face_factors(sides, logs, len(net.edges))
    sums, counts = np.zeros(len(net.edges)), np.zeros(len(net.edges))
    np.add.at(sums, sides, logs + factors[:, None])
    np.add.at(counts, sides, 1.0)
    scales = np.exp(sums / counts) * np.where(family == 0, 1.0, -1.0)
    start, end = net.edges.T
    wanted = scales[:, None] * (mesh.vertices[end] - mesh.vertices[start])
    points = _summed(net.edges, wanted, len(mesh.vertices))
    off = np.linalg.norm(points[end] - points[start] - wanted, axis=1)
    mean = float(np.linalg.norm(wanted, axis=1).mean())
    used = net.referenced
    middle, size = _box(mesh.vertices[used])
    own_middle, own_size = _box(points[used])
    placed = mesh.vertices.copy()
    placed[used] = middle + (points[used] - own_middle) * (size / own_size)
    return Dual(mesh.with_vertices(placed), float(off.max()) / mean, int(off.argmax()))


def _box(points: FloatArray) -> tuple[FloatArray, float]:
    low, high = points.min(axis=0), points.max(axis=0)
    return (low + high) / 2, float(np.linalg.norm(high - low))


def _log_factors(mesh: QuadMesh) -> FloatArray:
    """(F, 4) logarithm of the factor of each side, up to one of the face.

    Raises:
        InputError: diagonals that do not meet inside their face.
    """
    corner = mesh.vertices[mesh.faces]
    first, second = corner[:, 2] - corner[:, 0], corner[:, 3] - corner[:, 1]
    normal = np.cross(first, second)
    size = np.maximum(np.einsum("fi,fi->f", normal, normal), np.finfo(float).tiny)
    between = corner[:, 1] - corner[:, 0]
    # Shares of the diagonals up to where they meet, seen along the normal of the face.
    share = np.stack(
        [
            np.einsum("fi,fi->f", np.cross(between, second), normal) / size,
            np.einsum("fi,fi->f", np.cross(between, first), normal) / size,
        ],
        axis=1,
    )
    bad = (share < _SHARE) | (share > 1 - _SHARE)
    if bad.any():
        face = int(bad.any(axis=1).argmax())
        raise InputError(f"dual: face {face} is not convex; mend it, or optimise the net first")
    lengths = np.stack([np.linalg.norm(first, axis=1), np.linalg.norm(second, axis=1)], axis=1)
    reach = np.log(np.concatenate([share * lengths, (1 - share) * lengths], axis=1))
    return np.asarray(-(reach + np.roll(reach, -1, axis=1)))


def _face_factors(sides: IntArray, logs: FloatArray, count: int) -> FloatArray:
    """(F,) logarithms of the faces' factors with which the edges of neighbours agree best."""
    order = np.argsort(sides.ravel(), kind="stable")
    edge, face, value = sides.ravel()[order], order // 4, logs.ravel()[order]
    inner = np.flatnonzero(edge[1:] == edge[:-1])
    pairs = np.stack([face[inner], face[inner + 1]], axis=1)
    return _summed(pairs, (value[inner] - value[inner + 1])[:, None], len(sides))[:, 0]


def _summed(pairs: IntArray, steps: FloatArray, count: int) -> FloatArray:
    """(n, d) values whose differences, second less first, are nearest to the steps (m, d)."""
    one, two = pairs.T
    rows = np.arange(len(pairs))
    signs = np.repeat([-1.0, 1.0], len(pairs))
    places = (np.concatenate([rows, rows]), np.concatenate([one, two]))
    matrix = csr_array(coo_array((signs, places), shape=(len(pairs), count)))
    normal = matrix.T @ matrix
    label = connected_components(normal, directed=False)[1]
    _, first = np.unique(label, return_index=True)
    held = np.zeros(count)
    held[first] = 1.0
    solved = splu((normal + coo_array((held, (np.arange(count),) * 2))).tocsc())
    return np.asarray(solved.solve(np.ascontiguousarray(matrix.T @ steps)))
