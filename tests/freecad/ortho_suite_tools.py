"""What the suites that run inside FreeCAD share: meshes as files, waiting, clicking."""

import os
from pathlib import Path

import FreeCAD
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
SHARED_MESHES = ROOT.parent / "shared" / "meshes"
SCRATCH = Path(os.environ["ORTHO_SUITE_SCRATCH"])


def wavy_mesh(name="wavy", rows=6, columns=7, unit="mm", edge=1500.0):
    """Write a sheared, doubly curved grid, neither orthogonal nor planar; give its path."""
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    x, y = edge * (i + 0.2 * j), edge * j
    z = 0.1 * edge * rows * np.sin(0.37 * i + 0.3) * np.cos(0.27 * j - 0.2)
    return write_grid(name, np.stack([x, y, z], axis=2), unit)


def bent_sheet(name="sheet", rows=13, columns=11):
    """Write a sheet bent to an arc of 10 m radius, unequally divided; give its path."""
    angle = np.linspace(-0.7, 0.7, rows)
    i, j = np.meshgrid(angle, 1e3 * np.arange(columns), indexing="ij")
    return write_grid(name, np.stack([1e4 * np.sin(i), j, 1e4 * np.cos(i)], axis=2))


def write_grid(name, points, unit="mm"):
    """Write (rows, columns, 3) points as a quad mesh; give its path."""
    rows, columns = points.shape[:2]
    corner = np.arange(rows * columns).reshape(rows, columns)
    quads = [corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]]
    faces = np.stack(quads, axis=2).reshape(-1, 4) + 1
    lines = [f"# unit: {unit}"]
    lines += [f"v {a!r} {b!r} {c!r}" for a, b, c in points.reshape(-1, 3).tolist()]
    lines += ["f {} {} {} {}".format(*face) for face in faces.tolist()]
    return write(f"{name}.obj", "\n".join(lines))


def write(name, text):
    path = SCRATCH / name
    path.write_text(text, encoding="utf-8")
    return str(path)


def follow_at_once(case, seconds):
    """Let shapes follow at once that take no longer than this, until the end of a test case."""
    from freecad_ortho import preferences

    before = preferences.at_once()
    preferences.group().SetFloat("AtOnceSeconds", seconds)
    case.addCleanup(preferences.group().SetFloat, "AtOnceSeconds", before)


def close_all():
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)


def vertices(net):
    from freecad_ortho import convert

    return convert.array(net.Vertices)


def faults(net):
    """Worst planarity and orthogonality of a net."""
    from freecad_ortho import convert
    from solver.analysis import measures

    mesh = convert.quad_mesh(net)
    return measures.planarity(mesh).max(), measures.orthogonality(mesh).max()


def wait(condition=lambda: False, seconds=0.2):
    """Let FreeCAD handle events until the condition holds or the time is up."""
    import time

    from PySide import QtCore, QtGui

    end = time.monotonic() + seconds
    while time.monotonic() < end and not condition():
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
        time.sleep(0.002)
    return condition()


def press(name):
    """Press a standard button of the task panel, such as Ok or Cancel."""
    import FreeCADGui
    from PySide import QtGui

    kind = getattr(QtGui.QDialogButtonBox, name)

    def buttons():
        boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
        found = [box.button(kind) for box in boxes if box.isVisible()]
        return [button for button in found if button is not None]

    if not wait(buttons, 5):
        raise AssertionError(f"no task panel with a button {name}")
    buttons()[0].click()
    wait()


def button(text):
    """The button or check box of the window that is seen with this text."""
    import FreeCADGui
    from PySide import QtGui

    def seen():
        found = FreeCADGui.getMainWindow().findChildren(QtGui.QAbstractButton)
        return [each for each in found if each.isVisible() and each.text().replace("&", "") == text]

    if not wait(seen, 5):
        raise AssertionError(f"no button {text}")
    return seen()[0]


def click(text):
    """Click on the button or check box with this text."""
    found = button(text)
    if not found.isEnabled():
        raise AssertionError(f"{text} is grey")
    found.click()


def choose(text):
    """Choose a word of whichever list of the task panel has it."""
    import FreeCADGui
    from PySide import QtGui

    boxes = FreeCADGui.getMainWindow().findChildren(QtGui.QComboBox)
    (box,) = [each for each in boxes if each.isVisible() and each.findText(text) >= 0]
    box.setCurrentText(text)


def field(label):
    """The field of the task panel that stands behind a label."""
    import FreeCADGui
    from PySide import QtGui

    found = []

    def look():
        for form in FreeCADGui.getMainWindow().findChildren(QtGui.QFormLayout):
            for row in range(form.rowCount()):
                item = form.itemAt(row, QtGui.QFormLayout.LabelRole)
                if item and item.widget().isVisible() and item.widget().text() == label:
                    found.append(form.itemAt(row, QtGui.QFormLayout.FieldRole).widget())
        return found

    # FreeCAD shows a panel a while after it was asked for it.
    if not wait(look, 5):
        raise AssertionError(f"no field {label}")
    return found[0]
