"""Writes the figure and prints the tables of docs/nets.md on few kinds of parts.

Run with the project's Python:
    python scripts/docs_kinds.py            # the demo roof: figure and tables
    python scripts/docs_kinds.py --others   # the tables of another roof of as many panels
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib.pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from docs_nearest import sampled

from freecad_ortho import api
from solver import QuadMesh, optimise
from solver.analysis.kinds import kinds_within
from solver.report import Report

ROOT = Path(__file__).resolve().parents[1]
PICTURE = ROOT / "docs" / "pictures" / "nets" / "kinds.png"
# Net, parts, how many kinds, and within how much: mm, of nodes degrees.
ASKED = (
    ("principal", "panels", 40, 2.0),
    ("principal", "edges", 20, 1.0),
    ("planar", "edges", 20, 1.0),
    ("principal", "nodes", 30, 0.1),
)
# A roof of 480 panels, far from surfaces of revolution, and what is asked of it.
OTHERS = ("wave",)
OF_OTHERS = (("principal", "panels", 40, 2.0), ("planar", "edges", 20, 1.0))
CURVE = (0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0)


def row(net: str, of: str, report: Report) -> str:
    """What came of a run, as a row of the table."""
    found, form = report.repetition, report.form
    unit = "degrees" if of == "nodes" else "mm"
    return (
        f"| {net} | {of} | {found.asked} within {found.alike:g} {unit} | {found.kinds_before} | "
        f"{found.kinds} | {form.off_surface.max:.0f} mm, {form.off_surface.percent:.2f} % | "
        f"{form.area_ratio:.2f} | {form.zigzag:.2f} | {report.residuals['planarity'].max:.0e} |"
    )


def curve(mesh: QuadMesh, of: str) -> list[int]:
    """Numbers of kinds within every length of the curve."""
    return [kinds_within(mesh, of, within).number for within in CURVE]


def others() -> None:
    """Print the rows of other roofs, and their numbers of kinds within lengths."""
    for name in OTHERS:
        roof = sampled(name, 31, 17).scaled(1000.0)
        for net, of, kinds, alike in OF_OTHERS:
            outcome = optimise(roof, net, repeat=of, kinds=kinds, alike=alike)
            print(f"| {name} {row(net, of, outcome.report)}", flush=True)
            numbers = " | ".join(map(str, curve(outcome.mesh, of)))
            print(f"| {name}, {net}, {of}, after | {numbers} |", flush=True)


if __name__ == "__main__":
    if "--others" in sys.argv:
        others()
        raise SystemExit
    roof = api.read_mesh(ROOT / "examples" / "data" / "demo_roof.obj").mesh
    plain = {net: optimise(roof, net).mesh for net in ("principal", "planar")}
    print(
        "| net | parts | asked | kinds before | kinds | off the surface | area | evenness | worst |"
    )
    print("| --- | --- | --- | ---: | ---: | --- | ---: | ---: | ---: |")
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.4), layout="constrained")
    place = iter(axes)
    lines = []
    for net, of, kinds, alike in ASKED:
        outcome = optimise(roof, net, repeat=of, kinds=kinds, alike=alike, alike_angle=alike)
        print(row(net, of, outcome.report), flush=True)
        if of == "nodes":
            continue
        numbers = {"before": curve(plain[net], of), "after": curve(outcome.mesh, of)}
        axis = next(place)
        for words, style in (("before", "o--"), ("after", "o-")):
            axis.loglog(CURVE, numbers[words], style, label=words)
            lines.append(f"| {net}, {of}, {words} | {' | '.join(map(str, numbers[words]))} |")
        axis.set(title=f"{net}: {of}", xlabel="within, mm", ylabel="kinds")
        axis.grid(True, which="both", alpha=0.3)
        axis.legend()
    print(f"\n| kinds within mm | {' | '.join(f'{within:g}' for within in CURVE)} |")
    print(f"| --- |{' ---: |' * len(CURVE)}")
    print("\n".join(lines))
    figure.savefig(PICTURE, dpi=110)
