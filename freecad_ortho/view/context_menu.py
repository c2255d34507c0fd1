"""Entries of the menu that a right click in the tree opens."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide import QtGui


def offer(menu: Any, words: str, action: Callable[[], object]) -> None:
    """Add an entry.

    Args:
        menu: of the object that was clicked.
        words: what it says, translated.
        action: what it does.
    """
    entry = QtGui.QAction(words, menu)
    # Qt says whether the entry is ticked; none of these can be.
    entry.triggered.connect(lambda *_: action())
    menu.addAction(entry)
