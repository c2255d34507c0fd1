"""Sides of plates that are not square to the plate: where they begin, and by how much they lean."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import numpy as np

from freecad_ortho.fabrication.bodies import Polyhedron
from freecad_ortho.fabrication.pattern import Bevel

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
    corners = body.corners.tolist()
    for loop in body.loops:
        ring = [corners[number] for number in loop]
        upper, lower = (
            _level(ring, max(z for _, _, z in ring)),
            _level(ring, min(z for _, _, z in ring)),
        )
        if len(upper) != 2 or len(lower) != 2:
            continue
        normal = np.array(_normal(ring))
        if abs(normal[2]) >= _FACE:
            continue
        apart = np.mean(upper, axis=0) - np.mean(lower, axis=0)
        if np.abs(apart @ normal[:2]) <= _SQUARE * np.linalg.norm(normal[:2]):
            continue
        opens = bool(normal[2] > 0)
        angle = float(np.degrees(np.arcsin(normal[2])))
        bevels.append(Bevel(np.array(upper if opens else lower), angle))
    return tuple(bevels)


def _normal(ring: Sequence[Sequence[float]]) -> tuple[float, float, float]:
    """Unit normal of a plane polygon; numpy takes ten times as long for so few numbers."""
    x0, y0, z0 = ring[0]
    arms = [(x - x0, y - y0, z - z0) for x, y, z in ring[1:]]
    a = b = c = 0.0
    for (x, y, z), (u, v, w) in itertools.pairwise(arms):
        a, b, c = a + y * w - z * v, b + z * u - x * w, c + x * v - y * u
    size = math.sqrt(a * a + b * b + c * c)
    return a / size, b / size, c / size


def _level(ring: Sequence[Sequence[float]], height: float) -> list[list[float]]:
    """What of a polygon lies at a height: x and y of its corners there."""
    return [[x, y] for x, y, z in ring if abs(z - height) <= _SQUARE]
