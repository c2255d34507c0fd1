"""From numbers to colours: a palette for good to bad, one for both signs, shades by direction."""

from __future__ import annotations

import numpy as np

from solver.mesh.quadmesh import FloatArray

# Blue, light blue, pale yellow, orange, red: readable with the usual colour vision deficiencies.
_ORDERED = np.array(
    [
        (0.19, 0.33, 0.64),
        (0.45, 0.68, 0.82),
        (0.97, 0.93, 0.68),
        (0.96, 0.62, 0.31),
        (0.72, 0.10, 0.15),
    ]
)
# White in the middle, where the sign changes.
_SIGNED = np.array(
    [
        (0.13, 0.31, 0.60),
        (0.55, 0.75, 0.88),
        (0.96, 0.96, 0.96),
        (0.95, 0.68, 0.52),
        (0.70, 0.12, 0.16),
    ]
)
NO_VALUE = (0.62, 0.62, 0.64)
_SUN = np.array([0.36, -0.48, 0.80])
_DARKEST = 0.7


def palette(fraction: FloatArray, signed: bool = False) -> FloatArray:
    """Blend the palette's colours: (N,) numbers from 0 (blue) to 1 (red) to (N, 3) RGB.

    NaN, where there is no value, becomes grey.
    """
    stops = _SIGNED if signed else _ORDERED
    known = np.isfinite(fraction)
    position = np.clip(np.where(known, fraction, 0.0), 0.0, 1.0) * (len(stops) - 1)
    steps = np.arange(len(stops))
    blend = np.stack([np.interp(position, steps, stops[:, k]) for k in range(3)], axis=1)
    return np.where(known[:, None], blend, NO_VALUE)


def shading(normals: FloatArray) -> FloatArray:
    """Darken gently by direction, the same from wherever one looks.

    Args:
        normals: (N, 3) unit normals; which side they point to does not matter.

    Returns:
        (N,) factors on the colours.
    """
    return _DARKEST + (1.0 - _DARKEST) * np.abs(normals @ _SUN)
