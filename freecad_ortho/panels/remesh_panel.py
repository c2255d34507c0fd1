"""Task panel that turns triangles into quads."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from freecad_ortho.commands import context, messages
from freecad_ortho.objects import cad_faces
from freecad_ortho.panels.fields import LengthField
from freecad_ortho.resources import icon
from solver.errors import OrthoError

translate = FreeCAD.Qt.translate
_QUADS = 400


class RemeshPanel:
    """Wanted edge length, layout and time limit; OK makes the net.

    Args:
        mesh: a Mesh object, or the path of a file.
    """

    def __init__(self, mesh: Any) -> None:
        self._mesh = mesh if isinstance(mesh, str) else (mesh.Document.Name, mesh.Name)
        points, triangles = cad_faces.triangles_of(mesh)
        one, two = (points[triangles[:, k]] - points[triangles[:, 0]] for k in (1, 2))
        self._area = 0.5 * float(np.linalg.norm(np.cross(one, two), axis=1).sum())
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Ortho", "Quads from triangles"))
        self.form.setWindowIcon(QtGui.QIcon(icon("remesh")))
        self.edge = LengthField(float(f"{np.sqrt(self._area / _QUADS):.2g}"))
        self.layout, self.time_limit = QtGui.QSpinBox(), QtGui.QSpinBox()
        self.layout.setRange(0, 999)
        self.time_limit.setRange(1, 3600)
        self.time_limit.setValue(60)
        rows = QtGui.QFormLayout(self.form)
        rows.addRow(translate("Ortho", "Triangles"), QtGui.QLabel(str(len(triangles))))
        rows.addRow(translate("Ortho", "Edge length"), self.edge.widget)
        rows.addRow(translate("Ortho", "Layout"), self.layout)
        rows.addRow(translate("Ortho", "Time limit (s)"), self.time_limit)
        self.layout.setToolTip(translate("Ortho", "Another number gives another layout of quads"))

    def accept(self) -> bool:
        """Make the net; an error keeps the panel open."""
        mesh: Any = self._mesh
        if not isinstance(mesh, str):
            document = FreeCAD.listDocuments().get(mesh[0])
            mesh = document.getObject(mesh[1]) if document else None
            if mesh is None:
                FreeCADGui.Control.closeDialog()
                return True
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            context.run(
                "quads_from_mesh",
                mesh,
                edge=self.edge.millimetres,
                seed=self.layout.value(),
                time_limit=float(self.time_limit.value()),
            )
        except OrthoError as error:
            QtGui.QApplication.restoreOverrideCursor()
            messages.show_error(str(error))
            return False
        QtGui.QApplication.restoreOverrideCursor()
        FreeCADGui.Control.closeDialog()
        return True

    def reject(self) -> bool:
        """Leave everything as it was."""
        FreeCADGui.Control.closeDialog()
        return True
