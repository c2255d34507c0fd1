"""Task panel that optimises a net while one watches."""

from __future__ import annotations

import math
from typing import Any

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from freecad_ortho import convert, documents, preferences
from freecad_ortho.commands import context, messages
from freecad_ortho.objects.structure import is_structure
from freecad_ortho.panels.fields import ChoiceField, NumberField
from freecad_ortho.panels.run import Run
from freecad_ortho.resources import icon
from solver.nets import RECIPES

translate = FreeCAD.Qt.translate


class OptimisePanel:
    """Settings, Start / Stop, and what the solver says; OK keeps the result, Cancel does not.

    The document is not touched before OK: while the solver runs only the picture moves.
    """

    def __init__(self, net: FreeCAD.DocumentObject) -> None:
        self._document, self._name = net.Document.Name, net.Name
        self._mesh = convert.quad_mesh(net)
        self._settings: dict[str, Any] = {}
        self.run: Run | None = None
        self._visible = _uncover(net)
        self._build_form(net.Label)
        FreeCAD.addDocumentObserver(self)

    @property
    def net(self) -> FreeCAD.DocumentObject | None:
        """The net, None when it or its document has gone meanwhile."""
        if self._document not in FreeCAD.listDocuments():
            return None
        return FreeCAD.getDocument(self._document).getObject(self._name)

    def start(self) -> None:
        """Start a run, or resume the stopped one when the settings are still the same."""
        with messages.errors_shown():
            settings = self.settings()
            if self.run is None or settings != self._settings:
                self._begin(settings)
            self.run.resume()
        self._show_state()

    def stop(self) -> None:
        """Make no further step; what has been reached stays on the screen."""
        if self.run is not None and self.run.running:
            self.run.stop()
            self._say(translate("Ortho", "Stopped. OK keeps this state, Start goes on."))
        self._show_state()

    def settings(self) -> dict[str, Any]:
        """The settings as freecad_ortho.api.optimise takes them; the automatic ones are left out.

        Raises:
            InputError: a field does not hold a number.
        """
        chosen = {
            "fairness": self.fairness.number,
            "closeness": self.closeness.number,
            "tolerance": self.tolerance.number,
        }
        settings = {name: value for name, value in chosen.items() if value is not None}
        return {
            "net": self.net_type.word,
            "fix": self.fix.word,
            **settings,
            **preferences.solver_settings(),
        }

    def accept(self) -> bool:
        """Keep what has been reached, as one undo step and one line of a macro."""
        self._stop_watching()
        if self.net is not None and self.run is not None and self.run.steps:
            with messages.errors_shown():
                self._commit()
        elif self.net is not None:
            self.net.ViewObject.Proxy.show_stored()
        self._close()
        return True

    def reject(self) -> bool:
        """Show the net as it was."""
        self._stop_watching()
        if self.net is not None:
            self.net.ViewObject.Proxy.show_stored()
        self._close()
        return True

    def slotDeletedDocument(self, document: FreeCAD.Document) -> None:
        """Leave quietly when the document is closed during a run."""
        if document.Name == self._document:
            self._leave()

    def slotDeletedObject(self, feature: FreeCAD.DocumentObject) -> None:
        """Leave quietly when the net is deleted during a run."""
        if feature.Name == self._name and feature.Document.Name == self._document:
            self._leave()

    def slotChangedObject(self, feature: FreeCAD.DocumentObject, name: str) -> None:
        """Drop the run when something else moves the net, undo for one."""
        if name not in ("Vertices", "Faces") or self.run is None:
            return
        if feature.Name == self._name and feature.Document.Name == self._document:
            self.run.stop()
            self.run = None
            self._say(translate("Ortho", "The net has changed meanwhile. Start begins anew."))
            self._show_state()

    def _begin(self, settings: dict[str, Any]) -> None:
        from freecad_ortho import api

        self._settings = settings
        self._mesh = convert.quad_mesh(self.net)
        self.run = Run(api.start_optimisation(self._mesh, **settings), self._stepped, self._ended)
        self._say(translate("Ortho", "Running ..."))

    def _stepped(self, record: Any) -> None:
        if self.net is None:
            self._leave()
            return
        self.net.ViewObject.Proxy.show_vertices(self.run.optimisation.vertices)
        self._step_label.setText(str(record.step))
        self._time_label.setText(f"{1000 * record.seconds:.1f} ms")
        worst = max(record.residuals.values(), default=0.0)
        self._residual_label.setText(
            "\n".join(f"{name}  {value:.1e}" for name, value in record.residuals.items())
        )
        self._bar.setValue(_progress(worst, self._settings.get("tolerance", 1e-10)))

    def _ended(self, error: str | None) -> None:
        if error is None:
            outcome = self.run.optimisation.outcome()
            # The best shape of all attempts, not always the last one.
            self.net.ViewObject.Proxy.show_vertices(outcome.mesh.vertices)
            self._say(outcome.report.message)
        else:
            self._say(error)
        self._show_state()

    def _commit(self) -> None:
        settings = dict(self._settings)
        if not self.run.optimisation.finished:
            settings["max_steps"] = self.run.steps
            self.run.optimisation.stop()
        outcome = self.run.optimisation.outcome()
        # The macro line computes this again when it is replayed; here it only takes the result.
        documents.keep_outcome(self.net, settings, self._mesh.vertices, outcome)
        context.run("optimise_net", self.net, **settings)
        messages.show_status(f"{self.net.Label}: {outcome.report.message}")

    def _leave(self) -> None:
        """Stop when there is nothing left to work on; close when FreeCAD has done its part."""
        self._stop_watching()
        QtCore.QTimer.singleShot(0, self._close)

    def _close(self) -> None:
        """Show what was visible before, as far as it is still there, and close the panel."""
        self._stop_watching()
        if self._document in FreeCAD.listDocuments():
            document = FreeCAD.getDocument(self._document)
            for name, visible in self._visible.items():
                feature = document.getObject(name)
                if feature is not None:
                    feature.ViewObject.Visibility = visible
        FreeCADGui.Control.closeDialog()

    def _stop_watching(self) -> None:
        if self.run is not None:
            self.run.stop()
        if self._watching:
            self._watching = False
            FreeCAD.removeDocumentObserver(self)

    def _say(self, text: str) -> None:
        self._message.setText(text)

    def _show_state(self) -> None:
        running = self.run is not None and self.run.running
        self.start_button.setEnabled(not running)
        self.stop_button.setEnabled(running)

    def _build_form(self, label: str) -> None:
        self._watching = True
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Ortho", "Optimise"))
        self.form.setWindowIcon(QtGui.QIcon(icon("optimise")))
        rows = QtGui.QVBoxLayout(self.form)
        rows.addLayout(self._settings_rows(label))
        rows.addLayout(self._buttons_row())
        rows.addLayout(self._progress_rows())
        self._show_state()

    def _settings_rows(self, label: str) -> QtGui.QFormLayout:
        self.net_type = ChoiceField(
            {name: translate("Ortho", name) for name in RECIPES}, "principal"
        )
        self.fairness = NumberField("fairness")
        self.closeness = NumberField("closeness")
        self.fix = ChoiceField(
            {
                "none": translate("Ortho", "nothing"),
                "corners": translate("Ortho", "corners"),
                "boundary": translate("Ortho", "boundary"),
            },
            "none",
            editable=True,
        )
        self.fix.widget.setToolTip(
            translate("Ortho", "Vertices that do not move; numbers such as 0,5,12 work too")
        )
        self.tolerance = NumberField("tolerance", 1e-10)
        form = QtGui.QFormLayout()
        size = f"{len(self._mesh.vertices)} / {len(self._mesh.faces)}"
        form.addRow(translate("Ortho", "Mesh"), QtGui.QLabel(label))
        form.addRow(translate("Ortho", "Vertices / faces"), QtGui.QLabel(size))
        form.addRow(translate("Ortho", "Net"), self.net_type.widget)
        form.addRow(translate("Ortho", "Fairness"), self.fairness.widget)
        form.addRow(translate("Ortho", "Closeness"), self.closeness.widget)
        form.addRow(translate("Ortho", "Keep in place"), self.fix.widget)
        form.addRow(translate("Ortho", "Tolerance"), self.tolerance.widget)
        return form

    def _buttons_row(self) -> QtGui.QHBoxLayout:
        self.start_button = QtGui.QPushButton(translate("Ortho", "Start"))
        self.stop_button = QtGui.QPushButton(translate("Ortho", "Stop"))
        self.start_button.clicked.connect(self.start)
        self.stop_button.clicked.connect(self.stop)
        row = QtGui.QHBoxLayout()
        row.addWidget(self.start_button)
        row.addWidget(self.stop_button)
        return row

    def _progress_rows(self) -> QtGui.QFormLayout:
        self._step_label, self._time_label = QtGui.QLabel("0"), QtGui.QLabel("")
        self._residual_label = QtGui.QLabel("")
        self._bar = QtGui.QProgressBar()
        self._bar.setRange(0, 100)
        self._bar.setValue(0)
        self._message = QtGui.QLabel("")
        self._message.setWordWrap(True)
        form = QtGui.QFormLayout()
        form.addRow(self._bar)
        form.addRow(translate("Ortho", "Step"), self._step_label)
        form.addRow(translate("Ortho", "Time a step"), self._time_label)
        form.addRow(translate("Ortho", "Worst"), self._residual_label)
        form.addRow(self._message)
        return form


def _uncover(net: FreeCAD.DocumentObject) -> dict[str, bool]:
    """Show a net and hide what stands on it; give what was visible before, by name."""
    structures = [item for item in net.InList if is_structure(item)]
    before = {item.Name: item.ViewObject.Visibility for item in (net, *structures)}
    for item in structures:
        item.ViewObject.Visibility = False
    net.ViewObject.Visibility = True
    return before


def _progress(worst: float, tolerance: float) -> int:
    """How much of the way from 1 to the tolerance is behind us, in decades, in percent."""
    if worst <= tolerance:
        return 100
    decades = math.log10(worst) / math.log10(min(tolerance, 0.1))
    return int(100 * min(max(decades, 0.0), 1.0))
