"""Measures the solver: time a step, share of the factorisation, steps and memory to 1e-10.

Run with the project's Python:  python scripts/bench.py [--write] [--quick] [--backend NAME]

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
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from freecad_ortho import api  # noqa: E402
from solver import QuadMesh, optimise  # noqa: E402
from solver.linear import BACKENDS  # noqa: E402

SHARED = ROOT.parent / "shared" / "meshes"
MESHES = ("demo roof", "heart", "conical1", "botanic-garden-bubble-0", "complete01")
GRIDS = {"wavy grid 1k": 32, "wavy grid 10k": 100, "wavy grid 100k": 317}
BEGIN, END = "<!-- solver table: begin -->", "<!-- solver table: end -->"


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
    return QuadMesh.from_arrays(
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
        command = [sys.executable, __file__, "--case", case, "--backend", backend]
        answer = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        result = json.loads(answer)
        if result is None:
            print(f"{case}: its file is missing, left out", file=sys.stderr)
            continue
        lines.append(row(result))
        print(lines[-1], file=sys.stderr)
    return "\n".join(lines)


def main() -> None:
    """Print the tables; with --write put them into the document."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="update docs/benchmarks.md")
    parser.add_argument("--quick", action="store_true", help="leave out the 100k grid")
    parser.add_argument("--backend", choices=BACKENDS, help="only this sparse solver")
    parser.add_argument("--net", default="principal", help=argparse.SUPPRESS)
    parser.add_argument("--case", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.case:
        repeats = 1 if options.case == "wavy grid 100k" else 5
        print(json.dumps(measure(options.case, options.net, options.backend, repeats)))
        return
    cases = [*MESHES, *(name for name in GRIDS if not options.quick or "100k" not in name)]
    backends = [options.backend] if options.backend else list(BACKENDS)
    text = "\n\n".join(table(backend, cases) for backend in backends)
    text = f"Python {platform.python_version()}, numpy {np.__version__}.\n\n{text}"
    print(text)
    if options.write:
        write(ROOT / "docs" / "benchmarks.md", text)


def write(path: Path, text: str) -> None:
    """Replace what stands between the marks of the document."""
    document = path.read_text(encoding="utf-8")
    head, rest = document.split(BEGIN)
    tail = rest.split(END)[1]
    path.write_text(f"{head}{BEGIN}\n{text}\n{END}{tail}", encoding="utf-8")


if __name__ == "__main__":
    main()
