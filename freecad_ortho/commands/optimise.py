"""The commands Optimise, Optimise again, Edit net and Flip net."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import FreeCAD
import FreeCADGui

from freecad_ortho.commands.command import Command, NetCommand
from freecad_ortho.documents.again import outdated_nets, require_same_vertices
from freecad_ortho.objects.net import is_net
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
        with messages.errors_shown():
            _show_panel(context.current_net())


class OptimiseAgain(Command):
    """Optimise what its source has left behind, as before."""

    icon = "optimise_again"
    text = QT_TRANSLATE_NOOP("Ortho_OptimiseAgain", "Optimise again")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_OptimiseAgain",
        "Optimise the selected nets, or all, as before where their sources have changed since",
    )

    def IsActive(self) -> bool:
        """Where a net is outdated."""
        return super().IsActive() and bool(_outdated())

    def Activated(self) -> None:
        """Open the task panel, which begins, ends and closes by itself, for one after the other."""
        _go_on(FreeCAD.ActiveDocument.Name, [net.Name for net in _selected()], ())


def _outdated() -> list[FreeCAD.DocumentObject]:
    """The outdated nets that are selected, without a selection all of the document."""
    if FreeCAD.ActiveDocument is None:
        return []
    return outdated_nets(FreeCAD.ActiveDocument, _selected())


def _selected() -> list[FreeCAD.DocumentObject]:
    return [item for item in FreeCADGui.Selection.getSelection() if is_net(item)]


def _go_on(name: str, chosen: Sequence[str], done: Sequence[str]) -> None:
    """Optimise the next outdated net, with what comes after it to follow.

    Args:
        name: of the document.
        chosen: names of the nets that are meant, none for all.
        done: names of those that have had their turn.
    """
    if name not in FreeCAD.listDocuments():
        return
    for net in outdated_nets(FreeCAD.getDocument(name)):
        if net.Name in done or (chosen and net.Name not in chosen):
            continue
        with messages.errors_shown():
            require_same_vertices(net)
            _show_panel(net, partial(_go_on, name, chosen, (*done, net.Name)))
        return


def _show_panel(net: FreeCAD.DocumentObject, then: Callable[[], None] | None = None) -> None:
    from freecad_ortho.panels.optimise_panel import OptimisePanel

    FreeCADGui.Control.showDialog(OptimisePanel(net, then))


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
