"""A command that the project does not have, in one file."""

import FreeCAD

from freecad_ortho.commands.command import NetCommand
from freecad_ortho.window import context, messages

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class TurnOver(NetCommand):
    """Turn a net over."""

    icon = "flip"
    text = QT_TRANSLATE_NOOP("Ortho_TurnOver", "Turn over")
    tip = QT_TRANSLATE_NOOP("Ortho_TurnOver", "Turn the selected net over")

    def Activated(self) -> None:
        """Flip it."""
        with messages.errors_shown(), messages.busy():
            context.run("flip_net", context.current_net())
