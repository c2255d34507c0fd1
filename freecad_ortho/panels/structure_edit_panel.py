"""Task panel that changes the settings of a structure that is there."""

from __future__ import annotations

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from freecad_ortho.documents import structures
from freecad_ortho.objects import structure as structure_object
from freecad_ortho.panels.buttons import number
from freecad_ortho.panels.fields import shortened
from freecad_ortho.panels.structure_panel import StructurePanel
from freecad_ortho.window import context, messages

# Buttons without pictures, and with little room beside their words.
_NARROW = (
    "QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }"
    "QPushButton { min-width: 0px; padding: 4px 7px; }"
)


def _narrow_buttons() -> None:
    """Make three buttons no wider than a panel is with two."""
    for box in FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox):
        if box.isVisible():
            box.setStyleSheet(_NARROW)


class StructureEditPanel(StructurePanel):
    """Apply shows what the fields say, OK keeps it as one undo step, Cancel takes it back."""

    def __init__(self, edited: FreeCAD.DocumentObject) -> None:
        self._edited = edited.Name
        self._tried: set[str] = set()
        system = structure_object.TITLES[edited.System]
        super().__init__(edited.Net, system, shortened(edited.Label), edited)
        # Others may close the panel too, without asking.
        self.form.destroyed.connect(lambda *_: self._take_back())
        # FreeCAD's own modifyStandardButtons leaves Python with boxes that Qt has deleted.
        QtCore.QTimer.singleShot(0, _narrow_buttons)

    @property
    def edited(self) -> FreeCAD.DocumentObject | None:
        """The structure, None when it or its document has gone meanwhile."""
        if self._document not in FreeCAD.listDocuments():
            return None
        return FreeCAD.getDocument(self._document).getObject(self._edited)

    def getStandardButtons(self) -> int:
        """Apply beside the usual two."""
        box = QtGui.QDialogButtonBox
        return number(box.Ok) | number(box.Apply) | number(box.Cancel)

    def clicked(self, button: int) -> None:
        """Apply; FreeCAD calls this for every button."""
        if number(button) == number(QtGui.QDialogButtonBox.Apply) and self.possible():
            with messages.errors_shown(), messages.busy():
                self.apply()

    def apply(self) -> None:
        """Build what the fields say, not for good yet: in an undo step that stays open.

        Raises:
            OrthoError: sizes that do not fit; the structure is as it was.
        """
        wanted = self._changes()
        if not wanted:
            return
        structures.try_structure(self.edited, **wanted)
        self._tried |= set(wanted)
        messages.show_in_status_bar(structure_object.summary(self.edited))

    def possible(self) -> bool:
        """Tell whether the structure is still there."""
        return self.edited is not None and super().possible()

    def work(self) -> bool:
        """Keep it, as one line of a macro; what was applied last is not built again."""
        wanted = self._changes()
        if wanted:
            context.run("change_structure", self.edited, **wanted)
            messages.show_in_status_bar(structure_object.summary(self.edited))
        if self._tried:
            self._tried.clear()
            self.edited.Document.commitTransaction()
        return True

    def reject(self) -> bool:
        """Leave everything as it was."""
        self._take_back()
        FreeCADGui.Control.closeDialog()
        return True

    def _changes(self) -> dict[str, object]:
        """What is new, and what was tried and is as before again."""
        chosen = self._chosen()
        return {
            word: value
            for word, value in chosen.items()
            if word in self._tried or value != self._before[word]
        }

    def _take_back(self) -> None:
        """Undo what was applied."""
        if not self._tried or self.edited is None:
            return
        self._tried.clear()
        structure = self.edited
        structure.Document.abortTransaction()
        for item in (structure, *structure.InListRecursive):
            if not getattr(item, "Outdated", False):
                item.purgeTouched()
