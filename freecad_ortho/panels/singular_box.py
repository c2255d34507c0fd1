"""Row of a form that says where a net has singular vertices, and lets them be found again."""

from __future__ import annotations

from collections.abc import Callable

import FreeCAD
from PySide import QtGui

from freecad_ortho.sources.source import singular
from freecad_ortho.window import messages
from solver.align.crosses import Singular
from solver.errors import OrthoError
from solver.mesh.quadmesh import FloatArray

translate = FreeCAD.Qt.translate

Rows = tuple[tuple[float, ...], ...]


class SingularBox:
    """What singular vertices a net is to have, in words, with a button that has them found.

    Args:
        rows: x, y, z in mm and number of lines; None where they are found.
        changed: called with the rows when these change.

    Attributes:
        widget: to be put into a form.
    """

    def __init__(self, rows: Rows | None, changed: Callable[[Rows | None], None]) -> None:
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
        self.reset_button = QtGui.QPushButton(translate("Ortho", "Reset"))
        self.reset_button.setToolTip(
            translate("Ortho", "Have them found: the fewest that the surface needs")
        )
        self.reset_button.clicked.connect(lambda: self._take(None))
        column.addWidget(self._words)
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
        pairs = zip(moved.places.tolist(), moved.valences.tolist(), strict=True)
        self._take(tuple((*here, lines) for here, lines in pairs))

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
