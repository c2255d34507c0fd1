"""Quad meshes through File > Open and File > Import: FreeCAD calls the two functions by name."""

from __future__ import annotations

import os

import FreeCAD

from solver.errors import OrthoError


def open(filename: str) -> FreeCAD.Document | None:
    """Open a mesh file as a new document with one Net."""
    label = os.path.splitext(os.path.basename(filename))[0]
    document = FreeCAD.newDocument(label)
    if insert(filename, document.Name):
        return document
    FreeCAD.closeDocument(document.Name)
    return None


def insert(filename: str, document_name: str) -> bool:
    """Import a mesh file into a document as a Net; True when it worked."""
    from freecad_ortho import documents, preferences

    try:
        documents.import_net(filename, document_name, preferences.import_unit())
    except OrthoError as error:
        _tell(str(error))
        return False
    if FreeCAD.GuiUp:
        import FreeCADGui

        FreeCADGui.SendMsgToActiveView("ViewFit")
    return True


def _tell(text: str) -> None:
    if FreeCAD.GuiUp:
        from freecad_ortho.commands import messages

        messages.show_error(text)
    else:
        FreeCAD.Console.PrintError(text + "\n")
