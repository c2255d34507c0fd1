"""Commands of the toolbar and the menu; each records itself as one line of freecad_ortho.api."""

from __future__ import annotations

NAMES = (
    "Ortho_ImportNet",
    "Ortho_Optimise",
    "Ortho_Beams",
    "Ortho_Panels",
    "Ortho_ExportFabrication",
)


def register() -> None:
    """Make the commands known to FreeCAD; doing it again changes nothing."""
    import FreeCADGui

    from freecad_ortho.commands.export_fabrication import ExportFabrication
    from freecad_ortho.commands.import_net import ImportNet
    from freecad_ortho.commands.optimise import Optimise
    from freecad_ortho.commands.structures import AddBeams, AddPanels

    known = set(FreeCADGui.listCommands())
    commands = (ImportNet(), Optimise(), AddBeams(), AddPanels(), ExportFabrication())
    for name, command in zip(NAMES, commands, strict=True):
        if name not in known:
            FreeCADGui.addCommand(name, command)
