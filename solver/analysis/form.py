"""How much of what was drawn is left: distances, sizes and smoothness of a result."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.analysis import measures
from solver.mesh.closest import Polyline, TriangleSurface
from solver.mesh.quadmesh import FloatArray, QuadMesh

# Points looked at on each side of a face; fewer where that would be more than so many points.
_SAMPLES, _MOST = 5, 60_000
# Heights below this part of the size are none.
_LEVEL = 1e-9


@dataclass(frozen=True)
class Gap:
    """Distances from the design surface, of vertices and of points inside faces.

    Attributes:
        max: the largest, in model units.
        mean: the mean, likewise.
        percent: the largest in percent of the diagonal of the start's bounding box.
        face: number of the face where it is largest.
    """

    max: float
    mean: float
    percent: float
    face: int


@dataclass(frozen=True)
class Form:
    """A result beside its start and its design surface.

    Attributes:
        off_surface: distances from the design surface, which is the start where none is given.
        border: largest distance of border vertices from the start's border, in model units; zero
            without a border.
        area_ratio: area over the start's.
        height_ratio: vertical extent over the start's; one for a start that lies level.
        zigzag: correlation of consecutive bends along lines: one where they bend evenly, below
            zero where they zigzag.
        zigzag_start: the same of the start.
        gap: largest distance between the diagonals of a face, in model units, and its ``gap_face``.
    """

    off_surface: Gap
    border: float
    area_ratio: float
    height_ratio: float
    zigzag: float
    zigzag_start: float
    gap: float
    gap_face: int


def form_of(start: QuadMesh, mesh: QuadMesh, surface: TriangleSurface | None = None) -> Form:
    """Compare a mesh with its start.

    Args:
        start: the mesh as it was drawn.
        mesh: the same faces with other positions.
        surface: the design surface, by default the start itself.
    """
    used = start.connectivity.referenced
    before, after = start.vertices[used], mesh.vertices[used]
    diagonal = float(np.linalg.norm(np.ptp(before, axis=0)))
    height, now = float(np.ptp(before[:, 2])), float(np.ptp(after[:, 2]))
    distances = off_surface(mesh, surface or surface_of(start))
    worst = int(np.argmax(distances.max(axis=1)))
    far = float(distances[worst].max())
    gaps = measures.diagonal_distances(mesh)
    gap_face = int(np.argmax(gaps))
    return Form(
        off_surface=Gap(far, float(distances.mean()), 100 * far / diagonal, worst),
        border=off_border(start, mesh)[0],
        area_ratio=measures.area(mesh) / measures.area(start),
        height_ratio=now / height if height > _LEVEL * diagonal else 1.0,
        zigzag=measures.smoothness(mesh),
        zigzag_start=measures.smoothness(start),
        gap=float(gaps[gap_face]),
        gap_face=gap_face,
    )


def surface_of(mesh: QuadMesh) -> TriangleSurface:
    """The faces of a mesh, cut into triangles."""
    return TriangleSurface(mesh.vertices, mesh.connectivity.triangles)


def off_surface(mesh: QuadMesh, surface: TriangleSurface) -> FloatArray:
    """(F, s) distances of points of each face from a surface, in model units.

    Faces are sampled bilinearly, their corners included: a net may have all vertices on a surface
    and leave it in between. Where not all faces are quads corners and middles are looked at.
    """
    if mesh.connectivity.mixed:
        return _off_polygons(mesh, surface)
    side = int(np.clip(np.sqrt(_MOST / len(mesh.faces)), 2, _SAMPLES))
    if side == 2:
        # Corners alone, each once: whoever breaks off a large run waits for this.
        feet, _ = surface.closest(mesh.vertices)
        return np.asarray(np.linalg.norm(mesh.vertices - feet, axis=1)[mesh.faces])
    u, v = (part.ravel() for part in np.meshgrid(*[np.linspace(0.0, 1.0, side)] * 2))
    shares = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=1)
    points = np.einsum("sk,fkc->fsc", shares, mesh.vertices[mesh.faces])
    feet, _ = surface.closest(points.reshape(-1, 3))
    return np.asarray(np.linalg.norm(points - feet.reshape(points.shape), axis=2))


def _off_polygons(mesh: QuadMesh, surface: TriangleSurface) -> FloatArray:
    """(F, 1 + most corners) the same of faces of several sizes; what is left over repeats these."""
    net = mesh.connectivity
    at_vertices, in_middle = (
        np.linalg.norm(points - surface.closest(points)[0], axis=1)
        for points in (mesh.vertices, mesh.face_middles)
    )
    rows = np.arange(int(net.face_sizes.max()))
    corners = [np.resize(face, len(rows)) for face in net.polygons]
    return np.column_stack([in_middle, at_vertices[np.array(corners)]])


def off_border(start: QuadMesh, mesh: QuadMesh) -> tuple[float, int]:
    """How far border vertices are from the border that they belonged to, and which is farthest.

    Args:
        start: the mesh as it was drawn.
        mesh: the same faces with other positions.

    Returns:
        The largest distance in model units, and the number of the vertex; zero and the first
        without a border.
    """
    far, vertex = 0.0, 0
    for loop in start.connectivity.boundary_loops:
        points = mesh.vertices[loop]
        feet, _ = Polyline(start.vertices[loop], closed=True).closest(points)
        away = np.linalg.norm(points - feet, axis=1)
        worst = int(np.argmax(away))
        if away[worst] > far:
            far, vertex = float(away[worst]), int(loop[worst])
    return far, vertex
