"""Row of a form with the edges, wires and sketches that a net runs along, and picking them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from freecad_ortho.objects.constraints import describe
from freecad_ortho.objects.strokes import Stroke, strokes_of
from freecad_ortho.panels.fields import NARROW
from freecad_ortho.window import messages
from solver.errors import OrthoError

translate = FreeCAD.Qt.translate


class StrokeBox:
    """Names of strokes; while *Pick* is on, a click on an edge takes it in, or out again.

    Args:
        strokes: to begin with.
        picking: called with whether strokes are being picked, when that changes.

    Attributes:
        widget: to be put into a form.
        strokes: as they are now.
    """

    def __init__(self, strokes: Sequence[Stroke], picking: Callable[[bool], None]) -> None:
        self.strokes = list(strokes)
        self._picking, self._watching = picking, False
        self.widget = QtGui.QWidget()
        column = QtGui.QVBoxLayout(self.widget)
        column.setContentsMargins(0, 0, 0, 0)
        self._names = QtGui.QLabel()
        self._names.setWordWrap(True)
        self.pick_button = QtGui.QPushButton(translate("Ortho", "Pick"))
        self.pick_button.setCheckable(True)
        self.pick_button.setToolTip(
            translate(
                "Ortho",
                "Click edges in the 3D view, or wires and sketches in the tree, that lines of the "
                "net run along; a second click leaves them out",
            )
        )
        self.pick_button.toggled.connect(self._pick)
        self.clear_button = QtGui.QPushButton(translate("Ortho", "None"))
        self.clear_button.clicked.connect(self._drop_all)
        line = QtGui.QHBoxLayout()
        for button in (self.pick_button, self.clear_button):
            button.setMinimumWidth(NARROW // 2)
            line.addWidget(button)
        column.addWidget(self._names)
        column.addLayout(line)
        self._show()

    def end(self) -> None:
        """Pick no more; doing it again changes nothing, nor does it need the form."""
        if self._watching:
            self._watching = False
            FreeCADGui.Selection.removeObserver(self)

    def addSelection(self, document: str, name: str, part: str, _: Any) -> None:
        """Take in what the user has picked, or out again; FreeCAD calls this."""
        feature = FreeCAD.getDocument(document).getObject(name)
        if feature is None:
            return
        try:
            picked = strokes_of((feature, part.split(".")[-1]))
        except OrthoError as error:
            messages.show_status(str(error))
            return
        for stroke in picked:
            if stroke in self.strokes:
                self.strokes.remove(stroke)
            else:
                self.strokes.append(stroke)
        self._show()
        # What stays selected cannot be clicked on again.
        QtCore.QTimer.singleShot(0, FreeCADGui.Selection.clearSelection)

    def _pick(self, on: bool) -> None:
        self.end()
        if on:
            FreeCADGui.Selection.clearSelection()
            self._watching = True
            FreeCADGui.Selection.addObserver(self)
        self._picking(on)

    def _drop_all(self) -> None:
        self.strokes = []
        self._show()

    def _show(self) -> None:
        names = ", ".join(map(describe, self.strokes))
        self._names.setText(names or translate("Ortho", "none"))
        self.clear_button.setEnabled(bool(self.strokes))
