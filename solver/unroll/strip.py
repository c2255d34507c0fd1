"""A strip along a polyline: one ruling at every point, and its exact unrollment.

Between two rulings lies a face that contains their edge of the axis. Where the two rulings and the
edge lie in one plane the face is planar and the strip is developable; where not, it twists about
the edge. Either way the flat pattern keeps the length of every edge and both angles between every
ruling and the axis: the axis turns in the pattern by the difference of the two angles.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, row_lengths, unit_rows


@dataclass(frozen=True, eq=False)
class Strip:
    """An axis and its rulings.

    Args:
        points: (K, 3) of the axis, any unit; a closed axis repeats its first point at the end.
        rulings: (K, 3) unit directions, all towards the same side of the axis.

    Raises:
        InputError: fewer than two points, an edge without length, or a ruling along the axis.
    """

    points: FloatArray
    rulings: FloatArray

    def __post_init__(self) -> None:
        if len(self.points) < 2 or self.points.shape != self.rulings.shape:
            raise InputError(
                f"strip: expected at least 2 points and a ruling each, got {len(self.points)} "
                f"points and {len(self.rulings)} rulings"
            )
        refuse_empty_edges(self.points)
        away = np.abs(np.stack([self.before, self.after]) - np.pi / 2)
        worst = away.max(axis=0)
        if worst.max() > np.pi / 2 - 1e-7:
            raise InputError(
                f"strip: the ruling at point {int(worst.argmax())} lies along the axis"
            )

    @cached_property
    def lengths(self) -> FloatArray:
        """(K - 1,) of the axis' edges."""
        return row_lengths(np.diff(self.points, axis=0))

    @cached_property
    def along(self) -> FloatArray:
        """(K - 1, 3) unit directions of the axis' edges."""
        return unit_rows(np.diff(self.points, axis=0))

    @cached_property
    def before(self) -> FloatArray:
        """(K,) angle from the edge that ends at each point to its ruling; at the start: begins."""
        edges = np.concatenate([self.along[:1], self.along])
        return angle_between(edges, self.rulings)

    @cached_property
    def after(self) -> FloatArray:
        """(K,) angle from the edge that begins at each point to its ruling; at the end: ends."""
        edges = np.concatenate([self.along, self.along[-1:]])
        return angle_between(edges, self.rulings)

    @cached_property
    def slant(self) -> FloatArray:
        """(K,) mean angle between axis and ruling, in (0, pi)."""
        return 0.5 * (self.before + self.after)

    @cached_property
    def turns(self) -> FloatArray:
        """(K,) by how much the axis turns towards the ruling in the pattern; 0 at both ends."""
        return self.before - self.after

    @cached_property
    def headings(self) -> FloatArray:
        """(K - 1,) direction of each edge in the pattern, the first along x."""
        return np.asarray(np.cumsum(self.turns[:-1]))

    @cached_property
    def flat_points(self) -> FloatArray:
        """(K, 2) the axis in the pattern, from the origin."""
        steps = self.lengths[:, None] * _directions(self.headings)
        return np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])

    @cached_property
    def flat_rulings(self) -> FloatArray:
        """(K, 2) unit directions of the rulings in the pattern, on the left of the axis."""
        last = self.headings[-1] + self.before[-1]
        return _directions(np.append(self.headings + self.after[:-1], last))

    @cached_property
    def across(self) -> tuple[FloatArray, FloatArray]:
        """(K - 1, 3) twice: unit normals to each edge in its face, at its start and at its end."""
        start, end = self.rulings[:-1], self.rulings[1:]
        return _without(start, self.along), _without(end, self.along)

    @cached_property
    def twists(self) -> FloatArray:
        """(K - 1,) angle by which the rulings turn about each edge, 0 where the face is planar."""
        start, end = self.across
        return turn_about(self.along, start, end)

    @cached_property
    def bends(self) -> FloatArray:
        """(K,) angle about each ruling between the faces that meet there, 0 at both ends."""
        start, end = self.across
        before, after = np.cross(self.along, end)[:-1], np.cross(self.along, start)[1:]
        inner = turn_about(self.rulings[1:-1], before, after)
        return np.concatenate([[0.0], inner, [0.0]])

    @cached_property
    def normals(self) -> FloatArray:
        """(K, 3) unit normals of the strip at its rulings, means of both faces."""
        start, end = self.across
        first, last = np.cross(self.along, start), np.cross(self.along, end)
        both = np.concatenate([first[:1], last[:-1] + first[1:], last[-1:]])
        return unit_rows(both)

    def reach(self, half_width: float) -> FloatArray:
        """(K,) how far along its ruling each edge of a strip of this half width is."""
        return np.asarray(half_width / np.sin(self.slant))

    def admissible_width(self) -> tuple[float, int]:
        """Width at which two neighbouring rulings first meet, and the edge where they do.

        Returns:
            Width, inf when no rulings meet, and the number of the edge.
        """
        opening = 1 / np.tan(self.after[:-1]) - 1 / np.tan(self.before[1:])
        with np.errstate(divide="ignore"):
            meeting = self.lengths / np.abs(opening)
        edge = int(np.argmin(meeting))
        return 2 * float(meeting[edge]), edge

    def refolded(self) -> FloatArray:
        """(K, 2, 3) axis points and rulings, folded from the pattern with its bends and twists.

        Only the first edge and its ruling are taken from the strip, so it proves the pattern.
        """
        along, across = self.along[0], self.across[0][0]
        place = self.points[0]
        result = np.empty((len(self.points), 2, 3))
        result[0] = place, np.cos(self.after[0]) * along + np.sin(self.after[0]) * across
        flat = np.diff(self.flat_points, axis=0)
        for edge, step in enumerate(flat):
            place = place + np.hypot(*step) * along
            across = _turned(along, across, self.twists[edge])
            before = self.before[edge + 1]
            ruling = np.cos(before) * along + np.sin(before) * across
            result[edge + 1] = place, ruling
            if edge + 1 < len(flat):
                following = flat[edge + 1]
                turn = np.arctan2(step[0] * following[1] - step[1] * following[0], step @ following)
                along, across = _in_plane(along, across, turn)
                along = _turned(ruling, along, self.bends[edge + 1])
                across = _turned(ruling, across, self.bends[edge + 1])
        return result


