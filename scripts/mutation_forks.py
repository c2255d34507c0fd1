"""Tries many changes at a time in forks of one warm process: the quick pass of `mutations.py`.

A file of tests is loaded once. A first fork of it runs its tests and notes which changes they
reach; each change that is reached then gets a fork where it is made in the functions that are
loaded already, with the tests that reach it, the quickest first. The files of tests that know most
of what is still to be noticed come first. Tests that start other programs are not asked, nor is
what takes long: `mutations.py --again` does that for the few that are left.
"""

from __future__ import annotations

import builtins
import gc
import json
import os
import re
import resource
import shutil
import signal
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any, NoReturn

import pytest
from mutation_map import ONE_THREAD
from mutation_places import Mutation
from mutation_probes import CALLED, Loaded, Places, load_as

# Seconds of a processor: what prepares a test and a test itself may take in the first run, all
# cases of one test, a file; then the tests for one change, fewer where they are far from it.
_SETUP, _CALL, _CASES, _FILE = 8.0, 3.0, 4.0, 40.0
_NEAR, _BESIDE, _FAR = (3, 8.0), (8, 4.0), 1.5
# A change that makes tests run longer than this never ends.
_ENDLESS = 120.0
# What measures time fails on a busy machine.
_TIMED = re.compile(r"speed|_time|seconds|quick|ctrl_c|interrupt|kill|little_more|slowly")


class _Cut(BaseException):
    """A test of the first run takes too long."""


@dataclass
class Tried:
    """What came of a file of tests for one change.

    Attributes:
        tests: how many were asked.
        by: the test that noticed it; "" for none.
    """

    tests: int
    by: str = ""


