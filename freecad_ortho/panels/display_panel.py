"""Task panel that chooses colours and overlays of a net, seen at once."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtGui

from freecad_ortho.objects.net import COLOUR_MAPS, colour_field
from freecad_ortho.panels.fields import ChoiceField, NumberField, elided, form_rows, hint
from freecad_ortho.resources import icon
from freecad_ortho.view import look
from freecad_ortho.window import context, messages
from solver.analysis.fields import residuals
from solver.errors import InputError

translate = FreeCAD.Qt.translate


class DisplayPanel:
    """What is chosen is shown at once; OK keeps it as one undo step, Cancel goes back."""

    def __init__(self, net: FreeCAD.DocumentObject) -> None:
        self._document, self._name = net.Document.Name, net.Name
        self._before = look.current(net)
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Ortho", "Display"))
        self.form.setWindowIcon(QtGui.QIcon(icon("display")))
        rows = form_rows(self.form)
        rows.setContentsMargins(0, 6, 0, 6)
        rows.addRow(translate("Ortho", "Net"), elided(net.Label))
        self.hidden = hint(translate("Ortho", "The net is hidden: nothing of this is seen."))
        self.reveal = QtGui.QPushButton(translate("Ortho", "Show the net"))
        self.reveal.clicked.connect(self._reveal)
        for widget in (self.hidden, self.reveal):
            rows.addRow(widget)
            widget.setVisible(not net.Visibility)
        words = {name: translate("Ortho", name) for name in COLOUR_MAPS}
        self.colour_map = ChoiceField(words, net.ColourMap)
        self.colour_map.widget.setToolTip(translate("Ortho", "This quantity colours the net."))
        self.low = NumberField(translate("Ortho", "From"))
        self.high = NumberField(translate("Ortho", "To"))
        self.legend = QtGui.QCheckBox(translate("Ortho", "Show the scale"))
        self.legend.setChecked(net.ViewObject.Legend)
        rows.addRow(translate("Ortho", "Colour map"), self.colour_map.widget)
        rows.addRow(translate("Ortho", "From"), self.low.widget)
        rows.addRow(translate("Ortho", "To"), self.high.widget)
        rows.addRow("", self.legend)
        group = QtGui.QGroupBox(translate("Ortho", "Overlays"))
        boxes = QtGui.QVBoxLayout(group)
        self.overlays: dict[str, QtGui.QCheckBox] = {}
        for name, words_shown in overlay_words().items():
            box = QtGui.QCheckBox(words_shown)
            box.setChecked(bool(getattr(net.ViewObject, name)))
            boxes.addWidget(box)
            self.overlays[name] = box
        rows.addRow(group)
        self._explain_range()
        self._listen()

    @property
    def net(self) -> FreeCAD.DocumentObject | None:
        """The net, None when it or its document has gone meanwhile."""
        if self._document not in FreeCAD.listDocuments():
            return None
        return FreeCAD.getDocument(self._document).getObject(self._name)

    def settings(self) -> dict[str, Any]:
        """The choice as ``freecad_ortho.api.show_net`` takes it.

        Raises:
            InputError: a field does not hold a number, or only one of the two is filled in.
        """
        low, high = self.low.number, self.high.number
        if (low is None) != (high is None):
            raise InputError(
                translate("Ortho", "range: give both numbers, or none for an automatic range")
            )
        settings: dict[str, Any] = {"colour_map": self.colour_map.word}
        if low is not None:
            settings["value_range"] = (low, high)
        settings["overlays"] = [name for name, box in self.overlays.items() if box.isChecked()]
        settings["legend"] = self.legend.isChecked()
        return settings

    def accept(self) -> bool:
        """Keep what is shown, as one undo step and one line of a macro."""
        if self.net is not None:
            try:
                settings = self.settings()
                look.show(self.net, self._before)
                context.run("show_net", self.net, **settings)
            except InputError as error:
                messages.show_error(str(error))
                return False
        FreeCADGui.Control.closeDialog()
        return True

    def reject(self) -> bool:
        """Show the net as it was."""
        if self.net is not None:
            look.show(self.net, self._before)
        FreeCADGui.Control.closeDialog()
        return True

    def _reveal(self) -> None:
        """Show the net, beside what stands on it."""
        if self.net is not None:
            self.net.Visibility = True
        for widget in (self.hidden, self.reveal):
            widget.setVisible(False)

    def _listen(self) -> None:
        self.colour_map.widget.currentTextChanged.connect(self._explain_range)
        self.colour_map.widget.currentTextChanged.connect(self._preview)
        for field in (self.low, self.high):
            field.widget.editingFinished.connect(self._preview)
        for box in (self.legend, *self.overlays.values()):
            box.toggled.connect(self._preview)

    def _explain_range(self, *_: Any) -> None:
        """Say in which units the range is given; a range of another quantity means nothing."""
        residual = colour_field(self.net, self.colour_map.word) in residuals()
        tip = (
            translate("Ortho", "The range goes by powers of ten, such as -6.")
            if residual
            else translate("Ortho", "Lengths are in mm, curvatures in 1/m, angles in degrees.")
        )
        for field in (self.low, self.high):
            field.widget.setText("")
            field.widget.setToolTip(tip)
            field.widget.setEnabled(self.colour_map.word != "None")

    def _preview(self, *_: Any) -> None:
        if self.net is None:
            return
        try:
            settings = self.settings()
        except InputError:
            # Half-typed: shown as soon as it is whole, said when OK is pressed.
            return
        look.show(self.net, look.wanted(self.net, **{"value_range": None, **settings}))


def overlay_words() -> dict[str, str]:
    """Overlays by name, in the user's language."""
    return {
        "Upside": translate("Ortho", "Arrow on the upper side"),
        "ParameterLines": translate("Ortho", "Parameter lines u and v"),
        "Diagonals": translate("Ortho", "Diagonals"),
        "MedialLines": translate("Ortho", "Medial lines"),
        "Axes": translate("Ortho", "Node axes"),
        "Rulings": translate("Ortho", "Rulings of strips"),
        "StarSpheres": translate("Ortho", "Spheres of vertex stars"),
        "IrregularVertices": translate("Ortho", "Irregular vertices"),
        "Supports": translate("Ortho", "Supports"),
        "Loads": translate("Ortho", "Loads"),
        "Forces": translate("Ortho", "Forces under equal loads"),
        "GaussImage": translate("Ortho", "Gauss image"),
        "ReflectionLines": translate("Ortho", "Reflection lines"),
    }
