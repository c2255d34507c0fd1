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
        if self.shared is not None:
            k = np.full(len(v), x[self.shared])
        elif self.curvature is not None:
            k = np.full(len(v), self.curvature)
        else:
            k = own_curvatures(spokes)
        frame = _frame(spokes, k)
        residual, by_k = _residuals(frame, k)
        by_spokes = _by_spokes(frame, spokes, k, residual)
        if self.shared is None and self.curvature is None:
            residual, by_spokes = _without_curvature(residual, by_spokes, by_k)
        jacobian = np.concatenate([-by_spokes.sum(axis=2, keepdims=True), by_spokes], axis=2)
        jacobian = jacobian.reshape(len(v), residual.shape[1], 15)
        if self.shared is not None:
            jacobian = np.concatenate([jacobian, by_k[:, :, None]], axis=2)
        return Linearisation(residual, jacobian)


def own_curvatures(spokes: FloatArray) -> FloatArray:
    """(n,) curvature with which the star's two residuals are smallest together."""
    star = _lean(spokes)
    steep = dot(star.lean, star.lean)
    limit = _LARGEST_SINE / np.sqrt(np.maximum(steep, 1e-300))
    # Up to a common factor, r(k) = k lean . sum + sqrt(1 - k^2 steep) upright . sum - k height.
    leaning = np.stack([dot(star.lean, each) for each in star.sums])
    upright = np.stack([dot(star.upright, each) for each in star.sums])
    heights = np.stack(star.heights)
    k = np.zeros(len(spokes))
    for _ in range(_OWN_STEPS):
        bound = np.clip(k, -limit, limit)
        cosine = np.sqrt(1.0 - steep * bound**2)
        residual = bound * leaning + cosine * upright - k * heights
        by_k = leaning - (bound * steep / cosine) * upright - heights
        k = k - (residual * by_k).sum(axis=0) / np.maximum((by_k**2).sum(axis=0), 1e-300)
    return k


class _Lean(NamedTuple):
    """What the spheres of all curvatures through a star share.

    The normal of the sphere of curvature k is k lean + sqrt(1 - k^2 |lean|^2) upright.
    """

    across: tuple[FloatArray, FloatArray]
    alpha: FloatArray
    beta: FloatArray
    sums: tuple[FloatArray, FloatArray]
    heights: tuple[FloatArray, FloatArray]
    lengths: FloatArray
    lean: FloatArray
    upright: FloatArray


def _lean(spokes: FloatArray) -> _Lean:
    s1, s2, s3, s4 = (spokes[:, j] for j in range(4))
    square = np.einsum("nij,nij->ni", spokes, spokes)
    w = 0.5 * square
    a, b = s1 - s3, s2 - s4
    alpha, beta = w[:, 0] - w[:, 2], w[:, 1] - w[:, 3]
    m = np.cross(a, b)
    area = length(m)
    upright = m / area[:, None]
    towards = alpha[:, None] * np.cross(b, upright) + beta[:, None] * np.cross(upright, a)
    return _Lean(
        across=(a, b),
        alpha=alpha,
        beta=beta,
        sums=(s1 + s3, s2 + s4),
        heights=(w[:, 0] + w[:, 2], w[:, 1] + w[:, 3]),
        lengths=np.sqrt(square),
        lean=towards / area[:, None],
        upright=upright,
    )


class _Frame(NamedTuple):
    """What residuals and derivatives of stars share."""

    normal: FloatArray
    across: tuple[FloatArray, FloatArray]
    determinant: FloatArray
    alpha: FloatArray
    beta: FloatArray
    sums: tuple[FloatArray, FloatArray]
    heights: tuple[FloatArray, FloatArray]
    lengths: FloatArray

    @property
    def mean(self) -> FloatArray:
        """(n,) mean spoke length."""
        return np.asarray(self.lengths.mean(axis=1))

    def factors(self, row: int) -> tuple[FloatArray, FloatArray]:
        """Change of the normal with both differences of opposite spokes, seen along a sum."""
        return (
            dot(self.across[0], self.sums[row]) / self.determinant,
            dot(self.across[1], self.sums[row]) / self.determinant,
        )


def _frame(spokes: FloatArray, k: FloatArray) -> _Frame:
    star = _lean(spokes)
    a, b = star.across
    sine = k * length(star.lean)
    kept = np.clip(sine, -_LARGEST_SINE, _LARGEST_SINE)
    p = (k * kept / np.where(sine == 0.0, 1.0, sine))[:, None] * star.lean
    n = p + np.sqrt(1.0 - kept**2)[:, None] * star.upright
    across_b, across_a = np.cross(b, n), np.cross(n, a)
    return _Frame(
        normal=n,
        across=(across_b, across_a),
        determinant=dot(a, across_b),
        alpha=star.alpha,
        beta=star.beta,
        sums=star.sums,
        heights=star.heights,
        lengths=star.lengths,
    )


def _residuals(frame: _Frame, k: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Residuals (n, 2) and their derivatives by the curvature (n, 2)."""
    residual = np.empty((len(k), 2))
    by_k = np.empty((len(k), 2))
    for row in range(2):
        g1, g2 = frame.factors(row)
        height = frame.heights[row]
        residual[:, row] = dot(frame.normal, frame.sums[row]) - k * height
        by_k[:, row] = g1 * frame.alpha + g2 * frame.beta - height
    scale = (0.5 / frame.mean)[:, None]
    return scale * residual, scale * by_k


def _by_spokes(
    frame: _Frame, spokes: FloatArray, k: FloatArray, residual: FloatArray
) -> FloatArray:
    """Derivatives of the residuals by the spokes, (n, 2, 4, 3)."""
    towards = frame.normal[:, None, :] - k[:, None, None] * spokes
    direction = spokes / frame.lengths[:, :, None]
    mean = frame.mean
    result = np.empty((len(k), 2, 4, 3))
    for row in range(2):
        own = np.zeros(4)
        own[[row, row + 2]] = 1.0
        g1, g2 = frame.factors(row)
        factor = (own + np.stack([-g1, -g2, g1, g2], axis=1)) * (0.5 / mean)[:, None]
        shrink = 0.25 * residual[:, row] / mean
        result[:, row] = factor[:, :, None] * towards - shrink[:, None, None] * direction
    return result


def _without_curvature(
    residual: FloatArray, by_spokes: FloatArray, by_k: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Keep the one combination of the two rows that the star's own curvature cannot change."""
    across = np.stack([-by_k[:, 1], by_k[:, 0]], axis=1) / length(by_k)[:, None]
    return dot(residual, across)[:, None], np.einsum("ni,nijc->njc", across, by_spokes)[:, None]
