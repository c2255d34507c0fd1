"""The command line in two processes: one that works, and one that ends it in time.

Compiled code cannot be broken off from within: a large STEP file, a clash check or the import of a
package goes on for seconds after Ctrl-C. So the work is done in a process of its own, which is
killed where it does not end by itself, and what it leaves is swept. Imports nothing heavy.
"""

from __future__ import annotations

import importlib.util
import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType

from freecad_ortho.cli.endings import (
    ALL_WRITTEN,
    ENDING_SIGNALS,
    EXIT_BAD_INPUT,
    EXIT_NOT_CONVERGED,
    EXIT_STOPPED,
    held_back,
    let_through,
    pass_over,
    stopped_words,
)

# Seconds that the work has to end by itself once it has been told to, and how many times that at
# most where others keep the machine busy: what an optimisation has reached is still to be written.
_GRACE, _MOST = 1.0, 4.0


def supervised(arguments: Sequence[str] | None = None) -> int:
    """Run one command in a process of its own; return its exit code.

    Ctrl-C, and being asked to end (SIGTERM), are answered within two seconds.
    """
    words = sys.argv[1:] if arguments is None else list(arguments)
    targets = _targets(words)
    # Not a method of the path, which fails where a name is too long.
    missing = [
        path for target in targets for path in (target, *target.parents) if not os.path.exists(path)
    ]
    for number in ENDING_SIGNALS:
        signal.signal(number, signal.default_int_handler)
    finished = False
    # Neither process can be stopped before it knows how; the work inherits what is held back.
    held_back()
    with subprocess.Popen([sys.executable, "-m", "freecad_ortho.cli", *words]) as work:
        try:
            let_through()
            code = work.wait()
        except KeyboardInterrupt:
            if not ended(work):
                finished = _clear(targets, missing)
            code = EXIT_STOPPED if work.returncode < 0 else work.returncode
    if code < 0:
        _clear(targets, missing)
        sys.stderr.write(f"error: killed by signal {-code}; is there enough memory?\n")
        return EXIT_BAD_INPUT
    if code == EXIT_STOPPED:
        sys.stderr.write(ALL_WRITTEN if finished else stopped_words(words))
        return EXIT_NOT_CONVERGED
    return code


def grace() -> float:
    """Seconds that the work is given, by how many processes share a core."""
    if not hasattr(os, "getloadavg"):
        return _GRACE
    # A command and its workers may keep all cores busy themselves.
    crowd = os.getloadavg()[0] / (os.cpu_count() or 1) - 0.5
    return _GRACE * min(max(crowd, 1.0), _MOST)


def ended(work: subprocess.Popen[bytes]) -> bool:
    """Ask the work to end; kill it and return false where it does not."""
    latest = time.monotonic() + grace()
    pass_over()
    work.send_signal(signal.SIGTERM)
    try:
        work.wait(max(latest - time.monotonic(), 0.0))
    except subprocess.TimeoutExpired:
        work.kill()
        work.wait()
        return False
    return work.returncode >= 0


def _targets(words: Sequence[str]) -> list[Path]:
    """Files and folders that a command may write: all its arguments that are no options."""
    values = [word.partition("=")[2] if word.startswith("-") else word for word in words]
    return [Path(value) for value in values if value and "\0" not in value]


def _clear(targets: Sequence[Path], missing: Sequence[Path]) -> bool:
    """Sweep what work that was killed has left, and the folders that it had made.

    Returns whether it was killed as its files were moved into place, which is done then.
    """
    finished = False
    leftovers = _leftovers()
    for target in targets:
        try:
            finished = leftovers.sweep(target) or finished
        except OSError as error:
            sys.stderr.write(f"error: {target}: cannot be cleared ({error.strerror})\n")
    for path in missing:
        if os.path.isdir(path) and not any(path.iterdir()):
            path.rmdir()
    return finished


def _leftovers() -> ModuleType:
    """The module ``solver.io.leftovers``, without its package, which would load numpy first."""
    path = Path(__file__).resolve().parents[2] / "solver" / "io" / "leftovers.py"
    spec = importlib.util.spec_from_file_location("leftovers", path)
    if spec is None or spec.loader is None:
        raise ImportError(f"{path} is missing; install the project again")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
