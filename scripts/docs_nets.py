"""Makes the pictures and the table of numbers of docs/nets.md: every net before and after.

Run with the project's Python:
    python scripts/docs_nets.py [--write] [NAME ...]

``--write`` puts the table into docs/nets.md. Meshes of the paper's authors are used where they lie
beside the repository, a mesh by formula takes the place of one that is missing.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from bench import ROOT, write
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import ListedColormap, LogNorm

sys.path.insert(0, str(ROOT))

from freecad_ortho import api
from solver import Constraints, NetOptions, QuadMesh, optimise
from solver.analysis import measures
from solver.mesh.primitives import primitive
from solver.nets import NETS, Net
from solver.report import CONVERGED, Outcome
from solver.statics import VerticalLoads, start_densities, unbalanced
from tests.conftest import SHARED, demo_roof, wavy_grid
from tests.meshes import (
    bent_sheet,
    constant_ratio,
    deformed,
    freeform_roof,
    freeform_saddle,
    hanging_net,
    helicoid,
    noisy,
    scherk,
    unduloid,
)

PICTURES = ROOT / "docs" / "pictures" / "nets"
CLEAN, INK, GREY = "#9fc3e6", "#26292f", "#d9dde2"
LEAST, MOST = 1e-3, 1.0
WARM = ListedColormap(plt.get_cmap("YlOrRd")(np.linspace(0.0, 0.8, 12)))
LIGHT = np.array([0.35, -0.45, 0.82])
Measure = Callable[[QuadMesh], np.ndarray]


@dataclass(frozen=True)
class View:
    """A mesh to show a net on, and where to look from (turn and tilt in degrees).

    ``measured`` is for nets that a bare mesh is not judged by, ``options`` for what a net is told.
    """

    what: str
    start: Callable[[], QuadMesh]
    turn: float = -60.0
    tilt: float = 35.0
    measured: tuple[Measure, ...] = ()
    handles: Callable[[QuadMesh], dict[int, np.ndarray]] | None = None
    options: Mapping[str, float | str] = field(default_factory=dict)


@dataclass(frozen=True)
class Example:
    """A net, or its diagonal variant, as it is shown."""

    net: Net
    diagonal: bool
    view: View

    @property
    def name(self) -> str:
        """What the command line asks for."""
        return f"{self.net.name} --diagonal" if self.diagonal else self.net.name

    @property
    def picture(self) -> Path:
        """File of the picture."""
        return PICTURES / f"{self.name.replace(' --', '-')}.png"

    @property
    def measured(self) -> tuple[Measure, ...]:
        """By what its faces are coloured: what the net is judged by, as its table says."""
        of_net = tuple(partial(one.on, diagonal=self.diagonal) for one in self.net.measures)
        return (*of_net, *self.view.measured)


def paper(name: str, other: Callable[[], QuadMesh]) -> QuadMesh:
    """A mesh of the paper's authors, or another one where it is missing."""
    path = SHARED / f"{name}.obj"
    if path.is_file():
        return api.read_mesh(path).mesh
    print(f"{path.name} is missing, a mesh by formula is used")
    return other()


def imbalance(mesh: QuadMesh) -> np.ndarray:
    """(V,) force left at each free vertex over the mean load, with the best forces in the edges."""
    net = mesh.connectivity
    supports = net.boundary_vertices
    free = np.flatnonzero(~supports & net.referenced)
    points = (mesh.vertices - mesh.vertices.mean(axis=0)) / mesh.mean_edge
    loads = VerticalLoads(net, per_vertex=1.0).at(points.ravel())
    densities = start_densities(net, points, loads, supports, 0)
    left = np.full(len(points), np.nan)
    left[free] = unbalanced(net, points, densities, loads, free)
    return left


