"""A net and its axes as coordinates: every point near it lies over a face, at (u, v) and a height.

A point is ``S(u, v) + h A(u, v)`` with ``S`` a face's corners and ``A`` the axes there, both
bilinear. Neighbours agree along their common side, and in every parallel mesh a point has the same
(u, v): what is cut there stands along the axes, as beams do.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray, QuadMesh

_STEPS, _EXACT = 12, 1e-9
# (u, v) beyond these say only that the point lies over another face.
_FAR = (-2.0, 3.0)
# The directions of half-edges 0 to 3 of a face, and where they begin, in (u, v).
_STARTS = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])


@dataclass(frozen=True, eq=False)
class Rays:
    """The coordinates of a net.

    Attributes:
        corners: (F, 4, 3) of the faces.
        axes: (F, 4, 3) offsets per unit height there.
    """

    corners: FloatArray
    axes: FloatArray

    @classmethod
    def of(cls, mesh: QuadMesh, offsets: FloatArray) -> Rays:
        """Those of a mesh with offsets (V, 3) of a parallel one."""
        return cls(mesh.vertices[mesh.faces], offsets[mesh.faces])

    def points(self, faces: IntArray, uv: FloatArray) -> FloatArray:
        """(N, 3) points of the net at (u, v) (N, 2) in faces (N,)."""
        return np.asarray(np.einsum("nc,nck->nk", _bilinear(uv)[0], self.corners[faces]))

    def offsets(self, faces: IntArray, uv: FloatArray) -> FloatArray:
        """(N, 3) the axes at (u, v) (N, 2) in faces (N,)."""
        return np.asarray(np.einsum("nc,nck->nk", _bilinear(uv)[0], self.axes[faces]))

    def feet(self, points: FloatArray, faces: IntArray) -> FloatArray:
        """(N, 3) u, v and height of points (N, 3), each over a face (N,), or beside it.

        Newton's method; the height is in units of the axes.
        """
        corners, axes = self.corners[faces], self.axes[faces]
        found = np.column_stack([np.full((len(points), 2), 0.5), np.zeros(len(points))])
        for _ in range(_STEPS):
            weights, by_u, by_v = _bilinear(found[:, :2])
            spread = corners + found[:, 2, None, None] * axes
            columns = [np.einsum("nc,nck->nk", by, spread) for by in (by_u, by_v)]
            columns.append(np.einsum("nc,nck->nk", weights, axes))
            missing = points - np.einsum("nc,nck->nk", weights, spread)
            if np.abs(missing).max() <= _EXACT:
                break
            found = found + _solved(np.stack(columns, axis=2), missing)
            found[:, :2] = np.clip(found[:, :2], *_FAR)
        return found

    def crossing(
        self, face: int, side: int, start: FloatArray, end: FloatArray
    ) -> tuple[float, float]:
        """Where the way between two points meets the surface along a side's axes.

        Returns:
            The place along the side from its first corner, 0 to 1, and along the way, 0 to 1.
        """
        ends = [side, (side + 1) % 4]
        (here, there), (axis, other) = self.corners[face, ends], self.axes[face, ends]
        # Place along the side, height, place along the way.
        found = np.array([0.5, 0.0, 0.5])
        for _ in range(_STEPS):
            place, height, way = found
            lean = axis + place * (other - axis)
            reached = here + place * (there - here) + height * lean
            columns = [there - here + height * (other - axis), lean, start - end]
            missing = start + way * (end - start) - reached
            if np.abs(missing).max() <= _EXACT:
                break
            found = found + _solved(np.stack(columns, axis=1)[None], missing[None])[0]
            found = np.clip(found, [-1.0, -np.inf, -1.0], [2.0, np.inf, 2.0])
        place, _, way = np.clip(found, 0.0, [1.0, np.inf, 1.0])
        return float(place), float(way)


def on_side(side: int, place: float) -> FloatArray:
    """(2,) u and v of a place along a side, 0 at its first corner."""
    start, end = _STARTS[side], _STARTS[(side + 1) % 4]
    return np.asarray(start + place * (end - start))


def along_side(side: int, uv: FloatArray) -> float:
    """How far along a side a point lies, 0 at its first corner."""
    start, end = _STARTS[side], _STARTS[(side + 1) % 4]
    return float((uv - start) @ (end - start))


def inside_of(uv: FloatArray) -> FloatArray:
    """(..., 4) how far points (..., 2) lie inside of each side; negative beyond it."""
    u, v = uv[..., 0], uv[..., 1]
    return np.stack([v, 1 - u, 1 - v, u], axis=-1)


def bilinear(corners: FloatArray, uv: FloatArray) -> FloatArray:
    """(N, K) points at (N, 2) between corners (4, K)."""
    return np.asarray(_bilinear(uv)[0] @ corners)


def _bilinear(uv: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """(N, 4) weights of the corners at (N, 2), and their derivatives by u and v."""
    u, v = uv.T
    one = np.ones(len(uv))
    weights = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=1)
    by_u = np.stack([v - one, one - v, v, -v], axis=1)
    by_v = np.stack([u - one, -u, u, one - u], axis=1)
    return weights, by_u, by_v


def _solved(matrices: FloatArray, right: FloatArray) -> FloatArray:
    """(N, 3) solutions of (N, 3, 3) systems; the shortest where there are many."""
    return np.asarray(np.einsum("nij,nj->ni", np.linalg.pinv(matrices), right))
