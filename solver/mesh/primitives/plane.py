"""The flat start of a form-finding."""

from __future__ import annotations

import numpy as np

from solver.mesh.grid import grid_mesh
from solver.mesh.primitives.limits import positive
from solver.mesh.quadmesh import QuadMesh


def rectangle(m: int, n: int, *, length: float = 1.0, width: float = 1.0) -> QuadMesh:
    """Flat net in the plane z = 0, centred at the origin; rectangles, normals along +z.

    Raises:
        InputError: a length that is not positive.
    """
    positive(length=length, width=width)
    x, y = np.meshgrid(np.linspace(-0.5, 0.5, m), np.linspace(-0.5, 0.5, n), indexing="ij")
    return grid_mesh(np.stack([length * x, width * y, 0 * x], axis=2))
