"""A dragged net that follows: solver steps while FreeCAD draws, the exact net in the end."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator
from concurrent.futures import Future
from typing import Any

from PySide import QtCore

from freecad_ortho.panels.background import LOOK, worker
from solver.errors import OrthoError
from solver.mesh.quadmesh import FloatArray

# A shape that moves less than this in a step, in mean edges, rests; no steps are spent on it.
_AT_REST = 1e-4
# Seconds from a step that followed the mouse to one that only brings the net nearer to rest: the
# next move of the mouse comes first.
_PAUSE = 0.05


class Live(QtCore.QObject):
    """Steps a session: while held towards the handles, when let go until the net is exact.

    From the first :meth:`aim` on the session belongs to a thread of its own. What comes of its
    steps is told in the thread of the window; once stopped, nothing more is told.

    Args:
        session: a :class:`solver.Session`.
        moved: called with the (V, 3) positions after each step while held.
        ended: called when the exact net is found, with the outcome, or with an error message.
    """

    def __init__(
        self,
        session: Any,
        moved: Callable[[FloatArray], None],
        ended: Callable[[Any, str | None], None],
    ) -> None:
        super().__init__()
        self.session = session
        self.frames: list[float] = []
        self._moved, self._ended = moved, ended
        self._places: dict[int, FloatArray] = {}
        self._settling: Generator[Any, None, Any] | None = None
        self._step: Future[Callable[[], None]] | None = None
        self._resting, self._rest_after = False, 0.0
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(LOOK)
        self._timer.timeout.connect(self._look)

    @property
    def settling(self) -> bool:
        """Tell whether the handles have been let go and the exact net is not found yet."""
        return self._settling is not None

    @property
    def busy(self) -> bool:
        """Tell whether a step is under way."""
        return self._step is not None

    def aim(self, places: dict[int, FloatArray]) -> None:
        """Move handles and go on stepping towards them; ends settling."""
        self._settling = None
        self._places.update(places)
        self._timer.start()

    def settle(self) -> None:
        """Find the exact net for the handles as they are."""
        self._settling = self._settled(self._places)
        self._places = {}
        self._timer.start()

    def stop(self) -> None:
        """Make no further step, and tell nothing of one that is under way."""
        self._timer.stop()
        self._settling = self._step = None
        self._places = {}

    def _look(self) -> None:
        """Tell what has come of a step, and begin the next."""
        try:
            tell = None
            if self._step is not None:
                if not self._step.done():
                    return
                tell, self._step = self._step.result(), None
            # The next step is made while the picture of this one is drawn.
            self._begin()
            if tell is not None:
                tell()
        except OrthoError as error:
            self.stop()
            self._ended(None, str(error))
        except BaseException:
            # A timer that goes on would raise the same again and again.
            self.stop()
            raise

    def _begin(self) -> None:
        if self._settling is not None:
            self._step = worker.submit(self._settle, self._settling)
        elif self._places:
            places, self._places = self._places, {}
            self._resting, self._rest_after = False, time.perf_counter() + _PAUSE
            self._step = worker.submit(self._follow, places)
        elif self._resting:
            self._timer.stop()
        elif time.perf_counter() > self._rest_after:
            self._step = worker.submit(self._follow, {})

    def _follow(self, places: dict[int, FloatArray]) -> Callable[[], None]:
        """One step, in the worker; what it returns is called in the window's thread."""
        record = self.session.drag(places)
        points = self.session.vertices

        def tell() -> None:
            self.frames.append(time.perf_counter())
            self._resting = record.step_length < _AT_REST
            self._moved(points)

        return tell

    def _settle(self, settling: Generator[Any, None, Any]) -> Callable[[], None]:
        """Steps of settling, in the worker, until the net is exact or no longer wanted."""
        while settling is self._settling:
            try:
                next(settling)
            except StopIteration as end:
                outcome = end.value
                return lambda: self._end(settling, outcome)
        return lambda: None

    def _settled(self, places: dict[int, FloatArray]) -> Generator[Any, None, Any]:
        if places:
            # The mouse moved on since the last step.
            yield self.session.drag(places)
        return (yield from self.session.settling())

    def _end(self, settling: Generator[Any, None, Any], outcome: Any) -> None:
        if settling is self._settling:
            self.stop()
            self._ended(outcome, None)
