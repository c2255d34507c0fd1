"""Put the pictures that FreeCAD rendered together: result, start, colour scale, title."""

from __future__ import annotations

from pathlib import Path

import matplotlib
import numpy as np
from PIL import Image, ImageChops, ImageDraw, ImageFont

from freecad_ortho.view.colours import palette
from solver.analysis import measures
from solver.mesh.quadmesh import QuadMesh

SIZE = (1600, 1000)
INSET = (512, 320)
# The main view is pasted a little smaller, low on the sheet: the title goes above it.
MAIN = (1440, 900)
MARGIN = 48
INK = (38, 43, 51)
GREY = (110, 118, 128)
LOWEST_DECADE, HIGHEST_DECADE = -8, -1


def compose(target: Path, pictures: dict[str, Path], drawn: QuadMesh, principal: QuadMesh) -> None:
    """Write the preview.

    Args:
        target: PNG to write.
        pictures: rendered views, white background: ``after`` fills the sheet, ``before`` is the
            inset.
        drawn: the mesh as it came.
        principal: the optimised mesh.
    """
    sheet = Image.new("RGB", SIZE, "white")
    paste(sheet, pictures["after"], MAIN, ((SIZE[0] - MAIN[0]) // 2, SIZE[1] - MAIN[1]))
    corner = (SIZE[0] - MARGIN - INSET[0], MARGIN)
    paste(sheet, pictures["before"], INSET, corner)
    draw = ImageDraw.Draw(sheet)
    title = f"{len(principal.faces)} flat panels on torsion-free beams"
    draw.text((MARGIN, MARGIN), title, font=font(34, bold=True), fill=INK)
    lines = [f"{name}: {worst(mesh)}" for name, mesh in (("as drawn", drawn), ("built", principal))]
    draw.text((MARGIN, MARGIN + 52), "\n".join(lines), font=font(20), fill=GREY, spacing=8)
    end = (corner[0] + INSET[0], corner[1])
    draw.text(end, "as drawn", font=font(22, bold=True), fill=INK, anchor="ra")
    scale(sheet, draw)
    sheet.save(target, optimize=True)


def paste(sheet: Image.Image, path: Path, size: tuple[int, int], corner: tuple[int, int]) -> None:
    """Lay a picture on the sheet; its white ground covers nothing."""
    with Image.open(path) as picture:
        small = picture.convert("RGB").resize(size, Image.Resampling.LANCZOS)
    box = (*corner, corner[0] + size[0], corner[1] + size[1])
    sheet.paste(ImageChops.darker(sheet.crop(box), small), box)


def worst(mesh: QuadMesh) -> str:
    """Name the worst face of a mesh by both measures."""
    planarity, orthogonality = measures.planarity(mesh).max(), measures.orthogonality(mesh).max()
    return f"worst planarity {planarity:.1e}, worst orthogonality {orthogonality:.1e}"


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
