"""Pictures of nets for the gallery; the only part of the examples that needs matplotlib."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from solver import QuadMesh

INK, GLASS, NET, MARK = "#1d2935", "#eadfc8", "#5f9fd0", "#e8622a"
WOOD = "#d9a566"
SUN = np.array([0.30, -0.50, 0.81])


@dataclass
class Panel:
    """One net in parallel projection; angles in degrees, lines and points (n, 3) on top.

    A ``mirror`` shows no edges but a striped sky that its faces reflect. ``bodies`` are plane
    polygons (n, 3) of a colour, ``fine`` thin lines on top.
    """

    name: str
    mesh: QuadMesh | None
    turn: float = -60.0
    rise: float = 28.0
    colour: str = NET
    ground: QuadMesh | None = None
    lines: Sequence[np.ndarray] = field(default_factory=list)
    points: np.ndarray | None = None
    mirror: bool = False
    more: Sequence[tuple[QuadMesh, str]] = field(default_factory=list)
    bodies: Sequence[tuple[Sequence[np.ndarray], str]] = field(default_factory=list)
    fine: Sequence[np.ndarray] = field(default_factory=list)


def draw(
    panels: Sequence[Panel],
    target: str | Path,
    columns: int = 3,
    size: float = 4.4,
    high: float = 0.8,
) -> None:
    """Write a picture of some nets side by side, each with its name."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    rows = -(-len(panels) // columns)
    figure, axes = pyplot.subplots(
        rows, columns, figsize=(size * columns, size * high * rows), dpi=110, squeeze=False
    )
    for place, axis in enumerate(axes.flat):
        axis.set_axis_off()
        axis.set_aspect("equal", adjustable="datalim")
        if place < len(panels):
            _fill(axis, panels[place])
    figure.tight_layout(pad=0.6)
    figure.savefig(target)
    pyplot.close(figure)


def _fill(axis: object, panel: Panel) -> None:
    turn, rise = np.radians([panel.turn, panel.rise])
    across = np.array([-np.sin(turn), np.cos(turn), 0.0])
    look = np.array([np.cos(turn) * np.cos(rise), np.sin(turn) * np.cos(rise), np.sin(rise)])
    camera = np.stack([across, np.cross(look, across), look], axis=1)
    if panel.ground is not None:
        _polygons(axis, [_faces(panel.ground, GLASS)], camera, "#cdbd98", 0.35)
    edge = "face" if panel.mirror else INK
    meshes = [(panel.mesh, panel.colour)] if panel.mesh is not None else []
    parts = [*(_faces(*each) for each in [*meshes, *panel.more]), *panel.bodies]
    if parts:
        _polygons(axis, parts, camera, edge, 1.0)
    for line in panel.fine:
        axis.plot(*(line @ camera).T[:2], "-", color=INK, lw=0.8, zorder=7)
    for line in panel.lines:
        axis.plot(*(line @ camera).T[:2], "-", color=MARK, lw=2.2, zorder=8)
    if panel.points is not None:
        places = (panel.points @ camera).T[:2]
        axis.plot(*places, "o", color=MARK, ms=7, mec="white", mew=1.0, zorder=9)
    axis.set_title(panel.name, fontsize=11, color=INK, y=-0.02, va="top")
    axis.autoscale_view()


def _faces(mesh: QuadMesh, colour: str) -> tuple[Sequence[np.ndarray], str]:
    return list(mesh.vertices[mesh.faces]), colour


def _normal(polygon: np.ndarray) -> np.ndarray:
    """Unit normal of a polygon, by the sum of its triangles."""
    arms = polygon[1:] - polygon[0]
    normal = np.cross(arms[:-1], arms[1:]).sum(axis=0)
    return normal / max(float(np.linalg.norm(normal)), 1e-300)


def _polygons(axis: object, parts: list, camera: np.ndarray, edge: str, alpha: float) -> None:
    """Faces from back to front, lit by the sun, the far side a little darker."""
    from matplotlib.collections import PolyCollection
    from matplotlib.colors import to_rgb

    corners = [polygon for polygons, _ in parts for polygon in polygons]
    normals = np.array([_normal(polygon) for polygon in corners])
    base = np.concatenate([np.tile(to_rgb(colour), (len(some), 1)) for some, colour in parts])
    light = 0.62 + 0.45 * np.abs(normals @ SUN)
    light *= np.where(normals @ camera[:, 2] < 0, 0.93, 1.0)
    if edge == "face":
        normals = np.where((normals @ camera[:, 2])[:, None] < 0, -normals, normals)
        sky = 2 * (normals @ camera[:, 2])[:, None] * normals - camera[:, 2]
        light *= 0.72 + 0.28 * np.tanh(4 * np.sin(16 * np.arctan2(sky[:, 0], sky[:, 2] + 0.3)))
    colours = np.clip(base * light[:, None], 0, 1)
    seen = [polygon @ camera for polygon in corners]
    order = np.argsort([polygon[:, 2].mean() for polygon in seen])
    axis.add_collection(
        PolyCollection(
            [seen[k][:, :2] for k in order], facecolors=colours[order], edgecolors=edge,
            linewidths=0.45, alpha=alpha, joinstyle="round", zorder=2 if alpha == 1 else 1,
        )
    )  # fmt: skip
