"""Put the pictures that FreeCAD rendered together: result, start, colour scale, title."""

from __future__ import annotations

from pathlib import Path

import matplotlib
import numpy as np
from PIL import Image, ImageDraw, ImageFont

from freecad_ortho.view.colours import palette
from solver.analysis import measures
from solver.mesh.quadmesh import QuadMesh

SIZE = (1600, 1000)
INSET = (560, 350)
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
    with Image.open(pictures["after"]) as after:
        sheet = after.convert("RGB").resize(SIZE)
    with Image.open(pictures["before"]) as before:
        inset = before.convert("RGB").resize(INSET)
    corner = (SIZE[0] - MARGIN - INSET[0], SIZE[1] - MARGIN - INSET[1])
    # Darker of the two: white grounds vanish, nothing of the result is covered.
    under = sheet.crop((*corner, corner[0] + INSET[0], corner[1] + INSET[1]))
    sheet.paste(Image.fromarray(np.minimum(np.asarray(under), np.asarray(inset))), corner)
    draw = ImageDraw.Draw(sheet)
    title = f"{len(principal.faces)} flat panels on torsion-free beams"
    draw.text((MARGIN, MARGIN), title, font=font(34, bold=True), fill=INK)
    lines = [f"{name}: {worst(mesh)}" for name, mesh in (("as drawn", drawn), ("built", principal))]
    draw.text((MARGIN, MARGIN + 52), "\n".join(lines), font=font(20), fill=GREY, spacing=8)
    draw.text((corner[0], corner[1] - 34), "as drawn", font=font(22, bold=True), fill=INK)
    scale(sheet, draw)
    sheet.save(target, optimize=True)


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
