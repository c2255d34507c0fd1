"""How a command ends: exit codes, and Ctrl-C at the right moment. Imports nothing heavy."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager

EXIT_OK, EXIT_NOT_CONVERGED, EXIT_BAD_INPUT = 0, 1, 2


@contextmanager
def kept_whole() -> Iterator[None]:
    """Keep Ctrl-C, and being asked to end, until the block is through.

    Loading a large compiled package cannot be broken off: what is left of it fails in other words.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    pressed: list[int] = []
    before = {
        number: signal.signal(number, lambda number, frame: pressed.append(number))
        for number in (signal.SIGINT, signal.SIGTERM)
    }
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    if pressed:
        raise KeyboardInterrupt


def end_like_ctrl_c() -> None:
    """From here on, being asked to end (SIGTERM) cleans up like Ctrl-C does."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
