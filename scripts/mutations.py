"""Do the tests notice small mistakes? Changes the code in one place at a time.

usage: python scripts/mutations.py                 200 random changes, half an hour or more
       python scripts/mutations.py --count 40 --seed 7 --only solver/io
       python scripts/mutations.py --map-only      only work out which test runs which line

A change turns round a comparison, swaps + and -, * and /, and / or, drops a minus, a "not" or a
statement, or alters a number (`mutation_places.py`). It is made in a copy of the tree, where the
tests that run the changed line are run until one fails. What no test notices is printed at the end;
exit code 1 where that is more than a tenth. Needs the package coverage; its map of lines and tests
is kept in build/mutations and made anew with --map.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from queue import Queue

from mutation_places import Mutation, mutations_of

ROOT = Path(__file__).resolve().parents[1]
KEPT = ROOT / "build" / "mutations"
FOLDERS = ("solver", "freecad_ortho/fabrication", "freecad_ortho/sources", "freecad_ortho/cli")
# These start whole systems; what they run is tested more closely elsewhere.
LEFT_OUT = ("tests/freecad", "tests/scripts")
# Seconds of tests for one change; the quickest are taken first.
ALLOWANCE = 120.0
WANTED = 0.9


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
        of_file = self.lines.get(mutation.file, {})
        named = {name for line in mutation.lines for name in of_file.get(line, [])}
        # What runs on import has no test of its own: all that use the module may notice it.
        named = named or {name for tests in of_file.values() for name in tests}
        found = {test for name in named for test in self._tests_named(name)}
        chosen, spent = [], 0.0
        for test in sorted(found, key=lambda one: (self.seconds[one], one)):
            spent += self.seconds[test]
            if chosen and spent > ALLOWANCE:
                break
            chosen.append(test)
        return chosen

    def _tests_named(self, name: str) -> list[str]:
        if name in self.seconds:
            return [name]
        return [test for test in self.seconds if test.startswith(f"{name}::")]


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


def run_tests(tree: Path, arguments: Sequence[str], limit: float | None) -> tuple[bool, str]:
    """Run pytest in a tree; return whether all passed in time, and what it printed."""
    # A file written twice within a second must not be taken from the cache of its bytecode.
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "OMP_NUM_THREADS": "1"}
    command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", *arguments]
    with tempfile.TemporaryFile("w+") as output:
        try:
            done = subprocess.run(
                command,
                cwd=tree,
                env=environment,
                timeout=limit,
                stdout=output,
                stderr=subprocess.STDOUT,
                stdin=subprocess.DEVNULL,
            )
        except subprocess.TimeoutExpired:
            return False, "took too long"
        output.seek(0)
        return done.returncode == 0, output.read()


# Loaded by pytest, and by each of the processes that it shares tests out to: measures which lines
# each test runs, and writes that down beside how long it took.
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
seconds = {}

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

def pytest_runtest_logreport(report):
    name = report.nodeid.split("[")[0]
    seconds[name] = seconds.get(name, 0.0) + report.duration

def pytest_sessionfinish():
    if WORKER:
        measured.stop()
        measured.save()
        (HERE / f"seconds.{WORKER}.json").write_text(json.dumps(seconds))
"""


def make_map(tests: Sequence[str], workers: int = 2) -> None:
    """Run all tests once under coverage and keep which ran what."""
    import coverage

    with tempfile.TemporaryDirectory() as name:
        tree = copy_of_tree(Path(name))
        (tree / "mutation_plugin.py").write_text(_PLUGIN)
        command = [sys.executable, "-m", "pytest", "-q", "-p", "mutation_plugin", *tests]
        command += ["-n", str(workers), "--dist", "loadfile"]
        command += [f"--ignore={folder}" for folder in LEFT_OUT]
        environment = {
            **os.environ,
            "OMP_NUM_THREADS": "1",
            "PYTHONPATH": str(tree),
            "MUTATED_FOLDERS": ",".join(FOLDERS),
        }
        subprocess.run(command, cwd=tree, env=environment, check=False)
        lines: dict[str, dict[int, set[str]]] = defaultdict(lambda: defaultdict(set))
        for path in tree.glob("map.coverage.*"):
            data = coverage.CoverageData(str(path))
            data.read()
            for file in data.measured_files():
                of_file = lines[str(Path(file).relative_to(tree))]
                for line, contexts in data.contexts_by_lineno(file).items():
                    of_file[line].update(filter(None, contexts))
        seconds: dict[str, float] = {}
        for path in tree.glob("seconds.*.json"):
            seconds |= json.loads(path.read_text())
    KEPT.mkdir(parents=True, exist_ok=True)
    sorted_lines = {
        file: {line: sorted(names) for line, names in of_file.items()}
        for file, of_file in lines.items()
    }
    (KEPT / "map.json").write_text(json.dumps({"lines": sorted_lines, "seconds": seconds}))


