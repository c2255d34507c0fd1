"""Remakes figures 6 and 7 of the paper by the command line, with its weight, for docs/gallery.md.

Run with the project's Python:  python scripts/docs_regularisers.py [PICTURE.png]
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from examples.drawing import Panel, draw
from examples.multi_net_regulariser import rise, rough_roof, roughness
from examples.smooth_and_doubly_curved import double_curvature
from solver import QuadMesh
from solver.io.polygons import read_mesh, write_mesh

ROOT = Path(__file__).resolve().parents[1]
# Noise of the start, in mean edges.
NOISE = 0.03
# All guides but those that are named are off.
QUIET = "--closeness 0 --smooth-motion 0 --edge-vectors 0"
PANELS = {
    "6 b: E_ortho": "--fairness 0 --multi 0",
    "6 c: E_ortho + 0.005 E_multi": "--fairness 0 --multi 0.005",
    "6 d: E_ortho + 0.005 E_fair": "--fairness 0.005 --multi 0",
    "7 b: with 0.005 E_multi": "--fairness 0 --multi 0.005",
    "7 c: with 0.005 E_fair": "--fairness 0.005 --multi 0",
    "7 d: with 0.005 E_multi and 0.00005 E_fair": "--fairness 0.00005 --multi 0.005",
}


def arguments(weights: str) -> list[str]:
    """What the command line is told, but for the files."""
    return f"--net orthogonal {weights} {QUIET}".split()


def made(weights: str, start: QuadMesh, folder: Path) -> QuadMesh:
    """The start made orthogonal by the command line; what is not reached is drawn as it is."""
    before, after = folder / "start.obj", folder / "net.obj"
    write_mesh(before, start, "m")
    command = [sys.executable, "-m", "freecad_ortho", "optimise", str(before), "-o", str(after)]
    subprocess.run([*command, *arguments(weights)], cwd=ROOT, check=False, capture_output=True)
    return read_mesh(after)


def main() -> None:
    """Print the numbers; draw the pictures where a file is named."""
    roof, start = rough_roof(NOISE)
    shapes = {"6 a, 7 a": start}
    with tempfile.TemporaryDirectory() as folder:
        for name, weights in PANELS.items():
            shapes[name] = made(weights, start, Path(folder))
    print("| picture | second differences, in edges | rise kept | double curvature kept |")
    print("| --- | --- | --- | --- |")
    for name, mesh in shapes.items():
        kept = rise(mesh) / rise(roof), double_curvature(mesh) / double_curvature(roof)
        print(f"| {name} | {roughness(mesh):.3f} | {kept[0]:.2f} | {kept[1]:.2f} |")
    if len(sys.argv) > 1:
        first, *others = [Panel(name, mesh, -60, 35) for name, mesh in shapes.items()]
        rows = [first, *others[:3], Panel("7 a", first.mesh, -60, 35), *others[3:]]
        draw(rows, sys.argv[1], columns=4, size=4.2, high=0.72)


if __name__ == "__main__":
    main()
