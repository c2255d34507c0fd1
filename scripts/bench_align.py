"""Measure nets along curvature: how exact, how near to their surface, how fast.

usage: python scripts/bench_align.py            print the tables
       python scripts/bench_align.py --write    write them into docs/benchmarks.md
       python scripts/bench_align.py --random 5 so many random surfaces instead of 40

The nets on six surfaces by formula are those of ``scripts/docs_align.py``.
"""

from __future__ import annotations

import argparse
import resource
import sys
import tempfile
import time
from pathlib import Path

from bench import write
from docs_align import random_row, run, sheet
from docs_align import table as six_surfaces

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from solver import read_mesh, write_mesh  # noqa: E402
from solver.analysis import measures  # noqa: E402
from tests.design_surfaces import EXACT, net_on_patch  # noqa: E402

# Vertices of the dome, and the edge length: about 600 quads, and about 5,000.
SIZES = {(121, 73): "1.1", (361, 209): "0.38"}
RANDOM = 40
# Percent of the diagonal that a principal net on a random surface may be off.
NEAR = 0.5


def lines_of(*rows: tuple[object, ...]) -> str:
    """A table; its first row are the heads."""
    heads, *others = ("| " + " | ".join(str(cell) for cell in row) + " |" for row in rows)
    return "\n".join([heads, "| --- |" + " ---: |" * (len(rows[0]) - 1), *others])


def exact_row(name: str) -> tuple[object, ...]:
    """What becomes of one surface that carries an exact net."""
    made, outcome, found = net_on_patch(name)
    report = outcome.report
    worst = max(spread.max for spread in report.residuals.values())
    edges = measures.edge_ratio(outcome.mesh) / measures.edge_ratio(made.mesh)
    return (
        name,
        EXACT[name][3],
        len(made.mesh.faces),
        f"{worst:.0e}",
        f"{found.off_surface.percent:.3f} %",
        f"{found.area_ratio:.3f}",
        f"{found.zigzag:.2f}",
        f"{edges:.2f}",
    )


def exact_table() -> str:
    """All surfaces that carry exact nets."""
    heads = ("surface", "net", "faces", "worst residual", "off", "area", "zigzag")
    return lines_of((*heads, "shortest edge kept"), *(exact_row(name) for name in EXACT))


def speed_table() -> str:
    """The command ``align`` on a dome of more and more triangles, reading and writing included."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        start, net = (str(Path(folder) / name) for name in ("surface.obj", "net.obj"))
        for counts, edge in SIZES.items():
            surface = sheet("dome", counts)
            write_mesh(start, surface, "m")
            begun = time.perf_counter()
            run("align", start, "--edge", edge, "-o", net)
            spent = time.perf_counter() - begun
            once = Path(net).read_bytes()
            run("align", start, "--edge", edge, "-o", net)
            memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
            rows.append(
                (
                    f"{2 * len(surface.faces):,}",
                    f"{len(read_mesh(net).faces):,}",
                    f"{spent:.1f}",
                    f"{memory:.0f}",
                    "yes" if Path(net).read_bytes() == once else "no",
                )
            )
    return lines_of(("triangles", "quads", "seconds", "peak MB", "same bytes twice"), *rows)


def random_words(count: int) -> str:
    """How many random surfaces get an exact net near to them."""
    rows = [random_row(seed) for seed in range(count)]
    made = [row for row in rows if row.off is not None]
    near = [row for row in made if row.exact and row.off <= NEAR]
    print("\n".join(row.words for row in rows), file=sys.stderr)
    worst = ", ".join(f"{row.seed} ({row.off:.2f} %)" for row in made if row.off > NEAR) or "none"
    return (
        f"Of {count} random surfaces {len(made)} got a net, {len(near)} of them an exact principal "
        f"one that is off by at most {NEAR} % of the diagonal; off by more: {worst}."
    )


def main() -> None:
    """Print the tables; with --write put them into the document."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="update docs/benchmarks.md")
    parser.add_argument("--random", metavar="N", type=int, default=RANDOM)
    given = parser.parse_args()
    text = "\n\n".join(
        [
            "Six surfaces by formula, net `principal`:",
            six_surfaces().strip(),
            "Surfaces that carry exact nets:",
            exact_table(),
            "`align` on a dome:",
            speed_table(),
            random_words(given.random),
        ]
    )
    print(text)
    if given.write:
        write(ROOT / "docs" / "benchmarks.md", "align", text)


if __name__ == "__main__":
    main()
