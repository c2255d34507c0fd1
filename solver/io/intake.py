"""From raw polygons to a usable quad mesh: what can be mended is mended and said."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial import cKDTree

from solver.errors import InputError
from solver.io.orientation import oriented
from solver.mesh.connectivity import Connectivity, IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh

# A face whose area vector is below this part of its squared diagonals has no direction.
_ZERO_AREA = 1e-12
# Coordinates beyond this lose their squares' meaning in floating point.
_LARGEST = 1e100
# Vertices closer than this part of the mesh's size are one vertex.
SAME_PLACE = 1e-9


def quad_mesh(
    vertices: FloatArray, polygons: Sequence[Sequence[int]], lines: Sequence[int] = ()
) -> tuple[QuadMesh, list[str]]:
    """Check polygons and build a consistently oriented quad mesh from them.

    Vertex and face order are kept. Faces that disagree with their neighbours' orientation are
    reversed, the larger part of each component keeping its own.

    Args:
        vertices: (V, 3) coordinates.
        polygons: vertex numbers of each face, counted from 0.
        lines: of the file, one a face, for what is said of a face; empty where not known.

    Returns:
        The mesh, and remarks in plain words on what was mended or is unusual.

    Raises:
        InputError: faces that are not quads, bad numbers, non-manifold or non-orientable edges.
    """
    faces = _quads(polygons, len(vertices), lines)
    _refuse_wild_numbers(vertices)
    Connectivity.check_corners(faces, len(vertices))
    _refuse_double_faces(faces)
    remarks: list[str] = []
    faces = oriented(vertices, faces, remarks)
    mesh = QuadMesh(vertices, Connectivity(faces, len(vertices)))
    refuse_empty_faces(mesh)
    unused = np.flatnonzero(~mesh.connectivity.referenced)
    if len(unused):
        remarks.append(
            f"{len(unused)} vertices belong to no face (first: {unused[0]}); kept where they are"
            if len(unused) > 1
            else f"vertex {unused[0]} belongs to no face; kept where it is"
        )
    parts = int(mesh.connectivity.components.max()) + 1
    if parts > 1:
        remark = f"{parts} separate components; each is treated on its own"
        together = _together(mesh)
        if together:
            remark += f"; {together} vertices lie where another does: merge them with 'weld'"
        remarks.append(remark)
    return mesh, remarks


def _together(mesh: QuadMesh) -> int:
    """How many vertices have another at the same place."""
    points = mesh.vertices[mesh.connectivity.referenced]
    size = np.linalg.norm(points.max(axis=0) - points.min(axis=0))
    apart = cKDTree(points).query(points, k=2)[0][:, 1]
    return int((apart <= SAME_PLACE * size).sum())


def _quads(polygons: Sequence[Sequence[int]], vertex_count: int, lines: Sequence[int]) -> IntArray:
    if not len(polygons):
        raise InputError("faces: expected at least one, got none; export the mesh's faces")
    sizes = np.array([len(polygon) for polygon in polygons])
    wrong = np.flatnonzero(sizes != 4)
    if len(wrong):
        triangles = int((sizes == 3).sum())
        larger = int((sizes > 4).sum())
        first = int(wrong[0])
        counts = [f"{triangles} triangle{'s' * (triangles > 1)}"] * (triangles > 0)
        counts += [f"{larger} face{'s' * (larger > 1)} with more than 4 corners"] * (larger > 0)
        counts += ["faces with fewer than 3 corners"] * bool((sizes < 3).any())
        raise InputError(
            f"faces: expected 4 vertices a face, found {' and '.join(counts)} among "
            f"{len(sizes)}; face {first}{_line(lines, first)} has {sizes[first]}; make quads of "
            "them first ('quads', in FreeCAD 'Quads from triangles')"
        )
    highest = max(max(polygon) for polygon in polygons)
    if highest >= vertex_count:
        face = next(k for k, polygon in enumerate(polygons) if max(polygon) >= vertex_count)
        shown = str(highest) if highest < 10**12 else "with a far too large number"
        raise InputError(
            f"faces: face {face}{_line(lines, face)} names vertex {shown}, but vertices are "
            f"numbered 0 to {vertex_count - 1}; mend the face or add the vertices"
        )
    return np.array(polygons, dtype=np.int64).reshape(-1, 4)


def _line(lines: Sequence[int], face: int) -> str:
    return f" (line {lines[face]})" if len(lines) else ""


def _refuse_wild_numbers(vertices: FloatArray) -> None:
    finite = np.isfinite(vertices).all(axis=1)
    if not finite.all():
        raise InputError(
            f"vertices: {int((~finite).sum())} have NaN or infinite coordinates, the first is "
            f"vertex {int(np.argmin(finite))}; mend the file"
        )
    if np.abs(vertices).max() > _LARGEST:
        vertex = int(np.argmax(np.abs(vertices).max(axis=1)))
        raise InputError(
            f"vertices: vertex {vertex} has a coordinate beyond {_LARGEST:g}; mend it or scale down"
        )


def _refuse_double_faces(faces: IntArray) -> None:
    _, first, counts = np.unique(
        np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True
    )
    if (counts > 1).any():
        raise InputError(
            f"faces: {int((counts > 1).sum())} have the same four corners as another, the first is "
            f"face {int(first[counts > 1].min())}; delete the doubles"
        )


def refuse_empty_faces(mesh: QuadMesh) -> None:
    """Refuse edges without length and faces without area.

    Raises:
        InputError: naming the first.
    """
    short = np.flatnonzero(mesh.edge_lengths == 0.0)
    if len(short):
        start, end = mesh.connectivity.edges[short[0]].tolist()
        raise InputError(
            f"edges: {len(short)} have no length, the first is edge {start} - {end}; "
            "merge its vertices or move one"
        )
    points = mesh.vertices[mesh.faces]
    diagonals = points[:, 2] - points[:, 0], points[:, 3] - points[:, 1]
    size = sum((diagonal**2).sum(axis=1) for diagonal in diagonals)
    empty = np.linalg.norm(mesh.face_area_vectors, axis=1) <= _ZERO_AREA * size
    if empty.any():
        raise InputError(
            f"faces: {int(empty.sum())} have no area, the first is face {int(np.argmax(empty))}; "
            "delete or repair them"
        )
