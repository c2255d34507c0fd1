"""Task panel that shows how far a net is from every kind of net."""

from __future__ import annotations

from typing import Any, NamedTuple

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from freecad_ortho import convert
from freecad_ortho.objects import places
from freecad_ortho.objects.net import COLOUR_MAPS
from freecad_ortho.panels.buttons import close_only
from freecad_ortho.panels.fields import length_words
from freecad_ortho.panels.net_words import net_words, reason_words, short_word
from freecad_ortho.resources import icon
from freecad_ortho.view.place_marks import PlaceMarks
from freecad_ortho.view.screen import views
from freecad_ortho.window import context
from solver.analysis.check import check
from solver.nets import all_measures

translate = FreeCAD.Qt.translate


class CheckPanel:
    """Measures, advice, and the recommendation.

    A click on a measure marks the place where it is worst, a double click shows it in colours.
    """

    def __init__(self, net: FreeCAD.DocumentObject) -> None:
        self._document, self._name = net.Document.Name, net.Name
        self._mesh = convert.quad_mesh(net)
        self.result = check(self._mesh)
        self.marks: PlaceMarks | None = None
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Ortho", "Check"))
        self.form.setWindowIcon(QtGui.QIcon(icon("check")))
        column = QtGui.QVBoxLayout(self.form)
        column.setContentsMargins(0, 6, 0, 6)
        self.summary = _wrapped(_summary(net.Label, self.result))
        self.recommendation = _wrapped(_recommendation(self.result["advice"]))
        self.measures = _table(
            [translate("Ortho", "Measure"), translate("Ortho", "Worst"), translate("Ortho", "At")],
            _measures(self.result),
        )
        self.measures.setToolTip(
            translate(
                "Ortho",
                "A click marks the worst place, a double click shows the measure in colours.",
            )
        )
        self.measures.cellClicked.connect(self._mark)
        self.measures.cellDoubleClicked.connect(self._show)
        self.nets = _table(
            [
                translate("Ortho", "Net"),
                translate("Ortho", "Off by"),
                "✓",
            ],
            _advice(self.result),
        )
        for row, advice in enumerate(self.result["advice"]["nets"]):
            reason = reason_words(advice["cause"])
            for column_ in range(3 if reason else 0):
                self.nets.item(row, column_).setToolTip(reason)
        self.multi_net = _wrapped(_multi_net(self.result["multi_net"]))
        rows = (self.summary, self.recommendation, self.measures, self.nets, self.multi_net)
        for widget in rows:
            column.addWidget(widget)
        # Others may close the panel too, without asking.
        self.form.destroyed.connect(lambda *_: self._unmark())

    def getStandardButtons(self) -> int:
        """Nothing is changed here, so there is nothing to cancel."""
        return close_only()

    def reject(self) -> bool:
        """Close."""
        self._unmark()
        FreeCADGui.Control.closeDialog()
        return True

    def _mark(self, row: int, _: int) -> None:
        """Mark the vertices of the face, edge or star where a measure is worst."""
        entry = list(self.result["measures"].values())[row]
        seen = views(self._document) if self._document in FreeCAD.listDocuments() else []
        if entry["worst"] is None or not seen:
            return
        if self.marks is None:
            net = FreeCAD.getDocument(self._document).getObject(self._name)
            if net is None:
                return
            self.marks = PlaceMarks(seen[0], places.container(net))
        net, worst = self._mesh.connectivity, entry["worst"]
        if entry["where"] == "face":
            worst = net.half_edges[net.half_faces == worst, 0]
        elif entry["where"] == "edge":
            worst = net.edges[worst]
        self.marks.show(self._mesh.vertices[np.atleast_1d(worst)])

    def _unmark(self) -> None:
        if self.marks is not None:
            self.marks.remove()
            self.marks = None

    def _show(self, row: int, _: int) -> None:
        name = all_measures()[list(self.result["measures"])[row]].title
        if name in COLOUR_MAPS and self._document in FreeCAD.listDocuments():
            net = FreeCAD.getDocument(self._document).getObject(self._name)
            if net is not None:
                context.run("show_net", net, colour_map=name)


