"""Quad meshes through File > Open, Import and Export: FreeCAD calls the functions by name."""

from __future__ import annotations

import os
from collections.abc import Sequence

import FreeCAD

from solver.errors import InputError, OrthoError


def open(filename: str) -> FreeCAD.Document | None:
    """Open a mesh file as a new document with one Net."""
    label = os.path.splitext(os.path.basename(filename))[0]
    document = FreeCAD.newDocument(label)
    if insert(filename, document.Name):
        if FreeCAD.GuiUp:
            from freecad_ortho.view import picture

            picture.look(picture.three_d_view(document))
        return document
    FreeCAD.closeDocument(document.Name)
    return None


def insert(filename: str, document_name: str) -> bool:
    """Import a mesh file into a document as a Net; True when it worked."""
    from freecad_ortho import documents, preferences

    try:
        documents.import_net(filename, document_name, **preferences.import_settings())
    except OrthoError as error:
        _tell(str(error))
        return False
    if FreeCAD.GuiUp:
        import FreeCADGui

        FreeCADGui.SendMsgToActiveView("ViewFit")
    return True


def export(features: Sequence[FreeCAD.DocumentObject], filename: str) -> bool:
    """Write the one net that is selected into a file; True when it worked."""
    from freecad_ortho import documents

    try:
        if len(features) != 1:
            raise InputError(f"export: expected one net, got {len(features)} objects; select one")
        documents.export_net(features[0], filename)
    except OrthoError as error:
        _tell(str(error))
        return False
    return True


def _tell(text: str) -> None:
    if FreeCAD.GuiUp:
        from freecad_ortho.window import messages

        messages.show_error(text)
    else:
        FreeCAD.Console.PrintError(text + "\n")
