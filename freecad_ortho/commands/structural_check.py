"""The command Structural check, and what a double click on one does."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho.commands.command import NetCommand
from freecad_ortho.objects.net import is_net
from freecad_ortho.structural.sizing import LISTS
from freecad_ortho.structural.sizing_groups import ALL
from freecad_ortho.window import context, dialogs, messages
from solver.errors import InputError

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class StructuralCheckCommand(NetCommand):
    """Open the panel that asks for members, supports and loads."""

    icon = "structural_check"
    shortcut = "O, S"
    text = QT_TRANSLATE_NOOP("Ortho_StructuralCheck", "Structural check")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_StructuralCheck", "Check the grid shell on the selected net as a frame under loads"
    )

    def Activated(self) -> None:
        """Open the task panel."""
        _open(context.current_net(), None)


def edit_check(feature: FreeCAD.DocumentObject) -> None:
    """Open the panel with the settings of a structural check."""
    if FreeCADGui.Control.activeDialog():
        messages.show_status(FreeCAD.Qt.translate("Ortho", "Close the open task panel first."))
        return
    with messages.errors_shown():
        if not is_net(feature.Net):
            raise InputError(f"{feature.Label}: stands on no net; set its property 'Net' first")
        _open(feature.Net, feature)


def write_check(feature: FreeCAD.DocumentObject) -> None:
    """Write the files of a structural check into the folder that the user chooses."""
    with messages.errors_shown(), messages.busy():
        folder = dialogs.ask_folder()
        if folder is not None:
            context.run("write_check_files", feature, folder)
            said = FreeCAD.Qt.translate("Ortho", "Files of the check written to {}")
            messages.show_status(said.format(folder))


def analyse_check(feature: FreeCAD.DocumentObject) -> None:
    """Add the model as an analysis of the FEM workbench, under the combination that is drawn."""
    with messages.errors_shown(), messages.busy():
        chosen = feature.ViewObject.Combination
        more = {"combination": chosen} if chosen in feature.CombinationNames else {}
        context.run("add_fem_analysis", feature, **more)
        said = FreeCAD.Qt.translate("Ortho", "Analysis added; the FEM workbench solves it")
        messages.show_in_status_bar(said)


def size_check(feature: FreeCAD.DocumentObject) -> None:
    """Look for the lightest section of a list that the user chooses."""
    with messages.errors_shown(), messages.busy():
        chosen = dialogs.ask_sections(tuple(LISTS))
        if chosen is not None:
            sections, groups = chosen
            more = {} if groups == ALL else {"groups": groups}
            context.run("size_structural_check", feature, sections, **more)
            messages.show_in_status_bar(f"{feature.Label}: {feature.Verdict}")


def _open(net: FreeCAD.DocumentObject, edited: FreeCAD.DocumentObject | None) -> None:
    from freecad_ortho.panels.structural_panel import StructuralPanel

    FreeCADGui.Control.showDialog(StructuralPanel(net, edited))
