"""Mirror images, welding, and the orientation of a mesh."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError
from solver.mesh.grid import grid_mesh, grid_of
from solver.mesh.intake import SAME_PLACE as SAME_PLACE
from solver.mesh.intake import quad_mesh
from solver.mesh.merge import merged
from solver.mesh.mixed import MixedConnectivity
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.mesh.seams import MEETING, meeting, seams
from solver.sentence import Sentence


def size_of(vertices: FloatArray) -> float:
    """Diagonal of the bounding box, in the model's unit."""
    return float(np.linalg.norm(vertices.max(axis=0) - vertices.min(axis=0)))


def mirrored(mesh: QuadMesh, normal: ArrayLike, point: ArrayLike = (0, 0, 0)) -> QuadMesh:
    """A mesh and its mirror image in a plane as one mesh, the seam merged.

    The old vertices and faces come first and keep their numbers; those in the plane serve both
    halves and are set into it to the last digit. The image is oriented so that it continues the
    mesh.

    Args:
        mesh: the mesh, on one side of the plane.
        normal: (3,) normal of the plane, any length.
        point: (3,) a point of the plane, in the model's unit.

    Raises:
        InputError: a zero normal, or an inner edge in the plane, so that halves would overlap.
    """
    direction, origin = _plane(normal, point)
    height = (mesh.vertices - origin) @ direction
    seam = np.abs(height) <= SAME_PLACE * size_of(mesh.vertices)
    inner = ~mesh.connectivity.boundary_edges
    if seam[mesh.connectivity.edges[inner]].all(axis=1).any() or _crosses(height, seam):
        raise InputError(
            "mirror: the mesh reaches across the plane, so that the halves would overlap; "
            "trim it at the plane or choose another plane"
        )
    old = np.where(seam[:, None], mesh.vertices - height[:, None] * direction, mesh.vertices)
    image = mesh.vertices - 2 * height[:, None] * direction
    number = np.where(seam, np.arange(len(old)), len(old) - 1 + np.cumsum(~seam))
    faces = np.concatenate([mesh.faces, number[mesh.faces[:, [1, 0, 3, 2]]]])
    return QuadMesh(np.concatenate([old, image[~seam]]), faces)


def _crosses(height: FloatArray, seam: np.ndarray) -> bool:
    apart = height[~seam]
    return bool((apart > 0).any() and (apart < 0).any())


def _plane(normal: ArrayLike, point: ArrayLike) -> tuple[FloatArray, FloatArray]:
    direction, origin = np.asarray(normal, dtype=np.float64), np.asarray(point, dtype=np.float64)
    length = np.linalg.norm(direction)
    if direction.shape != (3,) or origin.shape != (3,) or not length > 0:
        raise InputError("plane: expected a normal and a point of three numbers each, normal not 0")
    return direction / length, origin


def reflection(mesh: QuadMesh, normal: ArrayLike, point: ArrayLike = (0, 0, 0)) -> QuadMesh:
    """The mirror image alone, vertex numbers kept, orientation reversed to stay outward.

    Raises:
        InputError: a zero normal.
    """
    direction, origin = _plane(normal, point)
    height = (mesh.vertices - origin) @ direction
    image = mesh.vertices - 2 * height[:, None] * direction
    return QuadMesh(image, mesh.faces[:, [1, 0, 3, 2]])


def welded(meshes: Sequence[QuadMesh], tolerance: float = MEETING) -> QuadMesh:
    """One mesh of several, vertices at the same place merged, orientation made consistent.

    Vertices keep the order in which the meshes are given; a merged vertex stays at the place and
    number of its first copy. Where other than four faces meet there is an irregular vertex. No
    vertex is merged with one as far away as half the shortest edge at either.

    Args:
        meshes: at least one mesh, which may be joined with itself.
        tolerance: merge distance as a part of the size of the whole.

    Raises:
        InputError: no mesh, or edges with more than two faces.
    """
    if not meshes:
        raise InputError("weld: expected at least one mesh, got none")
    vertices = np.concatenate([one.vertices for one in meshes])
    offsets = np.cumsum([0] + [len(one.vertices) for one in meshes[:-1]])
    faces = np.concatenate([p.faces + o for p, o in zip(meshes, offsets, strict=True)])
    kept, number = merged(meeting(vertices, faces, tolerance), len(vertices))
    return quad_mesh(vertices[kept], number[faces].tolist())[0]


def weld_remarks(meshes: Sequence[QuadMesh], whole: QuadMesh) -> list[str]:
    """What is to be said about a mesh made of several by :func:`welded`, in plain words."""
    count = sum(len(one.vertices) for one in meshes) - len(whole.vertices)
    parts = int(whole.connectivity.components.max()) + 1
    said: list[str] = [
        Sentence("{} vertices merged", count) if count != 1 else Sentence("1 vertex merged")
    ]
    said += [Sentence("{} separate components", parts)] if parts > 1 else []
    return [*said, *seams(whole).remarks()]


def reversed_orientation(mesh: QuadMesh) -> QuadMesh:
    """The same net seen from its other side; vertex and face numbers and families stay."""
    net = mesh.connectivity
    if net.mixed:
        turned = [face[1::-1] + face[:1:-1] for face in net.polygons]
        return QuadMesh(mesh.vertices, MixedConnectivity(turned, net.vertex_count))
    return QuadMesh(mesh.vertices, mesh.faces[:, [1, 0, 3, 2]])


def swapped(mesh: QuadMesh) -> QuadMesh:
    """Exchange the families u and v, orientation kept.

    A mesh of grid type is renumbered: its new vertex (i, j) is the old (M - 1 - j, i). Any other
    mesh keeps its vertex numbers, and each face starts at its next corner.
    """
    try:
        grid = grid_of(mesh)
    except InputError:
        return QuadMesh(mesh.vertices, np.roll(mesh.faces, -1, axis=1))
    turned = grid.points(mesh)[::-1].transpose(1, 0, 2)
    return grid_mesh(turned, closed_u=grid.closed_v, closed_v=grid.closed_u)
