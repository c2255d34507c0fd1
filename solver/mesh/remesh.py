"""Quads from triangles by an optional library, brought back onto the surface and its border.

The library (pyQuadriFlow) is compiled code that may crash or hang: it runs in a process of its own
with a time limit. It works in single precision and leaves the border by a few percent of its
length, so every vertex is set back: border vertices onto the border polylines, corners onto
corners, the others onto the triangles.

Source: Huang et al. (2018), QuadriFlow: a scalable and robust method for quadrangulation.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial import cKDTree

from solver.errors import InputError
from solver.io.intake import quad_mesh
from solver.isolated import Isolated, LibraryError
from solver.mesh.border import Border, set_back
from solver.mesh.closest import TriangleSurface
from solver.mesh.coarsen import compact
from solver.mesh.connectivity import IntArray
from solver.mesh.mirror import SAME_PLACE, size_of
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.mesh.quadriflow import LIBRARY, Quadriflow


@dataclass(frozen=True, eq=False)
class Remeshed:
    """Quads in place of triangles.

    Attributes:
        mesh: the quads; vertices on the triangles, border on the border.
        irregular: (K,) interior vertices that have not four faces.
        border_gap: largest distance from a middle of a border edge to the original border.
    """

    mesh: QuadMesh
    irregular: IntArray
    border_gap: float


def quads_from_triangles(
    vertices: ArrayLike,
    triangles: ArrayLike,
    *,
    faces: int | None = None,
    edge: float | None = None,
    seed: int = 0,
    time_limit: float = 60.0,
    corner: float = 40.0,
    waiting: Callable[[float], object] | None = None,
) -> Remeshed:
    """Remesh a triangle mesh to quads.

    Args:
        vertices: (V, 3) coordinates, in the model's unit.
        triangles: (T, 3) vertex numbers.
        faces: wanted number of quads; met within about a third.
        edge: wanted edge length, instead of ``faces``.
        seed: another number gives another layout.
        time_limit: seconds that the library may take.
        corner: border vertices that turn by more than this (degrees) are kept as corners.
        waiting: called several times a second while the library works, with the part of the time
            limit that is over; what it raises ends the library and is passed on.

    Raises:
        InputError: a triangle soup, bad targets, the library missing, hanging or failing.
    """
    points, corners = _sound(vertices, triangles)
    wanted = _target(points, corners, faces, edge)
    shift, size = points.mean(axis=0), size_of(points)
    raw, quads = _run(
        (points - shift) / size, corners, wanted, seed, time_limit, waiting or (lambda part: None)
    )
    if not len(quads):
        raise InputError("remesh: the library gave no quads; try another seed or face count")
    try:
        mesh = quad_mesh(raw * size + shift, quads.tolist())[0]
        mesh = compact(mesh, mesh.faces)
    except InputError as error:
        raise InputError(
            f"remesh: the library's quads are unusable ({error}); try another seed or face count"
        ) from None
    mesh, gap = _set_back(mesh, points, corners, corner)
    net = mesh.connectivity
    return Remeshed(mesh, np.flatnonzero(~net.regular & ~net.boundary_vertices), gap)


def _sound(vertices: ArrayLike, triangles: ArrayLike) -> tuple[FloatArray, IntArray]:
    """Merge vertices at one place, drop what has no area, refuse what is no surface."""
    points = np.asarray(vertices, dtype=np.float64).reshape(-1, 3)
    corners = np.asarray(triangles, dtype=np.int64)
    TriangleSurface(points, corners)
    tree = cKDTree(points)
    first = np.array(
        [min(near) for near in tree.query_ball_point(points, SAME_PLACE * size_of(points))]
    )
    corners = first[corners]
    two, three = (points[corners[:, k]] - points[corners[:, 0]] for k in (1, 2))
    corners = corners[np.linalg.norm(np.cross(two, three), axis=1) > 0]
    if not len(corners):
        raise InputError("triangles: none has an area; export the surface again")
    kept, numbers = np.unique(corners, return_inverse=True)
    points, corners = points[kept], numbers.reshape(-1, 3)
    sides = np.sort(np.concatenate([corners[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    counts = np.unique(sides, axis=0, return_counts=True)[1]
    if (counts > 2).any():
        raise InputError(
            f"triangles: {int((counts > 2).sum())} edges have more than two triangles; separate "
            "the sheets that meet there first"
        )
    if (counts == 1).sum() > 0.75 * 3 * len(corners) and len(corners) > 2:
        raise InputError(
            "triangles: a soup of loose triangles, not a surface; join vertices at the same place "
            "(a larger tolerance) and export again"
        )
    return points, corners


def _target(points: FloatArray, corners: IntArray, faces: int | None, edge: float | None) -> int:
    if (faces is None) == (edge is None):
        raise InputError("remesh: expected either a number of faces or an edge length; give one")
    if edge is not None:
        if not (np.isfinite(edge) and edge > 0):
            raise InputError(f"edge: expected a positive length, got {edge:g}")
        one, two = (points[corners[:, k]] - points[corners[:, 0]] for k in (1, 2))
        faces = round(0.5 * float(np.linalg.norm(np.cross(one, two), axis=1).sum()) / edge**2)
    assert faces is not None
    if not 4 <= faces <= 200_000:
        raise InputError(f"faces: expected 4 to 200000 quads, got {faces}; change the target")
    return faces


def _run(
    points: FloatArray,
    corners: IntArray,
    faces: int,
    seed: int,
    time_limit: float,
    waiting: Callable[[float], object],
) -> tuple[FloatArray, IntArray]:
    """Call the library in its own process."""
    if importlib.util.find_spec(LIBRARY) is None:
        raise InputError(
            f"remesh: the library {LIBRARY} is not installed; install it with 'pip install "
            f"{LIBRARY}', or bring quads"
        )
    if not time_limit > 0:
        raise InputError(f"time limit: expected seconds above 0, got {time_limit:g}")
    with Isolated(Quadriflow) as library:
        try:
            vertices, quads = library.call(
                *("quads", points, corners, faces, seed), time_limit=time_limit, waiting=waiting
            )
        except LibraryError as error:
            raise InputError(
                f"remesh: the library failed ({error}); allow more time, ask for fewer faces, try "
                "another seed or clean the triangles"
            ) from None
    return vertices, quads


def _set_back(
    mesh: QuadMesh, points: FloatArray, triangles: IntArray, corner: float
) -> tuple[QuadMesh, float]:
    """Smooth within the surface; give the largest gap between the two borders as well."""
    border = _border(points, triangles, corner)
    done = set_back(mesh, TriangleSurface(points, triangles), border)
    net = done.connectivity
    if border is None or not net.boundary_edges.any():
        return done, 0.0
    middles = done.vertices[net.edges[net.boundary_edges]].mean(axis=1)
    gaps = border.curve.closest(middles)[0] - middles
    return done, float(np.linalg.norm(gaps, axis=1).max())


def _border(points: FloatArray, triangles: IntArray, corner: float) -> Border | None:
    """The border's segments, and the vertices where it turns sharply; None without a border."""
    half = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    pairs, counts = np.unique(np.sort(half, axis=1), axis=0, return_counts=True)
    rim = pairs[counts == 1]
    if not len(rim):
        return None
    both = np.concatenate([rim, rim[:, ::-1]])
    both = both[np.argsort(both[:, 0], kind="stable")]
    vertices, start, valence = np.unique(both[:, 0], return_index=True, return_counts=True)
    plain = valence == 2
    one, two = both[start[plain], 1], both[start[plain] + 1, 1]
    before, after = points[one] - points[vertices[plain]], points[two] - points[vertices[plain]]
    cosine = (before * after).sum(axis=1)
    cosine /= np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1)
    sharp = cosine > -np.cos(np.radians(corner))
    # Triangles without area count as segments.
    curve = TriangleSurface(points, rim[:, [0, 1, 1]])
    return Border(curve, points[np.concatenate([vertices[plain][sharp], vertices[~plain]])])
