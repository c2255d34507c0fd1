"""Three grid shells of 30 m like those of the freeGrid benchmark, and how easily they are built.

A barrel vault, a dome and a hyperbolic paraboloid, each free along two of its edges; own geometry
by formula, in metres: span B = 30 m and rise B / 8. Each is scored as it is drawn and as a
principal net: planarity, joints and their kinds, deviation of the lengths of beams.

Run it to print the scores: ``python examples/benchmark_shells.py``.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from solver import QuadMesh, optimise
from solver.analysis.build_score import BuildScore, build_score
from solver.mesh.grid import grid_mesh

SPAN, RISE = 30.0, 30.0 / 8
# Faces along and across.
FACES = 16
Heights = Callable[[NDArray[np.float64], NDArray[np.float64]], NDArray[np.float64]]

# Heights over a square, both coordinates from -1 to 1; x is the span.
SHELLS: dict[str, Heights] = {
    "barrel": lambda x, y: RISE * (1 - x**2) + 0 * y,
    "dome": lambda x, y: RISE * (1 - x**2) * (1 - 0.3 * y**2),
    "hypar": lambda x, y: RISE * (1 - x**2 + 0.6 * y**2),
}


def shell(name: str, faces: int = FACES) -> QuadMesh:
    """A shell as a grid of faces by faces quads, in metres."""
    x, y = np.meshgrid(*[np.linspace(-1, 1, faces + 1)] * 2, indexing="ij")
    points = [0.5 * SPAN * x, 0.5 * SPAN * y, SHELLS[name](x, y)]
    return grid_mesh(np.stack(points, axis=2))


def score(mesh: QuadMesh) -> BuildScore:
    """The measures of a mesh in metres."""
    return build_score(mesh, 1000.0)


if __name__ == "__main__":
    for name in SHELLS:
        start = shell(name)
        for words, mesh in (("drawn", start), ("principal", optimise(start).mesh)):
            found = score(mesh)
            print(
                f"{name}, {words}: planarity {found.planarity:.4f}, {found.joints} joints of "
                f"{found.joint_kinds} kinds, lengths {found.lengths:.4f}"
            )
