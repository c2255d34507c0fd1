"""Commands of the toolbars and menus; each records itself as one line of freecad_ortho.api."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from freecad_ortho.commands.command import Command

# Toolbar -> names of its commands, in their order; a name is "Ortho_" and the class's name.
TOOLBARS = {
    "Design": ("ImportNet",),
    "Optimise": ("Optimise",),
    "Analyse": ("Display", "Check", "SavePicture"),
    "Fabricate": ("Beams", "Panels", "ExportFabrication"),
}


def names(toolbar: str) -> list[str]:
    """FreeCAD's names of the commands of a toolbar."""
    return [f"Ortho_{name}" for name in TOOLBARS[toolbar]]


def register() -> None:
    """Make the commands known to FreeCAD; doing it again changes nothing."""
    import FreeCADGui

    known = set(FreeCADGui.listCommands())
    for command in _commands():
        name = f"Ortho_{type(command).__name__}"
        if name not in known:
            FreeCADGui.addCommand(name, command)


def _commands() -> list[Command]:
    from freecad_ortho.commands.display import Check, Display, SavePicture
    from freecad_ortho.commands.export_fabrication import ExportFabrication
    from freecad_ortho.commands.import_net import ImportNet
    from freecad_ortho.commands.optimise import Optimise
    from freecad_ortho.commands.structures import Beams, Panels

    return [
        ImportNet(),
        Optimise(),
        Display(),
        Check(),
        SavePicture(),
        Beams(),
        Panels(),
        ExportFabrication(),
    ]
