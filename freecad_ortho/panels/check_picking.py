"""Supports and point loads picked in the 3D view, written into the fields that name them."""

from __future__ import annotations

import FreeCAD
import numpy as np
from PySide import QtGui

from freecad_ortho import convert
from freecad_ortho.panels.fields import TextField
from freecad_ortho.panels.option_fields import OptionField
from freecad_ortho.panels.vertex_picker import VertexPicker
from freecad_ortho.view.handles import HELD
from freecad_ortho.view.mouse import Mouse
from freecad_ortho.window import messages
from solver.errors import OrthoError
from solver.mesh.quadmesh import FloatArray

translate = FreeCAD.Qt.translate

# Force, kN, on the first vertex that is picked; on others that of the last one.
_FIRST = "0,0,-1"


class PickingButton:
    """A button; while it is pressed a click on a vertex of the net takes it in, or out again.

    Args:
        net: the net.

    Attributes:
        button: to be put into the form.
        beside: which stops when this one starts: a click says one thing at a time.
    """

    def __init__(self, net: FreeCAD.DocumentObject) -> None:
        self._net = net
        self.beside: PickingButton | None = None
        self._mouse: Mouse | None = None
        self._was_seen = True
        self.button = QtGui.QPushButton(translate("Ortho", "Pick vertices"))
        self.button.setCheckable(True)
        self.button.toggled.connect(self._toggle)
        # Others may close the panel too, without asking.
        self.button.destroyed.connect(lambda *_: self._end())

    def stop(self) -> None:
        """Pick no more."""
        self.button.setChecked(False)

    def pick(self, vertex: int) -> None:
        """Take a vertex in, or out again where it is in."""
        self._change(vertex)
        self._mark()

    def _change(self, vertex: int) -> None:
        raise NotImplementedError

    def _named(self) -> list[int]:
        """Vertices that the field names by their numbers."""
        raise NotImplementedError

    def _toggle(self, on: bool) -> None:
        if not on:
            self._end()
            return
        if self.beside is not None:
            self.beside.stop()
        try:
            mesh = convert.quad_mesh(self._net)
        except OrthoError as error:
            messages.show_status(str(error))
            return
        self._points: FloatArray = mesh.vertices
        self._was_seen, self._net.Visibility = self._net.Visibility, True
        picker = VertexPicker(mesh, self.pick, lambda vertex, place: None)
        self._mouse = Mouse(self._net.ViewObject, picker)
        picker.show = self._mark
        self._mark()

    def _end(self) -> None:
        if self._mouse is not None:
            self._mouse.remove()
            self._mouse = None
            self._net.Visibility = self._was_seen

    def _mark(self) -> None:
        if self._mouse is None:
            return
        seen = [number for number in self._named() if number < len(self._points)]
        self._mouse.handles.show(np.array(self._points[seen]).reshape(-1, 3), [HELD] * len(seen))


class SupportPicking(PickingButton):
    """Vertices that are picked are one entry of the text, ``3,17``, and keep the kind behind it.

    Args:
        net: the net.
        field: that names the supports.
    """

    def __init__(self, net: FreeCAD.DocumentObject, field: OptionField) -> None:
        super().__init__(net)
        self._field = field

    def _change(self, vertex: int) -> None:
        entries = [entry.strip() for entry in str(self._field.value).split("+") if entry.strip()]
        numbered = next((entry for entry in entries if _numbers(entry) is not None), None)
        _, colon, kind = (numbered or "").partition(":")
        chosen = set(_numbers(numbered) or ()) if numbered else set()
        chosen ^= {vertex}
        words = ",".join(map(str, sorted(chosen)))
        new = [f"{words}{colon}{kind}"] if chosen else []
        at = entries.index(numbered) if numbered else len(entries)
        self._field.value = "+".join([*entries[:at], *new, *entries[at + bool(numbered) :]])

    def _named(self) -> list[int]:
        entries = str(self._field.value).split("+")
        return [number for entry in entries for number in _numbers(entry.strip()) or ()]


class LoadPicking(PickingButton):
    """A vertex that is picked has the force of the last entry of the text, ``12:0,0,-5``.

    Args:
        net: the net.
        field: that names the loads, joined by ``between``.
        between: texts of a list.
    """

    def __init__(self, net: FreeCAD.DocumentObject, field: TextField, between: str) -> None:
        super().__init__(net)
        self._field, self._between = field, between

    def _change(self, vertex: int) -> None:
        entries = self._entries()
        kept = [entry for entry in entries if _numbers(entry) != [vertex]]
        if len(kept) == len(entries):
            force = entries[-1].partition(":")[2].strip() if entries else ""
            kept.append(f"{vertex}:{force or _FIRST}")
        self._field.widget.setText(f"{self._between} ".join(kept))

    def _named(self) -> list[int]:
        return [number for entry in self._entries() for number in _numbers(entry) or ()]

    def _entries(self) -> list[str]:
        words = (entry.strip() for entry in self._field.text.split(self._between))
        return [entry for entry in words if entry]


def _numbers(entry: str) -> list[int] | None:
    """Vertices that an entry names by their numbers; None where it names none so."""
    words = entry.partition(":")[0].replace(" ", "").split(",")
    return [int(word) for word in words] if all(word.isdecimal() for word in words) else None
