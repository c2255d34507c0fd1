"""Task panel that optimises a net while one watches."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from freecad_ortho import convert, documents, preferences
from freecad_ortho.documents import net_settings
from freecad_ortho.objects import source_net
from freecad_ortho.panels.advanced_box import AdvancedBox
from freecad_ortho.panels.constraint_box import ConstraintBox
from freecad_ortho.panels.fields import NARROW, length_words, sentence, shortened
from freecad_ortho.panels.net_choice import NetChoice
from freecad_ortho.panels.net_words import remark_words
from freecad_ortho.panels.residual_plot import ResidualPlot
from freecad_ortho.panels.run import Run
from freecad_ortho.panels.sight import bring_into_sight
from freecad_ortho.panels.watch import NetWatch, cover, uncover
from freecad_ortho.resources import icon
from freecad_ortho.window import context, messages
from solver import start_optimisation
from solver.analysis.kinds import NODES
from solver.report import CONVERGED, Repeated, Report

translate = FreeCAD.Qt.translate

# Milliseconds for which a panel that starts by itself is seen before.
_SEEN = 300


class OptimisePanel:
    """Settings, Start / Stop / Step / Undo, and what the solver says; OK keeps the result.

    The document is not touched before OK: while the solver runs only the picture moves.

    Args:
        net: the Net.
        then: begin at once, take the result if it is the net that is aimed at, close, and call
            this; else the panel waits for OK, as any other.

    Attributes:
        run: the run that was started last, None before and after Undo.
    """

    def __init__(self, net: FreeCAD.DocumentObject, then: Callable[[], None] | None = None) -> None:
        self._then = then
        self._document = net.Document.Name
        self._mesh = convert.quad_mesh(net)
        self._settings: dict[str, Any] = {}
        self.run: Run | None = None
        self._visible = uncover(net)
        self._build_form(net)
        self._watch = NetWatch(net, self._leave, self._changed)
        # Others may close the panel too, without asking.
        self.form.destroyed.connect(lambda *_: self._end())
        if then is not None:
            QtCore.QTimer.singleShot(_SEEN, self._begin)

    @property
    def net(self) -> FreeCAD.DocumentObject | None:
        """The net, None when it or its document has gone meanwhile."""
        return self._watch.net

    def start(self) -> None:
        """Start a run, or resume the stopped one when the settings are still the same."""
        with messages.errors_shown():
            self._prepare()
            remarks = [sentence(remark_words(each)) for each in self.run.optimisation.remarks]
            self._say("\n".join([translate("Ortho", "Running ..."), *remarks]))
            self.run.resume()
        self._show_state()

    def stop(self) -> None:
        """Make no further step; what has been reached stays on the screen."""
        self._then = None
        if self.run is not None and self.run.running:
            self._say(translate("Ortho", "Stopped. OK keeps this state, Start goes on."))
            # The step under way may be the last one, and then it has more to say.
            self.run.stop()
        self._show_state()

    def step(self) -> None:
        """Make a single step."""
        with messages.errors_shown():
            self._prepare()
            self.run.stop()
            self._say("")
            self.run.once()
        self._show_state()

    def undo(self) -> None:
        """Go back to the net as it was before Start."""
        if self.run is not None:
            self.run.drop()
            self.run = None
        if self.net is not None:
            self.net.ViewObject.Proxy.show_stored()
        self.plot.clear(self._tolerance())
        self._say(translate("Ortho", "The net is as it was before."))
        self._show_state()

    def settings(self) -> dict[str, Any]:
        """The settings as ``optimise_net`` takes them; those that the net has already are left out.

        Raises:
            InputError: a field does not hold a number.
        """
        wanted = {**self.choice.words, **self.constraints.words, **self.advanced.words}
        stored = net_settings.words(self.net)
        chosen = {
            word: value
            for word, value in wanted.items()
            if word in ("net", "fix") or value != stored[word]
        }
        return chosen | preferences.solver_settings()

    def accept(self) -> bool:
        """Keep what has been reached, as one undo step and one line of a macro."""
        if self.run is not None:
            self.run.stop()
        self._end()
        if self.net is not None and self._has_result():
            with messages.errors_shown():
                self._commit()
        elif self.net is not None:
            self.net.ViewObject.Proxy.show_stored()
        self._close()
        return True

    def reject(self) -> bool:
        """Show the net as it was."""
        self._end()
        if self.net is not None:
            self.net.ViewObject.Proxy.show_stored()
        self._close()
        return True

    def _prepare(self) -> None:
        """Have a run for the settings: the one that there is, or a new one.

        Raises:
            InputError: settings that cannot be used.
        """
        settings = self.settings()
        if self.run is not None and settings == self._settings:
            return
        self.constraints.stop_picking()
        self._mesh = source_net.starting_mesh(self.net)
        kept, passed = net_settings.divided(settings)
        values = net_settings.words(self.net) | kept
        optimisation = start_optimisation(
            self._mesh, **net_settings.solver_settings(values, self._mesh, self.net), **passed
        )
        if self.run is not None:
            self.run.drop()
        if source_net.is_outdated(self.net):
            self.net.ViewObject.Proxy.show_mesh(self._mesh)
        self._settings, self._shown_steps = settings, 0
        self.run = Run(optimisation, self._stepped, self._ended)
        self.plot.clear(values["tolerance"])
        self._count()

    def _stepped(self, record: Any) -> None:
        if self.net is None:
            self._leave()
            return
        optimisation = self.run.optimisation
        self.net.ViewObject.Proxy.show_vertices(optimisation.vertices)
        fresh = optimisation.history[self._shown_steps :]
        self._shown_steps += len(fresh)
        self.plot.add(fresh)
        self._count()

    def _count(self) -> None:
        """The line of the paper's table 2: size of the problem and time of a step."""
        optimisation = self.run.optimisation
        problem = optimisation.original
        seconds = [record.seconds for record in optimisation.history]
        pace = f"{1000 * float(np.median(seconds)):.0f} ms" if seconds else "-"
        self.statistics.setText(
            translate("Ortho", "{:,} vertices, {:,} variables, {:,} constraints, {} a step").format(
                len(self._mesh.vertices), problem.variables, problem.equations, pace
            )
        )

    def _ended(self, error: str | None) -> None:
        if error is None:
            outcome = self.run.optimisation.outcome()
            # The best shape of all attempts, not always the last one.
            self.net.ViewObject.Proxy.show_vertices(outcome.mesh.vertices)
            report = outcome.report
            self._say("\n".join([report.message, *_how_far(report), *report.remarks]))
            if self._then is not None and report.status == CONVERGED:
                QtCore.QTimer.singleShot(0, self._finish)
        else:
            self._say(error)
        self._show_state()
        # On a small screen the panel shows fewer lines than what was asked for takes.
        bring_into_sight(self.plot, self.message)

    def _has_result(self) -> bool:
        """Tell whether there is something to keep: of an outdated net an exact start, too."""
        if self.run is None:
            return False
        renewed = source_net.is_outdated(self.net) and self.run.optimisation.finished
        return bool(self.run.steps or renewed)

    def _begin(self) -> None:
        """Start once the panel is seen: FreeCAD shows it a while after it was asked for it."""
        if self._then is not None and not self.form.isVisible():
            QtCore.QTimer.singleShot(_SEEN, self._begin)
        elif self._then is not None:
            self.start()

    def _finish(self) -> None:
        """Take the result of a run that nobody has to judge, and go on."""
        then, self._then = self._then, None
        if then is not None:
            self.accept()
            QtCore.QTimer.singleShot(0, then)

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

    def _changed(self, name: str) -> None:
        """Drop the run when something else moves the net, undo for one."""
        if name in ("Vertices", "Faces") and self.run is not None:
            self.run.drop()
            self.run = None
            self._say(translate("Ortho", "The net has changed meanwhile. Start begins anew."))
            self._show_state()
        if name == "Faces":
            self.constraints.stop_picking()

    def _leave(self) -> None:
        """Stop when there is nothing left to work on; close when FreeCAD has done its part."""
        self._end()
        QtCore.QTimer.singleShot(0, self._close)

    def _close(self) -> None:
        """Show what was visible before, as far as it is still there, and close the panel."""
        self._end()
        cover(self._document, self._visible)
        FreeCADGui.Control.closeDialog()

    def _end(self) -> None:
        self._then = None
        if self.run is not None:
            self.run.drop()
        self.constraints.end()
        self._watch.end()

    def _tolerance(self) -> float:
        return float(self.net.TargetTolerance) if self.net is not None else 1e-10

    def _say(self, text: str) -> None:
        self.message.setText(text)
        self.message.setVisible(bool(text))

    def _show_state(self) -> None:
        running = self.run is not None and self.run.running
        over = self.run is not None and self.run.optimisation.finished
        self.start_button.setEnabled(not running)
        self.stop_button.setEnabled(running)
        self.step_button.setEnabled(not running and not over)
        self.undo_button.setEnabled(self.run is not None)
        for box in (self.choice.box, self.constraints.box, self.advanced.widget):
            box.setEnabled(not running)

    def _build_form(self, net: FreeCAD.DocumentObject) -> None:
        stored = net_settings.words(net)
        self.choice = NetChoice(net, stored)
        self.constraints = ConstraintBox(net, lambda: convert.quad_mesh(net), stored)
        self.advanced = AdvancedBox(stored)
        self.plot = ResidualPlot()
        self.statistics, self.message = QtGui.QLabel(), QtGui.QLabel()
        for label in (self.statistics, self.message):
            label.setWordWrap(True)
        self.statistics.setText(
            translate("Ortho", "{:,} vertices, {:,} faces").format(
                len(self._mesh.vertices), self._mesh.connectivity.face_count
            )
        )
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(translate("Ortho", "Optimise {}").format(shortened(net.Label)))
        self.form.setWindowIcon(QtGui.QIcon(icon("optimise")))
        column = QtGui.QVBoxLayout(self.form)
        column.setContentsMargins(0, 6, 0, 6)
        # What came of a run stands where it is seen without scrolling, below what was asked for.
        column.addWidget(self.choice.box)
        column.addLayout(self._buttons())
        for widget in (self.message, self.plot, self.statistics):
            column.addWidget(widget)
        for widget in (self.constraints.box, self.advanced.widget):
            column.addWidget(widget)
        # What is asked first in a panel stands at hand under these names too.
        self.net_type, self.fix = self.choice.net_type, self.constraints.fix
        fields = self.advanced.fields
        self.fairness, self.tolerance = fields["fairness"], fields["tolerance"]
        outdated = translate(
            "Ortho",
            "The source of this net has changed. Start begins anew with what it makes now.",
        )
        self._say(outdated if source_net.is_outdated(net) else "")
        self._show_state()

    def _buttons(self) -> QtGui.QGridLayout:
        self.start_button = QtGui.QPushButton(translate("Ortho", "Start"))
        self.stop_button = QtGui.QPushButton(translate("Ortho", "Stop"))
        self.step_button = QtGui.QPushButton(translate("Ortho", "Step"))
        self.undo_button = QtGui.QPushButton(translate("Ortho", "Undo"))
        self.start_button.clicked.connect(self.start)
        self.stop_button.clicked.connect(self.stop)
        self.step_button.clicked.connect(self.step)
        self.undo_button.clicked.connect(self.undo)
        buttons = (self.start_button, self.stop_button, self.step_button, self.undo_button)
        grid = QtGui.QGridLayout()
        for number, button in enumerate(buttons):
            button.setMinimumWidth(NARROW)
            grid.addWidget(button, number // 2, number % 2)
        return grid


def _how_far(report: Report) -> list[str]:
    """How far it is from its surface, from flat, and from the start where that is far, in mm."""
    off = report.form.off_surface
    words = translate("Ortho", "Off the surface by {} at most, {} on average.")
    said = [words.format(length_words(off.max), length_words(off.mean))]
    if report.within is not None and not report.is_within:
        words = translate("Ortho", "That is more than the {} that were allowed, at face {}.")
        said.append(words.format(length_words(report.within), off.face))
    if report.flat:
        words = translate("Ortho", "The largest gap of a face is {}, of face {}.")
        said.append(words.format(length_words(report.form.gap), report.form.gap_face))
    if report.repetition is not None:
        said.append(_kinds(report.repetition))
    if not report.far:
        return said
    before, after = (
        " x ".join(map(length_words, size)) for size in (report.size_start, report.size)
    )
    words = translate(
        "Ortho", "The shape moved by up to {} ({:.1f} mean edges). Its size was {} and is {}."
    )
    most = length_words(report.moved.max * report.mean_edge)
    return [*said, words.format(most, report.moved.max, before, after)]


def _kinds(found: Repeated) -> str:
    """How many kinds of parts there are."""
    measure = "{:.2g}°".format if found.of == NODES else length_words
    words = {
        "panels": translate("Ortho", "{} kinds of panels within {}, {} before."),
        "edges": translate("Ortho", "{} kinds of edges within {}, {} before."),
        "nodes": translate("Ortho", "{} kinds of nodes within {}, {} before."),
    }[found.of]
    said = words.format(found.kinds, measure(found.alike), found.kinds_before)
    miss = translate("Ortho", "The largest miss is {}.").format(measure(found.largest_miss))
    many = "" if found.is_reached else translate("Ortho", "That is more than the {} allowed.")
    return " ".join(filter(None, [said, miss, many.format(found.asked)]))
