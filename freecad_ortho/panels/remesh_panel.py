"""Task panel that turns triangles into quads."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
from PySide import QtGui

from freecad_ortho.objects import cad_faces
from freecad_ortho.panels.fields import LengthField, form_rows
from freecad_ortho.panels.work_panel import WorkPanel
from freecad_ortho.resources import icon
from freecad_ortho.window import context

translate = FreeCAD.Qt.translate
_QUADS = 400


class RemeshPanel(WorkPanel):
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
        rows = form_rows(self.form)
        rows.addRow(translate("Ortho", "Triangles"), QtGui.QLabel(str(len(triangles))))
        rows.addRow(translate("Ortho", "Edge length"), self.edge.widget)
        rows.addRow(translate("Ortho", "Layout"), self.layout)
        rows.addRow(translate("Ortho", "Time limit (s)"), self.time_limit)
        self.layout.setToolTip(translate("Ortho", "Another number gives another layout of quads"))

    @property
    def mesh(self) -> Any:
        """The Mesh object or the path; None when the object or its document has gone meanwhile."""
        if isinstance(self._mesh, str):
            return self._mesh
        document = FreeCAD.listDocuments().get(self._mesh[0])
        return document.getObject(self._mesh[1]) if document else None

    def possible(self) -> bool:
        """Tell whether the mesh is still there."""
        return self.mesh is not None

    def work(self) -> bool:
        """Make the net."""
        context.run(
            "quads_from_mesh",
            self.mesh,
            edge=self.edge.millimetres,
            seed=self.layout.value(),
            time_limit=float(self.time_limit.value()),
        )
        return True
