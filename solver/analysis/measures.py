"""Measures of a quad mesh, dimensionless, one value a face, edge or star.

Definitions are those of the project's table of measures (docs/nets.md). Nothing here depends on
the solver's own residuals, so that a result is judged by other code than made it.
"""

from __future__ import annotations

import numpy as np

from solver.mesh.combed import Combed
from solver.mesh.connectivity import BoolArray
from solver.mesh.quadmesh import FloatArray, QuadMesh, row_lengths, unit_rows

# Bends less than this, as a sum of squares in mean edges, are rounding.
_STRAIGHT = 1e-12


def orthogonality(
    mesh: QuadMesh, diagonal: bool = False, chosen: BoolArray | None = None
) -> FloatArray:
    """(F,) difference of the diagonal lengths / mean diagonal length.

    Args:
        mesh: the mesh to judge.
        diagonal: ask it of the diagonal meshes, whose faces are the four neighbours of a vertex:
            (S,) values, in the order of the stars.
        chosen: of which faces or stars; by default of all.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, definition 3.
    """
    net = mesh.connectivity
    quads = net.stars[:, 1:] if diagonal else net.faces
    corners = mesh.vertices[quads if chosen is None else quads[chosen]]
    first, second = (np.linalg.norm(corners[:, k + 2] - corners[:, k], axis=1) for k in (0, 1))
    return np.asarray(np.abs(first - second) / (0.5 * (first + second)))


def planarity(mesh: QuadMesh) -> FloatArray:
    """(F,) distance between the lines of the diagonals / mean diagonal length.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, figure 8.
    """
    if mesh.connectivity.mixed:
        net = mesh.connectivity
        ends = mesh.vertices[net.half_edges[:, 0]]
        across = row_lengths(mesh.vertices[net.half_edges[net.following, 1]] - ends)
        mean = np.bincount(net.half_faces, across, net.face_count) / net.face_sizes
        return np.asarray(diagonal_distances(mesh) / mean)
    first, second = _diagonal_lengths(mesh)
    return np.asarray(diagonal_distances(mesh) / (0.5 * (first + second)))


def four_in_plane(mesh: QuadMesh) -> FloatArray:
    """(P,) of ``flat_quads`` distance between the lines of the diagonals / their mean length."""
    a, b, c, d = mesh.vertices[mesh.connectivity.flat_quads].transpose(1, 0, 2)
    normal = unit_rows(np.cross(c - a, d - b))
    apart = np.abs(np.einsum("ij,ij->i", 0.5 * (a + c - b - d), normal))
    return np.asarray(apart / (0.5 * (row_lengths(c - a) + row_lengths(d - b))))


def diagonal_distances(mesh: QuadMesh) -> FloatArray:
    """(F,) distance between the lines of the diagonals, in the mesh's unit.

    That is twice the largest distance of a corner from the mean plane, as it is taken of faces with
    other than four corners.
    """
    if mesh.connectivity.mixed:
        return mesh.face_gaps
    a, b, c, d = _corners(mesh)
    between = 0.5 * (a + c - b - d)
    return np.asarray(np.abs(np.einsum("ij,ij->i", between, mesh.face_normals)))


def circular(mesh: QuadMesh) -> FloatArray:
    """(F,) abs(sum of opposite face angles - pi), the worse of both pairs, in radians."""
    angles = face_angles(mesh)
    excess = np.abs(angles[:, :2] + angles[:, 2:] - np.pi)
    return np.asarray(excess.max(axis=1))


def conical(mesh: QuadMesh) -> FloatArray:
    """(S,) difference of the two sums of opposite angles at each interior star, in radians.

    Source: Liu et al. (2006), Geometric modeling with conical meshes and developable surfaces.
    """
    angles = star_angles(mesh)
    return np.abs(angles[:, 0] + angles[:, 2] - angles[:, 1] - angles[:, 3])


def medial_angle(
    mesh: QuadMesh,
    angle: float = np.pi / 2,
    chosen: BoolArray | None = None,
    diagonal: bool = False,
) -> FloatArray:
    """(F,) deviation of the angle between the medial lines from ``angle``, in radians.

    ``chosen`` are the faces that count, by default all. With ``diagonal`` (S,) that of the faces
    of the diagonal meshes, whose corners are the four neighbours of a vertex.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, lemma 4.
    """
    combed = Combed(mesh.connectivity)
    quads = combed.stars[:, 1:] if diagonal else combed.faces
    values = np.abs(medial_angles(mesh.vertices[quads]) - angle)
    return values if chosen is None else values[chosen]