def _summary(label: str, result: dict[str, Any]) -> str:
    words = translate("Ortho", "{}: {} vertices, {} quads, {} irregular, edge ratio {:.2f}")
    counts = (result["vertices"], result["faces"], result["irregular_vertices"])
    sizes = ", ".join(result["corners_of_faces"])
    if sizes != "4":
        words = translate("Ortho", "{}: {} vertices, {} faces of {} corners, edge ratio {:.2f}")
        counts = (*counts[:2], sizes)
    flat = translate("Ortho", "faces flat to {}").format(length_words(result["planarity_gap"]))
    return f"{words.format(label, *counts, result['edge_ratio'])}, {flat}"


def _multi_net(found: dict[str, Any] | None) -> str:
    if found is None:
        return translate("Ortho", "Multi-net: no, the mesh is not of grid type")
    if found["is_multi_net"]:
        words = translate("Ortho", "Multi-net: yes, to {:.1e} over all rectangles of lines")
    else:
        words = translate("Ortho", "Multi-net: no, off by {:.1e} over all rectangles of lines")
    return words.format(found["worst"])


class TableCell(NamedTuple):
    """What a cell of a table shows, and what it says when the mouse rests there."""

    text: str
    tip: str = ""


def _measures(result: dict[str, Any]) -> list[list[TableCell]]:
    places = {
        "face": translate("Ortho", "face"),
        "edge": translate("Ortho", "edge"),
        "vertex": translate("Ortho", "vertex"),
    }
    rows = []
    for name, entry in result["measures"].items():
        where, number = entry["where"], entry["worst"]
        # As on drawings and engravings: V17 is vertex 17.
        letter = where[0].upper()
        place = (
            TableCell("")
            if number is None
            else TableCell(f"{letter}{number}", f"{places[where]} {number}")
        )
        title = translate("Ortho", all_measures()[name].title)
        rows.append([TableCell(title), TableCell(f"{entry['max']:.1e}"), place])
    return rows


def _advice(result: dict[str, Any]) -> list[list[TableCell]]:
    yes, no = TableCell("✓", translate("Ortho", "yes")), TableCell("–", translate("Ortho", "no"))
    tip = translate("Ortho", "Beside what it is off right angles, which all these nets ask for.")
    names = net_words()
    return [
        [
            TableCell(_title(advice), names[advice["net"]]),
            TableCell(f"{advice['beyond']:.1e}", tip),
            yes if advice["possible"] else no,
        ]
        for advice in result["advice"]["nets"]
    ]


def _title(advice: dict[str, Any]) -> str:
    return _of_variant(short_word(advice["net"]), advice)


def _full_title(advice: dict[str, Any]) -> str:
    return _of_variant(net_words()[advice["net"]].split(":")[0].strip(), advice)


def _of_variant(name: str, advice: dict[str, Any]) -> str:
    return translate("Ortho", "{}, diag.").format(name) if advice["diagonal"] else name


def _recommendation(advice: dict[str, Any]) -> str:
    best = advice["nets"][0]
    if advice["already"]:
        return translate("Ortho", "The net is this already: {}").format(_full_title(best))
    words = translate("Ortho", "Optimise for: {} (off by {:.1e} on average)")
    reason = reason_words(best["cause"])
    return "; ".join(
        [words.format(_full_title(best), best["distance"]), *([reason] if reason else [])]
    )


def _wrapped(text: str) -> QtGui.QLabel:
    label = QtGui.QLabel(text)
    label.setWordWrap(True)
    return label


def _table(titles: list[str], rows: list[list[TableCell]]) -> QtGui.QTableWidget:
    table = QtGui.QTableWidget(len(rows), len(titles))
    table.setHorizontalHeaderLabels(titles)
    table.verticalHeader().hide()
    table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
    for i, row in enumerate(rows):
        for j, cell in enumerate(row):
            item = QtGui.QTableWidgetItem(cell.text)
            item.setToolTip(cell.tip or cell.text)
            if j == 1:
                item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
            table.setItem(i, j, item)
    line = table.fontMetrics().height() + 6
    table.verticalHeader().setMinimumSectionSize(line)
    table.verticalHeader().setDefaultSectionSize(line)
    # The first column gives way: its names can be read when they are cut, numbers cannot.
    header = table.horizontalHeader()
    for j in range(len(titles)):
        mode = QtGui.QHeaderView.ResizeToContents if j else QtGui.QHeaderView.Stretch
        header.setSectionResizeMode(j, mode)
    # All rows at once: scrolling inside a task panel that scrolls itself is a nuisance.
    table.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
    table.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
    table.setMinimumHeight(line * len(rows) + header.height() + 4)
    return table
