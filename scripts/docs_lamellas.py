"""Makes the table and the pictures of lamellas in docs/fabrication.md.

Run with the project's Python:
    python scripts/docs_lamellas.py [--write]
    python scripts/docs_lamellas.py --third

``--third`` draws the third layer alone; all else needs the meshes of the paper's authors beside the
repository.
"""

from __future__ import annotations

import argparse
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import trimesh
from bench import ROOT
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

sys.path.insert(0, str(ROOT))

from freecad_ortho import api
from freecad_ortho.fabrication import Structure
from freecad_ortho.fabrication.part import Part
from solver import NetOptions
from tests.conftest import SHARED
from tests.meshes import freeform_saddle

MARK = "<!-- lamellas table -->"
PICTURE = ROOT / "docs" / "pictures" / "lamellas.png"
THIRD = ROOT / "docs" / "pictures" / "third-layer.png"
COLOURS = {"u": "#4a7ab5", "v": "#d08a3c", "d": "#4f9d5d", "": "#444a52"}
# Half the side of the cube around a crossing that is drawn, and the largest triangles in it, mm.
NEAR, FINE = 110.0, 7.0
EXAMPLES = (
    ("knet1", "asymptotic", 60.0, 4.0),
    ("helical-minimal", "asymptotic", 30.0, 2.0),
    ("cmc1", "cmc", 50.0, 5.0),
)


def make(name: str, net: str, width: float, thickness: float) -> Structure:
    """Optimise a mesh and build its lamellas."""
    mesh = api.optimise(api.read_mesh(SHARED / f"{name}.obj").mesh, net).mesh
    return api.fabricate(mesh, "lamellas", unit="m", width=width, thickness=thickness)


def row(name: str, structure: Structure) -> str:
    """A row of the table."""
    report = structure.results["lamellas"].report
    # Those at the border, of which the net asks nothing, are said apart.
    exact = [part.measures for part in structure.parts if not part.curved]
    off = max(each.straightness_mm or each.radius_spread_mm or 0.0 for each in exact)
    curved = [part.measures.straightness_mm or 0.0 for part in structure.parts if part.curved]
    apart = f" ({len(curved)} at the border {max(curved):.2g} mm)" if curved else ""
    kind = report["pattern"]
    if report["radius_mm"]:
        kind = f"arcs of {report['radius_mm']:.1f} mm"
    return (
        f"| {name}, {report['width_mm']:g} x {report['thickness_mm']:g} mm, {kind} "
        f"| {len(structure.parts)} | {report['crossings']} | {off:.0e} mm{apart} "
        f"| {report['lean_max_deg']:.1f}° | {report['gap_max_mm']:.1g} mm "
        f"| {report['bend_radius_min_mm'] / 1000:.1f} m |"
    )


def draw(structures: list[Structure]) -> None:
    """Lamellas in space, and some of their flat patterns below."""
    figure = plt.figure(figsize=(13, 7.5), dpi=90)
    for column, structure in enumerate(structures):
        space = figure.add_subplot(2, 3, column + 1, projection="3d")
        sides, colours = [], []
        for part in structure.parts:
            corners = part.origin + part.body.corners @ part.frame
            rings = [*part.body.sides, *(sheet.loops[0] for sheet in part.body.sheets)]
            sides += [corners[list(ring)] for ring in rings]
            colours += ["#4a7ab5" if part.family == "u" else "#d08a3c"] * len(rings)
        # In one collection: only within one are sides drawn from back to front.
        space.add_collection3d(Poly3DCollection(sides, facecolors=colours, linewidths=0))
        points = structure.mesh.vertices
        middle, size = points.mean(axis=0), np.ptp(points, axis=0).max() / 2.2
        space.set(**{f"{k}lim": (m - size, m + size) for k, m in zip("xyz", middle, strict=True)})
        space.set_axis_off()
        flat = figure.add_subplot(2, 3, column + 4)
        level = 0.0
        for part in [each for each in structure.parts if len(each.vertices) > 2][2:32:6]:
            outline = part.pattern.outline[:, ::1] + [0.0, level]
            flat.fill(*outline.T, facecolor="#d9e4f1", edgecolor="#26292f", linewidth=0.5)
            axis = part.pattern.axis + [0.0, level]
            flat.plot(*axis.T, color="#b81a26", linewidth=0.5)
            level += part.pattern.size[1] + 250.0
        flat.set_aspect("equal")
        flat.set_axis_off()
    figure.subplots_adjust(0, 0.02, 1, 1, 0, 0)
    figure.savefig(PICTURE)


