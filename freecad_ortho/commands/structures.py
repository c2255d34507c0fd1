"""The commands Beams and Panels."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho.commands import context
from freecad_ortho.commands.command import NetCommand

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class Beams(NetCommand):
    """Open the panel that puts a beam on every edge of a net."""

    icon = "beams"
    text = QT_TRANSLATE_NOOP("Ortho_Beams", "Beams")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Beams", "Put a torsion-free beam on every edge of the selected net"
    )

    def Activated(self) -> None:
        """Open the task panel."""
        from freecad_ortho.panels.structure_panel import BeamsPanel

        FreeCADGui.Control.showDialog(BeamsPanel(context.current_net()))


class Panels(NetCommand):
    """Open the panel that puts a flat plate in every face of a net."""

    icon = "panels"
    text = QT_TRANSLATE_NOOP("Ortho_Panels", "Panels")
    tip = QT_TRANSLATE_NOOP("Ortho_Panels", "Put a flat panel in every face of the selected net")

    def Activated(self) -> None:
        """Open the task panel."""
        from freecad_ortho.panels.structure_panel import PanelsPanel

        FreeCADGui.Control.showDialog(PanelsPanel(context.current_net()))
