"""Buttons of task panels, as FreeCAD takes them with Qt 5 and Qt 6."""

from __future__ import annotations

from typing import Any

from PySide import QtGui


def number(button: Any) -> int:
    """Give the number of a standard button; Qt 6 has it as an enumeration's value."""
    return int(getattr(button, "value", button))


def close_only() -> int:
    """Give the number of the one button Close."""
    return number(QtGui.QDialogButtonBox.Close)
