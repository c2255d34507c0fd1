"""D figure 7: a little fairness with E_multi is smooth and stays doubly curved; neither is alone.

The rough roof of ``multi_net_regulariser`` (a) with E_multi only (b), with E_fair only (c), with
both (d). How doubly curved a mesh is, is said by the Gauss curvature of the quadric that fits it.

Run it from the root of the project: ``python -m examples.smooth_and_doubly_curved``.
"""

from __future__ import annotations

import numpy as np

from examples.multi_net_regulariser import orthogonal, rough_roof
from solver import QuadMesh

# Fairness and multi of each picture.
PICTURES = {"b": (0.0, 1.0), "c": (1.0, 0.0), "d": (0.001, 1.0)}


def picture(name: str) -> QuadMesh:
    """The mesh of one picture."""
    fairness, multi = PICTURES[name]
    return orthogonal(rough_roof()[1], fairness, multi)


def double_curvature(mesh: QuadMesh) -> float:
    """K at the middle of the best quadric z = q(x, y) over the best plane, in 1 / unit^2."""
    arms = mesh.vertices - mesh.vertices.mean(axis=0)
    x, y, z = (arms @ np.linalg.svd(arms, full_matrices=False)[2].T).T
    terms = np.stack([np.ones_like(x), x, y, x * x / 2, x * y, y * y / 2], axis=1)
    _, slope_x, slope_y, xx, xy, yy = np.linalg.lstsq(terms, z, rcond=None)[0]
    return float((xx * yy - xy**2) / (1 + slope_x**2 + slope_y**2) ** 2)


if __name__ == "__main__":
    kept = double_curvature(picture("d")) / double_curvature(rough_roof()[0])
    print(f"both energies keep {kept:.2f} of the roof's double curvature")
