"""What stands in the part of a task panel that is seen without scrolling."""

from __future__ import annotations

from PySide import QtCore, QtGui


def bring_into_sight(*widgets: QtGui.QWidget) -> None:
    """Scroll the panel around widgets so far that they are seen; the last one counts most.

    Where they stand is known only after FreeCAD has laid out what has changed, so this waits for
    it.
    """

    def scroll() -> None:
        for widget in widgets:
            area = _area_around(widget)
            if area is not None and widget.isVisible():
                area.ensureWidgetVisible(widget, 0, 0)

    # As a child of the first widget it ends with the panel, and nothing is called afterwards.
    later = QtCore.QTimer(widgets[0])
    later.setSingleShot(True)
    later.timeout.connect(scroll)
    later.timeout.connect(later.deleteLater)
    later.start(0)


def _area_around(widget: QtGui.QWidget) -> QtGui.QScrollArea | None:
    around = widget.parentWidget()
    while around is not None and not isinstance(around, QtGui.QScrollArea):
        around = around.parentWidget()
    return around
