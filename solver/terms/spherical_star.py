"""E_Anet and E_Snet: the five points of a vertex star lie in a plane or on a sphere."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from solver.mesh.connectivity import IntArray
from solver.mesh.quadmesh import FloatArray
from solver.terms.base import Linearisation, Size, coordinates_of, dot, length, points_of

# Newton steps for a star's own curvature; it starts from the least-squares value.
_OWN_STEPS = 4
# Keep clear of stars that would wrap more than half their sphere.
_LARGEST_SINE = 0.999


@dataclass(frozen=True, eq=False)
class SphericalStar:
    """A star's points lie on a sphere of curvature k through its centre; k = 0 is a plane.

    The paper's E_Anet with ``curvature=0``, for constant mean curvature with one curvature given or
    shared, E_Snet with neither.

    With the spokes s1 .. s4 from the centre and w_j = |s_j|^2 / 2, the sphere with unit normal n
    at the centre contains s_j where n . s_j = k w_j. The differences of opposite spokes fix n,

        n . (s1 - s3) = k (w1 - w3),   n . (s2 - s4) = k (w2 - w4),   |n| = 1,

    and the sums are what is left to ask for, divided by the mean spoke length L:

        r1 = (n . (s1 + s3) - k (w1 + w3)) / (2 L),   r2 = (n . (s2 + s4) - k (w2 + w4)) / (2 L)

    So neither the normal nor the centre is an unknown. Two rows a star, one where every star has a
    curvature of its own (the row that no change of that curvature can mend).

    Args:
        stars: (n, 5) centre and four neighbours in cyclic order.
        curvature: the given k in 1 / mean edge, or None.
        shared: position of one unknown k in the flat vector, or None. With neither, each star has
            its own curvature.

    Source: Dellinger, Li, Wang (2023), Discrete Orthogonal Structures, sections 4.3 and 4.4.
    """

    stars: IntArray
    curvature: float | None = None
    shared: int | None = None
    name: str = "spherical stars"
    linear: bool = False

    @cached_property
    def unknowns(self) -> IntArray:
        """(n, 15) coordinates, or (n, 16) with the shared curvature last."""
        coordinates = coordinates_of(self.stars)
        if self.shared is None:
            return coordinates
        shared = np.full((len(self.stars), 1), self.shared, dtype=np.int64)
        return np.hstack([coordinates, shared])

    @property
    def size(self) -> Size:
        """A normal or a centre a star (and its radius); five points, or four and a unit length."""
        own = self.curvature is None and self.shared is None
        return Size((4 if own else 3) * len(self.stars), 5 * len(self.stars))

    def linearise(self, x: FloatArray) -> Linearisation:
        """Return (n, 2) and (n, 2, 15), with the curvature's column added or its row eliminated."""
        v = points_of(x, self.unknowns[:, :15])
        spokes = v[:, 1:] - v[:, :1]
        star = _star(spokes)
        if self.shared is not None:
            k = np.full(len(v), x[self.shared])
        elif self.curvature is not None:
            k = np.full(len(v), self.curvature)
        else:
            k = _own_curvatures(star)
        frame = _frame(star, k)
        residual, by_k = _residuals(star, frame, k)
        by_spokes = _by_spokes(star, frame, spokes, k, residual)
        if self.shared is None and self.curvature is None:
            residual, by_spokes = _without_curvature(residual, by_spokes, by_k)
        by_centre = -sum(by_spokes[:, :, j : j + 1] for j in range(4))
        jacobian = np.concatenate([by_centre, by_spokes], axis=2)
        jacobian = jacobian.reshape(len(v), residual.shape[1], 15)
        if self.shared is not None:
            jacobian = np.concatenate([jacobian, by_k[:, :, None]], axis=2)
        return Linearisation(residual, jacobian)


class _Star(NamedTuple):
    """What the spheres of all curvatures through a star share.

    The normal of the sphere of curvature k is k lean + sqrt(1 - k^2 |lean|^2) upright. Differences
    and sums of opposite spokes are (n, 2, 3), those of their heights w (n, 2).
    """

    differences: FloatArray
    sums: FloatArray
    height_differences: FloatArray
    height_sums: FloatArray
    lengths: FloatArray
    mean: FloatArray
    lean: FloatArray
    upright: FloatArray


