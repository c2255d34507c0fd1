"""A quad mesh: fixed connectivity and the positions of its vertices."""

from __future__ import annotations

import os
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from solver.errors import InputError
from solver.mesh.connectivity import Connectivity, IntArray

FloatArray = NDArray[np.float64]


class QuadMesh:
    """Positions on a connectivity; immutable.

    Args:
        vertices: (V, 3) coordinates in the model's unit.
        faces: (F, 4) vertex numbers, counter-clockwise, or the connectivity of another mesh; that
            of faces with any number of corners is :class:`solver.mesh.mixed.MixedConnectivity`.

    Raises:
        InputError: wrong shape, a coordinate that is not finite, or faces that are no mesh.
    """

    def __init__(self, vertices: ArrayLike, faces: ArrayLike | Connectivity) -> None:
        points = _coordinates(vertices)
        if isinstance(faces, Connectivity):
            net = faces
            if len(points) != net.vertex_count:
                raise InputError(
                    f"vertices: expected shape ({net.vertex_count}, 3), got {points.shape}; give "
                    "one for each vertex of the connectivity"
                )
        else:
            net = Connectivity(_numbers(faces), len(points))
        points.setflags(write=False)
        self._vertices, self._connectivity = points, net

    def __repr__(self) -> str:
        """How large it is."""
        return f"QuadMesh({len(self.vertices)} vertices, {self.connectivity.face_count} faces)"

    @property
    def vertices(self) -> FloatArray:
        """(V, 3) coordinates in the model's unit."""
        return self._vertices

    @property
    def connectivity(self) -> Connectivity:
        """Which vertices its faces have, and all that follows from that."""
        return self._connectivity

    @classmethod
    def from_arrays(cls, vertices: ArrayLike, faces: ArrayLike) -> QuadMesh:
        """The same as ``QuadMesh(vertices, faces)``, for scripts that were written before it."""
        return cls(vertices, faces)

    @property
    def faces(self) -> IntArray:
        """(F, 4) vertex numbers.

        Raises:
            InputError: some faces have other than four corners.
        """
        return self.connectivity.faces

    def with_vertices(self, vertices: FloatArray) -> QuadMesh:
        """Return the same connectivity with other positions."""
        return QuadMesh(vertices, self.connectivity)

    def scaled(self, factor: float) -> QuadMesh:
        """Return the mesh with all coordinates multiplied by ``factor``."""
        return self.with_vertices(self.vertices * factor)

    @cached_property
    def edge_lengths(self) -> FloatArray:
        """(E,) lengths in the order of ``connectivity.edges``."""
        start, end = self.connectivity.edges.T
        return row_lengths(self.vertices[end] - self.vertices[start])

    @property
    def mean_edge(self) -> float:
        """Mean edge length, the yardstick of every dimensionless measure."""
        return float(self.edge_lengths.mean())

    @cached_property
    def face_area_vectors(self) -> FloatArray:
        """(F, 3) half the cross product of the diagonals: direction the normal, length the area.

        Of faces with other than four corners the sum of those of their triangles.
        """
        if self.connectivity.mixed:
            return self._polygon_area_vectors()
        a, b, c, d = (self.vertices[self.faces[:, k]] for k in range(4))
        return 0.5 * np.cross(c - a, d - b)

    @cached_property
    def face_normals(self) -> FloatArray:
        """(F, 3) unit normals; zero where a face has no area."""
        return unit_rows(self.face_area_vectors)

    @cached_property
    def vertex_normals(self) -> FloatArray:
        """(V, 3) unit normals, area-weighted mean of the faces; zero where no face is."""
        corners, count = self.connectivity.half_edges[:, 0], len(self.vertices)
        area = self.face_area_vectors[self.connectivity.half_faces]
        total = [np.bincount(corners, area[:, k], count) for k in range(3)]
        return unit_rows(np.stack(total, axis=1))

    @cached_property
    def face_middles(self) -> FloatArray:
        """(F, 3) means of the corners of each face."""
        net = self.connectivity
        return self._face_sums(self.vertices[net.half_edges[:, 0]]) / net.face_sizes[:, None]

    @cached_property
    def face_gaps(self) -> FloatArray:
        """(F,) twice the largest distance of a corner from the mean plane of each face.

        Of a face with four corners that is the distance between the lines of its diagonals.
        """
        net = self.connectivity
        arms = self.vertices[net.half_edges[:, 0]] - self.face_middles[net.half_faces]
        heights = np.einsum("hk,hk->h", arms, self.face_normals[net.half_faces])
        gaps = np.zeros(net.face_count)
        np.maximum.at(gaps, net.half_faces, 2 * np.abs(heights))
        return gaps

    def _face_sums(self, values: FloatArray) -> FloatArray:
        """(F, 3) sums over the half-edges (H, 3) of each face."""
        net = self.connectivity
        sums = [np.bincount(net.half_faces, values[:, k], net.face_count) for k in range(3)]
        return np.stack(sums, axis=1)

    def _polygon_area_vectors(self) -> FloatArray:
        net = self.connectivity
        around = self.face_middles[net.half_faces]
        start, end = (self.vertices[net.half_edges[:, k]] - around for k in (0, 1))
        return 0.5 * self._face_sums(cross_rows(start, end))


