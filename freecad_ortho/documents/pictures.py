"""Pictures of documents."""

from __future__ import annotations

import os

import FreeCAD

from freecad_ortho.documents.common import open_document
from solver.errors import InputError
from solver.option import Range, whole_number

_PIXELS = Range(1, 16384)


def save_picture(
    path: str | os.PathLike[str],
    document: FreeCAD.Document | None = None,
    width: int = 1600,
    height: int = 1000,
    background: str = "White",
    turn: bool = True,
) -> None:
    """Save a rendered picture of a document.

    Args:
        path: a PNG file, or another ending that Qt writes, such as jpg or bmp.
        document: without it the active one.
        width: in pixels.
        height: in pixels.
        background: a colour name, ``Current`` or ``Transparent``.
        turn: look from the front above and fit everything in; else as the view shows it.

    Raises:
        InputError: FreeCAD runs without a window, no document is open, or an unknown ending.
    """
    if not FreeCAD.GuiUp:
        raise InputError(
            "picture: FreeCAD runs without a window; run the script with 'freecad' "
            "(under xvfb-run on a machine without a screen), not with 'freecadcmd'"
        )
    for name, pixels in (("width", width), ("height", height)):
        whole_number(name, pixels, _PIXELS)
    from freecad_ortho.view import picture

    picture.save(os.fspath(path), open_document(document), width, height, background, turn)
