"""Measures the solver and the fabrication files: time a step, a file, and memory.

Run with the project's Python:
    python scripts/bench.py [solver] [fabrication] [--write] [--quick] [--backend NAME]

Each case runs in a process of its own, so that peak memory is its own. ``--write`` puts the tables
into docs/benchmarks.md.
"""

from __future__ import annotations

import argparse
import json
import platform
import resource
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from freecad_ortho import api  # noqa: E402
from freecad_ortho.fabrication import Beams, Lamellas, Panels, build, stage_seconds  # noqa: E402
from freecad_ortho.fabrication.systems.system import System  # noqa: E402
from solver import QuadMesh, optimise  # noqa: E402
from solver.linear.backends import BACKENDS  # noqa: E402

SHARED = ROOT.parent / "shared" / "meshes"
MESHES = ("demo roof", "heart", "conical1", "botanic-garden-bubble-0", "complete01")
GRIDS = {"wavy grid 1k": 32, "wavy grid 1.2k": 34, "wavy grid 10k": 100, "wavy grid 100k": 317}
STRUCTURES = ("demo roof", "conical1", "wavy grid 1.2k")
LATTICES = ("knet1", "helical-minimal")
LAMELLAS = {
    "stock of 6 m": {"stock": 6000.0},
    "stock of 6 m, two layers": {"stock": 6000.0, "layers": 2},
    "lying, two layers": {"position": "lying", "layers": 2},
    "smooth": {"smooth": True},
    "stock of 2.5 m": {"stock": 2500.0},
}
PARTS = ("solver", "fabrication")


def wavy_grid(side: int) -> QuadMesh:
    """A wavy vase sampled by ``side`` x ``side`` vertices, every vertex pushed off its place.

    The pushes are waves of 0.3 edges, about 15 edges long: as hard everywhere, whatever the size.
    """
    i, j = np.meshgrid(np.arange(side, dtype=float), np.arange(side, dtype=float), indexing="ij")
    turn = 1.6 * (i + 0.3 * np.sin(0.41 * j + 0.2 * i)) / side
    height = j + 0.3 * np.sin(0.37 * i - 0.25 * j)
    radius = side * (0.6 + 0.06 * np.sin(4.0 * height / side)) + 0.3 * np.sin(0.4 * i + 0.3 * j)
    x, y, z = radius * np.cos(turn), radius * np.sin(turn), height
    corner = np.arange(side * side).reshape(side, side)
    quads = [corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]]
    return QuadMesh(
        np.stack([x, y, z], axis=2).reshape(-1, 3), np.stack(quads, axis=2).reshape(-1, 4)
    )


def mesh_of(case: str) -> QuadMesh | None:
    """Return the mesh of a case, None where its file is missing."""
    if case in GRIDS:
        return wavy_grid(GRIDS[case])
    roof = ROOT / "examples" / "data" / "demo_roof.obj"
    path = roof if case == "demo roof" else SHARED / f"{case}.obj"
    return api.read_mesh(path).mesh if path.is_file() else None


def measure(case: str, net: str, backend: str, repeats: int) -> dict[str, object] | None:
    """Optimise one mesh ``repeats`` times; the fastest run counts, since noise only adds."""
    mesh = mesh_of(case)
    if mesh is None:
        return None
    runs = [optimise(mesh, net, backend=backend).report for _ in range(repeats)]
    report = min(runs, key=lambda run: run.seconds_per_iteration)
    worst = max(spread.max for spread in report.residuals.values())
    return {
        "mesh": case,
        "vertices": report.vertices,
        "faces": report.faces,
        "variables": report.variables,
        "constraints": report.constraints,
        "step_ms": 1e3 * report.seconds_per_iteration,
        "solve_ms": 1e3 * report.solve_seconds_per_iteration,
        "setup_s": report.seconds_setup,
        "steps": report.iterations,
        "seconds": report.seconds,
        "worst": worst,
        "status": report.status,
        "memory_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
    }


HEAD = (
    "| mesh | V | F | #var | #cons | ms per step | of it factor + solve | ratio | set-up s | steps "
    "| seconds | worst residual | peak MB |\n"
    "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
)


def row(result: dict[str, object]) -> str:
    """One line of the table."""
    ratio = result["step_ms"] / result["solve_ms"]  # type: ignore[operator]
    return (
        "| {mesh} | {vertices:,} | {faces:,} | {variables:,} | {constraints:,} | {step_ms:.1f} "
        "| {solve_ms:.1f} | {ratio:.2f} | {setup_s:.2f} | {steps} | {seconds:.2f} | {worst:.0e} "
        "| {memory_mb:.0f} |"
    ).format(**result, ratio=ratio)


