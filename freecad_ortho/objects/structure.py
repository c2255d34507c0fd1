"""The Structure: beams or panels of a net as a Part shape that follows the net."""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad_ortho.objects.properties import HIDDEN, OUTPUT, READ_ONLY, Persistent, Property

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

VERSION = 1
BEAMS, PANELS = "Beams", "Panels"
OFFSETS = ("Above", "Centre", "Below")
STEEL_DENSITY = 7850.0

_PROPERTIES = (
    Property(
        "App::PropertyLink",
        "Net",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Net that the structure is built on"),
    ),
    Property(
        "App::PropertyEnumeration",
        "System",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Beams along the edges or panels in the faces"),
        choices=(BEAMS, PANELS),
    ),
    Property(
        "App::PropertyLength",
        "Height",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Height of the beams, along the axes"),
        default=200.0,
    ),
    Property(
        "App::PropertyLength",
        "Thickness",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Thickness of the plates"),
        default=12.0,
    ),
    Property(
        "App::PropertyLength",
        "Gap",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Width of the joint between neighbouring panels"),
        default=10.0,
    ),
    Property(
        "App::PropertyEnumeration",
        "Offset",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Where the plates lie: above the net, centred, below"),
        choices=OFFSETS,
    ),
    Property(
        "App::PropertyLink",
        "OnBeams",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Beams that the panels lie on; empty: on the net"),
    ),
    Property(
        "App::PropertyFloat",
        "Density",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Density of the material in kg/m3"),
        default=STEEL_DENSITY,
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyStringList",
        "PartNames",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Names of the parts, in the order of the solids"),
        flags=OUTPUT | READ_ONLY,
    ),
    Property(
        "App::PropertyInteger",
        "Version",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Version of this object's properties"),
        default=VERSION,
        flags=OUTPUT | HIDDEN,
    ),
)


class Structure(Persistent):
    """Proxy of a structure. Only recomputing needs the fabrication packages, showing does not."""

    properties = _PROPERTIES
    version = VERSION

    def execute(self, feature: FreeCAD.DocumentObject) -> None:
        """Build the solids anew; on an error the last good shape stays.

        Raises:
            OrthoError: what is wrong and what to do; FreeCAD shows it and marks the object.
        """
        from solver.errors import OrthoError

        try:
            rebuild(feature)
        except OrthoError as error:
            # The report view shows where an exception came from; the inner frames help nobody.
            raise type(error)(str(error)) from None


def create(document: FreeCAD.Document, system: str, **properties: Any) -> FreeCAD.DocumentObject:
    """Add a structure to a document without building its solids yet.

    Args:
        document: where to.
        system: BEAMS or PANELS.
        properties: values of the structure's properties, by name.
    """
    feature = document.addObject("Part::FeaturePython", system)
    Structure(feature)
    feature.System = system
    for name, value in properties.items():
        setattr(feature, name, value)
    unused = ("Gap", "OnBeams") if system == BEAMS else ("Height",)
    for name in unused:
        feature.setPropertyStatus(name, "Hidden")
    if FreeCAD.GuiUp:
        from freecad_ortho.view.structure_view import StructureView

        StructureView(feature.ViewObject)
    return feature


def rebuild(feature: FreeCAD.DocumentObject) -> None:
    """Set the shape and the part names from the properties.

    Raises:
        OrthoError: the properties or the net do not make a structure; nothing was changed.
    """
    from freecad_ortho import convert
    from freecad_ortho.fabrication.packages import missing_package_named
    from freecad_ortho.objects import build

    structure = build.structure([feature])
    with missing_package_named():
        shape = convert.part_shape(structure.compound())
    names = [part.name for part in structure.parts]
    feature.Shape = shape
    feature.PartNames = names


def is_structure(feature: object) -> bool:
    """Tell whether a document object is a structure."""
    return isinstance(getattr(feature, "Proxy", None), Structure)
