"""Kills runs of the command line at random moments and looks at what they leave.

usage: python scripts/kill_runs.py [--runs 30] [--seed 0] [--workers N]

Every run writes over the files of an earlier one. It is killed (kill -9), or asked to end (SIGTERM,
Ctrl-C); then the folder has to hold the old files or the new ones, all of them, beside a file that
is nobody's. After kill -9 the sweep that every run begins with may come in between. Exit code 1
where a folder does not, or where being asked to end takes longer than two seconds (on a busy
machine: a second longer than what the work is given).
"""

from __future__ import annotations

import argparse
import hashlib
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from freecad_ortho import api
from freecad_ortho.cli import supervising
from solver.io import leftovers
from tests.conftest import ROOT, wavy_grid

VERBS = {
    "fabricate": ["--system", "beams+nodes", "-o", "{out}"],
    "optimise": ["-o", "{out}/net.obj", "--report", "{out}/net.json"],
}
SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)


def held(folder: Path) -> dict[str, str]:
    """Digests of the files of a folder; of those that no two runs write alike, only the names."""
    return {
        path.relative_to(folder).as_posix(): ""
        if path.suffix in (".dxf", ".html", ".json", ".step")
        else hashlib.sha256(path.read_bytes()).hexdigest()
        for path in folder.rglob("*")
        if path.is_file()
    }


def command(verb: str, mesh: Path, out: Path, more: list[str]) -> list[str]:
    """The words that start a run."""
    words = [word.format(out=out) for word in VERBS[verb]]
    return [sys.executable, "-m", "freecad_ortho", verb, str(mesh), *words, *more]


def deaf_no_more() -> None:
    """A shell that starts this in the background makes all its children deaf to Ctrl-C."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


def broken_off(words: list[str], seconds: float, sent: int) -> float:
    """Start a run and break it off after so many seconds; seconds that it took to end."""
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    run = subprocess.Popen(
        words,
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        preexec_fn=deaf_no_more,
    )
    try:
        run.wait(seconds)
    except subprocess.TimeoutExpired:
        begin = time.monotonic()
        run.send_signal(sent)
        run.wait()
        return time.monotonic() - begin
    return 0.0


def settled(folder: Path) -> dict[str, str]:
    """What a folder holds once the work of a killed run has noticed, and has been swept."""
    latest = time.monotonic() + 60.0
    while True:
        leftovers.sweep(folder)
        for name in ("net.obj", "net.json"):
            leftovers.sweep(folder / name)
        if not list(folder.glob(".*")) or time.monotonic() > latest:
            return held(folder)
        time.sleep(0.2)


def main() -> int:
    """Kill as many runs as were asked for; say how each ended."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=30)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--workers", type=int, default=1)
    options = parser.parse_args()
    chance, wrong, slowest = random.Random(options.seed), 0, 0.0
    with tempfile.TemporaryDirectory() as name:
        home = Path(name)
        mesh = home / "mesh.obj"
        api.write_mesh(mesh, wavy_grid(9, 8, height=0.05).scaled(1000.0), "mm")
        ends, lasts = {}, {}
        for verb in VERBS:
            more = [["--height", "150"], ["--height", "120"]] if verb == "fabricate" else [[], []]
            more[1] += ["--workers", str(options.workers)] if verb == "fabricate" else []
            folder = home / f"{verb}-old"
            folder.mkdir()
            (folder / "mine.txt").write_text("mine")
            begin = time.monotonic()
            subprocess.run(command(verb, mesh, folder, more[0]), cwd=ROOT, check=False)
            lasts[verb] = time.monotonic() - begin
            new = home / f"{verb}-new"
            shutil.copytree(folder, new)
            subprocess.run(command(verb, mesh, new, more[1]), cwd=ROOT, check=False)
            ends[verb] = (held(folder), held(new), more[1])
        for number in range(options.runs):
            verb, sent = chance.choice(list(VERBS)), chance.choice(SIGNALS)
            seconds = chance.uniform(0.2, 1.1 * lasts[verb])
            old, new, more = ends[verb]
            folder = home / f"run-{number}"
            shutil.copytree(home / f"{verb}-old", folder)
            took = broken_off(command(verb, mesh, folder, more), seconds, sent)
            found = settled(folder) if sent == signal.SIGKILL else held(folder)
            # An optimisation that was asked to end writes what it has reached.
            whole = found in (old, new) or (verb == "optimise" and set(found) == set(old))
            slowest = max(slowest, took)
            wrong += not whole or took > supervising.grace() + 1.0
            print(
                f"{number:3d} {verb:9s} {signal.Signals(sent).name:7s} after {seconds:5.2f} s, "
                f"ended in {took:4.2f} s: {'old' if found == old else 'new' if whole else found}",
                flush=True,
            )
    print(f"{options.runs} runs, {wrong} wrong, the slowest ended in {slowest:.2f} s")
    return int(wrong > 0)


if __name__ == "__main__":
    sys.exit(main())
