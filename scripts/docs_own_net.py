"""Makes the picture of docs/own-net.md from the code that stands there.

Run with the project's Python:  python scripts/docs_own_net.py
"""

from __future__ import annotations

import os
import re
import tempfile

import numpy as np
from docs_nets import CLEAN, INK, LEAST, MOST, ROOT, WARM, camera, draw, plt, shrink
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm, to_rgba

from solver import QuadMesh

PICTURE = ROOT / "docs" / "pictures" / "own_net.png"
TURN, TILT = -60.0, 58.0
ROUND = np.linspace(0.0, 2 * np.pi, 49)


def found_by_the_page() -> tuple[QuadMesh, QuadMesh]:
    """Start and result of the first block of code."""
    text = (ROOT / "docs" / "own-net.md").read_text(encoding="utf-8")
    code = re.findall(r"```python\n(.*?)```", text, re.DOTALL)[0]
    names: dict[str, object] = {}
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(ROOT / "examples", f"{folder}/examples")
        os.chdir(folder)
        exec(code, names)
        os.chdir(ROOT)
    return names["roof"], names["outcome"].mesh


def circles(mesh: QuadMesh) -> tuple[np.ndarray, np.ndarray]:
    """(F, n, 3) circles that come nearest to touching the sides, and (F,) how far they miss one.

    Least squares of n_k . p - r over the sides k of a face, n_k across the side in its plane. What
    they miss is in mean edges.
    """
    corners = mesh.vertices[mesh.faces]
    sides = np.roll(corners, -1, axis=1) - corners
    along = sides / np.linalg.norm(sides, axis=2, keepdims=True)
    inwards = np.cross(mesh.face_normals[:, None], along)
    first = along[:, 0]
    second = np.cross(mesh.face_normals, first)
    middle = corners.mean(axis=1)
    drawn, missed = [], []
    for f in range(len(corners)):
        frame = np.stack([first[f], second[f]])
        rows = np.column_stack([inwards[f] @ frame.T, -np.ones(4)])
        reach = np.einsum("ki,ki->k", inwards[f], corners[f] - middle[f])
        (a, b, radius), *_ = np.linalg.lstsq(rows, reach, rcond=None)
        ring = np.stack([a + radius * np.cos(ROUND), b + radius * np.sin(ROUND)], axis=1)
        drawn.append(middle[f] + ring @ frame)
        missed.append(np.abs(rows @ [a, b, radius] - reach).max())
    return np.array(drawn), np.array(missed) / mesh.mean_edge


def side(axes: Axes, mesh: QuadMesh, clean: bool) -> float:
    """Draw a mesh with its circles; return by how much one misses a side at most."""
    view = camera(TURN, TILT)
    rings, missed = circles(mesh)
    scale = ScalarMappable(LogNorm(LEAST, MOST), WARM)
    colours = np.tile(to_rgba(CLEAN), (len(missed), 1))
    if not clean:
        colours = scale.to_rgba(np.clip(missed, LEAST, MOST))
    draw(axes, mesh, view, colours)
    seen = (rings - mesh.vertices.mean(axis=0)) @ view.T
    axes.add_collection(
        PolyCollection(seen[:, :, :2], facecolors="white", edgecolors=INK, linewidths=0.6)
    )
    axes.set_aspect("equal")
    axes.set_axis_off()
    return float(missed.max())


def main() -> None:
    """Make the picture."""
    meshes = found_by_the_page()
    view = camera(TURN, TILT)
    seen = np.vstack([(mesh.vertices - mesh.vertices.mean(axis=0)) @ view.T for mesh in meshes])
    low, high = seen.min(axis=0), seen.max(axis=0)
    room = 0.02 * (high - low).max()
    figure, sides = plt.subplots(1, 2, figsize=(12, 5), dpi=100)
    for axes, mesh, word, place in zip(
        sides, meshes, ("before", "after"), (0.255, 0.745), strict=True
    ):
        worst = side(axes, mesh, word == "after")
        axes.set(xlim=(low[0] - room, high[0] + room), ylim=(low[1] - room, high[1] + room))
        words = f"{word}: a side is missed by up to {worst:.0e} mean edges"
        figure.text(place, 0.03, words, ha="center", fontsize=12, color=INK)
    figure.subplots_adjust(0.01, 0.07, 0.99, 0.99, wspace=0.03)
    figure.savefig(PICTURE, pil_kwargs={"optimize": True})
    plt.close(figure)
    shrink(PICTURE)


if __name__ == "__main__":
    main()
