"""Borders before and after a surface was meshed anew: no opening may have closed or come up."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

# A border that is further off than this part of its width has shrunk to something else.
_OF_WIDTH = 0.2


@dataclass(frozen=True, eq=False)
class Loops:
    """The border of a surface, loop by loop; loops that touch in a vertex are one.

    Attributes:
        points: (V, 3) coordinates of the surface.
        segments: (K, 2) ends of the border edges.
        loop: (K,) number of the loop of each, from 0.
        pieces: number of connected pieces of the surface.
    """

    points: FloatArray
    segments: IntArray
    loop: IntArray
    pieces: int

    @classmethod
    def of(cls, points: FloatArray, faces: IntArray) -> Loops:
        """Border of faces (F, k) of k corners each."""
        half = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
        pairs, counts = np.unique(np.sort(half, axis=1), axis=0, return_counts=True)
        rim = pairs[counts == 1]
        label = _joined(rim, len(points))[rim[:, 0]]
        loop = np.unique(label, return_inverse=True)[1].ravel()
        pieces = len(np.unique(_joined(pairs, len(points))[faces[:, 0]]))
        return cls(points, rim, loop, pieces)

    @property
    def count(self) -> int:
        """Number of loops."""
        return int(self.loop.max(initial=-1)) + 1

    @cached_property
    def curve(self) -> TriangleSurface:
        """Its segments, as triangles without area."""
        return TriangleSurface(self.points, self.segments[:, [0, 1, 1]])

    @cached_property
    def samples(self) -> FloatArray:
        """(3 K, 3) both ends and the middles of the segments, which run in any direction."""
        ends = self.points[self.segments]
        return np.concatenate([ends[:, 0], ends[:, 1], ends.mean(axis=1)])

    def gaps(self, other: Loops) -> FloatArray:
        """(3 K,) distances of the samples from another border; infinite where that has none."""
        if not self.count or not other.count:
            return np.full(len(self.samples), np.inf)
        feet = other.curve.closest(self.samples)[0]
        return np.asarray(np.linalg.norm(feet - self.samples, axis=1))

    def width(self, loop: int) -> float:
        """Longest side of the box around a loop."""
        return float(np.ptp(self._corners(loop), axis=0).max())

    def words(self, loop: int) -> str:
        """Where a loop is and how large."""
        corners = self._corners(loop)
        centre = 0.5 * (corners.min(axis=0) + corners.max(axis=0))
        place = ", ".join(f"{number:.4g}" for number in centre)
        return f"at ({place}), {self.width(loop):.3g} wide"

    def _corners(self, loop: int) -> FloatArray:
        return np.asarray(self.points[self.segments[self.loop == loop]].reshape(-1, 3))


@dataclass(frozen=True)
class Misfit:
    """How a border differs from the one before.

    Attributes:
        what: in words, with place and size.
        width: of the loop that is meant; None where it came up anew.
    """

    what: str
    width: float | None


def other_loops(before: Loops, after: Loops) -> Misfit | None:
    """What says that two borders have not as many loops, or surfaces not as many pieces; or None.

    They need not lie near each other yet.
    """
    missing = before.count - after.count
    if missing > 0:
        return _lost(before, np.argsort(_far(before, after))[-missing:])
    if before.pieces != after.pieces:
        words = f"the number of pieces becomes {after.pieces} instead of {before.pieces}"
        return Misfit(words, None)
    if missing < 0:
        smallest = min(range(after.count), key=after.width)
        words = f"the number of borders becomes {after.count} instead of {before.count}"
        return Misfit(f"{words}, one {after.words(smallest)}", None)
    return None


def far_loop(before: Loops, after: Loops, reach: float) -> Misfit | None:
    """The loop of a border that a new border does not follow, None where all are near it.

    Args:
        before: the border as it has to be.
        after: the border of the new mesh.
        reach: how far they may be from each other, in the model's unit; further where the border
            itself has longer edges, never so far that a small opening shrinks to nothing.
    """
    lengths = np.zeros(before.count)
    ends = before.points[before.segments]
    np.maximum.at(lengths, before.loop, np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))
    widths = np.array([before.width(loop) for loop in range(before.count)])
    allowed = np.minimum(np.maximum(reach, lengths), _OF_WIDTH * widths)
    lost = np.flatnonzero(_far(before, after) > allowed)
    return _lost(before, lost) if len(lost) else None


def _far(before: Loops, after: Loops) -> FloatArray:
    """(count,) largest distance of each loop from the other border."""
    far = np.zeros(before.count)
    np.maximum.at(far, np.tile(before.loop, 3), before.gaps(after))
    return far


def _lost(before: Loops, loops: IntArray) -> Misfit:
    """Of several loops the smallest is the one that needs the finest mesh."""
    loop = min(loops.tolist(), key=before.width)
    largest = max(range(before.count), key=before.width)
    noun = "the border" if loop == largest else "the opening"
    return Misfit(f"{noun} {before.words(loop)}, is lost", before.width(loop))


def _joined(edges: IntArray, count: int) -> IntArray:
    """(count,) number of the group of vertices that edges (K, 2) join."""
    graph = coo_array((np.ones(len(edges)), edges.T), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)
