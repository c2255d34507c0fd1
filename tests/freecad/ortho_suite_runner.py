"""FreeCAD runs this file; it runs the suite that ORTHO_SUITE names and writes down the result."""

import faulthandler
import os
import sys
import unittest
from pathlib import Path

import FreeCAD

sys.path.append(os.environ["ORTHO_SUITE_FOLDER"])


def versions():
    from PySide import QtCore

    freecad = ".".join(part.strip() for part in FreeCAD.Version()[:3])
    return f"FreeCAD {freecad} (Python {sys.version.split()[0]}, Qt {QtCore.qVersion()})"


def run():
    with Path(os.environ["ORTHO_SUITE_RESULT"]).open("w", encoding="utf-8") as stream:
        stream.write(f"{versions()}\n")
        # What hangs is seen in the result: where each thread stands shortly before the end.
        faulthandler.dump_traceback_later(int(os.environ["ORTHO_SUITE_SECONDS"]), file=stream)
        suite = unittest.defaultTestLoader.loadTestsFromName(os.environ["ORTHO_SUITE"])
        outcome = unittest.TextTestRunner(stream, verbosity=2).run(suite)
        passed = outcome.wasSuccessful() and outcome.testsRun > 0
        stream.write("SUITE PASSED\n" if passed else "SUITE FAILED\n")
        faulthandler.cancel_dump_traceback_later()


def run_and_quit():
    from PySide import QtGui

    try:
        run()
    finally:
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        sys.stdout.flush()
        QtGui.QApplication.quit()


if FreeCAD.GuiUp:
    from PySide import QtCore

    QtCore.QTimer.singleShot(1000, run_and_quit)
else:
    run()
