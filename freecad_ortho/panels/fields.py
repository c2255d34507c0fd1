"""Input fields of the task panels."""

from __future__ import annotations

import numbers

import FreeCAD
from PySide import QtCore, QtGui

from freecad_ortho.panels.quantity import QuantityBox
from solver.errors import InputError
from solver.sentence import Measured, Sentence

NARROW = 100
# The most that one line of a task panel holds, in the width that FreeCAD gives it at first, beside
# a scroll bar and inside the frame of a group.
BROAD = 180
# Of an editable list of words, what its arrow and frame take.
_ARROW = 45
# Letters of a name in a title.
_TITLE = 12


def form_rows(parent: QtGui.QWidget | None = None) -> QtGui.QFormLayout:
    """Give a layout of labels and fields; a field that finds no room stands below its label."""
    rows = QtGui.QFormLayout(parent)
    rows.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
    rows.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
    return rows


def leave_room(box: QtGui.QComboBox) -> None:
    """Make a list of words as wide as its longest word, as far as the task panel allows."""
    wide = box.sizeHint().width()
    if box.isEditable():
        # Its own hint is that of a line of text.
        words = (box.itemText(k) for k in range(box.count()))
        wide = max(box.fontMetrics().boundingRect(word).width() for word in words) + _ARROW
    box.setMinimumWidth(min(max(wide, NARROW), BROAD))


class _Elided(QtGui.QLabel):
    """A text of the user's that may be long: it ends in dots where the room does."""

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self.setToolTip(text)

    def minimumSizeHint(self) -> QtCore.QSize:
        """No wider than anything else in a task panel; Qt asks for it."""
        return QtCore.QSize(NARROW, super().minimumSizeHint().height())

    def sizeHint(self) -> QtCore.QSize:
        """As wide as the text, as far as the task panel allows; Qt asks for it."""
        hint = super().sizeHint()
        return QtCore.QSize(min(hint.width(), BROAD), hint.height())

    def paintEvent(self, event: object) -> None:
        """Draw as much of the text as there is room for; Qt calls this."""
        painter = QtGui.QPainter(self)
        room = self.fontMetrics().elidedText(self.text(), QtCore.Qt.ElideRight, self.width())
        painter.drawText(self.rect(), QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter, room)
        painter.end()


def elided(text: str) -> QtGui.QLabel:
    """Give a label for a name that the user chose, which may be longer than a panel is wide."""
    return _Elided(text)


def shortened(text: str) -> str:
    """Cut a name that the user chose so that a title with it is no wider than a panel."""
    return text if len(text) <= _TITLE else text[: _TITLE - 1] + "\N{HORIZONTAL ELLIPSIS}"


def hint(text: str = "") -> QtGui.QLabel:
    """Give a label for sentences, on as many lines as they need."""
    label = QtGui.QLabel(text)
    label.setWordWrap(True)
    return label


class LengthField:
    """A field for a length that speaks the user's unit system.

    ``absent`` is shown in place of 0, where that stands for something else.
    """

    def __init__(self, millimetres: float, signed: bool = False, absent: str = "") -> None:
        least = None if signed else 0.0
        self.widget = QuantityBox("mm", millimetres, minimum=least, absent=absent)
        self.widget.setMinimumWidth(NARROW)

    @property
    def millimetres(self) -> float:
        """The length in mm."""
        return self.widget.exact

    @millimetres.setter
    def millimetres(self, value: float) -> None:
        self.widget.exact = value


class ChoiceField:
    """A list of words to choose from, shown translated."""

    def __init__(self, words: dict[str, str], chosen: str, editable: bool = False) -> None:
        self.widget = QtGui.QComboBox()
        self.widget.setEditable(editable)
        self._words = words
        self.widget.addItems(list(words.values()))
        self.widget.setCurrentText(words[chosen])
        leave_room(self.widget)

    @property
    def word(self) -> str:
        """The untranslated word, or what the user typed."""
        shown = self.widget.currentText().strip()
        for word, text in self._words.items():
            if text == shown:
                return word
        return shown

    def choose(self, word: str) -> None:
        """Show a word, or where it may be typed any text."""
        self.widget.setCurrentText(self._words.get(word, word))


class NumberField:
    """A number that may be left empty, as in "let the solver choose"."""

    def __init__(self, name: str, value: float | None = None, whole: bool = False) -> None:
        self._name, self._whole = name, whole
        self.widget = QtGui.QLineEdit("" if value is None else f"{value:g}")
        if value is None:
            self.widget.setPlaceholderText(FreeCAD.Qt.translate("Ortho", "automatic"))

    @property
    def number(self) -> float | None:
        """The number, None when the field is empty.

        Raises:
            InputError: not a number.
        """
        text = self.widget.text().strip().replace(",", ".")
        if not text:
            return None
        try:
            return int(text) if self._whole else float(text)
        except ValueError:
            raise InputError(f"{self._name}: '{text}' is not a number; give one like 0.1") from None


class TextField:
    """A line of text."""

    def __init__(self, text: str = "") -> None:
        self.widget = QtGui.QLineEdit(text)

    @property
    def text(self) -> str:
        """What was typed, without blanks around it."""
        return self.widget.text().strip()


def sentence(words: str) -> str:
    """Words of a table, which begin small and end without a full stop, as a sentence."""
    return f"{words[:1].upper()}{words[1:]}{'' if words[-1:] in '.!?' else '.'}"


def in_users_words(said: object) -> str:
    """A sentence of another room in the user's language and units; what is no such as it is."""
    if isinstance(said, tuple):
        return ", ".join(map(in_users_words, said))
    if isinstance(said, Measured):
        kind = FreeCAD.Units.Length if said.power == 1 else FreeCAD.Units.Area
        return str(FreeCAD.Units.Quantity(said.value, kind).UserString)
    if not isinstance(said, Sentence):
        return str(said)
    # Numbers stay numbers: the pattern says how they are written.
    values = (x if isinstance(x, numbers.Real) else in_users_words(x) for x in said.values)
    return str(FreeCAD.Qt.translate("Ortho", said.pattern)).format(*values)


def length_words(millimetres: float) -> str:
    """A length in the user's units."""
    return str(FreeCAD.Units.Quantity(millimetres, FreeCAD.Units.Length).UserString)
