"""Weights of the guides and the tolerance, folded away until they are wanted."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtCore, QtGui

from freecad_ortho.panels.fields import NumberField, form_rows

translate = FreeCAD.Qt.translate

_DEFAULT_TOLERANCE = 1e-10


class AdvancedBox:
    """A part of a form with a button that unfolds it.

    Args:
        stored: the settings of the net, as ``documents.net_settings.words`` gives them.

    Attributes:
        widget: to be put into the form.
    """

    def __init__(self, stored: dict[str, Any]) -> None:
        tolerance = stored["tolerance"]
        self.fairness = NumberField("fairness", stored["fairness"])
        self.closeness = NumberField("closeness", stored["closeness"])
        self.multi = NumberField("multi", stored["multi"])
        self.isometry = NumberField("isometry", stored["isometry"])
        self.tolerance = NumberField("tolerance", tolerance)
        rows = (
            (
                translate("Ortho", "Fairness"),
                self.fairness,
                translate("Ortho", "More of it draws lines straighter on the way; 0.01 is usual."),
            ),
            (
                translate("Ortho", "Closeness"),
                self.closeness,
                translate(
                    "Ortho", "More of it keeps vertices nearer to where they are; 0.003 is usual."
                ),
            ),
            (
                translate("Ortho", "Multi-net"),
                self.multi,
                translate("Ortho", "More of it keeps pairs of faces orthogonal; 0.001 is usual."),
            ),
            (
                translate("Ortho", "Isometry"),
                self.isometry,
                translate(
                    "Ortho",
                    "Faces keep their shape the more of it there is, such as 10; none is usual.",
                ),
            ),
            (
                translate("Ortho", "Tolerance"),
                self.tolerance,
                translate("Ortho", "A residual up to this counts as zero."),
            ),
        )
        self.widget = QtGui.QWidget()
        column = QtGui.QVBoxLayout(self.widget)
        column.setContentsMargins(0, 0, 0, 0)
        self.unfold = QtGui.QToolButton()
        self.unfold.setText(translate("Ortho", "Advanced"))
        self.unfold.setCheckable(True)
        self.unfold.setAutoRaise(True)
        self.unfold.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        self.unfold.toggled.connect(self._fold)
        self._inside = QtGui.QWidget()
        form = form_rows(self._inside)
        for label, field, tip in rows:
            field.widget.setToolTip(tip)
            form.addRow(label, field.widget)
        column.addWidget(self.unfold)
        column.addWidget(self._inside)
        given = any(stored[word] is not None for word in ("fairness", "closeness", "multi"))
        self.unfold.setChecked(given or tolerance != _DEFAULT_TOLERANCE)
        self._fold(self.unfold.isChecked())

    @property
    def words(self) -> dict[str, Any]:
        """The numbers as keywords of ``optimise_net``, None where the solver chooses.

        Raises:
            InputError: a field does not hold a number.
        """
        tolerance = self.tolerance.number
        return {
            "fairness": self.fairness.number,
            "closeness": self.closeness.number,
            "multi": self.multi.number,
            "isometry": self.isometry.number,
            "tolerance": _DEFAULT_TOLERANCE if tolerance is None else tolerance,
        }

    def _fold(self, open_now: bool) -> None:
        arrow = QtCore.Qt.DownArrow if open_now else QtCore.Qt.RightArrow
        self.unfold.setArrowType(arrow)
        self._inside.setVisible(open_now)
