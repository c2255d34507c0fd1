"""Weights of the guides and the tolerance, folded away until they are wanted."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtCore, QtGui

from freecad_ortho.panels.fields import form_rows
from freecad_ortho.panels.option_fields import OptionField
from solver.nets.settings import WEIGHTS

translate = FreeCAD.Qt.translate


class AdvancedBox:
    """A part of a form with a button that unfolds it.

    Args:
        stored: the settings of the net, as ``documents.net_settings.words`` gives them.

    Attributes:
        widget: to be put into the form.
        fields: by the name of the option.
    """

    def __init__(self, stored: dict[str, Any]) -> None:
        self.fields = {name: OptionField(option, stored[name]) for name, option in WEIGHTS.items()}
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
        for field in self.fields.values():
            form.addRow(translate("Ortho", field.option.label), field.widget)
        column.addWidget(self.unfold)
        column.addWidget(self._inside)
        self.unfold.setChecked(any(stored[name] != WEIGHTS[name].default for name in WEIGHTS))
        self._fold(self.unfold.isChecked())

    @property
    def words(self) -> dict[str, Any]:
        """The numbers as keywords of ``optimise_net``, None where the solver chooses.

        Raises:
            InputError: a field does not hold a number.
        """
        return {name: field.value for name, field in self.fields.items()}

    def _fold(self, open_now: bool) -> None:
        arrow = QtCore.Qt.DownArrow if open_now else QtCore.Qt.RightArrow
        self.unfold.setArrowType(arrow)
        self._inside.setVisible(open_now)
