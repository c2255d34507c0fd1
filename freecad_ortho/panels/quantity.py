"""A field for a number with a unit that holds exactly what it was given or what was typed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui

# A number with no more than these was chosen by someone; others come out of a calculation.
_DIGITS = 6
# What is less is a rest of a calculation: FreeCAD would show it as so many nanometres.
_NOTHING = 1e-6
# So many fields are made until one is not taken for another.
_TRIES = 20


def _line(box: QtGui.QWidget) -> QtGui.QLineEdit | None:
    """The part of a field that shows its text.

    None where PySide takes it for something that was deleted before it and lay in the same place.
    It is asked for anew each time: PySide forgets a child with the widgets around it.
    """
    return box.findChild(QtGui.QLineEdit)


class Absent(QtCore.QObject):
    """Shows words in the place of a zero that stands for something else.

    FreeCAD's own field for quantities knows no text for a special value.
    """

    def __init__(self, box: QtGui.QWidget, words: str, unit: str) -> None:
        super().__init__(box)
        self._box, self._unit = box, unit
        # Those that are zero together where they stand for something else.
        self.fellows = [self]
        line = _line(box)
        line.setPlaceholderText(words)
        # The field writes its number anew when it loses the focus or is shown: look after that.
        self._later = QtCore.QTimer(self)
        self._later.setSingleShot(True)
        self._later.timeout.connect(self.show)
        box.installEventFilter(self)
        line.installEventFilter(self)

    def eventFilter(self, watched: QtCore.QObject, event: QtCore.QEvent) -> bool:
        """Look at the number again; Qt calls this."""
        if event.type() in (QtCore.QEvent.FocusOut, QtCore.QEvent.Show):
            self._later.start(0)
        return False

    def show(self) -> None:
        """Make room for the words where the number is zero, and so are those of its fellows."""
        absent = all(each.is_zero for each in self.fellows)
        for each in self.fellows:
            each.write(absent)

    @property
    def is_zero(self) -> bool:
        """Whether the number is zero."""
        return bool(self._box.property("rawValue") == 0.0)

    def write(self, absent: bool) -> None:
        """Clear the field for its words, or write the zero that they stood for."""
        line = _line(self._box)
        if line is None or self._box.hasFocus() or line.hasFocus() or not self.is_zero:
            return
        if absent:
            line.clear()
        elif not line.text():
            line.setText(f"0 {self._unit}")


def _box() -> Any:
    """A new field of FreeCAD's own.

    Where it or its text comes to lie in the place of what was deleted PySide now and then takes it
    for that. Another is made then, which lies elsewhere as the first still has its place.

    Raises:
        RuntimeError: PySide takes each of them for deleted.
    """
    mistaken = []
    for _ in range(_TRIES):
        widget = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        if _alive(widget):
            return widget
        mistaken.append(widget)
    raise RuntimeError(f"no field for a quantity in {_TRIES} tries")


def _alive(widget: QtGui.QWidget) -> bool:
    """Tell whether PySide knows a new field and its text for what they are."""
    try:
        return _line(widget) is not None
    except RuntimeError:
        return False


class QuantityField(QtCore.QObject):
    """FreeCAD's own field in the user's unit system, which by itself takes what it shows for true.

    In US building units it makes 1/2", 12.7 mm, of 12 mm, and again whenever it comes into sight.
    A round number that the user's units cannot show is shown in the field's own unit instead.

    Args:
        unit: ``mm``, ``mm^2`` or ``deg``: that of the value.
        value: to begin with.
        minimum: the least that can be entered.
        maximum: the most.
        absent: shown in place of 0, where that stands for something else.

    Attributes:
        widget: to be put into a form.
    """

    def __init__(
        self,
        unit: str,
        value: float = 0.0,
        minimum: float | None = None,
        maximum: float | None = None,
        absent: str = "",
    ) -> None:
        self.widget = _box()
        super().__init__(self.widget)
        self._unit = unit
        self.widget.setProperty("unit", unit)
        for name, limit in (("minimum", minimum), ("maximum", maximum)):
            if limit is not None:
                self.widget.setProperty(name, limit)
        self._absent = Absent(self.widget, absent, unit) if absent else None
        self.value = value
        self._afterwards = QtCore.QTimer(self)
        self._afterwards.setSingleShot(True)
        self._afterwards.timeout.connect(self._write_again)
        self.widget.installEventFilter(self)

    @staticmethod
    def joined(fields: Sequence[QuantityField]) -> None:
        """Show the words for an absent number only where all of several fields are zero."""
        fellows = [field._absent for field in fields if field._absent is not None]
        for one in fellows:
            one.fellows = fellows
        if fellows:
            fellows[0].show()

    @property
    def value(self) -> float:
        """The value, in the unit of the field."""
        shown = self.widget.text() in self._texts
        return self._value if shown else float(self.widget.property("rawValue"))

    @value.setter
    def value(self, value: float) -> None:
        self.widget.setProperty("rawValue", float(value) if abs(value) >= _NOTHING else 0.0)
        rounded = self.widget.text()
        exact = f"{value:.{_DIGITS}g}"
        held = self.widget.property("rawValue")
        kept = math.isclose(held, value, rel_tol=1e-9, abs_tol=_NOTHING)
        # A millimetre is 0 in US building units, though the field holds it.
        seen = abs(value) < _NOTHING or any(figure in rounded for figure in "123456789")
        if float(exact) == value and not (kept and seen):
            self._write(f"{exact} {self._unit}")
        self._show_absent()
        self._value = float(value)
        self._texts = {rounded, self.widget.text()}

    def eventFilter(self, watched: Any, event: Any) -> bool:
        """Write again what FreeCAD rounds when the field comes into sight; Qt calls this."""
        if event.type() == QtCore.QEvent.Show:
            self._value, self._seen = self.value, self.widget.text()
            self._texts.add(self._seen)
            self._afterwards.start(0)
        return False

    def _write_again(self) -> None:
        self._texts = {self.widget.text(), self._seen}
        self._write(self._seen)
        self._show_absent()

    def _show_absent(self) -> None:
        if self._absent is not None:
            self._absent.show()

    def _write(self, text: str) -> None:
        line = _line(self.widget)
        # Without it FreeCAD's rounded text stays, which stands for the exact value as well.
        if line is not None:
            line.setText(text)
