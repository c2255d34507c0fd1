"""D figure 4: six orthogonal multi-nets; the equal diagonals of all their rectangles.

(a) lambda moves and a curve gives mu and nu; (b) the same, reflected in two coordinate planes;
(c) to (f) mu or nu moves.

Run it from the root of the project: ``python -m examples.six_multi_nets [PICTURE.png]``.
"""

from __future__ import annotations

import sys

from examples.drawing import Panel, draw
from solver import QuadMesh
from solver.multinet import elliptic_net, multi_net_residual, reflected
from solver.multinet.presets import preset

AXES = (9.0, 5.0, 2.0)


def net(moving: str, curve: str, m: int, n: int, t: tuple[float, float] | None = None) -> QuadMesh:
    """One net by the name of its curve, m x n vertices."""
    chosen = preset(curve)
    smooth = elliptic_net(AXES, moving, chosen.curve, unfolded=True, closed=chosen.closed)
    return smooth.sampled(m, n, t)


def six_nets() -> dict[str, QuadMesh]:
    """The nets in the order of the figure."""
    part = net("lambda", "wave", 19, 13, (-1.2, 4.0))
    return {
        "(a) lambda moves": part,
        "(b) and is reflected": reflected(part, "xy"),
        "(c) mu moves": net("mu", "arch", 29, 13),
        "(d) mu moves, closed curve": net("mu", "loop", 32, 15),
        "(e) nu moves": net("nu", "arch", 25, 19),
        "(f) nu moves, reflected": reflected(net("nu", "wave", 19, 19, (-9.0, -5.4)), "x"),
    }


if __name__ == "__main__":
    nets = six_nets()
    worst = max(multi_net_residual(mesh).bound for mesh in nets.values())
    print(f"no rectangle has diagonals that differ by more than {worst:.0e} of the squared size")
    if len(sys.argv) > 1:
        turns = (20, -60, 20, -50, -110, -60)
        panels = [Panel(*net, turn) for net, turn in zip(nets.items(), turns, strict=True)]
        draw(panels, sys.argv[1])
