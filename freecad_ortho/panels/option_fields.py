"""Input fields made from the options of a source."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from freecad_ortho.panels.fields import NARROW, ChoiceField, sentence
from freecad_ortho.panels.quantity import QuantityField
from solver.option import Option

translate = FreeCAD.Qt.translate

_UNITS = {"length": "mm", "distance": "mm", "area": "mm^2", "angle": "deg"}
_PLAIN = ("number", "direction", "percent")
_MOST = 1e12
# Room for a length of some metres with its unit, for a formula.
_LEGIBLE = 120


class _NumberBox(QtGui.QDoubleSpinBox):
    """A number without unit, shown with no more digits than it has."""

    def __init__(self) -> None:
        super().__init__()
        self.setDecimals(9)
        self.setRange(-_MOST, _MOST)
        self.setSingleStep(0.1)

    def textFromValue(self, value: float) -> str:
        """Write a number; Qt asks for it."""
        return f"{value:.9g}"


class OptionField:
    """One row of a form for one option; options without a widget keep the value they have.

    Attributes:
        widget: what stands in the row, None for what is not asked for in a form.
    """

    def __init__(self, option: Option, value: Any) -> None:
        self.option = option
        self._value = value
        self._parts: list[Any] = []
        self.widget = self._build(value)
        if self.widget is not None:
            self.widget.setToolTip(sentence(translate("Ortho", option.meaning)))

    @property
    def value(self) -> Any:
        """The value, plain, in mm and degrees."""
        values = tuple(self._read(part) for part in self._parts)
        if not values:
            return self._value
        return values if len(self.option.parts) > 1 else values[0]

    @value.setter
    def value(self, value: Any) -> None:
        self._value = value
        parts = value if len(self.option.parts) > 1 else (value,)
        for part, item in zip(self._parts, parts, strict=False):
            self._write(part, item)

    def _build(self, value: Any) -> QtGui.QWidget | None:
        if self.option.kind in ("points", "placement"):
            return None
        parts = value if len(self.option.parts) > 1 else (value,)
        for item in parts:
            part = self._part()
            self._parts.append(part)
            self._write(part, item)
        widgets = [getattr(part, "widget", part) for part in self._parts]
        if len(widgets) == 1:
            return widgets[0]
        group = QtGui.QWidget()
        # What has a unit needs the room: one below the other. Of plain numbers three go abreast.
        abreast = 1 if self.option.kind in _UNITS else len(widgets) if len(widgets) < 4 else 2
        grid = QtGui.QGridLayout(group)
        grid.setContentsMargins(0, 0, 0, 0)
        for number, widget in enumerate(widgets):
            grid.addWidget(widget, number // abreast, number % abreast)
        return group

    def _part(self) -> Any:
        kind = self.option.kind
        if kind in _UNITS:
            least = 0.0 if kind == "length" else -_MOST
            absent = translate("Ortho", self.option.absent) if self.option.absent else ""
            quantity = QuantityField(_UNITS[kind], minimum=least, maximum=_MOST, absent=absent)
            quantity.widget.setMinimumWidth(_LEGIBLE)
            return quantity
        if kind in _PLAIN:
            widget = _NumberBox()
            if isinstance(self.option.default, tuple):
                widget.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
        elif kind == "count":
            widget = QtGui.QSpinBox()
            widget.setRange(0, 100_000)
        elif kind == "choice":
            words = {word: translate("Ortho", word) for word in self.option.choices}
            return ChoiceField(words, self.option.choices[0])
        elif kind == "flag":
            return QtGui.QCheckBox()
        else:
            widget = QtGui.QLineEdit()
        words = isinstance(widget, QtGui.QLineEdit)
        widget.setMinimumWidth(_LEGIBLE if words else NARROW // 2)
        return widget

    def _read(self, part: Any) -> Any:
        kind = self.option.kind
        if kind in _UNITS:
            return part.value
        if kind in (*_PLAIN, "count"):
            return part.value()
        if kind == "choice":
            return part.word
        return part.isChecked() if kind == "flag" else part.text()

    def _write(self, part: Any, value: Any) -> None:
        kind = self.option.kind
        if kind in _UNITS:
            part.value = float(value)
        elif kind in _PLAIN:
            part.setValue(float(value))
        elif kind == "count":
            part.setValue(int(value))
        elif kind == "choice":
            part.widget.setCurrentIndex(self.option.choices.index(value))
        elif kind == "flag":
            part.setChecked(bool(value))
        else:
            part.setText(value)
