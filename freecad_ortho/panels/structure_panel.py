"""Task panel that asks for the sizes of a structure."""

from __future__ import annotations

from typing import Any

import FreeCAD
from PySide import QtGui

from freecad_ortho import preferences
from freecad_ortho.fabrication import BUILD_UPS, MATERIALS, material
from freecad_ortho.objects import structure as structure_object
from freecad_ortho.objects.system_properties import options_of, values
from freecad_ortho.panels.fields import ChoiceField, TextField, elided, form_rows, leave_room
from freecad_ortho.panels.option_fields import OptionField, add_option
from freecad_ortho.panels.work_panel import WorkPanel
from freecad_ortho.resources import icon
from freecad_ortho.window import context, messages
from solver.errors import InputError
from solver.option import Option

translate = FreeCAD.Qt.translate

# Sizes that the preference page sets for new structures.
_PREFERRED = {
    ("beams", "height"): "BeamHeight",
    ("beams", "thickness"): "BeamThickness",
    ("panels", "thickness"): "PanelThickness",
    ("panels", "gap"): "PanelGap",
}

# Settings of every system that a structure has without being told.
_COMMON: dict[str, Any] = {"beams": None, "family": "both", "lines": [], "material": "steel"}


class StructurePanel(WorkPanel):
    """One field an option of the system; OK makes the structure.

    Args:
        net: what it stands on.
        system: name of the system.
        title: of the panel.
        edited: a structure to change instead of making one.

    Attributes:
        fields: by the option's name.
    """

    def __init__(
        self,
        net: FreeCAD.DocumentObject,
        system: str,
        title: str,
        edited: FreeCAD.DocumentObject | None = None,
    ) -> None:
        self._document, self._net, self._system = net.Document.Name, net.Name, system
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(QtGui.QIcon(icon(system)))
        self._rows = form_rows(self.form)
        self._rows.addRow(translate("Ortho", "Net"), elided(net.Label))
        self.fields = {
            option.name: OptionField(option, _first(system, option))
            for option in options_of(system)
        }
        for field in self.fields.values():
            add_option(self._rows, field)
        self._add_common_fields(net)
        # Without one: what a structure has of which nothing is said.
        self._before = dict(_COMMON) | {item.name: item.default for item in options_of(system)}
        if edited is not None:
            self._take_over(edited)

    @property
    def net(self) -> FreeCAD.DocumentObject | None:
        """The net, None when it or its document has gone meanwhile."""
        if self._document not in FreeCAD.listDocuments():
            return None
        return FreeCAD.getDocument(self._document).getObject(self._net)

    def possible(self) -> bool:
        """Tell whether the net is still there."""
        return self.net is not None

    def work(self) -> bool:
        """Make the structure."""
        context.run("add_structure", self.net, self._system, **self.settings())
        made = FreeCAD.getDocument(self._document).ActiveObject
        messages.show_in_status_bar(structure_object.summary(made))
        return True

    def settings(self) -> dict[str, Any]:
        """What was chosen, as ``freecad_ortho.api.add_structure`` takes it; only what is new.

        Raises:
            InputError: a field does not hold a number.
        """
        chosen = self._chosen()
        return {word: chosen[word] for word in chosen if chosen[word] != self._before[word]}

    def _chosen(self) -> dict[str, Any]:
        """All that the fields say."""
        chosen = {name: field.value for name, field in self.fields.items()}
        if self.on_beams is not None:
            chosen["beams"] = [None, *self._beams][self.on_beams.currentIndex()]
        chosen["family"] = self.family.word
        chosen["lines"] = _numbers(self.lines.text)
        chosen["material"] = self.material.word
        return chosen

    def _take_over(self, edited: FreeCAD.DocumentObject) -> None:
        """Show what a structure has, and take it for what is there already."""
        for name, value in values(edited, self._system).items():
            self.fields[name].value = value
        if self.on_beams is not None and edited.OnBeams in self._beams:
            self.on_beams.setCurrentIndex(self._beams.index(edited.OnBeams) + 1)
        elif self.on_beams is not None:
            self.on_beams.setCurrentIndex(0)
        self.family.choose(edited.Family.lower())
        self.lines.widget.setText(", ".join(map(str, edited.Lines)))
        self.material.choose(material(edited.Material).name)
        self._before = self._chosen()

    def _add_common_fields(self, net: FreeCAD.DocumentObject) -> None:
        self.on_beams = None
        if self._system in structure_object.ON_BEAMS:
            self._beams = _beams_on(net)
            self.on_beams = QtGui.QComboBox()
            self.on_beams.addItem(translate("Ortho", "nothing (on the net itself)"))
            self.on_beams.addItems([beams.Label for beams in self._beams])
            leave_room(self.on_beams)
            self.on_beams.setCurrentIndex(min(1, len(self._beams)))
            self.on_beams.setToolTip(translate("Ortho", "The parts lie on these beams."))
            self._rows.addRow(translate("Ortho", "Lie on"), self.on_beams)
        families = {
            "both": translate("Ortho", "both families"),
            "u": translate("Ortho", "u lines"),
            "v": translate("Ortho", "v lines"),
        }
        self.family = ChoiceField(families, "both")
        self.family.widget.setToolTip(
            translate("Ortho", "Parts are made along lines of these families.")
        )
        self.lines = TextField()
        self.lines.widget.setPlaceholderText(translate("Ortho", "all"))
        self.lines.widget.setToolTip(
            translate("Ortho", "Parts are made along these lines only, numbered such as 0, 3.")
        )
        words = {name: translate("Ortho", name) for name in MATERIALS}
        words |= {name: name for name in BUILD_UPS}
        self.material = ChoiceField(words, "steel", editable=True)
        self.material.widget.setToolTip(translate("Ortho", "All parts are made of this."))
        self._rows.addRow(translate("Ortho", "Along"), self.family.widget)
        self._rows.addRow(translate("Ortho", "Lines"), self.lines.widget)
        self._rows.addRow(translate("Ortho", "Material"), self.material.widget)


def _first(system: str, option: Option) -> Any:
    """What a field begins with: the default, or what the preferences say."""
    preferred = _PREFERRED.get((system, option.name))
    return preferences.length(preferred) if preferred else option.default


def _numbers(text: str) -> list[int]:
    words = text.replace(",", " ").split()
    if not all(word.isdecimal() for word in words):
        raise InputError(f"lines: expected numbers such as 0, 3, got '{text}'")
    return [int(word) for word in words]


def _beams_on(net: FreeCAD.DocumentObject) -> list[FreeCAD.DocumentObject]:
    return [
        item
        for item in net.InList
        if structure_object.is_structure(item) and item.System == structure_object.BEAMS
    ]
