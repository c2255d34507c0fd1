"""FreeCAD's command Refresh builds what waits for it, as its users expect of marked objects."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho import answers
from freecad_ortho.objects import outdated

_followed: list[object] = []


def connect() -> None:
    """Follow the button, the menu and the key; doing it again changes nothing.

    A macro says ``update_structures`` itself.
    """
    if _followed:
        return
    _followed.extend(FreeCADGui.Command.get("Std_Refresh").getAction())
    for action in _followed:
        action.triggered.connect(lambda *_: _update())


def _update() -> None:
    if FreeCAD.ActiveDocument is not None and outdated.waiting(FreeCAD.ActiveDocument):
        answers.ask("update waiting structures")
