"""A dragged net that follows: solver steps from a timer while it is held, the exact net after."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator
from typing import Any

from PySide import QtCore

from solver.errors import OrthoError
from solver.mesh.quadmesh import FloatArray

# A shape that moves less than this in a step, in mean edges, rests; no steps are spent on it.
_AT_REST = 1e-4
# Milliseconds from a step that followed the mouse to one that only brings the net nearer to rest:
# the next move of the mouse, and the redraw, come first.
_PAUSE = 50


class Live(QtCore.QObject):
    """Steps a session: while held towards the handles, when let go until the net is exact.

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
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self._tick)

    @property
    def settling(self) -> bool:
        """Tell whether the handles have been let go and the exact net is not found yet."""
        return self._settling is not None

    def aim(self, places: dict[int, FloatArray]) -> None:
        """Move handles and go on stepping towards them; ends settling."""
        self._settling = None
        self._places.update(places)
        self._timer.start(0)

    def settle(self) -> None:
        """Find the exact net for the handles as they are."""
        if self._places:
            # The mouse moved on since the last step.
            self.session.drag(self._places)
            self._places = {}
        self._settling = self.session.settling()
        self._timer.start(0)

    def stop(self) -> None:
        """Make no further step."""
        self._timer.stop()
        self._settling = None

    def _tick(self) -> None:
        try:
            self._settle_on() if self._settling is not None else self._follow()
        except OrthoError as error:
            self.stop()
            self._ended(None, str(error))
        except BaseException:
            # A timer that goes on would raise the same again and again.
            self.stop()
            raise

    def _follow(self) -> None:
        places, self._places = self._places, {}
        record = self.session.drag(places)
        self.frames.append(time.perf_counter())
        if record.step_length < _AT_REST:
            self._timer.stop()
        else:
            self._timer.start(_PAUSE if places else 0)
        self._moved(self.session.vertices)

    def _settle_on(self) -> None:
        try:
            next(self._settling)
        except StopIteration as end:
            self.stop()
            self._ended(end.value, None)
