"""The course of a border over the faces of a net: its way through each, and where it crosses edges.

From face to face it goes through one point of the common side, the same seen from both.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from scipy.spatial import cKDTree

from freecad_ortho.fabrication.trimming.rays import Rays, along_side, inside_of, on_side
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, Connectivity, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# Pieces of the border are at most this long, in mean edges.
_FINE = 0.1
# Points nearer to a side, as a part of the face, lie on it.
ON_SIDE = 1e-6
# Faces that one piece of the border may cross, and that are looked through for a point.
_MOST = 16
# A border farther from the net, in mean edges, is that of something else.
_FAR = 3.0


@dataclass(frozen=True, eq=False)
class CourseCrossing:
    """Where the border crosses an edge.

    Attributes:
        place: along the edge, 0 at its first vertex, 1 at the other.
        point: (3,) of the border, mm.
        along: (3,) unit direction of the border there.
    """

    place: float
    point: FloatArray
    along: FloatArray


@dataclass(frozen=True, eq=False)
class Beyond:
    """A piece of the border that the net does not reach.

    Attributes:
        face: at the net's own boundary, near it.
        side: of that face.
        place: along the side, 0 to 1.
        length: of the piece, mm.
    """

    face: int
    side: int
    place: float
    length: float


@dataclass(frozen=True, eq=False)
class Followed:
    """A closed polyline of a border, and where over the net it runs.

    Attributes:
        points: (N, 3) of it, close together, mm.
        faces: (N,) over which they lie, or that they are beside.
        feet: (N, 2) where in these.
    """

    points: FloatArray
    faces: IntArray
    feet: FloatArray


@dataclass(eq=False)
class Course:
    """Where a border runs.

    Attributes:
        lines: its polylines, in the order in which they were given.
        chords: by face, polylines (M, 2) in its (u, v); they begin and end on its sides, or close.
        crossings: by edge.
        beyond: what the net does not reach.
    """

    lines: list[Followed] = field(default_factory=list)
    chords: dict[int, list[FloatArray]] = field(default_factory=dict)
    crossings: dict[int, list[CourseCrossing]] = field(default_factory=dict)
    beyond: list[Beyond] = field(default_factory=list)

    def add_chord(self, face: int, points: Sequence[FloatArray]) -> None:
        """Add a way through a face, without points that it has twice."""
        line = np.array(points)
        kept = np.r_[True, np.abs(np.diff(line, axis=0)).max(axis=1) > 0]
        if kept.sum() > 1:
            self.chords.setdefault(face, []).append(line[kept])


def course_of(mesh: QuadMesh, rays: Rays, border: Sequence[FloatArray]) -> Course:
    """Follow closed polylines (N, 3) over a net.

    Raises:
        InputError: a border that is far from the net.
    """
    course = Course()
    walk = _Walk(mesh, rays, course)
    for line in border:
        walk.around(_refined(line, _FINE * mesh.mean_edge))
    return course


def _refined(line: FloatArray, longest: float) -> FloatArray:
    """A closed polyline with points between where its sides are longer."""
    steps = np.roll(line, -1, axis=0) - line
    counts = np.maximum(np.ceil(np.linalg.norm(steps, axis=1) / longest), 1).astype(int)
    share = np.concatenate([np.arange(count) / count for count in counts])
    return np.asarray(np.repeat(line, counts, axis=0) + share[:, None] * steps.repeat(counts, 0))


_Way = tuple[int, list[FloatArray]]


class _Trail:
    """The way of a closed polyline as it grows, a chord for each face."""

    def __init__(self, course: Course) -> None:
        self._course = course
        self._face, self._chord = -1, list[FloatArray]()
        # The first chord, which the last one may lead into.
        self._first: _Way | None = None

    @property
    def head(self) -> tuple[int, FloatArray]:
        """Where it has come to."""
        return self._face, self._chord[-1]

    def begin(self, face: int, uv: FloatArray) -> None:
        """Begin over a face."""
        self._face, self._chord = face, [uv]

    def follow(self, ways: Sequence[_Way]) -> None:
        """Go on through faces, the first of them the one where it is."""
        for face, way in ways:
            if face != self._face:
                self.leave()
                self.begin(face, way[0])
            self._chord += way[1:]

    def leave(self) -> None:
        """Leave the face."""
        if self._first is None:
            self._first = self._face, self._chord
        else:
            self._course.add_chord(self._face, self._chord)
        self._chord = []

    def end(self) -> None:
        """End where it began."""
        face, chord = self._first or (-1, [])
        if self._chord and face == self._face:
            chord = [*self._chord, *chord[1:]]
        elif self._chord:
            self._course.add_chord(self._face, self._chord)
        if chord:
            self._course.add_chord(face, chord)


class _Walk:
    """Goes round closed polylines."""

    def __init__(self, mesh: QuadMesh, rays: Rays, course: Course) -> None:
        self._mesh, self._rays, self._course = mesh, rays, course
        self._net: Connectivity = mesh.connectivity
        self._twins = mesh.connectivity.twins.reshape(-1, 4)
        self._centres = cKDTree(rays.corners.mean(axis=1))

    def around(self, points: FloatArray) -> None:
        """Follow one closed polyline (N, 3), from a point that is over the net."""
        faces, feet, over = self._located(points)
        self._course.lines.append(Followed(points, faces, feet))
        first = int(over.argmax())
        order = np.r_[first : len(points), 0 : first + 1].tolist()
        trail = _Trail(self._course)
        if over[first]:
            trail.begin(int(faces[first]), feet[first])
        for here, there in pairwise(order):
            start, end = points[here], points[there]
            face, foot = int(faces[there]), feet[there]
            if over[here]:
                ways, reached = self._through(
                    *trail.head, start, end, foot, face if over[there] else None
                )
                trail.follow(ways)
                if reached:
                    continue
                trail.leave()
            if over[there]:
                ways, _ = self._through(face, foot, end, start, feet[here], None)
                back = [(number, way[::-1]) for number, way in reversed(ways)]
                trail.begin(back[0][0], back[0][1][0])
                trail.follow(back)
            elif not over[here]:
                self._miss(int(faces[here]), feet[here], start, end)
        trail.end()

    def _miss(self, face: int, foot: FloatArray, start: FloatArray, end: FloatArray) -> None:
        outer = np.flatnonzero(self._twins[face] < 0)
        side = int(outer[inside_of(foot)[outer].argmin()]) if len(outer) else 0
        place = min(max(along_side(side, foot), 0.0), 1.0)
        length = float(np.linalg.norm(end - start))
        self._course.beyond.append(Beyond(face, side, place, length))

    def _through(
        self,
        face: int,
        uv: FloatArray,
        start: FloatArray,
        end: FloatArray,
        foot: FloatArray,
        target: int | None,
    ) -> tuple[list[_Way], bool]:
        """Ways through faces from a point to another, and whether they reach it.

        Args:
            face: over which the first point lies.
            uv: (2,) where in it.
            start: (3,) the first point.
            end: (3,) the other one.
            foot: (2,) where in the target the other one is.
            target: the face over which it lies, None where it is beyond the net.
        """
        ways = [(face, [uv])]
        for _ in range(_MOST):
            if face == target:
                ways[-1][1].append(foot)
                return ways, True
            aim = self._rays.feet(end[None], np.array([face]))[0, :2]
            side = self._exit(face, uv, aim, target)
            if abs(inside_of(aim)[side]) <= ON_SIDE:
                place, share = along_side(side, aim), 1.0
            else:
                place, share = self._rays.crossing(face, side, start, end)
            place = float(_snapped(np.array(place)))
            ways[-1][1].append(on_side(side, place))
            self._cross(face, side, place, start + share * (end - start), end - start)
            twin = int(self._twins[face, side])
            if twin < 0:
                return ways, False
            face, side = divmod(twin, 4)
            uv = on_side(side, 1.0 - place)
            ways.append((face, [uv]))
        return ways, False

    def _exit(self, face: int, uv: FloatArray, aim: FloatArray, target: int | None) -> int:
        """The side through which the way towards a point leaves a face."""
        twins = self._twins[face]
        left = inside_of(aim)
        if target is not None:
            to_target = (twins >= 0) & (twins // 4 == target) & (np.abs(left) <= ON_SIDE)
            if to_target.any():
                return int(to_target.argmax())
        outward = inside_of(uv) - left
        leaving = outward > 1e-12
        if not leaving.any():
            return int(left.argmin())
        share = np.where(leaving, inside_of(uv) / np.where(leaving, outward, 1.0), np.inf)
        return int(share.argmin())

    def _cross(
        self, face: int, side: int, place: float, point: FloatArray, along: FloatArray
    ) -> None:
        first, second = self._net.faces[face, [side, (side + 1) % 4]]
        here = place if first < second else 1.0 - place
        crossing = CourseCrossing(here, point, unit_rows(along))
        self._course.crossings.setdefault(int(self._net.face_edges[face, side]), []).append(
            crossing
        )

    def _located(self, points: FloatArray) -> tuple[IntArray, FloatArray, BoolArray]:
        """Faces (N,) over which points lie, where in them (N, 2), and whether the net is there."""
        faces = np.asarray(self._centres.query(points)[1], dtype=np.int64)
        for _ in range(_MOST):
            feet = self._rays.feet(points, faces)
            inside = inside_of(feet[:, :2])
            side = np.where(self._twins[faces] >= 0, inside, np.inf).argmin(axis=1)
            rows = np.arange(len(points))
            twin = self._twins[faces, side]
            moves = (inside[rows, side] < -ON_SIDE) & (twin >= 0)
            if not moves.any():
                break
            faces = np.where(moves, twin // 4, faces)
        feet = self._rays.feet(points, faces)
        least = inside_of(feet[:, :2]).min(axis=1)
        # Round a vertex no face may be quite the right one.
        settled = inside_of(feet[:, :2])[np.arange(len(points)), side] >= -ON_SIDE
        over = (least >= -ON_SIDE) | (~settled & (least > -0.05))
        self._refuse_far(points, faces, feet)
        return faces, np.where(over[:, None], _snapped(feet[:, :2]), feet[:, :2]), over

    def _refuse_far(self, points: FloatArray, faces: IntArray, feet: FloatArray) -> None:
        nearest = self._rays.points(faces, np.clip(feet[:, :2], 0.0, 1.0))
        off = np.linalg.norm(points - nearest, axis=1)
        worst = int(off.argmax())
        if off[worst] > _FAR * self._mesh.mean_edge:
            raise InputError(
                f"border: it is {off[worst]:.4g} mm from the net near face {faces[worst]}; is it "
                "of another net, or in another unit? Leave it out to build all of the net"
            )


def _snapped(values: FloatArray) -> FloatArray:
    """Places within a face of which those that all but reach its sides do so."""
    values = np.where(np.abs(values) <= ON_SIDE, 0.0, values)
    values = np.where(np.abs(values - 1.0) <= ON_SIDE, 1.0, values)
    return np.asarray(np.clip(values, 0.0, 1.0))
