"""Do the tests notice small mistakes? Changes the code in one place at a time.

usage: python scripts/mutations.py                 200 random changes, half an hour or more
       python scripts/mutations.py --quick         without a map, many changes at a time; say again
                                                   to go on where it was broken off
       python scripts/mutations.py --count 40 --seed 7 --only solver/io
       python scripts/mutations.py --map-only      only work out which test runs which line
       python scripts/mutations.py --map-more tests/test_units.py     add a file's tests to that
       python scripts/mutations.py --again 3,17    these of the 200 changes once more

A change turns round a comparison, swaps + and -, * and /, and / or, drops a minus, a "not" or a
statement, or alters a number (`mutation_places.py`). It is made in a copy of the tree, where the
tests that run the changed line are run until one fails. What no test notices is printed at the end;
exit code 1 where that is more than a tenth. Needs the package coverage; its map of lines and tests
is kept in build/mutations and made anew with --map. The quick pass (`mutation_forks.py`) needs
neither, asks no test that starts a program or takes long, and names what is left for --again.
"""

from __future__ import annotations

import argparse
import compileall
import os
import random
import re
import signal
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

from mutation_map import FOLDERS, KEPT, ONE_THREAD, ROOT, Coverage, copy_of_tree, make_map, read_map
from mutation_places import Mutation, mutations_of
from mutation_record import Record, try_quickly

WANTED = 0.9


def prepared(folder: Path) -> Path:
    """Copy the tree and write the bytecode of all its files, which saves a second a change."""
    tree = copy_of_tree(folder)
    compileall.compile_dir(tree, quiet=1, maxlevels=20)
    return tree


@dataclass(frozen=True)
class Tried:
    """What the tests said of a tree.

    Attributes:
        failed: the test that failed first, or what pytest could not even load.
        passed: whether all passed.
        endless: whether they were broken off. That is no notice: a machine may be busy.
    """

    failed: str = ""
    passed: bool = False
    endless: bool = False


def run_tests(tree: Path, tests: Sequence[str], seconds: float) -> Tried:
    """Run tests in a tree, for no longer than some seconds of a processor, until one fails."""
    # Bytecode was written once (`prepared`), a changed file has none: written twice within a
    # second it would be taken for the one before.
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", **ONE_THREAD}
    command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider"]
    command += ["--tb=no", "-rfE", "--no-header", *tests]
    with tempfile.TemporaryFile("w+") as output:
        running = subprocess.Popen(
            command,
            cwd=tree,
            env=environment,
            stdout=output,
            stderr=subprocess.STDOUT,
            stdin=subprocess.DEVNULL,
            process_group=0,
        )
        endless = not _ends(running, seconds)
        output.seek(0)
        printed = output.read()
    failed = re.search(r"^(?:FAILED|ERROR) (\S+?)(?:\[| |$)", printed, re.MULTILINE)
    return Tried(
        failed=failed[1] if failed else printed.strip().rpartition("\n")[2],
        passed=running.returncode == 0,
        endless=endless,
    )


def _ends(running: subprocess.Popen[bytes], seconds: float) -> bool:
    """Wait for a process; end it and all that it started when its time is up."""
    # One that waits for nothing takes no time of a processor.
    last = time.monotonic() + 120.0 + 20.0 * seconds
    while True:
        try:
            running.wait(0.5)
            return True
        except subprocess.TimeoutExpired:
            if time.monotonic() < last and _processor_seconds(running.pid) < seconds:
                continue
        os.killpg(running.pid, signal.SIGKILL)
        running.wait()
        return False


def _processor_seconds(group: int) -> float:
    """Add up what the processes of a group, and those they waited for, used of a processor."""
    ticks = 0
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            # The name of a program, in brackets, may hold blanks.
            fields = path.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(fields[2]) == group:
            ticks += sum(map(int, fields[11:15]))
    return ticks / os.sysconf("SC_CLK_TCK")


def all_mutations(only: str) -> list[Mutation]:
    """List every change that could be made, in an order of its own."""
    found = []
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.py")):
            name = path.relative_to(ROOT).as_posix()
            if name.startswith(only):
                found += mutations_of(name, path.read_text(encoding="utf-8"))
    return found


def tried(mutation: Mutation, tree: Path, tests: list[str], seconds: float) -> Tried:
    """Make a change in a tree, run its tests there, undo it."""
    path = tree / mutation.file
    whole = path.read_text(encoding="utf-8")
    for old in (path.parent / "__pycache__").glob(f"{path.stem}.*"):
        old.unlink()
    path.write_text(mutation.applied(whole), encoding="utf-8")
    try:
        return run_tests(tree, tests, 60.0 + 4.0 * seconds)
    finally:
        path.write_text(whole, encoding="utf-8")


