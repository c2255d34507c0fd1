"""Input fields made from declared options: of sources, nets and systems."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
from PySide import QtGui

from freecad_ortho.panels.fields import (
    BROAD,
    NARROW,
    ChoiceField,
    NumberField,
    leave_room,
    sentence,
)
from freecad_ortho.panels.quantity import QuantityBox
from solver.option import Option, Range

translate = FreeCAD.Qt.translate

_UNITS = {"length": "mm", "distance": "mm", "area": "mm^2", "angle": "deg"}
_PLAIN = ("number", "direction", "percent", "pressure", "force", "per_length", "per_area")
_MOST = 1e12
# Room for a length of some metres with its unit, for a formula.
_LEGIBLE = 120


class _NumberBox(QtGui.QDoubleSpinBox):
    """A number without unit, shown with no more digits than it has."""

    def __init__(self, allowed: Range) -> None:
        super().__init__()
        self.setDecimals(9)
        self.setRange(max(allowed.least, -_MOST), min(allowed.most, _MOST))
        self.setSingleStep(0.1)

    def textFromValue(self, value: float) -> str:
        """Write a number; Qt asks for it."""
        return f"{value:.9g}"


class OptionField:
    """One row of a form for one option; options without a widget keep the value they have.

    Args:
        option: any.
        value: to begin with.
        meshes: document objects that an option of the kind ``mesh`` may be.

    Attributes:
        widget: what stands in the row, None for what is not asked for in a form.
    """

    def __init__(
        self, option: Option, value: Any, meshes: Sequence[FreeCAD.DocumentObject] = ()
    ) -> None:
        self.option = option
        self._value = value
        self._meshes = [None, *meshes]
        self._parts: list[Any] = []
        self.widget = self._build(value)
        if self.widget is not None:
            words = sentence(translate("Ortho", option.meaning))
            allowed = option.range
            limits = f" ({allowed.least:g} … {allowed.most:,g})" if allowed.closed else ""
            for widget in [self.widget, *self._widgets]:
                widget.setToolTip(words + limits)

    @property
    def value(self) -> Any:
        """The value, plain, in mm and degrees; None where it is to be found.

        Raises:
            InputError: what was typed is not a number.
        """
        values = tuple(self._read(part) for part in self._parts)
        if not values:
            return self._value
        if self.option.kind == "weight":
            return self.option.default if values[0] is None else values[0]
        if self.option.default is None and not values[0]:
            return None
        return values if self.option.several else values[0]

    @value.setter
    def value(self, value: Any) -> None:
        self._value = value
        for part, item in zip(self._parts, self._items(value), strict=False):
            self._write(part, item)

    @property
    def _widgets(self) -> list[QtGui.QWidget]:
        """One for each part of the value."""
        return [getattr(part, "widget", part) for part in self._parts]

    def _items(self, value: Any) -> tuple[Any, ...]:
        return value if self.option.several else (value,)

    def _build(self, value: Any) -> QtGui.QWidget | None:
        if self.option.kind in ("points", "polylines", "singular", "placement"):
            return None
        for item in self._items(value):
            part = self._part()
            self._parts.append(part)
            self._write(part, item)
        widgets = self._widgets
        if len(widgets) == 1:
            return widgets[0]
        if self.option.kind in _UNITS:
            QuantityBox.joined(self._parts)
        group = QtGui.QWidget()
        # What has a unit needs the room: one below the other. Of plain numbers three go abreast.
        abreast = 1 if self.option.kind in _UNITS else len(widgets) if len(widgets) < 4 else 2
        grid = QtGui.QGridLayout(group)
        grid.setContentsMargins(0, 0, 0, 0)
        for number, widget in enumerate(widgets):
            grid.addWidget(widget, number // abreast, number % abreast)
        return group

    def _part(self) -> Any:
        option, kind = self.option, self.option.kind
        if kind in _UNITS:
            return self._quantity()
        if kind in _PLAIN:
            widget = _NumberBox(option.range)
            if kind == "pressure":
                # FreeCAD's own field shows 0 in Pa, and takes a number without a unit for such.
                widget.setSuffix(" kN/m²")
            if option.several:
                widget.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
        elif kind == "weight":
            return NumberField(translate("Ortho", option.label))
        elif kind == "count":
            widget = QtGui.QSpinBox()
            least, most = option.range.least, option.range.most
            # 0 stands for one that is found.
            widget.setRange(0 if option.default is None else int(least), int(min(most, 100_000)))
            if option.default is None and option.absent:
                widget.setSpecialValueText(translate("Ortho", option.absent))
        elif kind == "choice":
            words = {word: translate("Ortho", shown) for word, shown in option.words.items()}
            words |= {word: word for word in option.examples}
            return ChoiceField(words, option.choices[0], editable=bool(option.examples))
        elif kind == "mesh":
            nothing = ChoiceField({"": translate("Ortho", option.shown["none"])}, "")
            nothing.widget.addItems([mesh.Label for mesh in self._meshes[1:]])
            leave_room(nothing.widget)
            return nothing.widget
        elif kind == "flag":
            box = QtGui.QCheckBox()
            box.setText(translate("Ortho", option.shown["yes"]) if option.shown else "")
            return box
        else:
            widget = QtGui.QLineEdit()
        words = isinstance(widget, QtGui.QLineEdit)
        widget.setMinimumWidth(_LEGIBLE if words else NARROW // 2)
        return widget

    def _quantity(self) -> QuantityBox:
        """A number with a unit; in place of 0 stands what an absent one is."""
        option = self.option
        allowed = option.range
        # 0 stands for one that is found.
        least = min(allowed.least, 0.0) if option.default is None else allowed.least
        absent = option.absent or ("automatic" if option.default is None else "")
        words = translate("Ortho", absent) if absent else ""
        quantity = QuantityBox(
            _UNITS[option.kind],
            minimum=max(least, -_MOST),
            maximum=min(allowed.most, _MOST),
            absent=words,
        )
        quantity.setMinimumWidth(max(_LEGIBLE, min(quantity.sizeHint().width(), BROAD)))
        return quantity

    def _read(self, part: Any) -> Any:
        kind = self.option.kind
        if kind in _UNITS:
            return part.exact
        if kind in (*_PLAIN, "count"):
            return part.value()
        if kind == "weight":
            return part.number
        if kind == "mesh":
            return self._meshes[part.currentIndex()]
        if kind == "choice":
            return part.word
        return part.isChecked() if kind == "flag" else part.text()

    def _write(self, part: Any, value: Any) -> None:
        kind = self.option.kind
        if kind in _UNITS:
            part.exact = float(value or 0.0)
        elif kind == "weight":
            part.widget.setText("" if value is None else f"{value:g}")
        elif kind in _PLAIN:
            part.setValue(float(value))
        elif kind == "count":
            part.setValue(int(value or 0))
        elif kind == "choice":
            part.choose(value)
        elif kind == "mesh":
            part.setCurrentIndex(self._meshes.index(value) if value in self._meshes else 0)
        elif kind == "flag":
            part.setChecked(bool(value))
        else:
            part.setText(value or "")


def add_option(rows: QtGui.QFormLayout, field: OptionField) -> None:
    """Add the row of an option to a form."""
    words = translate("Ortho", field.option.label)
    if field.option.kind == "flag":
        field.widget.setText(words)
        rows.addRow(field.widget)
    else:
        unit = " (%)" if field.option.kind == "percent" else ""
        rows.addRow(words + unit, field.widget)
