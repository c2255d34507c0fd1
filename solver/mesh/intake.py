"""From raw polygons to a usable quad mesh: what can be mended is mended and said."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from solver.errors import InputError
from solver.mesh.connectivity import Connectivity, IntArray
from solver.mesh.mixed import MixedConnectivity, refuse_bad_polygons, words_of_sizes
from solver.mesh.orientation import oriented, oriented_polygons
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.mesh.seams import seams

# A face whose area vector is below this part of its squared sides has no direction.
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
    remarks: list[str] = []
    faces = _quads(polygons, len(vertices), lines, remarks)
    _refuse_wild_numbers(vertices)
    Connectivity.check_corners(faces, len(vertices))
    faces = _without_doubles(faces, remarks)
    faces = oriented(vertices, faces, remarks)
    mesh = QuadMesh(vertices, Connectivity(faces, len(vertices)))
    refuse_empty_faces(mesh)
    return mesh, [*remarks, *_unusual(mesh)]


def any_mesh(
    vertices: FloatArray, polygons: Sequence[Sequence[int]], lines: Sequence[int] = ()
) -> tuple[QuadMesh, list[str]]:
    """The same of faces with any number of corners; a quad mesh where all of them have four.

    Of other meshes :class:`solver.mesh.mixed.MixedConnectivity` is the connectivity.

    Raises:
        InputError: faces of fewer than three corners, bad numbers, non-manifold or non-orientable
            edges.
    """
    corners = [_without_repeats(polygon) for polygon in polygons]
    if not corners or all(len(polygon) == 4 for polygon in corners):
        return quad_mesh(vertices, polygons, lines)
    refuse_missing_vertices(corners, len(vertices), lines)
    _refuse_wild_numbers(vertices)
    refuse_bad_polygons(corners, len(vertices))
    remarks: list[str] = []
    net = MixedConnectivity(oriented_polygons(corners, remarks), len(vertices))
    mesh = QuadMesh(vertices, net)
    refuse_empty_faces(mesh)
    remarks.append(f"faces of several sizes: {words_of_sizes(net.face_sizes)}")
    return mesh, [*remarks, *_unusual(mesh)]


def _unusual(mesh: QuadMesh) -> list[str]:
    """Vertices without faces, several components, and what meets without being joined."""
    remarks = []
    unused = np.flatnonzero(~mesh.connectivity.referenced)
    if len(unused):
        remarks.append(
            f"{len(unused)} vertices belong to no face (first: {unused[0]}); kept where they are"
            if len(unused) > 1
            else f"vertex {unused[0]} belongs to no face; kept where it is"
        )
    parts = int(mesh.connectivity.components.max()) + 1
    if parts > 1:
        remarks.append(f"{parts} separate components; each is treated on its own")
    return [*remarks, *seams(mesh).remarks()]


def _quads(
    polygons: Sequence[Sequence[int]],
    vertex_count: int,
    lines: Sequence[int],
    remarks: list[str],
) -> IntArray:
    if not len(polygons):
        raise InputError("faces: expected at least one, got none; export the mesh's faces")
    given, polygons = polygons, [_without_repeats(polygon) for polygon in polygons]
    _refuse_other_sizes(given, polygons, lines)
    repeats = [k for k, polygon in enumerate(given) if len(polygon) > 4]
    if repeats:
        remarks.append(
            f"{len(repeats)} faces name a corner twice in a row (first: face {repeats[0]}); read "
            "as quads"
        )
    refuse_missing_vertices(polygons, vertex_count, lines)
    return np.array(polygons, dtype=np.int64).reshape(-1, 4)


def _refuse_other_sizes(
    given: Sequence[Sequence[int]], polygons: Sequence[Sequence[int]], lines: Sequence[int]
) -> None:
    """Refuse faces that are no quads once no corner is repeated."""
    sizes = np.array([len(polygon) for polygon in polygons])
    wrong = np.flatnonzero(sizes != 4)
    if not len(wrong):
        return
    triangles, larger, first = int((sizes == 3).sum()), int((sizes > 4).sum()), int(wrong[0])
    counts = [f"{triangles} triangle{'s' * (triangles > 1)}"] * (triangles > 0)
    counts += [f"{larger} face{'s' * (larger > 1)} with more than 4 corners"] * (larger > 0)
    counts += ["faces with fewer than 3 corners"] * bool((sizes < 3).any())
    twice = ", one of them named twice" if len(given[first]) > len(polygons[first]) else ""
    raise InputError(
        f"faces: expected 4 vertices a face, found {' and '.join(counts)} among {len(sizes)}; face "
        f"{first}{_line(lines, first)} has {sizes[first]}{twice}; make quads of them first "
        "('quads', in FreeCAD 'Quads from triangles')"
    )


def _without_repeats(polygon: Sequence[int]) -> Sequence[int]:
    """Corners without those that are the same as the one before."""
    if len(set(polygon)) == len(polygon):
        return polygon
    return [corner for k, corner in enumerate(polygon) if corner != polygon[k - 1]]


def refuse_missing_vertices(
    polygons: Sequence[Sequence[int]], vertex_count: int, lines: Sequence[int] = ()
) -> None:
    """Refuse faces that name vertices which do not exist.

    Raises:
        InputError: naming the first.
    """
    for face, polygon in enumerate(polygons):
        for corner in polygon:
            if not 0 <= corner < vertex_count:
                shown = str(corner) if abs(corner) < 10**12 else "with a far too large number"
                raise InputError(
                    f"faces: face {face}{_line(lines, face)} names vertex {shown}, but vertices "
                    f"are numbered 0 to {vertex_count - 1}; mend the face or add the vertices"
                )


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


def _without_doubles(faces: IntArray, remarks: list[str]) -> IntArray:
    """Faces without those that have the corners of an earlier one, in the same or reverse order."""
    least = np.argmin(faces, axis=1)[:, None]
    turned = np.take_along_axis(faces, (least + np.arange(4)) % 4, axis=1)
    other = turned[:, [0, 3, 2, 1]]
    rows = np.where((turned[:, 1] < turned[:, 3])[:, None], turned, other)
    first = np.sort(np.unique(rows, axis=0, return_index=True)[1])
    count = len(faces) - len(first)
    if count:
        double = int(np.setdiff1d(np.arange(len(faces)), first)[0])
        remarks.append(
            f"{count} faces have the corners of another (first: face {double}); left out, the "
            "others are numbered without them"
            if count > 1
            else f"face {double} has the corners of another; left out, the others are numbered "
            "without it"
        )
    return faces[first]


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
    ends = mesh.vertices[mesh.connectivity.half_edges]
    square = ((ends[:, 1] - ends[:, 0]) ** 2).sum(axis=1)
    size = np.bincount(mesh.connectivity.half_faces, square, mesh.connectivity.face_count)
    empty = np.linalg.norm(mesh.face_area_vectors, axis=1) <= _ZERO_AREA * size
    if empty.any():
        raise InputError(
            f"faces: {int(empty.sum())} have no area, the first is face {int(np.argmax(empty))}; "
            "delete or repair them"
        )
