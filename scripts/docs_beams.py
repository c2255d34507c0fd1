"""The table and the picture of sections, ends, joints and edges in docs/fabrication.md.

    python scripts/docs_beams.py [--write]

The table needs the meshes of the paper's authors. For each structure every solid is written to
STEP, read back and held against the volume by formula, and every pair that comes near is checked.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from bench import ROOT, SHARED, write
from matplotlib.colors import to_rgb
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from freecad_ortho import api
from freecad_ortho.fabrication.clash import check_clashes
from freecad_ortho.fabrication.step import read_step, write_step
from solver.mesh.coarsen import compact

NAMES = ("heart", "conical1", "botanic-garden-bubble-0")
EDGE = 1000.0
SIZES = {"height": 120.0, "thickness": 10.0, "section_width": 50.0, "hub_diameter": 90.0}
STRUCTURES = {
    "hollow, mitred; panels bevelled": (
        "beams+panels",
        {"section": "hollow", "panel_edge": "bevel"},
    ),
    "plates on hubs; hubs": ("beams+nodes", {"ends": "hub", "bore": 17.0}),
    "plates lapped": ("beams", {"ends": "lapped"}),
    "plates lapped; sockets": ("beams+nodes", {"ends": "lapped", "node": "socket"}),
}
COLOURS = {"beam": "#6f8fb0", "node": "#d08a3c", "panel": "#c9d6c0", "louvre": "#a9c48f"}
VIEWS = {
    "hollow, mitred": ("beams", {"section": "hollow"}, 35),
    "I on hubs": ("beams+nodes", {"ends": "hub", "section": "I", "bore": 30.0}, 35),
    "T, u runs through": ("beams", {"section": "T", "ends": "through-u"}, 35),
    "lapped": ("beams", {"ends": "lapped"}, 35),
    "lapped, socket, from below": ("beams+nodes", {"ends": "lapped", "node": "socket"}, -40),
    "louvres, tilted": ("beams+louvres", {"tilt": 30.0, "panel_thickness": 6.0}, 35),
}


def net(name: str) -> api.QuadMesh:
    """A principal net with edges of one metre on average."""
    start = api.read_mesh(SHARED / f"{name}.obj").mesh
    return api.optimise(start.scaled(EDGE / start.mean_edge), net="principal").mesh


def table() -> str:
    """One row a net and structure."""
    rows = [
        "| net | structure | parts | valid in STEP | volume, STEP to formula | near | clashes |",
        "| --- | --- | --- | --- | --- | --- | --- |",
    ]
    for name in NAMES:
        mesh = net(name)
        for words, (system, values) in STRUCTURES.items():
            parts = api.fabricate(mesh, system, **{**SIZES, **values}).parts
            found = check_clashes(parts)
            good, worst = _reread(parts)
            rows.append(
                f"| {name} | {words} | {len(parts)} | {good} | {worst} | {found.near} | "
                f"{len(found.clashes)} |"
            )
            print(rows[-1], flush=True)
    return "\n".join(rows)


def _reread(parts: tuple) -> tuple[str, str]:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "structure.step"
        write_step(path, parts)
        shapes = read_step(path)
    assert [name for name, _ in shapes] == [part.name for part in parts]
    valid = sum(shape.isValid() for _, shape in shapes)
    worst = max(
        abs(shape.Volume() / part.volume - 1)
        for (_, shape), part in zip(shapes, parts, strict=True)
    )
    return str(valid), f"{worst:.0e}"


def picture(path: Path) -> None:
    """A node of conical1 in each way to build it, its axis upright, from the faces around it."""
    whole = net("conical1")
    middles = whole.vertices[whole.faces].mean(axis=1)
    away = np.linalg.norm(middles - whole.vertices.mean(axis=0), axis=1)
    nearest = middles[away.argmin()]
    mesh = compact(whole, whole.faces[np.linalg.norm(middles - nearest, axis=1) < 2.5 * EDGE])
    middle = mesh.vertices.mean(axis=0)
    vertex = int(np.linalg.norm(mesh.vertices - middle, axis=1).argmin())
    figure = plt.figure(figsize=(12, 8))
    for number, (title, (system, values, height)) in enumerate(VIEWS.items()):
        sizes = {**SIZES, "height": 160.0, "section_width": 60.0, "hub_diameter": 130.0, **values}
        structure = api.fabricate(mesh, system, **sizes)
        axis = structure.axes.directions[vertex]
        first = np.cross(axis, [0.0, 1.0, 0.0])
        first /= np.linalg.norm(first)
        frame = np.stack([first, np.cross(axis, first), axis])
        view = figure.add_subplot(2, 3, number + 1, projection="3d")
        reach = 450.0 if "louvres" not in title else 1000.0
        _draw(view, structure, vertex, (mesh.vertices[vertex], frame), reach)
        view.view_init(elev=height, azim=-60)
        view.set_title(title, fontsize=11, y=-0.02)
    figure.subplots_adjust(left=0, right=1, bottom=0.03, top=1, wspace=0, hspace=0)
    figure.savefig(path, dpi=80)


def _draw(view, structure, vertex: int, place: tuple, reach: float) -> None:
    sides, colours = [], []
    light = np.array([0.3, -0.5, 0.8]) / np.linalg.norm([0.3, -0.5, 0.8])
    for part in structure.parts:
        near = vertex in part.vertices or part.kind == "louvre"
        if not near:
            continue
        points, triangles = part.solid().tessellate(1.0, 0.3)
        local = (np.array([p.toTuple() for p in points]) - place[0]) @ place[1].T
        base = np.array(to_rgb(COLOURS[part.kind])) * (0.75 if part.family == "v" else 1.0)
        for triangle in triangles:
            side = _clipped(local[list(triangle)], reach)
            if len(side) > 2:
                normal = np.cross(*np.diff(local[list(triangle)], axis=0))
                shade = 0.45 + 0.55 * abs(normal @ light) / (np.linalg.norm(normal) + 1e-12)
                sides.append(side)
                colours.append(np.clip(base * shade, 0, 1))
    view.add_collection3d(Poly3DCollection(sides, facecolors=colours, edgecolors="none"))
    for limit in (view.set_xlim, view.set_ylim, view.set_zlim):
        limit(-0.62 * reach, 0.62 * reach)
    view.set_box_aspect((1, 1, 1))
    view.set_axis_off()


def _clipped(side: np.ndarray, reach: float) -> np.ndarray:
    """A polygon (N, 3) inside the upright box of this half width."""
    for axis in (0, 1):
        for sign in (1.0, -1.0):
            kept = []
            for one, two in zip(side, np.roll(side, -1, axis=0), strict=True):
                a, b = (reach - sign * point[axis] for point in (one, two))
                if a >= 0:
                    kept.append(one)
                if a * b < 0:
                    kept.append(one + (two - one) * a / (a - b))
            side = np.array(kept)
            if len(side) < 3:
                return side
    return side


def main() -> None:
    """Print the table; with --write put it and the picture into the document."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--picture", action="store_true", help="the picture only")
    options = parser.parse_args()
    if options.write or options.picture:
        picture(ROOT / "docs" / "pictures" / "joints.png")
    if options.picture:
        return
    found = table()
    if options.write:
        write(ROOT / "docs" / "fabrication.md", "beams", found)


if __name__ == "__main__":
    main()
