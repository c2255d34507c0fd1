"""Every task panel of the workbench, and what of its texts is cut off."""

import FreeCAD
import FreeCADGui
import Mesh
import ortho_suite_tools as tools
from ortho_suite_tools import wait
from PySide import QtGui

from freecad_ortho import api

# Command -> names of the objects that its panel is opened on, with a face where one is meant.
PANELS = {
    "MultiNet": (),
    "Primitive": (),
    "EllipticNet": (),
    "FaceNet": ("Cylinder", "Face1"),
    "AlignedNet": ("Cylinder", "Face1"),
    "QuadsFromMesh": ("Scan",),
    "FormNet": ("Net",),
    "Derived": ("Net",),
    "Refine": ("Net",),
    "Transform": ("Net",),
    "Offset": ("Net",),
    "Weld": ("Net", "Net001"),
    "Optimise": ("Net",),
    "EditNet": ("Net",),
    "Display": ("Net",),
    "Check": ("Net",),
    "StructuralCheck": ("Net",),
    "Beams": ("Net",),
    "EdgeBeam": ("Net",),
    "Arches": ("Net",),
    "Lamellas": ("Net",),
    "Patches": ("Net",),
    "Panels": ("Net",),
    "BentPanels": ("Net",),
    "Louvres": ("Net",),
    "Feet": ("Net",),
    "Nodes": ("Net",),
    "FlatPatterns": ("Beams",),
    "ExportFabrication": ("Beams",),
}
# PySide forgets a widget that it was asked for when it forgets the widget around it.
_alive = []
# Widgets with texts of ours.
KINDS = (QtGui.QComboBox, QtGui.QLabel, QtGui.QCheckBox, QtGui.QPushButton, QtGui.QTableWidget)
# On each side of a text in a table.
_MARGIN = 3


def document_for_panels():
    """A document in which each panel can be opened."""
    document = FreeCAD.newDocument("Panels")
    document.addObject("Part::Cylinder", "Cylinder")
    document.addObject("Mesh::Feature", "Scan").Mesh = Mesh.createSphere(3000.0, 20)
    net = api.import_net(tools.wavy_mesh("panels", 4, 4), document)
    api.change_net(net, "transform", move=("20 m", 0, 0))
    api.add_beams(net)
    return document


def open_panel(document, command):
    """Open the panel of a command; give the widget that is its form."""
    FreeCADGui.Selection.clearSelection()
    names = PANELS[command]
    if names[1:] and names[1].startswith("Face"):
        FreeCADGui.Selection.addSelection(document.getObject(names[0]), names[1])
    else:
        for name in names:
            FreeCADGui.Selection.addSelection(document.getObject(name))
    FreeCADGui.runCommand(f"Ortho_{command}")
    wait(seconds=0.1)
    return form()


def untold(panel):
    """Labels of what numbers, lengths and angles are typed into without a sentence beside it."""
    found = []
    for box in panel.findChildren(QtGui.QAbstractSpinBox):
        words = box.toolTip()
        told = words.rpartition(" (")[0] if words.endswith(")") else words
        if not told.endswith(".") or len(told.split()) < 4 or not told[0].isupper():
            found.append(f"{box.metaObject().className()} '{words}'")
    return found


def form():
    """The task panel that is open, with its title."""
    return scroll_area().widget()


def scroll_area():
    """What FreeCAD shows task panels in; up to 1.0 their buttons are inside, later beside it."""
    if not wait(visible_buttons, 5):
        raise AssertionError("no task panel is open")
    around = visible_buttons().parentWidget()
    while around is not None:
        _alive.append(around)
        for each in (around, *around.findChildren(QtGui.QScrollArea)):
            if isinstance(each, QtGui.QScrollArea) and each.isVisible():
                return each
        around = around.parentWidget()
    raise AssertionError("no task panel is open")


def visible_buttons():
    """The row of buttons of the task panel that is open, None where PySide finds none."""
    boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
    return next((box for box in boxes if box.isVisible()), None)


def width():
    """The pixels across that FreeCAD shows of a task panel; there is no scroll bar for the rest."""
    return scroll_area().viewport().width()


def cut_off(panel):
    """Texts in a task panel that are wider than the room for them, in any state of its choices."""
    found = []
    # A scroll bar that has just come needs a moment for what is beside it.
    if not wait(lambda: panel.width() <= width(), 1):
        found.append(f"the panel ({panel.width()} > {width()}): {', '.join(broad(panel))}")
    for each in texts_of(panel):
        if each.isVisible():
            found += [
                f"{text} ({wide} > {room})" for text, wide, room in sizes(each) if wide > room
            ]
    return found


def broad(panel):
    """What needs most room, as a help to find the culprit."""
    kinds = (*KINDS, QtGui.QToolButton, QtGui.QGroupBox)
    hints = [(each.minimumSizeHint().width(), each) for each in texts_of(panel, kinds)]
    most = sorted(hints, key=lambda pair: -pair[0])[:5]
    return [f"{wide} {type(each).__name__} {getattr(each, 'text', str)()}" for wide, each in most]


def texts_of(panel, kinds=KINDS):
    """Children of some kinds; PySide trips over FreeCAD's own when it is asked for all."""
    return [each for kind in kinds for each in panel.findChildren(kind)]


def sizes(widget):
    """Texts that a widget may show in one line, the pixels each needs and those that there are."""
    measure = widget.fontMetrics()
    if isinstance(widget, QtGui.QComboBox):
        words = [widget.itemText(k) for k in range(widget.count())]
        room = room_in(widget, QtGui.QStyleOptionComboBox())
        return [(word, measure.boundingRect(word).width(), room) for word in words]
    if isinstance(widget, QtGui.QLabel):
        needed = 0 if widget.wordWrap() else widget.sizeHint().width()
        return [(widget.text(), needed, widget.width())]
    if isinstance(widget, QtGui.QTableWidget):
        cells = [(i, j) for i in range(widget.rowCount()) for j in range(widget.columnCount())]
        room = [widget.columnWidth(j) - 2 * _MARGIN for j in range(widget.columnCount())]
        texts = [(widget.item(i, j).text(), room[j]) for i, j in cells]
        return [(text, measure.boundingRect(text).width(), wide) for text, wide in texts]
    text = widget.text().replace("&", "")
    room = room_in(widget, QtGui.QStyleOptionButton())
    return [(text, measure.boundingRect(text).width(), room)]


def room_in(widget, option):
    """Pixels for the text of a button, a check box or a list of words, as the style has it."""
    widget.initStyleOption(option)
    style = QtGui.QStyle
    if isinstance(widget, QtGui.QComboBox):
        kind, part = style.CC_ComboBox, style.SC_ComboBoxEditField
        return widget.style().subControlRect(kind, option, part, widget).width()
    check = isinstance(widget, QtGui.QCheckBox)
    part = style.SE_CheckBoxContents if check else style.SE_PushButtonContents
    return widget.style().subElementRect(part, option, widget).width()
