"""Border vertices set onto a given border, corners onto its corners, the rest evened out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csr_array

from solver.errors import InputError
from solver.mesh.closest import TriangleSurface
from solver.mesh.coarsen import compact
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Rounds that make room; each goes half of the way, so that a few rings have evened out by then.
_SMOOTHINGS = 15
# Rings of faces at the border whose vertices move to make room for it.
_RINGS = 3
# Faces thinner than this part of a square are no use.
_THIN = 0.05


@dataclass(frozen=True, eq=False)
class Border:
    """The border of a surface.

    Attributes:
        curve: its segments, as triangles without area.
        corners: (K, 3) where it turns sharply.
    """

    curve: TriangleSurface
    corners: FloatArray

    @classmethod
    def of_polylines(cls, lines: Sequence[FloatArray], corner: float = 40.0) -> Border:
        """Border of closed polylines (n, 3), which do not repeat their start.

        Args:
            lines: at least one.
            corner: turns by more than this, in degrees, are corners.
        """
        offsets = np.cumsum([0] + [len(line) for line in lines])
        numbers = [o + np.arange(len(line)) for o, line in zip(offsets, lines, strict=False)]
        segments = np.concatenate([np.stack([k, np.roll(k, -1)], axis=1) for k in numbers])
        points = np.concatenate(list(lines))
        sharp = np.concatenate([_turns(line) > np.radians(corner) for line in lines])
        return cls(TriangleSurface(points, segments[:, [0, 1, 1]]), points[sharp])


def _turns(line: FloatArray) -> FloatArray:
    """(n,) turning angles of a closed polyline."""
    before, after = line - np.roll(line, 1, axis=0), np.roll(line, -1, axis=0) - line
    cross = np.linalg.norm(np.cross(before, after), axis=1)
    return np.asarray(np.arctan2(cross, (before * after).sum(axis=1)))


def closed_loops(pieces: Sequence[FloatArray], near: float) -> tuple[FloatArray, ...]:
    """Closed polylines put together from pieces (n, 3) whose ends meet, in any order and direction.

    Args:
        pieces: polylines; closed ones repeat their start.
        near: how far apart ends may be that are the same, in the model's unit.

    Returns:
        Polylines of three points or more, which do not repeat their start.
    """
    left, loops = [piece for piece in pieces if len(piece) > 1], []
    while left:
        loop = [left.pop(0)]
        while np.linalg.norm(loop[-1][-1] - loop[0][0]) > near:
            following = _following(left, loop[-1][-1], near)
            if following is None:
                break
            loop.append(following)
        loops.append(np.concatenate([piece[:-1] for piece in loop]))
    return tuple(loop for loop in loops if len(loop) > 2)


def _following(pieces: list[FloatArray], end: FloatArray, near: float) -> FloatArray | None:
    """Take the piece that goes on from an end, turned round where it has to be."""
    for k, piece in enumerate(pieces):
        for path in (piece, piece[::-1]):
            if np.linalg.norm(path[0] - end) < near:
                del pieces[k]
                return path
    return None


def set_back(
    mesh: QuadMesh,
    surface: TriangleSurface,
    border: Border | None,
    free: BoolArray | None = None,
    held: BoolArray | None = None,
) -> QuadMesh:
    """Even out a mesh within a surface; border vertices stay on the border, corners on corners.

    Args:
        mesh: a mesh near the surface.
        surface: where inner vertices go.
        border: where border vertices go; None for a closed surface.
        free: (V,) inner vertices that may move; by default all.
        held: (V,) border vertices that stay where they are; by default none.
    """
    net = mesh.connectivity
    rim = net.boundary_vertices
    positions = mesh.vertices.copy()
    fixed = np.zeros(len(positions), dtype=bool) if held is None else held.copy()
    if border is not None and (rim & ~fixed).any():
        numbers = np.flatnonzero(rim)
        for place in border.corners:
            apart = np.linalg.norm(positions[numbers] - place, axis=1) + 1e9 * fixed[numbers]
            nearest = numbers[int(np.argmin(apart))]
            positions[nearest], fixed[nearest] = place, True
    inner_mean = _means(net.edges, len(positions))
    rim_mean = _means(net.edges[net.boundary_edges], len(positions))
    moving_rim, inside = rim & ~fixed, ~rim & ~fixed if free is None else ~rim & ~fixed & free
    for _ in range(_SMOOTHINGS):
        smooth = positions + 0.5 * (inner_mean @ positions - positions)
        slid = positions + 0.5 * (rim_mean @ positions - positions)
        if inside.any():
            positions[inside] = surface.closest(smooth[inside])[0]
        if moving_rim.any() and border is not None:
            positions[moving_rim] = border.curve.closest(slid[moving_rim])[0]
    return mesh.with_vertices(positions)


def fitted(
    mesh: QuadMesh, surface: TriangleSurface, border: Border, held: BoolArray
) -> tuple[QuadMesh, int]:
    """A mesh with a stepped border set onto a smooth one; faces that have no room there go.

    Only vertices near the border move; those that are held, (V,), do not.

    Returns:
        The mesh, and the number of faces that were left out.

    Raises:
        InputError: no face is left.
    """
    dropped = 0
    while True:
        near = mesh.connectivity.boundary_vertices.copy()
        for _ in range(_RINGS):
            near[mesh.faces[near[mesh.faces].any(axis=1)].ravel()] = True
        done = set_back(mesh, surface, border, near, held)
        bad = _useless(done, surface)
        if not bad.any():
            return done, dropped
        if bad.all():
            raise InputError("border: no quad has room inside; take a finer sampling")
        dropped += int(bad.sum())
        held = held[np.unique(mesh.faces[~bad])]
        mesh = compact(mesh, mesh.faces[~bad])


def straight_corners(mesh: QuadMesh) -> int:
    """How many faces have a corner of 180 degrees or more, up to half a degree."""
    points = mesh.vertices[mesh.faces]
    ahead = np.roll(points, -1, axis=1) - points
    cross = np.cross(np.roll(ahead, 1, axis=1), ahead)
    turn = np.einsum("fij,fj->fi", cross, mesh.face_normals)
    lengths = np.linalg.norm(ahead, axis=2)
    sine = turn / (lengths * np.roll(lengths, 1, axis=1))
    return int((sine < np.sin(np.radians(0.5))).any(axis=1).sum())


def _useless(mesh: QuadMesh, surface: TriangleSurface) -> BoolArray:
    """(F,) faces that are folded, turned over or as thin as a line."""
    corners = mesh.vertices[mesh.faces]
    normals = surface.closest(corners.mean(axis=1))[1]
    before = corners - np.roll(corners, 1, axis=1)
    after = np.roll(corners, -1, axis=1) - corners
    turn = np.einsum("fki,fi->fk", np.cross(before, after), normals)
    lengths = np.linalg.norm(after, axis=2)
    area = 0.5 * np.linalg.norm(
        np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]), axis=1
    )
    scale = lengths.max(axis=1) ** 2
    side = np.sign(np.median(turn.sum(axis=1)))
    folded = (side * turn < -1e-2 * scale[:, None]).any(axis=1)
    return np.asarray(folded | (area < _THIN * scale) | (lengths.min(axis=1) ** 2 < 1e-4 * scale))


def _means(edges: IntArray, count: int) -> csr_array:
    """Matrix that takes the mean over the neighbours along some edges."""
    both = np.concatenate([edges, edges[:, ::-1]])
    share = 1.0 / np.maximum(np.bincount(both[:, 0], minlength=count), 1)
    return csr_array(coo_array((share[both[:, 0]], both.T), shape=(count, count)))
