"""Clash check: every pair of parts that comes near, and the volume that it shares.

Bodies are held as convex pieces. Two convex pieces share nothing where a plane separates them, and
for parts that touch it is one of their own sides: so the depth by which two pieces overlap along
the normals of their sides bounds the volume that they can share. Only pairs that this does not
clear are cut by the CAD kernel.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from freecad_ortho.fabrication.bodies import Loops
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.solids import placed
from freecad_ortho.fabrication.workers import in_chunks
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

# Shared volume, as a part of the smaller part's volume, that counts as contact.
CONTACT = 1e-6
_BATCH = 4096


@dataclass(frozen=True)
class Clash:
    """Two parts in one place.

    Attributes:
        first: name of a part.
        second: name of the other.
        volume: that they share, mm3.
    """

    first: str
    second: str
    volume: float


@dataclass(frozen=True)
class ClashCheck:
    """What was checked and what was found.

    Attributes:
        near: pairs whose boxes meet.
        cut: pairs among them that the CAD kernel had to cut.
        clashes: pairs that share more than contact.
        open: names of pairs that the CAD kernel failed to cut: nothing is known about them.
    """

    near: int
    cut: int
    clashes: tuple[Clash, ...]
    open: tuple[tuple[str, str], ...] = ()

    def report(self) -> dict[str, Any]:
        """Numbers and names, ready for JSON."""
        return {
            "pairs_near": self.near,
            "pairs_cut": self.cut,
            "clashes": [
                {"parts": [clash.first, clash.second], "volume_mm3": clash.volume}
                for clash in self.clashes
            ],
            "pairs_open": [list(pair) for pair in self.open],
        }


def check_clashes(
    parts: Sequence[Part],
    executor: Executor | None = None,
    progress: Callable[[float], None] | None = None,
) -> ClashCheck:
    """Check every pair of parts that comes near.

    Args:
        parts: of one structure.
        executor: for the cuts of the CAD kernel.
        progress: called with the fraction done; may raise to stop.
    """
    base = np.mean([part.origin for part in parts], axis=0)
    pieces, owners = [], []
    for number, part in enumerate(parts):
        for piece in part.body.pieces():
            pieces.append((part.origin - base + piece.corners @ part.frame, piece.loops))
            owners.append(number)
    owner = np.array(owners)
    pairs = _near([points for points, _ in pieces], owner)
    near = np.unique(np.sort(owner[pairs], axis=1), axis=0)
    volume = np.array([part.volume for part in parts])
    shared = _bounds(pieces, pairs) if len(pairs) else np.zeros(0)
    least = volume[owner[pairs]].min(axis=1) if len(pairs) else shared
    open_pairs = np.unique(np.sort(owner[pairs[shared > CONTACT * least]], axis=1), axis=0)
    work = [(parts[i], parts[j]) for i, j in open_pairs.tolist()]
    volumes = in_chunks(_shared_volumes, work, executor, progress, size=8)
    clashes, unknown = [], []
    for (one, other), found in zip(work, volumes, strict=True):
        if found is None:
            unknown.append((one.name, other.name))
        elif found > CONTACT * min(one.volume, other.volume):
            clashes.append(Clash(one.name, other.name, found))
    return ClashCheck(len(near), len(work), tuple(clashes), tuple(unknown))


def _near(points: Sequence[FloatArray], owner: IntArray) -> IntArray:
    """(N, 2) pieces of different owners whose boxes meet, by a sweep along x."""
    low = np.array([piece.min(axis=0) for piece in points])
    high = np.array([piece.max(axis=0) for piece in points])
    order = np.argsort(low[:, 0], kind="stable")
    last = np.searchsorted(low[order, 0], high[order, 0], side="right")
    found = [np.empty((0, 2), dtype=np.int64)]
    for place, end in enumerate(last.tolist()):
        here, others = order[place], order[place + 1 : end]
        meets = (low[others, 1:] <= high[here, 1:]).all(axis=1)
        meets &= (high[others, 1:] >= low[here, 1:]).all(axis=1)
        meets &= owner[others] != owner[here]
        chosen = others[meets]
        found.append(np.stack([np.full(len(chosen), here), chosen], axis=1))
    return np.concatenate(found)


def _bounds(pieces: Sequence[tuple[FloatArray, Loops]], pairs: IntArray) -> FloatArray:
    """(N,) upper bound of the volume that each pair of pieces shares, mm3."""
    kinds: dict[tuple[Loops, Loops], list[int]] = defaultdict(list)
    for number, (i, j) in enumerate(pairs.tolist()):
        kinds[pieces[i][1], pieces[j][1]].append(number)
    result = np.empty(len(pairs))
    for (first, second), numbers in kinds.items():
        for start in range(0, len(numbers), _BATCH):
            some = numbers[start : start + _BATCH]
            one = np.array([pieces[i][0] for i in pairs[some, 0]])
            other = np.array([pieces[j][0] for j in pairs[some, 1]])
            result[some] = _bound(one, first, other, second)
    return result


def _bound(one: FloatArray, first: Loops, other: FloatArray, second: Loops) -> FloatArray:
    """(N,) the same for pieces (N, P, 3) and (N, Q, 3) of one shape each."""
    normals = np.concatenate([_normals(one, first), _normals(other, second)], axis=1)
    spans = [np.einsum("nak,npk->nap", normals, points) for points in (one, other)]
    overlap = np.minimum(
        spans[0].max(axis=2) - spans[1].min(axis=2), spans[1].max(axis=2) - spans[0].min(axis=2)
    )
    depth = np.maximum(overlap.min(axis=1), 0.0)
    box = np.minimum(one.max(axis=1), other.max(axis=1))
    box -= np.maximum(one.min(axis=1), other.min(axis=1))
    return depth * (box**2).sum(axis=1)


def _normals(points: FloatArray, loops: Loops) -> FloatArray:
    """(N, A, 3) unit normals of the sides of bodies (N, P, 3)."""
    rows = []
    for loop in loops:
        side = points[:, list(loop)] - points[:, loop[:1]]
        area = np.cross(side[:, 1:-1], side[:, 2:]).sum(axis=1)
        length = np.linalg.norm(area, axis=1, keepdims=True)
        rows.append(area / np.where(length > 0, length, 1.0))
    return np.stack(rows, axis=1)


def _shared_volumes(pairs: Sequence[tuple[Part, Part]]) -> list[float | None]:
    """Volumes that the solids of pairs share, mm3; None where the CAD kernel fails.

    Parts that share nothing with their holes filled share nothing.
    """
    result = []
    for one, other in pairs:
        shared = _shared_volume(_filled(one), _filled(other))
        drilled = any(part.body.filled() is not part.body for part in (one, other))
        if drilled and (shared is None or shared > CONTACT * min(one.volume, other.volume)):
            shared = _shared_volume(one.solid(), other.solid())
        result.append(shared)
    return result


def _filled(part: Part) -> cadquery.Solid:
    """The solid of a part, its holes filled, in its place."""
    body = part.body.filled()
    return part.solid() if body is part.body else placed(body.solid(), part.origin, part.frame)


def _shared_volume(one: cadquery.Solid, other: cadquery.Solid) -> float | None:
    import cadquery
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common

    common = BRepAlgoAPI_Common(one.wrapped, other.wrapped)
    return cadquery.Shape.cast(common.Shape()).Volume() if common.IsDone() else None
