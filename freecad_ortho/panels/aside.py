"""Something long that is made in the background, while FreeCAD stays alive."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from typing import Any

from PySide import QtCore

from freecad_ortho.panels.background import worker
from solver.errors import OrthoError

# Milliseconds between looks at what has come of it.
_LOOK = 20
Waiting = Callable[[str], object]


class _BrokenOff(Exception):
    """What is made is no longer wanted."""


class _Task:
    """One piece of work; in its thread it says how far it is and hears whether it is wanted.

    Attributes:
        stage: of the work, as it says itself.
        dropped: it is no longer wanted.
    """

    def __init__(self) -> None:
        self.stage, self.dropped = "", False

    def heed(self, stage: str) -> None:
        if self.dropped:
            raise _BrokenOff
        self.stage = stage


class Aside(QtCore.QObject):
    """Makes the newest of what is asked for; what was asked for before is broken off.

    Args:
        reached: called with the name of each stage that is seen.
        ended: called with what was made, or with an error message.
    """

    def __init__(
        self, reached: Callable[[str], None], ended: Callable[[Any, str | None], None]
    ) -> None:
        super().__init__()
        self._reached, self._ended = reached, ended
        self._task, self._seen = _Task(), ""
        self._future: Future[Any] | None = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(_LOOK)
        self._timer.timeout.connect(self._look)

    @property
    def busy(self) -> bool:
        """Tell whether something is being made."""
        return self._future is not None

    def ask(self, work: Callable[[Waiting], Any]) -> None:
        """Begin to make something, in place of what is under way.

        Args:
            work: called in another thread, so that it must not touch documents or views, with a
                function that it calls with the name of each stage and whose errors it passes on.
        """
        self.stop()
        self._task, self._seen = _Task(), ""
        self._future = worker.submit(work, self._task.heed)
        self._timer.start()

    def stop(self) -> None:
        """Make nothing any more; what is under way ends at its next stage, and nobody is told."""
        self._timer.stop()
        self._task.dropped = True
        if self._future is not None:
            self._future.cancel()
            self._future = None

    def _look(self) -> None:
        stage, future = self._task.stage, self._future
        if stage != self._seen:
            self._seen = stage
            self._reached(stage)
        if future is None or not future.done():
            return
        self._timer.stop()
        self._future = None
        try:
            made = future.result()
        except OrthoError as error:
            self._ended(None, str(error))
            return
        self._ended(made, None)