@dataclass(frozen=True)
class Warm:
    """What all forks know.

    Attributes:
        root: the tree, which is not changed.
        drawn: the changes by their numbers.
        places: where they show.
        ranks: for each change, how near each file of tests is to it, 0 the nearest.
    """

    root: Path
    drawn: Mapping[int, Mutation]
    places: Places
    ranks: Mapping[int, Mapping[str, int]]

    def changed(self, number: int) -> dict[str, Any]:
        """Compile the file of a change with it."""
        change = self.drawn[number]
        path = str(self.root / change.file)
        text = change.applied(self.places.sources[change.file])
        return {path: compile(text, path, "exec", dont_inherit=True)}

    def allowance(self, number: int, file: str) -> float:
        """Seconds that a file's tests may take for a change."""
        rank = self.ranks[number][file]
        return next((seconds for most, seconds in (_NEAR, _BESIDE) if rank < most), _FAR)

    def try_all(self, tests: Sequence[str], done: Callable[[str, dict[int, Tried]], None]) -> None:
        """Run through the files of tests until each change is noticed.

        Args:
            tests: files of tests, from the root.
            done: is told of each file what came of it; changes noticed are not tried again.
        """
        left, files = set(self.drawn), set(tests)
        while left and files:
            worth = {
                file: sum(1 / (1 + self.ranks[number][file]) for number in left) for file in files
            }
            file = max(sorted(files), key=lambda one: worth[one])
            files.remove(file)
            found = self.try_file(file, sorted(left))
            left -= {number for number, tried in found.items() if tried.by}
            done(file, found)

    def try_file(self, file: str, numbers: Sequence[int]) -> dict[int, Tried]:
        """Try changes with the tests of one file."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            _fork(lambda: self._pytest(_Session(self, file, folder, numbers), folder), 3600.0)
            found = _read(folder / "found.json") or {}
            for number, asked in found.items():
                if asked["by"] is None:
                    asked["by"] = self._loaded_anew(int(number), file, asked["names"], folder)
        return {int(number): Tried(len(one["names"]), one["by"]) for number, one in found.items()}

    def _loaded_anew(self, number: int, file: str, names: list[str], folder: Path) -> str:
        """Try a change that shows only when its file is loaded."""

        def fresh() -> None:
            load_as(self.changed(number))
            self._pytest(_Session(self, file, folder, only=names), folder)

        _fork(fresh, 10 * _ENDLESS)
        tried = _read(folder / "tried.json")
        (folder / "tried.json").unlink(missing_ok=True)
        return "what loads it" if tried is None else str(tried)

    def _pytest(self, session: _Session, folder: Path) -> None:
        os.chdir(self.root)
        os.environ.update(ONE_THREAD)
        sys.dont_write_bytecode = True
        sys.path[:] = [str(self.root), *(path for path in sys.path if path)]
        silent = os.open(os.devnull, os.O_RDWR)
        for number in range(3):
            os.dup2(silent, number)
        options = ["-q", "-p", "no:cacheprovider", "-p", "no:xdist", "--tb=no"]
        pytest.main([*options, f"--basetemp={folder / 'tests'}", session.file], plugins=[session])
        shutil.rmtree(folder / "tests", ignore_errors=True)


@dataclass
class _Session:
    """Goes through the tests of a file in its own way; a plugin of pytest."""

    warm: Warm
    file: str
    folder: Path
    numbers: Sequence[int] = ()
    only: Sequence[str] = ()
    failed: bool = False
    bounded: bool = False
    items: dict[str, pytest.Item] = field(default_factory=dict)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.failed |= report.failed

    def pytest_runtest_setup(self) -> None:
        self._bound(_SETUP)

    def pytest_runtest_call(self) -> None:
        self._bound(_CALL)

    def pytest_runtest_teardown(self) -> None:
        self._bound(0.0)

    def _bound(self, seconds: float) -> None:
        if self.bounded:
            signal.setitimer(signal.ITIMER_PROF, seconds)

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        if session.testsfailed:
            return True
        self.items = {item.nodeid: item for item in session.items}
        if self.only:
            self._until_one_fails(self.only)
            return True
        places = self.warm.places
        files = {str(self.warm.root / change.file) for change in self.warm.drawn.values()}
        loaded = Loaded(files | {str(self.warm.root / file) for file in places.rows})
        loaded.look()
        gc.freeze()
        _fork(lambda: self._first(loaded), 3600.0)
        seconds, reached = _read(self.folder / "first.json") or ({}, {})
        found = {}
        for number in self.numbers:
            names = self._chosen(number, reached.get(str(number), []), seconds)
            if names:
                by = self._tried(number, names, loaded)
                found[number] = {"names": names, "by": by}
        self._leave_out(found)
        _write(self.folder / "found.json", found)
        return True

    def _first(self, loaded: Loaded) -> None:
        """Run the tests and note what each takes and which changes it reaches."""
        now: set[int] = set()
        setattr(builtins, CALLED, now.add)
        loaded.replace(self.warm.places.code(self.warm.root))
        signal.signal(signal.SIGPROF, _cut)
        self.bounded = True
        seconds: dict[str, float] = {}
        cases: dict[str, float] = defaultdict(float)
        reached: dict[int, list[str]] = defaultdict(list)
        items = [item for item in self.items.values() if not _TIMED.search(item.nodeid)]
        following = {one.nodeid: other for one, other in pairwise(items)}
        begun = _spent()
        for item in items:
            name = item.nodeid.partition("[")[0]
            if cases[name] > _CASES or _spent() - begun > _FILE:
                continue
            now.clear()
            start = _spent()
            if not self._fails(item, following.get(item.nodeid)):
                seconds[item.nodeid] = _spent() - start
                for number in now:
                    reached[number].append(item.nodeid)
            cases[name] += _spent() - start
        _write(self.folder / "first.json", (seconds, reached))

    def _chosen(self, number: int, names: list[str], seconds: dict[str, float]) -> list[str]:
        chosen: list[str] = []
        spent = 0.0
        for name in sorted(names, key=lambda one: (seconds[one], one)):
            spent += seconds[name]
            if chosen and spent > self.warm.allowance(number, self.file):
                break
            chosen.append(name)
        return chosen

    def _tried(self, number: int, names: list[str], loaded: Loaded) -> str | None:
        """The test that notices a change, "" for none; None where it must be loaded anew."""
        if number in self.warm.places.on_import:
            return None

        def one() -> None:
            if loaded.replace(self.warm.changed(number)):
                self._until_one_fails(names)
            else:
                _write(self.folder / "tried.json", None)

        ended = _fork(one, 10 * _ENDLESS)
        path = self.folder / "tried.json"
        if not path.exists():
            return f"tests that never end, {names[0]} first" if ended else ""
        by = _read(path)
        path.unlink()
        return None if by is None else str(by)

    def _leave_out(self, found: dict[int, dict[str, Any]]) -> None:
        """Take no notice of tests that fail alone as it is."""
        noticed = sorted({one["by"] for one in found.values()} & set(self.items))

        def alone() -> None:
            failing = [each for each in noticed if self._fails(self.items[each])]
            _write(self.folder / "alone.json", failing)

        if noticed:
            _fork(alone, 3600.0)
            failing = _read(self.folder / "alone.json")
            for one in found.values():
                if failing is None or one["by"] in failing:
                    one["by"] = ""

    def _until_one_fails(self, names: Sequence[str]) -> None:
        most = int(_spent() + _ENDLESS)
        resource.setrlimit(resource.RLIMIT_CPU, (most, most + 2))
        by = next((name for name in names if self._fails(self.items[name])), "")
        _write(self.folder / "tried.json", by)

    def _fails(self, item: pytest.Item, following: pytest.Item | None = None) -> bool:
        """Run a test; what the following one shares with it is kept."""
        self.failed = False
        item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        return self.failed


def _cut(*_: object) -> NoReturn:
    raise _Cut


def _spent() -> float:
    return sum(os.times()[:4])


def _fork(work: Callable[[], None], seconds: float) -> int:
    """Do something in a fork, end it when its time is up; how it ended, 0 for well."""
    child = os.fork()
    if child == 0:
        try:
            os.setpgid(0, 0)
            work()
        finally:
            os._exit(0)
    last = time.monotonic() + seconds
    while True:
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            return status
        if time.monotonic() > last:
            os.killpg(child, signal.SIGKILL)
            return os.waitpid(child, 0)[1]
        time.sleep(0.02)


def _write(path: Path, what: Any) -> None:
    path.write_text(json.dumps(what), encoding="utf-8")


def _read(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None
