"""Row of a form with what a net runs along: edges, wires and sketches picked, lines drawn."""

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

# Points of a line, in mm.
Line = tuple[tuple[float, ...], ...]

translate = FreeCAD.Qt.translate


class StrokeBox:
    """Names of strokes; while *Pick* is on, a click on an edge takes it in, or out again.

    Args:
        strokes: to begin with.
        lines: drawn by hand, to begin with.
        changed: called when something is picked or drawn from now on, no longer, or there are other
            lines.

    Attributes:
        widget: to be put into a form.
        strokes: as they are now.
        lines: drawn by hand, as they are now.
    """

    def __init__(
        self, strokes: Sequence[Stroke], lines: Sequence[Line], changed: Callable[[], None]
    ) -> None:
        self.strokes, self.lines = list(strokes), tuple(lines)
        self._changed, self._watching = changed, False
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
                "net run along; a second click leaves them out.",
            )
        )
        self.pick_button.toggled.connect(self._pick)
        self.draw_button = QtGui.QPushButton(translate("Ortho", "Draw"))
        self.draw_button.setCheckable(True)
        self.draw_button.setToolTip(
            translate(
                "Ortho",
                "Press the mouse on the surface and draw a line that the net runs along; Esc "
                "leaves it out.",
            )
        )
        self.draw_button.toggled.connect(self._draw)
        self.clear_button = QtGui.QPushButton(translate("Ortho", "None"))
        self.clear_button.clicked.connect(self._drop_all)
        line = QtGui.QHBoxLayout()
        for button in (self.pick_button, self.draw_button, self.clear_button):
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

    def add_line(self, line: Line) -> None:
        """Take in a line that was drawn."""
        self.lines = (*self.lines, line)
        self._show()
        self._changed()

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
            self.draw_button.setChecked(False)
            FreeCADGui.Selection.clearSelection()
            self._watching = True
            FreeCADGui.Selection.addObserver(self)
        self._changed()

    def _draw(self, on: bool) -> None:
        if on:
            self.pick_button.setChecked(False)
        self._changed()

    def _drop_all(self) -> None:
        self.strokes, self.lines = [], ()
        self._show()
        self._changed()

    def _show(self) -> None:
        names = list(map(describe, self.strokes))
        if self.lines:
            names.append(translate("Ortho", "{} drawn").format(len(self.lines)))
        self._names.setText(", ".join(names) or translate("Ortho", "none"))
        self.clear_button.setEnabled(bool(names))
