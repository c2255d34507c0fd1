"""Task panel of form-finding, in which supports are picked in the 3D view."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
from PySide import QtGui

from freecad_ortho.panels.source_panel import SourcePanel
from freecad_ortho.view.picking import Picking
from solver.errors import OrthoError
from solver.formfinding import supported

translate = FreeCAD.Qt.translate


class FormPanel(SourcePanel):
    """The fields of form-finding; while *Pick supports* is on, a click on a vertex holds it."""

    picking: Picking | None = None

    def look(self) -> None:
        """Show supports and shape again where a field has changed."""
        if self.picking is None:
            mesh = self.geometry["meshes"][0]
            self.picking = Picking(self.view, mesh.vertices, self._picked, self.stands)
        words = self.fields["supports"].value
        state = (words, self.pick_button.isChecked())
        if state != self._marked:
            self._marked = state
            self.picking.show(self._supports(words), self.pick_button.isChecked())
        super().look()

    def _supports(self, words: str) -> set[int]:
        """Numbers of the vertices that the field names, none while it makes no sense."""
        try:
            held = supported(self.geometry["meshes"][0], words.replace(" ", ""))
        except OrthoError:
            # The panel's message says what is wrong.
            return set()
        return set(np.flatnonzero(held).tolist())

    def _picked(self) -> None:
        self.fields["supports"].value = ",".join(map(str, sorted(self.picking.chosen)))
        self.look()

    def _pick(self, on: bool) -> None:
        """Begin with the corners or with what was named by numbers, not with a whole border."""
        if on and self.fields["supports"].value == "boundary":
            self.fields["supports"].value = ""
        self.look()

    def _build_form(self, title: str, picture: str, group: str, edited: Any) -> None:
        super()._build_form(title, picture, group, edited)
        self._marked: Any = None
        self.pick_button = QtGui.QPushButton(translate("Ortho", "Pick supports"))
        self.pick_button.setCheckable(True)
        self.pick_button.setToolTip(
            translate("Ortho", "Click vertices in the 3D view to hold them; click again to free.")
        )
        self.pick_button.clicked.connect(self._pick)
        self.form.layout().insertWidget(2, self.pick_button)

    def _clear(self, *_: Any) -> None:
        super()._clear()
        if self.picking is not None:
            self.picking.remove()
