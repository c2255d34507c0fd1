"""D figure 5: a line drawn near an ellipsoid snaps to it and determines a whole net.

One of its points is then dragged: the net follows, and its other lines stay where they are.

Run it from the root of the project: ``python -m examples.drawn_multi_net [PICTURE.png]``.
"""

from __future__ import annotations

import sys

import numpy as np

from examples.drawing import Panel, draw
from freecad_ortho.sources.quadric_shape import quadric_mesh
from solver import QuadMesh
from solver.multinet import Quadric, multi_net, multi_net_residual

ELLIPSOID = Quadric.ellipsoid((3.0, 2.2, 1.4))
TURN, RISE = 45.0, 7.0
DRAWN = np.array(
    [[2.9, -0.4, 0.3], [2.3, 0.9, 0.5], [1.4, 1.3, 0.9], [0.3, 1.5, 1.0], [-1.0, 1.9, 0.7]]
)


def net(points: np.ndarray, m: int = 33, n: int = 15) -> QuadMesh:
    """The net of a drawn line, sampled m x n."""
    return multi_net(ELLIPSOID, points, snap=True, t_range=(-0.8, 4.0)).sampled(m, n)


def dragged() -> np.ndarray:
    """The drawn line with its middle point pulled down."""
    points = DRAWN.copy()
    points[2] += [0.1, 0.5, -0.5]
    return points


if __name__ == "__main__":
    nets = [("as drawn", net(DRAWN)), ("coarser", net(DRAWN, 13, 7)), ("dragged", net(dragged()))]
    worst = max(multi_net_residual(mesh).bound for _, mesh in nets)
    print(f"no rectangle has diagonals that differ by more than {worst:.0e} of the squared size")
    if len(sys.argv) > 1:
        ground, panels = quadric_mesh(ELLIPSOID), []
        for (name, mesh), points in zip(nets, (DRAWN, DRAWN, dragged()), strict=True):
            smooth = multi_net(ELLIPSOID, points, snap=True)
            curve, points = smooth.curve(np.linspace(0, 1, 200)), ELLIPSOID.project(points)
            panels.append(
                Panel(name, mesh, TURN, RISE, ground=ground, lines=[curve], points=points)
            )
        draw(panels, sys.argv[1])
