"""Measure nets along curvature: how exact, how near to their surface, how fast.

usage: python scripts/bench_align.py                  print the tables
       python scripts/bench_align.py --write          write them into docs/benchmarks.md
       python scripts/bench_align.py --part speed     one of them: exact, speed or random
       python scripts/bench_align.py --surfaces 5     so many random surfaces instead of 40

Times are processor time, so that they can be compared on a busy machine. The nets on six surfaces
by formula are those of ``scripts/docs_align.py``.
"""

from __future__ import annotations

import argparse
import resource
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from bench import write
from docs_align import Attempt, random_row, run, sheet

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
            begun = resource.getrusage(resource.RUSAGE_CHILDREN)
            run("align", start, "--edge", edge, "-o", net)
            ended = resource.getrusage(resource.RUSAGE_CHILDREN)
            spent = ended.ru_utime + ended.ru_stime - begun.ru_utime - begun.ru_stime
            once = Path(net).read_bytes()
            run("align", start, "--edge", edge, "-o", net)
            rows.append(
                (
                    f"{2 * len(surface.faces):,}",
                    f"{len(read_mesh(net).faces):,}",
                    f"{spent:.0f}",
                    f"{ended.ru_maxrss / 1024:.0f}",
                    "yes" if Path(net).read_bytes() == once else "no",
                )
            )
    return lines_of(("triangles", "quads", "seconds", "peak MB", "same bytes twice"), *rows)


def random_table(rows: Sequence[Attempt]) -> str:
    """What becomes of random surfaces, and how many get an exact net near to them."""
    made = [row for row in rows if row.off is not None]
    near = [row for row in made if row.exact and row.off <= NEAR]
    heads = ("surface", "triangles", "quads", "irregular", "seconds", "off", "zigzag", "exact")
    cells = [
        (
            row.seed,
            *(f"{row.triangles:,}", row.faces, row.irregular, f"{row.seconds:.0f}"),
            *(f"{row.off:.3f} %", f"{row.zigzag:.2f}", "yes" if row.exact else "no"),
        )
        for row in made
    ]
    refused = [row.words.strip() for row in rows if row.off is None]
    words = (
        f"Of {len(rows)} random surfaces {len(made)} get a net, {len(near)} of them an exact "
        f"principal one that is off by at most {NEAR} % of the diagonal."
    )
    return "\n\n".join([words, lines_of(heads, *cells), *refused])


def parts(wanted: str, count: int) -> dict[str, str]:
    """The tables that are asked for, by the names of their marks in the document."""
    made = {}
    if wanted in ("all", "exact"):
        made["align"] = "Surfaces that carry exact nets:\n\n" + exact_table()
    if wanted in ("all", "speed"):
        made["align speed"] = "`align` on a dome:\n\n" + speed_table()
    if wanted in ("all", "random"):
        made["align random"] = random_table([random_row(seed) for seed in range(count)])
    return made


def main() -> None:
    """Print the tables; with --write put them into the document."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="update docs/benchmarks.md")
    parser.add_argument("--part", choices=("all", "exact", "speed", "random"), default="all")
    parser.add_argument("--surfaces", metavar="N", type=int, default=RANDOM)
    given = parser.parse_args()
    for part, text in parts(given.part, given.surfaces).items():
        print(text)
        if given.write:
            write(ROOT / "docs" / "benchmarks.md", part, text)


if __name__ == "__main__":
    main()
