"""A net and its mirror images in coordinate planes, welded where they meet."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from solver.errors import InputError
from solver.mesh.mirror import mirrored
from solver.mesh.quadmesh import QuadMesh
from solver.multinet.quadric import Quadric

PLANES = ("x", "y", "z")


def reflected(mesh: QuadMesh, planes: Iterable[str], quadric: Quadric | None = None) -> QuadMesh:
    """Extend a net by reflection in the planes normal to the named axes of a quadric.

    The vertices and faces of the mesh come first and keep their numbers.

    Args:
        mesh: the net.
        planes: any of x, y, z: the axis that changes its sign.
        quadric: whose axes and centre; the coordinate system by default.

    Raises:
        InputError: a name that is no axis, or images that overlap.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, figure 4 (b).
    """
    names = list(planes)
    if len(set(names)) != len(names) or not set(names) <= set(PLANES):
        raise InputError(
            f"reflect: expected some of x, y, z, each once, got '{','.join(names)}'; "
            "separate them by commas"
        )
    centre = np.zeros(3) if quadric is None else quadric.centre
    axes = np.eye(3) if quadric is None else quadric.rotation
    for name in names:
        mesh = mirrored(mesh, axes[:, PLANES.index(name)], centre)
    return mesh
