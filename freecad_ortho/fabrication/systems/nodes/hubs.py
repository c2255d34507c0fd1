"""Hubs: prisms about the node axes with a face square to every beam."""

from __future__ import annotations

import numpy as np

from freecad_ortho.fabrication.bodies import Prism
from freecad_ortho.fabrication.systems.beams.end_plates import WIDEST
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray


def hub(angles: FloatArray, radius: float, low: float, high: float, bore: float) -> Prism:
    """The hub of one node.

    Args:
        angles: (K,) directions of the beams around the axis, counter-clockwise, radians.
        radius: from the axis to the faces, mm.
        low: lower end along the axis, mm.
        high: upper end, mm.
        bore: diameter of a hole along the axis, mm; 0 for none.

    Returns:
        A prism along z; two faces that are almost in one plane become one corner less.
    """
    return Prism(outline(face_normals(angles)[0], radius), low, high, bore)


def face_normals(angles: FloatArray) -> tuple[FloatArray, IntArray]:
    """Directions (N,) of the faces of a hub, and the numbers (K,) of those of its beams."""
    normals: list[float] = []
    own = []
    for angle, gap in zip(angles.tolist(), gaps_after(angles).tolist(), strict=True):
        steps = int(np.ceil(gap / WIDEST))
        own.append(len(normals))
        normals.extend((angle + gap * np.arange(steps) / steps).tolist())
    return np.array(normals), np.array(own)


def outline(normals: FloatArray, radius: float) -> FloatArray:
    """(N, 2) corners of a polygon around a circle, each after the side with that normal."""
    half = gaps_after(normals) / 2
    corner = normals + half
    reach = radius / np.cos(half)
    return np.stack([reach * np.cos(corner), reach * np.sin(corner)], axis=1)


def face_widths(angles: FloatArray, radius: float) -> FloatArray:
    """(K,) the width of the hub's face that is free for each beam on its narrower side, twice."""
    half = np.minimum(gaps_after(angles), WIDEST) / 2
    return np.asarray(2 * radius * np.tan(np.minimum(half, np.roll(half, 1))))


def gaps_after(angles: FloatArray) -> FloatArray:
    """(K,) angle from each direction to the next, 2 pi where there is one only."""
    gaps = (np.roll(angles, -1) - angles) % (2 * np.pi)
    return np.asarray(np.where(gaps > 0, gaps, 2 * np.pi))
