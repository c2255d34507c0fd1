"""The commands that build on a net: one a system of fabrication.

The OK of their panel runs ``add_structure`` with what differs from the defaults.
"""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho.commands.command import Command, NetCommand
from freecad_ortho.objects import outdated
from freecad_ortho.objects.net import is_net
from freecad_ortho.window import context, messages
from solver.errors import InputError

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class StructureCommand(NetCommand):
    """Opens the panel that asks for the sizes of a system; the icon is named like the system."""

    def Activated(self) -> None:
        """Open the task panel."""
        from freecad_ortho.panels.structure_panel import StructurePanel

        title = FreeCAD.Qt.translate(self.identifier, self.text)
        FreeCADGui.Control.showDialog(StructurePanel(context.current_net(), self.icon, title))


class ArchesCommand(StructureCommand):
    """Plates cut flat along the plane lines of a net."""

    icon = "arches"
    text = QT_TRANSLATE_NOOP("Ortho_Arches", "Arches")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Arches",
        "Put a plate that is cut flat along every line of the selected net that lies in a plane",
    )


class BeamsCommand(StructureCommand):
    """Beams on the edges or along the parameter lines of a net."""

    icon = "beams"
    shortcut = "O, B"
    text = QT_TRANSLATE_NOOP("Ortho_Beams", "Beams")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Beams", "Put torsion-free beams on the edges or parameter lines of the selected net"
    )


class BentPanelsCommand(StructureCommand):
    """Rows of faces as single bent plates."""

    icon = "bent-panels"
    text = QT_TRANSLATE_NOOP("Ortho_BentPanels", "Bent panels")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_BentPanels", "Put one bent plate in every row of faces of the selected net"
    )


class EdgeBeamCommand(StructureCommand):
    """A beam along the border of a net."""

    icon = "edge-beam"
    text = QT_TRANSLATE_NOOP("Ortho_EdgeBeam", "Edge beam")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_EdgeBeam",
        "Put a beam along the border of the selected net, at which beams and panels end",
    )


class FeetCommand(StructureCommand):
    """Feet below the supported vertices of a net."""

    icon = "feet"
    text = QT_TRANSLATE_NOOP("Ortho_Feet", "Support feet")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Feet",
        "Put corners, the boundary or some vertices of the selected net on posts with base plates",
    )


class LamellasCommand(StructureCommand):
    """Developable strips along the parameter lines of a net."""

    icon = "lamellas"
    shortcut = "O, L"
    text = QT_TRANSLATE_NOOP("Ortho_Lamellas", "Lamellas")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Lamellas",
        "Put a strip that unrolls flat along every parameter line of the selected net",
    )


class LouvresCommand(StructureCommand):
    """A slat in every face of a net, on the midpoints of its edges."""

    icon = "louvres"
    text = QT_TRANSLATE_NOOP("Ortho_Louvres", "Louvres")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Louvres", "Put a slat on the midpoints of every face of the selected net"
    )


class NodesCommand(StructureCommand):
    """Hubs and joints at the vertices of a net."""

    icon = "nodes"
    shortcut = "O, N"
    text = QT_TRANSLATE_NOOP("Ortho_Nodes", "Nodes")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Nodes", "Put a hub or a joint at the vertices of the selected net"
    )


class PanelsCommand(StructureCommand):
    """A flat plate in every face of a net."""

    icon = "panels"
    shortcut = "O, P"
    text = QT_TRANSLATE_NOOP("Ortho_Panels", "Panels")
    tip = QT_TRANSLATE_NOOP("Ortho_Panels", "Put a flat panel in every face of the selected net")


class PatchesCommand(StructureCommand):
    """Whole developable sheets."""

    icon = "patches"
    text = QT_TRANSLATE_NOOP("Ortho_Patches", "Developable patches")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Patches", "Make the selected net of sheets that are cut flat and bent into place"
    )


class UpdateStructures(Command):
    """Build anew what waits for it."""

    icon = "update"
    shortcut = "O, U"
    text = QT_TRANSLATE_NOOP("Ortho_UpdateStructures", "Update structures")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_UpdateStructures",
        "Build those structures and flat patterns anew that wait because they take long",
    )

    def IsActive(self) -> bool:
        """Where something waits."""
        document = FreeCAD.ActiveDocument
        return super().IsActive() and document is not None and bool(outdated.waiting(document))

    def Activated(self) -> None:
        """Build them."""
        update_waiting()


def edit_structure(structure: FreeCAD.DocumentObject) -> None:
    """Open the panel with the settings of a structure."""
    if FreeCADGui.Control.activeDialog():
        messages.show_status(FreeCAD.Qt.translate("Ortho", "Close the open task panel first."))
        return
    from freecad_ortho.panels.structure_edit_panel import StructureEditPanel

    with messages.errors_shown():
        if not is_net(structure.Net):
            raise InputError(f"{structure.Label}: stands on no net; set its property 'Net' first")
        FreeCADGui.Control.showDialog(StructureEditPanel(structure))


def update_waiting() -> None:
    """Build what waits in the active document."""
    with messages.errors_shown(), messages.busy():
        context.run("update_structures")


class Bake(Command):
    """Plain Part features and meshes out of what is selected."""

    icon = "bake"
    text = QT_TRANSLATE_NOOP("Ortho_Bake", "Bake to plain features")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Bake",
        "Copy the selected nets and structures as Part features and meshes that need no add-on",
    )

    def IsActive(self) -> bool:
        """Where a net or a structure is selected."""
        return super().IsActive() and bool(context.selected_nets_and_structures())

    def Activated(self) -> None:
        """Copy them."""
        with messages.errors_shown():
            context.run("bake", context.selected_nets_and_structures())
