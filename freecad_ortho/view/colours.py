"""From a dimensionless measure to a colour: blue is good, red is bad, decades between."""

from __future__ import annotations

import numpy as np

from solver.mesh.quadmesh import FloatArray

# Blue, light blue, pale yellow, orange, red: readable with the usual colour vision deficiencies.
_STOPS = np.array(
    [
        (0.19, 0.33, 0.64),
        (0.45, 0.68, 0.82),
        (0.97, 0.93, 0.68),
        (0.96, 0.62, 0.31),
        (0.72, 0.10, 0.15),
    ]
)
_SUN = np.array([0.36, -0.48, 0.80])
_DARKEST = 0.7


def palette(fraction: FloatArray) -> FloatArray:
    """Blend the palette's colours: (N,) numbers from 0 (blue) to 1 (red) to (N, 3) RGB."""
    position = np.clip(fraction, 0.0, 1.0) * (len(_STOPS) - 1)
    steps = np.arange(len(_STOPS))
    return np.stack([np.interp(position, steps, _STOPS[:, k]) for k in range(3)], axis=1)


def colours(values: FloatArray, lowest_decade: int, highest_decade: int) -> FloatArray:
    """Colour each value by its power of ten.

    Args:
        values: (N,) measures, zero or larger.
        lowest_decade: blue at and below 10 to this power.
        highest_decade: red at and above 10 to this power.

    Returns:
        (N, 3) RGB from 0 to 1.
    """
    decades = max(highest_decade - lowest_decade, 1)
    with np.errstate(divide="ignore"):
        exponent = np.log10(values)
    return palette((exponent - lowest_decade) / decades)


def shading(normals: FloatArray) -> FloatArray:
    """Darken faces gently by their direction, the same from wherever one looks.

    Args:
        normals: (F, 3) unit normals; which side they point to does not matter.

    Returns:
        (F,) factors on the faces' colours.
    """
    return _DARKEST + (1.0 - _DARKEST) * np.abs(normals @ _SUN)
