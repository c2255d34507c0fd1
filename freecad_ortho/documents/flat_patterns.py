"""Flat patterns in documents: laid out, nested, drawn on pages."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.documents.common import removed_on_failure, transaction
from freecad_ortho.objects import drawings, flat_patterns
from freecad_ortho.objects.structure import is_structure
from solver.errors import InputError

if TYPE_CHECKING:
    Length = float | str | FreeCAD.Units.Quantity

# FreeCAD's own page by its names in versions 0.20, 1.0 and 1.1.
_TEMPLATES = ("A3_LandscapeTD.svg", "A3_Landscape_TD.svg", "ISO/A3_Landscape_TD.svg")
_PAGE = (420.0, 297.0)
# Around the patterns, mm; below them stands the title block.
_MARGIN, _TITLE = 25.0, 48.0
# With more parts than this TechDraw, which looks for hidden lines, holds up every recompute for
# more than a second; the page is drawn as a picture instead.
_MOST_PARTS = 50


def add_flat_patterns(
    structures: FreeCAD.DocumentObject | Sequence[FreeCAD.DocumentObject],
    sheet: tuple[Length, Length] | None = None,
    spacing: Length = 10.0,
    grain: str = "none",
    nesting: str = "boxes",
    seed: int = 0,
    kerf: Length = 0.0,
) -> FreeCAD.DocumentObject:
    """Add the flat patterns of structures on one net, which follow them.

    Args:
        structures: a Structure, or several on the same Net.
        sheet: width and height of the sheets to nest on; without it the patterns lie in rows.
        spacing: clear distance of parts from each other and from the rim of a sheet.
        grain: ``"none"`` lets parts turn, ``"along"`` keeps their length along the sheet.
        nesting: ``"boxes"`` or ``"outlines"``.
        seed: of the search for a dense nesting.
        kerf: width of the cut that the outlines are compensated for.

    Raises:
        InputError: nothing to lay out, or no part that fits on a sheet; the document is unchanged.
    """
    chosen = list(structures) if isinstance(structures, (list, tuple)) else [structures]
    if not chosen or not all(is_structure(item) for item in chosen):
        raise InputError("flat patterns: expected structures; select some first")
    for name, word, words in (
        ("grain", grain, ("none", "along")),
        ("nesting", nesting, ("boxes", "outlines")),
    ):
        if word not in words:
            raise InputError(f"{name}: expected {' or '.join(words)}, got '{word}'")
    width, height = (0.0, 0.0) if sheet is None else sheet
    document = chosen[0].Document
    with transaction(document, FreeCAD.Qt.translate("Ortho", "Flat patterns")):
        feature = flat_patterns.create(
            document,
            chosen,
            SheetWidth=convert.millimetres(width, "sheet width"),
            SheetHeight=convert.millimetres(height, "sheet height"),
            Spacing=convert.millimetres(spacing, "spacing"),
            Grain=grain.capitalize(),
            Nesting=nesting.capitalize(),
            Seed=seed,
            Kerf=convert.millimetres(kerf, "kerf"),
        )
        with removed_on_failure(feature):
            flat_patterns.rebuild(feature)
        feature.purgeTouched()
    return feature


def add_drawing_page(feature: FreeCAD.DocumentObject) -> FreeCAD.DocumentObject:
    """Add a TechDraw page that shows flat patterns at a scale that fits, with the parts' names.

    With more than 50 parts the lines are a picture too, in which nothing can be picked; drawn by
    TechDraw itself they would take seconds at every recompute.

    Args:
        feature: flat patterns.

    Raises:
        InputError: something else, or a FreeCAD without TechDraw.
    """
    if not flat_patterns.is_flat_patterns(feature):
        name = getattr(feature, "Label", feature)
        raise InputError(f"drawing: {name} is no flat patterns; select flat patterns first")
    try:
        import TechDraw  # noqa: F401
    except ImportError:
        raise InputError(
            "drawing: this FreeCAD has no TechDraw workbench; install a full FreeCAD"
        ) from None
    folder = Path(FreeCAD.getResourceDir()) / "Mod" / "TechDraw" / "Templates"
    path = next((folder / name for name in _TEMPLATES if (folder / name).is_file()), None)
    if path is None:
        raise InputError(f"drawing: no page of A3 in {folder}; install all of TechDraw")
    document = feature.Document
    with transaction(document, FreeCAD.Qt.translate("Ortho", "Drawing page")):
        page = document.addObject("TechDraw::DrawPage", "Page")
        template = document.addObject("TechDraw::DrawSVGTemplate", "Template")
        template.Template = str(path)
        page.Template = template
        _add_view(page, feature)
        document.recompute()
    return page


def _add_view(page: FreeCAD.DocumentObject, feature: FreeCAD.DocumentObject) -> None:
    """One view from above in the middle of the page, and one drawing of all names over it."""
    box = feature.Shape.BoundBox
    room = (_PAGE[0] - 2 * _MARGIN, _PAGE[1] - 2 * _MARGIN - _TITLE)
    scale = min(room[0] / max(box.XLength, 1e-9), room[1] / max(box.YLength, 1e-9))
    if len(feature.PartNames) <= _MOST_PARTS:
        view = page.Document.addObject("TechDraw::DrawViewPart", "View")
        page.addView(view)
        view.Source = [feature]
        view.Direction = FreeCAD.Vector(0, 0, 1)
        view.XDirection = FreeCAD.Vector(1, 0, 0)
        view.ScaleType = "Custom"
        view.Scale = scale
    else:
        view = drawings.add_picture(page, feature, drawings.LINES, scale)
    names = drawings.add_picture(page, feature, drawings.NAMES, scale)
    for item in (view, names):
        item.X, item.Y = _PAGE[0] / 2, (_PAGE[1] + _TITLE) / 2
