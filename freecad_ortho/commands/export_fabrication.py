"""The command Export fabrication files."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho.commands.command import Command
from freecad_ortho.window import context

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class ExportFabrication(Command):
    """Open the panel that writes solids, flat patterns, lists and reports into a folder."""

    icon = "export"
    shortcut = "O, X"
    text = QT_TRANSLATE_NOOP("Ortho_ExportFabrication", "Export fabrication files")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_ExportFabrication",
        "Write solids (STEP), flat patterns and sheets (DXF), lists (CSV) and reports of the "
        "selected structures",
    )

    def IsActive(self) -> bool:
        """Where there are structures."""
        return super().IsActive() and bool(context.current_structures())

    def Activated(self) -> None:
        """Open the task panel."""
        from freecad_ortho.panels.workshop_panels import ExportPanel

        FreeCADGui.Control.showDialog(ExportPanel(context.current_structures()))
