"""Where a made net stands."""

from __future__ import annotations

import numpy as np

from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.option import Option

Placing = tuple[FloatArray, FloatArray]
PLACEMENT = Option(
    "placement", (np.eye(3), np.zeros(3)), "placement", "The net stands here, turned like this"
)


def placed(mesh: QuadMesh, placement: Placing) -> QuadMesh:
    """Turn a mesh by a (3, 3) rotation and move it by (3,) mm; unplaced ones keep every bit."""
    rotation, origin = placement
    if np.array_equal(rotation, np.eye(3)) and not np.any(origin):
        return mesh
    return mesh.with_vertices(mesh.vertices @ rotation.T + origin)
