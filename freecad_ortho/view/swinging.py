"""A drawn shape that swings to both sides."""

from __future__ import annotations

import math
import time

import FreeCAD
from PySide import QtCore

from freecad_ortho.view.frame_lines import FrameLines

# Milliseconds between pictures, seconds of one swing to and fro.
_PICTURE, _SWING = 40, 2.0


class Swinging:
    """Moves the lines of a frame while its document object is there and seen.

    Args:
        lines: what is moved.
        feature: the structural check.
    """

    def __init__(self, lines: FrameLines, feature: FreeCAD.DocumentObject) -> None:
        self._lines = lines
        self._document, self._name = feature.Document.Name, feature.Name
        self._begun = 0.0
        self._timer = QtCore.QTimer()
        self._timer.setInterval(_PICTURE)
        self._timer.timeout.connect(self._next)

    @property
    def going(self) -> bool:
        """Whether it swings."""
        return bool(self._timer.isActive())

    def toggle(self) -> None:
        """Begin to swing, or stand still where the shape is largest."""
        if self.going:
            self.stop()
            return
        self._begun = time.monotonic()
        self._timer.start()

    def stop(self) -> None:
        """Stand still; doing it again changes nothing."""
        if self.going:
            self._timer.stop()
            self._lines.sway(1.0)

    def _next(self) -> None:
        there = self._document in FreeCAD.listDocuments()
        feature = FreeCAD.getDocument(self._document).getObject(self._name) if there else None
        if feature is None or not feature.Visibility:
            self._timer.stop()
            return
        turn = 2 * math.pi * (time.monotonic() - self._begun) / _SWING
        self._lines.sway(math.cos(turn))
