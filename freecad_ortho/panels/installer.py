"""The window that installs missing Python packages with FreeCAD's own Python."""

from __future__ import annotations

import sys
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

import freecad_ortho
from freecad_ortho import packages

translate = FreeCAD.Qt.translate

# FreeCAD's Addon Manager keeps the user's answer to "which Python?" here.
_ADD_ONS = "User parameter:BaseApp/Preferences/Addons"
_PROBE = "import sys, pip; print('%d.%d' % sys.version_info[:2])"


class Installer(QtGui.QDialog):
    """Says what is missing, installs it in a process of its own, shows how far it is, can stop.

    Args:
        names: the packages.
        folder: where they go.
        python: the interpreter to use; found when it is not given.
    """

    def __init__(self, names: list[str], folder: Path, python: Path | None = None) -> None:
        super().__init__(FreeCADGui.getMainWindow())
        self.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        self.setWindowTitle(translate("Ortho", "Packages for the Ortho workbench"))
        self.names, self.folder, self.python = names, folder, python
        self.said: list[str] = []
        self.process = QtCore.QProcess(self)
        self.process.setProcessChannelMode(QtCore.QProcess.MergedChannels)
        self.process.readyReadStandardOutput.connect(self._read)
        self.process.finished.connect(self._finished)
        self._build()

    def install(self) -> None:
        """Start installing; the window says how it ends."""
        self.python = self.python or own_python()
        if self.python is None:
            self._say(
                translate(
                    "Ortho",
                    "FreeCAD's Python was not found, or it has no pip. Install pip for Python {} "
                    "with your system's package manager, then try again.",
                ).format(f"{sys.version_info.major}.{sys.version_info.minor}")
            )
            return
        self._show_running(True)
        names = ", ".join(self.names)
        self._say(translate("Ortho", "Installing {}. This takes some minutes.").format(names))
        arguments = packages.pip_arguments(self.names, self.folder)
        self.process.start(str(self.python), arguments)
        if not self.process.waitForStarted(10000):
            self._show_running(False)
            self._say(translate("Ortho", "{} cannot be started.").format(self.python))

    def reject(self) -> None:
        """Stop a running installation, which leaves nothing behind; otherwise close the window."""
        if not self.running:
            super().reject()
            return
        self.said.append("")
        self._stopped = True
        self.process.kill()

    @property
    def running(self) -> bool:
        """Tell whether packages are being installed."""
        return self.process.state() != QtCore.QProcess.NotRunning

    def _read(self) -> None:
        text = bytes(self.process.readAllStandardOutput()).decode("utf-8", "replace")
        for line in filter(None, map(str.strip, text.splitlines())):
            self.said.append(line)
            FreeCAD.Console.PrintLog(f"pip: {line}\n")
            self._step.setText(line[:80])

    def _finished(self, code: int, *_: object) -> None:
        self._show_running(False)
        self._step.setText("")
        if self._stopped:
            self._stopped = False
            self._say(translate("Ortho", "Stopped. Nothing was installed."))
        elif code:
            errors = [line for line in self.said if line.startswith("ERROR")] or self.said
            self._say(
                translate("Ortho", "The packages could not be installed:")
                + "\n"
                + "\n".join(errors[-2:])
            )
        else:
            self._take_into_use()

    def _take_into_use(self) -> None:
        freecad_ortho.use_own_packages(self.folder)
        self._install.setEnabled(False)
        self._close.setText(translate("Ortho", "Close"))
        self._say(
            translate("Ortho", "Installed. Start FreeCAD again to use everything.")
            if set(self.names) - set(packages.missing())
            else translate("Ortho", "Installed, but Python does not find it in {}.").format(
                self.folder
            )
        )

    def _say(self, text: str) -> None:
        self.message.setText(text)

    def _show_running(self, running: bool) -> None:
        self._bar.setVisible(running)
        self._install.setEnabled(not running)
        self._close.setText(
            translate("Ortho", "Stop") if running else translate("Ortho", "Not now")
        )

    def _build(self) -> None:
        self._stopped = False
        text = translate(
            "Ortho",
            "The Ortho workbench needs Python packages that FreeCAD does not find: {names}.\n\n"
            "Install downloads them with what they need, up to 2 GB on disk, into FreeCAD's own "
            "folder for add-ons:\n{folder}\nNothing else on this computer is changed.",
        ).format(names=", ".join(self.names), folder=self.folder)
        self.message = QtGui.QLabel(text)
        self.message.setWordWrap(True)
        self.message.setMinimumWidth(420)
        self.message.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        self._step = QtGui.QLabel("")
        self._bar = QtGui.QProgressBar()
        self._bar.setRange(0, 0)
        buttons = QtGui.QDialogButtonBox()
        self._install = buttons.addButton(
            translate("Ortho", "Install"), QtGui.QDialogButtonBox.AcceptRole
        )
        self._close = buttons.addButton("", QtGui.QDialogButtonBox.RejectRole)
        self._install.clicked.connect(self.install)
        self._close.clicked.connect(self.reject)
        rows = QtGui.QVBoxLayout(self)
        for widget in (self.message, self._bar, self._step, buttons):
            rows.addWidget(widget)
        self._show_running(False)


def own_python() -> Path | None:
    """Find the Python with pip that belongs to this FreeCAD."""
    chosen = FreeCAD.ParamGet(_ADD_ONS).GetString("PythonExecutableForPip", "")
    places = [Path(chosen)] if chosen else []
    version = f"{sys.version_info.major}.{sys.version_info.minor}"
    for place in places + packages.interpreters(FreeCAD.getHomePath()):
        probe = QtCore.QProcess()
        probe.start(str(place), ["-c", _PROBE])
        if probe.waitForFinished(10000) and not probe.exitCode():
            if bytes(probe.readAllStandardOutput()).decode().strip() == version:
                return place
    return None
