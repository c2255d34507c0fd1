"""Compiled libraries in a process of their own: no crash, panic or hang of theirs can pass.

An object that calls the library lives in that process for as long as this side keeps its
:class:`Isolated`; arguments and results travel as pickles. What goes wrong there arrives here as
one error with one line.
"""

from __future__ import annotations

import importlib
import os
import pickle
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import Any, BinaryIO

from solver.errors import OrthoError

# How often one looks whether an answer has come, in seconds.
_LOOK = 0.1
# Longest quotation of what a library said.
_WORDS = 100
_LENGTH = struct.Struct("<Q")
# The working folder is nobody's library.
_OTHER_SIDE = "import sys; del sys.path[0]; from solver.isolated import serve; serve()"


class LibraryError(OrthoError):
    """A library crashed, raised, hung or could not be started."""


class Isolated:
    """An object in a process of its own, made at the first call and gone at the first failure.

    Args:
        kind: its class, at the top of a module that both processes can import.
        arguments: what it is made from.
    """

    def __init__(self, kind: type, *arguments: object) -> None:
        self._kind = kind
        self._arguments = arguments
        self._process: subprocess.Popen[bytes] | None = None
        self._errors: BinaryIO | None = None

    def call(
        self,
        method: str,
        *arguments: object,
        time_limit: float,
        waiting: Callable[[float], object] | None = None,
    ) -> Any:
        """Call a method of the object and return what it returns.

        Args:
            method: its name.
            arguments: of the method.
            time_limit: seconds that it may take.
            waiting: called several times a second meanwhile, with the part of the limit that is
                over; what it raises ends the process and is passed on.

        Raises:
            LibraryError: no answer, or an answer that is an error; the next call starts anew.
        """
        sent = _packed((method, arguments))
        if self._process is None:
            made_from = (self._kind.__module__, self._kind.__qualname__, self._arguments)
            sent = _packed(made_from) + sent
        process = self._process or self._start()
        answers: SimpleQueue[bytes | None] = SimpleQueue()
        threading.Thread(target=_exchange, args=(process, sent, answers), daemon=True).start()
        try:
            answer = _awaited(answers, time_limit, waiting or (lambda part: None))
        except BaseException:
            self.close()
            raise
        if answer is None:
            raise LibraryError(self._last_words())
        # Here, not in the thread that waited for it: much that is made may have Python's collector
        # come due, which deletes the garbage of all, widgets of a window too.
        good, value = pickle.loads(answer)
        if not good:
            self.close()
            raise LibraryError(value)
        return value

    def close(self) -> None:
        """End the process; the object is made anew when it is called again."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            for stream in (self._process.stdin, self._process.stdout, self._errors):
                if stream is not None:
                    _close(stream)
        self._process = self._errors = None

    def __enter__(self) -> Isolated:
        """Return the object itself."""
        return self

    def __exit__(self, *_: object) -> None:
        """End the process."""
        self.close()

    def __del__(self) -> None:
        """Leave no process behind."""
        self.close()

    def _start(self) -> subprocess.Popen[bytes]:
        root = str(Path(__file__).resolve().parents[1])
        path = os.pathsep.join([part for part in sys.path if part] + [root])
        self._errors = tempfile.TemporaryFile()
        try:
            self._process = subprocess.Popen(
                [_interpreter(), "-c", _OTHER_SIDE],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=self._errors,
                env={**os.environ, "PYTHONPATH": path, "RUST_BACKTRACE": "0"},
                # On Windows no console comes up.
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
            )
        except OSError as error:
            self.close()
            raise LibraryError(f"no process could be started for it: {error}") from None
        return self._process

    def _last_words(self) -> str:
        """What the process said last before it ended."""
        assert self._process is not None and self._errors is not None
        code = self._process.wait()
        self._errors.seek(0)
        lines = self._errors.read().decode("utf-8", "replace").strip().splitlines()
        self.close()
        return lines[-1][:_WORDS] if lines else f"it ended with code {code} and no message"


def _interpreter() -> str:
    """A Python of this version: inside another program ``sys.executable`` is that program."""
    name = f"python{sys.version_info.major}.{sys.version_info.minor}"
    if Path(sys.executable).stem.lower().startswith("python"):
        return sys.executable
    folder = Path(sys.base_prefix)
    for place in (folder / "bin" / name, folder / "python.exe", folder / "bin" / "python.exe"):
        if place.is_file():
            return str(place)
    return shutil.which(name) or shutil.which("python3") or sys.executable


def _awaited(
    answers: SimpleQueue[bytes | None], time_limit: float, waiting: Callable[[float], object]
) -> bytes | None:
    start = time.monotonic()
    while True:
        try:
            return answers.get(timeout=_LOOK)
        except Empty:
            part = (time.monotonic() - start) / time_limit
            if part >= 1:
                raise LibraryError(
                    f"it did not finish within {time_limit:g} s and was stopped"
                ) from None
            waiting(part)


def _exchange(
    process: subprocess.Popen[bytes], sent: bytes, answers: SimpleQueue[bytes | None]
) -> None:
    """Send a question and wait for its answer; None where the other side has ended."""
    assert process.stdin is not None and process.stdout is not None
    try:
        process.stdin.write(sent)
        process.stdin.flush()
        answers.put(_receive(process.stdout))
    except (OSError, EOFError, ValueError):
        answers.put(None)


def _close(stream: Any) -> None:
    try:
        stream.close()
    except OSError:
        # What was not yet written has nowhere to go.
        return


def _packed(value: Any) -> bytes:
    data = pickle.dumps(value, protocol=pickle.HIGHEST_PROTOCOL)
    return _LENGTH.pack(len(data)) + data


def _receive(stream: Any) -> bytes:
    """The next value, packed.

    Raises:
        EOFError: there is none.
    """
    head = stream.read(_LENGTH.size)
    if len(head) < _LENGTH.size:
        raise EOFError
    (length,) = _LENGTH.unpack(head)
    data = stream.read(length)
    if len(data) < length:
        raise EOFError
    return bytes(data)


def serve() -> None:
    """Be the other side: make the object, then answer one question after the other."""
    # What a library prints must not get between the answers.
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    module, name, arguments = pickle.loads(_receive(sys.stdin.buffer))
    served = getattr(importlib.import_module(module), name)(*arguments)
    while True:
        try:
            method, given = pickle.loads(_receive(sys.stdin.buffer))
        except EOFError:
            return
        answers.write(_packed(_answer(getattr(served, method), given)))
        answers.flush()


def _answer(method: Callable[..., Any], given: tuple[Any, ...]) -> tuple[bool, Any]:
    try:
        return True, method(*given)
    except (KeyboardInterrupt, SystemExit):
        raise
    except BaseException as error:
        # Panics of compiled code are no Exceptions; here is where they end.
        said = (str(error).strip().splitlines() or [type(error).__name__])[0]
        return False, said[:_WORDS]
