"""Pictures of flat patterns on drawing pages; they follow the patterns.

TechDraw looks for hidden lines between all parts, each time anything before it is recomputed; a
picture costs nothing until the patterns change.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import FreeCAD

from freecad_ortho.objects.properties import HIDDEN, Property, ensure

if TYPE_CHECKING:
    import Part

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

LINES, NAMES = "Lines", "Names"
_ARC_POINTS = 25
_PROPERTIES = (
    Property(
        "App::PropertyLink",
        "Patterns",
        "Drawing",
        QT_TRANSLATE_NOOP("App::Property", "Flat patterns that the picture shows"),
    ),
    Property(
        "App::PropertyEnumeration",
        "Content",
        "Drawing",
        QT_TRANSLATE_NOOP("App::Property", "What the picture shows of them"),
        choices=(LINES, NAMES),
    ),
    Property(
        "App::PropertyFloat",
        "PatternScale",
        "Drawing",
        QT_TRANSLATE_NOOP("App::Property", "Length on the page of a length of one"),
        default=1.0,
        flags=HIDDEN,
    ),
    Property(
        "App::PropertyInteger",
        "Sheet",
        "Drawing",
        QT_TRANSLATE_NOOP("App::Property", "Number of the sheet that is shown; 0: all there is"),
    ),
)


def frame(feature: FreeCAD.DocumentObject, sheet: int) -> FreeCAD.BoundBox:
    """The rectangle that a sheet takes of flat patterns; that of all for 0 or one that is gone."""
    # Behind the parts in the shape come the sheets.
    shape = flat_shape(feature)
    places = shape.SubShapes[len(feature.PartNames) :]
    return places[sheet - 1].BoundBox if 0 < sheet <= len(places) else shape.BoundBox


def names_on(feature: FreeCAD.DocumentObject, sheet: int) -> list[tuple[str, FreeCAD.Vector]]:
    """Names of the parts on a sheet, and where they stand."""
    box = frame(feature, sheet)
    pairs = zip(feature.PartNames, feature.LabelPlaces, strict=True)
    return [(name, place) for name, place in pairs if _inside(place, box)]


def add_picture(
    page: FreeCAD.DocumentObject,
    feature: FreeCAD.DocumentObject,
    content: str,
    scale: float,
    sheet: int = 0,
) -> FreeCAD.DocumentObject:
    """Add a picture of the lines or the names of flat patterns, or of one sheet, to a page."""
    picture = page.Document.addObject("TechDraw::DrawViewSymbol", content)
    page.addView(picture)
    ensure(picture, _PROPERTIES)
    picture.Patterns, picture.Content, picture.PatternScale = feature, content, scale
    picture.Sheet = sheet
    _draw(picture)
    return picture


def flat_shape(feature: FreeCAD.DocumentObject) -> Part.Shape:
    """The shape of flat patterns in their own plane, wherever they were moved in the document."""
    shape = feature.Shape.copy()
    shape.Placement = FreeCAD.Placement()
    return shape


def redraw(feature: FreeCAD.DocumentObject) -> None:
    """Draw all pictures of flat patterns anew."""
    for item in feature.InList:
        if getattr(item, "Patterns", None) is feature:
            _draw(item)


def _draw(picture: FreeCAD.DocumentObject) -> None:
    feature, scale, sheet = picture.Patterns, picture.PatternScale, picture.Sheet
    content = _lines if picture.Content == LINES else _names
    box = frame(feature, sheet)
    picture.Symbol = _svg(box, scale, content(feature, sheet, box, scale))


def _inside(place: FreeCAD.Vector, box: FreeCAD.BoundBox) -> bool:
    return bool(box.XMin <= place.x <= box.XMax and box.YMin <= place.y <= box.YMax)


def _lines(feature: FreeCAD.DocumentObject, sheet: int, box: FreeCAD.BoundBox, scale: float) -> str:
    """The edges of the patterns as one group of SVG, mm on the page."""
    found = []
    for edge in flat_shape(feature).Edges:
        if sheet and not _inside(edge.BoundBox.Center, box):
            continue
        points = edge.discretize(2 if edge.Curve.TypeId == "Part::GeomLine" else _ARC_POINTS)
        places = [((p.x - box.XMin) * scale, (box.YMax - p.y) * scale) for p in points]
        found.append("M" + " L".join(f"{x:.3f},{y:.3f}" for x, y in places))
    return f'<path d="{" ".join(found)}" fill="none" stroke="#22303c" stroke-width="0.1"/>'


def _names(feature: FreeCAD.DocumentObject, sheet: int, box: FreeCAD.BoundBox, scale: float) -> str:
    """Each part's name in its place as one group of SVG, mm on the page."""
    size = max(1.0, min(4.0, 25.0 * scale))
    texts = []
    for name, place in names_on(feature, sheet):
        x, y = (place.x - box.XMin) * scale, (box.YMax - place.y) * scale
        texts.append(f'<text x="{x:.3f}" y="{y + size / 3:.3f}">{name}</text>')
    return (
        f'<g font-family="sans" font-size="{size:.2f}" text-anchor="middle" fill="#b03018">'
        f"{''.join(texts)}</g>"
    )


def _page_millimetre() -> float:
    """What a picture has to say for a millimetre on the page.

    TechDraw counts 96 pixels an inch, Qt 5 reads pictures with 90, Qt 6 with 96.
    """
    from PySide import QtCore

    return 96 / 90 if QtCore.qVersion().startswith("5.") else 1.0


def _svg(box: FreeCAD.BoundBox, scale: float, content: str) -> str:
    """A picture as large as what it shows, scaled."""
    size = box.XLength * scale, box.YLength * scale
    width, height = (f"{length:.3f}" for length in size)
    wide, high = (f"{length * _page_millimetre():.3f}mm" for length in size)
    # Corners that cannot be seen keep the picture's middle where the patterns' is.
    corners = f'<rect x="0" y="0" width="{width}" height="{height}" fill="none"/>'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide}" height="{high}" '
        f'viewBox="0 0 {width} {height}">{corners}{content}</svg>'
    )
