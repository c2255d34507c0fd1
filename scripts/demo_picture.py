"""Put the pictures that FreeCAD rendered together: result, start, colour scale, title."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import matplotlib
import numpy as np
from PIL import Image, ImageChops, ImageDraw, ImageFont

from freecad_ortho.view.colours import palette
from solver.analysis import measures
from solver.mesh.quadmesh import QuadMesh

SIZE = (1600, 1000)
# The start, as large as there is room beside the result, at least the last of these.
INSETS = ((512, 320), (448, 280), (384, 240), (320, 200))
# The main view is pasted a little smaller, low on the sheet: the title goes above it.
MAIN = (1440, 900)
MARGIN = 48
LABEL = 30
INK = (38, 43, 51)
GREY = (110, 118, 128)
LOWEST_DECADE, HIGHEST_DECADE = -8, -1


class Begin(NamedTuple):
    """What the demo began with.

    Attributes:
        mesh: the mesh as it was drawn, or as it was aligned on a design surface; mm.
        off_surface: how far the exact net is off that surface, mm; None where there is none.
    """

    mesh: QuadMesh
    off_surface: float | None


def compose(
    target: Path, pictures: dict[str, Path], title: str, begin: Begin, net: QuadMesh
) -> None:
    """Write the preview.

    Args:
        target: PNG to write.
        pictures: rendered views, white background: ``after`` fills the sheet, ``before`` is the
            inset.
        title: what was built.
        begin: what it began with.
        net: the optimised mesh.
    """
    sheet = Image.new("RGB", SIZE, "white")
    main = load(pictures["after"], MAIN)
    sheet.paste(main, ((SIZE[0] - MAIN[0]) // 2, SIZE[1] - MAIN[1]))
    draw = ImageDraw.Draw(sheet)
    place_inset(sheet, draw, pictures["before"])
    draw.text((MARGIN, MARGIN), title, font=font(34, bold=True), fill=INK)
    named = "as drawn" if begin.off_surface is None else "along curvature"
    lines = [f"{name}: {worst(mesh)}" for name, mesh in ((named, begin.mesh), ("built", net))]
    if begin.off_surface is not None:
        lines.append(f"off the design surface by {begin.off_surface:.0f} mm at most")
    draw.text((MARGIN, MARGIN + 52), "\n".join(lines), font=font(20), fill=GREY, spacing=8)
    scale(sheet, draw)
    sheet.save(target, optimize=True)


def load(path: Path, size: tuple[int, int]) -> Image.Image:
    """Read a rendered picture and scale it down."""
    with Image.open(path) as picture:
        return picture.convert("RGB").resize(size, Image.Resampling.LANCZOS)


def place_inset(sheet: Image.Image, draw: ImageDraw.ImageDraw, path: Path) -> None:
    """Lay the start into the corner at the right where it covers least of the result."""
    choices = []
    for size in INSETS:
        small = load(path, size)
        for top in (MARGIN + LABEL, SIZE[1] - MARGIN - size[1]):
            left = SIZE[0] - MARGIN - size[0]
            box = (left, top, left + size[0], top + size[1])
            both = ImageChops.lighter(sheet.crop(box), small)
            choices.append((int((np.asarray(both).min(axis=-1) < 250).sum()), small, box))
    _, small, box = min(choices, key=lambda choice: choice[0])
    sheet.paste(ImageChops.darker(sheet.crop(box), small), box)
    label = (box[2], box[1] - LABEL)
    draw.text(label, "as drawn", font=font(22, bold=True), fill=INK, anchor="ra")


def worst(mesh: QuadMesh) -> str:
    """Name the worst face of a mesh by both measures."""
    planarity, orthogonality = measures.planarity(mesh).max(), worst_orthogonality(mesh)
    return f"worst planarity {planarity:.1e}, worst orthogonality {orthogonality:.1e}"


def worst_orthogonality(mesh: QuadMesh) -> float:
    """That of the worst face away from irregular vertices, where there are no right angles."""
    return float(measures.orthogonality(mesh)[~mesh.connectivity.singular_faces].max())


def scale(sheet: Image.Image, draw: ImageDraw.ImageDraw) -> None:
    """Draw the colour scale at the lower left."""
    length, thickness = 420, 18
    left, top = MARGIN, SIZE[1] - MARGIN - 24 - thickness
    bar = (palette(np.linspace(0, 1, length)) * 255).astype(np.uint8)
    sheet.paste(Image.fromarray(np.repeat(bar[None], thickness, axis=0)), (left, top))
    label = "planarity of a face: gap between diagonals / diagonal"
    draw.text((left, top - 30), label, font=font(18), fill=INK)
    decades = np.arange(LOWEST_DECADE, HIGHEST_DECADE + 1)
    for x, decade in zip(np.linspace(left, left + length, len(decades)), decades, strict=True):
        draw.line([(x, top + thickness), (x, top + thickness + 5)], fill=INK)
        draw.text((x, top + thickness + 8), f"1e{decade}", font=font(14), fill=INK, anchor="ma")


def font(size: int, bold: bool = False) -> ImageFont.FreeTypeFont:
    """Load the typeface that comes with matplotlib, so that every machine has it."""
    name = "DejaVuSans-Bold.ttf" if bold else "DejaVuSans.ttf"
    return ImageFont.truetype(Path(matplotlib.get_data_path()) / "fonts" / "ttf" / name, size)
