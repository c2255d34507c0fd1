"""What an edge beam takes of the beams that end at it, and what it leaves of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.systems.beams.frames import Frames
from freecad_ortho.fabrication.systems.edge_beam.geometry import EdgeGeometry
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray

# A beam's lower right, lower left, upper left, upper right edge: sides and levels.
_SIDES, _LEVELS = np.array([1.0, -1.0, -1.0, 1.0]), np.array([0, 0, 1, 1])
# The first so many places of a block are on the edges of the beam.
_EDGES = 4


class Block(NamedTuple):
    """What a piece of an edge beam takes of a beam, at K places of its section.

    On the beam's four edges, then where the piece's upright edges pass its lower and upper side,
    then its right and left one.

    Attributes:
        normal: (3,) of the piece's sides.
        low: (K,) where it begins along the beam, mm.
        high: (K,) where it ends.
        right: (K,) how far to the right of the beam's plane, mm.
        up: (K,) how far up, mm.
        met: (K,) true for places at which it takes anything.
    """

    normal: FloatArray
    low: FloatArray
    high: FloatArray
    right: FloatArray
    up: FloatArray
    met: BoolArray

    @property
    def span(self) -> tuple[float, float]:
        """What it takes at any of them."""
        return float(self.low[self.met].min()), float(self.high[self.met].max())


def blocks_of(
    edge_beam: EdgeGeometry, site: Site, frames: Frames, levels: tuple[float, float], half: float
) -> dict[int, list[Block]]:
    """By edge, what the pieces of an edge beam take of its beam."""
    start = site.mesh.vertices[site.mesh.connectivity.edges[:, 0]]
    axes = np.stack([frames.along, frames.up, -frames.left], axis=1)
    ups = np.multiply.outer(frames.rise, levels)
    rights = np.broadcast_to(half * _SIDES, (len(start), _EDGES))
    section = np.stack([0 * rights, ups[:, _LEVELS], rights], axis=2)
    lines = start[:, None] + np.einsum("epc,eck->epk", section, axes)
    blocks: dict[int, list[Block]] = {}
    for piece, rows, low, high in edge_beam.blocked(lines, frames.along):
        arms = edge_beam.uprights[piece] - start[rows][:, None, None]
        local = np.einsum("mpek,mck->mpec", arms, axes[rows])
        passed = _passing(local, ups[rows], 1)
        beside = _passing(local, np.broadcast_to([half, -half], (len(rows), 2)), 2)
        places = section[rows, :, 1:], passed[..., 1:], beside[..., 1:]
        stations = np.concatenate([passed[..., 0], beside[..., 0]], axis=1)
        lower, upper = ups[rows].T[..., None]
        within = (lower <= beside[..., 1]) & (beside[..., 1] <= upper)
        # Lines along the sides have no place on them.
        within &= np.abs(beside[..., 2]) <= half * (1 + 1e-9)
        met = np.concatenate([low < high, np.abs(passed[..., 2]) <= half, within], axis=1)
        low, high = (np.concatenate([one, stations], axis=1) for one in (low, high))
        up, right = np.moveaxis(np.concatenate(places, axis=1), 2, 0)
        normal = edge_beam.frame[piece, 2]
        for row in np.flatnonzero(met.any(axis=1)).tolist():
            taken = (low[row], high[row], right[row], up[row], met[row])
            blocks.setdefault(int(rows[row]), []).append(Block(normal, *taken))
    return blocks


def _passing(lines: FloatArray, levels: FloatArray, axis: int) -> FloatArray:
    """(M, P * 2, 3) where lines through two points (M, P, 2, 3) pass two levels (M, 2) of an axis.

    Where they run along a level, where they begin.
    """
    foot, way = lines[:, :, :1], lines[:, :, 1:] - lines[:, :, :1]
    rise = np.where(np.abs(way[..., axis]) > 0, way[..., axis], np.inf)
    share = (levels[:, None] - foot[..., axis]) / rise
    return np.asarray((foot + share[..., None] * way).reshape(len(lines), -1, 3))


# Where a beam ends before an edge beam at its start and end, mm; None where it does not.
Bounds = tuple[float | None, float | None]


def free_stretch(
    spans: Sequence[tuple[float, float]], blocks: Sequence[Block], length: float
) -> tuple[tuple[float, float], Bounds] | None:
    """The longest stretch of spans, as parts of a length, that nothing takes; None for none."""
    best: tuple[tuple[float, float], Bounds] | None = None
    for start, end in spans:
        begins: float | None = None
        reached = start * length
        for low, high in sorted(block.span for block in blocks):
            if high <= reached or low >= end * length:
                continue
            if low > reached:
                best = _longer(best, (reached, low), (begins, low), length)
            begins = reached = max(high, reached)
        if reached < end * length:
            best = _longer(best, (reached, end * length), (begins, None), length)
    return best


def _longer(
    best: tuple[tuple[float, float], Bounds] | None,
    span: tuple[float, float],
    bounds: Bounds,
    length: float,
) -> tuple[tuple[float, float], Bounds]:
    share = span[0] / length, span[1] / length
    if best is None or share[1] - share[0] > best[0][1] - best[0][0]:
        return share, bounds
    return best


def beyond_end(blocks: Sequence[Block], bounds: Bounds, end: int) -> list[Block]:
    """The blocks beyond the end of a beam."""
    bound = bounds[end]
    assert bound is not None
    if end:
        return [block for block in blocks if block.span[0] >= bound]
    return [block for block in blocks if block.span[1] <= bound]


def mean_normal(blocks: Sequence[Block], end: int) -> FloatArray:
    """(3,) mean normal of what is nearest to the end along each edge of a beam."""
    found = []
    for place in range(_EDGES):
        met = [block for block in blocks if block.met[place]]
        if met and end:
            found.append(min(met, key=lambda block: float(block.low[place])).normal)
        elif met:
            found.append(max(met, key=lambda block: float(block.high[place])).normal)
    normals = np.array(found or [blocks[0].normal])
    signs = np.where(normals @ normals[0] < 0, -1.0, 1.0)
    return np.asarray(signs @ normals)


def cut_before(blocks: Sequence[Block], end: int, lean: float, slant: float) -> float:
    """How far along a beam's middle a cut lies that leaves all blocks, mm."""
    places = [
        (block.low if end else block.high) - slant * block.right - lean * block.up
        for block in blocks
    ]
    met = np.concatenate([block.met for block in blocks])
    left = np.concatenate(places)[met]
    return float(left.min() if end else left.max())
