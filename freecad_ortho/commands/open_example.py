"""The commands of the menu Examples."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho.commands.command import Command
from freecad_ortho.documents.examples import EXAMPLES
from freecad_ortho.resources import icon
from freecad_ortho.window import context, messages


class OpenExample(Command):
    """Build one of the examples in a new document."""

    def __init__(self, name: str) -> None:
        self.name = name

    def GetResources(self) -> dict[str, str]:
        """Texts of the example, in the user's language, and the picture of all examples."""
        example = EXAMPLES[self.name]
        return {
            "Pixmap": icon("example"),
            "MenuText": FreeCAD.Qt.translate("Ortho_Examples", example.title),
            "ToolTip": FreeCAD.Qt.translate("Ortho_Examples", example.tip),
        }

    def Activated(self) -> None:
        """Build it."""
        with messages.errors_shown(), messages.busy():
            context.run("open_example", self.name)
        FreeCADGui.updateGui()
