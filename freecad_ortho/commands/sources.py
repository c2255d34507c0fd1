"""The commands that make nets: from numbers, from CAD faces, from triangles and from other nets."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui

from freecad_ortho.commands.command import Command
from freecad_ortho.objects import source_net
from freecad_ortho.objects.making import Inputs
from freecad_ortho.objects.net import is_net
from freecad_ortho.sources import GROUPS, source
from freecad_ortho.window import context, messages

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class SourceCommand(Command):
    """A command that opens the panel of a group of sources.

    Attributes:
        group: of sources.
        title: of the panel, where the text in the menu is too long for it; marked for translation.
    """

    group: str
    title: str = ""

    def IsActive(self) -> bool:
        """Where there is what the sources need."""
        needs = source(GROUPS[self.group][0]).needs
        nets, faces = selected_nets(), selected_faces()
        enough = {"": True, "net": len(nets) == 1, "nets": bool(nets), "faces": bool(faces)}
        return super().IsActive() and enough[needs]

    def Activated(self) -> None:
        """Open the task panel."""
        with messages.errors_shown():
            FreeCADGui.Control.showDialog(self.panel())

    def panel(self) -> Any:
        """The task panel, on what is selected."""
        inputs = self.inputs()
        document = inputs.owners[0].Document if inputs.owners else _document()
        title = FreeCAD.Qt.translate(self.identifier, self.title or self.text)
        return _panel_class(self.group)(title, self.icon, self.group, document, inputs)

    def inputs(self) -> Inputs:
        """What is selected, as far as the sources are made of it."""
        entry = source(GROUPS[self.group][0])
        return Inputs(
            selected_nets() if entry.needs in ("net", "nets") else [],
            selected_faces() if entry.needs == "faces" else [],
            selected_edges() if entry.strokes else [],
        )


class PrimitiveCommand(SourceCommand):
    """Choose a net that is known exactly."""

    group = "primitive"
    icon = "primitive"
    text = QT_TRANSLATE_NOOP("Ortho_Primitive", "Primitive")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Primitive", "A net that is known exactly: sphere, catenoid, helicoid and others"
    )


class MultiNetCommand(SourceCommand):
    """Draw a polyline on a quadric."""

    group = "multi-net"
    icon = "multi_net"
    shortcut = "O, M"
    text = QT_TRANSLATE_NOOP("Ortho_MultiNet", "Multi-net")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_MultiNet",
        "Draw a polyline on a quadric; the orthogonal multi-net that it determines follows at once",
    )

    def panel(self) -> Any:
        """The task panel with which one draws."""
        title = FreeCAD.Qt.translate("Ortho_MultiNet", "Multi-net")
        return _panel_class(self.group)(title, self.icon, _document())


class EllipticNet(SourceCommand):
    """Choose a multi-net in elliptic coordinates."""

    group = "elliptic multi-net"
    icon = "elliptic_net"
    text = QT_TRANSLATE_NOOP("Ortho_EllipticNet", "Elliptic multi-net")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_EllipticNet", "An orthogonal multi-net from a curve in elliptic coordinates"
    )


class FaceNet(SourceCommand):
    """Sample CAD faces."""

    group = "faces"
    icon = "face_net"
    text = QT_TRANSLATE_NOOP("Ortho_FaceNet", "Net on faces")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_FaceNet",
        "Sample the selected CAD faces along their parameter lines, joined where they meet",
    )


class AlignedNet(SourceCommand):
    """Follow lines of curvature on CAD faces."""

    group = "along curvature"
    icon = "aligned_net"
    text = QT_TRANSLATE_NOOP("Ortho_AlignedNet", "Net along curvature")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_AlignedNet",
        "A net on the selected CAD faces along the lines that an exact net has there, which "
        "overhangs their border; edges, wires and sketches that are selected too it runs along",
    )
    title = QT_TRANSLATE_NOOP("Ortho_AlignedNet", "Aligned net")


class FormNet(SourceCommand):
    """Find a form in equilibrium."""

    group = "form-finding"
    icon = "form_net"
    text = QT_TRANSLATE_NOOP("Ortho_FormNet", "Form-finding")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_FormNet", "A membrane or cable net in equilibrium that starts from the selected net"
    )


class Derived(SourceCommand):
    """Make the diagonal, medial or checkerboard mesh, or the Christoffel dual."""

    group = "derived"
    icon = "derived"
    text = QT_TRANSLATE_NOOP("Ortho_Derived", "Derived mesh")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Derived",
        "The diagonal, medial or checkerboard mesh of the selected net, or its Christoffel dual",
    )


class Refine(SourceCommand):
    """Subdivide, coarsen or trim."""

    group = "refine"
    icon = "refine"
    text = QT_TRANSLATE_NOOP("Ortho_Refine", "Subdivide, coarsen, trim")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Refine", "More or fewer parameter lines of the selected net, or rows cut off"
    )


class Transform(SourceCommand):
    """Move, mirror, bend or turn over."""

    group = "transform"
    icon = "transform"
    text = QT_TRANSLATE_NOOP("Ortho_Transform", "Transform net")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Transform",
        "Move, turn, scale, mirror, turn over or bend the selected net (Moebius transformation)",
    )


class Offset(SourceCommand):
    """A parallel net."""

    group = "offset"
    icon = "offset"
    text = QT_TRANSLATE_NOOP("Ortho_Offset", "Offset")
    tip = QT_TRANSLATE_NOOP("Ortho_Offset", "A parallel net at an even distance")


class Weld(SourceCommand):
    """Join nets."""

    group = "weld"
    icon = "weld"
    text = QT_TRANSLATE_NOOP("Ortho_Weld", "Weld nets")
    tip = QT_TRANSLATE_NOOP("Ortho_Weld", "Join nets, or one with itself, where borders meet")


def edit_source(net: FreeCAD.DocumentObject) -> None:
    """Open the panel with the options of a net that follows a source."""
    if FreeCADGui.Control.activeDialog():
        return
    group = next(name for name, members in GROUPS.items() if net.MadeBy in members)
    with messages.errors_shown():
        make = _panel_class(group)
        if group == "multi-net":
            panel = make(net.Label, "multi_net", net.Document, net)
        else:
            inputs = source_net.inputs_of(net)
            panel = make(net.Label, "net", group, net.Document, inputs, net)
        FreeCADGui.Control.showDialog(panel)


def _panel_class(group: str) -> Any:
    """The class of the task panels for a group of sources."""
    from freecad_ortho.panels.aligned_panel import AlignedPanel
    from freecad_ortho.panels.form_panel import FormPanel
    from freecad_ortho.panels.multi_net_panel import MultiNetPanel
    from freecad_ortho.panels.source_panel import SourcePanel

    special = {
        "along curvature": AlignedPanel,
        "form-finding": FormPanel,
        "multi-net": MultiNetPanel,
    }
    return special.get(group, SourcePanel)


def selected_nets() -> list[FreeCAD.DocumentObject]:
    """The selected nets, or the one that is meant."""
    nets = [item for item in FreeCADGui.Selection.getSelection() if is_net(item)]
    if not nets and (net := context.current_net()) is not None:
        nets = [net]
    return nets


def selected_faces() -> list[tuple[FreeCAD.DocumentObject, str]]:
    """The selected faces of shapes; a shape that is selected whole stands for all its faces."""
    faces = []
    for picked in FreeCADGui.Selection.getSelectionEx():
        shape = getattr(picked.Object, "Shape", None)
        if shape is None or not getattr(shape, "Faces", None):
            continue
        names = [name for name in picked.SubElementNames if name.startswith("Face")]
        if not picked.SubElementNames:
            names = [f"Face{k + 1}" for k in range(len(shape.Faces))]
        faces += [(picked.Object, name) for name in names]
    return faces


def selected_edges() -> list[tuple[FreeCAD.DocumentObject, str]]:
    """The selected edges of shapes, and what is selected whole and has edges only."""
    edges = []
    for picked in FreeCADGui.Selection.getSelectionEx():
        shape = getattr(picked.Object, "Shape", None)
        if shape is None or not getattr(shape, "Edges", None):
            continue
        names = [name for name in picked.SubElementNames if name.startswith("Edge")]
        if not picked.SubElementNames and not shape.Faces:
            names = [""]
        edges += [(picked.Object, name) for name in names]
    return edges


def _document() -> FreeCAD.Document:
    """The active document, or a new one."""
    if FreeCAD.ActiveDocument is None:
        FreeCADGui.doCommand('FreeCAD.newDocument("Net")')
    return FreeCAD.ActiveDocument
