"""Angles between edges and their derivatives, shared by all terms that speak of angles."""

from __future__ import annotations

import numpy as np

from solver.mesh.quadmesh import FloatArray


def unit_and_length(vectors: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Split (..., 3) vectors into unit vectors (..., 3) and lengths (...)."""
    size = np.sqrt(np.einsum("...i,...i->...", vectors, vectors))
    return vectors / size[..., None], size


def cosines(one: FloatArray, two: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Cosine of the angle between (..., 3) vectors, and its derivatives by each of them."""
    a, length_a = unit_and_length(one)
    b, length_b = unit_and_length(two)
    cosine = np.einsum("...i,...i->...", a, b)
    by_a = (b - cosine[..., None] * a) / length_a[..., None]
    by_b = (a - cosine[..., None] * b) / length_b[..., None]
    return cosine, by_a, by_b


def angles(one: FloatArray, two: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Angle between (..., 3) vectors in radians, and its derivatives by each of them.

    The derivative of the angle is undefined where the vectors are parallel; there it is bounded.
    """
    a, _ = unit_and_length(one)
    b, _ = unit_and_length(two)
    apart, together = a - b, a + b
    half = np.arctan2(
        np.sqrt(np.einsum("...i,...i->...", apart, apart)),
        np.sqrt(np.einsum("...i,...i->...", together, together)),
    )
    _, by_a, by_b = cosines(one, two)
    sine = np.maximum(np.sin(2 * half), 1e-6)[..., None]
    return 2 * half, -by_a / sine, -by_b / sine
