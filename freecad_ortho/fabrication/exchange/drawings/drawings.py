"""The set of drawings: a plan, sheets that plates are cut from, typical node and parts, holes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from freecad_ortho.fabrication.drawing_form import PAPERS
from freecad_ortho.fabrication.exchange.drawings.cut_sheets import sheet_page
from freecad_ortho.fabrication.exchange.drawings.hole_detail import hole_pages
from freecad_ortho.fabrication.exchange.drawings.node_detail import node_page
from freecad_ortho.fabrication.exchange.drawings.page import Page, draw_page
from freecad_ortho.fabrication.exchange.drawings.part_detail import part_page, typical_parts
from freecad_ortho.fabrication.exchange.drawings.pen import Pen
from freecad_ortho.fabrication.exchange.drawings.plan_view import plan_view_pages
from freecad_ortho.fabrication.production import Production


def write_drawings(
    path: Path, production: Production, project: str, say: Callable[[float], None]
) -> None:
    """Write one file with all pages.

    Args:
        path: file to write.
        production: of the structure.
        project: its name, in every title block.
        say: called with the fraction done; may raise to stop.

    Raises:
        OSError: the file cannot be written.
    """
    from reportlab.lib.units import mm
    from reportlab.pdfgen.canvas import Canvas

    form = production.workshop.drawing_form
    pages = _pages(production, lambda done: say(0.5 * done))
    width, height = PAPERS[form.paper]
    # Invariant: no clock, the same structure gives the same file.
    canvas = Canvas(str(path), pagesize=(width * mm, height * mm), invariant=1)
    canvas.setTitle(project or "drawings")
    canvas.setCreator("freecad_ortho")
    for number, page in enumerate(pages, start=1):
        say(0.5 + 0.5 * number / len(pages))
        draw_page(Pen(canvas), page, form, project, number, len(pages))
        canvas.showPage()
    canvas.save()


def _pages(production: Production, say: Callable[[float], None]) -> list[Page]:
    form = production.workshop.drawing_form
    pages = plan_view_pages(production, form)
    say(0.1)
    pages += [sheet_page(sheet, form) for sheet in production.sheets]
    say(0.2)
    pages += node_page(production, form)
    parts = typical_parts(production)
    for number, (part, alike) in enumerate(parts):
        say(0.4 + 0.6 * number / len(parts))
        pages.append(part_page(production, form, part, alike))
    return pages + hole_pages(production, form)
