"""Pictures of a document's 3D view."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
from pivy import coin
from PySide import QtGui

from freecad_ortho.view.screen import views
from solver.errors import InputError, OutputError

# From the front right, 30 degrees above the horizon.
_LOOK_FROM = coin.SbVec3f(0.45, -0.75, 0.5)


def save(
    path: str, document: FreeCAD.Document, width: int, height: int, background: str, turn: bool
) -> None:
    """Save the document's 3D view as a picture, turned to the standard direction where asked for.

    Raises:
        InputError: the document has no 3D view, or the path has an unknown ending.
        OutputError: the file was not written.
    """
    known = _endings()
    if Path(path).suffix[1:].lower() not in known:
        raise InputError(
            f"{path}: expected a picture's ending, one of {', '.join(known)}; call it "
            f"{Path(path).stem}.png"
        )
    view = three_d_view(document)
    if turn:
        look(view)
    QtGui.QApplication.processEvents()
    view.saveImage(path, width, height, background)
    if not QtGui.QImage(path).width():
        raise OutputError(f"{path}: the picture could not be written; choose another folder")


def _endings() -> list[str]:
    """Endings of pictures that can be written and read again, PNG first."""
    readable = {bytes(name).decode() for name in QtGui.QImageReader.supportedImageFormats()}
    writable = {bytes(name).decode() for name in QtGui.QImageWriter.supportedImageFormats()}
    return sorted(readable & writable, key=lambda ending: (ending != "png", ending))


def look(view: Any) -> None:
    """Turn a 3D view to the standard direction and fit everything in."""
    camera = view.getCameraNode()
    camera.pointAt(camera.position.getValue() - _LOOK_FROM, coin.SbVec3f(0, 0, 1))
    view.fitAll()


def three_d_view(document: FreeCAD.Document) -> Any:
    """Give the document's 3D view.

    Raises:
        InputError: it has none.
    """
    found = views(document.Name)
    if not found:
        raise InputError(f"{document.Label}: has no 3D view; open one in the View menu")
    return found[0]
