"""Commands of the toolbars and menus; each records itself as one line of freecad_ortho.api."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from freecad_ortho.commands.command import Command

# Toolbar -> names of its commands, in their order: those of their classes, without "Command".
TOOLBARS = {
    "Design": ("ImportNet", "MultiNet", "NewNet", "ChangeNet"),
    "Optimise": ("Optimise", "OptimiseAgain", "EditNet", "FlipNet"),
    "Analyse": ("Display", "Check", "StructuralCheck", "SavePicture"),
    "Fabricate": (
        "Beams",
        "EdgeBeam",
        "Arches",
        "Lamellas",
        "Patches",
        "Panels",
        "BentPanels",
        "Louvres",
        "Nodes",
        "Feet",
        "UpdateStructures",
        "FlatPatterns",
        "DrawingPage",
        "ExportFabrication",
        "Bake",
    ),
}

# Files with classes of commands, in the order in which FreeCAD learns of them: groups are last.
_FILES = (
    "import_net",
    "sources",
    "remesh",
    "optimise",
    "display",
    "structural_check",
    "structures",
    "flat_patterns",
    "export_fabrication",
    "groups",
)

# At the end of the menu, and there even where nothing else can be loaded.
HELP = ["Ortho_InstallPackages"]


def names(toolbar: str) -> list[str]:
    """FreeCAD's names of the commands of a toolbar."""
    return [f"Ortho_{name}" for name in TOOLBARS[toolbar]]


def for_selection() -> list[str]:
    """FreeCAD's names of the commands for the context menu of what is selected."""
    import FreeCADGui

    from freecad_ortho.window import context

    if not context.selected_nets_and_structures():
        return []
    offered = ("EditNet", "Optimise", "OptimiseAgain", "FlipNet", "Display", "Check")
    offered += ("StructuralCheck", "Beams", "Lamellas", "Panels")
    offered += ("UpdateStructures", "FlatPatterns", "ExportFabrication", "Bake")
    found = [f"Ortho_{name}" for name in offered]
    return [name for name in found if FreeCADGui.isCommandActive(name)]


def examples() -> list[str]:
    """FreeCAD's names of the commands that open examples."""
    from freecad_ortho.documents.examples import EXAMPLES

    return [f"Ortho_Example_{name}" for name in EXAMPLES]


def register() -> None:
    """Make the commands known to FreeCAD; doing it again changes nothing.

    Raises:
        ImportError: a Python package is missing; only the commands of ``HELP`` are known then.
    """
    from freecad_ortho.commands.install_packages import InstallPackages

    _add("Ortho_InstallPackages", InstallPackages())
    for command in _commands():
        _add(command.identifier, command)
    from freecad_ortho.commands.open_example import OpenExample

    for name in examples():
        _add(name, OpenExample(name.removeprefix("Ortho_Example_")))


def _add(name: str, command: Any) -> None:
    import FreeCADGui

    if name not in FreeCADGui.listCommands():
        FreeCADGui.addCommand(name, command)


def _commands() -> list[Command]:
    """One of every class that has a text of its own."""
    modules = [import_module(f"{__name__}.{name}") for name in _FILES]
    members = [member for module in modules for member in vars(module).values()]
    return [each() for each in members if isinstance(each, type) and "text" in vars(each)]
