"""The command Optimise."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho.commands import context, messages
from freecad_ortho.resources import icon

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class Optimise:
    """Open the panel that moves a net's vertices until its quads are orthogonal and planar."""

    def GetResources(self) -> dict[str, str]:
        """Text and icon."""
        return {
            "Pixmap": icon("optimise"),
            "MenuText": QT_TRANSLATE_NOOP("Ortho_Optimise", "Optimise"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "Ortho_Optimise",
                "Move the vertices of the selected net until its faces are orthogonal and planar",
            ),
        }

    def IsActive(self) -> bool:
        """Where it is clear which net is meant."""
        return context.nothing_open() and context.current_net() is not None

    def Activated(self) -> None:
        """Open the task panel."""
        from freecad_ortho.panels.optimise_panel import OptimisePanel

        with messages.errors_shown():
            FreeCADGui.Control.showDialog(OptimisePanel(context.current_net()))
