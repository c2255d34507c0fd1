"""Prints the tables of docs/nets.md on the net nearest to a surface, and on panels that have a gap.

Run with the project's Python:  python scripts/docs_nearest.py
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from solver import Constraints, NetOptions, QuadMesh, optimise, start_optimisation
from solver.analysis.form import off_surface
from solver.mesh.closest import TriangleSurface
from solver.mesh.grid import grid_faces

Points = tuple[np.ndarray, np.ndarray, np.ndarray]

# In metres, over the unit square; none of their coordinate lines is a line of curvature.
SURFACES: dict[str, Callable[[np.ndarray, np.ndarray], Points]] = {
    "twisted barrel vault": lambda u, v: (
        30 * u,
        18 * (v - 0.5) * (1 + 0.25 * u),
        5 * np.cos(np.pi * (v - 0.5)) * (1 + 0.4 * np.sin(2 * u)),
    ),
    "skew saddle": lambda u, v: (
        30 * u + 3 * v,
        20 * v - 4 * u,
        12 * (u - 0.5) ** 2 - 20 * (v - 0.5) ** 2 + 2 * (u - 0.5) * (v - 0.5),
    ),
    "wave": lambda u, v: (
        40 * u,
        20 * v,
        2 * np.sin(2 * np.pi * u) + 1.5 * np.cos(np.pi * v) + 1.2 * u * v,
    ),
    "rectangular dome": lambda u, v: (
        30 * (u - 0.5),
        20 * (v - 0.5),
        6 * np.cos(0.9 * np.pi * (u - 0.5)) * np.cos(0.9 * np.pi * (v - 0.5)),
    ),
    "hill": lambda u, v: (
        30 * u,
        30 * v,
        4 * np.exp(-9 * ((u - 0.45) ** 2 + (v - 0.55) ** 2)) + 0.8 * u,
    ),
    "canopy": lambda u, v: (
        30 * u,
        18 * v,
        4 + 3 * np.sin(np.pi * v) * (1 - 0.6 * u) + 2 * np.sin(1.5 * np.pi * u) * (v - 0.5),
    ),
}


def sampled(name: str, rows: int, columns: int) -> QuadMesh:
    """A surface as a mesh of so many vertices along its coordinate lines."""
    u, v = np.meshgrid(np.linspace(0, 1, rows), np.linspace(0, 1, columns), indexing="ij")
    points = np.stack(np.broadcast_arrays(*SURFACES[name](u, v)), axis=2)
    return QuadMesh(points.reshape(-1, 3), grid_faces(rows, columns))


def row(name: str) -> str:
    """Optimise one towards a principal net, and tell how far off it is before and after."""
    fine = TriangleSurface.from_quads(sampled(name, 121, 73))
    surface = fine.vertices, fine.triangles
    start = sampled(name, 31, 19)
    begin = time.process_time()
    run = start_optimisation(start, constraints=Constraints(close_to=surface))
    steps, after, last, before = [time.process_time() - begin], 0.0, set[int](), run.shape
    while not run.finished:
        begin = time.process_time()
        record = run.step()
        taken = time.process_time() - begin
        # Nothing fades along the nets; what leads to one begins at its full weight.
        if record.fade == 0.0 and run.history[-2].attempt != record.attempt:
            if not last:
                # The step before it prepared it: what that took beyond the others is its own.
                usual = float(np.median(steps[1:]))
                after, steps[-1] = steps[-1] - usual, usual
            last.add(record.attempt)
        if record.attempt in last:
            after += taken
        else:
            steps.append(taken)
            before = run.shape
    form, report = run.outcome().report.form, run.outcome().report
    far = 1000 * off_surface(before, fine).max()
    kept = report.edge_ratio / report.edge_ratio_start
    return (
        f"| {name} | {far:.0f} mm | {1000 * form.off_surface.max:.0f} mm | {form.area_ratio:.2f} | "
        f"{form.zigzag:.2f} | {kept:.2f} | {after / sum(steps):.1f} |"
    )


def trade(name: str, flatness: float | None, within: float | None) -> str:
    """Look for flat panels, in millimetres, and tell how far from the surface they are."""
    fine = TriangleSurface.from_quads(sampled(name, 121, 73))
    metres = [None if length is None else length / 1000 for length in (flatness, within)]
    outcome = optimise(
        sampled(name, 31, 19),
        "planar",
        options=NetOptions(flatness=metres[0]),
        within=metres[1],
        constraints=Constraints(close_to=(fine.vertices, fine.triangles)),
    )
    form = outcome.report.form
    asked = " | ".join("" if length is None else f"{length:g} mm" for length in (flatness, within))
    return (
        f"| {name} | {asked} | {1000 * form.gap:.1f} mm | {1000 * form.off_surface.max:.0f} mm | "
        f"{form.area_ratio:.2f} |"
    )


if __name__ == "__main__":
    print("| surface | before the last phase | after it | area | zigzag | edges | time of it |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for surface in SURFACES:
        print(row(surface), flush=True)
    print("\n| surface | `--flatness` | `--within` | largest gap | off the surface | area |")
    print("| --- | --- | --- | --- | --- | --- |")
    for surface in ("twisted barrel vault", "canopy", "rectangular dome"):
        for asked in ((None, None), (2, None), (10, None), (2, 20), (10, 60)):
            print(trade(surface, *asked), flush=True)