def _star(spokes: FloatArray) -> _Star:
    square = np.einsum("nij,nij->ni", spokes, spokes)
    lengths = np.sqrt(square)
    differences = spokes[:, :2] - spokes[:, 2:]
    height_differences = 0.5 * (square[:, :2] - square[:, 2:])
    a, b = differences[:, 0], differences[:, 1]
    m = np.cross(a, b)
    area = length(m)
    upright = m / area[:, None]
    # Across both differences, scaled by the other's height: lean . a = alpha, lean . b = beta.
    drift = height_differences[:, :1] * b - height_differences[:, 1:] * a
    return _Star(
        differences=differences,
        sums=spokes[:, :2] + spokes[:, 2:],
        height_differences=height_differences,
        height_sums=0.5 * (square[:, :2] + square[:, 2:]),
        lengths=lengths,
        mean=lengths.mean(axis=1),
        lean=np.cross(drift, upright) / area[:, None],
        upright=upright,
    )


def _along(pairs: FloatArray, direction: FloatArray) -> FloatArray:
    """(n, 2) scalar products of two vectors (n, 2, 3) an element with its direction (n, 3)."""
    return np.stack([dot(pairs[:, 0], direction), dot(pairs[:, 1], direction)], axis=1)


def _own_curvatures(star: _Star) -> FloatArray:
    """(n,) curvature with which the star's two residuals are smallest together."""
    steep = dot(star.lean, star.lean)
    limit = _LARGEST_SINE / np.sqrt(np.maximum(steep, 1e-300))
    # Up to a common factor, r(k) = k lean . sum + sqrt(1 - k^2 steep) upright . sum - k height.
    leaning, upright = _along(star.sums, star.lean).T, _along(star.sums, star.upright).T
    heights = star.height_sums.T
    k = np.zeros(len(steep))
    for _ in range(_OWN_STEPS):
        bound = np.clip(k, -limit, limit)
        cosine = np.sqrt(1.0 - steep * bound**2)
        residual = bound * leaning + cosine * upright - k * heights
        by_k = leaning - (bound * steep / cosine) * upright - heights
        k = k - (residual * by_k).sum(axis=0) / np.maximum((by_k**2).sum(axis=0), 1e-300)
    return k


class _Frame(NamedTuple):
    """What residuals and derivatives share.

    Attributes:
        normal: (n, 3) of the sphere at the centre.
        turns: (n, 2, 2) change of the normal with both differences, seen along both sums.
    """

    normal: FloatArray
    turns: FloatArray


def _frame(star: _Star, k: FloatArray) -> _Frame:
    sine = k * length(star.lean)
    kept = np.clip(sine, -_LARGEST_SINE, _LARGEST_SINE)
    p = (k * kept / np.where(sine == 0.0, 1.0, sine))[:, None] * star.lean
    n = p + np.sqrt(1.0 - kept**2)[:, None] * star.upright
    a, b = star.differences[:, 0], star.differences[:, 1]
    across_b, across_a = np.cross(b, n), np.cross(n, a)
    turns = np.stack([_along(star.sums, across_b), _along(star.sums, across_a)], axis=2)
    return _Frame(n, turns / dot(a, across_b)[:, None, None])


def _residuals(star: _Star, frame: _Frame, k: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Residuals (n, 2) and their derivatives by the curvature (n, 2)."""
    residual = _along(star.sums, frame.normal) - k[:, None] * star.height_sums
    drift = frame.turns * star.height_differences[:, None]
    by_k = drift[:, :, 0] + drift[:, :, 1] - star.height_sums
    scale = (0.5 / star.mean)[:, None]
    return scale * residual, scale * by_k


def _by_spokes(
    star: _Star, frame: _Frame, spokes: FloatArray, k: FloatArray, residual: FloatArray
) -> FloatArray:
    """Derivatives of the residuals by the spokes, (n, 2, 4, 3)."""
    towards = frame.normal[:, None, :] - k[:, None, None] * spokes
    direction = spokes / star.lengths[:, :, None]
    own = np.array([[1.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, 1.0]])
    factor = own + np.concatenate([-frame.turns, frame.turns], axis=2)
    factor *= (0.5 / star.mean)[:, None, None]
    shrink = (0.25 / star.mean)[:, None] * residual
    result: FloatArray = factor[..., None] * towards[:, None]
    result -= shrink[:, :, None, None] * direction[:, None]
    return result


def _without_curvature(
    residual: FloatArray, by_spokes: FloatArray, by_k: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Keep the one combination of the two rows that the star's own curvature cannot change."""
    across = np.stack([-by_k[:, 1], by_k[:, 0]], axis=1) / length(by_k)[:, None]
    return dot(residual, across)[:, None], np.einsum("ni,nijc->njc", across, by_spokes)[:, None]