def uneven_angle(mesh: QuadMesh, diagonal: bool = False) -> FloatArray:
    """(F,) deviation of the angle between the medial lines from their median, in radians.

    Faces at singular vertices have no say in that. With ``diagonal`` (S,) that of the faces of the
    diagonal meshes.
    """
    net = mesh.connectivity
    combed = Combed(net)
    angles = medial_angles(mesh.vertices[combed.stars[:, 1:] if diagonal else combed.faces])
    if not combed.families:
        angles = np.minimum(angles, np.pi - angles)
    counted = angles[~(net.singular_stars if diagonal else net.singular_faces)]
    return np.abs(angles - np.median(counted if len(counted) else angles))


def medial_angles(corners: FloatArray) -> FloatArray:
    """(n,) angle between the lines through midpoints of opposite sides of (n, 4, 3) corners."""
    a, b, c, d = corners.transpose(1, 0, 2)
    return _angles(b + c - a - d, c + d - a - b)


def isometry(mesh: QuadMesh, reference: FloatArray) -> FloatArray:
    """(F,) worst relative change of a face's diagonal lengths and of their dot product.

    Args:
        mesh: the shape to judge.
        reference: (V, 3) positions of the same mesh in the reference shape.

    Source: Jiang et al. (2021), Using isometries for computational design and fabrication.
    """
    rest = mesh.with_vertices(reference)
    now, then = _diagonal_lengths(mesh), _diagonal_lengths(rest)
    lengths = [np.abs(one / two - 1.0) for one, two in zip(now, then, strict=True)]
    size = 0.5 * (then[0] ** 2 + then[1] ** 2)
    lengths.append(np.abs(_diagonal_product(mesh) - _diagonal_product(rest)) / size)
    return np.asarray(np.max(lengths, axis=0))


def equal_edges(
    mesh: QuadMesh,
    chosen: BoolArray | None = None,
    length: float | None = None,
    diagonal: bool = False,
) -> FloatArray:
    """(n,) deviation of chosen edges from their mean length, or a given one, relative to it.

    With ``diagonal``, of face diagonals, the edges of the diagonal meshes.
    """
    ends = mesh.connectivity.diagonal_edges if diagonal else mesh.connectivity.edges
    points = mesh.vertices[ends if chosen is None else ends[chosen]]
    lengths = np.linalg.norm(points[:, 1] - points[:, 0], axis=1)
    return np.asarray(np.abs(lengths / (lengths.mean() if length is None else length) - 1.0))


def equal_angles(mesh: QuadMesh, diagonal: bool = False) -> FloatArray:
    """(S,) largest difference between the cosines of the four angles of a star.

    Source: Rabinovich, Hoffmann, Sorkine-Hornung (2018), Discrete geodesic nets for modeling
    developable surfaces.
    """
    cosines = np.cos(star_angles(mesh, diagonal))
    return np.asarray(cosines.max(axis=1) - cosines.min(axis=1))


def geodesic(mesh: QuadMesh, diagonal: bool = False) -> FloatArray:
    """(S,) difference of the cosines of opposite angles at each interior star, the worse pair.

    Source: Wunderlich (1951), via Dellinger, Li, Wang (2023), definition 6.
    """
    cosines = np.cos(star_angles(mesh, diagonal))
    return np.asarray(np.abs(cosines[:, :2] - cosines[:, 2:]).max(axis=1))


def chebyshev(mesh: QuadMesh, diagonal: bool = False) -> FloatArray:
    """(E,) deviation of each edge length from the mean / mean.

    With ``diagonal`` (F,) that of the diagonals of each face, the worse of both.
    """
    values = equal_edges(mesh, diagonal=diagonal)
    return values.reshape(-1, 2).max(axis=1) if diagonal else values


def asymptotic(mesh: QuadMesh, diagonal: bool = False) -> FloatArray:
    """(S,) farthest neighbour of a star from the best plane through its centre / mean edge.

    Source: Sauer (1937), via Dellinger, Li, Wang (2023), section 4.3.
    """
    spokes = star_spokes(mesh, diagonal)
    if not len(spokes):
        return np.zeros(0)
    normal = np.linalg.eigh(spokes.swapaxes(1, 2) @ spokes)[1][:, :, 0]
    distance = np.abs(np.einsum("sij,sj->si", spokes, normal)).max(axis=1)
    return np.asarray(distance / mesh.mean_edge)


def edge_ratio(mesh: QuadMesh) -> float:
    """Shortest edge / mean edge."""
    return float(mesh.edge_lengths.min() / mesh.mean_edge)


