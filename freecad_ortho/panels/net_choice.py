"""Which net is wanted: the recommendation, the choice, and what only some nets ask for."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from freecad_ortho import convert
from freecad_ortho.objects.net import is_net
from freecad_ortho.panels.fields import ChoiceField, form_rows, sentence
from freecad_ortho.panels.net_words import explain, net_words, reason_words
from freecad_ortho.panels.option_fields import OptionField
from solver.analysis.advisor import Advice, advise
from solver.nets import NETS
from solver.nets.options import OPTIONS
from solver.nets.supports import SUPPORTS

translate = FreeCAD.Qt.translate

_ASKED = {SUPPORTS.name: SUPPORTS, **OPTIONS}


class NetChoice:
    """A box of a form.

    Args:
        net: the Net.
        stored: its settings, as ``documents.net_settings.words`` gives them.

    Attributes:
        box: to be put into the form.
        net_type: the choice.
        fields: what only some nets ask for, by the name of the option; ``rows`` hold them.
    """

    def __init__(self, net: FreeCAD.DocumentObject, stored: dict[str, Any]) -> None:
        self._net = net
        self._stored = {name: stored[name] for name in _ASKED}
        mesh = convert.quad_mesh(net)
        self._advice = advise(mesh)
        # What makes no difference to this mesh is not asked.
        self._idle = () if mesh.connectivity.singular.any() else ("singular",)
        words, chosen = net_words(mesh.connectivity.mixed), stored["net"]
        self.net_type = ChoiceField(words, chosen if chosen in words else next(iter(words)))
        self.recommendation = _wrapped()
        self.use = QtGui.QPushButton(translate("Ortho", "Use"))
        self.use.setToolTip(translate("Ortho", "Choose the recommended net."))
        self.use.clicked.connect(self._use_best)
        self.explanation = _wrapped()
        self.explanation.setEnabled(False)
        twins = _twins(net)
        self.fields = {
            name: OptionField(option, stored[name], twins) for name, option in _ASKED.items()
        }
        self.box = QtGui.QGroupBox(translate("Ortho", "Net"))
        column = QtGui.QVBoxLayout(self.box)
        advised = QtGui.QHBoxLayout()
        advised.addWidget(self.recommendation, 1)
        advised.addWidget(self.use)
        column.addLayout(advised)
        column.addWidget(self.net_type.widget)
        column.addWidget(self.explanation)
        # Rows of a form would leave gaps where they are hidden.
        self.rows = {
            name: _row(translate("Ortho", option.label), self.fields[name].widget)
            for name, option in _ASKED.items()
        }
        for row in self.rows.values():
            column.addWidget(row)
        self.net_type.widget.currentIndexChanged.connect(lambda _: self._change())
        self._show()

    @property
    def words(self) -> dict[str, Any]:
        """The choices as keywords of ``optimise_net``, and those of other nets as they are."""
        chosen = self.net_type.word
        # Another net begins on the edges, whatever the one before was asked of.
        own = {name: self.fields[name].value for name in ("diagonal", *NETS[chosen].told)}
        return {"net": chosen, **self._stored, **own}

    @property
    def _diagonal(self) -> bool:
        """Whether the net that is chosen is asked of the diagonals."""
        return self.fields["diagonal"].value and True in NETS[self.net_type.word].variants

    def _change(self) -> None:
        """Begin with another net, on the edges."""
        self.fields["diagonal"].value = False
        self._show()

    def _show(self) -> None:
        """Show what belongs to the net that is chosen."""
        chosen = self.net_type.word
        for name, row in self.rows.items():
            row.setVisible(name in NETS[chosen].told and name not in self._idle)
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
            self.use.setVisible((best.net, best.diagonal) != (chosen, self._diagonal))
        self.explanation.setText(" ".join(filter(None, (explain(chosen), self._doubt(chosen)))))

    def _best(self) -> Advice | None:
        return self._advice[0] if self._advice and self._advice[0].possible else None

    def _doubt(self, chosen: str) -> str:
        for advice in self._advice:
            if advice.net == chosen and advice.diagonal == self._diagonal:
                return sentence(reason_words(advice.cause))
        return ""

    def _use_best(self) -> None:
        best = self._best()
        if best is not None:
            self.net_type.choose(best.net)
            self.fields["diagonal"].value = best.diagonal
            self._show()


def _twins(net: FreeCAD.DocumentObject) -> list[FreeCAD.DocumentObject]:
    """Other nets of the document with the same faces."""
    faces = list(net.Faces), convert.sizes_of(net)
    others = [item for item in net.Document.Objects if is_net(item) and item is not net]
    return [item for item in others if (list(item.Faces), convert.sizes_of(item)) == faces]


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
