"""PDF: a label for each part, with its name, sizes, neighbours, and a QR code of the name."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from pathlib import Path
from typing import Any

from freecad_ortho.fabrication.part import Part
from freecad_ortho.fabrication.production import Production

# A4 with three columns of eight labels, mm: 70 x 36 as office suppliers sell them, no margins at
# the sides, 4.5 above and below.
_PAGE, _LABEL, _TOP = (210.0, 297.0), (70.0, 36.0), 4.5
_COLUMNS, _ROWS = 3, 8
_MARGIN, _CODE = 3.5, 24.0
_NEIGHBOURS = 6


def write_labels(
    path: Path, production: Production, project: str, say: Callable[[float], None]
) -> None:
    """Write a page of labels to be printed for every 24 parts.

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
    canvas = Canvas(str(path), pagesize=(_PAGE[0] * mm, _PAGE[1] * mm), invariant=1)
    canvas.setTitle(project or "labels")
    canvas.setCreator("freecad_ortho")
    parts, places = production.structure.parts, production.places
    neighbours = _neighbours(production)
    a_page = _COLUMNS * _ROWS
    for number, part in enumerate(parts):
        if number % a_page == 0:
            say(number / len(parts))
            if number:
                canvas.showPage()
        row, column = divmod(number % a_page, _COLUMNS)
        canvas.saveState()
        canvas.translate(column * _LABEL[0] * mm, (_PAGE[1] - _TOP - (row + 1) * _LABEL[1]) * mm)
        _label(canvas, part, neighbours[part.name], places.get(part.name, ""), project)
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


def _label(canvas: Any, part: Part, neighbours: list[str], place: str, project: str) -> None:
    _code(canvas, part.name, _LABEL[0] - _CODE - _MARGIN, _LABEL[1] - _CODE - _MARGIN)
    room = _LABEL[0] - _CODE - 2.5 * _MARGIN
    _line(canvas, part.name, _LABEL[1] - 10, 20, room, bold=True)
    size = f"{part.length:.0f} x {part.width:.0f} x {part.thickness:g} mm"
    line = f"line {part.family}{part.line}" if part.line is not None else ""
    seen = part.pattern.seen if part.pattern is not None else ""
    lines = [
        f"{part.kind}, {part.material.name}",
        f"{size}, {part.mass:.1f} kg",
        ", ".join(word for word in (line, f"from {place}" if place else "") if word),
        f"side with marks: {seen}" if seen else "",
    ]
    height = _LABEL[1] - 14.5
    for text in filter(None, lines):
        _line(canvas, text, height, 7, room)
        height -= 3.4
    beside = ", ".join(neighbours[:_NEIGHBOURS]) + (" ..." if len(neighbours) > _NEIGHBOURS else "")
    if beside:
        _line(canvas, f"beside {beside}", 6.5, 6, _LABEL[0] - 2 * _MARGIN)
    _line(canvas, project, 3.5, 5, _LABEL[0] - 2 * _MARGIN)


def _code(canvas: Any, text: str, x: float, y: float) -> None:
    """A QR code (ISO/IEC 18004) with its corner at x and y, mm; its dark cells in one path."""
    from reportlab.graphics.barcode.qrencoder import QRCode, QRErrorCorrectLevel
    from reportlab.lib.units import mm

    code = QRCode(None, QRErrorCorrectLevel.M)
    code.addData(text)
    code.make()
    count = code.getModuleCount()
    cell = _CODE * mm / count
    path = canvas.beginPath()
    for row in range(count):
        for column in range(count):
            if code.isDark(row, column):
                path.rect(x * mm + column * cell, y * mm + (count - 1 - row) * cell, cell, cell)
    canvas.drawPath(path, stroke=0, fill=1)


def _line(
    canvas: Any, text: str, height: float, size: float, room: float, bold: bool = False
) -> None:
    """A line of text, smaller where it needs more room than there is; mm, points."""
    from reportlab.lib.units import mm

    font = "Helvetica-Bold" if bold else "Helvetica"
    # The fonts that every reader has know Latin-1 only.
    plain = text.encode("latin-1", "replace").decode("latin-1")
    wide = canvas.stringWidth(plain, font, size)
    canvas.setFont(font, size * min(1.0, room * mm / max(wide, 1e-9)))
    canvas.drawString(_MARGIN * mm, height * mm, plain)
