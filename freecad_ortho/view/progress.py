"""FreeCAD's own progress bar around long work; Esc stops it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

import FreeCAD

from solver.errors import OrthoError

_STEPS = 100


@contextmanager
def shown(title: str) -> Iterator[Callable[[float, str], None]]:
    """Show a bar; give the function that moves it to a fraction from 0 to 1.

    Raises:
        OrthoError: from that function, when the user has pressed Esc.
    """
    bar = FreeCAD.Base.ProgressIndicator()
    bar.start(title, _STEPS)
    done = 0

    def move(fraction: float, words: str) -> None:
        nonlocal done
        while done < int(fraction * _STEPS):
            done += 1
            try:
                bar.next(True)
            except Exception as error:
                # Which exception it is differs between FreeCAD's versions; all mean the same.
                raise OrthoError("stopped; nothing was written") from error

    try:
        yield move
    finally:
        bar.stop()
