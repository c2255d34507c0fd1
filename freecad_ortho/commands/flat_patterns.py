"""The commands Flat patterns and Drawing page."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho.commands.command import Command
from freecad_ortho.objects.structure import is_structure
from freecad_ortho.window import context, messages
from solver.errors import InputError

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class FlatPatternsCommand(Command):
    """Open the panel that lays the parts of structures flat."""

    icon = "flat_patterns"
    shortcut = "O, F"
    text = QT_TRANSLATE_NOOP("Ortho_FlatPatterns", "Flat patterns")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_FlatPatterns", "Lay the parts of the selected structures flat, in rows or on sheets"
    )

    def IsActive(self) -> bool:
        """Where there are structures."""
        return super().IsActive() and bool(context.current_structures())

    def Activated(self) -> None:
        """Open the task panel."""
        from freecad_ortho.panels.workshop_panels import FlatPatternsPanel

        FreeCADGui.Control.showDialog(FlatPatternsPanel(context.current_structures()))


def edit_flat_patterns(feature: FreeCAD.DocumentObject) -> None:
    """Open the panel with the settings of flat patterns."""
    if FreeCADGui.Control.activeDialog():
        messages.show_status(FreeCAD.Qt.translate("Ortho", "Close the open task panel first."))
        return
    from freecad_ortho.panels.workshop_panels import FlatPatternsPanel

    with messages.errors_shown():
        structures = [item for item in feature.Structures if is_structure(item)]
        if not structures:
            raise InputError(
                f"{feature.Label}: shows no structures; set its property 'Structures' first"
            )
        FreeCADGui.Control.showDialog(FlatPatternsPanel(structures, feature))


class DrawingPage(Command):
    """TechDraw pages of flat patterns, one a sheet."""

    icon = "drawing_page"
    text = QT_TRANSLATE_NOOP("Ortho_DrawingPage", "Drawing page")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_DrawingPage", "Show each sheet of the selected flat patterns on a page to print"
    )

    def IsActive(self) -> bool:
        """Where it is clear which flat patterns are meant."""
        return super().IsActive() and context.current_flat_patterns() is not None

    def Activated(self) -> None:
        """Add the pages."""
        with messages.errors_shown():
            context.run("add_drawing_pages", context.current_flat_patterns())
