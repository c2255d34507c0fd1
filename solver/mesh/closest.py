"""Closest points on a triangle mesh and on a polyline, exact and for many points at once.

A tree of boxes rejects what cannot be nearest; what is left is compared exactly. Nothing is sampled
and no neighbourhood is guessed, so a point gets its true closest point wherever it lies.
"""

from __future__ import annotations

from copy import copy
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from solver.errors import InputError
from solver.mesh.box_tree import FACE, BoxTree, Hit
from solver.mesh.connectivity import BoolArray
from solver.mesh.features import open_sides, pseudo_normals
from solver.mesh.quadmesh import FloatArray, QuadMesh, unit_rows

# Nearer than this part of the size of what is hit, a direction from point to foot is rounding.
_TOUCHING = 1e-9


class TriangleSurface:
    """A triangle mesh that answers where its closest points are.

    Args:
        vertices: (V, 3) coordinates.
        triangles: (T, 3) vertex numbers; triangles without area count as segments or points.

    Raises:
        InputError: wrong shapes, coordinates that are not finite, vertex numbers out of range.
    """

    def __init__(self, vertices: ArrayLike, triangles: ArrayLike) -> None:
        self.vertices = _points(vertices, "vertices")
        self.triangles = np.asarray(triangles, dtype=np.int64)
        if self.triangles.ndim != 2 or self.triangles.shape[1] != 3 or not len(self.triangles):
            raise InputError(
                f"triangles: expected shape (T, 3) with T > 0, got {self.triangles.shape}; "
                "triangulate the surface first"
            )
        if self.triangles.min() < 0 or self.triangles.max() >= len(self.vertices):
            raise InputError(
                f"triangles: vertices are numbered 0 to {len(self.vertices) - 1}, got "
                f"{self.triangles.min()} to {self.triangles.max()}; mend the file"
            )
        self._corners = self.vertices[self.triangles]
        self._boxes = BoxTree(self._corners)
        # Of the same triangles elsewhere, where this was made from those.
        self._elsewhere: TriangleSurface | None = None
        self._normals, self._side_normals, self._corner_normals = pseudo_normals(
            self._corners, self.triangles
        )

    @classmethod
    def from_quads(cls, mesh: QuadMesh) -> TriangleSurface:
        """Split quads along their shorter diagonals, faces of any size from their first corners."""
        if mesh.connectivity.mixed:
            return cls(mesh.vertices, mesh.connectivity.triangles)
        quads, points = mesh.faces, mesh.vertices
        first, second = (
            np.linalg.norm(points[quads[:, k + 2]] - points[quads[:, k]], axis=1) for k in (0, 1)
        )
        turned = np.where((second < first)[:, None], np.roll(quads, -1, axis=1), quads)
        return cls(points, np.concatenate([turned[:, [0, 1, 2]], turned[:, [0, 2, 3]]]))

    def scaled(self, centre: FloatArray, scale: float) -> TriangleSurface:
        """The same about another origin and in another unit; what has no unit is taken over.

        Args:
            centre: (3,) the new origin.
            scale: the new unit.
        """
        other = copy(self)
        other.vertices = _points((self.vertices - centre) / scale, "vertices")
        other._corners = other.vertices[self.triangles]
        other._boxes = BoxTree(other._corners, self._boxes.order)
        other._elsewhere = self
        return other

    def closest(self, points: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Return the closest points and the normals of the tangent planes there.

        Args:
            points: (N, 3) coordinates.

        Returns:
            (N, 3) feet, and (N, 3) unit normals on the side that the triangles face. Inside a
            triangle it is its normal. On an edge or a vertex it is the direction between point and
            foot; of a point that lies there itself, the mean of the faces around (edge: of their
            normals, vertex: weighted by their angles). Where the surface has no area it is some
            unit vector.
        """
        query = _points(points, "points", empty=True)
        return self._normals_at(query, self._boxes.nearest(query, self._corners))

    def _normals_at(self, query: FloatArray, hit: Hit) -> tuple[FloatArray, FloatArray]:
        """Feet and normals for :meth:`closest`."""
        pseudo = self._pseudo_normals(hit)
        away = query - hit.feet
        distance = np.linalg.norm(away, axis=1)
        size = self._boxes.sizes[hit.item]
        on_rim = (hit.feature != FACE) & (distance > _TOUCHING * size)
        side = np.where(np.einsum("ij,ij->i", away, pseudo) < 0, -1.0, 1.0)
        directed = unit_rows(away) * side[:, None]
        normals = np.where(on_rim[:, None], directed, pseudo)
        normals[~normals.any(axis=1)] = [0.0, 0.0, 1.0]
        return hit.feet, normals

    def beside(self, points: ArrayLike) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Like :meth:`closest`, but beyond the border with the normals of the surface itself.

        Args:
            points: (N, 3) coordinates.

        Returns:
            (N, 3) feet, (N, 3) unit normals, and (N, 3) unit vectors across these that lead from
            the border to points beyond it; zero for all others.
        """
        query = _points(points, "points", empty=True)
        hit = self._boxes.nearest(query, self._corners)
        feet, normals = self._normals_at(query, hit)
        on_side, on_corner = (hit.feature >= 0) & (hit.feature < 3), hit.feature >= 3
        sides, corners = self._open
        at_border = np.zeros(len(query), dtype=bool)
        at_border[on_side] = sides[hit.item[on_side], hit.feature[on_side]]
        at_border[on_corner] = corners[hit.item[on_corner], hit.feature[on_corner] - 3]
        normals[at_border] = self._pseudo_normals(hit)[at_border]
        away = query - feet
        away -= np.einsum("ij,ij->i", away, normals)[:, None] * normals
        far = np.linalg.norm(away, axis=1) > _TOUCHING * self._boxes.sizes[hit.item]
        return feet, normals, np.where((at_border & far)[:, None], unit_rows(away), 0.0)

    @cached_property
    def _open(self) -> tuple[BoolArray, BoolArray]:
        if self._elsewhere is not None:
            return self._elsewhere._open
        return open_sides(self.vertices, self.triangles)

    def _pseudo_normals(self, hit: Hit) -> FloatArray:
        """(N, 3) mean normals of the faces, edges and vertices that were hit."""
        normals = self._normals[hit.item].copy()
        on_side = (hit.feature >= 0) & (hit.feature < 3)
        on_corner = hit.feature >= 3
        normals[on_side] = self._side_normals[hit.item[on_side], hit.feature[on_side]]
        numbers = self.triangles[hit.item[on_corner], hit.feature[on_corner] - 3]
        normals[on_corner] = self._corner_normals[numbers]
        return normals


class Polyline:
    """A polyline that answers where its closest points are.

    Args:
        points: (M, 3) coordinates in order; repeated points are allowed.
        closed: whether the last point is joined to the first.

    Raises:
        InputError: fewer than two points, or coordinates that are not finite.
    """

    def __init__(self, points: ArrayLike, closed: bool = False) -> None:
        path = _points(points, "polyline")
        keep = np.append(True, (path[1:] != path[:-1]).any(axis=1))
        path = path[keep]
        if closed and len(path) > 1 and (path[0] == path[-1]).all():
            path = path[:-1]
        if len(path) < 2:
            raise InputError(
                f"polyline: expected two different points or more, got {len(path)}; add points"
            )
        self.points = path
        self.closed = closed
        ends = np.roll(path, -1, axis=0)
        starts, ends = (path, ends) if closed else (path[:-1], ends[:-1])
        self._corners = np.stack([starts, ends, ends], axis=1)
        self._boxes = BoxTree(self._corners)
        self._directions = unit_rows(ends - starts)

    def closest(self, points: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Return the closest points and the tangents there.

        Args:
            points: (N, 3) coordinates.

        Returns:
            (N, 3) feet and (N, 3) unit tangents in the direction of the polyline. At a vertex it
            is the mean of the two directions (of the first, where they are opposite). It is zero
            for a point beyond an open end: nothing leads on from there.
        """
        query = _points(points, "points", empty=True)
        hit = self._boxes.nearest(query, self._corners)
        tangents = self._directions[hit.item].copy()
        at_start, at_end = _ends(hit, self._corners)
        count = len(self._directions)
        for mask, other in ((at_start, hit.item - 1), (at_end, hit.item + 1)):
            mean = unit_rows(tangents + self._directions[other % count])
            joined = mask & (self.closed | ((other >= 0) & (other < count))) & mean.any(axis=1)
            tangents[joined] = mean[joined]
        if not self.closed:
            along = np.einsum("ij,ij->i", query - hit.feet, self._directions[hit.item])
            touching = _TOUCHING * self._boxes.sizes[hit.item]
            before = at_start & (hit.item == 0) & (along < -touching)
            after = at_end & (hit.item == count - 1) & (along > touching)
            tangents[before | after] = 0.0
        return hit.feet, tangents


def _ends(hit: Hit, corners: FloatArray) -> tuple[BoolArray, BoolArray]:
    """(N,) whether the foot is the start of the segment that was hit, and whether its end."""
    segment = corners[hit.item]
    at_start = (hit.feet == segment[:, 0]).all(axis=1)
    return at_start, (hit.feet == segment[:, 1]).all(axis=1)


def _points(points: ArrayLike, name: str, empty: bool = False) -> FloatArray:
    """(N, 3) finite coordinates."""
    result = np.asarray(points, dtype=np.float64)
    if result.ndim != 2 or result.shape[1] != 3 or (not empty and not len(result)):
        raise InputError(f"{name}: expected shape (N, 3), got {result.shape}; give 3D points")
    if not np.isfinite(result).all():
        raise InputError(f"{name}: some coordinates are NaN or infinite; mend the file")
    return result
