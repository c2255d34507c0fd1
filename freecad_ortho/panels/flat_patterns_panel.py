"""Task panel that asks how flat patterns are laid out."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from freecad_ortho.commands import context, messages
from freecad_ortho.panels.fields import ChoiceField, LengthField, NumberField
from freecad_ortho.resources import icon
from solver.errors import OrthoError

translate = FreeCAD.Qt.translate


class FlatPatternsPanel:
    """Sheet, spacing and kerf; OK lays the patterns out, an error keeps the panel open."""

    def __init__(self, structures: list[FreeCAD.DocumentObject]) -> None:
        self._document = structures[0].Document.Name
        self._names = [item.Name for item in structures]
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Ortho", "Flat patterns"))
        self.form.setWindowIcon(QtGui.QIcon(icon("flat_patterns")))
        labels = QtGui.QLabel(", ".join(item.Label for item in structures))
        labels.setWordWrap(True)
        self.on_sheets = QtGui.QCheckBox(translate("Ortho", "Nest on sheets"))
        self.on_sheets.setChecked(True)
        self.width, self.height = LengthField(3000.0), LengthField(1500.0)
        self.spacing, self.kerf = LengthField(10.0), LengthField(0.0)
        self.grain = ChoiceField(
            {
                "none": translate("Ortho", "parts may turn"),
                "along": translate("Ortho", "along the sheet"),
            },
            "none",
        )
        self.nesting = ChoiceField(
            {
                "boxes": translate("Ortho", "by boxes (fast)"),
                "outlines": translate("Ortho", "by outlines (dense)"),
            },
            "boxes",
        )
        self.seed = NumberField(translate("Ortho", "Seed"), 0, whole=True)
        rows = QtGui.QFormLayout(self.form)
        rows.addRow(translate("Ortho", "Structures"), labels)
        rows.addRow(self.on_sheets)
        of_sheets = (
            (translate("Ortho", "Sheet width"), self.width),
            (translate("Ortho", "Sheet height"), self.height),
            (translate("Ortho", "Spacing"), self.spacing),
            (translate("Ortho", "Grain"), self.grain),
            (translate("Ortho", "Packing"), self.nesting),
            (translate("Ortho", "Seed"), self.seed),
        )
        for label, field in of_sheets:
            rows.addRow(label, field.widget)
            self.on_sheets.toggled.connect(field.widget.setEnabled)
        rows.addRow(translate("Ortho", "Kerf"), self.kerf.widget)

    @property
    def structures(self) -> list[FreeCAD.DocumentObject]:
        """The structures, without those that have gone meanwhile."""
        if self._document not in FreeCAD.listDocuments():
            return []
        document = FreeCAD.getDocument(self._document)
        found = [document.getObject(name) for name in self._names]
        return [item for item in found if item is not None]

    def settings(self) -> dict[str, Any]:
        """What was chosen, as ``freecad_ortho.api.add_flat_patterns`` takes it.

        Raises:
            InputError: the seed is not a number.
        """
        settings: dict[str, Any] = {}
        if self.kerf.millimetres:
            settings["kerf"] = self.kerf.millimetres
        if not self.on_sheets.isChecked():
            return settings
        settings["sheet"] = (self.width.millimetres, self.height.millimetres)
        settings["spacing"] = self.spacing.millimetres
        settings["grain"] = self.grain.word
        settings["nesting"] = self.nesting.word
        settings["seed"] = self.seed.number or 0
        return settings

    def accept(self) -> bool:
        """Lay the patterns out."""
        if not self.structures:
            FreeCADGui.Control.closeDialog()
            return True
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            context.run("add_flat_patterns", self.structures, **self.settings())
        except OrthoError as error:
            QtGui.QApplication.restoreOverrideCursor()
            messages.show_error(str(error))
            return False
        QtGui.QApplication.restoreOverrideCursor()
        FreeCADGui.Control.closeDialog()
        return True

    def reject(self) -> bool:
        """Leave everything as it was."""
        FreeCADGui.Control.closeDialog()
        return True
