"""The Net: a mesh as a document object, its quads kept as quads, larger faces as they are."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import FreeCAD

from freecad_ortho import answers, convert
from freecad_ortho.objects import net_settings
from freecad_ortho.objects.properties import (
    HIDDEN,
    OUTPUT,
    READ_ONLY,
    Persistent,
    Property,
    version_of,
)
from solver.analysis.fields import fields
from solver.nets import NETS
from solver.report import CONVERGED

if TYPE_CHECKING:
    from solver.mesh.quadmesh import QuadMesh

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

VERSION = 2
# Colours by what the target of the net asks for, whatever that is.
BY_TARGET = "Target"
COLOUR_MAPS = ("None", BY_TARGET, *fields())

NET_PROPERTIES = (
    Property(
        "App::PropertyVectorList",
        "Vertices",
        "Net",
        QT_TRANSLATE_NOOP("App::Property", "Positions of the vertices, in mm"),
        flags=HIDDEN,
    ),
    Property(
        "App::PropertyIntegerList",
        "Faces",
        "Net",
        QT_TRANSLATE_NOOP("App::Property", "Vertex numbers of the quads, four a face"),
        flags=HIDDEN,
    ),
    Property(
        "App::PropertyIntegerList",
        "FaceSizes",
        "Net",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "How many vertices each face has, where some have more or fewer than four",
        ),
        flags=HIDDEN,
    ),
    Property(
        "App::PropertyVectorList",
        "BorderPoints",
        "Net",
        QT_TRANSLATE_NOOP(
            "App::Property", "Points of closed curves along which parts are trimmed, in mm"
        ),
        flags=HIDDEN,
    ),
    Property(
        "App::PropertyIntegerList",
        "BorderCounts",
        "Net",
        QT_TRANSLATE_NOOP("App::Property", "How many of these points each of the curves has"),
        flags=HIDDEN,
    ),
    Property(
        "App::PropertyBool",
        "Flipped",
        "Net",
        QT_TRANSLATE_NOOP("App::Property", "The other side is up than where the net came from"),
        flags=OUTPUT | READ_ONLY,
    ),
    Property(
        "App::PropertyString",
        "Unit",
        "Source",
        QT_TRANSLATE_NOOP("App::Property", "Unit of the file that the net came from"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyFile",
        "SourceFile",
        "Source",
        QT_TRANSLATE_NOOP("App::Property", "File that the net came from"),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyPosition",
        "Origin",
        "Source",
        QT_TRANSLATE_NOOP(
            "App::Property",
            "What was taken off the coordinates of a file far from the origin; export puts it back",
        ),
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyEnumeration",
        "ColourMap",
        "Display",
        QT_TRANSLATE_NOOP(
            "App::Property", "Quantity that colours the net, explained by the scale in the view"
        ),
        default=BY_TARGET,
        choices=COLOUR_MAPS,
        flags=OUTPUT,
    ),
    Property(
        "App::PropertyString",
        "LastReport",
        "Net",
        QT_TRANSLATE_NOOP("App::Property", "Report of the last optimisation, as JSON"),
        flags=OUTPUT | READ_ONLY,
    ),
    version_of("Net", VERSION),
    *net_settings.ALL,
)


class NetProxy(Persistent):
    """Proxy of a net. The properties hold everything; others react when they change."""

    properties = NET_PROPERTIES
    version = VERSION

    def execute(self, feature: FreeCAD.DocumentObject) -> None:
        """Nothing follows from the properties of a net but what other objects make of them."""


def create(document: FreeCAD.Document, mesh: QuadMesh, label: str) -> FreeCAD.DocumentObject:
    """Add a net to a document.

    Args:
        document: where to.
        mesh: positions in mm.
        label: name in the tree.
    """
    feature = document.addObject("App::FeaturePython", "Net")
    NetProxy(feature)
    feature.Label = label
    convert.store_mesh(feature, mesh)
    if FreeCAD.GuiUp:
        answers.ask("show net", feature.ViewObject)
    return feature


def colour_field(net: FreeCAD.DocumentObject, colour_map: str | None = None) -> str:
    """Name of the field that colours a net, ``"None"`` where nothing does.

    Args:
        net: the Net.
        colour_map: one of ``COLOUR_MAPS``; without it the net's own.
    """
    chosen = net.ColourMap if colour_map is None else colour_map
    if chosen != BY_TARGET:
        return chosen
    if net.CloseTo and _reached(net):
        # Nothing is left to be seen of what the net is judged by, but how near it came.
        return "Gap to reference"
    found = NETS[net.NetType].field
    on_diagonals = f"{found} diagonals"
    return on_diagonals if asked_of_diagonals(net) and on_diagonals in fields() else found


def _reached(net: FreeCAD.DocumentObject) -> bool:
    """Whether the last run ended with the net that is aimed at."""
    if not net.LastReport:
        return False
    report = json.loads(net.LastReport)
    return (report["net"], report["status"]) == (net.NetType, CONVERGED)


def asked_of_diagonals(net: FreeCAD.DocumentObject) -> bool:
    """Whether what the net is to become is asked of the diagonals of its faces."""
    return bool(net.DiagonalNet) and True in NETS[net.NetType].variants


def is_net(feature: object) -> bool:
    """Tell whether a document object is a net."""
    return isinstance(getattr(feature, "Proxy", None), NetProxy)


# Documents name the class of a net's proxy; those of earlier versions call it so.
Net = NetProxy
