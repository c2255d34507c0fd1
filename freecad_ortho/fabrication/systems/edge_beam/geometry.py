"""Pieces of an edge beam: straight, of one section, mitred where they meet.

The plane of a mitre contains the joint and bisects the directions of the two pieces, so that each
stays on its side, however their sections are turned to each other. Beams, nodes and panels that
are built later see here what is in their way, and what carries them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.sizes import rounded_down
from freecad_ortho.fabrication.systems.edge_beam.path import Path
from freecad_ortho.fabrication.systems.edge_beam.rulings import StraightPieces, Strips, strips_of
from solver.errors import InputError
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, unit_rows

# Part of a piece's length that its mitres must leave.
_LEAST_LEFT = 1e-3
# Cosine of the angle between two pieces from which on they are two sides of a panel.
_TURNED = np.cos(np.radians(20.0))


@dataclass(frozen=True, eq=False)
class EdgeGeometry:
    """The pieces of all edge beams of a site, one row a piece; mm.

    A piece's coordinates begin at its start, in the middle of its upper side: along it, up, and
    across it to the right.

    Attributes:
        start: (N, 3) where they begin, in the site's mesh.
        length: (N,) from joint to joint.
        frame: (N, 3, 3) rows along, up, to the right.
        mitres: (N, 2, 3) normals of the planes in which they end, in their own coordinates, ahead.
        before: (N,) the piece before each.
        behind: (N,) and after it.
        way: (N,) number of the closed way that it is on.
        half: half of the width.
        height: of the section.
        top: level along the axes of the upper side.
        clearance: that is left to what ends at it.
        drop: (N,) how far the upper side lies below the level, mm, at most.
        carries: (F,) how many sides of each face's panel lie on it.
        bearing: (F,) least width that a panel that ends on the way lies on it, inf for none.
        strips: those that the pieces are bent from, None for other sections.
    """

    start: FloatArray
    length: FloatArray
    frame: FloatArray
    mitres: FloatArray
    before: IntArray
    behind: IntArray
    way: IntArray
    half: float
    height: float
    top: float
    clearance: float
    drop: FloatArray
    carries: IntArray
    bearing: FloatArray
    strips: Strips | None = None

    def section(self, profile: FloatArray) -> FloatArray:
        """(N, 2, K, 3) corners of a profile (K, 2), up and to the right, at the ends of pieces."""
        off = np.einsum("nek,pk->nep", self.mitres[..., 1:], profile) / self.mitres[..., :1]
        stations = np.array([0.0, 1.0])[:, None] * self.length[:, None, None] - off
        shape = (*stations.shape, 2)
        return np.concatenate([stations[..., None], np.broadcast_to(profile, shape)], axis=3)

    def in_site(self, points: FloatArray) -> FloatArray:
        """Points (N, ..., 3) in the pieces' coordinates in those of the site's mesh."""
        turned = np.einsum("n...c,nck->n...k", points, self.frame)
        return np.asarray(turned + self.start.reshape(-1, *[1] * (points.ndim - 2), 3))

    @cached_property
    def uprights(self) -> FloatArray:
        """(N, 4, 2, 3) lower and upper point of lines where others pass the corners of pieces.

        The clearance away from their four upright edges, in the site's mesh.
        """
        away = self.half + self.clearance
        profile = np.array([[y, z] for z in (-away, away) for y in (-self.height, 0.0)])
        corners = self.in_site(self.section(profile))
        return corners.reshape(-1, 4, 2, 3)

    def blocked(
        self, lines: FloatArray, along: FloatArray, beside: float = 0.0
    ) -> list[tuple[int, IntArray, FloatArray, FloatArray]]:
        """Where straight lines are nearer to the pieces than the clearance, whatever their height.

        Args:
            lines: (E, L, 3) points of L parallel lines each, in the site's mesh.
            along: (E, 3) unit directions.
            beside: further distance to keep, mm.

        Returns:
            For each piece its number, the rows of lines (M,) that come near, and how far along each
            line that begins (M, L) and ends (M, L); it ends before it begins where a line keeps
            away.
        """
        middle = lines.mean(axis=1)
        reach = np.linalg.norm(lines - middle[:, None], axis=2).max(axis=1)
        centres = self.in_site(np.stack([self.length / 2, 0 * self.length, 0 * self.length], 1))
        room = self.length / 2 + 2 * (self.half + self.clearance + beside) + self.height
        found = []
        for piece in range(len(self.length)):
            arms = centres[piece] - middle
            ahead = np.einsum("ek,ek->e", arms, along)
            away = np.linalg.norm(arms - ahead[:, None] * along, axis=1)
            rows = np.flatnonzero(away <= room[piece] + reach)
            if len(rows):
                bounds = self._within(piece, lines[rows], along[rows], beside)
                found.append((piece, rows, *bounds))
        return found

    def _within(
        self, piece: int, lines: FloatArray, along: FloatArray, beside: float
    ) -> tuple[FloatArray, FloatArray]:
        """(M, L) twice: where lines enter and leave the space of a piece."""
        frame = self.frame[piece]
        points = (lines - self.start[piece]) @ frame.T
        steps = along @ frame.T
        half = self.half + self.clearance + beside
        first, last = self.mitres[piece]
        end = np.array([self.length[piece], 0.0, 0.0])
        # Each half-space: normal, level below which it is.
        sides = [
            (np.array([0.0, 0.0, 1.0]), half),
            (np.array([0.0, 0.0, -1.0]), half),
            (-first, beside),
            (last, last @ end + beside),
        ]
        low = np.full(points.shape[:2], -np.inf)
        high = np.full(points.shape[:2], np.inf)
        for normal, level in sides:
            room = level - points @ normal
            speed = np.broadcast_to((steps @ normal)[:, None], room.shape)
            with np.errstate(divide="ignore", invalid="ignore"):
                place = room / speed
            high = np.where(speed > 0, np.minimum(high, place), high)
            low = np.where(speed < 0, np.maximum(low, place), low)
            low = np.where((speed == 0) & (room < 0), np.inf, low)
        return low, high

    def near(self, points: FloatArray, axes: FloatArray, radius: float) -> BoolArray:
        """(V,) true where upright things of a radius about axes would stand in its way.

        Args:
            points: (V, 3) on the axes, in the site's mesh.
            axes: (V, 3) their directions.
            radius: mm.
        """
        ends = np.array([self.top, self.top - self.height])[:, None]
        result = np.zeros(len(points), dtype=bool)
        half = self.half + self.clearance + radius
        for piece in range(len(self.length)):
            arms = points - self.start[piece]
            rows = np.flatnonzero(
                np.linalg.norm(arms, axis=1) <= self.length[piece] + half + self.height
            )
            both = points[rows, None] + ends * axes[rows, None]
            local = (both - self.start[piece]) @ self.frame[piece].T
            first, last = self.mitres[piece]
            stays = np.abs(local[..., 2]) <= half
            stays &= local @ first >= -half
            stays &= local @ last <= last[0] * self.length[piece] + half
            result[rows] |= stays.any(axis=1)
        return result


def edge_geometry(
    site: Site,
    ways: list[tuple[Path, IntArray]],
    width: float,
    height: float,
    top: float,
    clearance: float,
    stock: float | None = None,
) -> EdgeGeometry:
    """Lay pieces along ways, from joint to joint, as low as no face of the net is cut by them.

    Args:
        site: the net.
        ways: with the points at which pieces meet.
        width: of the section, mm.
        height: of the section, mm.
        top: level of its upper side along the axes, mm.
        clearance: that others keep, mm.
        stock: greatest length of strips that the pieces are bent from, mm; None for no strips.

    Raises:
        InputError: a width that does not fit a piece between its mitres, or too short a stock.
    """
    raised = site.mesh.with_vertices(site.mesh.vertices + top * site.axes.offsets)
    levels = _Levels(raised.vertices[raised.faces].mean(axis=1), raised.face_normals)
    pieces, drop = _pieces(ways, width / 2, top, levels)
    strips = None
    if stock is not None:
        # Strips lean: what of them stands highest is known once they are.
        leaning = _frames(pieces, strips_of(pieces, height, stock))[:, 2]
        pieces, drop = _pieces(ways, width / 2, top, levels, leaning)
        strips = strips_of(pieces, height, stock)
    frame = _frames(pieces, strips)
    bisectors = _bisectors(pieces, strips)
    mitres = np.einsum("nek,nck->nec", unit_rows(bisectors), frame)
    faces = len(site.mesh.faces)
    made = EdgeGeometry(
        pieces.start,
        pieces.length,
        frame,
        mitres,
        pieces.before,
        pieces.behind,
        pieces.way,
        width / 2,
        height,
        top,
        clearance,
        drop,
        np.zeros(faces, dtype=np.int64),
        np.full(faces, np.inf),
        strips,
    )
    _refuse_mitres(made, width, site.shift)
    _note_bearing(made, ways)
    return made


def _pieces(
    ways: list[tuple[Path, IntArray]],
    half: float,
    top: float,
    levels: _Levels,
    rights: FloatArray | None = None,
) -> tuple[StraightPieces, FloatArray]:
    """The pieces of all ways, and how far they were lowered (N,); upright without (N, 3) rights."""
    ahead = np.cumsum([0, *(len(joints) for _, joints in ways)])
    given = [None if rights is None else rights[k:m] for k, m in pairwise(ahead.tolist())]
    rows = [
        _laid(path, joints, half, top, levels, own)
        for (path, joints), own in zip(ways, given, strict=True)
    ]
    behind, before = np.empty((2, int(ahead[-1])), dtype=np.int64)
    for first, last in pairwise(ahead.tolist()):
        numbers = np.arange(first, last)
        behind[numbers], before[numbers] = np.roll(numbers, -1), np.roll(numbers, 1)
    start, end, axes, drop = (np.concatenate(some) for some in zip(*rows, strict=True))
    length = np.linalg.norm(end - start, axis=1)
    way = np.repeat(np.arange(len(ways)), np.diff(ahead))
    along = (end - start) / length[:, None]
    return StraightPieces(start, length, along, axes, before, behind, way), drop


def _frames(pieces: StraightPieces, strips: Strips | None) -> FloatArray:
    """(N, 3, 3) along, up and to the right of pieces: upright in their middle, or as strips lie."""
    both = pieces.axes + pieces.axes[pieces.behind]
    up = both if strips is None else strips.rulings.sum(axis=1)
    along = pieces.along
    up = unit_rows(up - np.einsum("nk,nk->n", up, along)[:, None] * along)
    return np.stack([along, up, np.cross(along, up)], axis=1)


def _bisectors(pieces: StraightPieces, strips: Strips | None) -> FloatArray:
    """(N, 2, 3) directions square to the planes in which pieces end; bends lie in these planes."""
    plain = pieces.bisectors()
    found = np.stack([plain, plain[pieces.behind]], axis=1)
    for run in strips.runs if strips else ():
        one, two = run[:-1], run[1:]
        lines = strips.rulings[two, 0] if strips else plain
        square = [
            unit_rows(along - np.einsum("nk,nk->n", along, lines)[:, None] * lines)
            for along in (pieces.along[one], pieces.along[two])
        ]
        found[one, 1] = found[two, 0] = square[0] + square[1]
    return found


@dataclass(frozen=True, eq=False)
class _Levels:
    """Planes of the faces at the upper side: points (F, 3) and normals (F, 3)."""

    middles: FloatArray
    normals: FloatArray

    def above(self, points: FloatArray, faces: IntArray) -> FloatArray:
        """How far points (..., 3) stand above faces (...); below all for no face."""
        arms = points - self.middles[faces]
        return np.where(faces >= 0, np.einsum("...k,...k->...", arms, self.normals[faces]), -np.inf)


def _samples(path: Path, joints: IntArray) -> list[IntArray]:
    """The points of each piece, from its one joint to the other."""
    count = len(path.points)
    ends = np.roll(joints, -1) + np.where(np.arange(len(joints)) == len(joints) - 1, count, 0)
    return [
        np.arange(start, end + 1) % count
        for start, end in zip(joints.tolist(), ends.tolist(), strict=True)
    ]


def _laid(
    path: Path,
    joints: IntArray,
    half: float,
    top: float,
    levels: _Levels,
    rights: FloatArray | None,
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Start, end and axis at the start (N, 3) of pieces, and how far they were lowered (N,)."""
    points = path.points + top * path.axes
    normals = unit_rows(path.axes)
    stands = np.empty(len(joints))
    for piece, some in enumerate(_samples(path, joints)):
        start, end = points[some[0]], points[some[-1]]
        along = unit_rows((end - start)[None])[0]
        right = np.cross(along, normals[some[0]] + normals[some[-1]])
        right = unit_rows(right[None])[0] if rights is None else rights[piece]
        on_axis = start + ((points[some] - start) @ along)[:, None] * along
        corners = on_axis[:, None] + np.array([-half, half])[:, None] * right
        faces = np.broadcast_to(path.faces[some][:, None], (len(some), 2, 2))
        stands[piece] = levels.above(corners[:, :, None], faces).max()
    lowered = np.maximum(np.maximum(stands, np.roll(stands, 1)), 0.0)
    lower = points[joints] - lowered[:, None] * normals[joints]
    after = np.roll(np.arange(len(joints)), -1)
    return lower, lower[after], normals[joints], np.maximum(lowered, lowered[after])


