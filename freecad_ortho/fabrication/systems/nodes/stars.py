"""The beams around each vertex, in their order."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from freecad_ortho.fabrication.systems.beams.frames import Around, Frames
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray


class Star(NamedTuple):
    """The K beams of a vertex, counter-clockwise from the half-edge with the smallest number.

    Attributes:
        vertex: its number.
        half_edges: (K,) their numbers, see ``Around``.
        arms: (K, 3) directions of the beams, away from it.
        turn: (K,) their angles around the axis from the first, radians.
    """

    vertex: int
    half_edges: IntArray
    arms: FloatArray
    turn: FloatArray


def stars(frames: Frames, around: Around) -> Iterator[Star]:
    """Those of all vertices that have beams, in their order."""
    half_edges = np.flatnonzero(around.left >= 0)
    order = half_edges[np.argsort(around.vertex[half_edges], kind="stable")]
    for group in np.split(order, np.flatnonzero(np.diff(around.vertex[order])) + 1):
        ring = [int(group.min())]
        while (ahead := int(around.left[ring[-1]])) != ring[0]:
            ring.append(ahead)
        count = len(frames.along)
        numbers = np.array(ring)
        outward = np.where(numbers < count, 1.0, -1.0)[:, None]
        turn = np.concatenate([[0.0], np.cumsum(around.angle[numbers[:-1]])])
        arms = outward * frames.along[numbers % count]
        yield Star(int(around.vertex[ring[0]]), numbers, arms, turn)
