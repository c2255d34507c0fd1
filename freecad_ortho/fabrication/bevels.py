"""Sides of plates that are not square to the plate: where they begin, and by how much they lean."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.bodies import Polyhedron
from freecad_ortho.fabrication.pattern import Bevel
from solver.mesh.quadmesh import FloatArray

# Where a side leaves the square by less, mm, tools cut no truer.
_SQUARE = 1e-6
# Sine of the angle to the plate beyond which a side is one of its two faces.
_FACE = 1 - 1e-9


def bevels_of(body: Polyhedron) -> tuple[Bevel, ...]:
    """The bevelled sides of a plate, x and y in its plane and z across it towards the viewer.

    Each is given by its inner line, where the plate is cut back: on the side that faces the viewer
    where it opens towards him, hidden on the far side where it is undercut.
    """
    bevels = []
    for loop in body.loops:
        ring = body.corners[list(loop)]
        normal = _normal(ring)
        if abs(normal[2]) >= _FACE:
            continue
        upper, lower = _level(ring, ring[:, 2].max()), _level(ring, ring[:, 2].min())
        if upper is None or lower is None:
            continue
        across = float(np.abs((upper - lower).mean(axis=0) @ normal[:2]))
        if across <= _SQUARE * np.linalg.norm(normal[:2]):
            continue
        opens = bool(normal[2] > 0)
        angle = float(np.degrees(np.arcsin(normal[2])))
        bevels.append(Bevel(upper if opens else lower, angle))
    return tuple(bevels)


def _normal(ring: FloatArray) -> FloatArray:
    """Unit normal of a plane polygon (N, 3)."""
    arms = ring - ring[0]
    area = np.cross(arms[1:-1], arms[2:]).sum(axis=0)
    return np.asarray(area / np.linalg.norm(area))


def _level(ring: FloatArray, height: float) -> FloatArray | None:
    """(2, 2) ends of the side of a polygon that lies at a height; None where there is none."""
    there = ring[np.abs(ring[:, 2] - height) <= _SQUARE]
    return there[:, :2] if len(there) == 2 else None
