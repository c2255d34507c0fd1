"""What holds a net while it is optimised: a list, and picking in the 3D view."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from freecad_ortho.objects import constraints
from freecad_ortho.panels.fields import NARROW, ChoiceField, form_rows
from freecad_ortho.panels.vertex_picker import VertexPicker
from freecad_ortho.view.handles import CHOSEN, HELD
from freecad_ortho.view.mouse import Mouse
from freecad_ortho.window import messages
from solver.errors import OrthoError
from solver.mesh.quadmesh import QuadMesh

translate = FreeCAD.Qt.translate

_FIX, _HANDLE, _GLIDE, _NEAR = "fix", "handle", "glide", "near"


class ConstraintBox:
    """A box of a form: rules, picked vertices, edges and faces, and a list of all.

    One picking at a time; it ends with its button, with another, or with the panel.

    Args:
        net: the Net.
        mesh: gives its mesh as it is stored.
        stored: its settings, as ``documents.net_settings.words`` gives them.

    Attributes:
        box: to be put into the form.
        fix: vertices that stay, a word and numbers.
        glide, close_to: entries as ``optimise_net`` takes them.
        handles: places in mm by vertex.
    """

    def __init__(
        self, net: FreeCAD.DocumentObject, mesh: Callable[[], QuadMesh], stored: dict[str, Any]
    ) -> None:
        self._net, self._mesh = net, mesh
        self.glide: list[Any] = list(stored["glide"])
        self.close_to: list[Any] = list(stored["close_to"])
        self.handles: dict[int, tuple[float, ...]] = dict(stored["handles"])
        self._picking: str | None = None
        self._mouse: Mouse | None = None
        self._watching = False
        self._build(stored)
        self._show()

    @property
    def words(self) -> dict[str, Any]:
        """What holds the net, as keywords of ``optimise_net``."""
        planes = zip("xyz", self.mirrors, strict=True)
        chosen = [letter for letter, mark in planes if mark.isChecked()]
        return {
            "fix": self.fix.word,
            "glide": list(self.glide),
            "close_to": list(self.close_to),
            "handles": dict(self.handles),
            "symmetry": "".join(chosen),
        }

    def stop_picking(self) -> None:
        """Pick no more, and let the buttons say so."""
        self.end()
        for button in self._pickers.values():
            button.setChecked(False)

    def end(self) -> None:
        """Pick no more; doing it again changes nothing, nor does it need the form."""
        self._picking = None
        if self._mouse is not None:
            self._mouse.remove()
            self._mouse = None
        if self._watching:
            self._watching = False
            FreeCADGui.Selection.removeObserver(self)

    def addSelection(self, document: str, name: str, part: str, _: Any) -> None:
        """Take what the user has picked; FreeCAD calls this."""
        feature = FreeCAD.getDocument(document).getObject(name)
        if feature is None or feature is self._net:
            return
        entry = (feature, part.split(".")[-1])
        entries = self.glide if self._picking == _GLIDE else self.close_to
        if entry in entries:
            return
        try:
            if self._picking == _GLIDE:
                constraints.glides([entry], self._mesh(), self._net)
            else:
                constraints.require_surface(entry)
        except OrthoError as error:
            messages.show_status(str(error))
            return
        entries.append(entry)
        self._show()

    def _picking_with(self, what: str, button: QtGui.QPushButton) -> Callable[[], None]:
        return lambda: self._pick(what, button.isChecked())

    def _pick(self, what: str, on: bool) -> None:
        if not on:
            if self._picking == what:
                self.end()
            return
        self.stop_picking()
        self._picking = what
        self._pickers[what].setChecked(True)
        if what in (_FIX, _HANDLE):
            picker = VertexPicker(self._mesh(), self._clicked, self._dragged)
            self._mouse = Mouse(self._net.ViewObject, picker)
            picker.show = self._mark
            self._mark()
        else:
            self._watching = True
            FreeCADGui.Selection.addObserver(self)

    def _clicked(self, vertex: int) -> None:
        """Take a vertex in, or out again."""
        if self._picking == _FIX:
            words = self._fix_words()
            number = str(vertex)
            words.remove(number) if number in words else words.append(number)
            self._set_fix(words)
        elif vertex in self.handles:
            del self.handles[vertex]
        else:
            self.handles[vertex] = tuple(self._mesh().vertices[vertex].tolist())
        self._show()

    def _dragged(self, vertex: int, place: np.ndarray) -> None:
        if self._picking == _HANDLE:
            self.handles[vertex] = tuple(place.tolist())
            self._show()

    def _fix_words(self) -> list[str]:
        words = [word for word in self.fix.word.replace(" ", "").split(",") if word]
        return [word for word in words if word != "none"]

    def _set_fix(self, words: list[str]) -> None:
        rules = [word for word in words if not word.isdigit()]
        numbers = sorted((word for word in words if word.isdigit()), key=int)
        text = ",".join(rules + numbers)
        self.fix.choose(text or "none")

    def _mark(self) -> None:
        if self._mouse is not None:
            self._mouse.handles.show(*self._markers())
            vertices = list(self.handles)
            ends = np.array(list(self.handles.values())).reshape(-1, 3)
            starts = self._mesh().vertices[vertices].reshape(-1, 3)
            self._mouse.handles.show_lines(starts, ends)

    def _markers(self) -> tuple[Any, list[int]]:
        points = self._mesh().vertices
        held = [int(word) for word in self._fix_words() if word.isdigit()]
        held = [vertex for vertex in held if vertex < len(points)]
        places = [*points[held], *(np.array(place) for place in self.handles.values())]
        kinds = [HELD] * len(held) + [CHOSEN] * len(self.handles)
        return np.array(places).reshape(-1, 3), kinds

    def _add_rule(self, rule: str) -> None:
        if rule not in self.glide:
            self.glide.append(rule)
        self._show()

    def _add_ground(self) -> None:
        self._add_rule(f"z={self._mesh().vertices[:, 2].min():.9g}")

    def _remove(self) -> None:
        for item in self.list.selectedItems():
            kind, key = item.data(QtCore.Qt.UserRole)
            if kind == _HANDLE:
                self.handles.pop(int(key), None)
            else:
                entries = self.glide if kind == _GLIDE else self.close_to
                entries[:] = [entry for entry in entries if constraints.describe(entry) != key]
        self._show()

    def _show(self) -> None:
        self.list.clear()
        rows = [(_GLIDE, constraints.describe(entry)) for entry in self.glide]
        rows += [(_NEAR, constraints.describe(entry)) for entry in self.close_to]
        rows += [(_HANDLE, str(vertex)) for vertex in self.handles]
        words = {
            _GLIDE: translate("Ortho", "glide on {}"),
            _NEAR: translate("Ortho", "stay near {}"),
            _HANDLE: translate("Ortho", "vertex {} drawn to its place"),
        }
        for kind, key in rows:
            item = QtGui.QListWidgetItem(words[kind].format(key))
            item.setData(QtCore.Qt.UserRole, [kind, key])
            self.list.addItem(item)
        self.list.setVisible(bool(rows))
        self.remove.setVisible(bool(rows))
        self._mark()

    def _build(self, stored: dict[str, Any]) -> None:
        words = {
            "none": translate("Ortho", "nothing"),
            "corners": translate("Ortho", "corners"),
            "boundary": translate("Ortho", "boundary"),
        }
        self.fix = ChoiceField(words, "none", editable=True)
        fixed = stored["fix"]
        self.fix.choose(fixed if isinstance(fixed, str) else ",".join(map(str, fixed)))
        self.fix.widget.setToolTip(
            translate("Ortho", "These vertices do not move; numbers such as 0,5,12 work too.")
        )
        self.list = QtGui.QListWidget()
        self.list.setSelectionMode(QtGui.QAbstractItemView.ExtendedSelection)
        self.list.setMaximumHeight(90)
        self.remove = QtGui.QPushButton(translate("Ortho", "Remove"))
        self.remove.clicked.connect(self._remove)
        self.mirrors = [QtGui.QCheckBox(letter) for letter in "xyz"]
        for letter, mark in zip("xyz", self.mirrors, strict=True):
            mark.setChecked(letter in stored["symmetry"])
        self.box = QtGui.QGroupBox(translate("Ortho", "Constraints"))
        form = form_rows(self.box)
        form.addRow(translate("Ortho", "Hold"), self.fix.widget)
        form.addRow(translate("Ortho", "Pick"), self._picker_buttons())
        form.addRow(self.list)
        form.addRow(self.remove)
        mirror_row = QtGui.QHBoxLayout()
        for mark in self.mirrors:
            mirror_row.addWidget(mark)
        form.addRow(translate("Ortho", "Mirror"), mirror_row)
        tip = translate("Ortho", "The net keeps being its own mirror image in the plane through 0.")
        for mark in self.mirrors:
            mark.setToolTip(tip)

    def _picker_buttons(self) -> QtGui.QGridLayout:
        texts = {
            _FIX: (
                translate("Ortho", "Fix"),
                translate("Ortho", "Click vertices that must not move; a second click frees them."),
            ),
            _HANDLE: (
                translate("Ortho", "Handle"),
                translate("Ortho", "Click vertices that are held softly, or drag them to a place."),
            ),
            _GLIDE: (
                translate("Ortho", "Glide"),
                translate(
                    "Ortho",
                    "Click edges, faces or planes that the boundary near them (on a curved face: "
                    "every vertex) glides on, exactly.",
                ),
            ),
            _NEAR: (
                translate("Ortho", "Near"),
                translate("Ortho", "Click faces that the net stays near as far as it can."),
            ),
        }
        self._pickers = {}
        grid = QtGui.QGridLayout()
        for number, (what, (text, tip)) in enumerate(texts.items()):
            button = QtGui.QPushButton(text)
            button.setToolTip(tip)
            button.setCheckable(True)
            button.setMinimumWidth(NARROW // 2)
            button.clicked.connect(self._picking_with(what, button))
            self._pickers[what] = button
            grid.addWidget(button, number // 2, number % 2)
        more = QtGui.QPushButton(translate("Ortho", "Glide on ..."))
        menu = QtGui.QMenu(more)
        menu.addAction(translate("Ortho", "its own boundary")).triggered.connect(
            lambda: self._add_rule("boundary")
        )
        menu.addAction(translate("Ortho", "the level of its lowest vertex")).triggered.connect(
            self._add_ground
        )
        more.setMenu(menu)
        grid.addWidget(more, 2, 0, 1, 2)
        return grid
