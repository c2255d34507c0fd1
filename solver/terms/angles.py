"""Angles between edges and their derivatives, shared by all terms that speak of angles."""

from __future__ import annotations

import numpy as np

from solver.mesh.quadmesh import FloatArray


def unit_and_length(vectors: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Split (..., 3) vectors into unit vectors (..., 3) and lengths (...)."""
    size = _length(vectors)
    return vectors / size[..., None], size


def cosines(one: FloatArray, two: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Cosine of the angle between (..., 3) vectors, and its derivatives by each of them."""
    return _cosines(*unit_and_length(one), *unit_and_length(two))


def angles(one: FloatArray, two: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Angle between (..., 3) vectors in radians, and its derivatives by each of them.

    The derivative of the angle is undefined where the vectors are parallel; there it is bounded.
    """
    a, length_a = unit_and_length(one)
    b, length_b = unit_and_length(two)
    apart, together = _length(a - b), _length(a + b)
    _, by_a, by_b = _cosines(a, length_a, b, length_b)
    # Of unit vectors these are twice the sine and the cosine of half the angle.
    sine = np.maximum(0.5 * apart * together, 1e-6)[..., None]
    return 2 * np.arctan2(apart, together), by_a / -sine, by_b / -sine


def _cosines(
    a: FloatArray, length_a: FloatArray, b: FloatArray, length_b: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The same from unit vectors and lengths."""
    cosine = np.einsum("...i,...i->...", a, b)
    by_a = (b - cosine[..., None] * a) / length_a[..., None]
    by_b = (a - cosine[..., None] * b) / length_b[..., None]
    return cosine, by_a, by_b


def _length(vectors: FloatArray) -> FloatArray:
    return np.asarray(np.sqrt(np.einsum("...i,...i->...", vectors, vectors)))
