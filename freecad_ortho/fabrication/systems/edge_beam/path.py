"""The way of an edge beam: along the border over a net, or along the net's own boundary."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from freecad_ortho.fabrication.site import Site
from freecad_ortho.fabrication.trimming.course import CourseCrossing, Followed
from freecad_ortho.fabrication.trimming.rays import Rays
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, unit_rows

# A border that turns by more at a point has a corner there, degrees.
_CORNER = 20.0
# Corners nearer to each other, mm, are one.
_ONE_CORNER = 20.0
# Pieces that differ by less in direction, degrees, are one.
_STRAIGHT = 0.01


@dataclass(frozen=True, eq=False)
class Path:
    """A closed way in close steps, N points.

    Attributes:
        points: (N, 3) of the net, mm.
        axes: (N, 3) offsets of the parallel mesh there.
        faces: (N, 2) that it touches there, -1 for none.
        corner: (N,) true where it turns sharply, and at the vertices of a net's own boundary.
        crossing: (N,) true where it crosses an edge of the net.
    """

    points: FloatArray
    axes: FloatArray
    faces: IntArray
    corner: BoolArray
    crossing: BoolArray


def paths_of(site: Site) -> list[Path]:
    """Those of the border, or where there is none of the boundary of the net."""
    if site.trimming is None:
        return [_of_boundary(site, loop) for loop in site.mesh.connectivity.boundary_loops]
    rays = Rays.of(site.mesh, site.axes.offsets)
    lines = site.trimming.lines
    edges = [edge for edge, some in site.trimming.crossings.items() for _ in some]
    crossings = [one for some in site.trimming.crossings.values() for one in some]
    places = [_stations(line, crossings) for line in lines]
    nearest = np.argmin([off for _, off in places], axis=0)
    found = []
    for number, (line, (stations, _)) in enumerate(zip(lines, places, strict=True)):
        own = np.flatnonzero(nearest == number)
        found.append(
            _of_border(
                site,
                rays,
                line,
                [(edges[k], crossings[k].place) for k in own.tolist()],
                stations[own],
            )
        )
    return found


def _of_boundary(site: Site, loop: IntArray) -> Path:
    net = site.mesh.connectivity
    face = {
        tuple(net.edges[e].tolist()): net.edge_faces[e].max()
        for e in np.flatnonzero(net.boundary_edges)
    }
    ends = np.sort(np.stack([loop, np.roll(loop, -1)], axis=1), axis=1)
    ahead = np.array([face[first, second] for first, second in ends.tolist()])
    every = np.ones(len(loop), dtype=bool)
    return Path(
        site.mesh.vertices[loop],
        site.axes.offsets[loop],
        np.stack([np.roll(ahead, 1), ahead], axis=1),
        every,
        every,
    )


def _stations(line: Followed, crossings: list[CourseCrossing]) -> tuple[FloatArray, FloatArray]:
    """(C,) where along a line crossings are, in its points, and how far off it."""
    points = np.array([one.point for one in crossings]).reshape(-1, 3)
    steps = np.roll(line.points, -1, axis=0) - line.points
    nearest = cKDTree(line.points).query(points)[1]
    segments = np.stack([nearest - 1, nearest], axis=1) % len(steps)
    arms = points[:, None] - line.points[segments]
    lengths = np.maximum((steps**2).sum(axis=1), np.finfo(float).tiny)
    share = np.einsum("csk,csk->cs", arms, steps[segments]) / lengths[segments]
    share = np.clip(share, 0.0, 1.0)
    off = np.linalg.norm(arms - share[..., None] * steps[segments], axis=2)
    best = off.argmin(axis=1)
    rows = np.arange(len(points))
    return segments[rows, best] + share[rows, best], off[rows, best]


def _of_border(
    site: Site,
    rays: Rays,
    line: Followed,
    places: list[tuple[int, float]],
    stations: FloatArray,
) -> Path:
    """The way of a polyline of the border that crosses edges at places and stations (C,)."""
    net, count = site.mesh.connectivity, len(line.points)
    edges = np.array([edge for edge, _ in places], dtype=np.int64)
    share = np.array([place for _, place in places])[:, None, None]
    ends = np.stack([site.mesh.vertices, site.axes.offsets], axis=1)[net.edges[edges]]
    at_edges = (1 - share) * ends[:, 0] + share * ends[:, 1]
    own = np.stack(
        [rays.points(line.faces, line.feet), rays.offsets(line.faces, line.feet)], axis=1
    )
    along = unit_rows(np.roll(line.points, -1, axis=0) - line.points)
    turn = np.einsum("nk,nk->n", along, np.roll(along, 1, axis=0))
    order = np.argsort(np.concatenate([np.arange(count), stations]), kind="stable")
    both = np.concatenate([own, at_edges])[order]
    faces = np.stack([line.faces, np.full(count, -1)], axis=1)
    return Path(
        both[:, 0],
        both[:, 1],
        np.concatenate([faces, net.edge_faces[edges]])[order],
        np.concatenate([turn < np.cos(np.radians(_CORNER)), np.zeros(len(edges), bool)])[order],
        (np.arange(count + len(edges)) >= count)[order],
    )


def joints_of(path: Path, least: float, off: float) -> IntArray:
    """(J,) the points of a way at which the pieces of a beam meet; below three it has no room.

    They are at its corners, at edges of the net, and elsewhere where it would leave a piece by more
    than ``off``, and at least ``least`` apart, mm; not where pieces are in line.
    """
    fixed = _apart(path, np.flatnonzero(path.corner), [], min(least, _ONE_CORNER))
    wanted = np.flatnonzero(path.crossing)
    if not len(fixed):
        fixed = [int(wanted[0]) if len(wanted) else 0]
    joints = _apart(path, wanted, fixed, least)
    count = len(path.points)
    found = []
    for start, end in zip(joints, [*joints[1:], joints[0] + count], strict=True):
        found += [start, *_between(path, start, end, least, off)]
    return _bends(path, np.unique(np.array(found) % count))


def _apart(path: Path, wanted: IntArray, fixed: list[int], least: float) -> list[int]:
    """Points, in their order, of which those that are wanted keep away from all others."""
    kept = list(fixed)
    for point in wanted.tolist():
        away = np.linalg.norm(path.points[kept] - path.points[point], axis=1)
        if point not in kept and (away >= least).all():
            kept.append(point)
    return sorted(kept)


def _between(path: Path, start: int, end: int, least: float, off: float) -> list[int]:
    """Points between two others at which a way leaves the straight pieces by more than it may."""
    numbers = np.arange(start, end + 1)
    points = path.points[numbers % len(path.points)]
    arms = points - points[0]
    chord = arms[-1] / max(float(np.linalg.norm(arms[-1])), np.finfo(float).tiny)
    away = np.linalg.norm(arms - (arms @ chord)[:, None] * chord, axis=1)
    room = np.minimum(np.linalg.norm(arms, axis=1), np.linalg.norm(points - points[-1], axis=1))
    away = np.where(room >= least, away, 0.0)
    far = int(away.argmax())
    if away[far] <= off:
        return []
    middle = start + far
    before, behind = (
        _between(path, *ends, least, off) for ends in ((start, middle), (middle, end))
    )
    return [*before, middle, *behind]


def _bends(path: Path, joints: IntArray) -> IntArray:
    """The joints without those between pieces that are in line."""
    along = unit_rows(path.points[np.roll(joints, -1)] - path.points[joints])
    turn = np.linalg.norm(np.cross(along, np.roll(along, 1, axis=0)), axis=1)
    return np.asarray(joints[turn > np.sin(np.radians(_STRAIGHT))])
