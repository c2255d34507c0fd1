"""Task panel in which a multi-net is drawn: a polyline on a quadric, the net follows at once."""

from __future__ import annotations

from typing import Any

import FreeCAD
import numpy as np
from PySide import QtGui

from freecad_ortho.panels.source_panel import SourcePanel
from freecad_ortho.sources.multinets import first_polyline, quadric_of
from freecad_ortho.sources.quadric_shape import quadric_mesh
from freecad_ortho.view.drawing import Drawing
from solver.errors import OrthoError
from solver.mesh.quadmesh import FloatArray
from solver.multinet import Quadric

translate = FreeCAD.Qt.translate


class MultiNetPanel(SourcePanel):
    """The fields of a multi-net, and the mouse: points are set on the quadric and dragged.

    A new panel shows a first polyline; *Draw* begins another one.
    """

    def __init__(
        self,
        title: str,
        picture: str,
        document: FreeCAD.Document,
        edited: FreeCAD.DocumentObject | None = None,
    ) -> None:
        self.drawing: Drawing | None = None
        self._ground: str | None = None
        super().__init__(title, picture, "multi-net", document, edited=edited)

    @property
    def quadric(self) -> Quadric:
        """The quadric of the fields.

        Raises:
            InputError: its semi-axes are not positive.
        """
        fields = {name: self.fields[name].value for name in ("quadric", "semi_axes", "placement")}
        rotation, origin = fields["placement"]
        place = np.asarray(rotation, dtype=float), np.asarray(origin, dtype=float)
        return quadric_of(fields["quadric"], fields["semi_axes"], place)

    def look(self) -> None:
        """Follow the quadric with the points, then the net with both."""
        try:
            self._follow_quadric()
        except OrthoError:
            # The net's own message says what is wrong with the quadric.
            pass
        if self.drawing is not None and self.drawing.adding and len(self.drawing.points) < 2:
            self.preview.show(None)
            self.made = None
            self._last = None
            self._say(translate("Ortho", "Click points on the quadric; right click or Esc ends."))
            return
        super().look()

    def draw(self) -> None:
        """Begin a new polyline: clicks in the 3D view set its points."""
        self.drawing.set_points(np.zeros((0, 3)))
        self.drawing.adding = True
        self._drawn()

    def add_points(self, adding: bool) -> None:
        """Let clicks add points at the end of the polyline, or no longer."""
        self.drawing.adding = adding
        self._show_state()

    def _follow_quadric(self) -> None:
        quadric = self.quadric
        state = repr((quadric.curvatures.tolist(), quadric.rotation.tolist(), quadric.centre))
        if state == self._ground:
            return
        before, self._ground = self._ground, state
        self.preview.show_ground(quadric_mesh(quadric))
        if self.drawing is None:
            self.drawing = Drawing(
                self.view, self._picked, self._drawn, self._show_state, self.stands
            )
        points = self.fields["points"].value
        if not len(points) or (before is not None and not self._fit_here(points, quadric)):
            points = first_polyline(quadric)
        self._set_local(quadric.project(quadric.from_frame(np.asarray(points))), quadric)
        self.drawing.set_points(quadric.from_frame(self._local))
        self._show_state()

    def _fit_here(self, points: Any, quadric: Quadric) -> bool:
        """Whether points of the last quadric still make sense near this one."""
        projected = quadric.project(quadric.from_frame(np.asarray(points)))
        steps = np.linalg.norm(np.diff(projected, axis=0), axis=1)
        sheets = (quadric.curvatures < 0).sum() < 2 or len(set(np.sign(projected[:, 0]))) == 1
        return bool(len(steps) and steps.min() > 1e-3 * steps.sum() and sheets)

    def _picked(self, origin: FloatArray, direction: FloatArray) -> FloatArray | None:
        """The first point of the quadric on a ray; beside it while dragging the nearest one."""
        quadric = self.quadric
        hits = quadric.hits(origin, direction)
        ahead = hits[(hits - origin) @ direction > 0]
        if len(ahead):
            return ahead[0]
        if self.drawing is None or self.drawing.adding:
            return None
        closest = origin + ((quadric.centre - origin) @ direction) * direction
        return quadric.project(closest)

    def _drawn(self) -> None:
        self._set_local(self.drawing.points, self.quadric)
        self._show_state()
        self.look()

    def _set_local(self, points: FloatArray, quadric: Quadric) -> None:
        self._local = quadric.to_frame(points)
        self.fields["points"].value = tuple(map(tuple, self._local.tolist()))

    def _show_state(self) -> None:
        adding = self.drawing is not None and self.drawing.adding
        self.add_button.setChecked(adding)
        count = 0 if self.drawing is None else len(self.drawing.points)
        self.points_label.setText(translate("Ortho", "{} points").format(count))

    def _build_form(self, title: str, picture: str, group: str, edited: Any) -> None:
        super()._build_form(title, picture, group, edited)
        self.draw_button = QtGui.QPushButton(translate("Ortho", "Draw"))
        self.draw_button.setToolTip(
            translate("Ortho", "Begin a new polyline: click its points on the quadric.")
        )
        self.draw_button.clicked.connect(self.draw)
        self.add_button = QtGui.QPushButton(translate("Ortho", "Add points"))
        self.add_button.setCheckable(True)
        self.add_button.setToolTip(
            translate("Ortho", "Clicks add points at the end; Backspace takes the last one away.")
        )
        self.add_button.clicked.connect(self.add_points)
        self.points_label = QtGui.QLabel()
        line = QtGui.QHBoxLayout()
        for widget in (self.draw_button, self.add_button):
            line.addWidget(widget)
        self.form.layout().insertLayout(2, line)
        self.form.layout().insertWidget(3, self.points_label)

    def _clear(self, *_: Any) -> None:
        super()._clear()
        if self.drawing is not None:
            self.drawing.remove()