def two_corners(mesh: QuadMesh) -> dict[int, np.ndarray]:
    """Two opposite corners of a sheet, lifted and drawn together."""
    corners = np.flatnonzero(mesh.connectivity.corners)
    middle, size = mesh.vertices.mean(axis=0), np.ptp(mesh.vertices[:, 0])
    targets = {}
    for corner in (corners[0], corners[-1]):
        place = mesh.vertices[corner]
        targets[int(corner)] = place + 0.18 * (middle - place) + [0, 0, 0.3 * size]
    return targets


def flat_sheet() -> QuadMesh:
    """A level rectangle of squares."""
    return primitive("rectangle", 19, 15, length=4.5, width=3.5)


def sheared(mesh: QuadMesh) -> QuadMesh:
    """The mesh pushed sideways, so that its lines are not at right angles."""
    push = np.zeros_like(mesh.vertices)
    push[:, 0] = 0.25 * mesh.vertices[:, 1]
    return mesh.with_vertices(mesh.vertices + push)


# How a net is shown that has no view of its own.
OTHER = View("waved shell", lambda: deformed(primitive("translational", 21, 15), 0.04))
VIEWS = {
    "orthogonal": View("sheared wave", lambda: wavy_grid(24, 17, 0.25, 0.3), turn=-20),
    "isogonal": View("sheared roof", lambda: sheared(freeform_roof())),
    "principal": View("demo roof", demo_roof),
    "planar": View("waved shell", lambda: deformed(primitive("translational", 21, 15), 0.02)),
    "circular": View("waved catenoid", lambda: deformed(primitive("catenoid", 33, 15)), tilt=25),
    "isothermic": View("waved shell", lambda: deformed(primitive("translational", 21, 15), 0.04)),
    "geodesic": View(
        "waved cylinder", lambda: deformed(primitive("cylinder", 25, 15, angles=(0, 200)), 0.08)
    ),
    "dog": View("noisy sheet", lambda: noisy(bent_sheet())),
    "chebyshev": View(
        "chebyshev_sphere", lambda: paper("chebyshev_sphere", lambda: noisy(bent_sheet()))
    ),
    "geodesic-chebyshev": View("noisy sheet", lambda: noisy(bent_sheet())),
    "asymptotic": View("knet1", lambda: paper("knet1", lambda: noisy(scherk()))),
    "asymptotic --diagonal": View(
        "complete01", lambda: paper("complete01", lambda: noisy(helicoid())), turn=-60, tilt=30
    ),
    "asymptotic-angle": View(
        "waved funnel", lambda: deformed(constant_ratio(31, 27, 0.5, 2.0), 0.05), turn=-40, tilt=25
    ),
    "pseudo-geodesic": View(
        "freeform roof, 60 degrees", freeform_roof, options={"tilt_u": 60.0, "tilt_v": 60.0}
    ),
    "web": View(
        "freeform saddle",
        freeform_saddle,
        turn=-55,
        tilt=40,
    ),
    "planar-lines": View("demo roof, both families", demo_roof, options={"plane": "both"}),
    "cmc": View("cmc1", lambda: paper("cmc1", lambda: noisy(unduloid()))),
    "snet": View("sheared dome", lambda: sheared(primitive("translational", 19, 19))),
    "stress": View(
        "quad_dome",
        lambda: paper("quad_dome", hanging_net),
        measured=(measures.orthogonality, imbalance),
    ),
    "isometric": View(
        "flat sheet, two handles",
        flat_sheet,
        measured=(partial(measures.isometry, reference=flat_sheet().vertices),),
        handles=two_corners,
    ),
}


def examples() -> Iterator[Example]:
    """Every net of the table, and those diagonal variants that have a picture of their own."""
    for net in NETS.values():
        yield Example(net, False, VIEWS.get(net.name, OTHER))
        if f"{net.name} --diagonal" in VIEWS:
            yield Example(net, True, VIEWS[f"{net.name} --diagonal"])


