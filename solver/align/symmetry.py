"""Planes in which a surface is its own mirror image, and nets that are theirs.

A symmetric field of directions runs along a plane of symmetry or crosses it at 45 degrees, and goes
over from one to the other at vertices with three or five lines: lines of the net, or diagonals of
its faces, may lie in the plane. The surface is made symmetric to the last digit, such a net is made
on it, and what lies on one side of the planes is mirrored.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from solver.align.crosses import Crosses, Singular
from solver.align.features import Features
from solver.align.triangle_mesh import TriangleMesh, one_surface
from solver.errors import InputError
from solver.mesh.closest import TriangleSurface
from solver.mesh.connectivity import IntArray
from solver.mesh.intake import quad_mesh
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows
from solver.sentence import Sentence, at

# What may be asked for: no planes, those that are found, or those across an axis.
SYMMETRIES = ("none", "auto", "x", "y", "z", "x,y", "x,y,xy")
# Directions across which planes lie, by their words; the last is between the first two.
_ACROSS = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0), "xy": (1.0, -1.0, 0.0)}
# In edges of the net: how far a mirror image may be off a surface that counts as symmetric; the
# same where the plane is given; and how far from a plane a vertex of the net is set onto it.
_OFF, _GIVEN, _ON = 0.01, 0.05, 0.1
# In sides of a triangle: how far from a plane a point is set onto it.
_SNAP = 0.15
# In edges: how far from a plane an edge of a triangle still runs along it.
_ALONG = 1e-3
# Two planes are perpendicular up to this cosine.
_SQUARE = 1e-3
# Rounds in which a plane settles.
_ROUNDS = 5
# In sizes of a net: how far mirror images may be apart by rounding.
_ROUNDING = 1e-9
# Points of a surface whose mirror images are looked at, about.
_SAMPLE = 4000


@dataclass(frozen=True, eq=False)
class Mirror:
    """A plane of symmetry.

    Attributes:
        normal: (3,) unit vector.
        place: (3,) a point of the plane.
    """

    normal: FloatArray
    place: FloatArray

    def heights(self, points: FloatArray) -> FloatArray:
        """(N,) signed distances of points (N, 3) from the plane."""
        found: FloatArray = (points - self.place) @ self.normal
        return found

    def images(self, points: FloatArray) -> FloatArray:
        """(N, 3) mirror images."""
        found: FloatArray = points - 2 * self.heights(points)[:, None] * self.normal
        return found

    def __str__(self) -> str:
        axis = int(np.argmax(np.abs(self.normal)))
        if np.abs(self.normal[axis]) > 1 - 1e-9:
            return f"{'xyz'[axis]} = {self.place[axis]:.4g}"
        normal, place = (", ".join(f"{x:.3g}" for x in row) for row in (self.normal, self.place))
        return f"across ({normal}) through ({place})"


def mirrors_of(
    surface: TriangleMesh, wanted: str, edge: float, remarks: list[str]
) -> tuple[Mirror, ...]:
    """The planes in which a net on a surface is to be symmetric, perpendicular to each other.

    Args:
        surface: triangles.
        wanted: one of :data:`SYMMETRIES`.
        edge: wanted edge length.
        remarks: gets a sentence that says which planes were found, or that none was.

    Raises:
        InputError: a plane in which the surface is not symmetric.
    """
    if wanted == "none":
        return ()
    box = (surface.points.max(axis=0) + surface.points.min(axis=0)) / 2
    if wanted != "auto":
        words = wanted.split(",")
        found = tuple(Mirror(_unit(np.array(_ACROSS[word])), box) for word in words)
        for mirror in found:
            off, place = _off(surface, mirror)
            if off > _GIVEN * edge:
                raise InputError(
                    f"symmetry: mirrored in the plane {mirror} the surface is {off:.3g} off itself "
                    f"near {at(place)}; leave the symmetry out, or mend the surface"
                )
        return found
    found = _found(surface, box, edge)
    planes = " and ".join(str(mirror) for mirror in found)
    remarks.append(
        Sentence("the net is symmetric in {}", planes)
        if found
        else Sentence("the surface has no plane of symmetry; the net is made without")
    )
    return found


def _found(surface: TriangleMesh, box: FloatArray, edge: float) -> tuple[Mirror, ...]:
    """Up to two planes: across an axis, a diagonal of two, or an axis of inertia."""
    centre = np.average(surface.centres, axis=0, weights=surface.areas)
    apart = surface.centres - centre
    inertia = np.linalg.eigh((apart * surface.areas[:, None]).T @ apart)[1].T
    diagonals = [(1.0, 1.0, 0.0), (1.0, -1.0, 0.0)]
    normals = unit_rows(np.array([*np.eye(3).tolist(), *diagonals, *inertia.tolist()]))
    normals *= np.sign(normals[np.arange(len(normals)), np.abs(normals).argmax(axis=1)])[:, None]
    found: list[Mirror] = []
    for row, normal in enumerate(normals):
        mirror = Mirror(normal, box) if row < 3 else _settled(surface, Mirror(normal, centre))
        for other in found:
            leans = float(mirror.normal @ other.normal)
            if abs(leans) < _SQUARE:
                mirror = Mirror(_unit(mirror.normal - leans * other.normal), mirror.place)
        square = all(abs(float(mirror.normal @ other.normal)) < 1e-9 for other in found)
        if square and len(found) < 2 and _off(surface, mirror)[0] < _OFF * edge:
            found.append(mirror)
    return tuple(found)


def _unit(vector: FloatArray) -> FloatArray:
    found: FloatArray = vector / np.linalg.norm(vector)
    return found


def _settled(surface: TriangleMesh, mirror: Mirror) -> Mirror:
    """The plane near another that halves the ways from border points to their mirror images."""
    rims = surface.half_edges[surface.rim]
    rim, points = TriangleSurface(surface.points, rims[:, [0, 1, 1]]), surface.points[rims[:, 0]]
    for _ in range(_ROUNDS):
        images = rim.closest(mirror.images(points))[0]
        ways = points - images
        normal = np.linalg.eigh(ways.T @ ways)[1][:, 2]
        mirror = Mirror(
            normal * np.sign(normal @ mirror.normal), (points + images).mean(axis=0) / 2
        )
    return mirror


def _off(surface: TriangleMesh, mirror: Mirror) -> tuple[float, FloatArray]:
    """How far mirror images of points and of the border are off a surface at most, and where."""
    if (mirror.heights(surface.points) <= 0).all():
        return np.inf, mirror.place
    rims = surface.half_edges[surface.rim]
    rim = TriangleSurface(surface.points, rims[:, [0, 1, 1]])
    some = surface.points[:: max(1, len(surface.points) // _SAMPLE)]
    worst, where = 0.0, mirror.place
    pairs = (
        (some, TriangleSurface(surface.points, surface.triangles)),
        (surface.points[rims[:, 0]], rim),
    )
    for points, ground in pairs:
        images = mirror.images(points)
        off = np.linalg.norm(images - ground.closest(images)[0], axis=1)
        if off.max() > worst:
            worst, where = float(off.max()), points[off.argmax()]
    return worst, where


def symmetric_surface(surface: TriangleMesh, mirrors: Sequence[Mirror]) -> TriangleMesh:
    """What of a surface lies on one side of the planes, and its mirror images."""
    points, triangles = surface.points, surface.triangles
    for mirror in mirrors:
        points, triangles = _half(points, triangles, mirror)
    for mirror in reversed(mirrors):
        points, triangles = _doubled(points, triangles, mirror)
    return one_surface(points, triangles)


def _half(points: FloatArray, triangles: IntArray, mirror: Mirror) -> tuple[FloatArray, IntArray]:
    """The triangles over a plane; those that it cuts are cut."""
    sides = np.linalg.norm(points[triangles] - points[np.roll(triangles, 1, axis=1)], axis=2)
    reach = np.full(len(points), np.inf)
    for k in range(3):
        np.minimum.at(reach, triangles[:, k], sides.min(axis=1))
    heights = mirror.heights(points)
    sign = np.where(np.abs(heights) < _SNAP * reach, 0, np.sign(heights)).astype(int)
    points = np.where((sign == 0)[:, None], points - heights[:, None] * mirror.normal, points)
    signs = sign[triangles]
    whole = (signs >= 0).all(axis=1) & (signs > 0).any(axis=1)
    cut = np.flatnonzero((signs > 0).any(axis=1) & (signs < 0).any(axis=1))
    added: dict[tuple[int, int], int] = {}
    new: list[FloatArray] = []
    kept = triangles[whole].tolist()
    for triangle in triangles[cut].tolist():
        corners = []
        for one, two in zip(triangle, [*triangle[1:], triangle[0]], strict=True):
            if sign[one] >= 0:
                corners.append(one)
            if sign[one] * sign[two] < 0:
                pair = (min(one, two), max(one, two))
                if pair not in added:
                    part = heights[pair[0]] / (heights[pair[0]] - heights[pair[1]])
                    added[pair] = len(points) + len(new)
                    new.append(points[pair[0]] + part * (points[pair[1]] - points[pair[0]]))
                corners.append(added[pair])
        kept += [[corners[0], *corners[k : k + 2]] for k in range(1, len(corners) - 1)]
    both = np.concatenate([points, np.array(new).reshape(-1, 3)])
    used, numbers = np.unique(np.array(kept), return_inverse=True)
    return both[used], numbers.reshape(-1, 3)


def _doubled(
    points: FloatArray, triangles: IntArray, mirror: Mirror
) -> tuple[FloatArray, IntArray]:
    """Triangles on one side of a plane and their mirror images; what is in it serves both."""
    heights = mirror.heights(points)
    seam = np.abs(heights) < 1e-9 * float(np.ptp(points, axis=0).max())
    points = np.where(seam[:, None], points - heights[:, None] * mirror.normal, points)
    number = np.where(seam, np.arange(len(points)), len(points) - 1 + np.cumsum(~seam))
    both = np.concatenate([points, mirror.images(points[~seam])])
    return both, np.concatenate([triangles, number[triangles[:, ::-1]]])


def along_planes(mesh: TriangleMesh, mirrors: Sequence[Mirror], edge: float) -> Features:
    """Edges of a surface, and of what it is carried on by, that lie in planes of symmetry."""
    start, end = mesh.ends
    on = np.zeros(len(start), dtype=bool)
    for mirror in mirrors:
        near = np.abs(mirror.heights(mesh.points)) < _ALONG * edge
        on |= near[start] & near[end]
    edges = np.flatnonzero(on)
    along = unit_rows(mesh.points[end[edges]] - mesh.points[start[edges]])
    return Features(edges, along, np.zeros(len(edges)), np.ones(len(edges), dtype=bool))


def symmetric_net(net: QuadMesh, mirrors: Sequence[Mirror], edge: float) -> QuadMesh:
    """The faces of a net on one side of the planes, and their mirror images.

    Raises:
        InputError: a face lies on both sides of a plane, with no diagonal in it.
    """
    for mirror in mirrors:
        net = _half_net(net, mirror, _ON * edge)
    for mirror in reversed(mirrors):
        net = _doubled_net(net, mirror, _ON * edge)
    return net


def _sides(net: QuadMesh, mirror: Mirror, near: float) -> IntArray:
    """(V,) 1 over a plane, 0 in it, -1 below."""
    heights = mirror.heights(net.vertices)
    return np.where(np.abs(heights) < near, 0, np.sign(heights)).astype(np.int64)


def _half_net(net: QuadMesh, mirror: Mirror, near: float) -> QuadMesh:
    """The faces over a plane, and those with a diagonal in it, which are their own images."""
    side = _sides(net, mirror, near)
    heights, vertices = mirror.heights(net.vertices), net.vertices.copy()
    vertices[side == 0] -= heights[side == 0, None] * mirror.normal
    sides = side[net.faces]
    both = (sides.min(axis=1) < 0) & (sides.max(axis=1) > 0)
    # Two corners in the plane lie opposite to each other, since the others are opposite too.
    wrong = np.flatnonzero(both & ((sides == 0).sum(axis=1) != 2) | both & (sides.sum(axis=1) != 0))
    if len(wrong):
        place = net.vertices[net.faces[wrong[0]]].mean(axis=0)
        raise InputError(
            f"symmetry: near {at(place)} no line runs along the plane {mirror}; give a shorter "
            "edge, or leave the symmetry out"
        )
    over, under = (net.faces[both][sides[both] == sign] for sign in (1, -1))
    vertices[under] = mirror.images(vertices[over])
    used, numbers = np.unique(net.faces[sides.max(axis=1) > 0], return_inverse=True)
    return quad_mesh(vertices[used], numbers.reshape(-1, 4).tolist())[0]


def _doubled_net(net: QuadMesh, mirror: Mirror, near: float) -> QuadMesh:
    """A half and its mirror image as one net."""
    side, faces = _sides(net, mirror, near), net.faces
    sides = side[faces]
    both = (sides.min(axis=1) < 0) & (sides.max(axis=1) > 0)
    number = np.arange(len(side))
    number[faces[both][sides[both] == 1]] = faces[both][sides[both] == -1]
    new = np.flatnonzero((number == np.arange(len(side))) & (side > 0))
    number[new] = len(side) + np.arange(len(new))
    vertices = np.concatenate([net.vertices, mirror.images(net.vertices[new])])
    return QuadMesh(vertices, np.concatenate([faces, number[faces[~both][:, [1, 0, 3, 2]]]]))


def coordinate_planes(net: QuadMesh) -> str:
    """Letters of the coordinate planes in which a net is its own mirror image to rounding."""
    points, near = net.vertices, _ROUNDING * float(np.ptp(net.vertices, axis=0).max())
    tree = cKDTree(points)
    return "".join(
        word
        for axis, word in enumerate("xyz")
        if tree.query(points * np.where(np.arange(3) == axis, -1, 1))[0].max() < near
    )


def symmetric_singular(singular: Singular, mirrors: Sequence[Mirror], edge: float) -> Singular:
    """Those on one side of the planes, and their mirror images."""
    places, valences = singular.places, singular.valences
    for mirror in mirrors:
        heights = mirror.heights(places)
        near = np.abs(heights) < _ON * edge
        places = places - np.where(near, heights, 0.0)[:, None] * mirror.normal
        kept = near | (heights > 0)
        places, valences = places[kept], valences[kept]
    for mirror in reversed(mirrors):
        off = np.abs(mirror.heights(places)) >= _ON * edge
        places = np.concatenate([places, mirror.images(places[off])])
        valences = np.concatenate([valences, valences[off]])
    return Singular(places, valences)


def symmetric_crosses(crosses: Crosses, mirrors: Sequence[Mirror]) -> Crosses:
    """Those on one side of the planes, and their mirror images."""
    places, directions, certainty = crosses.places, crosses.directions, crosses.certainty
    for mirror in mirrors:
        kept = mirror.heights(places) > 0
        places, directions, certainty = places[kept], directions[kept], certainty[kept]
    for mirror in reversed(mirrors):
        turned = directions - 2 * (directions @ mirror.normal)[:, :, None] * mirror.normal
        places = np.concatenate([places, mirror.images(places)])
        directions = np.concatenate([directions, turned])
        certainty = np.concatenate([certainty, certainty])
    return Crosses(places, directions, certainty)


def with_images(lines: Sequence[FloatArray], mirrors: Sequence[Mirror]) -> list[FloatArray]:
    """Polylines (n, 3) and their mirror images."""
    found = list(lines)
    for mirror in mirrors:
        found += [mirror.images(line) for line in found]
    return found