def read_map() -> Coverage:
    """Read the map that was kept."""
    kept = json.loads((KEPT / "map.json").read_text())
    lines = {
        file: {int(line): tests for line, tests in of_file.items()}
        for file, of_file in kept["lines"].items()
    }
    return Coverage(lines, kept["seconds"])


def all_mutations(only: str) -> list[Mutation]:
    """List every change that could be made, in an order of its own."""
    found = []
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.py")):
            name = path.relative_to(ROOT).as_posix()
            if name.startswith(only):
                found += mutations_of(name, path.read_text(encoding="utf-8"))
    return found


def noticed(mutation: Mutation, tree: Path, tests: list[str], seconds: float) -> bool:
    """Make a change in a tree, run its tests there, undo it."""
    path = tree / mutation.file
    whole = path.read_text(encoding="utf-8")
    path.write_text(mutation.applied(whole), encoding="utf-8")
    try:
        passed, _ = run_tests(tree, tests, 30.0 + 4.0 * seconds)
    finally:
        path.write_text(whole, encoding="utf-8")
    return not passed


def try_all(chosen: list[Mutation], known: Coverage, workers: int) -> list[Mutation]:
    """Try the changes and return those that no test noticed."""
    survivors: dict[int, Mutation] = {}
    with tempfile.TemporaryDirectory() as name:
        trees: Queue[Path] = Queue()
        for number in range(workers):
            trees.put(copy_of_tree(Path(name) / str(number)))

        def attempt(number: int) -> None:
            mutation, tree, start = chosen[number], trees.get(), time.perf_counter()
            tests = known.tests(mutation)
            try:
                seconds = sum(known.seconds[test] for test in tests)
                found = bool(tests) and noticed(mutation, tree, tests, seconds)
            finally:
                trees.put(tree)
            if not found:
                survivors[number] = mutation
            words = "noticed" if found else f"NOT noticed by {len(tests)} tests"
            spent = time.perf_counter() - start
            print(f"{number + 1:4d} {mutation}: {words} ({spent:.0f} s)", flush=True)

        with ThreadPoolExecutor(workers) as pool:
            list(pool.map(attempt, range(len(chosen))))
    return [survivors[number] for number in sorted(survivors)]


def main() -> int:
    """Read the command line, try the changes, print what survived."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="files whose path begins like this")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--map", action="store_true", help="make the map of lines and tests anew")
    parser.add_argument("--map-only", action="store_true", help="... and stop there")
    given = parser.parse_args()
    if given.map or given.map_only or not (KEPT / "map.json").exists():
        make_map(["tests"], given.workers)
    if given.map_only:
        return 0
    possible = all_mutations(given.only)
    count = min(given.count, len(possible))
    chosen = random.Random(given.seed).sample(possible, count)
    print(f"{count} of {len(possible)} possible changes")
    survivors = try_all(chosen, read_map(), given.workers)
    by_file = defaultdict(list)
    for mutation in survivors:
        by_file[mutation.file].append(mutation)
    print(f"noticed {count - len(survivors)} of {count}; not noticed:")
    for file in sorted(by_file):
        for mutation in by_file[file]:
            print(f"  {mutation}")
    return 0 if len(survivors) <= (1 - WANTED) * count else 1


if __name__ == "__main__":
    raise SystemExit(main())
