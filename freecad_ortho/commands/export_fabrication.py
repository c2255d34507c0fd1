"""The command Export fabrication files."""

from __future__ import annotations

import FreeCAD

from freecad_ortho.commands import context, dialogs, messages
from freecad_ortho.commands.command import Command

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class ExportFabrication(Command):
    """Ask for a folder and write STEP, DXF, parts list and report into it."""

    icon = "export"
    text = QT_TRANSLATE_NOOP("Ortho_ExportFabrication", "Export fabrication files")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_ExportFabrication",
        "Write solids (STEP), flat patterns (DXF) and the parts list (CSV) of the "
        "selected structures",
    )

    def IsActive(self) -> bool:
        """Where there are structures."""
        return super().IsActive() and bool(context.current_structures())

    def Activated(self) -> None:
        """Write the files into the folder that the user chooses."""
        folder = dialogs.ask_folder()
        if folder is None:
            return
        with messages.errors_shown():
            context.run("export_fabrication", context.current_structures(), folder)
            messages.show_status(
                FreeCAD.Qt.translate("Ortho", "Fabrication files written to {}").format(folder)
            )
