"""The thread in which panels have the solver work while FreeCAD draws."""

from __future__ import annotations

import gc
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any

from PySide import QtCore

# Milliseconds between looks at whether a step is done.
LOOK = 1
# Milliseconds between looks at what can be let go.
_LET_GO = 100


class Worker:
    """Works one thing off after the other, in the order in which they are asked for.

    What it is given must not touch anything of FreeCAD's: documents and views belong to the thread
    of the window. Nor may widgets, timers and scenes be deleted anywhere but there, FreeCAD crashes
    or hangs else. So what a piece of work was made of is let go there, when it has been done for
    long enough that the other thread has, and Python's collector, which deletes the garbage of
    all in whichever thread it comes due, rests meanwhile; young garbage is collected here.
    """

    def __init__(self) -> None:
        self._pool = ThreadPoolExecutor(max_workers=1, thread_name_prefix="ortho-solver")
        self._begun: list[tuple[Future[Any], Any]] = []
        self._ended: list[tuple[Future[Any], Any]] = []
        self._timer: QtCore.QTimer | None = None
        self._collects = False

    def submit(self, work: Callable[..., Any], *arguments: Any) -> Future[Any]:
        """Have something done; called in the thread of the window.

        Args:
            work: called in the other thread.
            *arguments: what it is called with.
        """
        if self._timer is None:
            self._timer = QtCore.QTimer()
            self._timer.setInterval(_LET_GO)
            self._timer.timeout.connect(self._let_go)
        if not self._timer.isActive():
            self._collects = gc.isenabled()
            gc.disable()
            self._timer.start()
        future = self._pool.submit(work, *arguments)
        self._begun.append((future, (work, arguments)))
        return future

    def _let_go(self) -> None:
        """Forget what was done at the last look already; let the collector work where all was."""
        looked = [(piece, piece[0].done()) for piece in self._begun]
        self._ended = [piece for piece, done in looked if done]
        self._begun = [piece for piece, done in looked if not done]
        # Also counts anew, so that the collector does not come due in the other thread's last line.
        gc.collect(0)
        if not self._begun and not self._ended and self._timer is not None:
            self._timer.stop()
            if self._collects:
                gc.enable()


worker = Worker()
