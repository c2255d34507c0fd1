"""Task panel that asks what a structural check is made of."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from freecad_ortho.objects import structural_check
from freecad_ortho.objects.kinds import BEAMS, LAMELLAS, is_structure
from freecad_ortho.panels.check_picking import LoadPicking, SupportPicking
from freecad_ortho.panels.fields import TextField, elided, form_rows, leave_room, shortened
from freecad_ortho.panels.option_fields import OptionField
from freecad_ortho.panels.work_panel import WorkPanel
from freecad_ortho.resources import icon
from freecad_ortho.structural.design import Design
from freecad_ortho.window import context, messages

translate = FreeCAD.Qt.translate

# Between texts of a list in one field.
_BETWEEN = ";"


class StructuralPanel(WorkPanel):
    """Members, supports and loads; OK checks.

    Args:
        net: whose edges are the members.
        edited: a check to change instead of making one.

    Attributes:
        fields: by the name of the option.
    """

    def __init__(
        self, net: FreeCAD.DocumentObject, edited: FreeCAD.DocumentObject | None = None
    ) -> None:
        self._document, self._net = net.Document.Name, net.Name
        self._edited = None if edited is None else edited.Name
        title = translate("Ortho", "Structural check")
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(title if edited is None else shortened(edited.Label))
        self.form.setWindowIcon(QtGui.QIcon(icon("structural_check")))
        self._rows = form_rows(self.form)
        self._rows.addRow(translate("Ortho", "Net"), elided(net.Label))
        around = [item for item in net.InList if is_structure(item)]
        self._beams = [None, *(item for item in around if item.System in (BEAMS, LAMELLAS))]
        self._cladding = [None, *(item for item in around if item.System != BEAMS)]
        given = translate("Ortho", "given here")
        self.beams = self._links(translate("Ortho", "Members"), self._beams, given)
        self.beams.setToolTip(
            translate("Ortho", "Section and material are those of these beams or lamellas.")
        )
        none = translate("Ortho", "none")
        self.cladding = self._links(translate("Ortho", "Weight of"), self._cladding, none)
        self.cladding.setToolTip(
            translate("Ortho", "The weight of this structure is a load by the surface.")
        )
        self.fields = {
            option.name: OptionField(option, option.default) for option in Design.options
        }
        self.texts = {"wind": TextField(), "load": TextField()}
        self.picking = SupportPicking(net, self.fields["supports"])
        self.load_picking = LoadPicking(net, self.texts["load"], _BETWEEN)
        self.picking.beside, self.load_picking.beside = self.load_picking, self.picking
        self._add_rows()
        self.beams.currentIndexChanged.connect(self._with_beams)
        self._before = self._chosen()
        if edited is not None:
            self._take_over(edited)

    @property
    def net(self) -> FreeCAD.DocumentObject | None:
        """The net, None when it or its document has gone meanwhile."""
        return self._object(self._net)

    def possible(self) -> bool:
        """Tell whether what is checked is still there."""
        there = self._edited is None or self._object(self._edited) is not None
        return self.net is not None and there

    def work(self) -> bool:
        """Check."""
        self._pick_no_more()
        chosen = self._chosen()
        new = {name: chosen[name] for name in chosen if chosen[name] != self._before[name]}
        if self._edited is None:
            context.run("add_structural_check", self.net, **new)
            found = FreeCAD.getDocument(self._document).ActiveObject
        else:
            found = self._object(self._edited)
            if new:
                context.run("change_structural_check", found, **new)
        messages.show_in_status_bar(f"{found.Label}: {found.Verdict}")
        return True

    def reject(self) -> bool:
        """Leave everything as it was."""
        self._pick_no_more()
        return super().reject()

    def _pick_no_more(self) -> None:
        self.picking.stop()
        self.load_picking.stop()

    def _object(self, name: str) -> FreeCAD.DocumentObject | None:
        if self._document not in FreeCAD.listDocuments():
            return None
        return FreeCAD.getDocument(self._document).getObject(name)

    def _links(self, label: str, items: list[Any], nothing: str) -> QtGui.QComboBox:
        """A list of structures to choose one of."""
        box = QtGui.QComboBox()
        box.addItem(nothing)
        box.addItems([item.Label for item in items[1:]])
        leave_room(box)
        self._rows.addRow(label, box)
        return box

    def _add_rows(self) -> None:
        for name, field in self.fields.items():
            words = translate("Ortho", field.option.label)
            if field.option.kind == "flag":
                field.widget.setText(words)
                self._rows.addRow(field.widget)
            else:
                self._rows.addRow(words, field.widget)
            if name == "supports":
                self._rows.addRow("", self.picking.button)
            if name == "snow_side":
                self._add_texts()

    def _add_texts(self) -> None:
        for label, field, tip in (
            (
                translate("Ortho", "Wind"),
                self.texts["wind"],
                translate(
                    "Ortho",
                    "The wind has this pressure in kN/m2 and blows this way: 0.6@x; 0.6@-y.",
                ),
            ),
            (
                translate("Ortho", "Point loads"),
                self.texts["load"],
                translate(
                    "Ortho", "These vertices carry these forces in kN: 12:0,0,-5; 13:0,0,-5."
                ),
            ),
        ):
            field.widget.setToolTip(tip)
            self._rows.addRow(label, field.widget)
        self._rows.addRow("", self.load_picking.button)

    def _with_beams(self, *_: Any) -> None:
        """Beams say what the members are."""
        chosen = self._beams[self.beams.currentIndex()]
        for name in ("section", "material"):
            self.fields[name].widget.setEnabled(chosen is None)
        # Lamellas say how they stand too.
        for name in ("position", "layers"):
            stand = chosen is not None and chosen.System == LAMELLAS
            self.fields[name].widget.setEnabled(not stand)

    def _chosen(self) -> dict[str, Any]:
        chosen: dict[str, Any] = {name: field.value for name, field in self.fields.items()}
        for name, field in self.texts.items():
            words = (word.strip() for word in field.text.split(_BETWEEN))
            chosen[name] = tuple(word for word in words if word)
        chosen["beams"] = self._beams[self.beams.currentIndex()]
        chosen["cladding"] = self._cladding[self.cladding.currentIndex()]
        return chosen

    def _take_over(self, edited: FreeCAD.DocumentObject) -> None:
        """Show what a check has, and take it for what is there already."""
        design = structural_check.design_of(edited)
        for name, field in self.fields.items():
            field.value = design[name]
        for name, field in self.texts.items():
            field.widget.setText(f"{_BETWEEN} ".join(design[name]))
        for box, items, item in (
            (self.beams, self._beams, edited.Members),
            (self.cladding, self._cladding, edited.Cladding),
        ):
            box.setCurrentIndex(items.index(item) if item in items else 0)
        self._with_beams()
        self._before = self._chosen()
