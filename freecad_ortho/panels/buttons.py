"""Buttons of task panels, as FreeCAD takes them with Qt 5 and Qt 6."""

from __future__ import annotations

from PySide import QtGui


def close_only() -> int:
    """Give the number of the one button Close; Qt 6 has it as an enumeration's value."""
    button = QtGui.QDialogButtonBox.Close
    return int(getattr(button, "value", button))
