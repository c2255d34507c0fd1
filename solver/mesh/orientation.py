"""Faces turned until neighbours agree, or the face that stands in the way."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray


def oriented(vertices: FloatArray, faces: IntArray, remarks: list[str]) -> IntArray:
    """Reverse faces until every inner edge runs in both directions.

    Args:
        vertices: (V, 3) coordinates.
        faces: (F, 4) vertex numbers.
        remarks: gets a sentence where faces were reversed.

    Returns:
        (F, 4) vertex numbers; the larger part of each component is as it was.

    Raises:
        InputError: edges with more than two faces, corners in crossed order, a one-sided component.
    """
    keep = _kept(
        _Sides.of_quads(faces),
        remarks,
        lambda conflict: _refuse_conflict(vertices, faces, conflict),
    )
    return np.where(keep[:, None], faces, faces[:, [0, 3, 2, 1]])


def oriented_polygons(polygons: Sequence[Sequence[int]], remarks: list[str]) -> list[Sequence[int]]:
    """The same for faces with any number of corners.

    Args:
        polygons: vertex numbers of each face.
        remarks: gets a sentence where faces were reversed.

    Raises:
        InputError: edges with more than two faces, a one-sided component.
    """
    pairs = [pair for face in polygons for pair in zip(face, [*face[1:], face[0]], strict=True)]
    owners = np.repeat(np.arange(len(polygons)), [len(face) for face in polygons])
    sides = _Sides(np.array(pairs, dtype=np.int64), owners, len(polygons))
    keep = _kept(sides, remarks, lambda conflict: _refuse_twist(sides, conflict))
    chosen = zip(polygons, keep.tolist(), strict=True)
    return [face if kept else [face[0], *face[:0:-1]] for face, kept in chosen]


@dataclass(frozen=True, eq=False)
class _Sides:
    """(H, 2) edges of faces in their direction, the face (H,) of each, and the number of faces."""

    ends: IntArray
    faces: IntArray
    count: int

    @classmethod
    def of_quads(cls, faces: IntArray) -> _Sides:
        ends = np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2)
        return cls(ends, np.repeat(np.arange(len(faces)), 4), len(faces))


def _kept(sides: _Sides, remarks: list[str], refuse: Callable[[BoolArray], None]) -> BoolArray:
    """(F,) true for the faces that stay as they are, where all can agree."""
    _refuse_crowded_edges(sides)
    label = _copies(sides)
    count = sides.count
    as_given, reversed_ = label[:count], label[count:]
    if (as_given == reversed_).any():
        refuse(as_given == reversed_)
    # Of the two orientations of a component, take the one that more of its faces already have.
    votes = np.bincount(as_given, minlength=label.max() + 1)
    first_seen = np.full(label.max() + 1, count)
    np.minimum.at(first_seen, as_given, np.arange(count))
    keep = votes[as_given] > votes[reversed_]
    tie = votes[as_given] == votes[reversed_]
    keep |= tie & (first_seen[as_given] < first_seen[reversed_])
    if not keep.all():
        turned, first_turned = int((~keep).sum()), int(np.argmin(keep))
        remarks.append(
            f"{turned} faces were oriented against their neighbours "
            f"(first: face {first_turned}); reversed"
            if turned > 1
            else f"face {first_turned} was oriented against its neighbours; reversed"
        )
    return np.asarray(keep)


def _refuse_crowded_edges(sides: _Sides) -> None:
    pairs, counts = np.unique(np.sort(sides.ends, axis=1), axis=0, return_counts=True)
    if (counts > 2).any():
        edge = pairs[np.argmax(counts > 2)].tolist()
        raise InputError(
            f"edges: {int((counts > 2).sum())} have more than two faces, the first is edge "
            f"{edge[0]} - {edge[1]}; split the mesh there or remove double faces"
        )


def _shared_edges(sides: _Sides) -> tuple[IntArray, IntArray, BoolArray]:
    """The two faces (K,) at each inner edge, and whether they run along it in both directions."""
    inverse = np.unique(np.sort(sides.ends, axis=1), axis=0, return_inverse=True)[1]
    order = np.argsort(inverse.ravel(), kind="stable")
    shared = np.flatnonzero(np.diff(inverse.ravel()[order]) == 0)
    one, two = order[shared], order[shared + 1]
    return sides.faces[one], sides.faces[two], sides.ends[one, 0] != sides.ends[two, 0]


def _copies(sides: _Sides) -> IntArray:
    """Components of two copies of each face, as given and reversed: each is one orientation.

    Returns:
        (2 F,) label of each copy; a face whose copies are in one component cannot be oriented.
    """
    first, second, agrees = _shared_edges(sides)
    count = sides.count
    rows = np.concatenate([first, first + count])
    columns = np.concatenate(
        [np.where(agrees, second, second + count), np.where(agrees, second + count, second)]
    )
    graph = coo_array((np.ones(len(rows)), (rows, columns)), shape=(2 * count, 2 * count))
    label: IntArray = connected_components(graph, directed=False)[1]
    return label


def _refuse_conflict(vertices: FloatArray, faces: IntArray, conflict: BoolArray) -> None:
    """Name the faces with crossed corners, or two faces where the orientation breaks."""
    uncrossed, crossed = _uncrossed(vertices, faces)
    crossed &= conflict
    if crossed.any():
        mended = np.where(crossed[:, None], uncrossed, faces)
        label = _copies(_Sides.of_quads(mended))
        if (label[: len(faces)] != label[len(faces) :]).all():
            some = np.flatnonzero(crossed)
            more = f" (and {len(some) - 1} more)" if len(some) > 1 else ""
            raise InputError(
                f"faces: face {some[0]}{more} has its corners in crossed order (a bow tie); list "
                f"them round the face: {' '.join(map(str, mended[some[0]]))}"
            )
    _refuse_twist(_Sides.of_quads(faces), conflict)


def _refuse_twist(sides: _Sides, conflict: BoolArray) -> None:
    """Name two faces where the orientation breaks."""
    start = int(np.argmax(conflict))
    one, two = _break(sides, start)
    raise InputError(
        f"faces: the component of face {start} cannot be oriented: it closes with a twist between "
        f"faces {one} and {two} (a Moebius band, or a face with corners in wrong order); mend the "
        "face or cut along one row of edges"
    )


def _uncrossed(vertices: FloatArray, faces: IntArray) -> tuple[IntArray, BoolArray]:
    """Faces in the order that makes opposite sides short, and which of them that changes.

    The diagonals of a convex quad are together longer than either pair of opposite sides.
    """
    corners = vertices[faces]

    def length(i: int, j: int) -> FloatArray:
        found: FloatArray = np.linalg.norm(corners[:, i] - corners[:, j], axis=1)
        return found

    pairs = np.stack(
        [length(0, 2) + length(1, 3), length(0, 1) + length(2, 3), length(1, 2) + length(3, 0)]
    )
    longest = np.argmax(pairs, axis=0)
    # What is longest are the diagonals, whatever the file calls them.
    orders = np.array([[0, 1, 2, 3], [0, 2, 1, 3], [0, 1, 3, 2]])
    return np.take_along_axis(faces, orders[longest], axis=1), longest > 0


def _break(sides: _Sides, start: int) -> tuple[int, int]:
    """Two neighbours that disagree after all faces were oriented outwards from ``start``."""
    neighbours: dict[int, list[tuple[int, bool]]] = {}
    for one, two, agrees in zip(*(part.tolist() for part in _shared_edges(sides)), strict=True):
        neighbours.setdefault(one, []).append((two, agrees))
        neighbours.setdefault(two, []).append((one, agrees))
    kept, queue = {start: True}, deque([start])
    while queue:
        face = queue.popleft()
        for other, agrees in neighbours[face]:
            wanted = kept[face] == agrees
            if other not in kept:
                kept[other] = wanted
                queue.append(other)
            elif kept[other] != wanted:
                return min(face, other), max(face, other)
    raise AssertionError("asked for a component that can be oriented")