def _refuse_mitres(made: EdgeGeometry, width: float, shift: FloatArray) -> None:
    sides = np.array([[y, z] for y in (0.0, -made.height) for z in (-made.half, made.half)])
    stations = made.section(sides)[..., 0]
    left = (stations[:, 1] - stations[:, 0]).min(axis=1) / made.length
    if left.min() <= _LEAST_LEFT:
        piece = int(left.argmin())
        x, y, z = (made.start[piece] + shift).tolist()
        largest = rounded_down(width / (1 - float(left[piece])))
        raise InputError(
            f"edge beam: {width:g} mm wide it does not fit where it turns near ({x:.0f}, {y:.0f}, "
            f"{z:.0f}) mm, {made.length[piece]:.0f} mm from bend to bend; take at most {largest} mm"
        )


def _note_bearing(made: EdgeGeometry, ways: list[tuple[Path, IntArray]]) -> None:
    """Note which faces lie on the pieces, and by how much."""
    first = 0
    known: dict[int, list[FloatArray]] = {}
    for path, joints in ways:
        for piece, some in enumerate(_samples(path, joints), start=first):
            points = path.points[some] + made.top * path.axes[some]
            local = (points - made.start[piece]) @ made.frame[piece].T
            faces = path.faces[some]
            inner = np.setdiff1d(np.unique(faces), [-1])
            for face in inner.tolist():
                own = (faces == face).any(axis=1)
                if own.sum() < 2:
                    continue
                others = known.setdefault(face, [])
                along = made.frame[piece, 0]
                if all(along @ other < _TURNED for other in others):
                    others.append(along)
                made.carries[face] = len(others)
                width = made.half - float(np.abs(local[own, 2]).max())
                made.bearing[face] = min(made.bearing[face], width)
        first += len(joints)
