"""Task panel that turns triangles into quads."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
from PySide import QtGui

from freecad_ortho.objects import cad_faces
from freecad_ortho.panels.fields import form_rows
from freecad_ortho.panels.option_fields import OptionField, add_option
from freecad_ortho.panels.work_panel import WorkPanel
from freecad_ortho.resources import icon
from freecad_ortho.window import context
from solver.mesh.remesh import OPTIONS

translate = FreeCAD.Qt.translate
_QUADS = 400


class RemeshPanel(WorkPanel):
    """Wanted edge length, corners, layout and time limit; OK makes the net.

    Args:
        mesh: a Mesh object, or the path of a file.

    Attributes:
        fields: by the name of the option.
    """

    def __init__(self, mesh: Any) -> None:
        self._mesh = mesh if isinstance(mesh, str) else (mesh.Document.Name, mesh.Name)
        points, triangles = cad_faces.triangles_of(mesh)
        one, two = (points[triangles[:, k]] - points[triangles[:, 0]] for k in (1, 2))
        self._area = 0.5 * float(np.linalg.norm(np.cross(one, two), axis=1).sum())
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Ortho", "Quads from triangles"))
        self.form.setWindowIcon(QtGui.QIcon(icon("remesh")))
        rows = form_rows(self.form)
        rows.addRow(translate("Ortho", "Triangles"), QtGui.QLabel(str(len(triangles))))
        first = {"edge": float(f"{np.sqrt(self._area / _QUADS):.2g}")}
        # Instead of a number of quads an edge length is asked for.
        asked = [option for option in OPTIONS if option.name != "faces"]
        self.fields = {
            option.name: OptionField(option, first.get(option.name, option.default))
            for option in asked
        }
        for field in self.fields.values():
            add_option(rows, field)

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
        values = {name: field.value for name, field in self.fields.items()}
        usual = {option.name: option.default for option in OPTIONS}
        changed = {name: value for name, value in values.items() if value != usual[name]}
        context.run("quads_from_mesh", self.mesh, **changed)
        return True
