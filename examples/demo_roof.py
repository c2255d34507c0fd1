"""The demo roof by formula: a free-standing canopy of 480 quads on four feet.

The surface is synclastic over the middle and anticlastic where its two visors rise, its border is
nowhere planar, and its parameter lines are sheared on purpose, so that its faces are neither planar
nor orthogonal: a shape as an architect would draw it, not one that is already solved.

Run it to write the mesh: ``python examples/demo_roof.py [OUT.obj]``.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

HALF_LENGTH = 12_000.0
HALF_WIDTH = 10_000.0
SHEAR = 0.1
FACES_ALONG = 24
FACES_ACROSS = 20


def surface(u: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points of the roof in mm for u along and v across, both from -1 to 1."""
    along = u + SHEAR * v * (1 - u**2)
    across = v + SHEAR * u * (1 - v**2)
    visor = 1 + 0.1 * (1 - across**2)
    x = HALF_LENGTH * along * visor
    y = HALF_WIDTH * across * (0.9 + 0.1 * along**2)
    side_arch = 2_400 * (1 - along**2)
    cross_arch = (3_000 + 1_100 * along**4) * (1 - across**2)
    return np.stack([x, y, side_arch + cross_arch], axis=-1)


def demo_roof() -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """(525, 3) vertices in mm and (480, 4) faces, counter-clockwise seen from above."""
    u, v = np.meshgrid(
        np.linspace(-1, 1, FACES_ALONG + 1), np.linspace(-1, 1, FACES_ACROSS + 1), indexing="ij"
    )
    vertices = surface(u, v).reshape(-1, 3)
    number = np.arange(u.size, dtype=np.int64).reshape(u.shape)
    corners = [number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]]
    return vertices, np.stack(corners, axis=-1).reshape(-1, 4)


def main() -> None:
    """Write the roof as an OBJ file."""
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
    from solver.io.obj import write_obj
    from solver.mesh.quadmesh import QuadMesh

    default = Path(__file__).parent / "data" / "demo_roof.obj"
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else default
    mesh = QuadMesh(*demo_roof())
    write_obj(target, mesh, unit="mm")
    print(f"{target}: {len(mesh.vertices)} vertices, {len(mesh.faces)} quads")


if __name__ == "__main__":
    main()
