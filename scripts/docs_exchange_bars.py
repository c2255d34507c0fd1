"""Pictures of docs/exchange.md: boards as a reader takes them out of BTLx; angles of the saw list.

Run with the project's Python:  python scripts/docs_exchange_bars.py
Needs the packages of requirements-dev.txt.
"""

from __future__ import annotations

import re
import sys
import tempfile
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import small_pictures
from matplotlib import pyplot as plt
from matplotlib.axes import Axes

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from freecad_ortho import api  # noqa: E402
from tests.fabrication.btlx_reader import SPACE, plate_of, ring, value  # noqa: E402

NET = ROOT / "examples" / "data" / "demo_roof.obj"
FOLDER = ROOT / "docs" / "pictures" / "exchange"
INK, WOOD, RAW = "#26292f", "#e6d3b1", "#98a2ac"
# Boards that are drawn, one a family, and how much of their start, mm.
BOARDS, START = ("L-U003", "L-V003"), 2300.0
# Of the picture of both sketches: what is between them, and the height of a sketch.
APART, HIGH = 20, 200


def main() -> int:
    """Write the files, read them back, and draw."""
    loaded = api.read_mesh(NET)
    net = api.optimise(loaded.mesh, "principal").mesh
    waist = api.primitive("catenoid", 12, 9, waist=4.0, height=6.0, lines="asymptotic")
    with tempfile.TemporaryDirectory() as name:
        boards_folder, bars_folder = Path(name) / "boards", Path(name) / "bars"
        boards = api.fabricate(
            waist, "lamellas", width=80.0, thickness=18.0, material="plywood", unit="m"
        )
        api.write_fabrication(boards, boards_folder, project="waist", write="btlx")
        root = ElementTree.parse(boards_folder / "structure.btlx").getroot()
        bars = api.fabricate(net, "beams", section="GL24h:80x200", unit=loaded.unit)
        api.write_fabrication(bars, bars_folder, project="demo roof", write="saw")
        page = (bars_folder / "saw-list" / "saw-list.html").read_text(encoding="utf-8")
    of_boards([part for part in root.iter(f"{SPACE}Part") if drawn(part)])
    of_sketches(re.findall(r"<svg[^>]*>(.*?)</svg><figcaption>(.*?)</figcaption>", page))
    return 0


def drawn(part: ElementTree.Element) -> bool:
    """Whether a part is one of those of the picture."""
    return str(part.get("Designation")).startswith(BOARDS)


def of_boards(parts: list[ElementTree.Element]) -> None:
    """Draw the starts of boards below each other, in their raw parts."""
    figure, places = plt.subplots(len(parts), figsize=(10, 0.9 * len(parts)), dpi=100)
    for axes, part in zip(np.atleast_1d(places), parts, strict=True):
        of_board(axes, part)
    figure.tight_layout()
    small_pictures.save(figure, FOLDER / "btlx.png", 32)


def of_board(axes: Axes, part: ElementTree.Element) -> None:
    """Draw what is left of a raw part, its lines and texts, on its reference side 4."""
    length, height, width = (float(str(part.get(name))) for name in ("Length", "Height", "Width"))
    axes.fill(*plate_of(part).exterior.xy, fc=WOOD, ec=INK, lw=1.0)
    axes.plot([0, length, length, 0, 0], [0, 0, height, height, 0], "--", color=RAW, lw=0.9)
    for line in part.iter(f"{SPACE}PenContour"):
        axes.plot(*ring(line[0])[:, :2].T, color=INK, lw=0.8)
    for text in part.iter(f"{SPACE}Text"):
        if len(text) and value(text, "StartX") < START:
            at = value(text, "StartX"), value(text, "StartY")
            words = text.find(f"{SPACE}Text").text
            axes.text(*at, words, fontsize=7, ha="center", va="center", color=INK)
    size = f"{length:.1f} x {height:.1f} x {width:g} mm"
    axes.set_title(f"{part.get('Designation')}: raw part {size}", fontsize=9, color=INK)
    axes.set_aspect("equal")
    axes.set_xlim(-30, START)
    axes.axis("off")


def of_sketches(views: list[tuple[str, str]]) -> None:
    """Put the sketches of the page beside each other in one file."""
    wide = 560
    shapes = "".join(
        f'<g transform="translate({k * (wide + APART)} 0)">{shape}<text x="{wide / 2:.0f}" y="196" '
        f'text-anchor="middle" font-size="14" fill="{RAW}">{title}</text></g>'
        for k, (shape, title) in enumerate(views)
    )
    across = len(views) * (wide + APART) - APART
    (FOLDER / "saw.svg").write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {across} {HIGH}" width="{across}" '
        f'font-family="sans-serif"><rect width="100%" height="100%" fill="#fff"/>{shapes}</svg>\n',
        encoding="utf-8",
    )


if __name__ == "__main__":
    sys.exit(main())