def on_faces(mesh: QuadMesh, values: np.ndarray) -> np.ndarray:
    """(F,) worst value at a face; values belong to faces, edges, stars or vertices."""
    net = mesh.connectivity
    if len(values) == len(mesh.faces):
        return values
    spread = np.full(len(mesh.vertices), np.nan)
    if len(values) == len(net.stars):
        spread[net.stars[:, 0]] = values
    elif len(values) == len(spread):
        spread = values
    else:
        for end in net.edges.T:
            np.fmax.at(spread, end, values)
    return np.fmax.reduce(spread[mesh.faces], axis=1)


def worst_on_faces(mesh: QuadMesh, measured: tuple[Measure, ...]) -> np.ndarray:
    """(F,) worst of all measures of a net at each face."""
    return np.fmax.reduce([on_faces(mesh, measure(mesh)) for measure in measured])


def solve(example: Example) -> tuple[QuadMesh, Outcome]:
    """Start and outcome of an example."""
    start = example.view.start()
    wanted = None
    if example.view.handles is not None:
        wanted = Constraints(handles=example.view.handles(start))
    options = NetOptions(diagonal=example.diagonal, **example.view.options)
    outcome = optimise(start, example.net.name, options=options, constraints=wanted)
    if outcome.report.status != CONVERGED:
        sys.exit(f"{example.name}: {outcome.report.message}")
    return start, outcome


