"""Loads of a net in an analysis of the FEM workbench: forces on all nodes of its line elements."""

from __future__ import annotations

from typing import Any

import FreeCAD

from freecad_ortho import convert
from freecad_ortho.objects.properties import HIDDEN, Persistent, Property, version_of
from solver.mesh.quadmesh import FloatArray

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

VERSION = 1
_GROUP = "Loads"


class NodeLoads(Persistent):
    """Proxy of a load case: FreeCAD's own constraints have no loads along lines."""

    Type = "Fem::ConstraintOrthoNodeLoads"
    version = VERSION
    properties = (
        Property(
            "App::PropertyString",
            "LoadCase",
            _GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Load case of the structural check"),
        ),
        Property(
            "App::PropertyFloat",
            "Factor",
            _GROUP,
            QT_TRANSLATE_NOOP("App::Property", "The loads count so many times; 0 leaves them out"),
            default=1.0,
        ),
        Property(
            "App::PropertyVectorList",
            "Forces",
            _GROUP,
            QT_TRANSLATE_NOOP("App::Property", "Force on each node of the mesh, N"),
            flags=HIDDEN,
        ),
        version_of(_GROUP, VERSION),
    )

    def execute(self, feature: FreeCAD.DocumentObject) -> None:
        """There is nothing to work out."""


def create(
    document: FreeCAD.Document, case: str, factor: float, forces: FloatArray
) -> FreeCAD.DocumentObject:
    """Add a load case.

    Args:
        document: where to.
        case: its name.
        factor: how many times it counts.
        forces: (K, 3) on the nodes, N, by their numbers.
    """
    feature = document.addObject("Fem::ConstraintPython", "NodeLoads")
    NodeLoads(feature)
    feature.Label = FreeCAD.Qt.translate("Ortho", "Loads: {}").format(case)
    feature.LoadCase, feature.Factor = case, factor
    feature.Forces = convert.vectors(forces)
    if FreeCAD.GuiUp:
        # No view of its own: what FreeCAD draws of a constraint has no nodes to stand on.
        feature.ViewObject.Proxy = 0
    return feature


def is_loads(feature: Any) -> bool:
    """Tell whether a document object is such a load case."""
    return isinstance(getattr(feature, "Proxy", None), NodeLoads)
