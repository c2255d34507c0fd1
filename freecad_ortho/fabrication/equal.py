"""Which parts are equal: their solids can be laid on each other, with holes, folds and marks.

A part may be turned, but a plate is not flipped over: its marks are on one side. Only the words on
it, which name its neighbours, may differ. Every member of a group is within the tolerance of the
group's first member, so groups do not creep.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

from freecad_ortho.fabrication.drilled import DrilledBody
from freecad_ortho.fabrication.part import Part
from solver.mesh.quadmesh import FloatArray

# Distance, mm, within which all corners, holes and lines of parts lie that lists call equal.
TOLERANCE_MM = 0.5
# Half turns about the axes of a part's own coordinates, and none.
_HALF_TURNS = [np.diag(signs) for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))]


@dataclass(frozen=True, eq=False)
class Copy:
    """How a part comes of another one that is equal to it.

    Attributes:
        first: number of that part, the first of its group; the first is a copy of itself.
        turn: (3, 3) rotation of rows, from the first one's own coordinates to the part's.
        shift: (3,) what they move by then, mm.
    """

    first: int
    turn: FloatArray
    shift: FloatArray


def copies(parts: Sequence[Part], tolerance: float) -> list[Copy]:
    """For each part the first one that it is equal to, and the motion that lays that one on it.

    Args:
        parts: in any order.
        tolerance: mm; 0 makes no part the copy of another.
    """
    found = [Copy(number, np.eye(3), np.zeros(3)) for number in range(len(parts))]
    if tolerance <= 0:
        return found
    for first, *others in equal_groups(parts, tolerance):
        form = _Form(parts[first], tolerance) if others else None
        for number in others:
            other = _Form(parts[number], tolerance)
            turn = None if form is None else form.turn_onto(other)
            if form is not None and turn is not None:
                found[number] = Copy(first, turn, other.middle - form.middle @ turn)
    return found


def equal_groups(parts: Sequence[Part], tolerance: float = TOLERANCE_MM) -> list[list[int]]:
    """Groups of numbers of equal parts, each with the first of them at its head.

    Args:
        parts: in any order.
        tolerance: distance within which all corners, holes and lines of equal ones lie, mm.
    """
    forms = [_Form(part, tolerance) for part in parts]
    kinds: dict[tuple[str, str], int] = {}
    rows = [
        # The distances move by at most twice as far as corners do.
        [*form.distances, 1e4 * kinds.setdefault((part.kind, part.material.name), len(kinds))]
        + [1e4 * len(form.points), 1e3 * part.thickness]
        for part, form in zip(parts, forms, strict=True)
    ]
    return grouped(
        np.array(rows, dtype=float).reshape(-1, 6),
        2 * tolerance,
        lambda i, j: forms[i].turn_onto(forms[j]) is not None,
    )


def grouped(
    rows: FloatArray, reach: float, same: Callable[[int, int], bool] | None = None
) -> list[list[int]]:
    """Groups of rows: the first free row leads all free ones within reach that are the same."""
    if not len(rows):
        return []
    tree = cKDTree(rows)
    free = np.ones(len(rows), dtype=bool)
    groups = []
    for leader in range(len(rows)):
        if not free[leader]:
            continue
        near = np.array(tree.query_ball_point(rows[leader], reach, p=np.inf))
        others = np.sort(near[free[near] & (near > leader)]).tolist()
        group = [leader] + [k for k in others if same is None or same(leader, k)]
        free[group] = False
        groups.append(group)
    return groups


class _Form:
    """What must coincide, as points in a part's own coordinates about its middle.

    Attributes:
        points: (N, 4) corners of the body, ends of lines, middles of holes; what each of them is
            in the last column, so that only its like is near.
        ring: (M,) corners of the flat pattern as complex numbers, None without one.
        body: (K, 3) corners of the body.
        middle: (3,) that they are measured from, in the part's own coordinates.
        volume: of the solid, mm3.
    """

    def __init__(self, part: Part, tolerance: float) -> None:
        self.tolerance, self.volume = tolerance, part.volume
        pattern, body = part.pattern, part.body.points
        rows = [np.column_stack([body, np.zeros(len(body))])]
        middle, self.ring = body.mean(axis=0), None
        if pattern is not None:
            middle = np.array([*pattern.outline.mean(axis=0), 0.0])
            self.ring = (pattern.outline - middle[:2]) @ np.array([1, 1j])
            flat = [(cut, 1.0) for cut in pattern.cutouts]
            flat += [(bend.points, 2.0) for bend in pattern.bends]
            lines = [mark for mark in pattern.marks if not mark.text]
            flat += [(line.points, 3.0) for line in lines]
            flat += [(hole.centre[None], 10 + hole.diameter) for hole in pattern.holes]
            for points, what in flat:
                marked = np.array([0.0, 1e3 * what])
                rows.append(np.column_stack([points, np.tile(marked, (len(points), 1))]))
        elif isinstance(part.body, DrilledBody):
            for drill in part.body.drills:
                rows.append(np.append(drill.centre, 1e3 * (10 + drill.diameter))[None])
        self.points = np.concatenate(rows) - [*middle, 0.0]
        self.body, self.middle = body - middle, middle

    @property
    def distances(self) -> tuple[float, float, float]:
        """Least, mean and largest distance of the body's corners from their middle, mm."""
        away = np.linalg.norm(self.body - self.body.mean(axis=0), axis=1)
        return float(away.min()), float(away.mean()), float(away.max())

    @cached_property
    def _tree(self) -> cKDTree:
        return cKDTree(self.points)

    @cached_property
    def _body_tree(self) -> cKDTree:
        return cKDTree(self.body)

    @cached_property
    def _pivot(self) -> int:
        """Corner far from z that has the fewest like it, in distance from z and height."""
        away, reach = np.hypot(self.body[:, 0], self.body[:, 1]), 2 * self.tolerance
        far = np.flatnonzero(away >= away.max() / 2)
        level = self.body[:, 2]
        alike = np.abs(away[far, None] - away) <= reach
        alike &= np.abs(level[far, None] - level) <= reach
        return int(far[np.lexsort((-away[far], alike.sum(axis=1)))[0]])

    def turn_onto(self, other: _Form) -> FloatArray | None:
        """The rotation (3, 3) of rows that lays this form on another of as many points, if any."""
        if abs(self.volume - other.volume) > self.tolerance * self._box_area:
            return None
        fitting = (turn for turn in self._turns(other) if self._lies_on(other, turn))
        return next(fitting, None)

    @property
    def _box_area(self) -> float:
        """Area of the body's box, mm2: what its volume may change by for 1 mm."""
        a, b, c = np.ptp(self.body, axis=0).tolist()
        return float(2 * (a * b + b * c + c * a))

    def _lies_on(self, other: _Form, turn: FloatArray) -> bool:
        """Tell whether it does, turned by this rotation (3, 3) that takes rows."""
        moved, within = (
            np.column_stack([self.points[:, :3] @ turn, self.points[:, 3]]),
            self.tolerance,
        )
        if other._tree.query(moved, distance_upper_bound=within)[0].max() > within:
            return False
        return bool(cKDTree(moved).query(other.points)[0].max() <= within)

    def _turns(self, other: _Form) -> Iterator[FloatArray]:
        """Rotations that may lay it on the other."""
        if self.ring is not None and other.ring is not None:
            yield from _plane_turns(self.ring, other.ring, self.tolerance)
        elif self.ring is other.ring:
            if self._may_lie_on(other):
                yield from _HALF_TURNS
                yield from self._turns_about_axis(other)

    def _may_lie_on(self, other: _Form) -> bool:
        """Rule out at once that a half turn, or any turn about z, lays it on the other.

        A turn that does brings the pivot to within the tolerance of a corner of the other, so it is
        nearly the one that brings it into the direction of that: no point is far off then either.
        """
        turns, slack = _HALF_TURNS, np.full((len(_HALF_TURNS), 1), self.tolerance)
        x, y, level = self.body[self._pivot].tolist()
        away, within = np.hypot(x, y), self.tolerance
        if away <= 2 * within:
            return True
        places = other.body[np.abs(other.body[:, 2] - level) <= 2 * within]
        places = places[np.abs(np.hypot(places[:, 0], places[:, 1]) - away) <= 2 * within]
        angles = np.arctan2(places[:, 1], places[:, 0]) - np.arctan2(y, x)
        turns = [*turns, *(_about_z(angle) for angle in angles.tolist())]
        farthest = np.hypot(self.points[:, 0], self.points[:, 1]).max()
        about = within + float(farthest * np.arcsin(within / away))
        slack = np.concatenate([slack, np.full((len(angles), 1), about)]) * (1 + 1e-6)
        moved = np.concatenate(
            [np.column_stack([self.points[:, :3] @ t, self.points[:, 3]]) for t in turns]
        )
        apart = cdist(moved, other.points).reshape(len(turns), len(self.points), -1)
        fits = (apart.min(axis=2) <= slack).all(axis=1) & (apart.min(axis=1) <= slack).all(axis=1)
        return bool(fits.any())

    def _turns_about_axis(self, other: _Form) -> Iterator[FloatArray]:
        """Turns about z that bring its outermost corner near to one of the other's."""
        mine, others = (form.body[:, :2] @ np.array([1, 1j]) for form in (self, other))
        far = int(np.abs(mine).argmax())
        near = np.abs(np.abs(others) - np.abs(mine[far])) <= 2 * self.tolerance
        near &= np.abs(other.body[:, 2] - self.body[far, 2]) <= 2 * self.tolerance
        for place in others[near]:
            turn = _about_z(np.angle(place / mine[far]))
            # The nearest corners say more exactly how far it is to be turned.
            moved = self.body @ turn
            nearest = others[other._body_tree.query(moved)[1]]
            rest = np.angle((nearest * (moved[:, :2] @ np.array([1, -1j]))).sum())
            yield turn @ _about_z(rest)


def _plane_turns(one: FloatArray, other: FloatArray, tolerance: float) -> Iterator[FloatArray]:
    """Turns that lay the corners of an outline on those of another, in their order."""
    count = len(one)
    if count != len(other):
        return
    shifted = other[(np.arange(count)[:, None] + np.arange(count)) % count]
    turn = shifted @ one.conj()
    turn /= np.maximum(np.abs(turn), np.finfo(float).tiny)
    miss = np.abs(shifted - turn[:, None] * one).max(axis=1)
    for fitting in turn[miss <= tolerance]:
        yield _about_z(float(np.angle(fitting)))


def _about_z(angle: float) -> FloatArray:
    """(3, 3) turns rows counter-clockwise."""
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.array([[cosine, sine, 0.0], [-sine, cosine, 0.0], [0.0, 0.0, 1.0]])
