"""File dialogs, apart from the commands so that tests can put answers in their place."""

from __future__ import annotations

import os
from collections.abc import Sequence

import FreeCAD
import FreeCADGui
from PySide import QtGui

from freecad_ortho import preferences
from freecad_ortho.mesh_files import ENDINGS

translate = FreeCAD.Qt.translate


def ask_mesh_file() -> str | None:
    """Ask for a file of quads; None when the user cancels."""
    path, _ = QtGui.QFileDialog.getOpenFileName(
        FreeCADGui.getMainWindow(),
        translate("Ortho", "Import quad mesh"),
        _last_folder(),
        _filter(translate("Ortho", "Quad mesh"), ENDINGS),
    )
    return _remember(path)


def ask_triangle_file() -> str | None:
    """Ask for a file with triangles; None when the user cancels."""
    path, _ = QtGui.QFileDialog.getOpenFileName(
        FreeCADGui.getMainWindow(),
        translate("Ortho", "Quads from triangles"),
        _last_folder(),
        _filter(translate("Ortho", "Triangle mesh"), (".stl", ".glb", *ENDINGS)),
    )
    return _remember(path)


def ask_folder() -> str | None:
    """Ask for the folder that fabrication files go to; None when the user cancels."""
    path = QtGui.QFileDialog.getExistingDirectory(
        FreeCADGui.getMainWindow(),
        translate("Ortho", "Folder for the fabrication files"),
        _last_folder(),
    )
    return _remember(path)


def ask_picture() -> tuple[str, int, int] | None:
    """Ask for a PNG file and a width and height in pixels; None when the user cancels."""
    window = FreeCADGui.getMainWindow()
    title = translate("Ortho", "Save picture")
    path, _ = QtGui.QFileDialog.getSaveFileName(
        window, title, _last_folder(), translate("Ortho", "Picture (*.png)")
    )
    if _remember(path) is None:
        return None
    size, accepted = QtGui.QInputDialog.getText(
        window,
        title,
        translate("Ortho", "Width x height in pixels"),
        QtGui.QLineEdit.Normal,
        "1600 x 1000",
    )
    numbers = [int(part) for part in size.lower().split("x") if part.strip().isdecimal()]
    if not accepted or len(numbers) != 2:
        return None
    name = path if path.lower().endswith(".png") else f"{path}.png"
    return name, numbers[0], numbers[1]


def ask_sections(lists: Sequence[str]) -> tuple[str, str] | None:
    """Ask for a list of sections, and what has one of its own; None when the user cancels."""
    title = translate("Ortho", "Find the lightest section")
    names, accepted = QtGui.QInputDialog.getItem(
        FreeCADGui.getMainWindow(),
        title,
        translate("Ortho", "A list, or sections joined by +"),
        list(lists),
        0,
        True,
    )
    if not accepted or not names.strip():
        return None
    words = {
        translate("Ortho", "one section for all"): "all",
        translate("Ortho", "border, u and v have their own"): "families",
    }
    groups, accepted = QtGui.QInputDialog.getItem(
        FreeCADGui.getMainWindow(), title, translate("Ortho", "Members"), list(words), 0, False
    )
    return (names.strip(), words[groups]) if accepted else None


def _filter(title: str, endings: Sequence[str]) -> str:
    return f"{title} ({' '.join(f'*{ending}' for ending in endings)})"


def _last_folder() -> str:
    return preferences.group().GetString("LastFolder", "")


def _remember(path: str) -> str | None:
    if not path:
        return None
    folder = path if os.path.isdir(path) else os.path.dirname(path)
    preferences.group().SetString("LastFolder", folder)
    return path
