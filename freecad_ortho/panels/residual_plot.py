"""A plot of residuals over steps, the residuals by powers of ten, drawn as a run goes on."""

from __future__ import annotations

import math
from collections.abc import Sequence

import FreeCAD
from PySide import QtCore, QtGui

_COLOURS = ((31, 84, 163), (200, 80, 20), (40, 130, 70), (140, 60, 150), (120, 110, 30))
_GRID = (128, 128, 128, 90)
_LEFT, _RIGHT, _TOP, _BOTTOM = 44, 8, 8, 18
_LOWEST, _EVERY = -16, 4
_LINE = 1.6


class ResidualPlot(QtGui.QWidget):
    """One line for each residual; a dashed line where it counts as zero.

    Attributes:
        series: values by name, one a step.
    """

    def __init__(self) -> None:
        super().__init__()
        self.series: dict[str, list[float]] = {}
        self._tolerance = 1e-10
        self.setMinimumHeight(150)
        self.setToolTip(
            FreeCAD.Qt.translate(
                "Ortho", "The largest residuals by steps. Below the dashed line they count as zero."
            )
        )

    def clear(self, tolerance: float) -> None:
        """Begin anew."""
        self.series, self._tolerance = {}, tolerance
        self.update()

    def add(self, records: Sequence[object]) -> None:
        """Append the residuals of steps."""
        for record in records:
            for name, value in record.residuals.items():
                self.series.setdefault(name, []).append(value)
        self.update()

    def paintEvent(self, event: object) -> None:
        """Draw; Qt calls this."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.fillRect(self.rect(), self.palette().color(QtGui.QPalette.Base))
        area = QtCore.QRectF(self.rect()).adjusted(_LEFT, _TOP, -_RIGHT, -_BOTTOM)
        values = [value for line in self.series.values() for value in line if value > 0]
        highest = max(0, math.ceil(math.log10(max(values)))) if values else 0
        self._draw_grid(painter, area, highest)
        for number, line in enumerate(self.series.values()):
            colour = QtGui.QColor(*_COLOURS[number % len(_COLOURS)])
            painter.setPen(QtGui.QPen(colour, _LINE))
            points = [
                self._place(area, highest, k, value, len(line)) for k, value in enumerate(line)
            ]
            painter.drawPolyline(QtGui.QPolygonF(points))
        self._draw_names(painter, area)
        painter.end()

    def _draw_names(self, painter: QtGui.QPainter, area: QtCore.QRectF) -> None:
        """Name the lines in their colours, on a ground that covers them."""
        ground = QtGui.QColor(self.palette().color(QtGui.QPalette.Base))
        ground.setAlpha(200)
        high = painter.fontMetrics().height()
        for number, name in enumerate(self.series):
            width = painter.fontMetrics().boundingRect(name).width() + 8
            place = QtCore.QRectF(area.right() - width, area.top() + number * high, width, high)
            painter.fillRect(place, ground)
            painter.setPen(QtGui.QColor(*_COLOURS[number % len(_COLOURS)]))
            painter.drawText(place, QtCore.Qt.AlignCenter, name)

    def _draw_grid(self, painter: QtGui.QPainter, area: QtCore.QRectF, highest: int) -> None:
        text = self.palette().color(QtGui.QPalette.Text)
        for decade in range(_LOWEST, highest + 1, _EVERY):
            height = self._height(area, highest, decade)
            painter.setPen(QtGui.QPen(QtGui.QColor(*_GRID), 1.0))
            painter.drawLine(
                QtCore.QPointF(area.left(), height), QtCore.QPointF(area.right(), height)
            )
            painter.setPen(text)
            label = "1" if decade == 0 else f"1e{decade}"
            width = painter.fontMetrics().boundingRect(label).width()
            painter.drawText(QtCore.QPointF(area.left() - width - 5, height + 4), label)
        dashed = QtGui.QPen(text, 1.0, QtCore.Qt.DashLine)
        painter.setPen(dashed)
        height = self._height(area, highest, math.log10(self._tolerance))
        painter.drawLine(QtCore.QPointF(area.left(), height), QtCore.QPointF(area.right(), height))
        painter.setPen(text)
        steps = max((len(line) for line in self.series.values()), default=0)
        words = FreeCAD.Qt.translate("Ortho", "{} steps").format(steps)
        width = painter.fontMetrics().boundingRect(words).width()
        painter.drawText(QtCore.QPointF(area.right() - width, self.height() - 4), words)

    def _height(self, area: QtCore.QRectF, highest: int, decade: float) -> float:
        part = (decade - _LOWEST) / (highest - _LOWEST)
        return area.bottom() - min(max(part, 0.0), 1.0) * area.height()

    def _place(
        self, area: QtCore.QRectF, highest: int, step: int, value: float, count: int
    ) -> QtCore.QPointF:
        decade = math.log10(value) if value > 0 else _LOWEST
        across = area.left() + area.width() * step / max(count - 1, 1)
        return QtCore.QPointF(across, self._height(area, highest, decade))
