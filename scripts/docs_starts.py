"""Writes the tables of docs/nets.md on starts that are not near: freeform surfaces, and noise.

Run with the project's Python:
    python scripts/docs_starts.py [--write] [--noise] [NET ...]

The first table takes some minutes, the second one, with ``--noise``, more. Rows of some nets are
put in the place of those that stand there.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from bench import ROOT, write
from docs_nearest import SURFACES, sampled

from solver import Constraints, NetOptions, QuadMesh, optimise
from solver.align.align import aligned
from solver.mesh.closest import TriangleSurface
from solver.report import CONVERGED, Report
from tests.meshes import freeform_roof, noisy

Options = Mapping[str, Any]
PAGE = ROOT / "docs" / "nets.md"
ALL = tuple(SURFACES)
# Saddles, at least in part; those on which asymptotic lines are found.
SADDLES, ALIGNED = ("skew saddle", "wave"), ("skew saddle",)
# Nets after the paper, and of which surfaces they are asked.
NETS: dict[str, tuple[str, Options, tuple[str, ...]]] = {
    "isogonal": ("isogonal", {}, ALL),
    "isothermic": ("isothermic", {}, ALL),
    "planar-lines": ("planar-lines", {}, ALL),
    "planar-lines, both": ("planar-lines", {"plane": "both"}, ALL),
    "asymptotic-angle": ("asymptotic-angle", {}, SADDLES),
    "pseudo-geodesic": ("pseudo-geodesic", {}, ALL),
    "pseudo-geodesic, 60": ("pseudo-geodesic", {"tilt_u": 60.0, "tilt_v": 60.0}, ALL),
    "web aag": ("web", {"web": "aag"}, SADDLES),
    "asymptotic-angle, aligned": ("asymptotic-angle", {}, ALIGNED),
    "web aag, aligned": ("web", {"web": "aag"}, ALIGNED),
    "web agg": ("web", {"web": "agg"}, ALL),
    "web gga": ("web", {"web": "gga"}, SADDLES),
    "web ggg": ("web", {"web": "ggg"}, ALL),
}
ROWS, COLUMNS, EDGE = 26, 19, 1.3
# Nets that are asked of starts with noise, and with which weights of evenness.
NOISY = {
    "isogonal": (0.0, None),
    "isothermic": (0.0, None),
    "planar-lines": (0.0, None),
    "planar-lines, both": (0.0, None),
    "pseudo-geodesic": (0.0, None),
    "pseudo-geodesic, 60": (0.0, None),
}
SEEDS, AMOUNT = 10, 0.1


def reached(start: QuadMesh, net: str, options: Options, **more: Any) -> Report:
    """What came of a run."""
    return optimise(start, net, options=NetOptions(**options), **more).report


def along_asymptotic(surface: str) -> tuple[QuadMesh, Options]:
    """A start along the asymptotic lines of a surface, and to stay close to that."""
    fine = TriangleSurface.from_quads(sampled(surface, 61, 45))
    ground = fine.vertices, fine.triangles
    start = aligned(*ground, net="asymptotic-angle", edge=EDGE).mesh
    return start, {"constraints": Constraints(close_to=ground)}


def worst(report: Report) -> float:
    """Largest residual."""
    return max(spread.max for spread in report.residuals.values())


def freeform_table(names: Sequence[str]) -> str:
    """Nets on every surface: distance, evenness and area."""
    lines = [
        f"| net | {' | '.join(SURFACES)} | worst |",
        f"| --- |{' --- |' * len(SURFACES)} ---: |",
    ]
    for name in names:
        net, options, surfaces = NETS[name]
        cells, residual = [], 0.0
        for surface in SURFACES:
            if surface not in surfaces:
                cells.append("")
                continue
            if surfaces is ALIGNED:
                start, more = along_asymptotic(surface)
            else:
                start, more = sampled(surface, ROWS, COLUMNS), {}
            report = reached(start, net, options, **more)
            form, residual = report.form, max(residual, worst(report))
            status = "" if report.status == CONVERGED else f"{report.status}, "
            cells.append(
                f"{status}{form.off_surface.percent:.2f} %, {form.zigzag:.2f}, "
                f"{form.area_ratio:.2f}"
            )
        lines.append(f"| {name} | {' | '.join(cells)} | {residual:.0e} |")
        print(lines[-1], flush=True)
    return "\n".join(lines)


def noise_table(names: Sequence[str]) -> str:
    """Starts with noise: how many reach the net, and how evenly their lines bend."""
    roof, dome = freeform_roof(20, 17), sampled("rectangular dome", 22, 16)
    lines = [
        "| net | start | `--evenness` | reached | evenness: median, least | off at most "
        "| area at least |",
        "| --- | --- | --- | ---: | ---: | ---: | ---: |",
    ]
    for name in filter(names.__contains__, NOISY):
        weights, (net, options, _) = NOISY[name], NETS[name]
        for what, start in {"roof": roof, "dome": dome}.items():
            for weight in weights:
                found = [
                    reached(
                        noisy(start, AMOUNT, seed),
                        net,
                        options,
                        **({} if weight is None else {"evenness": weight}),
                    )
                    for seed in range(SEEDS)
                ]
                exact = sum(r.status == CONVERGED and worst(r) <= 1e-10 for r in found)
                even = [r.form.zigzag for r in found]
                off = max(r.form.off_surface.percent for r in found)
                area = min(r.form.area_ratio for r in found)
                given = "" if weight is None else f"{weight:g}"
                lines.append(
                    f"| {name} | {what} | {given} | {exact} of {SEEDS} "
                    f"| {np.median(even):.2f}, {min(even):.2f} | {off:.1f} % | {area:.2f} |"
                )
                print(lines[-1], flush=True)
    return "\n".join(lines)


def merged(table: str, part: str) -> str:
    """Rows of some nets among those of the others that stand in the document."""
    mark = f"<!-- {part} table: "
    standing = PAGE.read_text(encoding="utf-8").split(mark)[1].split("\n", 1)[1].splitlines()
    head, rows = table.splitlines()[:2], table.splitlines()[2:]
    new = {row.split(" | ")[0] for row in rows}
    kept = [row for row in standing[2:] if row and row.split(" | ")[0] not in new]
    places = [f"| {name}" for name in NETS]
    whole = sorted([*kept, *rows], key=lambda row: places.index(row.split(" | ")[0]))
    return "\n".join([*head, *whole])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="update docs/nets.md")
    parser.add_argument("--noise", action="store_true", help="starts with noise instead")
    parser.add_argument("nets", nargs="*", metavar="NET", help="only rows of these")
    chosen = parser.parse_args()
    part = "noise" if chosen.noise else "starts"
    table = (noise_table if chosen.noise else freeform_table)(chosen.nets or list(NETS))
    if chosen.write:
        write(PAGE, part, merged(table, part) if chosen.nets else table)
