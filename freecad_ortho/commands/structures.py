"""The commands Beams and Panels."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho.commands import context
from freecad_ortho.resources import icon

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class AddBeams:
    """Open the panel that puts a beam on every edge of a net."""

    def GetResources(self) -> dict[str, str]:
        """Text and icon."""
        return {
            "Pixmap": icon("beams"),
            "MenuText": QT_TRANSLATE_NOOP("Ortho_Beams", "Beams"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "Ortho_Beams", "Put a torsion-free beam on every edge of the selected net"
            ),
        }

    def IsActive(self) -> bool:
        """Where it is clear which net is meant."""
        return context.nothing_open() and context.current_net() is not None

    def Activated(self) -> None:
        """Open the task panel."""
        from freecad_ortho.panels.structure_panel import BeamsPanel

        FreeCADGui.Control.showDialog(BeamsPanel(context.current_net()))


class AddPanels:
    """Open the panel that puts a flat plate in every face of a net."""

    def GetResources(self) -> dict[str, str]:
        """Text and icon."""
        return {
            "Pixmap": icon("panels"),
            "MenuText": QT_TRANSLATE_NOOP("Ortho_Panels", "Panels"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "Ortho_Panels", "Put a flat panel in every face of the selected net"
            ),
        }

    def IsActive(self) -> bool:
        """Where it is clear which net is meant."""
        return context.nothing_open() and context.current_net() is not None

    def Activated(self) -> None:
        """Open the task panel."""
        from freecad_ortho.panels.structure_panel import PanelsPanel

        FreeCADGui.Control.showDialog(PanelsPanel(context.current_net()))