def triangles(part: Part, middle: np.ndarray) -> np.ndarray:
    """(N, 3, 3) of what a cube holds of a part, small ones, so that they are sorted well."""
    points, faces = part.solid().tessellate(0.5)
    mesh = trimesh.Trimesh([point.toTuple() for point in points], faces, process=False)
    for side in np.concatenate([np.eye(3), -np.eye(3)]):
        if len(mesh.faces):
            mesh = mesh.slice_plane(middle + NEAR * side, -side)
    if not len(mesh.faces):
        return np.empty((0, 3, 3))
    fine, corners = trimesh.remesh.subdivide_to_size(mesh.vertices, mesh.faces, FINE)
    return np.asarray(fine[corners])


def draw_third() -> None:
    """A third layer along geodesic diagonals, and one crossing seen from above and from below."""
    web = api.optimise(freeform_saddle(13, 12, 13.0), "web", options=NetOptions(web="aag")).mesh
    structure = api.fabricate(web, "lamellas", unit="m", diagonals="auto")
    points = structure.mesh.vertices
    ties = [part for part in structure.parts if part.kind == "cleat"]
    middle = points[ties[len(ties) // 2].vertices[0]]
    near = [
        (part, triangles(part, middle))
        for part in structure.parts
        if np.linalg.norm(points[list(part.vertices)] - middle, axis=1).min() < 1.0
    ]
    figure = plt.figure(figsize=(13, 4.6), dpi=90)
    for column, height in enumerate((40.0, 25.0, -30.0), start=1):
        space = figure.add_subplot(1, 3, column, projection="3d")
        centre, size = (
            (middle, NEAR * 0.75)
            if column > 1
            else (points.mean(axis=0), np.ptp(points, axis=0).max() / 2.4)
        )
        if column == 1:
            for part in structure.parts:
                line = points[list(part.vertices)]
                space.plot(*line.T, color=COLOURS[part.family], linewidth=1.6)
        else:
            sides = np.concatenate([some for _, some in near])
            colours = [COLOURS[part.family] for part, some in near for _ in some]
            space.add_collection3d(
                Poly3DCollection(sides, facecolors=colours, linewidths=0, shade=True)
            )
        space.set(**{f"{k}lim": (m - size, m + size) for k, m in zip("xyz", centre, strict=True)})
        space.view_init(height, -65)
        space.set_axis_off()
    figure.subplots_adjust(0, 0, 1, 1, 0, 0)
    figure.savefig(THIRD)


def main() -> None:
    """Print the rows, write picture and page."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--third", action="store_true")
    options = parser.parse_args()
    draw_third()
    if options.third:
        return
    structures = [make(*example) for example in EXAMPLES]
    rows = [row(example[0], made) for example, made in zip(EXAMPLES, structures, strict=True)]
    print("\n".join(rows))
    draw(structures)
    if options.write:
        page = ROOT / "docs" / "fabrication.md"
        lines = page.read_text(encoding="utf-8").splitlines()
        end = lines.index(MARK)
        names = tuple(f"| {example[0]}," for example in EXAMPLES)
        kept = [line for line in lines[:end] if not line.startswith(names)]
        page.write_text("\n".join([*kept, *rows, *lines[end:]]) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
