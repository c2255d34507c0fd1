"""A source of nets that the project does not have, in one file."""

from __future__ import annotations

import numpy as np

from freecad_ortho.sources import Made, Source
from freecad_ortho.sources.placing import PLACEMENT, placed
from solver.mesh.grid import grid_mesh
from solver.option import Option


def _ramp(sampling: tuple[int, int], width: float, slope: float, placement, unit: str) -> Made:
    x, y = np.meshgrid(*(np.linspace(0.0, width, count) for count in sampling), indexing="ij")
    points = np.stack([x, y, np.tan(np.radians(slope)) * x], axis=2)
    return Made(placed(grid_mesh(points), placement), (f"rises by {points[-1, 0, 2]:g} {unit}",))


RAMP = Source(
    "ramp",
    "Square that rises in one direction",
    (
        Option("sampling", (5, 4), "count", "vertices along u and v"),
        Option("width", 6000.0, "length", "the square is this wide"),
        Option("slope", 30.0, "angle", "it rises under this angle"),
        PLACEMENT,
    ),
    _ramp,
)
