"""The commands Optimise, Edit net and Flip net."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho.commands.command import NetCommand
from freecad_ortho.window import context, messages

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class Optimise(NetCommand):
    """Open the panel that moves a net's vertices until its quads are orthogonal and planar."""

    icon = "optimise"
    shortcut = "O, O"
    text = QT_TRANSLATE_NOOP("Ortho_Optimise", "Optimise")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_Optimise",
        "Move the vertices of the selected net until its faces are orthogonal and planar",
    )

    def Activated(self) -> None:
        """Open the task panel."""
        from freecad_ortho.panels.optimise_panel import OptimisePanel

        with messages.errors_shown():
            FreeCADGui.Control.showDialog(OptimisePanel(context.current_net()))


class EditNet(NetCommand):
    """Begin to drag vertices of a net, as a double click on it does."""

    icon = "edit"
    text = QT_TRANSLATE_NOOP("Ortho_EditNet", "Edit net")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_EditNet",
        "Drag vertices of the selected net; the others follow so that it stays its kind of net",
    )

    def Activated(self) -> None:
        """Enter edit mode."""
        net = context.current_net()
        FreeCADGui.getDocument(net.Document.Name).setEdit(net.Name)


class FlipNet(NetCommand):
    """Turn the other side of a net up."""

    icon = "flip"
    text = QT_TRANSLATE_NOOP("Ortho_FlipNet", "Flip net")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_FlipNet",
        "Turn the other side of the selected net up; an arrow shows it, offsets and parts follow",
    )

    def Activated(self) -> None:
        """Flip it."""
        with messages.errors_shown(), messages.busy():
            context.run("flip_net", context.current_net())
