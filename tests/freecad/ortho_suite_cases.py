"""What test cases inside FreeCAD begin and end with, in a document and in the window."""

import unittest
from unittest import mock

import FreeCAD
import numpy as np
import ortho_suite_tools as tools


def follow_at_once():
    """Let shapes follow their nets however long that takes: tests run on busy machines."""
    from freecad_ortho import preferences

    preferences.group().SetFloat("AtOnceSeconds", 600.0)


class DocumentCase(unittest.TestCase):
    """Works in a new document."""

    def setUp(self):
        follow_at_once()
        self.document = FreeCAD.newDocument("Test")
        # FreeCAD records no undo steps in console mode unless it is told to.
        self.document.UndoMode = 1

    def tearDown(self):
        tools.close_all()

    def imported(self, **mesh):
        """Make a net of the wavy mesh in the document."""
        from freecad_ortho import api

        return api.import_net(tools.wavy_mesh(**mesh), self.document)

    def shape(self, shape, name="Shape"):
        """Add a shape to the document as an object."""
        feature = self.document.addObject("Part::Feature", name)
        feature.Shape = shape
        self.document.recompute()
        return feature

    def reopened(self, name):
        """Save and close the document, and open it again."""
        path = str(tools.SCRATCH / name)
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        return self.document


class StructureCase(DocumentCase):
    """Works on an exact net in a new document."""

    def setUp(self):
        from freecad_ortho import api

        super().setUp()
        self.net = self.imported()
        api.optimise_net(self.net)


class WindowCase(unittest.TestCase):
    """Works in the workbench and keeps what it records and says.

    Attributes:
        lines: lines of macros that were run.
        errors: messages in boxes.
        said: messages in the status bar.
        panel: the last panel that a class watched by ``watch_panel`` made.
    """

    def setUp(self):
        import FreeCADGui

        from freecad_ortho.window import messages

        follow_at_once()
        FreeCADGui.activateWorkbench("OrthoWorkbench")
        self.lines, self.errors, self.said, self.panel = [], [], [], None
        run = FreeCADGui.doCommand

        def recorded(line):
            self.lines.append(line)
            run(line)

        self.replace(FreeCADGui, "doCommand", recorded)
        self.replace(messages, "show_error", self.errors.append)
        self.replace(messages, "show_status", lambda text, wrong=False: self.said.append(text))

    def tearDown(self):
        import FreeCADGui

        if FreeCADGui.Control.activeDialog():
            FreeCADGui.Control.closeDialog()
        FreeCADGui.Selection.clearSelection()
        tools.close_all()
        tools.wait()

    def replace(self, target, name, replacement):
        """Replace an attribute until the end of the test."""
        patch = mock.patch.object(target, name, replacement)
        patch.start()
        self.addCleanup(patch.stop)

    def watch_panel(self, module, name):
        """Keep the panels that a class makes as ``panel`` until the end of the test."""
        make = getattr(module, name)

        def made(*arguments):
            self.panel = make(*arguments)
            return self.panel

        self.replace(module, name, made)

    def replay(self):
        """Run the line again that was recorded last."""
        exec(self.lines[-1], {"FreeCAD": FreeCAD})

    def shown(self, net):
        """Positions that are on the screen."""
        points = net.ViewObject.Proxy._coordinates.point.getValues()
        return np.array([point.getValue() for point in points])


class PanelCase(WindowCase):
    """Works in a panel that shows a net before it is made."""

    def tearDown(self):
        if self.panel is not None:
            self.panel._stop()
        super().tearDown()

    def opened(self, command):
        """Run a command by its name; give the panel that it opens."""
        import FreeCADGui

        self.assertTrue(FreeCADGui.isCommandActive(f"Ortho_{command}"), command)
        FreeCADGui.runCommand(f"Ortho_{command}")
        tools.wait()
        return self.panel

    def previewed(self):
        """Points that the preview shows."""
        points = self.panel.preview._net._points.point.getValues()
        return np.array([point.getValue() for point in points])
