"""TechDraw pages of flat patterns, to print."""

from __future__ import annotations

import datetime
import json
from pathlib import Path

import FreeCAD

from freecad_ortho.documents.common import transaction
from freecad_ortho.objects import drawings, flat_patterns, places
from solver.errors import InputError

# FreeCAD's own page by its names in versions 0.20, 1.0 and 1.1.
_TEMPLATES = ("A3_LandscapeTD.svg", "A3_Landscape_TD.svg", "ISO/A3_Landscape_TD.svg")
_PAGE = (420.0, 297.0)
# Around the patterns, mm; below them stands the title block.
_MARGIN, _TITLE = 25.0, 48.0
# With more parts than this TechDraw, which looks for hidden lines, holds up every recompute for
# more than a second; the page is drawn as a picture instead.
_MOST_PARTS = 50
# Usual scales, so many to one.
_SCALES = (1, 2, 5, 10, 15, 20, 25, 50, 75, 100, 200, 250, 500, 1000)


def add_drawing_pages(feature: FreeCAD.DocumentObject) -> list[FreeCAD.DocumentObject]:
    """Add a TechDraw page for each sheet of flat patterns, or one where they lie in rows.

    In a window the first page is opened.

    Raises:
        InputError: no flat patterns, or a FreeCAD without TechDraw.
    """
    _refuse_unfit(feature)
    sheets = range(1, feature.SheetCount + 1) if feature.SheetCount > 1 else [0]
    with transaction(feature.Document, FreeCAD.Qt.translate("Ortho", "Drawing pages")):
        pages = [_page(feature, sheet) for sheet in sheets]
        feature.Document.recompute()
    _open(pages[0])
    return pages


def add_drawing_page(feature: FreeCAD.DocumentObject, sheet: int = 0) -> FreeCAD.DocumentObject:
    """Add a TechDraw page that shows flat patterns at a usual scale, with the parts' names.

    With more than 50 parts, and on pages of one sheet, the lines are a picture too, in which
    nothing can be picked; drawn by TechDraw itself they would take seconds at every recompute.

    Args:
        feature: flat patterns.
        sheet: number of the sheet to show, from 1 on; 0 for all in one picture.

    Raises:
        InputError: something else, no such sheet, or a FreeCAD without TechDraw.
    """
    _refuse_unfit(feature)
    if not 0 <= sheet <= feature.SheetCount:
        raise InputError(
            f"drawing: {feature.Label} has no sheet {sheet}; there are {feature.SheetCount}, "
            "0 shows all"
        )
    with transaction(feature.Document, FreeCAD.Qt.translate("Ortho", "Drawing page")):
        page = _page(feature, sheet)
        feature.Document.recompute()
    _open(page)
    return page


def _refuse_unfit(feature: FreeCAD.DocumentObject) -> None:
    places.refuse_link(feature)
    if not flat_patterns.is_flat_patterns(feature):
        name = getattr(feature, "Label", feature)
        raise InputError(f"drawing: {name} is no flat patterns; select flat patterns first")
    try:
        import TechDraw  # noqa: F401
    except ImportError:
        raise InputError(
            "drawing: this FreeCAD has no TechDraw workbench; install a full FreeCAD"
        ) from None


def _open(page: FreeCAD.DocumentObject) -> None:
    """Show a page, as a double click on it does."""
    if FreeCAD.GuiUp:
        page.ViewObject.doubleClicked()


def _page(feature: FreeCAD.DocumentObject, sheet: int) -> FreeCAD.DocumentObject:
    folder = Path(FreeCAD.getResourceDir()) / "Mod" / "TechDraw" / "Templates"
    path = next((folder / name for name in _TEMPLATES if (folder / name).is_file()), None)
    if path is None:
        raise InputError(f"drawing: no page of A3 in {folder}; install all of TechDraw")
    page = feature.Document.addObject("TechDraw::DrawPage", "Page")
    if sheet:
        page.Label = FreeCAD.Qt.translate("Ortho", "Sheet {}").format(sheet)
    template = feature.Document.addObject("TechDraw::DrawSVGTemplate", "Template")
    template.Template = str(path)
    page.Template = template
    to_one = _scale(drawings.frame(feature, sheet))
    _add_view(page, feature, 1.0 / to_one, sheet)
    _fill_title_block(template, feature, sheet, to_one)
    return page


def _scale(box: FreeCAD.BoundBox) -> float:
    """So many to one: the largest usual scale at which a rectangle fits on the page."""
    room = (_PAGE[0] - 2 * _MARGIN, _PAGE[1] - 2 * _MARGIN - _TITLE)
    needed = max(box.XLength / room[0], box.YLength / room[1])
    return next((float(scale) for scale in _SCALES if scale >= needed), needed)


def _add_view(
    page: FreeCAD.DocumentObject, feature: FreeCAD.DocumentObject, scale: float, sheet: int
) -> None:
    """One view from above in the middle of the page, and one drawing of all names over it."""
    if not sheet and len(feature.PartNames) <= _MOST_PARTS:
        view = page.Document.addObject("TechDraw::DrawViewPart", "View")
        page.addView(view)
        view.Source = [feature]
        view.Direction = FreeCAD.Vector(0, 0, 1)
        view.XDirection = FreeCAD.Vector(1, 0, 0)
        view.ScaleType = "Custom"
        view.Scale = scale
    else:
        view = drawings.add_picture(page, feature, drawings.LINES, scale, sheet)
    names = drawings.add_picture(page, feature, drawings.NAMES, scale, sheet)
    for item in (view, names):
        item.X, item.Y = _PAGE[0] / 2, (_PAGE[1] + _TITLE) / 2


def _fill_title_block(
    template: FreeCAD.DocumentObject, feature: FreeCAD.DocumentObject, sheet: int, to_one: float
) -> None:
    """Write what is known into the fields that the page has; what is not known stays empty."""
    names = [name for name, _ in drawings.names_on(feature, sheet)]
    structures = ", ".join(item.Label for item in feature.Structures)
    document = feature.Document
    scale = f"1 : {to_one:g}"
    # A page has one of the two fields of the scale: the second since FreeCAD 1.1.
    known = {
        "FC-Title": document.Label,
        "Subtitle": f"{structures}: {_first_to_last(names)}",
        "FC-Scale": scale,
        "scale": scale,
        "SheetNumber": f"{sheet or 1} / {max(feature.SheetCount, 1) if sheet else 1}",
        "CreationDate": datetime.date.today().isoformat(),
        "AuthorName": document.CreatedBy,
        "Weight": _weight(feature, set(names)),
    }
    fields = template.EditableTexts
    template.EditableTexts = {name: known.get(name, "") for name in fields}


def _first_to_last(names: list[str]) -> str:
    words = FreeCAD.Qt.translate("Ortho", "{} parts, {} to {}")
    return words.format(len(names), names[0], names[-1]) if len(names) > 1 else "".join(names)


def _weight(feature: FreeCAD.DocumentObject, names: set[str]) -> str:
    """The mass of the structures where all their parts are shown; nothing is known of a few."""
    shown = [item for item in feature.Structures if set(item.PartNames) <= names]
    if len(shown) < len(feature.Structures):
        return ""
    return f"{sum(json.loads(item.Report)['mass_kg'] for item in shown):,.1f} kg"
