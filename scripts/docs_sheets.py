"""Makes the picture and prints the numbers of bent panels and patches in docs/fabrication.md.

Run with the project's Python:
    python scripts/docs_sheets.py

Needs the meshes of the paper's authors beside the repository.
"""

from __future__ import annotations

import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from bench import ROOT
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

sys.path.insert(0, str(ROOT))

from freecad_ortho import api
from freecad_ortho.fabrication import FlatPattern, Structure
from tests.conftest import SHARED

PICTURE = ROOT / "docs" / "pictures" / "sheets.png"
EXAMPLES = (
    ("heart", "principal", "bent-panels"),
    ("chebyshev_sphere", "geodesic-chebyshev", "patches"),
)
BLUE, ORANGE, DARK, RED = "#4a7ab5", "#d08a3c", "#26292f", "#b81a26"


def make(name: str, net: str, system: str) -> Structure:
    """Optimise a mesh and build it of sheets."""
    mesh = api.optimise(api.read_mesh(SHARED / f"{name}.obj").mesh, net).mesh
    return api.fabricate(mesh, system, unit="m", thickness=2.0)


def draw_in_place(space: plt.Axes, structure: Structure) -> None:
    """The plates, neighbours in different colours."""
    sides, colours = [], []
    for number, part in enumerate(structure.parts):
        corners = part.origin + part.body.corners @ part.frame
        sides += [corners[list(side)] for side in part.body.sides]
        colours += [(BLUE, ORANGE)[number % 2]] * len(part.body.sides)
    # In one collection: only within one are sides drawn from back to front.
    plates = Poly3DCollection(sides, facecolors=colours, edgecolors=DARK, lw=0.15, shade=True)
    space.add_collection3d(plates)
    points = structure.mesh.vertices
    middle, size = points.mean(axis=0), np.ptp(points, axis=0).max() / 2.2
    space.set(**{f"{k}lim": (m - size, m + size) for k, m in zip("xyz", middle, strict=True)})
    space.set_axis_off()


def draw_flat(flat: plt.Axes, pattern: FlatPattern, level: float) -> None:
    """Outline, bends and engraved lines of a pattern."""
    flat.fill(*(pattern.outline + [0.0, level]).T, facecolor="#d9e4f1", edgecolor=DARK, lw=0.6)
    for bend in pattern.bends:
        flat.plot(*(bend.points + [0.0, level]).T, color=RED, lw=0.4)
    for mark in pattern.marks:
        if not mark.text:
            flat.plot(*(mark.points + [0.0, level]).T, color=DARK, lw=0.2)


def main() -> None:
    """Print the reports and draw."""
    figure = plt.figure(figsize=(13, 7.5), dpi=90)
    for column, example in enumerate(EXAMPLES):
        structure = make(*example)
        print(*example, len(structure.parts), structure.results[example[2]].report)
        draw_in_place(figure.add_subplot(2, 2, column + 1, projection="3d"), structure)
        flat, level = figure.add_subplot(2, 2, column + 3), 0.0
        for part in structure.parts[::3]:
            draw_flat(flat, part.pattern, level)
            level += 1.1 * part.pattern.size[1]
        flat.set_aspect("equal")
        flat.set_axis_off()
    figure.subplots_adjust(0, 0.02, 1, 1, 0, 0)
    figure.savefig(PICTURE)


if __name__ == "__main__":
    main()