class Trial:
    """Tries changes and keeps which were not noticed.

    Attributes:
        survivors: changes that no test noticed, by their numbers.
        known: which tests run what.
    """

    def __init__(self, known: Coverage) -> None:
        self.known = known
        self.survivors: dict[int, Mutation] = {}
        # Whether a test that failed with a change passes without one.
        self._sound: dict[str, bool] = {}

    def attempt(self, number: int, mutation: Mutation, tree: Path) -> None:
        """Try one change and print what came of it."""
        start = time.perf_counter()
        words = self._words(mutation, tree)
        if not words.startswith("noticed"):
            self.survivors[number] = mutation
        spent = time.perf_counter() - start
        print(f"{number + 1:4d} {mutation}: {words} ({spent:.0f} s)", flush=True)

    def _words(self, mutation: Mutation, tree: Path) -> str:
        tests = self.known.tests(mutation)
        while tests:
            seconds = sum(self.known.seconds[test] for test in tests)
            found = tried(mutation, tree, tests, seconds)
            if found.passed:
                break
            if found.endless:
                return "NOT noticed, its tests did not end"
            if found.failed not in tests:
                # Not even loaded: the unchanged tree was, for the map.
                return f"noticed, {found.failed}"
            if self._is_sound(found.failed, tree):
                return f"noticed by {found.failed}"
            tests.remove(found.failed)
        return f"NOT noticed by {len(tests)} tests"

    def _is_sound(self, test: str, tree: Path) -> bool:
        if test not in self._sound:
            done = run_tests(tree, [test], 60.0 + 4.0 * self.known.seconds[test])
            self._sound[test] = done.passed
            if not done.passed:
                print(f"fails now without a change, not asked: {test}", flush=True)
        return self._sound[test]


def try_all(chosen: list[tuple[int, Mutation]], known: Coverage, workers: int) -> list[Mutation]:
    """Try the changes and return those that no test noticed."""
    trial = Trial(known)
    with tempfile.TemporaryDirectory() as name:
        trees: Queue[Path] = Queue()
        for number in range(workers):
            trees.put(prepared(Path(name) / str(number)))

        def attempt(numbered: tuple[int, Mutation]) -> None:
            tree = trees.get()
            try:
                trial.attempt(*numbered, tree)
            finally:
                trees.put(tree)

        with ThreadPoolExecutor(workers) as pool:
            list(pool.map(attempt, chosen))
    return [trial.survivors[number] for number in sorted(trial.survivors)]


def main() -> int:
    """Read the command line, try the changes, print what survived."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="files whose path begins like this")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--map", action="store_true", help="make the map of lines and tests anew")
    parser.add_argument("--map-only", action="store_true", help="... and stop there")
    parser.add_argument("--map-more", nargs="+", help="measure these tests, add them to the map")
    parser.add_argument("--again", default="", help="numbers of one draw to try again: 3,17,40")
    parser.add_argument("--quick", action="store_true", help="without a map, in forks")
    parser.add_argument("--table", action="store_true", help="what came of that, as a table")
    given = parser.parse_args()
    if given.quick or given.table:
        return quick_pass(given)
    if given.map or given.map_only or not (KEPT / "map.json").exists():
        make_map([], given.workers)
    if given.map_more:
        make_map(given.map_more, given.workers)
    if given.map_only or given.map_more:
        return 0
    drawn = draw(given)
    again = {int(number) for number in given.again.split(",") if number}
    chosen = [one for one in enumerate(drawn) if not again or one[0] + 1 in again]
    return verdict(len(chosen), try_all(chosen, read_map(), given.workers))


def draw(given: argparse.Namespace) -> list[Mutation]:
    """Draw the changes that were asked for."""
    possible = all_mutations(given.only)
    count = min(given.count, len(possible))
    print(f"{count} of {len(possible)} possible changes", flush=True)
    return random.Random(given.seed).sample(possible, count)


def quick_pass(given: argparse.Namespace) -> int:
    """Try the changes in forks, or show what came of that."""
    drawn, path = draw(given), KEPT / f"quick-{given.seed}.json"
    if given.table:
        print(Record.of(path, drawn).table())
        return 0
    survivors = try_quickly(drawn, path)
    print(f"with all of their tests: --again {','.join(map(str, survivors))}")
    return verdict(len(drawn), list(survivors.values()))


def verdict(count: int, survivors: list[Mutation]) -> int:
    """Print what no test noticed; 1 where that is too much."""
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
