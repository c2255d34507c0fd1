"""Whole developable patches laid flat, with the distortion of every edge."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.analysis.measures import flipped
from solver.errors import InputError
from solver.mesh.grid import grid_of
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.nets.options import NetOptions
from solver.optimise import optimise

_STEPS = 60


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
    keeps both diagonals and their angle as nearly as the surface is developable.

    Args:
        mesh: of grid type, open in both directions, near developable, in any unit.

    Raises:
        InputError: the mesh is not a grid, is closed, or folds over when laid flat.

    Source: Jiang et al. (2021), Using isometries for computational design and fabrication.
    """
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
    flat = outcome.mesh
    if flipped(flat).any():
        face = int(np.argmax(flipped(flat)))
        raise InputError(
            f"patch: laid flat it folds over at face {face}; optimise with --net geodesic or "
            "--net chebyshev first, or cut it into smaller patches"
        )
    return FlatPatch(mesh, flat)
