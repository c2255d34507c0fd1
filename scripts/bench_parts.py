"""Measures structures with bolted nodes and glass in frames: time by stage, memory, sizes of STEP.

Run with the project's Python:  python scripts/bench_parts.py [--write] [CASE ...]

Each case runs in a process of its own, so that peak memory is its own. ``--write`` puts the table
into docs/benchmarks.md.
"""

from __future__ import annotations

import json
import resource
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from bench import write  # noqa: E402

from freecad_ortho import api  # noqa: E402
from freecad_ortho.fabrication.dxf import write_dxf  # noqa: E402
from freecad_ortho.fabrication.equal import copies  # noqa: E402
from freecad_ortho.fabrication.files import write_lists  # noqa: E402
from freecad_ortho.fabrication.production import produce  # noqa: E402
from freecad_ortho.fabrication.step import write_step  # noqa: E402
from freecad_ortho.fabrication.structure import OK, Structure  # noqa: E402
from solver import QuadMesh  # noqa: E402

DOCUMENT = ROOT / "docs" / "benchmarks.md"
GLAZED = {
    "node": "bolted",
    "section": "tube:160x80x5",
    "material": "steel,panels=glass:6/16/44.2",
    "frame": "plate",
    "panel_edge": "bevel",
}
CASES = ("demo roof", "vault of 1,053 faces")
HEAD = (
    "| net | parts | build s | checks s | solids s | STEP s | DXF s | tables s | total s | ratio "
    "| peak GB | STEP MB | shared: products | s | MB | clashes | not ok |\n"
    f"|{' --- |'}{' ---: |' * 16}"
)


def main() -> None:
    """Print the table; with --write put it into the document."""
    if sys.argv[1:2] == ["--one"]:
        print(json.dumps(measured(sys.argv[2])))
        return
    named = [name for name in sys.argv[1:] if name != "--write"]
    lines = [HEAD]
    for case in named or CASES:
        command = [sys.executable, __file__, "--one", case]
        found = json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)
        lines.append(row(found))
        print(lines[-1], file=sys.stderr)
    text = "\n".join(lines)
    print(text)
    if "--write" in sys.argv:
        write(DOCUMENT, "parts", text)


def row(found: dict[str, Any]) -> str:
    """One line of the table."""
    times = ("build", "checks", "solids", "step", "dxf", "tables", "total")
    seconds = " | ".join(f"{found[name]:.1f}" for name in times)
    ratio = found["total"] / found["step"]
    return (
        f"| {found['case']} | {found['parts']:,} | {seconds} | {ratio:.2f} "
        f"| {found['memory']:.1f} | {found['size']:.0f} | {found['products']:,} "
        f"| {found['shared']:.1f} | {found['shared_size']:.0f} "
        f"| {found['clashes']} | {found['not_ok']} |"
    )


def measured(case: str) -> dict[str, Any]:
    """Build and write a structure once; seconds are those of the processor."""
    import cadquery  # noqa: F401  its import, a second or two, is nobody's stage
    import ezdxf  # noqa: F401

    net, found = net_of(case), {"case": case}

    def timed(name: str, work: Callable[[], Any]) -> Any:
        start = time.process_time()
        result = work()
        found[name] = time.process_time() - start
        return result

    made: Structure = timed("build", lambda: api.fabricate(net, "beams+nodes+panels", **GLAZED))
    production = timed("checks", lambda: produce(made))
    timed("solids", made.solids)
    with TemporaryDirectory() as name:
        folder = Path(name)
        timed("step", lambda: write_step(folder / "a.step", made.parts))
        timed("dxf", lambda: write_dxf(folder / "a.dxf", production.named_patterns))
        timed("tables", lambda: write_lists(folder, production))
        stages = ("build", "checks", "solids", "step", "dxf", "tables")
        found["total"] = sum(found[stage] for stage in stages)
        found["size"] = (folder / "a.step").stat().st_size / 1e6
        found["memory"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
        timed("shared", lambda: write_step(folder / "b.step", made.parts, None, 1e-3))
        found["shared_size"] = (folder / "b.step").stat().st_size / 1e6
    found["products"] = len({copy.first for copy in copies(made.parts, 1e-3)})
    found["clashes"] = len(production.clashes.clashes)
    return found | {
        "parts": len(made.parts),
        "not_ok": sum(verdict != OK for verdict in made.verdicts),
    }


def net_of(case: str) -> QuadMesh:
    """A principal net with edges of about 1.2 m, mm."""
    if case == "demo roof":
        start = api.read_mesh(ROOT / "examples" / "data" / "demo_roof.obj").mesh
        return api.optimise(start.scaled(1200.0 / start.mean_edge), net="principal").mesh
    # Meridians and parallels about a level line: flat orthogonal faces by formula.
    rows, columns = 28, 40
    along, angle = np.meshgrid(
        1.2 * np.arange(rows), np.radians(np.linspace(40.0, 140.0, columns)), indexing="ij"
    )
    radius = 27.0 + 1.5 * np.sin(0.25 * along)
    points = np.stack([-radius * np.cos(angle), along, radius * np.sin(angle)], axis=-1)
    number = np.arange(rows * columns).reshape(rows, columns)
    corners = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    return QuadMesh(1000 * points.reshape(-1, 3), np.stack(corners, axis=-1).reshape(-1, 4))


if __name__ == "__main__":
    main()
