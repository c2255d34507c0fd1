"""Which test runs which line: a map for `mutations.py`, made by running all tests once."""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from mutation_places import Mutation

ROOT = Path(__file__).resolve().parents[1]
KEPT = ROOT / "build" / "mutations"
FOLDERS = ("solver", "freecad_ortho/fabrication", "freecad_ortho/sources", "freecad_ortho/cli")
# These start whole systems; what they run is tested more closely elsewhere.
LEFT_OUT = ("tests/freecad", "tests/scripts")
# Seconds of tests for one change; the quickest are taken first.
ALLOWANCE = 120.0
# As many threads as processors in each test would measure how busy the machine is.
ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


@dataclass(frozen=True)
class Coverage:
    """Which tests run which line.

    Attributes:
        lines: file -> line -> tests, by their pytest names; of what a fixture ran, test files.
        seconds: how long each test took.
    """

    lines: dict[str, dict[int, list[str]]]
    seconds: dict[str, float]

    def tests(self, mutation: Mutation) -> list[str]:
        """List the tests of the changed lines, the quickest first, within the allowance."""
        named = {
            name
            for file, lines in self._places(mutation)
            for line in lines
            for name in self.lines.get(file, {}).get(line, [])
        }
        if not named and any(line in self.lines.get(mutation.file, {}) for line in mutation.lines):
            # A function that only runs on import makes what the whole file works with.
            named = {name for names in self.lines[mutation.file].values() for name in names}
        found = {test for name in named for test in self._tests_named(name)}
        chosen: list[str] = []
        spent = 0.0
        for test in sorted(found, key=lambda one: (self.seconds[one], one)):
            spent += self.seconds[test]
            if chosen and spent > ALLOWANCE:
                break
            chosen.append(test)
        # A file at a time: what its tests share is made once.
        of_file: dict[str, float] = defaultdict(float)
        for test in chosen:
            of_file[test.split("::")[0]] += self.seconds[test]
        return sorted(chosen, key=lambda one: (of_file[one.split("::")[0]], one.split("::")[0]))

    def _places(self, mutation: Mutation) -> Iterator[tuple[str, Iterable[int]]]:
        """Yield the lines of files where a change shows.

        What runs on import is run by whichever test comes first. It shows in its file, and
        wherever the name stands that it gives a value to.
        """
        source = (ROOT / mutation.file).read_text(encoding="utf-8")
        names, lines = read_at(source, mutation.lines.start)
        yield mutation.file, mutation.lines if lines is None else lines
        if names:
            word = re.compile(rf"\b({'|'.join(names)})\b")
            for file in self.lines:
                rows = (ROOT / file).read_text(encoding="utf-8").splitlines()
                yield file, [row for row, text in enumerate(rows, 1) if word.search(text)]

    def _tests_named(self, name: str) -> list[str]:
        if name in self.seconds:
            return [name]
        return [test for test in self.seconds if test.startswith(f"{name}::")]


def read_at(source: str, line: int) -> tuple[list[str], range | None]:
    """Tell where it shows what a line gives on import.

    Returns:
        the names that the line gives a value to, if it runs on import, and the lines in this file
        that run later: those of the function of which it is the head, or all; None where the
        line itself runs later.
    """
    names: list[str] = []
    body = ast.parse(source).body
    while True:
        around = next((one for one in body if _begin(one) <= line <= (one.end_lineno or 0)), None)
        if around is None:
            return names, range(1, source.count("\n") + 2)
        if isinstance(around, (ast.FunctionDef, ast.AsyncFunctionDef)):
            if line >= around.body[0].lineno:
                return [], None
            return [], range(around.body[0].lineno, (around.end_lineno or 0) + 1)
        names = names or _names_of(around)
        body = around.body if isinstance(around, (ast.ClassDef, ast.If)) else []


def _begin(node: ast.stmt) -> int:
    return min([node.lineno, *(one.lineno for one in getattr(node, "decorator_list", []))])


def _names_of(node: ast.stmt) -> list[str]:
    """List the names that a statement at the top of a file gives a value to."""
    if isinstance(node, ast.ClassDef):
        return [node.name]
    targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
    inner = (one for target in targets if target for one in ast.walk(target))
    return [one.id for one in inner if isinstance(one, ast.Name)]


def copy_of_tree(folder: Path) -> Path:
    """Copy what git tracks into a folder, with the environment and ../shared beside it."""
    target = folder / "tree"
    names = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout.split("\0")
    for name in filter(None, names):
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / name, target / name)
    (target / ".venv").symlink_to((ROOT / ".venv").resolve())
    if (shared := ROOT.parent / "shared").is_dir():
        (folder / "shared").symlink_to(shared)
    return target


