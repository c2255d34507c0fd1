"""Flat panels of three, four, five and six corners: a honeycomb dome, and a dome cut off round.

Prints, of each, how many faces have how many corners, the steps to flat faces, what they miss in
mm, how far the dome is off the one that was drawn, and the largest twist of the beams between them.
"""

from __future__ import annotations

import numpy as np

from solver import QuadMesh, optimise
from solver.mesh.mixed import MixedConnectivity, words_of_sizes
from solver.mesh.quadmesh import FloatArray
from solver.offset.axes import torsion_free_axes

Polygons = list[list[int]]


def dome(points: FloatArray) -> FloatArray:
    """(N, 3) mm: points (N, 2) of the plan raised onto a dome of 6 m."""
    x, y = points.T
    return np.column_stack([points, 6000 * np.cos(x / 16000) * np.cos(y / 14000)])


def honeycomb(rows: int = 8, edge: float = 1200.0) -> QuadMesh:
    """A dome of rows of as many hexagons, edges about this long, mm."""
    corners = np.pi / 6 + np.arange(6) * np.pi / 3
    corner = edge * np.column_stack([np.cos(corners), np.sin(corners)])
    centres = [
        edge * np.array([np.sqrt(3) * (column - rows / 2 + row % 2 / 2), 1.5 * (row - rows / 2)])
        for row in range(rows)
        for column in range(rows)
    ]
    return joined([centre + corner for centre in centres])


def cut_round(half: int = 7, edge: float = 1500.0) -> QuadMesh:
    """A dome of quads cut off by a circle: triangles, quads and pentagons along the border.

    Corners beside the circle are moved onto it, so that no edge is much shorter than the others.
    """
    radius = (half - 0.2) * edge
    lines = edge * np.arange(-half, half + 1.0)
    grid = np.stack(np.meshgrid(lines, lines, indexing="ij"), axis=2)
    away = np.linalg.norm(grid, axis=2, keepdims=True)
    grid = np.where(
        np.abs(away - radius) < 0.15 * edge, grid * radius / np.maximum(away, edge), grid
    )
    outlines = []
    for i in range(2 * half):
        for j in range(2 * half):
            found = _within(grid[[i, i + 1, i + 1, i], [j, j, j + 1, j + 1]], radius)
            if len(found) > 2 and np.ptp(found, axis=0).min() > 0.2 * edge:
                outlines.append(found)
    return joined(outlines)


def joined(outlines: list[FloatArray]) -> QuadMesh:
    """A mesh on the dome of outlines (n, 2) in plan, mm, points at one place made one."""
    numbers: dict[tuple[float, float], int] = {}
    polygons: Polygons = [
        [numbers.setdefault(tuple(np.round(point, 3)), len(numbers)) for point in outline]
        for outline in outlines
    ]
    return QuadMesh(dome(np.array(list(numbers))), MixedConnectivity(polygons, len(numbers)))


def _within(outline: FloatArray, radius: float) -> FloatArray:
    """(n, 2) what is left of an outline within a circle, straight where the circle cuts it."""
    points = []
    for here, there in zip(outline, np.roll(outline, -1, axis=0), strict=True):
        ends = np.linalg.norm([here, there], axis=1) - radius
        if ends[0] < 1e-6:
            points.append(here)
        if ends.min() < -1e-6 and ends.max() > 1e-6:
            along = there - here
            roots = np.roots([along @ along, 2 * here @ along, here @ here - radius**2]).real
            points.append(here + roots[(roots > 0) & (roots < 1)][0] * along)
    return np.array(points)


def main() -> None:
    """Print what this file is about."""
    for name, start in (("honeycomb", honeycomb()), ("cut off round", cut_round())):
        outcome = optimise(start, "planar")
        report, mesh = outcome.report, outcome.mesh
        off = report.form.off_surface
        print(
            f"{name}: {words_of_sizes(start.connectivity.face_sizes)}; {report.status} after "
            f"{report.iterations} steps, gaps {report.form.gap:.0e} mm, off by {off.max:.0f} mm "
            f"({off.percent:.2f} %); twist {torsion_free_axes(mesh).twist.max():.0e}"
        )


if __name__ == "__main__":
    main()
