"""Flat patterns in a document: the outlines of structures' parts, in rows or nested on sheets."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import FreeCAD
import numpy as np

from freecad_ortho import answers
from freecad_ortho.fabrication import Workshop
from freecad_ortho.fabrication.dxf import row_layout
from freecad_ortho.fabrication.kerf import compensated
from freecad_ortho.fabrication.nesting import Nesting, nest, too_large_words
from freecad_ortho.fabrication.workshop import ON_SHEETS
from freecad_ortho.objects import build, drawings, option_properties, outdated
from freecad_ortho.objects.properties import HIDDEN, OUTPUT, READ_ONLY, Property, version_of
from freecad_ortho.objects.structure import is_structure
from solver.errors import InputError

if TYPE_CHECKING:
    import Part

    from freecad_ortho.fabrication import FlatPattern, Structure
    from freecad_ortho.fabrication.nesting import Sheet
    from solver.mesh.quadmesh import FloatArray

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

VERSION = 1
# Between sheets, in parts of their shorter side.
_APART = 0.1

_PROPERTIES = (
    Property(
        "App::PropertyLinkList",
        "Structures",
        "Flat patterns",
        QT_TRANSLATE_NOOP("App::Property", "Structures whose parts are shown"),
    ),
    Property(
        "App::PropertyLength",
        "SheetWidth",
        "Sheets",
        QT_TRANSLATE_NOOP("App::Property", "Width of a sheet; 0: the parts lie in rows"),
    ),
    Property(
        "App::PropertyLength",
        "SheetHeight",
        "Sheets",
        QT_TRANSLATE_NOOP("App::Property", "Height of a sheet"),
    ),
    *(
        each
        for option in ON_SHEETS
        for each in option_properties.properties(option, "Sheets", titled=True)
    ),
    *outdated.updating("Flat patterns"),
    Property(
        "App::PropertyStringList",
        "PartNames",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Names of the parts, in the order of the shape"),
        flags=OUTPUT | READ_ONLY,
    ),
    Property(
        "App::PropertyStringList",
        "TooLarge",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Names of the parts that do not fit on a sheet"),
        flags=OUTPUT | READ_ONLY,
    ),
    Property(
        "App::PropertyVectorList",
        "LabelPlaces",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Where the names stand"),
        flags=OUTPUT | HIDDEN,
    ),
    Property(
        "App::PropertyInteger",
        "SheetCount",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Number of sheets"),
        flags=OUTPUT | READ_ONLY,
    ),
    Property(
        "App::PropertyFloat",
        "Waste",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Part of the sheets that is left over, 0 to 1"),
        flags=OUTPUT | READ_ONLY,
    ),
    version_of("Flat patterns", VERSION),
)


class FlatPatterns(outdated.Following):
    """Proxy of flat patterns. Only recomputing needs the fabrication packages."""

    properties = _PROPERTIES
    version = VERSION

    def rebuild(
        self, feature: FreeCAD.DocumentObject, progress: outdated.Progress | None = None
    ) -> None:
        """Lay the patterns out."""
        rebuild(feature)

    def fingerprint(self, feature: FreeCAD.DocumentObject) -> str:
        """A word that stands for all that the patterns are laid out from."""
        return build.fingerprint(feature.Structures, _workshop(feature))

    def stands_on(self, feature: FreeCAD.DocumentObject) -> list[FreeCAD.DocumentObject]:
        """The structures whose parts are shown."""
        return [item for item in feature.Structures if is_structure(item)]


def create(
    document: FreeCAD.Document, structures: Sequence[FreeCAD.DocumentObject], **properties: Any
) -> FreeCAD.DocumentObject:
    """Add flat patterns to a document without laying them out yet."""
    feature = document.addObject("Part::FeaturePython", "FlatPatterns")
    FlatPatterns(feature)
    outdated.watch()
    feature.Structures = list(structures)
    for name, value in properties.items():
        setattr(feature, name, value)
    if FreeCAD.GuiUp:
        answers.ask("show flat patterns", feature.ViewObject)
    return feature


def rebuild(feature: FreeCAD.DocumentObject) -> None:
    """Set the shape and what is known of the sheets from the properties.

    Raises:
        OrthoError: nothing to lay out, or no part that fits on a sheet; nothing was changed.
    """
    with outdated.timed(feature):
        _lay_out(feature, build.structure(feature.Structures), _workshop(feature))
    feature.Outdated, feature.Notice = False, outdated.notice(feature)
    feature.BuiltFrom = build.fingerprint(feature.Structures, _workshop(feature))
    drawings.redraw(feature)


def is_flat_patterns(feature: object) -> bool:
    """Tell whether a document object is flat patterns."""
    return isinstance(getattr(feature, "Proxy", None), FlatPatterns)


def _lay_out(feature: FreeCAD.DocumentObject, structure: Structure, workshop: Workshop) -> None:
    import Part

    flat = {
        part.name: compensated(part.name, part.pattern, workshop.kerf)
        for part in structure.parts
        if part.pattern is not None
    }
    if not flat:
        raise InputError(
            f"{feature.Label}: these structures have no parts that are cut from plates; choose "
            "beams of plates, lamellas or panels"
        )
    if workshop.sheet is None:
        nesting, placed = Nesting(), _in_rows(flat)
    else:
        nesting, placed = _nested(structure.parts, flat, workshop)
    sheets = nesting.sheets
    shapes = [_pattern_shape(flat[name], place) for name, place in placed]
    origins = _sheet_origins(sheets)
    frames = [_rectangle(sheet, at) for sheet, at in zip(sheets, origins, strict=True)]
    # A shape takes the place of the placement; what was moved by hand stays moved.
    place = feature.Placement
    feature.Shape = Part.makeCompound(shapes + frames)
    feature.Placement = place
    feature.PartNames = [name for name, _ in placed]
    feature.LabelPlaces = [_vector(place(flat[name].label[None])[0]) for name, place in placed]
    feature.TooLarge = [part.name for part in nesting.too_large]
    feature.SheetCount = len(sheets)
    area = sum(sheet.width * sheet.height for sheet in sheets)
    feature.Waste = 1 - sum(sheet.used for sheet in sheets) / area if area else 0.0


def _workshop(feature: FreeCAD.DocumentObject) -> Workshop:
    """What the parts are cut from and with."""
    values = {option.name: option_properties.read(feature, option) for option in ON_SHEETS}
    return Workshop(sheet=_sheet_size(feature), **values)


def _sheet_size(feature: FreeCAD.DocumentObject) -> tuple[float, float] | None:
    width, height = feature.SheetWidth.Value, feature.SheetHeight.Value
    if not width and not height:
        return None
    if not width or not height:
        raise InputError(f"{feature.Label}: a sheet needs a width and a height; set both or none")
    return width, height


def _in_rows(flat: dict[str, FlatPattern]) -> list[tuple[str, Any]]:
    places = row_layout(list(flat.values()))
    return [
        (name, lambda points, shift=place: points + shift)
        for name, place in zip(flat, places, strict=True)
    ]


def _nested(parts: Any, flat: dict[str, FlatPattern], workshop: Workshop) -> tuple[Nesting, Any]:
    chosen = [part for part in parts if part.name in flat]
    nesting = nest(chosen, workshop, [flat[part.name] for part in chosen])
    placed = []
    remarks = list(nesting.remarks)
    if nesting.too_large:
        remarks.append(too_large_words(nesting.too_large, workshop))
    for remark in remarks:
        FreeCAD.Console.PrintWarning(f"{remark}\n")
    for sheet, origin in zip(nesting.sheets, _sheet_origins(nesting.sheets), strict=True):
        for one in sheet.placements:
            placed.append(
                (
                    one.name,
                    lambda points, one=one, origin=origin: one.on_sheet(points) + origin,
                )
            )
    return nesting, placed


def _sheet_origins(sheets: Sequence[Sheet]) -> list[FloatArray]:
    """Lower left corners of the sheets, side by side in rows that make the whole about square."""
    if not sheets:
        return []
    width, height = sheets[0].width, sheets[0].height
    apart = _APART * min(width, height)
    columns = max(1, round(math.sqrt(len(sheets) * height / width)))
    step = np.array([width + apart, -height - apart])
    return [step * [number % columns, number // columns] for number in range(len(sheets))]


def _rectangle(sheet: Sheet, origin: FloatArray) -> Part.Shape:
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * [sheet.width, sheet.height]
    return _polygon(corners + origin, closed=True)


def _pattern_shape(pattern: FlatPattern, place: Any) -> Part.Shape:
    """Everything that is cut, drilled, bent or engraved, as one compound of wires."""
    import Part

    wires = [_polygon(place(loop), closed=True) for loop in (pattern.outline, *pattern.cutouts)]
    for hole in pattern.holes:
        centre = _vector(place(np.asarray(hole.centre)[None])[0])
        wires.append(Part.makeCircle(hole.diameter / 2, centre))
    lines = [line.points for line in (*pattern.bends, *pattern.bevels)]
    lines += [mark.points for mark in pattern.marks if not mark.text]
    if pattern.axis is not None:
        lines.append(pattern.axis)
    wires += [_polygon(place(line), closed=False) for line in lines]
    return Part.makeCompound(wires)


def _polygon(points: FloatArray, closed: bool) -> Part.Shape:
    import Part

    corners = [_vector(point) for point in points]
    return Part.makePolygon([*corners, corners[0]] if closed else corners)


def _vector(point: FloatArray) -> FreeCAD.Vector:
    return FreeCAD.Vector(float(point[0]), float(point[1]), 0.0)
