"""A watched run of the solver: one step at a time from a timer, so that FreeCAD stays alive."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from PySide import QtCore

from solver.errors import OrthoError

# Steps of small meshes are bundled up to this time; the window is redrawn in between.
_SECONDS_PER_TICK = 0.03


class Run(QtCore.QObject):
    """Steps an optimisation until it is finished or stopped; can be resumed.

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
        self._timer.setInterval(0)
        self._timer.timeout.connect(self._tick)

    @property
    def running(self) -> bool:
        """Tell whether steps are being made."""
        return self._timer.isActive()

    def resume(self) -> None:
        """Go on stepping."""
        if not self.optimisation.finished:
            self._timer.start()

    def stop(self) -> None:
        """Make no further step."""
        self._timer.stop()

    def once(self) -> None:
        """Make one step."""
        if not self.optimisation.finished:
            self._advance(0.0)

    def _tick(self) -> None:
        self._advance(_SECONDS_PER_TICK)

    def _advance(self, seconds: float) -> None:
        """Make a step, and more of them while the time is not up."""
        end = time.perf_counter() + seconds
        try:
            while not self.optimisation.finished:
                record = self.optimisation.step()
                self.steps += 1
                if time.perf_counter() > end:
                    break
        except OrthoError as error:
            self.stop()
            self._ended(str(error))
            return
        except BaseException:
            # A timer that goes on would raise the same again and again.
            self.stop()
            raise
        self._stepped(record)
        if self.optimisation.finished:
            self.stop()
            self._ended(None)
