"""Which net is wanted: the recommendation, the choice, and what only some nets ask for."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from freecad_ortho import convert
from freecad_ortho.objects.net import is_net
from freecad_ortho.objects.net_settings import FORCES, NETS
from freecad_ortho.panels.fields import (
    NARROW,
    ChoiceField,
    LengthField,
    NumberField,
    form_rows,
    leave_room,
    sentence,
)
from freecad_ortho.panels.net_words import explain, net_words, reason_words
from freecad_ortho.panels.quantity import QuantityField
from solver.analysis.advisor import Advice, advise

translate = FreeCAD.Qt.translate

_STAR_NETS = ("geodesic", "dog", "asymptotic", "cmc", "snet")
_CHEBYSHEV = ("chebyshev", "geodesic-chebyshev")


class NetChoice:
    """A box of a form.

    Args:
        net: the Net.
        stored: its settings, as ``documents.net_settings.words`` gives them.

    Attributes:
        box: to be put into the form.
        net_type: the choice.
    """

    def __init__(self, net: FreeCAD.DocumentObject, stored: dict[str, Any]) -> None:
        self._net = net
        self._advice = advise(convert.quad_mesh(net))
        self.net_type = ChoiceField({name: net_words()[name] for name in NETS}, stored["net"])
        self.recommendation = _wrapped()
        self.use = QtGui.QPushButton(translate("Ortho", "Use"))
        self.use.setToolTip(translate("Ortho", "Choose the recommended net"))
        self.use.clicked.connect(self._use_best)
        self.explanation = _wrapped()
        self.explanation.setEnabled(False)
        self._build_options(stored)
        self.box = QtGui.QGroupBox(translate("Ortho", "Net"))
        column = QtGui.QVBoxLayout(self.box)
        advised = QtGui.QHBoxLayout()
        advised.addWidget(self.recommendation, 1)
        advised.addWidget(self.use)
        column.addLayout(advised)
        column.addWidget(self.net_type.widget)
        column.addWidget(self.explanation)
        # Rows of a form would leave gaps where they are hidden.
        self._shown_for = [(_row(label, widget), nets) for label, widget, nets in self._rows]
        for row, _ in self._shown_for:
            column.addWidget(row)
        self.net_type.widget.currentIndexChanged.connect(lambda _: self._show())
        self._show()

    @property
    def words(self) -> dict[str, Any]:
        """The choices as keywords of ``optimise_net``; those of other nets keep their values."""
        return {
            "net": self.net_type.word,
            "diagonal": self.diagonal.isChecked(),
            "angle": self.angle.value,
            "radius": self.radius.millimetres or None,
            "length": self.length.millimetres or None,
            "per_family": self.per_family.isChecked(),
            "reference": self._references[self.reference.currentIndex()],
            "load": self.load.number or 0.0,
            "load_area": self.area_load.number or 0.0,
            "load_length": self.length_load.number or 0.0,
            "forces": self.forces.word,
        }

    def _build_options(self, stored: dict[str, Any]) -> None:
        self.diagonal = QtGui.QCheckBox(translate("Ortho", "on the face diagonals"))
        self.diagonal.setChecked(stored["diagonal"])
        self.per_family = QtGui.QCheckBox(translate("Ortho", "a length for each direction"))
        self.per_family.setChecked(stored["per_family"])
        automatic = translate("Ortho", "automatic")
        self.radius = LengthField(stored["radius"] or 0.0, absent=automatic)
        self.length = LengthField(stored["length"] or 0.0, absent=automatic)
        for field in (self.radius, self.length):
            field.widget.setToolTip(translate("Ortho", "Without a number the solver finds it."))
        self.angle = QuantityField("deg", stored["angle"])
        self.angle.widget.setMinimumWidth(NARROW)
        self._references = [None, *_twins(self._net)]
        self.reference = QtGui.QComboBox()
        self.reference.addItem(translate("Ortho", "as it starts"))
        self.reference.addItems([twin.Label for twin in self._references[1:]])
        leave_room(self.reference)
        if stored["reference"] in self._references:
            self.reference.setCurrentIndex(self._references.index(stored["reference"]))
        self.load = NumberField("load", stored["load"])
        self.area_load = NumberField("area load", stored["load_area"])
        self.length_load = NumberField("edge weight", stored["load_length"])
        words = {
            "free": translate("Ortho", "compression and tension"),
            "compression": translate("Ortho", "compression only"),
            "tension": translate("Ortho", "tension only"),
        }
        self.forces = ChoiceField({word: words[word] for word in FORCES}, stored["forces"])
        named = translate
        self._rows: list[tuple[str, QtGui.QWidget, tuple[str, ...]]] = [
            (named("Ortho", "Asked"), self.diagonal, _STAR_NETS),
            (named("Ortho", "Angle"), self.angle.widget, ("orthogonal",)),
            (named("Ortho", "Radius"), self.radius.widget, ("cmc",)),
            (named("Ortho", "Edge length"), self.length.widget, _CHEBYSHEV),
            (named("Ortho", "Edges"), self.per_family, _CHEBYSHEV),
            (named("Ortho", "Own shape"), self.reference, ("isometric",)),
            (named("Ortho", "Load at a vertex"), self.load.widget, ("stress",)),
            (named("Ortho", "Load of 1 mm2"), self.area_load.widget, ("stress",)),
            (named("Ortho", "Weight of 1 mm edge"), self.length_load.widget, ("stress",)),
            (named("Ortho", "Forces"), self.forces.widget, ("stress",)),
        ]

    def _show(self) -> None:
        """Show what belongs to the net that is chosen."""
        chosen = self.net_type.word
        for row, nets in self._shown_for:
            row.setVisible(chosen in nets)
        best = self._best()
        if best is None:
            self.recommendation.setText(translate("Ortho", "No recommendation for this mesh."))
            self.use.setVisible(False)
        else:
            name = net_words()[best.net].split(":")[0]
            if best.diagonal:
                name = translate("Ortho", "{} on the diagonals").format(name)
            self.recommendation.setText(translate("Ortho", "Recommended: <b>{}</b>").format(name))
            self.recommendation.setToolTip(
                translate("Ortho", "The mesh is {:.1e} from it on average").format(best.distance)
            )
            self.use.setVisible((best.net, best.diagonal) != (chosen, self.diagonal.isChecked()))
        self.explanation.setText(" ".join(filter(None, (explain(chosen), self._doubt(chosen)))))

    def _best(self) -> Advice | None:
        return self._advice[0] if self._advice and self._advice[0].possible else None

    def _doubt(self, chosen: str) -> str:
        for advice in self._advice:
            if advice.net == chosen and advice.diagonal == self.diagonal.isChecked():
                return sentence(reason_words(advice.cause))
        return ""

    def _use_best(self) -> None:
        best = self._best()
        if best is not None:
            self.diagonal.setChecked(best.diagonal)
            self.net_type.widget.setCurrentText(net_words()[best.net])
            self._show()


def _twins(net: FreeCAD.DocumentObject) -> list[FreeCAD.DocumentObject]:
    """Other nets of the document with the same faces."""
    faces = list(net.Faces)
    others = [item for item in net.Document.Objects if is_net(item) and item is not net]
    return [item for item in others if list(item.Faces) == faces]


def _row(label: str, widget: QtGui.QWidget) -> QtGui.QWidget:
    row = QtGui.QWidget()
    line = form_rows(row)
    line.setContentsMargins(0, 0, 0, 0)
    line.addRow(label, widget)
    return row


def _wrapped() -> QtGui.QLabel:
    label = QtGui.QLabel()
    label.setWordWrap(True)
    return label
