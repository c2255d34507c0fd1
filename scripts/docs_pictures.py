"""Makes the pictures of README.md and docs/ from the results of the demo.

Run with the project's Python:  bash scripts/demo.sh DIR && python scripts/docs_pictures.py DIR
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import ezdxf
import matplotlib
import numpy as np

matplotlib.use("Agg")

import matplotlib.pyplot as plt
from ezdxf.addons.drawing import Frontend, RenderContext
from ezdxf.addons.drawing.config import BackgroundPolicy, Configuration
from ezdxf.addons.drawing.matplotlib import MatplotlibBackend
from matplotlib.axes import Axes
from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from freecad_ortho import api  # noqa: E402
from solver import QuadMesh  # noqa: E402

PICTURES = ROOT / "docs" / "pictures"
INK, BLUE, GREY, RED = "#26292f", "#3055a4", "#8a929e", "#b81a26"
# A patch of the demo's roof for the close view: first row and column, and its size.
PATCH, ROWS, COLUMNS = (3, 2), 3, 4
FACES_ACROSS = 20
BARE = (6, 7, 10, 11)


def main() -> None:
    """Make all pictures."""
    if len(sys.argv) != 2 or not (Path(sys.argv[1]) / "flat.dxf").is_file():
        sys.exit("docs_pictures.py: give the folder that scripts/demo.sh wrote")
    demo = Path(sys.argv[1])
    PICTURES.mkdir(parents=True, exist_ok=True)
    shrink(demo / "preview.png", PICTURES / "demo.png", 1200)
    patterns(demo / "flat.dxf", PICTURES / "flat.png")
    section(PICTURES / "section.png")
    with tempfile.TemporaryDirectory() as folder:
        corner(demo / "principal.obj", Path(folder))


def shrink(source: Path, target: Path, width: int) -> None:
    """Save a picture ``width`` pixels wide."""
    with Image.open(source) as picture:
        size = (width, round(width * picture.height / picture.width))
        small = picture.convert("RGB").resize(size, Image.Resampling.LANCZOS)
    small.save(target, optimize=True)


def patterns(source: Path, target: Path) -> None:
    """Draw two beams and two panels of a DXF file, its layers in their colours."""
    drawing = ezdxf.readfile(source)
    space = drawing.modelspace()
    places = {"B0000": (0, 0), "B0001": (0, -420), "P0000": (1500, -1100), "P0001": (2650, -1100)}
    for insert in list(space):
        if insert.dxf.name in places:
            insert.dxf.insert = places[insert.dxf.name]
        else:
            space.delete_entity(insert)
    figure = plt.figure(figsize=(12, 4), dpi=100)
    axes = figure.add_axes((0, 0, 1, 1))
    drawing.layers.get("CUT").color = 250
    colours = Configuration(background_policy=BackgroundPolicy.WHITE)
    Frontend(RenderContext(drawing), MatplotlibBackend(axes), config=colours).draw_layout(space)
    figure.savefig(target)
    plt.close(figure)


def section(target: Path) -> None:
    """Draw a section through two faces, a beam and two panels with the names of the sizes."""
    figure, axes = plt.subplots(figsize=(10, 4.6), dpi=110)
    axes.set_aspect("equal")
    axes.axis("off")
    slope = np.array([1.0, -0.16])
    slope /= np.linalg.norm(slope)
    for side in (-1, 1):
        along = slope * (side, 1)
        up = np.array([-along[1], along[0]]) * side
        near, far = 20 * along, 420 * along
        base = np.array([0.0, 100.0]) + 6 * up
        plate = [base + near, base + far, base + far + 24 * up, base + near + 24 * up]
        axes.fill(*np.transpose(plate), fc="#9ecbe0", ec=INK, lw=1)
        axes.plot(*np.transpose([(0, 0), far]), color=BLUE, lw=2)
        axes.plot(*np.transpose([(0, 100), far + (0, 100)]), color=GREY, lw=1, ls="--")
    axes.fill([-6, 6, 6, -6], [-100, -100, 100, 100], fc="#94a0b0", ec=INK, lw=1)
    axes.plot([0, 0], [-140, 185], color=RED, lw=1, ls="-.")
    axes.text(0, 192, "plane of the axes", color=RED, ha="center")
    axes.text(430, -72, "net", color=BLUE, va="center")
    axes.text(430, 28, "parallel mesh", color=GREY, va="center")
    size(axes, (-60, -100), (-60, 100), "height", (-70, 40), "right")
    size(axes, (-6, -125), (6, -125), "thickness", (14, -128), "left")
    size(axes, (-23, 152), (23, 152), "gap", (32, 150), "left")
    axes.annotate(
        "lift: until no beam cuts a panel",
        (210, 72),
        (150, -10),
        color=INK,
        arrowprops={"arrowstyle": "->", "color": INK},
    )
    axes.text(-330, 82, "panel", color=INK, ha="center")
    axes.text(14, -70, "beam", color=INK)
    figure.savefig(target, bbox_inches="tight")
    plt.close(figure)


def size(
    axes: Axes,
    start: tuple[float, float],
    end: tuple[float, float],
    name: str,
    place: tuple[float, float],
    side: str,
) -> None:
    """Draw a dimension line and its name."""
    axes.annotate("", end, start, arrowprops={"arrowstyle": "<->", "color": INK, "shrinkA": 0})
    axes.text(*place, name, color=INK, ha=side)


def draw_in_freecad(script: str, order: dict[str, Any], folder: Path, seconds: float) -> None:
    """Run a script that draws in FreeCAD's window, on a screen of its own where there can be one.

    Args:
        script: its name, in this folder.
        order: what it is to draw.
        folder: of FreeCAD's settings.
        seconds: that it may take.
    """
    command = [shutil.which("freecad") or "FreeCAD", str(ROOT / "scripts" / script)]
    if screen := shutil.which("xvfb-run"):
        command = [screen, "-a", "-s", "-screen 0 1400x900x24", *command]
    environment = {
        **os.environ,
        "FREECAD_USER_HOME": str(folder),
        "QTWEBENGINE_DISABLE_SANDBOX": "1",
        "ORTHO_DOCS": json.dumps(order),
    }
    subprocess.run(command, env=environment, check=True, timeout=seconds, stdout=subprocess.DEVNULL)


def corner(principal: Path, folder: Path) -> None:
    """Have FreeCAD draw a patch of the roof from near."""
    mesh = api.read_mesh(principal).mesh
    chosen = [
        (PATCH[0] + row) * FACES_ACROSS + PATCH[1] + column
        for row in range(ROWS)
        for column in range(COLUMNS)
    ]
    used, faces = np.unique(mesh.faces[chosen], return_inverse=True)
    patch = QuadMesh(mesh.vertices[used], faces.reshape(-1, 4))
    api.write_mesh(folder / "patch.obj", patch, "mm")
    order = {
        "paths": [str(ROOT), str(ROOT / "scripts")],
        "mesh": str(folder / "patch.obj"),
        "panels": [number for number in range(len(chosen)) if number not in BARE],
        "picture": str(folder / "corner.png"),
    }
    draw_in_freecad("docs_corner.py", order, folder, seconds=300)
    shrink(folder / "corner.png", PICTURES / "corner.png", 1000)


if __name__ == "__main__":
    main()
