"""What a compiled library may do to itself, and what arrives of it on this side."""

from __future__ import annotations

import os
import sys
import time

import numpy as np
import pytest

from solver.errors import OrthoError
from solver.isolated import Isolated, LibraryError

# A library with all faults; pyo3's panics are BaseExceptions like this one.
FAULTY = """
import ctypes, os, time

class Panic(BaseException):
    pass

class Faulty:
    def __init__(self, start=0):
        self.count = start

    def add(self, number):
        self.count += number
        return self.count

    def noise(self):
        print("words of the library")
        os.system("echo more of them")
        return "answer"

    def panic(self):
        raise Panic("called `unwrap` on nothing\\nstack backtrace:\\n  0: begin")

    def die(self):
        os._exit(11)

    def crash(self):
        os.write(2, b"backtrace\\nsegmentation fault in the library\\n")
        ctypes.string_at(0)

    def hang(self):
        time.sleep(60)
"""


@pytest.fixture
def kind(tmp_path, monkeypatch):
    (tmp_path / "faulty_library.py").write_text(FAULTY)
    monkeypatch.syspath_prepend(str(tmp_path))
    import faulty_library

    yield faulty_library.Faulty
    del sys.modules["faulty_library"]


def test_the_object_keeps_its_state_between_calls(kind):
    with Isolated(kind, 5) as library:
        assert [library.call("add", k, time_limit=30) for k in (1, 2)] == [6, 8]
        large = np.arange(2_000_000.0)
        assert library.call("add", large, time_limit=30)[-1] == 8 + large[-1]


def test_what_a_library_prints_does_not_get_between_the_answers(kind, capfd):
    with Isolated(kind) as library:
        assert library.call("noise", time_limit=30) == "answer"
        assert library.call("add", 1, time_limit=30) == 1
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("act", "words"),
    [
        ("panic", "called `unwrap` on nothing"),
        ("die", "it ended with code 11 and no message"),
        ("crash", "segmentation fault in the library"),
        ("hang", "it did not finish within 1 s and was stopped"),
    ],
)
def test_whatever_happens_is_one_line_and_the_next_call_starts_anew(kind, capfd, act, words):
    with Isolated(kind) as library:
        library.call("add", 7, time_limit=30)
        start = time.monotonic()
        with pytest.raises(LibraryError) as caught:
            library.call(act, time_limit=1 if act == "hang" else 30)
        assert str(caught.value) == words and isinstance(caught.value, OrthoError)
        assert time.monotonic() - start < 10
        assert library.call("add", 1, time_limit=30) == 1
    assert capfd.readouterr() == ("", "")


def test_who_waits_may_end_it_and_no_process_stays(kind):
    def waiting(part):
        raise KeyboardInterrupt

    library = Isolated(kind)
    library.call("add", 1, time_limit=30)
    process = library._process
    with pytest.raises(KeyboardInterrupt):
        library.call("hang", time_limit=30, waiting=waiting)
    assert process.poll() is not None


def test_a_folder_of_the_user_is_no_library(kind, tmp_path, monkeypatch):
    """A package 'solver' where the program happens to be run is not taken for the project's."""
    (tmp_path / "here" / "solver").mkdir(parents=True)
    (tmp_path / "here" / "solver" / "__init__.py").write_text("raise SystemExit('the wrong one')")
    monkeypatch.chdir(tmp_path / "here")
    with Isolated(kind) as library:
        assert library.call("add", 1, time_limit=30) == 1


def test_no_interpreter_is_said(kind, monkeypatch):
    monkeypatch.setattr("solver.isolated._interpreter", lambda: os.devnull)
    with pytest.raises(LibraryError, match="no process could be started"):
        Isolated(kind).call("add", 1, time_limit=30)
