"""Task panel for any source of nets: its options as fields, the net seen before it is made."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from freecad_ortho.objects import places, source_net
from freecad_ortho.objects.making import Inputs
from freecad_ortho.panels.fields import form_rows, in_users_words, leave_room, shortened
from freecad_ortho.panels.option_fields import OptionField
from freecad_ortho.resources import icon
from freecad_ortho.sources import GROUPS, Made, Source, source
from freecad_ortho.view.picture import three_d_view
from freecad_ortho.view.preview import Preview
from freecad_ortho.window import context, messages
from solver.errors import OrthoError

translate = FreeCAD.Qt.translate

# How often the fields are looked at, in ms: no signal of a field is the same in all FreeCADs.
_LOOK = 120
_NOTHING = Inputs()


class SourcePanel:
    """Options of one of several sources; OK makes the net, an error keeps the panel open.

    Args:
        title: of the panel.
        picture: name of its icon.
        group: name of a group of sources.
        document: where the net goes.
        inputs: what the net is made of.
        edited: a net to change instead of making one.
    """

    def __init__(
        self,
        title: str,
        picture: str,
        group: str,
        document: FreeCAD.Document,
        inputs: Inputs = _NOTHING,
        edited: FreeCAD.DocumentObject | None = None,
    ) -> None:
        self._document = document.Name
        self.inputs = inputs
        self._edited = edited.Name if edited else None
        self._shown_before = _visible([*inputs.owners, *([edited] if edited else [])])
        self.geometry = inputs.geometry(edited)
        self.stands = self._stands(inputs, edited)
        self.made: Made | None = None
        self._last: Any = None
        self.view = three_d_view(document)
        self.preview = Preview(self.view, self.stands)
        self.fields: dict[str, OptionField] = {}
        self._build_form(title, picture, group, edited)
        self._choose(edited.MadeBy if edited else GROUPS[group][0])
        self._cover()
        # A child of the form: it ends with the form, however that is closed.
        self._timer = QtCore.QTimer(self.form)
        self._timer.timeout.connect(self.look)
        self._timer.start(_LOOK)
        FreeCAD.addDocumentObserver(self)
        self._watching = True
        self.form.destroyed.connect(self._clear)
        self.look()
        if self.made is not None and edited is None:
            self._fit()

    @staticmethod
    def _stands(inputs: Inputs, edited: Any) -> FreeCAD.Placement:
        """Where the coordinates of what is shown stand; of faces they are the document's."""
        beside = None if inputs.faces else edited or next(iter(inputs.nets), None)
        return FreeCAD.Placement() if beside is None else places.container(beside)

    @property
    def source(self) -> Source:
        """The source that is chosen."""
        return self._source

    def values(self) -> dict[str, Any]:
        """All options as they stand in the fields."""
        return {name: field.value for name, field in self.fields.items()}

    def look(self) -> None:
        """Show the net again where a field has changed."""
        values = self.values()
        state = (self.source.name, repr(values))
        if state == self._last:
            return
        self._last = state
        self._remake()

    def _remake(self) -> None:
        """Make the net as the fields say now."""
        try:
            self._show(self.source.make(self.values(), **self.geometry))
        except OrthoError as error:
            self.made = None
            self._say(str(error), wrong=True)

    def _show(self, made: Made) -> None:
        self.made = made
        self.preview.show(made.mesh)
        count = translate("Ortho", "{} vertices, {} quads").format(
            len(made.mesh.vertices), len(made.mesh.faces)
        )
        self._say("\n".join([count, *map(in_users_words, made.remarks)]))

    def accept(self) -> bool:
        """Make or change the net, as one undo step and one line of a macro."""
        if self._document not in FreeCAD.listDocuments():
            self._close()
            return True
        try:
            self._commit()
        except OrthoError as error:
            messages.show_error(str(error))
            return False
        self._close(restore=self._edited is not None)
        return True

    def reject(self) -> bool:
        """Leave everything as it was."""
        self._close(restore=True)
        return True

    def slotDeletedDocument(self, document: FreeCAD.Document) -> None:
        """Leave quietly when the document is closed."""
        if document.Name == self._document:
            self._shown_before = []
            self._stop()
            QtCore.QTimer.singleShot(0, FreeCADGui.Control.closeDialog)

    def slotDeletedObject(self, feature: FreeCAD.DocumentObject) -> None:
        """Leave quietly when what the net is made of is deleted."""
        mine = {item.Name for item in self.inputs.owners}
        if feature.Document.Name == self._document and feature.Name in {*mine, self._edited}:
            self._shown_before = [x for x in self._shown_before if x.Name != feature.Name]
            self._stop()
            QtCore.QTimer.singleShot(0, FreeCADGui.Control.closeDialog)

    def _commit(self) -> None:
        changed = self._changed()
        document = FreeCAD.getDocument(self._document)
        # What the function hides from here on, Undo shows again.
        for feature in self._shown_before:
            feature.Visibility = True
        if self._edited:
            context.run("change_source", document.getObject(self._edited), **changed)
        elif self.source.name in GROUPS["primitive"]:
            context.run("add_primitive", self.source.name, document=document.Name, **changed)
        else:
            given = [(word, getattr(self.inputs, word)) for word in ("nets", "faces", "strokes")]
            inputs = {word: list(items) for word, items in given if items}
            inputs |= {} if inputs else {"document": document.Name}
            context.run("add_source", self.source.name, **inputs, **changed)

    def _changed(self) -> dict[str, Any]:
        """Options that are not as they were."""
        before = {**self.source.defaults, **self._starting}
        values = {name: _plain(value) for name, value in self.values().items()}
        return {k: value for k, value in values.items() if value != _plain(before[k])}

    def _close(self, restore: bool = False) -> None:
        self._stop()
        if restore:
            for feature in self._shown_before:
                feature.Visibility = True
        FreeCADGui.Control.closeDialog()

    def _stop(self) -> None:
        """Look no more, and clear the view."""
        if self._watching:
            self._timer.stop()
        self._clear()

    def _clear(self, *_: Any) -> None:
        """Take everything out of the view that is there for this panel only."""
        self.preview.remove()
        if self._watching:
            self._watching = False
            FreeCAD.removeDocumentObserver(self)

    def _cover(self) -> None:
        """Hide what the net is drawn in place of."""
        for feature in self._shown_before:
            feature.Visibility = False

    def _fit(self) -> None:
        self.view.fitAll()

    def _say(self, text: str, wrong: bool = False) -> None:
        self.message.setText(text)
        self.message.setStyleSheet("color: #b71926" if wrong else "")

    def _build_form(
        self, title: str, picture: str, group: str, edited: FreeCAD.DocumentObject | None
    ) -> None:
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(shortened(title))
        self.form.setWindowIcon(QtGui.QIcon(icon(picture)))
        column = QtGui.QVBoxLayout(self.form)
        column.setContentsMargins(0, 6, 0, 6)
        self.choice = QtGui.QComboBox()
        self.choice.addItems([translate("Ortho", name) for name in GROUPS[group]])
        leave_room(self.choice)
        self.choice.setVisible(len(GROUPS[group]) > 1 and edited is None)
        self.choice.currentIndexChanged.connect(lambda k: self._choose(GROUPS[group][k]))
        self.explained = QtGui.QLabel()
        self.explained.setWordWrap(True)
        self._rows = QtGui.QVBoxLayout()
        self.message = QtGui.QLabel()
        self.message.setWordWrap(True)
        column.addWidget(self.choice)
        column.addWidget(self.explained)
        # Above the fields, of which there may be more than the window shows.
        column.addWidget(self.message)
        column.addLayout(self._rows)
        self._table: QtGui.QWidget | None = None
        self._starting = source_net.values_of(edited) if edited else {}

    def _choose(self, name: str) -> None:
        """Lay out the fields of a source."""
        self._source = source(name)
        self.explained.setText(translate("Ortho", self.source.meaning))
        if self._table is not None:
            self._table.hide()
            self._table.deleteLater()
        self._table = QtGui.QWidget()
        rows = form_rows(self._table)
        rows.setContentsMargins(0, 0, 0, 0)
        values = {**self.source.defaults, **self._starting}
        self.fields = {}
        for option in self.source.options:
            field = OptionField(option, values[option.name])
            self.fields[option.name] = field
            if field.widget is not None:
                rows.addRow(translate("Ortho", option.label), field.widget)
        self._rows.addWidget(self._table)


def _visible(features: Sequence[FreeCAD.DocumentObject]) -> list[FreeCAD.DocumentObject]:
    return [feature for feature in features if feature.Visibility]


def _plain(value: Any) -> Any:
    """A value as it stands in a macro's line."""
    if isinstance(value, np.ndarray):
        value = value.tolist()
    return tuple(_plain(item) for item in value) if isinstance(value, (tuple, list)) else value
