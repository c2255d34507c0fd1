"""Measures a step of every net, dragging, and growth with the number of vertices.

Run with the project's Python:
    python scripts/bench_nets.py [--write] [--backend NAME]

``--write`` puts the tables into docs/benchmarks.md.
"""

from __future__ import annotations

import argparse
import json
import math
import resource
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
from bench import ROOT, wavy_grid, write

from solver import NetOptions, QuadMesh, Session, optimise, start_optimisation
from solver.linear.backends import BACKENDS
from solver.nets import NETS

SIDE = 39  # 1,521 vertices
STEPS, REPEATS = 12, 3
DRAG_SIDES = (32, 40, 48)  # 1,024, 1,600 and 2,304 vertices
GROWTH_SIDES = (32, 63, 100, 173, 317)  # about 1, 4, 10, 30 and 100 thousand vertices
# From so many vertices on, fewer steps are taken and no second time.
LARGE = 20_000
# The five kinds of nets of the paper's table 2, and how they are asked for here.
PAPER_ROWS = ("principal", "isometric", "asymptotic", "cmc", "stress")


def run_steps(
    mesh: QuadMesh, net: str, backend: str, steps: int = STEPS, repeats: int = REPEATS
) -> dict[str, float]:
    """Time of the first steps of an optimisation of ``mesh``, which need not converge.

    The same steps are taken ``repeats`` times; the fastest of each counts, since noise only adds,
    and of those the median. A step is all that passes between two of them, a solve the part in
    factorisations and solves.
    """
    fix = "boundary" if net == "stress" else "none"
    bent = mesh.vertices * [1.0, 1.0, 1.02]
    options = NetOptions(reference=bent) if net == "isometric" else NetOptions()
    step, setup = np.full((2, steps), np.inf), np.inf
    for _ in range(repeats):
        run = start_optimisation(
            mesh, net, fix=fix, options=options, backend=backend, tolerance=1e-30
        )
        for k in range(steps):
            begin = time.perf_counter()
            record = run.step()
            step[0, k] = min(step[0, k], time.perf_counter() - begin)
            step[1, k] = min(step[1, k], record.solve_seconds)
        setup = min(setup, run.seconds_setup)
    return {
        "variables": run.problem.variables,
        "constraints": run.problem.equations,
        "step_ms": 1e3 * float(np.median(step[0])),
        "solve_ms": 1e3 * float(np.median(step[1])),
        "setup_ms": 1e3 * setup,
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
    for net in NETS:
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
        frames = np.full((REPEATS, 20), np.inf)
        for times in frames:
            session = Session(mesh, [middle], backend=backend)
            for k in range(len(times)):
                way = 0.05 * k * mesh.mean_edge
                lift = mesh.vertices[middle] + way * mesh.vertex_normals[middle]
                begin = time.perf_counter()
                session.drag({middle: lift})
                session.vertices.sum()
                times[k] = time.perf_counter() - begin
        frame = float(np.median(frames.min(axis=0)))
        lines.append(f"| {side * side:,} | {1e3 * frame:.1f} | {1 / frame:.0f} |")
    return "\n".join(lines)


def growth_table(backend: str) -> str:
    """Time of a step and memory as the mesh grows, each size in a process of its own."""
    lines = [
        f"Growth, net `principal`, `{backend}`:",
        "",
        "| V | F | ms per step | of it factor + solve | grows like V to the | since the first row "
        "| set-up in steps | peak MB |",
        "| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    rows: list[tuple[int, float]] = []
    for side in GROWTH_SIDES:
        command = [sys.executable, __file__, "--growth", str(side), "--backend", backend]
        one = json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)
        rows.append((side * side, one["step_ms"]))
        powers = [_power(rows[-2], rows[-1]), _power(rows[0], rows[-1])] if rows[1:] else ["", ""]
        lines.append(
            f"| {side * side:,} | {(side - 1) ** 2:,} | {one['step_ms']:.1f} "
            f"| {one['solve_ms']:.1f} | {powers[0]} | {powers[1]} "
            f"| {one['setup_ms'] / one['step_ms']:.1f} | {one['memory_mb']:.0f} |"
        )
        print(lines[-1], file=sys.stderr, flush=True)
    return "\n".join(lines)


def _power(one: tuple[int, float], two: tuple[int, float]) -> str:
    return f"{math.log(two[1] / one[1]) / math.log(two[0] / one[0]):.2f}"


def measure_growth(side: int, backend: str) -> dict[str, float]:
    """One row of the growth table."""
    large = side * side > LARGE
    steps, repeats = (4, 1) if large else (STEPS, REPEATS)
    result = run_steps(wavy_grid(side), "principal", backend, steps, repeats)
    return {**result, "memory_mb": peak_memory() / 1024}


def peak_memory() -> int:
    """Largest memory of this process in kB; getrusage alone would count its parent's too."""
    status = Path("/proc/self/status")
    if not status.is_file():
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return int(status.read_text().split("VmHWM:")[1].split()[0])


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
    parser.add_argument("--growth", type=int, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.growth:
        print(json.dumps(measure_growth(options.growth, options.backend)))
        return
    parts = []
    for backend in [options.backend] if options.backend else list(BACKENDS):
        for table in (net_table, drag_table, growth_table, paper_table):
            parts.append(table(backend))
            print(parts[-1], end="\n\n", flush=True)
    if options.write:
        write(ROOT / "docs" / "benchmarks.md", "nets", "\n\n".join(parts))


if __name__ == "__main__":
    main()
