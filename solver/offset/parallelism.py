"""What the searches for parallel meshes share: the condition that corresponding edges are parallel.

For an edge of direction ``u`` and offsets ``a`` of its ends the condition is ``P (a_j - a_i) = 0``
with ``P = 1 - u u^T``. It enters as a square with a large weight, and with a smaller one where the
faces at the edge are not planar and only trivial offsets could fulfil it.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.sparse import coo_array, csc_array
from scipy.sparse.linalg import splu

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh

_HARD = 1e10  # squared singular values of C far below its inverse count as zero
_SOFT = 1e-2  # weight times planarity squared where faces are not planar


def projections(direction: FloatArray) -> FloatArray:
    """(E, 3, 3) projection along each unit direction (E, 3)."""
    return np.asarray(np.eye(3) - direction[:, :, None] * direction[:, None, :])


def edge_weights(mesh: QuadMesh) -> FloatArray:
    """(E,) weight of the constraint, lower where a face at the edge is not planar."""
    if mesh.connectivity.mixed:
        sizes = np.sqrt(2 * np.linalg.norm(mesh.face_area_vectors, axis=1))
        return _weights_of(mesh, mesh.face_gaps / np.where(sizes > 0, sizes, 1.0))
    corner = mesh.vertices[mesh.faces]
    first, second = corner[:, 2] - corner[:, 0], corner[:, 3] - corner[:, 1]
    distance = np.abs(np.einsum("fk,fk->f", corner[:, 1] - corner[:, 0], mesh.face_normals))
    size = (np.linalg.norm(first, axis=1) + np.linalg.norm(second, axis=1)) / 2
    return _weights_of(mesh, distance / np.where(size > 0, size, 1.0))


def _weights_of(mesh: QuadMesh, planarity: FloatArray) -> FloatArray:
    worst = np.append(planarity, 0.0)[mesh.connectivity.edge_faces].max(axis=1)
    return np.asarray(_SOFT / np.maximum(worst, np.sqrt(_SOFT / _HARD)) ** 2)


def factorised(mesh: QuadMesh, diagonal: FloatArray, coupling: FloatArray) -> Any:
    """Factorise ``H + sum over edges of (a_j - a_i)^T K (a_j - a_i)``.

    Args:
        mesh: its edges couple.
        diagonal: (V, 3, 3) blocks of H.
        coupling: (E, 3, 3) symmetric blocks K.

    Returns:
        An object whose ``solve`` takes and returns 3V numbers.
    """
    start, end = mesh.connectivity.edges.T
    stiff = diagonal.copy()
    for ends in (start, end):
        np.add.at(stiff, ends, coupling)
    return splu(
        _block_matrix(stiff, -coupling, start, end),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0,
        options={"SymmetricMode": True},
    )


def apply(blocks: FloatArray, vectors: FloatArray) -> FloatArray:
    """(N, 3) product of each 3 x 3 block with its vector."""
    return np.asarray(np.einsum("nij,nj->ni", blocks, vectors))


def _block_matrix(
    diagonal: FloatArray, beside: FloatArray, start: IntArray, end: IntArray
) -> csc_array:
    """Symmetric sparse matrix of 3 x 3 blocks: ``diagonal`` (V, 3, 3), ``beside`` (E, 3, 3)."""
    vertex = np.arange(len(diagonal))
    row = np.concatenate([vertex, start, end])[:, None, None]
    column = np.concatenate([vertex, end, start])[:, None, None]
    blocks = np.concatenate([diagonal, beside, beside])
    rows = np.broadcast_to(3 * row + np.arange(3)[:, None], blocks.shape)
    columns = np.broadcast_to(3 * column + np.arange(3), blocks.shape)
    size = 3 * len(diagonal)
    return csc_array(
        coo_array((blocks.ravel(), (rows.ravel(), columns.ravel())), shape=(size, size))
    )
