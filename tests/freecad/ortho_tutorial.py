"""The steps of docs/tutorial.md in FreeCAD's window, each done as it is written there.

The story suite looks at what comes of them, ``scripts/docs_screens.py`` makes pictures of them.
"""

from unittest import mock

import FreeCAD
import FreeCADGui
import ImportGui
import numpy as np
import ortho_suite_tools as tools
from ortho_dialog_tools import Answers
from ortho_mouse_tools import Hand
from ortho_suite_tools import click, press, vertices, wait
from pivy import coin
from PySide import QtCore, QtGui

from freecad_ortho import answers, convert
from freecad_ortho.window import dialogs

SURFACE = tools.ROOT / "examples" / "data" / "demo_roof.step"
ROOF = tools.ROOT / "examples" / "data" / "demo_roof.obj"


class Tutorial:
    """One step a method; ``look(name)`` is called where the page has a picture."""

    def __init__(self, look=lambda name: None):
        self.look = look

    @property
    def document(self):
        return FreeCAD.ActiveDocument

    @property
    def net(self):
        return self.document.Net

    def open_surface(self, path=SURFACE):
        """What File > Open does, without FreeCAD's own questions on STEP, which newer ones ask."""
        FreeCADGui.activateWorkbench("OrthoWorkbench")
        ImportGui.open(str(path))
        wait(lambda: self.document is not None and self.document.Objects, 30)
        wait()
        self.look("surface")

    def align(self, edge):
        """Select the surface, Net along curvature, the edge length; OK when the net is there."""
        self.select(self.document.Objects[0])
        FreeCADGui.runCommand("Ortho_AlignedNet")
        wait()
        tools.field("Edge").setValue(edge)
        # The net for the length that stood there goes, the one for the new length comes.
        wait(lambda: not shown(" vertices, "), 5)
        if not wait(lambda: shown(" vertices, "), 120):
            raise AssertionError("no net comes")
        wait()
        self.look("aligned")
        press("Ok")
        wait()

    def open_mesh(self, path=ROOF):
        """File > Open, the file, and the module that FreeCAD asks for."""
        FreeCADGui.activateWorkbench("OrthoWorkbench")
        with Answers(str(path)):
            FreeCADGui.runCommand("Std_Open")
        wait(lambda: self.document is not None, 10)
        wait()
        self.look("open")

    def check(self):
        FreeCADGui.runCommand("Ortho_Check")
        wait()
        self.look("check")
        press("Close")

    def optimise(self, stop=True):
        """Start, Stop after some steps, Start again to the end, OK."""
        FreeCADGui.runCommand("Ortho_Optimise")
        wait()
        click("Start")
        if stop:
            # With one step at a time there are enough of them to be stopped between two.
            with mock.patch("freecad_ortho.panels.run._BUNDLE", 0.0):
                QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 5)
                click("Stop")
                yield
                click("Start")
        if not wait(lambda: not tools.button("Stop").isEnabled(), 60):
            raise AssertionError("the run does not end")
        wait()
        self.look("optimise")
        press("Ok")
        yield

    def drag(self):
        """Double click the net, hold its corners by Ctrl-clicks, press Z, pull its middle up."""
        net = self.net
        hand = Hand(self.document)
        net.ViewObject.Proxy.doubleClicked(net.ViewObject)
        wait()
        mesh = convert.quad_mesh(net)
        pixels = hand.pixels(mesh.vertices)
        for corner in corners(mesh):
            hand.click(pixels[corner], ctrl=True)
        middle = int(np.argmin(np.linalg.norm(mesh.vertices - mesh.vertices.mean(axis=0), axis=1)))
        hand.key(coin.SoKeyboardEvent.Z)
        start = pixels[middle]
        end = start + [0, 40]
        hand.drag(start, end)
        hand.release(end)
        editing = net.ViewObject.Proxy._edit_panel.editing
        if not wait(lambda: not editing.busy, 60):
            raise AssertionError("the dragged net does not come to rest")
        wait()
        self.look("drag")
        press("Close")
        return middle

    def colour(self, colour_map="Gauss curvature"):
        FreeCADGui.runCommand("Ortho_Display")
        wait()
        tools.choose(colour_map)
        wait()
        self.look("colours")
        press("Ok")

    def structure(self, command, name, numbers=()):
        """A command of the toolbar Fabricate: other numbers by what stands before them, OK."""
        FreeCADGui.runCommand(f"Ortho_{command}")
        wait()
        for label, value in numbers:
            tools.field(label).setValue(value)
        self.look(f"{name}-panel")
        press("Ok")
        wait()
        self.look(name)

    def change_structure(self, structure, name, numbers):
        """A double click on it in the tree, other numbers, Apply, OK."""
        structure.ViewObject.Proxy.doubleClicked(structure.ViewObject)
        wait()
        for label, value in numbers:
            tools.field(label).setValue(value)
        press("Apply")
        self.look(name)
        press("Ok")
        wait()

    def flat_patterns(self, name, on_sheets):
        FreeCADGui.runCommand("Ortho_FlatPatterns")
        wait()
        if not on_sheets:
            click("Nest on sheets")
        self.look(f"{name}-panel")
        press("Ok")
        wait()
        self.look(name)

    def drawing_page(self):
        FreeCADGui.runCommand("Ortho_DrawingPage")
        wait()

    def export(self, folder):
        """OK asks for a folder, in the dialog that a user sees; it is one that exists."""
        folder.mkdir(parents=True, exist_ok=True)
        FreeCADGui.runCommand("Ortho_ExportFabrication")
        wait()
        self.look("export")
        with Answers(str(folder)):
            press("Ok")

    def check_structure(self, snow):
        """Select the net, Structural check, its beams, panels and loads; OK."""
        self.select(self.net)
        FreeCADGui.runCommand("Ortho_StructuralCheck")
        wait()
        for label, item in (("Members", self.document.Beams), ("Weight of", self.document.Panels)):
            tools.field(label).setCurrentText(item.Label)
        tools.field("Snow").setValue(snow)
        tools.field("Wind").setText("0.6@x")
        self.look("stand-panel")
        press("Ok")
        wait()
        self.only(self.document.StructuralCheck)
        self.look("stand")

    def draw_forces(self):
        """In its menu Next diagram of forces up to My, and Next combination twice; then neither."""
        proxy = self.document.StructuralCheck.ViewObject.Proxy
        for _ in range(5):
            proxy.next_diagram()
        for _ in range(2):
            proxy.next_combination()
        self.look("stand-diagram")
        view = self.document.StructuralCheck.ViewObject
        view.Combination, view.Diagram = "Governing", "None"

    def balance_deformed(self):
        """A double click on the check, the tick at Second order, OK; then its buckling shape."""
        check = self.document.StructuralCheck
        check.ViewObject.Proxy.doubleClicked(check.ViewObject)
        wait()
        click("Second order")
        press("Ok")
        wait()
        check.ViewObject.Proxy.next_mode()
        self.look("stand-buckling")

    def size(self, sections="tubes"):
        """Members of its own, then the lightest of a list, as its menu in the tree offers."""
        check = self.document.StructuralCheck
        check.ViewObject.Proxy.doubleClicked(check.ViewObject)
        wait()
        tools.field("Members").setCurrentIndex(0)
        tools.field("Material").setText("S355")
        press("Ok")
        wait()
        with mock.patch.object(dialogs, "ask_sections", lambda lists: (sections, "all")):
            answers.ask("size check", check)
        wait()
        check.ViewObject.ColourBy, check.ViewObject.DrawnShape = "Displacement", "Deflected"
        self.look("stand-sized")

    def open_gridshell(self):
        FreeCADGui.activateWorkbench("OrthoWorkbench")
        FreeCADGui.runCommand("Ortho_Example_Gridshell")
        wait()
        self.look("gridshell")

    def only(self, *items):
        """Show these objects alone, as the space bar does, and fit them in."""
        for item in self.document.Objects:
            if hasattr(item.ViewObject, "Visibility"):
                item.ViewObject.Visibility = item in items
        wait()

    def select(self, *items):
        FreeCADGui.Selection.clearSelection()
        for item in items:
            FreeCADGui.Selection.addSelection(item)


