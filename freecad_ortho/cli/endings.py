"""How a command ends: exit codes, and Ctrl-C at the right moment. Imports nothing heavy."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from types import FrameType

EXIT_OK, EXIT_NOT_CONVERGED, EXIT_BAD_INPUT = 0, 1, 2
# Between two processes of ours only: the work was stopped, as a shell counts it.
EXIT_STOPPED = 130
NOTHING_WRITTEN = "stopped; nothing was written\n"
ALL_WRITTEN = "stopped after its files were finished; all of them are in place\n"
_GOES_ON = {"build": "stopped; finished stages are kept, the same command goes on from there\n"}
ENDING_SIGNALS = (signal.SIGINT, signal.SIGTERM)


def stopped_words(arguments: Sequence[str]) -> str:
    """What there is to say of a command that was stopped, by its arguments."""
    return _GOES_ON.get(next(iter(arguments), ""), NOTHING_WRITTEN)


@contextmanager
def kept_whole() -> Iterator[None]:
    """Keep Ctrl-C, and being asked to end, until the block is through.

    Loading a large compiled package cannot be broken off: what is left of it fails in other words.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    pressed: list[signal.Signals] = []
    before = {
        number: signal.signal(number, lambda number, frame: pressed.append(signal.Signals(number)))
        for number in ENDING_SIGNALS
    }
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    if pressed and callable(handler := before[pressed[0]]):
        handler(pressed[0], None)


def held_back() -> None:
    """Keep what asks this process, or one that it starts now, to end, until it is let through."""
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_BLOCK, ENDING_SIGNALS)


def let_through() -> None:
    """Let come what was held back."""
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, ENDING_SIGNALS)


def pass_over() -> None:
    """Do nothing from here on when asked to end.

    By functions, since Python complains of a signal that has come already and is then ignored.
    """
    for number in ENDING_SIGNALS:
        signal.signal(number, lambda number, frame: None)


def past_stopping() -> None:
    """From here on the command ends by itself: what it writes now is not called off any more."""
    if threading.current_thread() is threading.main_thread():
        # Not held back, which is for one thread: those of compiled libraries would take it.
        pass_over()


@contextmanager
def stopped_as_before() -> Iterator[None]:
    """After the block Ctrl-C, and being asked to end, do again what they did before it."""
    before = {number: signal.getsignal(number) for number in ENDING_SIGNALS}
    try:
        yield
    finally:
        if threading.current_thread() is threading.main_thread():
            for number, handler in before.items():
                if handler is not None:
                    signal.signal(number, handler)


def end_once() -> None:
    """From here on, being asked to end (SIGTERM) cleans up like Ctrl-C does.

    Only the first time: what is cleared away then is not broken off again.
    """

    def end(number: int, frame: FrameType | None) -> None:
        pass_over()
        raise KeyboardInterrupt

    for number in ENDING_SIGNALS:
        signal.signal(number, end)
