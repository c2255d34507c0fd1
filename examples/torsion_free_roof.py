"""D figure 11: a principal roof, and beams of constant height that meet in common axes.

The demo roof becomes principal: faces planar, diagonals equal. Its parallel mesh gives the axes,
and every beam lies in the plane of its two axes, without twist.

Run it from the root of the project: ``python -m examples.torsion_free_roof [PICTURE.png]``.
"""

from __future__ import annotations

import sys

import numpy as np

from examples.demo_roof import demo_roof
from examples.drawing import Panel, draw
from solver import QuadMesh, optimise
from solver.offset.axes import torsion_free_axes


def beams(mesh: QuadMesh, height: float) -> QuadMesh:
    """A planar quad on every edge, between the mesh and its parallel mesh at a height."""
    upper = mesh.vertices + height * torsion_free_axes(mesh).offsets
    one, two = mesh.connectivity.edges.T
    points = np.stack([mesh.vertices[one], mesh.vertices[two], upper[two], upper[one]], axis=1)
    return QuadMesh(points.reshape(-1, 3), np.arange(4 * len(one)).reshape(-1, 4))


def corner(mesh: QuadMesh, centre: np.ndarray, reach: float) -> QuadMesh:
    """The faces of a mesh near a point."""
    apart = np.linalg.norm(mesh.vertices[mesh.faces].mean(axis=1) - centre, axis=1)
    return QuadMesh(mesh.vertices, mesh.faces[apart < reach])


if __name__ == "__main__":
    roof = optimise(QuadMesh(*demo_roof()), "principal").mesh
    print(f"the worst beam twists by {np.degrees(torsion_free_axes(roof).twist.max()):.0e} degrees")
    if len(sys.argv) > 1:
        plates, steel = beams(roof, -450.0), "#c98f4e"
        near = roof.vertices[6 * 21 + 6]
        panels = [
            Panel("principal roof", roof, -55, 25),
            Panel("torsion-free beams", plates, -55, 25, steel),
            Panel("a part of it", corner(plates, near, 2600.0), -55, 32, steel),
        ]
        draw(panels, sys.argv[1], size=4.6, high=0.7)
