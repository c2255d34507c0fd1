"""FreeCAD's command Refresh builds what waits for it, as its users expect of marked objects."""

from __future__ import annotations

import FreeCAD
import FreeCADGui


def connect() -> None:
    """Follow the button, the menu and the key; a macro says ``update_structures`` itself."""
    for action in FreeCADGui.Command.get("Std_Refresh").getAction():
        action.triggered.connect(lambda *_: _update())


def _update() -> None:
    from freecad_ortho.commands.structures import update_waiting
    from freecad_ortho.objects import outdated

    if FreeCAD.ActiveDocument is not None and outdated.waiting(FreeCAD.ActiveDocument):
        update_waiting()