def shown(text):
    """Whether a label with this text is seen."""
    labels = FreeCADGui.getMainWindow().findChildren(QtGui.QLabel)
    return any(text in label.text() and label.isVisible() for label in labels)


def corners(mesh):
    """Vertices of one face only."""
    counts = np.bincount(mesh.faces.ravel(), minlength=len(mesh.vertices))
    return np.flatnonzero(counts == 1).tolist()


def state(document):
    """Everything that the document holds: per object its properties, and its shape's measures.

    Returns:
        settings: by object and property, compared exactly.
        shapes: by object, numbers that are compared as far as FreeCAD writes digits.
    """
    settings, shapes = {}, {}
    for item in document.Objects:
        for name in item.PropertiesList:
            value = plain(getattr(item, name))
            if value is not None:
                settings[item.Name, name] = value
        shape = getattr(item, "Shape", None)
        if shape is not None:
            box = shape.BoundBox
            shapes[item.Name] = [
                len(shape.Faces),
                shape.Volume,
                shape.Area,
                shape.Length,
                *(box.XMin, box.XMax, box.YMin, box.YMax, box.ZMin, box.ZMax),
            ]
        if item.Name == "Net":
            settings["positions"] = vertices(item).tobytes()
    return settings, shapes


def plain(value):
    """A property's value as numbers and texts; None for what is neither."""
    if isinstance(value, FreeCAD.Units.Quantity):
        return value.Value
    if isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, (list, tuple)):
        values = [plain(each) for each in value]
        return None if None in values else values
    return getattr(value, "Name", None) if hasattr(value, "TypeId") else None
