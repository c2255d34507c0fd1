"""Align nets on surfaces by formula and write the table of docs/sources.md.

usage: python scripts/docs_align.py                     print the table
       python scripts/docs_align.py --write             write it into the page
       python scripts/docs_align.py --follow [--write]  the table of nets that follow the border
       python scripts/docs_align.py --picture FILE.png  draw the nets
       python scripts/docs_align.py --roofs FILE.png    draw nets on roofs with creases
       python scripts/docs_align.py --random 40         try random surfaces

Surfaces are given as 120 x 72 x 2 triangles, aligned with edges of 1.1 m by the command line, then
optimised close to the surface, with default settings. What is off the surface is measured on one
that is carried on by a tenth of its formula, since nets overhang the border.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from examples.drawing import Panel, draw  # noqa: E402
from solver import (  # noqa: E402
    Constraints,
    InputError,
    NetOptions,
    QuadMesh,
    optimise,
    read_mesh,
    write_mesh,
)
from solver.align.align import aligned  # noqa: E402
from solver.align.reach import reaching  # noqa: E402
from solver.align.triangle_mesh import TriangleMesh  # noqa: E402
from solver.analysis import form, measures  # noqa: E402
from solver.mesh.closest import TriangleSurface  # noqa: E402
from solver.mesh.grid import grid_mesh  # noqa: E402
from solver.mesh.quadmesh import FloatArray  # noqa: E402
from solver.nets.constraints import BoundaryGlide  # noqa: E402
from tests.design_surfaces import HIP, WING, groined, random_surface  # noqa: E402
from tests.design_surfaces import sheet as roof_of  # noqa: E402

PAGE = ROOT / "docs" / "sources.md"
BEGIN, END = "<!-- align -->\n", "<!-- /align -->"
FOLLOW_BEGIN, FOLLOW_END = "<!-- follow -->\n", "<!-- /follow -->"
# What faces may be off flat where a net keeps its border, m.
FLAT = 0.01
EDGE = "1.1"
HEADS = (
    "surface",
    "faces",
    "irregular",
    "orthogonality, max / mean",
    "planarity, max / mean",
    "off, when exact",
    "area",
    "zigzag",
    "shortest edge kept",
    "time",
)


def _twisted_barrel(u: FloatArray, v: FloatArray) -> tuple[FloatArray, ...]:
    w = v - 0.5
    height = 5 * np.cos(np.pi * w) * (1 + 0.4 * np.sin(2 * u))
    return 30 * u, 18 * w * (1 + 0.25 * u), height


def _skew_saddle(u: FloatArray, v: FloatArray) -> tuple[FloatArray, ...]:
    a, b = u - 0.5, v - 0.5
    return 30 * u + 3 * v, 20 * v - 4 * u, 12 * a**2 - 20 * b**2 + 2 * a * b


def _wave(u: FloatArray, v: FloatArray) -> tuple[FloatArray, ...]:
    height = 2 * np.sin(2 * np.pi * u) + 1.5 * np.cos(np.pi * v) + 1.2 * u * v
    return 40 * u, 20 * v, height


def _dome(u: FloatArray, v: FloatArray) -> tuple[FloatArray, ...]:
    a, b = u - 0.5, v - 0.5
    return 30 * a, 20 * b, 6 * np.cos(0.9 * np.pi * a) * np.cos(0.9 * np.pi * b)


def _canopy(u: FloatArray, v: FloatArray) -> tuple[FloatArray, ...]:
    rise = 3 * np.sin(np.pi * v) * (1 - 0.6 * u)
    return 30 * u, 18 * v, 4 + rise + 2 * np.sin(1.5 * np.pi * u) * (v - 0.5)


def _bump(u: FloatArray, v: FloatArray) -> tuple[FloatArray, ...]:
    height = 4 * np.exp(-9 * ((u - 0.45) ** 2 + (v - 0.55) ** 2)) + 0.8 * u
    return 30 * u, 30 * v, height


SURFACES: dict[str, Callable[[FloatArray, FloatArray], tuple[FloatArray, ...]]] = {
    "twisted barrel": _twisted_barrel,
    "skew saddle": _skew_saddle,
    "wave": _wave,
    "dome": _dome,
    "canopy": _canopy,
    "bump": _bump,
}


def sheet(name: str, counts: tuple[int, int], margin: float = 0.0) -> QuadMesh:
    """A grid of quads along the parameters of a formula."""
    ends = [np.linspace(-margin, 1 + margin, count) for count in counts]
    grids = np.meshgrid(*ends, indexing="ij")
    return grid_mesh(np.stack(np.broadcast_arrays(*SURFACES[name](*grids)), axis=-1))


def run(*arguments: str) -> None:
    """One command of the command line."""
    command = [sys.executable, "-m", "freecad_ortho", *arguments]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"{' '.join(arguments)}: {done.stderr}")


def row(name: str, folder: Path) -> str:
    """The line of one surface."""
    start, net, exact = (str(folder / f"{part}.obj") for part in ("surface", "net", "exact"))
    write_mesh(start, sheet(name, (121, 73)), "m")
    begun = time.perf_counter()
    report = str(folder / "align.json")
    run("align", start, "--edge", EDGE, "-o", net, "--report", report)
    spent = time.perf_counter() - begun
    run("optimise", net, "--net", "principal", "--close-to", start, "-o", exact)
    aligned, optimised = read_mesh(net), read_mesh(exact)
    irregular = json.loads(Path(report).read_text())["irregular_vertices"]
    away = ~np.isin(aligned.faces, irregular).any(axis=1)
    right, flat = (
        measure(aligned)[away] for measure in (measures.orthogonality, measures.planarity)
    )
    surface = TriangleSurface.from_quads(sheet(name, (481, 289), 0.1))
    found = form.form_of(aligned, optimised, surface)
    edges = measures.edge_ratio(optimised) / measures.edge_ratio(aligned)
    cells = (
        name,
        len(aligned.faces),
        len(irregular),
        f"{right.max():.3f} / {right.mean():.4f}",
        f"{flat.max():.4f} / {flat.mean():.5f}",
        f"{found.off_surface.max * 1000:.0f} mm, {found.off_surface.percent:.3f} %",
        f"{found.area_ratio:.3f}",
        f"{found.zigzag:.2f}",
        f"{edges:.2f}",
        f"{spent:.0f} s",
    )
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def table() -> str:
    """All surfaces."""
    lines = ["| " + " | ".join(HEADS) + " |", "| --- |" + " ---: |" * (len(HEADS) - 1)]
    with tempfile.TemporaryDirectory() as folder:
        lines += [row(name, Path(folder)) for name in SURFACES]
    return "\n".join(lines) + "\n"


def follow_row(name: str) -> str:
    """What an exact net and a planar one with a gap make of a net that follows its border."""
    surface = TriangleSurface.from_quads(sheet(name, (121, 73)))
    made = aligned(surface.vertices, surface.triangles, edge=float(EDGE), border="follow").mesh
    near = (surface.vertices, surface.triangles)
    cells: list[object] = [name, len(made.faces)]
    for net, constraints, options in (
        ("principal", Constraints(close_to=near), None),
        (
            "planar",
            Constraints(close_to=near, glide=(BoundaryGlide(),)),
            NetOptions(flatness=FLAT),
        ),
    ):
        outcome = optimise(made, net, constraints=constraints, options=options)
        found = outcome.report.form
        cells += ["yes" if outcome.report.status == "converged" else "no"]
        lengths = (found.border, found.off_surface.max, found.gap)
        cells += [f"{1000 * length:.0f} mm" for length in lengths]
        cells += [f"{found.area_ratio:.3f}"]
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def follow_table() -> str:
    """All surfaces."""
    heads = "reached", "off the border", "off the surface", "largest gap", "area"
    exact, planar = ([f"{net}: {head}" for head in heads] for net in ("principal", "planar"))
    lines = ["| " + " | ".join(["surface", "faces", *exact, *planar]) + " |"]
    lines += ["| --- |" + " ---: |" * 11, *map(follow_row, SURFACES)]
    return "\n".join(lines) + "\n"


class Attempt(NamedTuple):
    """What became of one random surface.

    Attributes:
        seed: its number.
        words: a line about it.
        exact: whether the net is exact, without folded faces.
        off: its largest distance from the surface without noise where it lies over that, in percent
            of the diagonal; None without a net.
        triangles: of the surface.
        faces: of the net.
        irregular: vertices of the net.
        zigzag: how evenly its lines bend.
        seconds: processor time until it was aligned.
    """

    seed: int
    words: str
    exact: bool = False
    off: float | None = None
    triangles: int = 0
    faces: int = 0
    irregular: int = 0
    zigzag: float = 0.0
    seconds: float = 0.0


def random_row(seed: int) -> Attempt:
    """Try one random surface; neither noise nor what is trimmed is what a net is measured by."""
    points, triangles = random_surface(seed)
    begun = time.process_time()
    try:
        made = aligned(points, triangles, edge=1.2)
    except InputError as error:
        return Attempt(seed, f"{seed:2} refused: {error}")
    spent = time.process_time() - begun
    given = Constraints(close_to=reaching(made.mesh, points, triangles))
    outcome = optimise(made.mesh, "principal", constraints=given)
    clean = TriangleSurface(*reaching(made.mesh, *random_surface(seed, noisy=False)))
    found = form.form_of(made.mesh, outcome.mesh, clean)
    over = off_over(outcome.mesh, TriangleSurface(*random_surface(seed, noisy=False)))
    exact = outcome.report.status == "converged" and not outcome.report.flipped_faces
    words = (
        f"{seed:2} {len(triangles):6} triangles, {len(made.mesh.faces):4} faces, "
        f"{len(made.irregular):2} irregular, {spent:3.0f} s; {outcome.report.status}, "
        f"off {over:.3f} %, with what is trimmed {found.off_surface.percent:.3f} %, zigzag "
        f"{found.zigzag:.2f}, folded {outcome.report.flipped_faces} {'; '.join(made.remarks)}"
    )
    counts = len(triangles), len(made.mesh.faces), len(made.irregular)
    return Attempt(seed, words, exact, over, *counts, found.zigzag, spent)


def off_over(mesh: QuadMesh, surface: TriangleSurface) -> float:
    """Largest distance of a net from a surface, in percent, where it does not overhang that.

    Vertices and middles of faces whose closest point is on the border overhang.
    """
    places = np.concatenate([mesh.vertices, mesh.vertices[mesh.faces].mean(axis=1)])
    feet, _ = surface.closest(places)
    sheet_ = TriangleMesh(surface.vertices, surface.triangles)
    rim = TriangleSurface(surface.vertices, sheet_.half_edges[sheet_.rim][:, [0, 1, 1]])
    over = np.linalg.norm(feet - rim.closest(feet)[0], axis=1) > 1e-6 * mesh.mean_edge
    far = np.linalg.norm(places - feet, axis=1)[over].max()
    return float(100 * far / np.linalg.norm(np.ptp(mesh.vertices, axis=0)))


def picture(target: str) -> None:
    """All nets as they are aligned, with the border of the surface and irregular vertices."""
    panels = []
    for name in SURFACES:
        surface = TriangleSurface.from_quads(sheet(name, (121, 73)))
        made = aligned(surface.vertices, surface.triangles, edge=float(EDGE))
        lines = [np.concatenate([line, line[:1]]) for line in made.border]
        points = made.mesh.vertices[made.irregular]
        panels.append(Panel(name, made.mesh, lines=lines, points=points, rise=48.0))
    draw(panels, target)


def roofs(target: str) -> None:
    """Nets on two roofs and a cross vault, with irregular vertices."""
    panels = []
    for name, given in (
        ("hip roof", roof_of(HIP)),
        ("lower wing and window", roof_of(WING)),
        ("cross vault", groined()),
    ):
        made = aligned(*given, edge=1.2)
        points = made.mesh.vertices[made.irregular]
        panels.append(Panel(name, made.mesh, points=points, rise=48.0))
    draw(panels, target)


def main() -> None:
    """Read the command line and make the table, or the picture."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--follow", action="store_true", help="nets that follow the border")
    parser.add_argument("--picture", metavar="FILE.png")
    parser.add_argument("--roofs", metavar="FILE.png")
    parser.add_argument("--random", metavar="N", type=int)
    given = parser.parse_args()
    if given.random:
        for seed in range(given.random):
            print(random_row(seed).words, flush=True)
        return
    if given.picture:
        picture(given.picture)
        return
    if given.roofs:
        roofs(given.roofs)
        return
    made = follow_table() if given.follow else table()
    if not given.write:
        print(made)
        return
    begin, end = (FOLLOW_BEGIN, FOLLOW_END) if given.follow else (BEGIN, END)
    page = PAGE.read_text(encoding="utf-8")
    before, rest = page.split(begin)
    PAGE.write_text(before + begin + made + end + rest.split(end, 1)[1], encoding="utf-8")


if __name__ == "__main__":
    main()
