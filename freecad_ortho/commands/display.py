"""The commands of the Analyse toolbar: how a net looks, what it is near to, pictures."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho.commands.command import Command, NetCommand
from freecad_ortho.window import context, dialogs, messages

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class Display(NetCommand):
    """Open the panel that chooses colour map and overlays."""

    icon = "display"
    shortcut = "O, D"
    text = QT_TRANSLATE_NOOP("Ortho_Display", "Display")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Display", "Choose the colour map and the overlays of the selected net"
    )

    def Activated(self) -> None:
        """Open the task panel."""
        from freecad_ortho.panels.display_panel import DisplayPanel

        FreeCADGui.Control.showDialog(DisplayPanel(context.current_net()))


class CheckCommand(NetCommand):
    """Open the panel that measures a net against every kind of net."""

    icon = "check"
    shortcut = "O, C"
    text = QT_TRANSLATE_NOOP("Ortho_Check", "Check")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Check", "Measure the selected net and say which kinds of nets it is near to"
    )

    def Activated(self) -> None:
        """Open the task panel."""
        from freecad_ortho.panels.check_panel import CheckPanel

        with messages.errors_shown():
            FreeCADGui.Control.showDialog(CheckPanel(context.current_net()))


class SavePicture(Command):
    """Ask for a file and a size, and write what the view shows."""

    icon = "picture"
    text = QT_TRANSLATE_NOOP("Ortho_SavePicture", "Save picture")
    tip = QT_TRANSLATE_NOOP("Ortho_SavePicture", "Save what the 3D view shows, at any size")

    def IsActive(self) -> bool:
        """Where a document is open."""
        return super().IsActive() and FreeCAD.ActiveDocument is not None

    def Activated(self) -> None:
        """Write the picture."""
        chosen = dialogs.ask_picture()
        if chosen is None:
            return
        path, width, height = chosen
        with messages.errors_shown():
            context.run("save_picture", path, width=width, height=height, turn=False)
            messages.show_status(
                FreeCAD.Qt.translate("Ortho", "Picture written to {}").format(path)
            )
