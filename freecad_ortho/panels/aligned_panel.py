"""Task panel of nets along curvature: made in the background, with their field and strokes."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Any

import FreeCAD
import numpy as np
from PySide import QtGui

from freecad_ortho.objects import cad_faces, source_net
from freecad_ortho.objects.making import Making
from freecad_ortho.objects.strokes import curves
from freecad_ortho.panels.aside import Aside
from freecad_ortho.panels.singular_box import Rows, SingularBox
from freecad_ortho.panels.source_panel import SourcePanel
from freecad_ortho.panels.stroke_box import StrokeBox
from freecad_ortho.sources import GROUPS, Made, source
from freecad_ortho.view.field_shapes import crosses, singular_points, stroke_lines
from freecad_ortho.view.surface_hand import SurfaceHand
from freecad_ortho.window import messages
from solver.errors import OrthoError
from solver.mesh.quadmesh import FloatArray

translate = FreeCAD.Qt.translate

# Seconds without a change after which a net is made.
_SETTLED = 0.35


class AlignedPanel(SourcePanel):
    """The fields of a net along curvature; it is made aside, and OK waits for it.

    Its singular vertices are dragged along the surface or added, and strokes are drawn on it.

    Attributes:
        aside: makes the net.
    """

    def look(self) -> None:
        """Begin to make the net once the fields have settled."""
        if self.strokes.strokes != list(self.inputs.strokes):
            self.inputs = replace(self.inputs, strokes=list(self.strokes.strokes))
            self._show_parts()
        named = [(feature.Name, part) for feature, part in self.inputs.strokes]
        state = repr((self.values(), named))
        if state != self._last:
            settling = 0.0 if self._last is None else _SETTLED
            self._last, self._begin_at = state, time.monotonic() + settling
            self._halt()
            self._waits = True
            self._say(translate("Ortho", "The net follows in a moment."))
        if self._waits and time.monotonic() >= self._begin_at:
            self.begin()

    def begin(self) -> None:
        """Make the net as the fields say, in place of what is under way."""
        self._waits, self._error = False, None
        try:
            making = self._making()
        except OrthoError as error:
            self._ended(None, str(error))
            return
        self.aside.ask(making.made)
        self._reached(making.entry.stages[0])
        self._show_state()

    def stop(self) -> None:
        """Make nothing until a field changes, or OK is pressed."""
        self._halt()
        self._say(translate("Ortho", "Stopped. A change or OK begins again."))

    def accept(self) -> bool:
        """Keep the net that is shown; where it is not the one that is wanted, as soon as it is."""
        if self._document not in FreeCAD.listDocuments() or self._is_shown:
            return super().accept()
        if self._error is not None:
            messages.show_error(self._error)
            return False
        self._accepting = True
        if not self.aside.busy:
            self.begin()
        self._show_state()
        return False

    def dropped(self, number: int, place: FloatArray, reach: float) -> None:
        """A singular vertex was dragged to a place, or onto another within reach."""
        if not self._accepting:
            self.singular.dropped(number, place, reach)

    def drawn(self, line: FloatArray) -> None:
        """A stroke was drawn."""
        if not self._accepting:
            self.strokes.add_line(tuple(map(tuple, line.tolist())))

    def added(self, place: FloatArray) -> None:
        """A singular vertex is wanted at a place."""
        if not self._accepting:
            self.singular.added(place)

    def _give_adding(self, on: bool) -> None:
        if on:
            self.strokes.draw_button.setChecked(False)
            self.strokes.pick_button.setChecked(False)
        self.hand.adding = on

    def _give_singular(self, rows: Rows | None) -> None:
        self.fields["singularities"].value = rows
        self._show_parts()

    def _give_lines(self) -> None:
        self.hand.drawing = self.strokes.draw_button.isChecked()
        if self.hand.drawing or self.strokes.pick_button.isChecked():
            self.singular.add_button.setChecked(False)
        self.fields["drawn_strokes"].value = self.strokes.lines
        self._show_parts()

    @property
    def _is_shown(self) -> bool:
        """Tell whether the net on the screen is the one that the fields ask for."""
        self.look()
        return self.made is not None and not self._waits and not self.aside.busy

    def _making(self) -> Making:
        document = FreeCAD.getDocument(self._document)
        edited = document.getObject(self._edited) if self._edited else None
        return Making.of(self.source, self.values(), self.inputs, edited)

    def _halt(self) -> None:
        self.aside.stop()
        self.made, self._waits, self._accepting = None, False, False
        self._show_state()

    def _reached(self, stage: str) -> None:
        names = {
            "surface": translate("Ortho", "surface"),
            "curvature": translate("Ortho", "curvature"),
            "directions": translate("Ortho", "directions"),
            "map": translate("Ortho", "map"),
            "quads": translate("Ortho", "quads"),
        }
        stages = self.source.stages
        self.bar.setRange(0, len(stages))
        self.bar.setValue(stages.index(stage))
        words = translate("Ortho", "Step {} of {}: {}")
        self._say(words.format(stages.index(stage) + 1, len(stages), names[stage]))

    def _ended(self, made: Made | None, error: str | None) -> None:
        accepting, self._accepting = self._accepting, False
        self._error = error
        if made is None:
            self._say(error or "", wrong=True)
        else:
            self._show(made)
        self._show_state()
        if accepting and error is not None:
            messages.show_error(error)
        elif accepting:
            super().accept()

    def _show(self, made: Made) -> None:
        super()._show(made)
        first, self._seen = self._seen is None, made
        self.singular.found(made.singular)
        self._show_parts()
        if first and self._edited is None:
            self._fit()

    def _show_parts(self) -> None:
        """Show the net and what its lines follow; while strokes are picked the shapes instead."""
        seen, picking = self._seen, self.strokes.pick_button.isChecked()
        drawn = [np.array(line) for line in self.strokes.lines]
        shapes = stroke_lines([*curves(list(self.inputs.strokes)), *drawn])
        singular = self.singular.singular
        self.hand.points = np.zeros((0, 3))
        if seen is not None:
            self.preview.show(None if picking else seen.mesh)
            shapes += crosses(seen.field, seen.mesh.mean_edge) * self.field_box.isChecked()
        if singular is not None and not picking:
            shapes += singular_points(singular)
            self.hand.points = singular.places
        self.preview.show_marks(shapes)
        for feature in self._shown_before:
            feature.Visibility = picking or seen is None

    def _cover(self) -> None:
        """Nothing is hidden before there is something to be seen in its place."""

    def _changed(self) -> dict[str, Any]:
        """What is given anew to the net that is edited."""
        if self._edited is None:
            return super()._changed()
        stored = source_net.inputs_of(FreeCAD.getDocument(self._document).getObject(self._edited))
        same = list(stored.strokes) == list(self.inputs.strokes)
        return super()._changed() | ({} if same else {"strokes": list(self.inputs.strokes)})

    def _show_state(self) -> None:
        self.progress.setVisible(self.aside.busy)
        if self._table is not None:
            for widget in (self._table, self.strokes.widget, self.singular.widget):
                widget.setEnabled(not self._accepting)

    def _build_form(self, title: str, picture: str, group: str, edited: Any) -> None:
        super()._build_form(title, picture, group, edited)
        self.aside = Aside(self._reached, self._ended)
        self._waits = self._accepting = False
        self._seen: Made | None = None
        self._error: str | None = None
        self._begin_at = 0.0
        self.bar = QtGui.QProgressBar()
        self.bar.setTextVisible(False)
        self.stop_button = QtGui.QPushButton(translate("Ortho", "Stop"))
        self.stop_button.clicked.connect(self.stop)
        self.progress = QtGui.QWidget()
        line = QtGui.QHBoxLayout(self.progress)
        line.setContentsMargins(0, 0, 0, 0)
        line.addWidget(self.bar)
        line.addWidget(self.stop_button)
        self.form.layout().insertWidget(3, self.progress)
        self.hand = SurfaceHand(
            self.view, cad_faces.triangulated(self.inputs.faces), self, self.stands
        )
        values = {**source(GROUPS[group][0]).defaults, **self._starting}
        self.strokes = StrokeBox(
            self.inputs.strokes, values["drawn_strokes"], lambda: self._give_lines()
        )
        self.singular = SingularBox(values["singularities"], self._give_singular, self._give_adding)
        self.field_box = QtGui.QCheckBox(translate("Ortho", "Show the field"))
        self.field_box.setToolTip(
            translate(
                "Ortho",
                "The two directions that lines follow; grey where curvature does not say much.",
            )
        )
        self.field_box.toggled.connect(lambda on: self._show_parts())
        for title, part in (
            (translate("Ortho", "Strokes"), self.strokes),
            (translate("Ortho", "Singular vertices"), self.singular),
        ):
            box = QtGui.QGroupBox(title)
            QtGui.QVBoxLayout(box).addWidget(part.widget)
            self.form.layout().addWidget(box)
        self.form.layout().addWidget(self.field_box)
        self._show_state()

    def _clear(self, *_: Any) -> None:
        self.aside.stop()
        self.strokes.end()
        self.hand.remove()
        super()._clear()
