"""Measures the writers of files for other programs: seconds, size, memory of each.

Run with the project's Python:  python scripts/bench_exchange.py [--write] [CASE ...]

Beams, nodes and panels of the demo roof, and of a vault with more than 10,000 parts. Each writer
runs in a process of its own; its memory is what it needs beyond the structure and its solids,
which are there already. Seconds are those of the processor. ``--write`` puts the table into
docs/exchange.md.
"""

from __future__ import annotations

import multiprocessing
import os
import resource
import sys
import time
from multiprocessing.connection import Connection
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from bench import write  # noqa: E402

from freecad_ortho import api  # noqa: E402
from freecad_ortho.fabrication.exchange import WRITERS  # noqa: E402
from freecad_ortho.fabrication.formats import FORMATS  # noqa: E402
from freecad_ortho.fabrication.production import Production, produce  # noqa: E402
from freecad_ortho.fabrication.workshop import Workshop  # noqa: E402
from solver import QuadMesh  # noqa: E402

DOCUMENT = ROOT / "docs" / "exchange.md"
CASES = ("demo roof", "vault")
STEP_TOLERANCE = 0.01


def main() -> None:
    """Print the table; with --write put it into the document."""
    cases = [name for name in sys.argv[1:] if name != "--write"] or CASES
    found = [measured(case) for case in cases]
    lines = [
        "| `--write` |" + "".join(f" {count:,} parts: s | MB | memory, MB |" for count, _ in found)
    ]
    lines.append("| --- |" + " ---: |" * (3 * len(found)))
    for name in FORMATS:
        cells = [
            f" {rows[name][0]:.1f} | {rows[name][1]:.1f} | {rows[name][2]:.0f} |"
            for _, rows in found
        ]
        lines.append(f"| `{name}` |" + "".join(cells))
    text = "\n".join(lines)
    print(text)
    if "--write" in sys.argv:
        write(DOCUMENT, "size", text)


def measured(case: str) -> tuple[int, dict[str, tuple[float, float, float]]]:
    """Number of parts; seconds, MB of files and MB of memory by the names of writers."""
    production = produced(case)
    rows = {}
    for name in FORMATS:
        ours, theirs = multiprocessing.get_context("fork").Pipe(duplex=False)
        child = multiprocessing.get_context("fork").Process(
            target=one, args=(name, production, theirs)
        )
        child.start()
        theirs.close()
        rows[name] = ours.recv()
        child.join()
        print(f"{case}: {name} {rows[name]}", file=sys.stderr)
    return len(production.structure.parts), rows


def one(name: str, production: Production, answer: Connection) -> None:
    """Write one format, and say what it took."""
    with TemporaryDirectory() as folder:
        target = Path(folder) / FORMATS[name].place
        before, start = resident(), time.process_time()
        WRITERS[name](target, production, "bench", lambda done: None)
        seconds = time.process_time() - start
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
        files = [path for path in Path(folder).rglob("*") if path.is_file()]
        size = sum(path.stat().st_size for path in files)
        answer.send((seconds, size / 1e6, (peak - before) / 1e6))


def resident() -> int:
    """Bytes of memory in use."""
    pages = Path("/proc/self/statm").read_text().split()[1]
    return int(pages) * os.sysconf("SC_PAGE_SIZE")


def produced(case: str) -> Production:
    """A structure, ready to be written."""
    loaded = api.read_mesh(ROOT / "examples" / "data" / "demo_roof.obj")
    mesh, unit = (vault(50, 52), "m") if case == "vault" else (loaded.mesh, loaded.unit)
    structure = api.fabricate(
        mesh,
        "nodes+beams+panels",
        section="GL24h:80x200",
        ends="hub",
        hub_diameter=260.0,
        material="nodes=steel,panels=toughened-glass",
        unit=unit,
    )
    structure.solids()
    return produce(structure, Workshop(sheet=(3000.0, 1500.0), step_tolerance=STEP_TOLERANCE))


def vault(rows: int, columns: int) -> QuadMesh:
    """Faces of a barrel that swells along its way: nearly planar, of many kinds; metres."""
    angle, along = np.meshgrid(
        np.linspace(0.4, np.pi - 0.4, rows + 1), np.linspace(0, 60, columns + 1), indexing="ij"
    )
    radius = 30 + 2 * np.sin(along / 12)
    points = np.stack([radius * np.cos(angle), along, radius * np.sin(angle)], axis=-1)
    number = np.arange((rows + 1) * (columns + 1)).reshape(rows + 1, columns + 1)
    corners = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    return QuadMesh(points.reshape(-1, 3), np.stack(corners, axis=-1).reshape(-1, 4))


if __name__ == "__main__":
    main()
