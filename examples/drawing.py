"""Pictures of nets for the gallery; the only part of the examples that needs matplotlib."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from solver import QuadMesh


def draw(
    meshes: Sequence[tuple[str, QuadMesh]], target: str | Path, columns: int = 3, title: str = ""
) -> None:
    """Write a picture of some nets side by side, each with its name."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    rows = -(-len(meshes) // columns)
    figure = pyplot.figure(figsize=(4.2 * columns, 3.6 * rows + 0.3 * bool(title)), dpi=110)
    for place, (name, mesh) in enumerate(meshes, start=1):
        axes = figure.add_subplot(rows, columns, place, projection="3d", proj_type="ortho")
        light = np.abs(mesh.face_normals @ (np.array([0.35, -0.45, 0.82])))
        colours = pyplot.get_cmap("Blues")(0.15 + 0.5 * light)
        faces = Poly3DCollection(
            mesh.vertices[mesh.faces], facecolors=colours, edgecolors="#26303c", linewidths=0.4
        )
        axes.add_collection3d(faces)
        low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
        middle, reach = 0.5 * (low + high), 0.5 * float((high - low).max())
        limits = np.stack([middle - reach, middle + reach], axis=1)
        axes.set(xlim=limits[0], ylim=limits[1], zlim=limits[2])
        axes.set_box_aspect((1, 1, 1), zoom=1.35)
        axes.set_axis_off()
        axes.set_title(name, fontsize=10, y=0.96)
    if title:
        figure.suptitle(title, fontsize=13)
    figure.tight_layout()
    figure.savefig(target)
    pyplot.close(figure)
