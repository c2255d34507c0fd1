"""Measures a step of every net, dragging, and growth with the number of vertices.

Run with the project's Python:
    python scripts/bench_nets.py [--write] [--backend NAME]

``--write`` puts the tables into docs/benchmarks.md.
"""

from __future__ import annotations

import argparse
import math
import time

import numpy as np
from bench import ROOT, wavy_grid, write

from solver import NetOptions, QuadMesh, Session, optimise, start_optimisation
from solver.linear import BACKENDS
from solver.nets import RECIPES

SIDE = 39  # 1,521 vertices
STEPS = 12
DRAG_SIDES = (32, 40, 48)  # 1,024, 1,600 and 2,304 vertices
GROWTH_SIDES = (32, 50, 71, 100, 141)
# The five kinds of nets of the paper's table 2, and how they are asked for here.
PAPER_ROWS = ("principal", "isometric", "asymptotic", "cmc", "stress")


def run_steps(mesh: QuadMesh, net: str, backend: str) -> dict[str, float]:
    """Medians over the first steps of an optimisation of ``mesh``, which need not converge."""
    fix = "boundary" if net == "stress" else "none"
    bent = mesh.vertices * [1.0, 1.0, 1.02]
    options = NetOptions(reference=bent) if net == "isometric" else NetOptions()
    run = start_optimisation(mesh, net, fix=fix, options=options, backend=backend, tolerance=1e-30)
    records = [run.step() for _ in range(STEPS)]
    size = run.problem.size
    return {
        "variables": size.auxiliary,
        "constraints": size.equations,
        "step_ms": 1e3 * float(np.median([record.seconds for record in records])),
        "solve_ms": 1e3 * float(np.median([record.solve_seconds for record in records])),
        "setup_ms": 1e3 * run.seconds_setup,
    }


def net_table(backend: str) -> str:
    """Time of a step for every net."""
    mesh = wavy_grid(SIDE)
    lines = [
        f"Every net on {len(mesh.vertices):,} vertices and {len(mesh.faces):,} faces, `{backend}`:",
        "",
        "| net | #var | #cons | ms per step | of it factor + solve | ratio | steps a second "
        "| set-up in steps |",
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    for net in RECIPES:
        one = run_steps(mesh, net, backend)
        lines.append(
            f"| {net} | {one['variables']:,} | {one['constraints']:,} | {one['step_ms']:.1f} "
            f"| {one['solve_ms']:.1f} | {one['step_ms'] / one['solve_ms']:.2f} "
            f"| {1e3 / one['step_ms']:.0f} | {one['setup_ms'] / one['step_ms']:.1f} |"
        )
    return "\n".join(lines)


def drag_table(backend: str) -> str:
    """Frames a second while a vertex is dragged, one step a frame."""
    lines = [
        f"Dragging a vertex of a principal mesh, one step a frame, `{backend}`:",
        "",
        "| V | ms a frame | frames a second |",
        "| ---: | ---: | ---: |",
    ]
    for side in DRAG_SIDES:
        mesh = optimise(wavy_grid(side), backend=backend).mesh
        middle = side * side // 2 + side // 2
        session = Session(mesh, [middle], backend=backend)
        frames = []
        for k in range(20):
            lift = mesh.vertices[middle] + mesh.vertex_normals[middle] * 0.05 * k * mesh.mean_edge
            begin = time.perf_counter()
            session.drag({middle: lift})
            session.vertices.sum()
            frames.append(time.perf_counter() - begin)
        frame = float(np.median(frames))
        lines.append(f"| {side * side:,} | {1e3 * frame:.1f} | {1 / frame:.0f} |")
    return "\n".join(lines)


def growth_table(backend: str) -> str:
    """Time of a step as the mesh grows, and the exponent between neighbouring rows."""
    lines = [
        f"Growth, net `principal`, `{backend}`:",
        "",
        "| V | F | ms per step | grows like V to the |",
        "| ---: | ---: | ---: | ---: |",
    ]
    before: tuple[int, float] | None = None
    for side in GROWTH_SIDES:
        mesh = wavy_grid(side)
        step = run_steps(mesh, "principal", backend)["step_ms"]
        power = ""
        if before is not None:
            power = f"{math.log(step / before[1]) / math.log(side * side / before[0]):.2f}"
        lines.append(f"| {side * side:,} | {len(mesh.faces):,} | {step:.1f} | {power} |")
        before = (side * side, step)
    return "\n".join(lines)


def paper_table(backend: str) -> str:
    """The paper's table 2 with the same five kinds of nets."""
    lines = [
        f"In the form of the paper's table 2, `{backend}`:",
        "",
        "| net | V | F | #var | #cons | s per step | the paper's s per step (V) |",
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    paper = {
        "principal": (1792, 0.29),
        "isometric": (720, 0.34),
        "asymptotic": (2079, 1.26),
        "cmc": (2301, 1.74),
        "stress": (1029, 0.36),
    }
    for net in PAPER_ROWS:
        vertices, seconds = paper[net]
        mesh = wavy_grid(round(math.sqrt(vertices)))
        one = run_steps(mesh, net, backend)
        lines.append(
            f"| {net} | {len(mesh.vertices):,} | {len(mesh.faces):,} | {one['variables']:,} "
            f"| {one['constraints']:,} | {one['step_ms'] / 1e3:.3f} | {seconds} ({vertices:,}) |"
        )
    return "\n".join(lines)


def main() -> None:
    """Print the tables; with --write put them into the document."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="update docs/benchmarks.md")
    parser.add_argument("--backend", choices=BACKENDS, help="only this sparse solver")
    options = parser.parse_args()
    parts = []
    for backend in [options.backend] if options.backend else list(BACKENDS):
        for table in (net_table, drag_table, growth_table, paper_table):
            parts.append(table(backend))
            print(parts[-1], end="\n\n", flush=True)
    if options.write:
        write(ROOT / "docs" / "benchmarks.md", "nets", "\n\n".join(parts))


if __name__ == "__main__":
    main()
