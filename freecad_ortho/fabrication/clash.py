"""Clash check: every pair of parts that comes near, and the volume that it shares.

Bodies are held as convex pieces. Two convex pieces share nothing where a plane separates them, and
for parts that touch it is one of their own sides: so the depth by which two pieces overlap along
the normals of their sides bounds the volume that they can share. What this does not clear is
clipped: for bodies that their pieces make up exactly that gives the shared volume, for all others
an upper bound. Of twisted and drilled bodies there are pieces that lie within them, too: what
these share outside of the holes is a lower bound. The CAD kernel cuts only pairs of curved,
drilled or notched parts that the bounds leave open, and what it finds beyond the upper bound does
not count: at sides that nearly lie in one plane its boolean operations may find a volume where
there is none.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from freecad_ortho.fabrication.bodies import Body, Loops, Polyhedron
from freecad_ortho.fabrication.convex import (
    ConvexHull,
    boxes_meet,
    convex_pieces,
    core,
    overlapping,
    shared_volume,
    volume_bounds,
)
from freecad_ortho.fabrication.drilled import DrilledBody
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.workers import in_chunks
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray

if TYPE_CHECKING:
    import cadquery

# Shared volume, as a part of the smaller part's volume, that counts as contact.
CONTACT = 1e-6
# Share of a body's volume by which polyhedra that are the body may miss it.
_SAME_VOLUME = 1e-9
# Of the bounds of the volume of a clash, the lower one as a part of the upper one, from which on
# the middle will do: it is off by a seventh at most.
_CLOSE = 0.75
# How many times as many pieces bent bodies are held by where theirs leave bounds too far apart; the
# CAD kernel takes seconds to cut two of them.
_FINER = 8
# Fractions done when the pairs that come near are known, and when they are clipped.
_SORTED, _CLIPPED = 0.2, 0.5
_BETWEEN_WORDS = 64


@dataclass(frozen=True)
class Clash:
    """Two parts in one place.

    Attributes:
        first: name of a part.
        second: name of the other.
        volume: that they share, mm3; to a seventh where parts are drilled or twisted.
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
        progress: called with the fraction done, between any two cuts too; may raise to stop.
    """
    say = progress or (lambda fraction: None)
    bodies = _Bodies(parts)
    pairs = _near([piece.corners for piece in bodies.pieces], bodies.owner)
    say(_SORTED)
    near = np.unique(np.sort(bodies.owner[pairs], axis=1), axis=0)
    open_pairs = bodies.open_pairs(pairs)
    known: dict[tuple[int, int], float | None] = {}
    bounds: dict[tuple[int, int], float] = {}
    for number, pair in enumerate(open_pairs):
        if number % _BETWEEN_WORDS == 0:
            say(_SORTED + (_CLIPPED - _SORTED) * number / len(open_pairs))
        least, most = bodies.shared(*pair)
        if bodies.will_do(*pair, least, most):
            known[pair] = (least + most) / 2
        else:
            bounds[pair] = most
    work = [(parts[i], parts[j]) for i, j in bounds]
    volumes = in_chunks(
        _cut_by_kernel, work, executor, lambda done: say(_CLIPPED + (1 - _CLIPPED) * done), size=1
    )
    for (pair, bound), found in zip(bounds.items(), volumes, strict=True):
        known[pair] = None if found is None else min(found, bound)
    clashes, unknown = [], []
    for i, j in open_pairs:
        found, names = known[i, j], (parts[i].name, parts[j].name)
        if found is None:
            unknown.append(names)
        elif found > bodies.contact(i, j):
            clashes.append(Clash(*names, found))
    return ClashCheck(len(near), len(work), tuple(clashes), tuple(unknown))


class _Bodies:
    """The parts as convex pieces, near the origin."""

    def __init__(self, parts: Sequence[Part]) -> None:
        self.parts = parts
        self.base = np.mean([part.origin for part in parts], axis=0)
        found = [self._placed(part, part.body.pieces()) for part in parts]
        self.pieces = convex_pieces([piece for some in found for piece in some])
        self.owner: IntArray = np.repeat(np.arange(len(parts)), [len(some) for some in found])
        self.fillings: dict[int, _Filling] = {}

    def _placed(self, part: Part, pieces: Sequence[Polyhedron]) -> list[tuple[FloatArray, Loops]]:
        origin = part.origin - self.base
        return [(origin + piece.corners @ part.frame, piece.loops) for piece in pieces]

    def open_pairs(self, pairs: IntArray) -> list[tuple[int, int]]:
        """Pairs of parts that the depth by which pieces (N, 2) overlap does not clear."""
        if not len(pairs):
            return []
        volume = np.array([part.volume for part in self.parts])
        shared = volume_bounds(self.pieces, pairs)
        owners = np.sort(self.owner[pairs], axis=1)
        left = owners[shared > CONTACT * volume[owners].min(axis=1)]
        return [(i, j) for i, j in np.unique(left, axis=0).tolist()]

    def shared(self, i: int, j: int) -> tuple[float, float]:
        """Bounds from below and above of the volume that two parts share, mm3.

        They are the same where that is known exactly.
        """
        least, most = self._bounds(i, j, self._filling(i), self._filling(j))
        if self.will_do(i, j, least, most):
            return least, most
        return self._bounds(i, j, *self._finer(i, j))

    def will_do(self, i: int, j: int, least: float, most: float) -> bool:
        """Whether bounds say how much two parts share: it is known, or a clash to a seventh."""
        return least == most or least > max(self.contact(i, j), _CLOSE * most)

    def _bounds(self, i: int, j: int, one: _Filling, other: _Filling) -> tuple[float, float]:
        most = shared_volume(one.pieces, other.pieces)
        if (one.exact and other.exact) or most <= self.contact(i, j):
            return most, most
        return shared_volume(one.core, other.core, [*one.holes, *other.holes]), most

    def contact(self, i: int, j: int) -> float:
        """Volume that two parts may share, mm3."""
        return CONTACT * min(self.parts[i].volume, self.parts[j].volume)

    def _filling(self, number: int) -> _Filling:
        if number not in self.fillings:
            self.fillings[number] = self._filled(self.parts[number])
        return self.fillings[number]

    def _finer(self, i: int, j: int) -> list[_Filling]:
        """Fillings of more pieces, of what is near to the other part only."""
        one, other = self._filling(i), self._filling(j)
        boxes = np.array([one.pieces[k].box for k, _ in overlapping(one.pieces, other.pieces)])
        where = boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)
        found = []
        for number, loose in ((i, one), (j, other)):
            part = self.parts[number]
            placed = self._placed(part, part.body.filling(_FINER))
            corners = [points for points, _ in placed]
            near = boxes_meet(np.array([[p.min(axis=0), p.max(axis=0)] for p in corners]), where)
            pieces = convex_pieces([placed[k] for k in np.flatnonzero(near)])
            cores = [core(piece) for piece in pieces] if loose.core else []
            found.append(_Filling(pieces, False, cores, loose.holes))
        return found

    def _filled(self, part: Part) -> _Filling:
        body: Body = part.body
        holes: Sequence[Polyhedron] = ()
        if isinstance(part.body, DrilledBody):
            body, holes = part.body.whole, part.body.holes()
        filling = body.filling()
        pieces = convex_pieces(self._placed(part, filling))
        whole = all(piece.convex for piece in pieces) and _add_up(filling, body)
        return _Filling(
            pieces,
            whole and not holes,
            [core(piece) for piece in pieces] if whole or body.in_cells else [],
            convex_pieces(self._placed(part, holes)),
        )


@dataclass(frozen=True, eq=False)
class _Filling:
    """Pieces that hold a part most closely.

    Attributes:
        pieces: that together hold the part.
        exact: they are nothing but the part.
        core: pieces that lie in the part but for its holes, none where none are known.
        holes: pieces that hold these.
    """

    pieces: list[ConvexHull]
    exact: bool
    core: list[ConvexHull]
    holes: list[ConvexHull]


def _add_up(filling: Sequence[Polyhedron], body: Body) -> bool:
    """Whether polyhedra that together hold a body have its volume, so are nothing but it."""
    volume = sum(polyhedron.volume for polyhedron in filling)
    return abs(volume - body.volume) <= _SAME_VOLUME * body.volume


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


def _cut_by_kernel(pairs: Sequence[tuple[Part, Part]]) -> list[float | None]:
    """Volumes that the solids of pairs share, mm3; None where the CAD kernel fails."""
    return [_shared_volume(one.solid(), other.solid()) for one, other in pairs]


def _shared_volume(one: cadquery.Solid, other: cadquery.Solid) -> float | None:
    import cadquery
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common

    common = BRepAlgoAPI_Common(one.wrapped, other.wrapped)
    return cadquery.Shape.cast(common.Shape()).Volume() if common.IsDone() else None