def row_lengths(vectors: FloatArray) -> FloatArray:
    """Length of each row of an array of vectors."""
    return np.asarray(np.linalg.norm(vectors, axis=-1))


def cross_rows(one: FloatArray, two: FloatArray) -> FloatArray:
    """(N, 3) cross products of rows; numpy's own takes twice as long for some thousand of them."""
    (a, b, c), (u, v, w) = one.T, two.T
    return np.stack([b * w - c * v, c * u - a * w, a * v - b * u], axis=1)


def unit_rows(vectors: FloatArray) -> FloatArray:
    """Divide each row by its length; zero rows stay zero."""
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length > 0, length, 1.0)


def _coordinates(values: ArrayLike) -> FloatArray:
    """(V, 3) copy of finite coordinates."""
    try:
        points = np.array(values, dtype=np.float64, order="C")
    except (TypeError, ValueError):
        raise InputError(
            "vertices: expected numbers of shape (V, 3), got what is no array of numbers; give "
            "three coordinates a vertex"
        ) from None
    if points.ndim != 2 or points.shape[1] != 3:
        raise InputError(
            f"vertices: expected shape (V, 3), got {points.shape}; give three coordinates a vertex"
        )
    finite = np.isfinite(points).all(axis=1)
    if not finite.all():
        raise InputError(
            f"vertices: {int((~finite).sum())} have NaN or infinite coordinates, the first is "
            f"vertex {int(np.argmin(finite))}; mend the file"
        )
    return points


def _numbers(values: ArrayLike) -> IntArray:
    """Whole numbers; floats will do where they are whole, as they are in tables of text."""
    try:
        given = np.asarray(values)
        with np.errstate(invalid="ignore"):
            whole = given.astype(np.int64)
        same = bool((whole == given).all())
    except (TypeError, ValueError):
        same = False
    if not same:
        raise InputError(
            "faces: expected whole numbers of shape (F, 4), got what is none; give the numbers of "
            "four vertices a face, from 0"
        )
    return whole


def refuse_other(mesh: object) -> None:
    """Refuse what is no mesh, as the name of a file, where a function wants one.

    Raises:
        InputError: saying how a mesh is made of it.
    """
    if isinstance(mesh, QuadMesh):
        return
    if isinstance(mesh, (str, os.PathLike)):
        remedy = "read the file with read_mesh first"
    elif isinstance(getattr(mesh, "mesh", None), QuadMesh):
        remedy = "give its .mesh"
    else:
        remedy = "QuadMesh(vertices, faces) makes one of arrays"
    raise InputError(f"mesh: expected a QuadMesh, got {type(mesh).__name__}; {remedy}")