def table(backend: str, cases: list[str]) -> str:
    """Measure all cases in processes of their own and return the table."""
    lines = [f"Sparse solver `{backend}`, net `principal`:", "", HEAD]
    for case in cases:
        result = answer("--case", case, "--backend", backend)
        if result is None:
            continue
        lines.append(row(result))
        print(lines[-1], file=sys.stderr)
    return "\n".join(lines)


def measure_fabrication(case: str) -> dict[str, object] | None:
    """Build and write structures on an optimised mesh; the fastest of three runs counts."""
    mesh = mesh_of(case)
    if mesh is None:
        return None
    mesh = optimise(mesh, "asymptotic" if case in LATTICES else "principal").mesh
    mesh = mesh.scaled(1000 / mesh.mean_edge)
    both = Beams(200, 12), Panels(12, 10)
    structures: dict[str, Sequence[System]] = {"beams": both[:1], "beams+panels": both}
    if case in LATTICES:
        structures = {f"lamellas, {words}": [Lamellas(**v)] for words, v in LAMELLAS.items()}
    runs = []
    for system, chosen in structures.items():
        times = [stage_seconds(mesh, chosen) for _ in range(1 if case in LATTICES else 3)]
        parts = len(build(mesh, chosen).parts)
        runs.append({"system": system, "parts": parts, **min(times, key=lambda run: run["total"])})
        print(system, runs[-1], file=sys.stderr)
    return {"mesh": case, "runs": runs}


FABRICATION_HEAD = (
    "| mesh | system | parts | build s | checks s | solids s | STEP s | DXF s | tables s "
    "| total s | ratio |\n"
    "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
)


def fabrication_rows(result: dict[str, Any]) -> list[str]:
    """Lines of the table for one mesh."""
    line = (
        "| {mesh} | {system} | {parts:,} | {build:.2f} | {checks:.2f} | {solids:.2f} | {step:.2f} "
        "| {dxf:.2f} | {tables:.2f} | {total:.2f} | {ratio:.2f} |"
    )
    return [
        line.format(mesh=result["mesh"], ratio=run["total"] / run["step"], **run)
        for run in result["runs"]
    ]


def fabrication_table() -> str:
    """Measure all structures in processes of their own and return the table."""
    lines = [FABRICATION_HEAD]
    for case in (*STRUCTURES, *LATTICES):
        for text in fabrication_rows(result) if (result := answer("--fabricate", case)) else []:
            lines.append(text)
            print(text, file=sys.stderr)
    return "\n".join(lines)


def answer(*arguments: str) -> dict[str, Any] | None:
    """Run one case in a process of its own; None where its mesh is missing."""
    command = [sys.executable, __file__, *arguments]
    result = json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)
    if result is None:
        print(f"{arguments[1]}: its file is missing, left out", file=sys.stderr)
    return result


def main() -> None:
    """Print the tables; with --write put them into the document."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts", nargs="*", metavar="PART", help="solver, fabrication; both")
    parser.add_argument("--write", action="store_true", help="update docs/benchmarks.md")
    parser.add_argument("--quick", action="store_true", help="leave out the 100k grid")
    parser.add_argument("--backend", choices=BACKENDS, help="only this sparse solver")
    parser.add_argument("--net", default="principal", help=argparse.SUPPRESS)
    parser.add_argument("--case", help=argparse.SUPPRESS)
    parser.add_argument("--fabricate", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if unknown := set(options.parts) - set(PARTS):
        parser.error(f"expected {' or '.join(PARTS)}, got {', '.join(sorted(unknown))}")
    if options.case:
        repeats = 1 if options.case == "wavy grid 100k" else 5
        print(json.dumps(measure(options.case, options.net, options.backend, repeats)))
        return
    if options.fabricate:
        print(json.dumps(measure_fabrication(options.fabricate)))
        return
    for part in options.parts or PARTS:
        text = solver_tables(options) if part == "solver" else fabrication_table()
        print(text)
        if options.write:
            write(ROOT / "docs" / "benchmarks.md", part, text)


def solver_tables(options: argparse.Namespace) -> str:
    """One table a sparse solver."""
    grids = [name for name in GRIDS if name not in STRUCTURES]
    cases = [*MESHES, *(name for name in grids if not options.quick or "100k" not in name)]
    backends = [options.backend] if options.backend else list(BACKENDS)
    text = "\n\n".join(table(backend, cases) for backend in backends)
    return f"Python {platform.python_version()}, numpy {np.__version__}.\n\n{text}"


def write(path: Path, part: str, text: str) -> None:
    """Replace what stands between the part's marks in the document."""
    begin, end = f"<!-- {part} table: begin -->", f"<!-- {part} table: end -->"
    document = path.read_text(encoding="utf-8")
    head, rest = document.split(begin)
    tail = rest.split(end)[1]
    path.write_text(f"{head}{begin}\n{text}\n{end}{tail}", encoding="utf-8")


if __name__ == "__main__":
    main()
