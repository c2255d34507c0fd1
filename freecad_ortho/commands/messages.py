"""What a user is told; one place, so that tests can listen instead of clicking boxes away."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec

import FreeCAD
import FreeCADGui
from PySide import QtGui

import freecad_ortho
from solver.errors import OrthoError

_PACKAGES = {
    "numpy": "everything",
    "scipy": "everything",
    "cadquery": "beams and panels",
    "ezdxf": "flat patterns",
}


def show_error(text: str) -> None:
    """Tell the user that something did not work, in a box and in the report view."""
    FreeCAD.Console.PrintError(text + "\n")
    QtGui.QMessageBox.warning(FreeCADGui.getMainWindow(), "Ortho", text)


def show_status(text: str) -> None:
    """Tell the user what was done, in the report view and the status bar."""
    FreeCAD.Console.PrintMessage(text + "\n")
    FreeCADGui.getMainWindow().statusBar().showMessage(text, 10000)


@contextmanager
def errors_shown() -> Iterator[None]:
    """Turn errors that a user can do something about into a message; let others through."""
    try:
        yield
    except OrthoError as error:
        show_error(str(error))


def warn_about_missing_packages() -> None:
    """Name the Python packages that are missing and what they are needed for."""
    problem = freecad_ortho.shadowing_module()
    if problem:
        FreeCAD.Console.PrintError(problem + "\n")
    for name, purpose in _PACKAGES.items():
        if find_spec(name) is None:
            FreeCAD.Console.PrintWarning(
                f"Ortho: the Python package '{name}' is missing, needed for {purpose}; "
                "install it for FreeCAD's Python\n"
            )
