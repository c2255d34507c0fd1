"""Where the strips of an edge beam begin and end, and the lines along which they are bent.

The strip between two joints is plane where its edge e and the directions r, s of the bend lines at
its ends are: det(r, s, e) = 0; its ends lie in the planes of the mitres. Of all such directions
those nearest to the axes are taken; they rather lean across the strip than along it, where it would
be bent along slanting lines. Where they slant too far none the less, another strip begins.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, unit_rows

# Length of a strip where no stock is given, mm: that of a usual sheet.
SHEET = 6000.0
# Turns that are welded rather than bent, degrees.
_SHARP = 30.0
# A bend line leans at most so far from square to the strip, and across it from the axis: sines.
_SLANTED, _LEANING = 0.5, 0.2
# Rounds in which directions settle, and how far from plane they may be left.
_ROUNDS = 60
_PLANE = 1e-12
# How much dearer it is to lean along than across, per square of the lean.
_ALONG = 25.0


@dataclass(frozen=True, eq=False)
class Strips:
    """What pieces of an edge beam are made of.

    Attributes:
        runs: numbers of the pieces of each strip, in their order.
        rulings: (N, 2, 3) unit directions, upwards, in which each piece starts and ends.
    """

    runs: tuple[IntArray, ...]
    rulings: FloatArray


@dataclass(frozen=True, eq=False)
class StraightPieces:
    """Straight pieces on closed ways, one row a piece.

    Attributes:
        start: (N, 3) where they begin, mm.
        length: (N,) mm.
        along: (N, 3) unit directions.
        axes: (N, 3) unit directions upwards, at their starts.
        before: (N,) the piece before each.
        behind: (N,) and after it.
        way: (N,) number of their closed way.
    """

    start: FloatArray
    length: FloatArray
    along: FloatArray
    axes: FloatArray
    before: IntArray
    behind: IntArray
    way: IntArray

    @property
    def turns(self) -> FloatArray:
        """(N,) by how much each turns from the one before it, about the axis, degrees."""
        right = unit_rows(np.cross(self.along, self.axes))
        other = unit_rows(np.cross(self.along[self.before], self.axes))
        cosine = np.einsum("nk,nk->n", right, other).clip(-1, 1)
        return np.asarray(np.degrees(np.arccos(cosine)))

    def bisectors(self) -> FloatArray:
        """(N, 3) directions square to the mitres at the starts of pieces."""
        return self.along[self.before] + self.along


def strips_of(pieces: StraightPieces, height: float, stock: float) -> Strips:
    """Divide ways into strips no longer than the stock, and find their bend lines.

    Args:
        pieces: of the ways.
        height: of the strips, mm.
        stock: mm.

    Raises:
        InputError: a piece that is longer than the stock.
    """
    foot = pieces.start - height * pieces.axes
    below = np.linalg.norm(foot[pieces.behind] - foot, axis=1)
    lengths = np.maximum(pieces.length, below)
    if lengths.max() > stock:
        raise InputError(
            f"stock: {stock:g} mm are less than the {lengths.max():.0f} mm between two bends of "
            f"the strip along the edge; take {math.ceil(lengths.max())} mm or more"
        )
    wanted: list[IntArray] = []
    for number in range(int(pieces.way.max()) + 1):
        rows = np.flatnonzero(pieces.way == number)
        wanted += _runs(rows, pieces.turns[rows], lengths, stock)
    runs: list[IntArray] = []
    rulings = np.empty((len(lengths), 2, 3))
    while wanted:
        run = wanted.pop(0)
        found = _upright(pieces, run) if len(run) == 1 else _rulings(pieces, run)
        cut = len(run) // 2 if found is None else _worst(pieces, run, found)
        if found is None or cut is not None:
            wanted = [run[:cut], run[cut:], *wanted]
            continue
        runs.append(run)
        rulings[run] = np.stack([found[:-1], found[1:]], axis=1)
    return Strips(tuple(runs), rulings)


def _runs(pieces: IntArray, turns: FloatArray, lengths: FloatArray, stock: float) -> list[IntArray]:
    """The pieces of each strip of a closed way, in their order."""
    sharp = np.flatnonzero(turns > _SHARP)
    # Without a corner a way is cut where it turns most.
    first = int(sharp[0]) if len(sharp) else int(turns.argmax())
    cuts = sorted({0, *((sharp - first) % len(pieces)).tolist()})
    pieces = np.roll(pieces, -first)
    found: list[IntArray] = []
    for start, end in pairwise([*cuts, len(pieces)]):
        found += _shares(pieces[start:end], lengths[pieces[start:end]], stock)
    return found


def _shares(pieces: IntArray, lengths: FloatArray, stock: float) -> list[IntArray]:
    """Pieces in as few and as equal shares as are not longer than the stock."""
    ends = np.cumsum(lengths)
    for count in range(max(1, math.ceil(ends[-1] / stock - 1e-9)), len(pieces) + 1):
        wanted = ends[-1] * np.arange(1, count) / count
        cuts = np.unique(np.abs(ends[:, None] - wanted).argmin(axis=0)) + 1
        cuts = cuts[cuts < len(pieces)]
        if max(float(share.sum()) for share in np.split(lengths, cuts)) <= stock:
            return np.split(pieces, cuts)
    return np.split(pieces, len(pieces))


def _worst(pieces: StraightPieces, run: IntArray, rulings: FloatArray) -> int | None:
    """Where a strip is cut in two as its bend lines lean too far; None where they do not.

    In its middle where they lean across: that builds up along it.
    """
    if len(run) == 1:
        return None
    inner = rulings[1:-1]
    ahead = pieces.along[run]
    slants = [np.abs(np.einsum("nk,nk->n", inner, way)) for way in (ahead[:-1], ahead[1:])]
    across = np.cross(pieces.bisectors()[run[1:]], pieces.axes[run[1:]])
    leans = np.abs(np.einsum("nk,nk->n", inner, unit_rows(across)))
    if leans.max() > _LEANING:
        return len(run) // 2
    slant = np.maximum(*slants)
    return int(slant.argmax()) + 1 if slant.max() > _SLANTED else None


def _upright(pieces: StraightPieces, run: IntArray) -> FloatArray:
    """(2, 3) the ends of a single piece, where its upright plane meets the mitres."""
    ends = np.array([run[0], pieces.behind[run[-1]]])
    along = pieces.along[run[0]]
    right = np.cross(along, pieces.axes[ends].sum(axis=0))
    lines = unit_rows(np.cross(right, pieces.bisectors()[ends]))
    signs = np.sign(np.einsum("nk,nk->n", lines, pieces.axes[ends]))
    return np.asarray(lines * signs[:, None])


def _rulings(pieces: StraightPieces, run: IntArray) -> FloatArray | None:
    """(K + 1, 3) unit directions at the joints of a strip of K pieces; None where none are near."""
    nodes = np.append(run, pieces.behind[run[-1]])
    along, axes = pieces.along[run], pieces.axes[nodes]
    tangents = unit_rows(pieces.bisectors()[nodes])
    # Inverse of the weight of each direction's change.
    ease = np.eye(3) - (1 - 1 / _ALONG) * tangents[:, :, None] * tangents[:, None, :]
    rulings = axes
    for _ in range(_ROUNDS):
        matrix, off = _conditions(along, tangents, rulings)
        if np.abs(off).max() < _PLANE:
            found = unit_rows(rulings)
            upright = np.einsum("nk,nk->n", found, axes).min()
            return found if upright > _SLANTED else None
        # Those nearest to the axes, with the determinants as they are known here.
        wanted = matrix.reshape(len(off), -1) @ axes.ravel() - off * _excess(along)
        eased = np.einsum("nmk,mkc->nmc", matrix, ease)
        normal = np.einsum("nmc,lmc->nl", eased, matrix)
        forces = np.linalg.lstsq(normal, wanted, rcond=1e-12)[0]
        rulings = axes - np.einsum("nmc,n->mc", eased, forces)
    return None


def _excess(along: FloatArray) -> FloatArray:
    """(K + 2,) degree of the conditions less one: two of determinants, one at the ends."""
    return np.append(np.ones(len(along)), [0.0, 0.0])


def _conditions(
    along: FloatArray, tangents: FloatArray, rulings: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Derivatives (K + 2, K + 1, 3) and values (K + 2,) of what bend lines must fulfil.

    det(r, s, e) of each piece, then the ends' part along the directions of their mitres.
    """
    count = len(along)
    start, end = rulings[:-1], rulings[1:]
    rows = np.arange(count)
    matrix = np.zeros((count + 2, count + 1, 3))
    matrix[rows, rows] = np.cross(end, along)
    matrix[rows, rows + 1] = np.cross(along, start)
    matrix[count, 0], matrix[count + 1, -1] = tangents[0], tangents[-1]
    off = np.einsum("nk,nk->n", start, np.cross(end, along))
    ends = np.einsum("nk,nk->n", rulings[[0, -1]], tangents[[0, -1]])
    return matrix, np.append(off, ends)
