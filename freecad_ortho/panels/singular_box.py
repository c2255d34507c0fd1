"""Rows of a form that say where a net has singular vertices, and add one or have them found."""

from __future__ import annotations

from collections.abc import Callable

import FreeCAD
from PySide import QtGui

from freecad_ortho.panels.fields import NARROW
from freecad_ortho.sources.source import singular
from freecad_ortho.window import messages
from solver.align.crosses import VALENCES, Singular
from solver.errors import OrthoError
from solver.mesh.quadmesh import FloatArray

translate = FreeCAD.Qt.translate

Rows = tuple[tuple[float, ...], ...]


class SingularBox:
    """What singular vertices a net is to have, in words; one is added, or they are found.

    Args:
        rows: x, y, z in mm and number of lines; None where they are found.
        changed: called with the rows when these change.
        adding: called when from now on a press on the surface adds one, or no longer.

    Attributes:
        widget: to be put into a form.
    """

    def __init__(
        self,
        rows: Rows | None,
        changed: Callable[[Rows | None], None],
        adding: Callable[[bool], None],
    ) -> None:
        self._rows, self._changed = rows, changed
        self._found: Singular | None = None
        self.widget = QtGui.QWidget()
        column = QtGui.QVBoxLayout(self.widget)
        column.setContentsMargins(0, 0, 0, 0)
        self._words = QtGui.QLabel()
        self._words.setWordWrap(True)
        self._words.setToolTip(
            translate(
                "Ortho",
                "Drag the points along the surface; dropped onto each other, one with 3 and one "
                "with 5 lines vanish, and two with 5 become one with 6",
            )
        )
        self.lines_box = QtGui.QComboBox()
        self.lines_box.addItems([translate("Ortho", "{} lines").format(k) for k in VALENCES])
        self.lines_box.setToolTip(translate("Ortho", "How many lines meet in the one to be added."))
        self.add_button = QtGui.QPushButton(translate("Ortho", "Add"))
        self.add_button.setCheckable(True)
        self.add_button.setToolTip(
            translate("Ortho", "Press the mouse on the surface where there is to be one more.")
        )
        self.add_button.toggled.connect(adding)
        self.reset_button = QtGui.QPushButton(translate("Ortho", "Reset"))
        self.reset_button.setToolTip(
            translate("Ortho", "Have them found: the fewest that the surface needs.")
        )
        self.reset_button.clicked.connect(lambda: self._take(None))
        row = QtGui.QHBoxLayout()
        for widget in (self.lines_box, self.add_button):
            widget.setMinimumWidth(NARROW // 2)
            row.addWidget(widget)
        column.addWidget(self._words)
        column.addLayout(row)
        column.addWidget(self.reset_button)
        self._show()

    @property
    def singular(self) -> Singular | None:
        """Those that are wanted; where they are found, those of the net on the screen."""
        return self._found if self._rows is None else singular("singularities", self._rows)

    def found(self, there: Singular) -> None:
        """A net on the screen has these."""
        self._found = there
        self._show()

    def dropped(self, number: int, place: FloatArray, reach: float) -> None:
        """One of them was dragged to a place, perhaps onto another; what cannot be is said."""
        try:
            moved = self.singular.moved(number, place, reach)
        except OrthoError as error:
            messages.show_status(str(error))
            return
        self._take(_rows(moved))

    def added(self, place: FloatArray) -> None:
        """One more is wanted at a place, with as many lines as the box says."""
        there = self.singular
        before = () if there is None else _rows(there)
        self.add_button.setChecked(False)
        self._take((*before, (*place.tolist(), VALENCES[self.lines_box.currentIndex()])))

    def _take(self, rows: Rows | None) -> None:
        self._rows = rows
        self._show()
        self._changed(rows)

    def _show(self) -> None:
        there = self.singular
        valences = [] if there is None else there.valences.tolist()
        each = [
            translate("Ortho", "{} with {} lines").format(valences.count(lines), lines)
            for lines in sorted(set(valences))
        ]
        words = ", ".join(each) or translate("Ortho", "none")
        given = self._rows is not None
        head = translate("Ortho", "given: {}") if given else translate("Ortho", "automatic: {}")
        self._words.setText(head.format(words))
        self.reset_button.setEnabled(given)


def _rows(there: Singular) -> Rows:
    pairs = zip(there.places.tolist(), there.valences.tolist(), strict=True)
    return tuple((*place, lines) for place, lines in pairs)
