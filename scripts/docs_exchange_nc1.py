"""Picture of docs/exchange.md: a bar as a reader of the standard takes it out of its NC1 file.

Run with the project's Python:  python scripts/docs_exchange_nc1.py
Needs the packages of requirements-dev.txt.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
import small_pictures
from matplotlib import pyplot as plt
from matplotlib.axes import Axes

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from freecad_ortho import api  # noqa: E402
from freecad_ortho.fabrication import Structure  # noqa: E402
from tests.fabrication.nc1_reader import Piece, read_nc1  # noqa: E402

NET = ROOT / "examples" / "data" / "demo_roof.obj"
PICTURE = ROOT / "docs" / "pictures" / "exchange" / "nc1.png"
FACES = {"o": "from above (o)", "v": "from the front (v)", "u": "from below (u)"}
INK, STEEL = "#26292f", "#c9cfd8"
# Between faces, and how far of each end is drawn, mm.
APART, END = 60.0, 330.0


def main() -> int:
    """Write the files, read them back and draw the two ends of a bar."""
    loaded = api.read_mesh(NET)
    net = api.optimise(loaded.mesh, "principal").mesh
    figure, axes = plt.subplots(figsize=(8, 4.8), dpi=100)
    with tempfile.TemporaryDirectory() as name:
        bars = api.fabricate(net, "beams", section="IPE200", unit=loaded.unit)
        bar = mitred(written(bars, Path(name) / "bars"))
    of_bar(axes, bar)
    figure.tight_layout()
    small_pictures.save(figure, PICTURE, 32)
    return 0


def written(structure: Structure, folder: Path) -> list[Piece]:
    """What is read from the files of a structure."""
    api.write_fabrication(structure, folder, project="demo roof", write="nc1")
    return [read_nc1(path) for path in sorted((folder / "nc1").glob("*.nc1"))]


def mitred(pieces: list[Piece]) -> Piece:
    """The one whose upper flange is set back most on both sides of its start."""

    def set_back(piece: Piece) -> float:
        if not piece.faces("o"):
            return 0.0
        x, y = np.array(piece.faces("o")[0])[:, :2].T
        return min(x[y <= y.min() + 1].min(), x[y >= y.max() - 1].min()) - x.min()

    return max(pieces, key=set_back)


def of_bar(axes: Axes, piece: Piece) -> None:
    """Draw the faces below each other, the middle of the bar left out."""
    cut = piece.length - 2 * END
    top = 0.0
    for face, words in FACES.items():
        (rows,) = piece.faces(face)
        points = np.array(rows)[:, :2]
        high = points[:, 1].max()
        points[:, 1] += top - high
        # What is beyond the first end is moved towards it.
        points[:, 0] -= np.where(points[:, 0] > piece.length / 2, cut, 0.0)
        axes.fill(*points.T, fc=STEEL, ec=INK, lw=1.2)
        axes.text(-25, top - high / 2, words, ha="right", va="center", color=INK)
        top -= high + APART
    axes.axvspan(END - 9, END + 9, color="white", zorder=3)
    title = f"{piece.words[3]}, {piece.words[6]}: {piece.length:.2f} mm, the middle left out"
    axes.set_title(title, fontsize=11, color=INK)
    axes.set_aspect("equal")
    axes.axis("off")


if __name__ == "__main__":
    sys.exit(main())
