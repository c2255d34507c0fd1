"""The Structure: the parts of one system on a net as a Part shape that follows the net."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import FreeCAD

from freecad_ortho import answers, convert
from freecad_ortho.fabrication import BUILD_UPS, MATERIALS
from freecad_ortho.fabrication.packages import missing_package_named
from freecad_ortho.fabrication.systems.nodes import ENDS_OF
from freecad_ortho.objects import build, outdated, places
from freecad_ortho.objects.kinds import (
    AT_EDGE_BEAM,
    BEAMS,
    EDGE_BEAM,
    NODES,
    ON_BEAMS,
    PANELS,
    TITLES,
    BuiltProxy,
    is_structure,
)
from freecad_ortho.objects.limit_properties import limit_properties
from freecad_ortho.objects.option_properties import with_capital
from freecad_ortho.objects.properties import (
    HIDDEN,
    OUTPUT,
    READ_ONLY,
    Property,
    choose,
    ensure,
    version_of,
)
from freecad_ortho.objects.system_properties import own_words, properties_of

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

VERSION = 2
FAMILIES = ("Both", "U", "V")

_MATERIAL = Property(
    "App::PropertyEnumeration",
    "Material",
    "Material",
    QT_TRANSLATE_NOOP("App::Property", "Material of all parts"),
    choices=tuple(map(with_capital, (*MATERIALS, *BUILD_UPS))),
)
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
        QT_TRANSLATE_NOOP("App::Property", "What the net is built with"),
        choices=tuple(TITLES),
    ),
    Property(
        "App::PropertyLink",
        "OnBeams",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Beams that the parts lie on or join; empty: the net"),
    ),
    Property(
        "App::PropertyLink",
        "OnNodes",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Nodes whose hubs the panels stay clear of"),
    ),
    Property(
        "App::PropertyLink",
        "AtEdgeBeam",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Edge beam that the parts end at or lie on"),
    ),
    Property(
        "App::PropertyEnumeration",
        "Family",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Parameter lines that are built on: u, v or both"),
        choices=FAMILIES,
    ),
    Property(
        "App::PropertyIntegerList",
        "Lines",
        "Structure",
        QT_TRANSLATE_NOOP("App::Property", "Numbers of these parameter lines; empty: all"),
    ),
    Property(
        "App::PropertyBool",
        "Trimmed",
        "Structure",
        QT_TRANSLATE_NOOP(
            "App::Property", "Cut parts along the border of the surface, where the net has one"
        ),
        default=True,
    ),
    *outdated.updating("Structure"),
    _MATERIAL,
    Property(
        "App::PropertyFloat",
        "Density",
        "Material",
        QT_TRANSLATE_NOOP("App::Property", "Density in kg/m3; 0: that of the material"),
        default=0.0,
    ),
    *limit_properties(),
    Property(
        "App::PropertyStringList",
        "PartNames",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Names of the parts, in the order of the solids"),
        flags=OUTPUT | READ_ONLY,
    ),
    Property(
        "App::PropertyStringList",
        "Verdicts",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "What each part exceeds, 'ok' if nothing"),
        flags=OUTPUT | READ_ONLY,
    ),
    Property(
        "App::PropertyPlacement",
        "BuiltAt",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Where the shape stands while nobody has moved it"),
        flags=OUTPUT | READ_ONLY | HIDDEN,
    ),
    Property(
        "App::PropertyString",
        "Report",
        "Result",
        QT_TRANSLATE_NOOP("App::Property", "Counts, accuracy and masses, as JSON"),
        flags=OUTPUT | READ_ONLY | HIDDEN,
    ),
    version_of("Structure", VERSION),
)


class StructureProxy(BuiltProxy):
    """Proxy of a structure. Only recomputing needs the fabrication packages, showing does not."""

    properties = _PROPERTIES
    version = VERSION

    def onDocumentRestored(self, feature: FreeCAD.DocumentObject) -> None:
        """Give a structure from an older document the properties that came later."""
        super().onDocumentRestored(feature)
        ensure_options(feature)

    def rebuild(
        self, feature: FreeCAD.DocumentObject, progress: outdated.Progress | None = None
    ) -> None:
        """Build the solids."""
        rebuild(feature, progress)

    def fingerprint(self, feature: FreeCAD.DocumentObject) -> str:
        """A word that stands for all that the solids are built from."""
        return build.fingerprint([feature])

    def stands_on(self, feature: FreeCAD.DocumentObject) -> list[FreeCAD.DocumentObject]:
        """The beams that the parts lie on, the nodes and the edge beam that they stay clear of."""
        links = (feature.OnBeams, feature.OnNodes, feature.AtEdgeBeam)
        return [item for item in links if is_structure(item)]


def create(document: FreeCAD.Document, title: str, **properties: Any) -> FreeCAD.DocumentObject:
    """Add a structure to a document without building its solids yet.

    Args:
        document: where to.
        title: of the system, one of ``TITLES``.
        properties: values of the structure's properties, by name.
    """
    feature = document.addObject("Part::FeaturePython", title.replace("-", ""))
    feature.Label = title
    StructureProxy(feature)
    outdated.watch()
    feature.System = title
    feature.setPropertyStatus("System", "ReadOnly")
    ensure_options(feature)
    set_properties(feature, properties)
    if FreeCAD.GuiUp:
        answers.ask("show structure", feature.ViewObject)
    return feature


def set_properties(feature: FreeCAD.DocumentObject, properties: Mapping[str, Any]) -> None:
    """Set properties by name."""
    # Build-ups of glass are as many as one likes, and so are sections.
    own = {_MATERIAL.name: _MATERIAL, **own_words(TITLES[feature.System])}
    for name, value in properties.items():
        if name in own:
            choose(feature, own[name], value)
        else:
            setattr(feature, name, value)


def acquaint(feature: FreeCAD.DocumentObject) -> list[FreeCAD.DocumentObject]:
    """Tell panels of the nodes on the same net and beams, whichever was there first.

    And beams, nodes and panels of the edge beam. Mitred beams end before hubs from now on; beams
    with other ends were chosen so.

    Returns:
        What was there before and has to make room now.
    """
    around = [item for item in feature.Net.InList if is_structure(item) and item is not feature]
    beside = [item for item in around if item.OnBeams is feature.OnBeams]
    told = _acquaint_edge_beam(feature, around)
    if feature.System == PANELS:
        feature.OnNodes = next((item for item in beside if item.System == NODES), None)
    elif feature.System == NODES:
        panels = [item for item in beside if item.System == PANELS and item.OnNodes is None]
        for item in panels:
            item.OnNodes = feature
        told += panels
    beams = feature.OnBeams
    ends = ENDS_OF.get(feature.Node.lower()) if feature.System == NODES else None
    if ends is not None and is_structure(beams):
        if beams.System == BEAMS and beams.Ends == "Mitred":
            beams.Ends = with_capital(ends)
            told.append(beams)
    return told


def _acquaint_edge_beam(
    feature: FreeCAD.DocumentObject, around: list[FreeCAD.DocumentObject]
) -> list[FreeCAD.DocumentObject]:
    """Tell what ends at an edge beam of it; returns what was there before it."""
    if feature.System == EDGE_BEAM:
        told = [item for item in around if TITLES[item.System] in AT_EDGE_BEAM]
        told = [item for item in told if item.AtEdgeBeam is None]
        for item in told:
            item.AtEdgeBeam = feature
        return told
    if is_structure(feature.OnBeams):
        feature.AtEdgeBeam = feature.OnBeams.AtEdgeBeam
    elif TITLES[feature.System] in AT_EDGE_BEAM:
        feature.AtEdgeBeam = next((item for item in around if item.System == EDGE_BEAM), None)
    return []


def ensure_options(feature: FreeCAD.DocumentObject) -> None:
    """Give a structure the properties that its system's options need."""
    system = TITLES[feature.System]
    ensure(feature, properties_of(system))
    status = "Hidden" if system not in ON_BEAMS else "-Hidden"
    feature.setPropertyStatus("OnBeams", status)
    feature.setPropertyStatus("OnNodes", "-Hidden" if feature.System == PANELS else "Hidden")
    status = "-Hidden" if system in AT_EDGE_BEAM else "Hidden"
    feature.setPropertyStatus("AtEdgeBeam", status)


