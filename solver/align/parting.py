"""Flat faces parted into ones that quads fit into: from corners that point inwards, and openings.

The corner of a roof window or chimney points into the slope, as does the top of a lower wing that
runs into it. From each a line runs on: along the crease that ends there, or else along the side of
the opening that is nearer to the line of slope.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from solver.align.facets import STRAIGHT
from solver.align.triangle_mesh import TriangleMesh, components, following
from solver.mesh.connectivity import BoolArray, IntArray
from solver.mesh.quadmesh import FloatArray, unit_rows

# As many lines are drawn at most.
_MOST = 60
# In edges: what lies on a line; how near to a corner a line runs to that corner.
_ON, _NEAR = 1e-5, 0.4
# Cosine of the angle by which a line turns for that at most.
_AIM = 0.9
# Slope of a face that is level.
_LEVEL = 1e-6
# A crease is carried on where both parts of the corner keep an angle like this.
_WIDE = np.radians(50.0)

_Lines = set[tuple[int, int]]


def parted(
    mesh: TriangleMesh, sharp: BoolArray, edge: float
) -> tuple[TriangleMesh, BoolArray] | None:
    """Draw lines on flat faces until no corner of any points inwards.

    Args:
        mesh: the surface.
        sharp: (E,) which inner edges are creases between flat faces.
        edge: wanted edge length.

    Returns:
        The surface, with vertices more, and its creases and lines; None where that does not end.
    """
    start, end = mesh.ends
    lines = {_pair(*ends) for ends in zip(start[sharp], end[sharp], strict=True)}
    for _ in range(_MOST):
        corner = _next_corner(mesh, lines)
        if corner is None:
            return mesh, _on_lines(mesh, lines)
        cut = corner.cut(edge)
        if cut is None:
            return None
        mesh, lines = cut
    return None


def _pair(one: int, two: int) -> tuple[int, int]:
    return (int(min(one, two)), int(max(one, two)))


def _on_lines(mesh: TriangleMesh, lines: _Lines) -> BoolArray:
    """(E,) which inner edges are of lines."""
    ends = np.sort(np.stack(mesh.ends, axis=1), axis=1).tolist()
    return np.array([tuple(pair) in lines for pair in ends], dtype=bool)


def _next_corner(mesh: TriangleMesh, lines: _Lines) -> _Corner | None:
    """A corner of a face that points inwards."""
    sharp = _on_lines(mesh, lines)
    bounding = mesh.twins < 0
    bounding[mesh.edges[sharp].ravel()] = True
    first, second = (mesh.edges // 3).T
    label = components(len(mesh.triangles), first[~sharp], second[~sharp])
    halves = np.flatnonzero(bounding)
    angles, after = _sectors(mesh, bounding, halves)
    inwards = np.flatnonzero(angles > 2 * np.pi - STRAIGHT)
    if not len(inwards):
        return None
    row = int(inwards[0])
    face = label[halves[row] // 3]
    own = label[halves // 3] == face
    turns = own & (np.abs(angles - np.pi) > np.pi - STRAIGHT)
    before, vertex = mesh.half_edges[halves[row]].tolist()
    return _Corner(
        mesh,
        lines,
        np.flatnonzero(label == face),
        mesh.half_edges[halves[own]],
        np.unique(mesh.half_edges[halves[turns], 1]),
        (before, vertex, int(mesh.half_edges[after[row], 1])),
        float(angles[row]),
    )


def _sectors(
    mesh: TriangleMesh, bounding: BoolArray, halves: IntArray
) -> tuple[FloatArray, IntArray]:
    """Angles of faces at the ends of half-edges round them, and the half-edges that follow."""
    arms = mesh.points[mesh.half_edges[:, 1]] - mesh.points[mesh.half_edges[:, 0]]
    on = following(np.arange(len(arms)))
    # At the end of each half-edge, within its triangle.
    crossed = np.linalg.norm(np.cross(arms, arms[on]), axis=1)
    corner = np.pi - np.arctan2(crossed, (arms * arms[on]).sum(axis=1))
    angles, after = np.zeros(len(halves)), np.zeros(len(halves), dtype=np.int64)
    for row, half in enumerate(halves.tolist()):
        angles[row] = corner[half]
        while not bounding[on[half]]:
            half = int(mesh.twins[on[half]])
            angles[row] += corner[half]
        after[row] = on[half]
    return angles, after


@dataclass(frozen=True, eq=False)
class _Corner:
    """A corner of a flat face, from which a line is to be drawn over the face.

    Attributes:
        mesh: the surface.
        lines: pairs of vertices of creases and lines.
        triangles: of the face.
        outline: (K, 2) half-edges round it and its openings, and on both sides of lines in it.
        corners: vertices where that turns.
        around: the vertex before the corner, itself, and the one after it.
        angle: of the face there.
    """

    mesh: TriangleMesh
    lines: _Lines
    triangles: IntArray
    outline: IntArray
    corners: IntArray
    around: tuple[int, int, int]
    angle: float

    def cut(self, edge: float) -> tuple[TriangleMesh, _Lines] | None:
        """The surface with the line, and all lines."""
        aim = self._aim(edge)
        if aim is None:
            return None
        place, (one, two) = aim
        points, triangles, lines = self.mesh.points, self.mesh.triangles, set(self.lines)
        own = np.zeros(len(triangles), dtype=bool)
        own[self.triangles] = True
        target = one
        if one != two:
            target = len(points)
            points = np.concatenate([points, place[None]])
            triangles, own = _split(triangles, own, one, two, target)
            if _pair(one, two) in lines:
                lines -= {_pair(one, two)}
                lines |= {_pair(one, target), _pair(two, target)}
        points, triangles, way = _drawn(points, triangles, own, (self.around[1], target), edge)
        mesh = TriangleMesh(points, triangles)
        steps = {_pair(*step) for step in pairwise(way)}
        inner = {_pair(*ends) for ends in zip(*mesh.ends, strict=True)}
        return (mesh, lines | steps) if steps <= inner and not steps <= lines else None

    def _aim(self, edge: float) -> tuple[FloatArray, tuple[int, int]] | None:
        """Where the line ends: the place, and both ends of the side there, or a corner twice."""
        tries = [(way, self._hit(way, edge)) for way in self._ways()]
        hits = [(way, hit) for way, hit in tries if hit is not None]
        if not hits:
            return None
        # Ways that are as steep as each other: the shorter one.
        steep = [round(abs(float(way @ self._slope)), 6) for way, _ in hits]
        points, here = self.mesh.points, self.mesh.points[self.around[1]]
        away = [float(np.linalg.norm(hit[0] - here)) for _, hit in hits]
        best = min(range(len(hits)), key=lambda k: (-steep[k], away[k]))
        way, (place, side) = hits[best]
        near = np.linalg.norm(points[self.corners] - place, axis=1)
        for corner in self.corners[np.argsort(near)][: int((near < _NEAR * edge).sum())].tolist():
            aimed = unit_rows((points[corner] - here)[None])[0]
            seen = self._hit(aimed, edge)
            if aimed @ way > _AIM and seen is not None:
                off = float(np.linalg.norm(seen[0] - points[corner]))
                if off < _ON * edge:
                    return points[corner], (corner, corner)
        return place, side

    @property
    def _normal(self) -> FloatArray:
        mesh, own = self.mesh, self.triangles
        summed = (mesh.normals[own] * mesh.areas[own, None]).sum(axis=0)
        found: FloatArray = unit_rows(summed[None])[0]
        return found

    @property
    def _slope(self) -> FloatArray:
        """The line of slope, nothing on a level face."""
        down: FloatArray = np.array([0.0, 0.0, 1.0]) - self._normal[2] * self._normal
        if np.linalg.norm(down) < _LEVEL:
            return np.zeros(3)
        steepest: FloatArray = unit_rows(down[None])[0]
        return steepest

    def _ways(self) -> list[FloatArray]:
        """Directions in which the line may run: on from a crease, or from both sides."""
        points, normal = self.mesh.points, self._normal
        before, here, after = self.around
        side = points[after] - points[here]
        axes = unit_rows(np.stack([side, np.cross(normal, side)]))
        found = []
        for pair in sorted(self.lines):
            other = sum(pair) - here
            if here in pair and other not in (before, after):
                way = points[here] - points[other]
                way = way - (way @ normal) * normal
                angle = float(np.arctan2(way @ axes[1], way @ axes[0])) % (2 * np.pi)
                if _WIDE < angle < self.angle - _WIDE:
                    found.append(way)
        if len(found) != 1:
            found = [points[here] - points[before], points[here] - points[after]]
        return list(unit_rows(np.array(found)))

    def _hit(self, way: FloatArray, edge: float) -> tuple[FloatArray, tuple[int, int]] | None:
        """Where a ray from the corner leaves the face; the vertex twice where it does in one."""
        points = self.mesh.points
        here = points[self.around[1]]
        across = np.cross(self._normal, way)
        start, end = ((points[self.outline[:, k]] - here) for k in (0, 1))
        left, right = start @ across, end @ across
        near = _ON * edge
        own = (self.outline == self.around[1]).any(axis=1)
        met = ~own & (np.minimum(left, right) < near) & (np.maximum(left, right) > -near)
        met &= np.abs(left - right) > near
        part = np.clip(np.divide(left, left - right, out=np.zeros_like(left), where=met), 0, 1)
        reach = (start + part[:, None] * (end - start)) @ way
        met &= reach > near
        if not met.any():
            return None
        row = int(np.flatnonzero(met)[np.argmin(reach[met])])
        place = here + start[row] + part[row] * (end[row] - start[row])
        for vertex in self.outline[row].tolist():
            if np.linalg.norm(points[vertex] - place) < 2 * near:
                return points[vertex], (vertex, vertex)
        one, two = self.outline[row].tolist()
        return place, (one, two)


def _split(
    triangles: IntArray, own: BoolArray, one: int, two: int, between: int
) -> tuple[IntArray, BoolArray]:
    """Triangles, and which are of the face, after a vertex was taken in between two others."""
    rows = np.flatnonzero((triangles == one).any(axis=1) & (triangles == two).any(axis=1))
    made = triangles.copy()
    made[rows] = np.where(triangles[rows] == one, between, triangles[rows])
    others = np.where(triangles[rows] == two, between, triangles[rows])
    return np.concatenate([made, others]), np.concatenate([own, own[rows]])


def _drawn(
    points: FloatArray, triangles: IntArray, own: BoolArray, ends: tuple[int, int], edge: float
) -> tuple[FloatArray, IntArray, list[int]]:
    """Split edges of a face until a line from one vertex to another runs along edges.

    Args:
        points: (V, 3) of the surface.
        triangles: (T, 3) of it.
        own: (T,) which are of the face.
        ends: of the line.
        edge: wanted edge length.

    Returns:
        points, triangles, and the vertices along the line.
    """
    origin, near = points[ends[0]], _ON * edge
    length = float(np.linalg.norm(points[ends[1]] - origin))
    along = (points[ends[1]] - origin) / length
    while True:
        parts = (points - origin) @ along
        arms = (points - origin) - parts[:, None] * along
        off = np.linalg.norm(arms, axis=1)
        face = triangles[own]
        one, two = np.stack([face, np.roll(face, -1, axis=1)], axis=-1).reshape(-1, 2).T
        share = off[one] / np.maximum(off[one] + off[two], near)
        met = parts[one] + share * (parts[two] - parts[one])
        beyond = ((arms[one] * arms[two]).sum(axis=1) < 0) & (off[one] > near) & (off[two] > near)
        crossing = np.flatnonzero(beyond & (met > near) & (met < length - near))
        if not len(crossing):
            break
        row = int(crossing[0])
        triangles, own = _split(triangles, own, int(one[row]), int(two[row]), len(points))
        points = np.concatenate([points, (origin + met[row] * along)[None]])
    used = np.unique(face)
    on = used[(off[used] < near) & (parts[used] > -near) & (parts[used] < length + near)]
    return points, triangles, on[np.argsort(parts[on])].tolist()
