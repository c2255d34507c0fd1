"""Measures how long FreeCAD takes to open STEP files of structures whose parts are all different.

Run with the project's Python:
    python scripts/bench_step.py [--parts N ...] [--write]
    python scripts/bench_step.py --content

``--write`` puts the table into docs/fabrication.md, ``--content`` says what takes the place in a
file of twisted lamellas with 21 crossings. FreeCAD's console program is that of
scripts/setup.sh (ORTHO_FREECADCMD). Seconds are those of the processor.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import bench

sys.path.insert(0, str(bench.ROOT))

from freecad_ortho.fabrication import Beams, Lamellas, Panels, build
from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.step import write_step
from solver import optimise
from tests.meshes import helicoid

DOCUMENT = bench.ROOT / "docs" / "fabrication.md"
SIZES = (1338, 10208)
# Above it only what opens soonest is measured: what the others take grows with the square of the
# number of parts.
LARGE = 2500
FORMS = ("one", "in-place")
HEAD = (
    "| parts | `--step` | size | opens in | with *Use LinkGroup* |\n"
    "| ---: | --- | ---: | ---: | ---: |"
)


# What the entities of a file are for, by their names; a direction is mostly that of a line.
CONTENT = {
    "faces, loops, edges, corners": (
        *("ADVANCED_FACE", "FACE_BOUND", "EDGE_LOOP", "ORIENTED_EDGE"),
        *("EDGE_CURVE", "VERTEX_POINT", "CLOSED_SHELL"),
    ),
    "lines and directions": ("LINE", "VECTOR", "DIRECTION"),
    "points": ("CARTESIAN_POINT",),
    "surfaces": ("B_SPLINE_SURFACE_WITH_KNOTS", "PLANE", "AXIS2_PLACEMENT_3D"),
}


def content() -> str:
    """What takes the place in a file of two twisted lamellas that 21 others cross."""
    net = helicoid(rows=21, columns=21).scaled(1000.0)
    parts = build(net, [Lamellas(60, 4, strip="twisted")]).parts
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "lamellas.step"
        write_step(path, [part for part in parts if part.name in ("L-U010", "L-V010")])
        text = path.read_bytes()
    sizes: Counter[str] = Counter()
    for found in re.finditer(rb"#\d+=\(?(\w+)[^\n]*\n", text):
        sizes[found[1].decode()] += len(found[0])
    rows = [f"{len(text) / 2000:.0f} kB a lamella"]
    for what, names in CONTENT.items():
        rows.append(f"{what}: {100 * sum(sizes[name] for name in names) / len(text):.0f} %")
    return "\n".join(rows)


def all_parts() -> Sequence[Part]:
    """Beams, then panels of a wavy grid, no two of them equal."""
    mesh = optimise(bench.wavy_grid(59), "principal").mesh
    return build(mesh.scaled(1000 / mesh.mean_edge), [Beams(200, 12), Panels(12, 10)]).parts


def opened(path: Path, names: list[str], links: bool) -> float:
    """Seconds in which FreeCAD opens a file; its objects must have the names of the parts."""
    with tempfile.TemporaryDirectory(dir=path.parent) as home:
        order = {"path": str(path), "links": links, "answer": f"{home}/answer.json"}
        environment = {**os.environ, "FREECAD_USER_HOME": home, "ORTHO_STEP": json.dumps(order)}
        command = [os.environ.get("ORTHO_FREECADCMD", "freecadcmd"), script()]
        subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, check=True)
        answer: dict[str, Any] = json.loads(Path(order["answer"]).read_text())  # type: ignore[arg-type]
    if missing := set(names) - set(answer["labels"]):
        raise SystemExit(f"{path.name}: FreeCAD named no object {sorted(missing)[0]}")
    return float(answer["seconds"])


def script() -> str:
    """What FreeCAD runs."""
    return str(Path(__file__).with_name("bench_step_freecad.py"))


def rows(parts: Sequence[Part], folder: Path) -> list[str]:
    """Lines of the table for these parts."""
    names = [part.name for part in parts]
    forms = FORMS if len(parts) < LARGE else FORMS[1:]
    paths = {form: folder / f"{form}-{len(parts)}.step" for form in forms}
    for form, path in paths.items():
        write_step(path, parts, in_place=form == "in-place")
    cases = [(form, links) for form in forms for links in (False, True) if links or len(forms) > 1]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        times = dict(
            zip(cases, pool.map(lambda c: opened(paths[c[0]], names, c[1]), cases), strict=True)
        )
    found = []
    for form, path in paths.items():
        ways = [(form, links) for links in (False, True)]
        seconds = [f"{times[way]:.0f} s" if way in times else "" for way in ways]
        megabytes = path.stat().st_size / 1e6
        found.append(f"| {len(parts):,} | {form} | {megabytes:.1f} MB | {' | '.join(seconds)} |")
    return found


def main() -> None:
    """Print the table; with --write put it into the document."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--parts", type=int, nargs="+", default=SIZES, help="how many parts")
    parser.add_argument("--write", action="store_true", help="update docs/fabrication.md")
    parser.add_argument("--content", action="store_true", help="what takes the place in a file")
    options = parser.parse_args()
    if options.content:
        print(content())
        return
    parts = all_parts()
    lines = [HEAD]
    with tempfile.TemporaryDirectory() as folder:
        for size in options.parts:
            half = min(size, len(parts)) // 2
            lines += rows([*parts[:half], *parts[len(parts) - half :]], Path(folder))
    print("\n".join(lines))
    if options.write:
        bench.write(DOCUMENT, "step", "\n".join(lines))


if __name__ == "__main__":
    main()
