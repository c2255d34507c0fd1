"""Whether a mesh that is to carry loads lies on its side."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from solver.mesh.quadmesh import QuadMesh

# A mesh faces one way where the sum of its area vectors is so much of its area, and lies on its
# side where so little of that sum is vertical.
_ONE_WAY, _VERTICAL = 0.5, 0.5


def side_remark(mesh: QuadMesh, *loads: ArrayLike) -> str | None:
    """What is to be said where loads along z act on a mesh that faces x or y; None elsewhere.

    Args:
        mesh: the mesh.
        loads: (3,) vectors.
    """
    total = np.abs(np.array(loads, dtype=np.float64).reshape(-1, 3)).sum(axis=0)
    if not total[2] > max(total[0], total[1]):
        return None
    areas = mesh.face_area_vectors
    facing = areas.sum(axis=0)
    length = float(np.linalg.norm(facing))
    whole = float(np.linalg.norm(areas, axis=1).sum())
    if length < _ONE_WAY * whole or abs(facing[2]) > _VERTICAL * length:
        return None
    axis = "xyz"[int(np.argmax(np.abs(facing)))]
    return (
        f"the net lies on its side: it faces {axis}, and the loads act along z; turn it, or read "
        "a file whose y points up with --up y (FreeCAD: import_net with up='y', or Transform)"
    )