def camera(turn: float, tilt: float) -> np.ndarray:
    """(3, 3) rows: right, up and towards the eye."""
    a, b = np.radians([turn, tilt])
    towards = np.array([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    return np.stack([right, np.cross(towards, right), towards])


def shade(mesh: QuadMesh, colours: np.ndarray) -> np.ndarray:
    """Colours darkened where a face turns away from the light."""
    light = np.abs(mesh.face_normals @ (LIGHT / np.linalg.norm(LIGHT)))
    shaded = colours.copy()
    shaded[:, :3] *= (0.72 + 0.28 * light)[:, None]
    return shaded


def draw(axes: Axes, mesh: QuadMesh, view: np.ndarray, colours: np.ndarray) -> None:
    """Draw the faces, the far ones first."""
    seen = (mesh.vertices - mesh.vertices.mean(axis=0)) @ view.T
    order = np.argsort(seen[mesh.faces, 2].mean(axis=1))
    axes.add_collection(
        PolyCollection(
            seen[mesh.faces[order], :2],
            facecolors=shade(mesh, colours)[order],
            edgecolors=INK,
            linewidths=0.6,
            joinstyle="round",
        )
    )


def draw_forces(axes: Axes, mesh: QuadMesh, view: np.ndarray, densities: list[float]) -> None:
    """Draw edges as thick as their force is large."""
    seen = (mesh.vertices - mesh.vertices.mean(axis=0)) @ view.T
    forces = np.abs(densities) * mesh.edge_lengths
    widths = 0.6 + 5.0 * forces / forces.max()
    ends = mesh.connectivity.edges
    outwards = np.sign(((seen @ view) * mesh.vertex_normals).sum())
    front = outwards * (mesh.vertex_normals[ends].sum(axis=1) @ view[2]) > 0
    axes.add_collection(
        LineCollection(
            seen[ends[front], :2],
            linewidths=widths[front],
            colors=np.where(np.array(densities)[front] < 0, "#b81a26", "#3055a4"),
            capstyle="round",
        )
    )


def picture(example: Example, start: QuadMesh, outcome: Outcome) -> None:
    """Write the picture of a net before and after."""
    view = camera(example.view.turn, example.view.tilt)
    before = worst_on_faces(start, example.measured)
    after = worst_on_faces(outcome.mesh, example.measured)
    scale = ScalarMappable(LogNorm(LEAST, MOST), WARM)
    coloured = scale.to_rgba(np.clip(np.nan_to_num(before, nan=LEAST), LEAST, MOST))
    if example.view.handles:
        coloured[:] = matplotlib.colors.to_rgba(GREY)
    clean = np.tile(matplotlib.colors.to_rgba(CLEAN), (len(after), 1))

    figure, sides = plt.subplots(1, 2, figsize=(12, 5), dpi=100)
    both = [(start.vertices - start.vertices.mean(axis=0)) @ view.T]
    both.append((outcome.mesh.vertices - outcome.mesh.vertices.mean(axis=0)) @ view.T)
    low, high = np.min([p.min(axis=0) for p in both], 0), np.max([p.max(axis=0) for p in both], 0)
    room = 0.03 * (high - low).max()
    for axes, mesh, colours in zip(sides, (start, outcome.mesh), (coloured, clean), strict=True):
        draw(axes, mesh, view, colours)
        axes.set(xlim=(low[0] - room, high[0] + room), ylim=(low[1] - room, high[1] + room))
        axes.set_aspect("equal")
        axes.set_axis_off()
    if "force_densities" in outcome.report.details:
        draw_forces(sides[1], outcome.mesh, view, outcome.report.details["force_densities"])
    if example.view.handles is not None:
        targets = np.array(list(example.view.handles(start).values()))
        places = (targets - outcome.mesh.vertices.mean(axis=0)) @ view.T
        sides[1].plot(places[:, 0], places[:, 1], "o", color="#b81a26", markersize=7)
    figure.subplots_adjust(0.01, 0.13, 0.99, 0.99, wspace=0.03)
    if not example.view.handles:
        bar = figure.colorbar(
            scale,
            cax=figure.add_axes((0.15, 0.075, 0.21, 0.022)),
            orientation="horizontal",
            extend="both",
        )
        bar.ax.tick_params(labelsize=9, colors=INK)
        bar.outline.set_linewidth(0.5)
    words = dict(ha="center", fontsize=12, color=INK)
    left = "before" if example.view.handles else f"before: worst {np.nanmax(before):.1g}"
    figure.text(0.255, 0.115, left, **words)
    figure.text(0.745, 0.115, f"after: worst {residual(outcome):.0e}", **words)
    PICTURES.mkdir(parents=True, exist_ok=True)
    figure.savefig(example.picture, pil_kwargs={"optimize": True})
    plt.close(figure)
    shrink(example.picture)


def shrink(path: Path) -> None:
    """Reduce a picture to 256 colours, which flat shading does not miss."""
    from PIL import Image

    with Image.open(path) as image:
        small = image.convert("RGB").quantize(
            256, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE
        )
    small.save(path, optimize=True)


def residual(outcome: Outcome) -> float:
    """Largest residual of all measures of the net."""
    return max(spread.max for spread in outcome.report.residuals.values())


def row(example: Example, start: QuadMesh, outcome: Outcome) -> str:
    """Row of the table."""
    report = outcome.report
    before = float(np.nanmax(worst_on_faces(start, example.measured)))
    return (
        f"| {example.name} | {example.view.what} | {report.vertices:,} | {before:.1g} "
        f"| {residual(outcome):.0e} | {report.iterations} "
        f"| {report.moved.mean:.2f}, {report.moved.max:.2f} "
        f"| {report.edge_ratio_start:.2f} -> {report.edge_ratio:.2f} |"
    )


def main() -> None:
    """Make pictures and table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", action="store_true", help="update docs/nets.md")
    parser.add_argument("names", nargs="*", metavar="NAME", help="only these nets")
    options = parser.parse_args()
    lines = [
        "| net | mesh | V | worst before | worst after | steps | moved: mean, largest "
        "| edge ratio |",
        "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |",
    ]
    for example in examples():
        if options.names and example.picture.stem not in options.names:
            continue
        start, outcome = solve(example)
        picture(example, start, outcome)
        lines.append(row(example, start, outcome))
        print(lines[-1], flush=True)
    if options.write and not options.names:
        write(ROOT / "docs" / "nets.md", "examples", "\n".join(lines))


if __name__ == "__main__":
    main()
