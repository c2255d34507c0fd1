"""Work on parts through any executor, or a local pool of processes that FreeCAD can start too."""

from __future__ import annotations

import multiprocessing
import signal
import sys
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import spawn
from pathlib import Path
from typing import TypeVar

from freecad_ortho.processes import end_with_parent
from solver.errors import InputError
from solver.option import Option, Range

Given = TypeVar("Given")
Made = TypeVar("Made")
_CHUNK = 64


def in_chunks(
    function: Callable[[Sequence[Given]], list[Made]],
    items: Sequence[Given],
    executor: Executor | None = None,
    progress: Callable[[float], None] | None = None,
    size: int = _CHUNK,
) -> list[Made]:
    """Apply a function of a list to chunks of the items; results in the order of the items.

    Args:
        function: of a module, so that other processes find it; gets a chunk, gives a list.
        items: what travels to the workers.
        executor: without one the work is done here.
        progress: called with the fraction done; may raise to stop, what was not begun is dropped.
        size: of a chunk.
    """
    chunks = [items[start : start + size] for start in range(0, len(items), size)]
    say = progress or (lambda fraction: None)
    if executor is None:
        results: Iterator[list[Made]] = map(function, chunks)
        futures = []
    else:
        futures = [executor.submit(function, chunk) for chunk in chunks]
        results = (future.result() for future in futures)
    made: list[Made] = []
    try:
        for number, result in enumerate(results):
            say(number / len(chunks))
            made.extend(result)
    finally:
        for future in futures:
            future.cancel()
    return made


WORKERS = Option("workers", None, "count", "So many processes share the work", within=Range(1, 256))


@contextmanager
def local_pool(workers: int | None) -> Iterator[Executor | None]:
    """Give a pool of processes on this machine, None for no or one worker.

    The processes are started with the interpreter of the environment, not with ``sys.executable``,
    which inside FreeCAD is FreeCAD.

    Raises:
        InputError: not a number of workers.
    """
    if workers is None or workers == 1:
        yield None
        return
    WORKERS.check(workers)
    before = spawn.get_executable()
    spawn.set_executable(interpreter())
    try:
        context = multiprocessing.get_context("spawn")
        pool = ProcessPoolExecutor(workers, context, initializer=_serve)
        with _plain_main(), pool:
            try:
                yield pool
            except BaseException:
                # What was begun is finished, the rest dropped: processes that are killed while
                # work is on its way to them can leave this one waiting for good.
                pool.shutdown(wait=True, cancel_futures=True)
                raise
    finally:
        spawn.set_executable(before)


def interpreter() -> str:
    """Path of the Python that runs this, also where the running program is FreeCAD.

    Raises:
        InputError: there is none beside the packages in use.
    """
    if Path(sys.executable).stem.lower().startswith("python"):
        return sys.executable
    here = Path(__file__).resolve().parents[2] / ".venv"
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    bases = [here, Path(sys.prefix), Path(sys.base_prefix)]
    names = [f"bin/{version}", "bin/python3", "Scripts/python.exe", "python.exe"]
    for path in (base / name for base in bases for name in names):
        if path.is_file():
            return str(path)
    raise InputError(f"workers: no {version} found beside FreeCAD; leave the workers out")


def _serve() -> None:
    """End with the process that is served, not with Ctrl-C, which reaches all of a terminal."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    end_with_parent()


@contextmanager
def _plain_main() -> Iterator[None]:
    """Keep workers from running the main script again: all they do is imported by name."""
    main = sys.modules["__main__"]
    file, spec = getattr(main, "__file__", None), getattr(main, "__spec__", None)
    if file is not None:
        del main.__file__
    main.__spec__ = None
    try:
        yield
    finally:
        if file is not None:
            main.__file__ = file
        main.__spec__ = spec
