"""What a user is told; one place, so that tests can listen instead of clicking boxes away."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from solver.errors import OrthoError


def show_error(text: str) -> None:
    """Tell the user that something did not work, in a box and in the report view."""
    FreeCAD.Console.PrintError(text + "\n")
    QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), "Ortho", text)


def show_status(text: str, wrong: bool = False) -> None:
    """Tell the user what was done, in the report view and the status bar.

    Args:
        text: one line.
        wrong: it is done, but something about it is not as it should be.
    """
    say = FreeCAD.Console.PrintWarning if wrong else FreeCAD.Console.PrintMessage
    say(text + "\n")
    show_in_status_bar(text)


def show_in_status_bar(text: str) -> None:
    """Tell the user again what the report view says already."""
    FreeCADGui.getMainWindow().statusBar().showMessage(text, 10000)


@contextmanager
def errors_shown() -> Iterator[None]:
    """Turn errors that a user can do something about into a message; let others through."""
    try:
        yield
    except OrthoError as error:
        show_error(str(error))


@contextmanager
def busy() -> Iterator[None]:
    """Show the cursor that says to wait."""
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        yield
    finally:
        QtGui.QApplication.restoreOverrideCursor()
