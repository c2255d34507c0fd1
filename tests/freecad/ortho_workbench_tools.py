"""What is done by commands and seen in pictures, for suites in FreeCAD's window."""

from unittest import mock

import FreeCAD
import FreeCADGui
import numpy as np
import ortho_suite_tools as tools
from ortho_suite_cases import WindowCase
from ortho_suite_tools import press, wait
from PySide import QtGui

from freecad_ortho import api
from freecad_ortho.panels import optimise_panel
from freecad_ortho.window import dialogs


class WorkbenchCase(WindowCase):
    def setUp(self):
        super().setUp()
        self.watch_panel(optimise_panel, "OptimisePanel")

    def imported(self, path):
        with mock.patch.object(dialogs, "ask_mesh_file", lambda: path):
            FreeCADGui.runCommand("Ortho_ImportNet")
        wait()
        return FreeCAD.ActiveDocument.Net

    def optimised(self, seconds=60):
        FreeCADGui.runCommand("Ortho_Optimise")
        self.panel.start_button.click()
        run = self.panel.run
        self.assertTrue(wait(lambda: run.optimisation.finished, seconds))
        press("Ok")

    def picture(self, name):
        """Save a picture of the active document; give its pixels as (height, width, 3) bytes."""
        path = str(tools.SCRATCH / f"{name}.png")
        api.save_picture(path, width=800, height=500)
        image = QtGui.QImage(path).convertToFormat(QtGui.QImage.Format_RGB888)
        rows = np.frombuffer(bytes(image.constBits()), np.uint8)
        return rows.reshape(image.height(), -1)[:, : 3 * image.width()].reshape(500, 800, 3)

    def assertNotBlank(self, pixels):
        background = (pixels == pixels[0, 0]).all(axis=2).mean()
        self.assertLess(background, 0.97)
        self.assertGreater(background, 0.2)
