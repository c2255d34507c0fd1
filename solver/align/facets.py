"""Faces of a surface that meet at creases, as polygons whose sides they share.

A roof of flat faces has no lines of curvature, and groins of a cross vault run across those of its
barrels: what such surfaces have are their creases and their border.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from solver.align.features import corners_of
from solver.align.symmetry import Mirror
from solver.align.triangle_mesh import TriangleMesh, components
from solver.mesh.connectivity import BoolArray, IntArray, cycles
from solver.mesh.quadmesh import FloatArray, unit_rows

# A face with a larger angle between two of its sides goes straight on there.
STRAIGHT = np.radians(150.0)
# Cosine of the angle by which a crease may turn where it is carried on.
_ON = 0.7
# What a surface turns by at a crease that fades out.
_FAINT = np.radians(2.0)
# As many faces are taken for faces; more are triangles of something that bends.
MOST = 24
# Ends are images of each other that are nearer to it than this part of a chain's length.
_EVENLY = 1e-4
# Rounds in which sides are halved at vertices that lie on them.
_HALVES = 12
# Normals of a plane differ by no more.
_PLANE = np.radians(0.5)


@dataclass(frozen=True, eq=False)
class CreaseLine:
    """A piece of creases or border between two corners of faces.

    Attributes:
        vertices: (N,) of the mesh, corners first and last.
        length: of it.
    """

    vertices: IntArray
    length: float


# A side of a face: numbers of its chains, and whether each is walked from its first vertex.
Side = list[tuple[int, bool]]


@dataclass(frozen=True, eq=False)
class FlatFaces:
    """Faces as polygons.

    Attributes:
        chains: all pieces of creases and border.
        sides: of each face, counter-clockwise, three or more.
        triangles: of each face.
    """

    chains: list[CreaseLine]
    sides: list[list[Side]]
    triangles: list[IntArray]

    @classmethod
    def of(
        cls, mesh: TriangleMesh, sharp: BoolArray, edge: float, most: int = MOST
    ) -> FlatFaces | None:
        """Part a surface at its creases.

        Args:
            mesh: the surface.
            sharp: (E,) which inner edges are creases.
            edge: wanted edge length; the border is looked at over as much.
            most: faces that are not too many.

        Returns:
            two faces or more; None where one has an opening, a crease that ends in it, or fewer
            than three corners.
        """
        first, second = (mesh.edges // 3).T
        label = components(len(mesh.triangles), first[~sharp], second[~sharp])
        count = int(label.max()) + 1
        if not 1 < count <= most or (sharp & (label[first] == label[second])).any():
            return None
        bounds = list(_loops(mesh, label, count))
        if any(len(loops) != 1 for loops in bounds):
            return None
        loops = [np.array(loops[0]) for loops in bounds]
        corner = _corners(mesh, loops, edge)
        if any(corner[loop].sum() < 2 for loop in loops):
            return None
        chains: dict[tuple[int, ...], int] = {}
        made: list[CreaseLine] = []
        sides = []
        for face, loop in enumerate(loops):
            angles = _angles(mesh, np.flatnonzero(label == face))
            sides.append(_sides(mesh, loop, corner, angles, chains, made))
            if len(sides[-1]) < 3:
                return None
        return cls(made, sides, [np.flatnonzero(label == face) for face in range(count)])

    def flat(self, mesh: TriangleMesh) -> bool:
        """Whether each face is a plane."""
        for triangles in self.triangles:
            normals, areas = mesh.normals[triangles], mesh.areas[triangles, None]
            middle = unit_rows((normals * areas).sum(axis=0)[None])[0]
            if (normals @ middle).min() < np.cos(_PLANE):
                return False
        return True

    def crossing(self, mesh: TriangleMesh, mirrors: Sequence[Mirror]) -> list[int]:
        """Chains that are their own mirror images, with their middle in a plane."""
        ends = np.array([mesh.points[chain.vertices[[0, -1]]] for chain in self.chains])
        near = _EVENLY * np.array([chain.length for chain in self.chains])
        found = np.zeros(len(self.chains), dtype=bool)
        for mirror in mirrors:
            apart = np.linalg.norm(mirror.images(ends[:, 0]) - ends[:, 1], axis=1)
            found |= (apart < near) & (np.abs(mirror.heights(ends[:, 0])) > near)
        return np.flatnonzero(found).tolist()


def faces(mesh: TriangleMesh, sharp: BoolArray) -> int:
    """How many faces creases (E,) part a surface into."""
    first, second = (mesh.edges // 3).T
    return int(components(len(mesh.triangles), first[~sharp], second[~sharp]).max()) + 1


def zipped(mesh: TriangleMesh, near: float) -> TriangleMesh:
    """Triangles halved at vertices of others that lie on their sides, so that both meet there.

    Faces that were cut into triangles each on its own have other vertices along a crease.

    Args:
        mesh: the surface.
        near: how far off a side they may be.
    """
    for _ in range(_HALVES):
        halved = _halved(mesh, near)
        if halved is None:
            break
        mesh = TriangleMesh(mesh.points, halved)
    return mesh


def _halved(mesh: TriangleMesh, near: float) -> IntArray | None:
    """Triangles after one vertex was taken in at each side of the border that others lie on."""
    start, end = mesh.half_edges[mesh.rim].T
    first, along = mesh.points[start], mesh.points[end] - mesh.points[start]
    tree = cKDTree(mesh.points[start])
    lengths = np.linalg.norm(along, axis=1)
    taken: dict[int, int] = {}
    for row, others in enumerate(tree.query_ball_point(first + along / 2, lengths / 2 + near)):
        vertices = start[[k for k in others if start[k] not in (start[row], end[row])]]
        arms = mesh.points[vertices] - first[row]
        part = arms @ along[row] / lengths[row] ** 2
        off = np.linalg.norm(arms - part[:, None] * along[row], axis=1)
        on = (off < near) & (part * lengths[row] > near) & ((1 - part) * lengths[row] > near)
        if on.any():
            taken[row] = int(vertices[on][np.argmin(np.abs(part[on] - 0.5))])
    if not taken:
        return None
    triangles, more, done = mesh.triangles.copy(), [], set()
    for row, vertex in taken.items():
        triangle, corner = divmod(int(mesh.rim[row]), 3)
        if triangle not in done:
            done.add(triangle)
            a, b, c = np.roll(mesh.triangles[triangle], -corner).tolist()
            triangles[triangle] = a, vertex, c
            more.append((vertex, b, c))
    return np.concatenate([triangles, np.array(more)])


def turning(mesh: TriangleMesh, angle: float) -> BoolArray:
    """(E,) which inner edges the surface turns at by more than an angle in radians."""
    first, second = (mesh.edges // 3).T
    cosine = (mesh.normals[first] * mesh.normals[second]).sum(axis=1)
    found: BoolArray = cosine < np.cos(angle)
    return found


def carried_on(mesh: TriangleMesh, sharp: BoolArray, reach: float) -> BoolArray:
    """Creases that fade out, carried on to the next one: (E,) as ``sharp``.

    Where the two vaults of a groin are level with each other, as at the crown, they do not turn.

    Args:
        mesh: the surface.
        sharp: (E,) which inner edges are creases.
        reach: how far each end is carried on at most where it does not turn.
    """
    start, end = mesh.ends
    found, faint = sharp.copy(), turning(mesh, _FAINT)
    around: dict[int, list[tuple[int, int]]] = {}
    for edge, (one, two) in enumerate(zip(start.tolist(), end.tolist(), strict=True)):
        around.setdefault(one, []).append((edge, two))
        around.setdefault(two, []).append((edge, one))
    count = np.bincount(np.concatenate([start[sharp], end[sharp]]), minlength=len(mesh.points))
    for vertex in np.flatnonzero((count == 1) & ~mesh.on_rim).tolist():
        if sum(found[edge] for edge, _ in around[vertex]) != 1:
            continue
        found[_way_on(mesh, (found, faint), around, vertex, reach)] = True
    return found


def _way_on(
    mesh: TriangleMesh,
    creases: tuple[BoolArray, BoolArray],
    around: dict[int, list[tuple[int, int]]],
    vertex: int,
    reach: float,
) -> list[int]:
    """Edges straight on from the end of a crease to another, or to the border; none if too far."""
    sharp, faint = creases
    back = next(other for edge, other in around[vertex] if sharp[edge])
    ahead, gone = mesh.points[vertex] - mesh.points[back], 0.0
    way: list[int] = []
    while gone < reach:
        steps = [
            (edge, other, mesh.points[other] - mesh.points[vertex])
            for edge, other in around[vertex]
            if not sharp[edge]
        ]
        cosines = [step @ ahead / np.linalg.norm(step) for _, _, step in steps]
        best = int(np.argmax(cosines))
        if cosines[best] < _ON * np.linalg.norm(ahead):
            return []
        edge, vertex, step = steps[best]
        way.append(edge)
        gone += 0.0 if faint[edge] else float(np.linalg.norm(step))
        if mesh.on_rim[vertex] or any(sharp[edge] for edge, _ in around[vertex]):
            return way
    return []


def _loops(mesh: TriangleMesh, label: IntArray, count: int) -> Iterator[list[list[int]]]:
    """Vertices of the loops round each face, the face on their left."""
    twins = mesh.twins
    other = np.where(twins < 0, -1, label[np.maximum(twins, 0) // 3])
    own = label[np.arange(len(twins)) // 3]
    for face in range(count):
        run = mesh.half_edges[(own == face) & (other != face)]
        after = dict(zip(run[:, 0].tolist(), run[:, 1].tolist(), strict=True))
        if len(after) < len(run):
            # It touches itself in a vertex.
            yield []
            continue
        yield cycles(after)


def _corners(mesh: TriangleMesh, loops: list[IntArray], edge: float) -> BoolArray:
    """(V,) where three faces meet, or two at the border, or the outline of one has a corner."""
    meeting = np.bincount(np.concatenate(loops), minlength=len(mesh.points)) + mesh.on_rim
    corner: BoolArray = meeting > 2
    for loop in loops:
        corner[loop[corners_of(mesh.points[loop], edge)]] = True
    return corner


def _angles(mesh: TriangleMesh, triangles: IntArray) -> FloatArray:
    """(V,) angle that a face takes up round each vertex."""
    places = mesh.points[mesh.triangles[triangles]]
    found = np.zeros(len(mesh.points))
    for k in range(3):
        one, two = (places[:, (k + other) % 3] - places[:, k] for other in (1, 2))
        angle = np.arctan2(np.linalg.norm(np.cross(one, two), axis=1), (one * two).sum(axis=1))
        np.add.at(found, mesh.triangles[triangles, k], angle)
    return found


def _sides(
    mesh: TriangleMesh,
    loop: IntArray,
    corner: BoolArray,
    angles: FloatArray,
    chains: dict[tuple[int, ...], int],
    made: list[CreaseLine],
) -> list[Side]:
    """The sides of a face; chains that no other face has made are added."""
    at = np.flatnonzero(corner[loop])
    turns = np.flatnonzero(angles[loop[at]] < STRAIGHT)
    if not len(turns):
        return []
    found: list[Side] = []
    for number in np.roll(np.arange(len(at)), -int(turns[0])).tolist():
        start, end = int(at[number]), int(at[(number + 1) % len(at)])
        steps = (end - start - 1) % len(loop) + 1
        run = loop[(start + np.arange(steps + 1)) % len(loop)]
        forwards = bool(run[1] <= run[-2]) if run[0] == run[-1] else bool(run[0] < run[-1])
        key = tuple((run if forwards else run[::-1]).tolist())
        if key not in chains:
            chains[key] = len(made)
            vertices = np.array(key)
            steps_along = np.diff(mesh.points[vertices], axis=0)
            made.append(CreaseLine(vertices, float(np.linalg.norm(steps_along, axis=1).sum())))
        if number in turns:
            found.append([])
        found[-1].append((chains[key], forwards))
    return found