def rebuild(feature: FreeCAD.DocumentObject, progress: outdated.Progress | None = None) -> None:
    """Set the shape and what is known of the parts from the properties.

    Args:
        feature: the structure.
        progress: called with a fraction and words; may raise to stop.

    Raises:
        OrthoError: the properties or the net do not make a structure; nothing was changed.
    """
    with outdated.timed(feature):
        structure = build.structure([feature])
        with missing_package_named():
            shape = convert.part_shape(structure.compound(progress))
        # A shape takes the place of the placement; what was moved by hand stays moved.
        by_hand, stands = places.by_hand(feature), places.built_at(feature, structure.shift)
        feature.Shape = shape
        feature.BuiltAt = stands
        feature.Placement = by_hand.multiply(stands)
    feature.Outdated, feature.Notice = False, outdated.notice(feature)
    feature.BuiltFrom = build.fingerprint([feature])
    feature.PartNames = [part.name for part in structure.parts]
    feature.Verdicts = list(structure.verdicts)
    report = structure.report()
    feature.Report = json.dumps(report)
    wrong = bool(report["verdict"]["failed"] or report["messages"])
    say = FreeCAD.Console.PrintWarning if wrong else FreeCAD.Console.PrintMessage
    say(summary(feature) + "\n")


def summary(feature: FreeCAD.DocumentObject) -> str:
    """One line on a structure that has been built: parts, mass, and what is wrong with them."""
    translate = FreeCAD.Qt.translate
    report = json.loads(feature.Report)
    failed = report["verdict"]["failed"]
    words = [
        translate("Ortho", "{}: {:,} parts, {:,.1f} kg").format(
            feature.Label, len(feature.PartNames), report["mass_kg"]
        )
    ]
    if failed:
        name, reason = next(iter(failed.items()))
        words.append(
            translate("Ortho", "{} of them exceed a limit, such as {}: {}").format(
                len(failed), name, reason
            )
        )
    words += report["messages"]
    return "; ".join(words)


# Documents name the class of a structure's proxy; those of earlier versions call it so.
Structure = StructureProxy
