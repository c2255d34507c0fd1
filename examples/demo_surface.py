"""The demo's roof as an architect hands it over: one curved face in a STEP file, without any mesh.

A shell that is domed in the middle and rises at one end to two wings. It has two round points
(umbilics), around which lines of curvature part, and its border follows none of them.

Run it to write the file: ``python examples/demo_surface.py [OUT.step]``.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import cadquery

HALF_LENGTH = 13_000.0
HALF_WIDTH = 10_000.0
# Rise of the dome, of its wings, and height of its lowest corners.
DOME, WINGS, FEET = 3_400.0, 900.0, 500.0
POINTS = 41
# How far the face may be from the formula.
TOLERANCE = 0.01


def surface(u: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points of the roof in mm for u along and v across, both from -1 to 1."""
    along = u * (1 + 0.05 * (1 - v**2))
    across = v * (1 + 0.08 * (1 - u**2))
    x, y = HALF_LENGTH * along, HALF_WIDTH * across
    far = (x**2 + y**2) / (HALF_LENGTH**2 + HALF_WIDTH**2)
    lowest = -DOME - 4 * WINGS
    z = -DOME * far + WINGS * (along**3 + 3 * along * across**2) - lowest + FEET
    return np.stack([x, y, z], axis=-1)


def demo_surface() -> cadquery.Face:
    """The roof as a B-spline face, mm."""
    import cadquery

    u, v = np.meshgrid(*[np.linspace(-1, 1, POINTS)] * 2, indexing="ij")
    points = [[cadquery.Vector(*place) for place in row] for row in surface(u, v).tolist()]
    return cadquery.Face.makeSplineApprox(points, tol=TOLERANCE)


def main() -> None:
    """Write the roof as a STEP file."""
    import cadquery

    default = Path(__file__).parent / "data" / "demo_roof.step"
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else default
    face = demo_surface()
    cadquery.exporters.export(cadquery.Workplane(face), str(target))
    print(f"{target}: a face of {face.Area() / 1e6:.1f} m2")


if __name__ == "__main__":
    main()
