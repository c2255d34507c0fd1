"""The command Import quad mesh."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho import preferences
from freecad_ortho.commands.command import Command
from freecad_ortho.window import context, dialogs, messages

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class ImportNet(Command):
    """Ask for a file and make a Net of it."""

    icon = "import"
    shortcut = "O, I"
    text = QT_TRANSLATE_NOOP("Ortho_ImportNet", "Import quad mesh")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_ImportNet", "Read an OBJ, PLY, OFF, JSON or VTK file and keep its quads as a net"
    )

    def Activated(self) -> None:
        """Import the file that the user chooses."""
        path = dialogs.ask_mesh_file()
        if path is None:
            return
        with messages.errors_shown():
            context.run("import_net", path, **preferences.import_settings())
            FreeCADGui.SendMsgToActiveView("ViewFit")
