"""Whole developable patches laid flat, with the distortion of every edge."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import coo_array, eye_array
from scipy.sparse.linalg import spsolve

from solver.analysis.measures import flipped
from solver.errors import InputError
from solver.mesh.grid import grid_of
from solver.mesh.quadmesh import FloatArray, QuadMesh, refuse_other
from solver.nets.options import NetOptions
from solver.optimise import optimise

# Most steps to the isometric net in the plane; after that lengths are made true alone.
_STEPS = 60
# Gauss-Newton steps on the lengths, and their damping, which holds the pattern in its place.
_POLISHING = 8
_DAMPING = 1e-10


@dataclass(frozen=True, eq=False)
class FlatPatch:
    """A patch and its flat pattern.

    Attributes:
        bent: the patch in space.
        flat: the same mesh in the plane z = 0.
    """

    bent: QuadMesh
    flat: QuadMesh

    @cached_property
    def stretch(self) -> FloatArray:
        """(E,) by how much each edge is longer in the patch than in the pattern, model's unit."""
        return self.bent.edge_lengths - self.flat.edge_lengths

    @cached_property
    def strain(self) -> FloatArray:
        """(E,) the same divided by the edge's length in the pattern."""
        return self.stretch / self.flat.edge_lengths


def flattened(mesh: QuadMesh) -> FlatPatch:
    """Lay a patch flat so that its faces keep their shape as well as they can.

    A rectangle of the mean edge lengths is the start; the isometric net polishes it: every face
    keeps both diagonals and their angle as nearly as the surface is developable. That leaves where
    the diagonals cross; so in the end edges and diagonals together keep their lengths as well as
    they can, and a patch of plane faces that unrolls does so exactly.

    Args:
        mesh: of grid type, open in both directions, near developable, in any unit.

    Raises:
        InputError: the mesh is not a grid, is closed, or folds over when laid flat.

    Source: Jiang et al. (2021), Using isometries for computational design and fabrication.
    """
    refuse_other(mesh)
    grid = grid_of(mesh)
    if grid.closed_u or grid.closed_v:
        raise InputError(
            "patch: it closes on itself and cannot be laid flat; cut it along a parameter line"
        )
    points = grid.points(mesh)
    start = np.zeros_like(mesh.vertices)
    for axis in (0, 1):
        lengths = np.linalg.norm(np.diff(points, axis=axis), axis=2).mean(axis=1 - axis)
        places = np.concatenate([[0.0], np.cumsum(lengths)])
        start[grid.numbers, axis] = places[:, None] if axis == 0 else places[None]
    outcome = optimise(
        mesh.with_vertices(start),
        "isometric",
        options=NetOptions(reference=mesh.vertices),
        max_steps=_STEPS,
    )
    flat = _true_to_length(outcome.mesh, mesh)
    if flipped(flat).any():
        face = int(np.argmax(flipped(flat)))
        raise InputError(
            f"patch: laid flat it folds over at face {face}; optimise for a geodesic or "
            "Chebyshev net first, or cut it into smaller patches"
        )
    return FlatPatch(mesh, flat)


def _true_to_length(flat: QuadMesh, bent: QuadMesh) -> QuadMesh:
    """Move a flat mesh in its plane until edges and diagonals differ least from the bent one's."""
    faces = flat.faces
    pairs = np.concatenate([flat.connectivity.edges, faces[:, [0, 2]], faces[:, [1, 3]]])
    start, end = pairs.T
    wanted = np.linalg.norm(bent.vertices[end] - bent.vertices[start], axis=1)
    points = flat.vertices[:, :2].copy()
    rows = np.repeat(np.arange(len(pairs)), 4)
    columns = np.stack([2 * end, 2 * end + 1, 2 * start, 2 * start + 1], axis=1).ravel()
    for _ in range(_POLISHING):
        arms = points[end] - points[start]
        lengths = np.linalg.norm(arms, axis=1)
        slopes = arms / lengths[:, None]
        entries = np.concatenate([slopes, -slopes], axis=1).ravel()
        jacobian = coo_array((entries, (rows, columns)), shape=(len(pairs), points.size)).tocsr()
        normal = (jacobian.T @ jacobian + _DAMPING * eye_array(points.size)).tocsc()
        points += spsolve(normal, jacobian.T @ (wanted - lengths)).reshape(-1, 2)
    return flat.with_vertices(np.column_stack([points, np.zeros(len(points))]))
