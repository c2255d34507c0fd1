"""A field for a number with a unit that holds exactly what it was given or what was typed."""

from __future__ import annotations

import math
from collections.abc import Sequence

import FreeCAD
from PySide import QtCore, QtGui

# A number with no more than these was chosen by someone; others come out of a calculation.
_DIGITS = 6
# What is less is a rest of a calculation: FreeCAD would show it as so many nanometres.
_NOTHING = 1e-6
# Qt rounds to so many places behind the point, which leaves each number what it is.
_PLACES = 30
_MOST = 1e12
# Pixels, of a field and of what stands beside its text.
_WIDE, _ARROWS = 100, 40
_KINDS = {
    "mm": FreeCAD.Units.Length,
    "mm^2": FreeCAD.Units.Area,
    "deg": FreeCAD.Units.Angle,
}


class QuantityBox(QtGui.QDoubleSpinBox):
    """A number in the user's unit system, or in any unit that is typed behind it.

    FreeCAD's own field takes what it shows for true: in US building units it makes 1/2", 12.7 mm,
    of 12 mm. And as it comes out of FreeCAD, PySide is not told when it is deleted, and takes what
    lies in its place later for it, up to a crash. Here a round number that the user's units cannot
    show is shown in the field's own unit.

    Args:
        unit: ``mm``, ``mm^2`` or ``deg``: that of the value.
        value: to begin with.
        minimum: the least that can be entered.
        maximum: the most.
        absent: shown in place of 0, where that stands for something else.
    """

    def __init__(
        self,
        unit: str,
        value: float = 0.0,
        minimum: float | None = None,
        maximum: float | None = None,
        absent: str = "",
    ) -> None:
        super().__init__()
        self._unit, self._absent = unit, absent
        # Those that are zero together where they stand for something else.
        self._fellows = [self]
        self._held, self._factor = 0.0, 1.0
        self._size: QtCore.QSize | None = None
        # Qt moves the cursor after the focus has come.
        self._chosen = QtCore.QTimer(self)
        self._chosen.setSingleShot(True)
        self._chosen.timeout.connect(self.selectAll)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self.setDecimals(_PLACES)
        self.setRange(-_MOST if minimum is None else minimum, _MOST if maximum is None else maximum)
        self.editingFinished.connect(self._show_fellows)
        self.exact = value

    @staticmethod
    def joined(boxes: Sequence[QuantityBox]) -> None:
        """Show the words for an absent number only where all of several fields are zero."""
        for box in boxes:
            box._fellows = list(boxes)
        boxes[0]._show_fellows()

    @property
    def exact(self) -> float:
        """The value, in the unit of the field; Qt's own ends at the limits."""
        shown = self.value()
        return self._held if shown == self._bounded(self._held) else shown

    @exact.setter
    def exact(self, value: float) -> None:
        self._held = float(value)
        self.setValue(self._held)
        self._show_fellows()

    def textFromValue(self, value: float) -> str:
        """Write a value; Qt asks for it."""
        held = self._held if value == self._bounded(self._held) else value
        words, factor = self._words(held)
        if held == self._held:
            # A number that is typed without a unit is meant in that of the number before it. Qt
            # asks for those at the limits too, to know how wide they are.
            self._factor = factor
        others = [box for box in self._fellows if box is not self]
        if self._absent and held == 0.0 and all(box._held == 0.0 for box in others):
            return self._absent
        return words

    def valueFromText(self, text: str) -> float:
        """Read what was typed, where it is not what is shown; Qt asks for it."""
        if not self._is_shown(text):
            self._held = self._parsed(text) or 0.0
        return self._bounded(self._held)

    def validate(self, text: str, place: int) -> tuple[QtGui.QValidator.State, str, int]:
        """Tell whether a text is a quantity within the limits; Qt asks for it."""
        value = self._held if self._is_shown(text) else self._parsed(text)
        sound = value is not None and (self._is_shown(text) or value == self._bounded(value))
        state = QtGui.QValidator.Acceptable if sound else QtGui.QValidator.Intermediate
        return state, text, place

    def stepBy(self, steps: int) -> None:
        """Go on by so many of the unit that is shown; Qt asks for it."""
        self.exact = self._bounded(self.exact + steps * self._factor)
        self.selectAll()

    def sizeHint(self) -> QtCore.QSize:
        """Room for a common length and for words; Qt would leave it for the largest number."""
        if self._size is None:
            words = self.fontMetrics().boundingRect(self._absent).width() + _ARROWS
            self._size = QtCore.QSize(max(_WIDE, words), super().sizeHint().height())
        return self._size

    def minimumSizeHint(self) -> QtCore.QSize:
        """Less where words need more; Qt asks for it."""
        return QtCore.QSize(_WIDE, self.sizeHint().height())

    def focusInEvent(self, event: QtGui.QFocusEvent) -> None:
        """Choose the words for an absent number, so that typing takes their place."""
        super().focusInEvent(event)
        if self._absent and self.text() == self._absent:
            self._chosen.start(0)

    def wheelEvent(self, event: QtGui.QWheelEvent) -> None:
        """Leave the wheel to the panel unless the field was clicked on."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()

    def _show_fellows(self) -> None:
        for box in self._fellows:
            box._held = box.exact
        for box in self._fellows:
            box.setValue(box._held)

    def _bounded(self, value: float) -> float:
        return min(max(value, self.minimum()), self.maximum())

    def _is_shown(self, text: str) -> bool:
        return text in (self._words(self._held)[0], *([self._absent] if self._held == 0.0 else []))

    def _words(self, value: float) -> tuple[str, float]:
        """A value in words, and how much of the field's own unit is one of the unit in them."""
        shown = 0.0 if abs(value) < _NOTHING else value
        words, factor, _ = FreeCAD.Units.Quantity(shown, _KINDS[self._unit]).getUserPreferred()
        exact = f"{shown:.{_DIGITS}g}"
        if float(exact) != shown:
            return words, factor
        # FreeCAD reads some of what it writes as something else, or shows a millimetre as 0.
        read = _quantity(words, self._unit, factor)
        if read is not None and math.isclose(read, shown, rel_tol=1e-9, abs_tol=_NOTHING):
            return words, factor
        return f"{exact} {self._unit}", 1.0

    def _parsed(self, text: str) -> float | None:
        return _quantity(text, self._unit, self._factor)


def _quantity(text: str, unit: str, factor: float) -> float | None:
    """A text as a number of some unit, None where it is none; a bare one is in that of a factor."""
    try:
        value = float(text.strip().replace(",", ".")) * factor
    except ValueError:
        pass
    else:
        return value if math.isfinite(value) else None
    try:
        quantity = FreeCAD.Units.Quantity(text)
    except ValueError:
        return None
    if not text.strip():
        return None
    if quantity.Unit == _KINDS[unit]:
        return float(quantity.Value)
    return float(quantity.Value) * factor if quantity.Unit == FreeCAD.Units.Unit() else None