def thickness(mesh: QuadMesh) -> float:
    """Smallest over largest root mean square extent of the vertices: zero for a plane."""
    points = mesh.vertices[mesh.connectivity.referenced]
    extents = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return float(extents[2] / extents[0])


def sharpest_crease(mesh: QuadMesh) -> float:
    """Largest angle between the normals of two neighbouring faces, in degrees."""
    left, right = mesh.connectivity.edge_faces[~mesh.connectivity.boundary_edges].T
    if not len(left):
        return 0.0
    angles = _angles(mesh.face_normals[left], mesh.face_normals[right])
    return float(np.degrees(angles.max()))


def area(mesh: QuadMesh) -> float:
    """Sum of the areas of all faces, in the mesh's unit; of bent faces that of their projection."""
    return float(np.linalg.norm(mesh.face_area_vectors, axis=1).sum())


def smoothness(mesh: QuadMesh) -> float:
    """Correlation of consecutive second differences along the parameter lines.

    One where lines bend evenly, below zero where they zigzag, and one where they are straight.
    """
    a, b, c, d = mesh.vertices[mesh.connectivity.line_quadruples].transpose(1, 0, 2)
    first, second = 2 * b - a - c, 2 * c - b - d
    size = 0.5 * float((first**2).sum() + (second**2).sum())
    return float((first * second).sum()) / size if size > _STRAIGHT * mesh.mean_edge**2 else 1.0


def flipped(mesh: QuadMesh) -> BoolArray:
    """(F,) true where a face lies against its neighbours or turns a corner inside out."""
    normals = mesh.face_normals
    left, right = mesh.connectivity.edge_faces[~mesh.connectivity.boundary_edges].T
    count = len(normals)
    around = np.stack(
        [
            np.bincount(left, normals[right, k], count)
            + np.bincount(right, normals[left, k], count)
            for k in range(3)
        ],
        axis=1,
    )
    against = np.einsum("ij,ij->i", normals, around) < 0
    return np.asarray(against | _inside_out(mesh))


def _inside_out(mesh: QuadMesh) -> BoolArray:
    """(F,) true where a corner of a face turns against it."""
    net = mesh.connectivity
    ends = mesh.vertices[net.half_edges]
    ahead = ends[:, 1] - ends[:, 0]
    turns = np.cross(ahead, ahead[net.following])
    wrong = np.einsum("hk,hk->h", turns, mesh.face_normals[net.half_faces]) <= 0
    return np.bincount(net.half_faces, wrong, net.face_count).astype(bool)


def face_angles(mesh: QuadMesh) -> FloatArray:
    """(F, 4) angle at each corner of each face, in radians."""
    points = mesh.vertices[mesh.faces]
    return _angles(np.roll(points, -1, axis=1) - points, np.roll(points, 1, axis=1) - points)


def slant(mesh: QuadMesh) -> float:
    """Largest deviation of a corner of a face from a right angle, in degrees."""
    off = np.abs(face_angles(mesh) - 0.5 * np.pi)
    return float(np.degrees(off.max(initial=0.0)))


def star_angles(mesh: QuadMesh, diagonal: bool = False) -> FloatArray:
    """(S, 4) angles between consecutive edges of each interior star, in radians."""
    spokes = star_spokes(mesh, diagonal)
    return _angles(spokes, np.roll(spokes, -1, axis=1))


def star_spokes(mesh: QuadMesh, diagonal: bool = False) -> FloatArray:
    """(S, 4, 3) vectors from the centre of each interior star to its neighbours.

    With ``diagonal``, to the opposite corners of its faces: the star of the diagonal net.
    """
    net = mesh.connectivity
    points = mesh.vertices[net.diagonal_stars if diagonal else net.stars]
    return points[:, 1:] - points[:, :1]


def _angles(one: FloatArray, two: FloatArray) -> FloatArray:
    """Angle between vectors by the half-angle form, exact for tiny and flat angles alike."""
    one, two = unit_rows(one), unit_rows(two)
    return np.asarray(2 * np.arctan2(row_lengths(one - two), row_lengths(one + two)))


def _corners(mesh: QuadMesh) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    points = mesh.vertices[mesh.faces]
    return points[:, 0], points[:, 1], points[:, 2], points[:, 3]


def _diagonal_product(mesh: QuadMesh) -> FloatArray:
    a, b, c, d = _corners(mesh)
    return np.asarray(np.einsum("ij,ij->i", c - a, d - b))


def _diagonal_lengths(mesh: QuadMesh) -> tuple[FloatArray, FloatArray]:
    a, b, c, d = _corners(mesh)
    return row_lengths(c - a), row_lengths(d - b)
