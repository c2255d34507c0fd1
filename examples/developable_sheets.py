"""D figure 13: one sheet made developable in three ways, its four corners fixed.

With all angles of a star equal (reference 21 of the paper), as an orthogonal geodesic net, and as
an orthogonal Chebyshev net. The area of the Gauss image says how far a sheet is from developable.

Run it from the root of the project: ``python -m examples.developable_sheets``.
"""

from __future__ import annotations

import numpy as np

from solver import QuadMesh, optimise
from solver.analysis.gauss_image import gauss_image_area
from solver.mesh.grid import grid_mesh

NETS = ("dog", "geodesic", "chebyshev")


def doubly_curved_sheet() -> QuadMesh:
    """21 x 17 vertices over an elliptic paraboloid, the lines askew to its axes."""
    u, v = np.meshgrid(np.linspace(-1, 1, 21), np.linspace(-0.8, 0.8, 17), indexing="ij")
    x, y = u + 0.1 * v, v - 0.1 * u
    return grid_mesh(np.stack([x, y, 0.4 * x**2 + 0.2 * y**2 + 0.1 * x * y], axis=2))


def developed(net: str) -> QuadMesh:
    """The sheet as a net of a developable surface, smoothed on the way."""
    return optimise(doubly_curved_sheet(), net, fix="corners", fairness=10.0).mesh


if __name__ == "__main__":
    areas = [gauss_image_area(developed(net)) for net in NETS]
    share = max(areas) / gauss_image_area(doubly_curved_sheet())
    print(f"the Gauss image keeps at most {100 * share:.1f} % of its area")
