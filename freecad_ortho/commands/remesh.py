"""The command Quads from triangles."""

from __future__ import annotations

import FreeCAD
import FreeCADGui

from freecad_ortho.commands.command import Command
from freecad_ortho.window import dialogs, messages

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP


class QuadsFromMesh(Command):
    """Open the panel that remeshes the selected Mesh object, or a file, to quads."""

    icon = "remesh"
    text = QT_TRANSLATE_NOOP("Ortho_QuadsFromMesh", "Quads from triangles")
    tip = QT_TRANSLATE_NOOP(
        "Ortho_QuadsFromMesh",
        "Remesh the selected triangle mesh, or an STL, OBJ, PLY or GLB file, to a net of quads",
    )

    def Activated(self) -> None:
        """Ask for a file where no mesh is selected, then open the task panel."""
        from freecad_ortho.panels.remesh_panel import RemeshPanel

        meshes = [
            item
            for item in FreeCADGui.Selection.getSelection()
            if item.isDerivedFrom("Mesh::Feature")
        ]
        chosen = meshes[0] if meshes else dialogs.ask_triangle_file()
        if chosen is None:
            return
        with messages.errors_shown():
            FreeCADGui.Control.showDialog(RemeshPanel(chosen))
