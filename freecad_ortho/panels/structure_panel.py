"""Task panels that ask for the sizes of beams and panels."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from freecad_ortho import preferences
from freecad_ortho.commands import context, messages
from freecad_ortho.objects import structure as structure_object
from freecad_ortho.panels.fields import NARROW, ChoiceField, LengthField, offset_words
from freecad_ortho.resources import icon
from solver.errors import OrthoError

translate = FreeCAD.Qt.translate


class _StructurePanel:
    """What both panels share: a form, OK makes the structure, an error keeps the panel open."""

    def __init__(self, net: FreeCAD.DocumentObject, title: str, icon_name: str) -> None:
        self._document, self._net = net.Document.Name, net.Name
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(QtGui.QIcon(icon(icon_name)))
        self.fields = QtGui.QFormLayout(self.form)
        self.fields.addRow(translate("Ortho", "Net"), QtGui.QLabel(net.Label))

    @property
    def net(self) -> FreeCAD.DocumentObject | None:
        """The net, None when it or its document has gone meanwhile."""
        if self._document not in FreeCAD.listDocuments():
            return None
        return FreeCAD.getDocument(self._document).getObject(self._net)

    def accept(self) -> bool:
        """Make the structure."""
        if self.net is None:
            FreeCADGui.Control.closeDialog()
            return True
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            self.make()
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

    def make(self) -> None:
        """Run and record the document function."""
        raise NotImplementedError


class BeamsPanel(_StructurePanel):
    """Sizes of the beams on the edges of a net."""

    def __init__(self, net: FreeCAD.DocumentObject) -> None:
        super().__init__(net, translate("Ortho", "Beams"), "beams")
        self.height = LengthField(preferences.length("BeamHeight"))
        self.thickness = LengthField(preferences.length("BeamThickness"))
        self.offset = ChoiceField(offset_words(), "centre")
        self.fields.addRow(translate("Ortho", "Height"), self.height.widget)
        self.fields.addRow(translate("Ortho", "Thickness"), self.thickness.widget)
        self.fields.addRow(translate("Ortho", "Position"), self.offset.widget)

    def make(self) -> None:
        """Add the beams."""
        context.run(
            "add_beams",
            self.net,
            height=self.height.millimetres,
            thickness=self.thickness.millimetres,
            offset=self.offset.word,
        )


class PanelsPanel(_StructurePanel):
    """Sizes of the panels in the faces of a net."""

    def __init__(self, net: FreeCAD.DocumentObject) -> None:
        super().__init__(net, translate("Ortho", "Panels"), "panels")
        self.thickness = LengthField(preferences.length("PanelThickness"))
        self.gap = LengthField(preferences.length("PanelGap"))
        self.offset = ChoiceField(offset_words(), "above")
        self._beams = _beams_on(net)
        self.on_beams = QtGui.QComboBox()
        self.on_beams.addItem(translate("Ortho", "nothing (on the net itself)"))
        self.on_beams.addItems([beams.Label for beams in self._beams])
        self.on_beams.setMinimumWidth(NARROW)
        self.on_beams.setCurrentIndex(min(1, len(self._beams)))
        self.fields.addRow(translate("Ortho", "Thickness"), self.thickness.widget)
        self.fields.addRow(translate("Ortho", "Gap"), self.gap.widget)
        self.fields.addRow(translate("Ortho", "Position"), self.offset.widget)
        self.fields.addRow(translate("Ortho", "Lie on"), self.on_beams)

    def make(self) -> None:
        """Add the panels."""
        settings: dict[str, Any] = {
            "thickness": self.thickness.millimetres,
            "gap": self.gap.millimetres,
            "offset": self.offset.word,
        }
        if self.on_beams.currentIndex() > 0:
            settings["beams"] = self._beams[self.on_beams.currentIndex() - 1]
        context.run("add_panels", self.net, **settings)


def _beams_on(net: FreeCAD.DocumentObject) -> list[FreeCAD.DocumentObject]:
    return [
        item
        for item in net.InList
        if structure_object.is_structure(item) and item.System == structure_object.BEAMS
    ]