# Loaded by pytest, and by each of the processes that it shares tests out to: measures which lines
# each test runs, and writes that down beside how much of a processor it took, which is the same on
# a busy machine, and which tests fail as it is.
_PLUGIN = """
import json
import os
from pathlib import Path

import coverage
import pytest

HERE = Path(__file__).resolve().parent
WORKER = os.environ.get("PYTEST_XDIST_WORKER")
measured = coverage.Coverage(
    data_file=str(HERE / f"map.coverage.{WORKER}"),
    source=[str(HERE / folder) for folder in os.environ["MUTATED_FOLDERS"].split(",")],
)
if WORKER:
    measured.start()
seconds, failed = {}, set()

def switch(name):
    if WORKER:
        measured.switch_context(name)

@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    switch(item.nodeid.split("::")[0])

@pytest.hookimpl(tryfirst=True)
def pytest_runtest_call(item):
    switch(item.nodeid.split("[")[0])

@pytest.hookimpl(tryfirst=True)
def pytest_runtest_teardown(item):
    switch("")

@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_protocol(item):
    name, start = item.nodeid.split("[")[0], sum(os.times()[:4])
    yield
    seconds[name] = seconds.get(name, 0.0) + sum(os.times()[:4]) - start

def pytest_runtest_logreport(report):
    if report.failed:
        failed.add(report.nodeid.split("[")[0])

def pytest_sessionfinish():
    if WORKER:
        measured.stop()
        measured.save()
        text = json.dumps({"seconds": seconds, "failed": sorted(failed)})
        (HERE / f"tests.{WORKER}.json").write_text(text)
"""


def make_map(tests: Sequence[str], workers: int = 2) -> None:
    """Run tests once under coverage and keep which ran what.

    Args:
        tests: files of tests, added to the map that was kept; none: all, for a new map.
        workers: how many run at once.
    """
    known = read_map() if tests else Coverage({}, {})
    with tempfile.TemporaryDirectory() as name:
        tree = copy_of_tree(Path(name))
        (tree / "mutation_plugin.py").write_text(_PLUGIN)
        command = [sys.executable, "-m", "pytest", "-q", "-p", "mutation_plugin"]
        command += [*(tests or ["tests"]), "-n", str(workers), "--dist", "loadfile"]
        command += [f"--ignore={folder}" for folder in LEFT_OUT]
        environment = {
            **os.environ,
            **ONE_THREAD,
            "PYTHONPATH": str(tree),
            "MUTATED_FOLDERS": ",".join(FOLDERS),
        }
        subprocess.run(command, cwd=tree, env=environment, check=False)
        lines = _lines(tree, known)
        seconds, failed = dict(known.seconds), set()
        for path in tree.glob("tests.*.json"):
            kept = json.loads(path.read_text())
            seconds |= kept["seconds"]
            failed.update(kept["failed"])
    # A test that fails as it is would notice any change.
    for test in sorted(failed):
        print(f"fails without a change, not asked: {test}")
    seconds = {test: spent for test, spent in seconds.items() if test not in failed}
    KEPT.mkdir(parents=True, exist_ok=True)
    (KEPT / "map.json").write_text(json.dumps({"lines": lines, "seconds": seconds}))


def _lines(tree: Path, known: Coverage) -> dict[str, dict[int, list[str]]]:
    """Add what was measured in a tree to what is known: file, line, tests."""
    import coverage

    lines: dict[str, dict[int, set[str]]] = defaultdict(lambda: defaultdict(set))
    for file, of_file in known.lines.items():
        for line, names in of_file.items():
            lines[file][line].update(names)
    for path in tree.glob("map.coverage.*"):
        data = coverage.CoverageData(str(path))
        data.read()
        for measured in data.measured_files():
            contexts = data.contexts_by_lineno(measured)
            for line, names in contexts.items():
                file = Path(measured).relative_to(tree).as_posix()
                lines[file][line].update(filter(None, names))
    return {
        file: {line: sorted(names) for line, names in of_file.items()}
        for file, of_file in lines.items()
    }


def read_map() -> Coverage:
    """Read the map that was kept."""
    kept = json.loads((KEPT / "map.json").read_text())
    lines = {
        file: {int(line): tests for line, tests in of_file.items()}
        for file, of_file in kept["lines"].items()
    }
    return Coverage(lines, kept["seconds"])
