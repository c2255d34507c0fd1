"""Task panel beside the live editing of a net: numbers, choices, and how it goes."""

from __future__ import annotations

import time
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from freecad_ortho import convert
from freecad_ortho.objects.source_net import is_outdated
from freecad_ortho.panels.buttons import close_only
from freecad_ortho.panels.editing import Editing
from freecad_ortho.panels.fields import ChoiceField, LengthField, elided, form_rows
from freecad_ortho.panels.net_words import explain, net_words, outlook
from freecad_ortho.panels.watch import cover, uncover
from freecad_ortho.resources import icon
from freecad_ortho.view import dragging
from freecad_ortho.window import context, messages
from solver.errors import OrthoError
from solver.mesh.quadmesh import FloatArray

translate = FreeCAD.Qt.translate

# Weight of the guide that keeps the shape of faces while a sheet is bent.
_ISOMETRY = 10.0
# The rate of redraws is that of the last so many.
_FRAMES = 20


class EditPanel:
    """The form, and the end of editing in all the ways it can come about."""

    def __init__(self, net: FreeCAD.DocumentObject) -> None:
        self._document, self._name = net.Document.Name, net.Name
        self._gone = False
        self._filling = True
        self.editing = Editing(net, self._told, self._lost)
        self._visible = uncover(net)
        self._build_form(net)
        self._filling = False
        outdated = translate(
            "Ortho", "The source of this net has changed since; it stays as it is."
        )
        self._told(outdated if is_outdated(net) else None)
        # Others may close the panel too, without asking.
        self.form.destroyed.connect(lambda *_: self._vanished())

    @property
    def net(self) -> FreeCAD.DocumentObject:
        """The net; it is there as long as the panel is."""
        return FreeCAD.getDocument(self._document).getObject(self._name)

    def getStandardButtons(self) -> int:
        """Each drag is a step of its own, so there is nothing to confirm."""
        return close_only()

    def reject(self) -> bool:
        """Leave edit mode, which ends everything else."""
        FreeCADGui.getDocument(self._document).resetEdit()
        return True

    def end(self) -> None:
        """Put everything back as it was before editing; FreeCAD leaves edit mode."""
        if self._gone:
            return
        self.editing.end()
        cover(self._document, self._visible)
        self._gone = True
        FreeCADGui.Control.closeDialog()

    def _vanished(self) -> None:
        """Leave edit mode when the form has gone."""
        if not self._gone:
            self._gone = True
            self.editing.end()
            cover(self._document, self._visible)
            QtCore.QTimer.singleShot(0, self._leave_mode)

    def _leave_mode(self) -> None:
        if self._document in FreeCAD.listDocuments():
            FreeCADGui.getDocument(self._document).resetEdit()

    def _lost(self, reason: str) -> None:
        """Leave quietly when the net is deleted or its document closed."""
        if self._gone:
            return
        self._gone = True
        self.editing.end(gone=True)
        if reason:
            messages.show_status(reason)
        # FreeCAD is in the middle of deleting; the panel closes when it has done so.
        QtCore.QTimer.singleShot(0, FreeCADGui.Control.closeDialog)

    def _told(self, words: str | None) -> None:
        """Show how the editing stands."""
        if self._gone or self._filling:
            return
        editing = self.editing
        if words is not None:
            self.message.setText(words)
        count = translate("Ortho", "{} of {} chosen")
        self.handles.setText(count.format(len(editing.chosen), len(editing.handles)))
        for widget in (self.remove, self.move, *(field.widget for field in self.place)):
            widget.setEnabled(bool(editing.chosen) and not editing.busy)
        if editing.chosen and not any(field.widget.hasFocus() for field in self.place):
            vertex = editing.chosen[-1]
            self.vertex.setText(str(vertex))
            for field, value in zip(self.place, editing.handles[vertex], strict=True):
                field.millimetres = value
            self._shown = [field.millimetres for field in self.place]
        self.mode.widget.setCurrentIndex(dragging.MODES.index(editing.mode))
        self.rate.setText(self._rate())

    def _rate(self) -> str:
        frames = self.editing.live.frames[-_FRAMES:] if self.editing.live is not None else []
        if len(frames) < 2 or time.perf_counter() - frames[-1] > 1.0:
            return ""
        rate = (len(frames) - 1) / (frames[-1] - frames[0])
        return translate("Ortho", "{:.0f} a second").format(rate)

    def _retarget(self) -> None:
        """Keep another kind of net from now on."""
        if self._filling:
            return
        wanted: dict[str, Any] = {"net": self.net_type.word}
        if self.net.DiagonalNet and self.net_type.word != self.net.NetType:
            # It was ticked for the net before, and is not shown here.
            wanted["diagonal"] = False
        weight = _ISOMETRY if self.isometric.isChecked() else None
        if (self.net.IsometryWeight > 0) != self.isometric.isChecked():
            wanted["isometry"] = weight
        with messages.errors_shown():
            context.run("set_net", self.net, **wanted)
        self._explain(self.net)

    def _explain(self, net: FreeCAD.DocumentObject) -> None:
        words = outlook(net, net.NetType)
        self.outlook.setText(words)
        self.outlook.setVisible(bool(words))
        self.net_type.widget.setToolTip(explain(net.NetType))

    def _move(self) -> None:
        self.editing.move_to(self._place())

    def _place(self) -> FloatArray:
        """Where the chosen handle is to go; what was not typed anew keeps all its digits."""
        place = self.editing.handles[self.editing.chosen[-1]].copy()
        for axis, (field, shown) in enumerate(zip(self.place, self._shown, strict=True)):
            if field.millimetres != shown:
                place[axis] = field.millimetres
        return place

    def _build_form(self, net: FreeCAD.DocumentObject) -> None:
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Ortho", "Edit net"))
        self.form.setWindowIcon(QtGui.QIcon(icon("net")))
        column = QtGui.QVBoxLayout(self.form)
        column.setContentsMargins(0, 6, 0, 6)
        column.addWidget(self._net_box(net))
        column.addWidget(self._state_box())
        column.addWidget(self._handle_box())
        column.addWidget(_hints())

    def _net_box(self, net: FreeCAD.DocumentObject) -> QtGui.QGroupBox:
        words = net_words(bool(convert.sizes_of(net)))
        if net.NetType not in words:
            words = net_words()
        self.net_type = ChoiceField(words, net.NetType)
        self.net_type.widget.currentIndexChanged.connect(lambda _: self._retarget())
        self.isometric = QtGui.QCheckBox(translate("Ortho", "Isometric"))
        self.isometric.setToolTip(
            translate("Ortho", "For developable nets: the sheet bends and hardly stretches.")
        )
        self.isometric.setChecked(net.IsometryWeight > 0)
        self.isometric.toggled.connect(lambda _: self._retarget())
        self.outlook = QtGui.QLabel()
        self.outlook.setWordWrap(True)
        self._explain(net)
        box = QtGui.QGroupBox(translate("Ortho", "Net"))
        form = form_rows(box)
        form.addRow(elided(net.Label))
        form.addRow(translate("Ortho", "Stays"), self.net_type.widget)
        form.addRow(self.isometric)
        form.addRow(self.outlook)
        return box

    def _handle_box(self) -> QtGui.QGroupBox:
        self.handles, self.vertex = QtGui.QLabel(), QtGui.QLabel()
        self.remove = QtGui.QPushButton(translate("Ortho", "Remove"))
        self.remove.setToolTip(translate("Ortho", "The chosen vertices are no handles any more."))
        self.remove.clicked.connect(lambda: self.editing.remove(self.editing.chosen))
        self.mode = ChoiceField(
            {
                dragging.VIEW_PLANE: translate("Ortho", "parallel to the screen (V)"),
                "x": translate("Ortho", "along X (X)"),
                "y": translate("Ortho", "along Y (Y)"),
                "z": translate("Ortho", "along Z (Z)"),
                dragging.ALONG_NORMAL: translate("Ortho", "along the normal (N)"),
                dragging.ON_SURFACE: translate("Ortho", "on the surface (S)"),
            },
            self.editing.mode,
        )
        self.mode.widget.activated.connect(lambda _: self.editing.choose_mode(self.mode.word))
        self.place = [LengthField(0.0, signed=True) for _ in "xyz"]
        self.move = QtGui.QPushButton(translate("Ortho", "Move there"))
        self.move.clicked.connect(self._move)
        box = QtGui.QGroupBox(translate("Ortho", "Handles"))
        form = form_rows(box)
        row = QtGui.QHBoxLayout()
        row.addWidget(self.handles, 1)
        row.addWidget(self.remove)
        form.addRow(row)
        form.addRow(translate("Ortho", "Drag"), self.mode.widget)
        form.addRow(translate("Ortho", "Vertex"), self.vertex)
        self.mode.widget.setToolTip(translate("Ortho", "The mouse draws handles this way."))
        there = translate("Ortho", "The chosen vertex goes to this place.")
        for letter, field in zip("XYZ", self.place, strict=True):
            field.widget.setToolTip(there)
            form.addRow(letter, field.widget)
        form.addRow(self.move)
        return box

    def _state_box(self) -> QtGui.QGroupBox:
        self.rate, self.message = QtGui.QLabel(), QtGui.QLabel()
        self.message.setWordWrap(True)
        box = QtGui.QGroupBox(translate("Ortho", "State"))
        form = form_rows(box)
        form.addRow(translate("Ortho", "Redraws"), self.rate)
        form.addRow(self.message)
        return box


def begin(view_object: Any) -> EditPanel | None:
    """Open the panel for a net; None, with a word to the user, where that cannot be now."""
    net = view_object.Object
    if FreeCADGui.Control.activeDialog():
        messages.show_status(translate("Ortho", "Close the open task panel first."))
        return None
    try:
        panel = EditPanel(net)
    except OrthoError as error:
        messages.show_error(str(error))
        return None
    FreeCADGui.Control.showDialog(panel)
    return panel


def _hints() -> QtGui.QLabel:
    text = QtGui.QLabel(
        translate(
            "Ortho",
            "Drag a vertex. Click: choose; Ctrl: several; Shift and drag: all in a frame; Del: no "
            "handle any more; Esc: put back. Handles that are not dragged stay exactly where they "
            "are. Each drag is one step for Undo.",
        )
    )
    text.setWordWrap(True)
    text.setEnabled(False)
    return text
