"""PDF: a label for each part, with its name, sizes, neighbours, and a QR code of the name."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from pathlib import Path
from typing import Any

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.production import Production

# For a label of 70 x 36 mm, with which the others grow and shrink: margin and side of the code, mm,
# sizes of texts, points, of which the least can still be read.
_LABEL = (70.0, 36.0)
_MARGIN, _CODE = 3.5, 24.0
_NAME, _TEXT, _BESIDE, _PROJECT, _LEAST = 20.0, 7.0, 6.0, 5.0, 4.5
# A code grows to this, mm.
_LARGEST_CODE = 40.0
# Height of a line of text for each point of it, and the depth of letters below it, mm.
_LINE, _DEPTH = 0.48, 0.1
_NEIGHBOURS = 6


def write_labels(
    path: Path, production: Production, project: str, say: Callable[[float], None]
) -> None:
    """Write a label for each part, on pages as ``Workshop.label_form`` has them.

    Args:
        path: file to write.
        production: of the structure.
        project: its name, on every label.
        say: called with the fraction done; may raise to stop.

    Raises:
        OSError: the file cannot be written.
    """
    from reportlab.lib.units import mm
    from reportlab.pdfgen.canvas import Canvas

    # Invariant: no clock, the same structure gives the same file.
    form = production.workshop.label_form
    width, height = form.paper
    canvas = Canvas(str(path), pagesize=(width * mm, height * mm), invariant=1)
    canvas.setTitle(project or "labels")
    canvas.setCreator("freecad_ortho")
    parts, places = production.structure.parts, production.places
    neighbours = _neighbours(production)
    for number, part in enumerate(parts):
        if number % form.count == 0:
            say(number / len(parts))
            if number:
                canvas.showPage()
        x, y = form.corner(number % form.count)
        canvas.saveState()
        canvas.translate(x * mm, y * mm)
        texts = _texts(part, places.get(part.name, ""))
        _label(canvas, form.size, part.name, texts, neighbours[part.name], project)
        canvas.restoreState()
    canvas.save()


def _neighbours(production: Production) -> dict[str, list[str]]:
    """Parts of the same kind that meet a part at its nodes, in the order of the nodes."""
    kinds = {part.name: part.kind for part in production.structure.parts}
    found: dict[str, list[str]] = defaultdict(list)
    for node in production.nodes:
        for name in node.parts:
            found[name] += [
                other
                for other in node.parts
                if other != name and kinds[other] == kinds[name] and other not in found[name]
            ]
    return found


def _texts(part: Part, place: str) -> list[str]:
    """What is said about a part, a line each."""
    size = f"{part.length:.0f} x {part.width:.0f} x {part.thickness:g} mm"
    line = f"line {part.family}{part.line}" if part.line is not None else ""
    seen = part.pattern.seen if part.pattern is not None else ""
    lines = [
        f"{part.kind}, {part.material.name}",
        f"{size}, {part.mass:.1f} kg",
        ", ".join(word for word in (line, f"from {place}" if place else "") if word),
        f"side with marks: {seen}" if seen else "",
    ]
    return [text for text in lines if text]


def _label(
    canvas: Any,
    size: tuple[float, float],
    name: str,
    texts: list[str],
    neighbours: list[str],
    project: str,
) -> None:
    """One label, its lower left corner at zero; lines that have no room are left out."""
    width, height = size
    scale = min(width / _LABEL[0], height / _LABEL[1])
    margin = min(_MARGIN * scale, _MARGIN)
    code = min(_CODE * scale, _LARGEST_CODE)
    _code(canvas, name, (width - code - margin, height - code - margin), code)
    room = width - code - 2.5 * margin
    low = margin + _LINE * max(_PROJECT * scale, _LEAST)
    _line(canvas, project, (margin, margin), max(_PROJECT * scale, _LEAST), width - 2 * margin)
    beside = ", ".join(neighbours[:_NEIGHBOURS]) + (" ..." if len(neighbours) > _NEIGHBOURS else "")
    if beside:
        points = max(_BESIDE * scale, _LEAST)
        # Below the code it has the label's width.
        below = low + _LINE * points <= height - code - margin
        free = width - 2 * margin if below else room
        _line(canvas, f"beside {beside}", (margin, low), points, free)
        low += _LINE * points
    points = _NAME * scale
    level = height - margin - 0.75 * _LINE * points
    _line(canvas, name, (margin, level), points, room, bold=True)
    points = max(_TEXT * scale, _LEAST)
    level -= 1.35 * _LINE * points
    for text in texts:
        if level < low + _DEPTH * points:
            break
        _line(canvas, text, (margin, level), points, room)
        level -= _LINE * points


def _code(canvas: Any, text: str, corner: tuple[float, float], side: float) -> None:
    """A QR code (ISO/IEC 18004) with its lower left corner, mm; its dark cells in one path."""
    from reportlab.graphics.barcode.qrencoder import QRCode, QRErrorCorrectLevel
    from reportlab.lib.units import mm

    code = QRCode(None, QRErrorCorrectLevel.M)
    code.addData(text)
    code.make()
    count = code.getModuleCount()
    cell = side * mm / count
    x, y = corner
    path = canvas.beginPath()
    for row in range(count):
        for column in range(count):
            if code.isDark(row, column):
                path.rect(x * mm + column * cell, y * mm + (count - 1 - row) * cell, cell, cell)
    canvas.drawPath(path, stroke=0, fill=1)


def _line(
    canvas: Any,
    text: str,
    start: tuple[float, float],
    size: float,
    room: float,
    bold: bool = False,
) -> None:
    """A line of text, smaller where it needs more room than there is; mm, points."""
    from reportlab.lib.units import mm

    font = "Helvetica-Bold" if bold else "Helvetica"
    # The fonts that every reader has know Latin-1 only.
    plain = text.encode("latin-1", "replace").decode("latin-1")
    wide = canvas.stringWidth(plain, font, size)
    canvas.setFont(font, size * min(1.0, room * mm / max(wide, 1e-9)))
    canvas.drawString(start[0] * mm, start[1] * mm, plain)