def refuse_empty_edges(points: FloatArray) -> None:
    """Refuse a polyline (K, 3) that repeats a point.

    Raises:
        InputError: naming the first such edge.
    """
    lengths = np.linalg.norm(np.diff(points, axis=0), axis=1)
    if not np.isfinite(points).all() or lengths.min() <= 1e-9 * lengths.max():
        raise InputError(f"strip: edge {int(lengths.argmin())} has no length; remove a point")


def angle_between(one: FloatArray, two: FloatArray) -> FloatArray:
    """Angle between unit vectors, exact for tiny and flat angles alike."""
    apart, together = np.linalg.norm(one - two, axis=-1), np.linalg.norm(one + two, axis=-1)
    return np.asarray(2 * np.arctan2(apart, together))


def turn_about(axis: FloatArray, one: FloatArray, two: FloatArray) -> FloatArray:
    """Signed angle from ``one`` to ``two`` about a unit ``axis`` that both are normal to."""
    sine = np.einsum("...k,...k->...", np.cross(one, two), axis)
    return np.asarray(np.arctan2(sine, np.einsum("...k,...k->...", one, two)))


def _directions(angles: FloatArray) -> FloatArray:
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


def _without(vectors: FloatArray, axis: FloatArray) -> FloatArray:
    return unit_rows(vectors - np.einsum("ij,ij->i", vectors, axis)[:, None] * axis)


def _turned(axis: FloatArray, vector: FloatArray, angle: float) -> FloatArray:
    """Rotate about a unit axis (Rodrigues)."""
    return np.asarray(
        np.cos(angle) * vector
        + np.sin(angle) * np.cross(axis, vector)
        + (1 - np.cos(angle)) * (axis @ vector) * axis
    )


def _in_plane(one: FloatArray, two: FloatArray, angle: float) -> tuple[FloatArray, FloatArray]:
    return np.cos(angle) * one + np.sin(angle) * two, np.cos(angle) * two - np.sin(angle) * one
