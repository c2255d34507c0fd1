"""A watched run of the solver: steps in the background, so that FreeCAD stays alive."""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any

from PySide import QtCore

from freecad_ortho.panels.background import LOOK, worker
from solver.errors import OrthoError

# Steps of small meshes are bundled up to this time; the window is redrawn in between.
_BUNDLE = 0.03


class Run(QtCore.QObject):
    """Steps an optimisation until it is finished or stopped; can be resumed.

    While it is running the optimisation belongs to a thread of its own; what is called here is
    called in the thread of the window, between steps.

    Args:
        optimisation: what :func:`freecad_ortho.api.start_optimisation` gives.
        stepped: called after each bundle of steps, with the last step's record.
        ended: called when there is nothing more to do, with an error message or None.
    """

    def __init__(
        self,
        optimisation: Any,
        stepped: Callable[[Any], None],
        ended: Callable[[str | None], None],
    ) -> None:
        super().__init__()
        self.optimisation = optimisation
        self.steps = 0
        self._stepped, self._ended = stepped, ended
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(LOOK)
        self._timer.timeout.connect(self._look)
        self._bundle: Future[list[Any]] | None = None

    @property
    def running(self) -> bool:
        """Tell whether steps are being made."""
        return self._timer.isActive()

    def resume(self) -> None:
        """Go on stepping; say so where there is nothing to do."""
        if self.optimisation.finished:
            self._ended(None)
        else:
            self._timer.start()

    def stop(self) -> None:
        """Make no further step; wait for the one that is under way."""
        self._timer.stop()
        bundle, self._bundle = self._bundle, None
        if bundle is not None:
            self._tell(bundle)

    def drop(self) -> None:
        """Make no further step, and tell nothing of one that is under way."""
        self._timer.stop()
        self._bundle = None

    def once(self) -> None:
        """Make one step; say so where there is nothing to do."""
        if self.optimisation.finished:
            self._ended(None)
        else:
            self._tell(worker.submit(self._steps, 0.0))

    def _look(self) -> None:
        if self._bundle is not None and self._bundle.done():
            bundle, self._bundle = self._bundle, None
            self._tell(bundle)
        if self._bundle is None and self.running:
            self._bundle = worker.submit(self._steps, _BUNDLE)

    def _steps(self, seconds: float) -> list[Any]:
        """A step, and more of them while the time is not up; their records."""
        end = time.perf_counter() + seconds
        records = [self.optimisation.step()]
        while not self.optimisation.finished and time.perf_counter() < end:
            records.append(self.optimisation.step())
        return records

    def _tell(self, bundle: Future[list[Any]]) -> None:
        """Say what came of a bundle of steps; wait for it where it is not done."""
        try:
            records = bundle.result()
        except OrthoError as error:
            self._timer.stop()
            self._ended(str(error))
            return
        except BaseException:
            # A timer that goes on would raise the same again and again.
            self._timer.stop()
            raise
        self.steps += len(records)
        self._stepped(records[-1])
        if self.optimisation.finished:
            self._timer.stop()
            self._ended(None)
