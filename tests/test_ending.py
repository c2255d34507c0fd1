"""How runs end that are killed from outside, in each of the two processes of a command."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from types import SimpleNamespace

import pytest

from freecad_ortho import api
from freecad_ortho.__main__ import main
from freecad_ortho.cli import endings, supervising
from solver.io import leftovers
from tests.conftest import ROOT, wavy_grid

pytestmark = pytest.mark.skipif(
    not os.path.isdir("/proc/self/task"), reason="looks up processes in /proc"
)
DEAF = (
    "import signal, time; signal.signal(15, signal.SIG_IGN); print(1, flush=True); time.sleep(99)"
)


def children(process: int) -> list[int]:
    try:
        return [
            int(w) for w in Path(f"/proc/{process}/task/{process}/children").read_text().split()
        ]
    except OSError:
        return []


def waited_for(what, seconds=150.0):
    latest = time.monotonic() + seconds
    while not (found := what()):
        assert time.monotonic() < latest
        time.sleep(0.05)
    return found


@pytest.fixture
def fabrication(tmp_path):
    """A run that is writing its files, the process of its work, and the folder."""
    mesh, out = tmp_path / "grid.obj", tmp_path / "new" / "out"
    api.write_mesh(mesh, wavy_grid(18, 18, height=0.0).scaled(1000.0), "mm")
    run = subprocess.Popen(
        [sys.executable, "-m", "freecad_ortho", "fabricate", str(mesh), "-o", str(out)],
        cwd=ROOT,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        waited_for(lambda: list(out.glob(".staging-*/new")) or run.poll() is not None)
        (work,) = children(run.pid)
        yield run, work, out
    finally:
        run.kill()
        run.wait()


def test_ctrl_c_and_being_asked_to_end_at_once_is_one_ending():
    code = (
        "import os, signal\n"
        "from freecad_ortho.cli.endings import end_once, held_back, let_through\n"
        "end_once()\n"
        "held_back()\n"
        "os.kill(os.getpid(), signal.SIGTERM)\n"
        "os.kill(os.getpid(), signal.SIGINT)\n"
        "try:\n"
        "    let_through()\n"
        "except KeyboardInterrupt:\n"
        "    print('ended')\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "ended\n", "")


def test_what_is_kept_whole_ends_after_it_and_threads_go_on():
    through = []
    # Whoever runs the tests in the background has Ctrl-C ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt), endings.kept_whole():
            os.kill(os.getpid(), signal.SIGINT)
            through.append("block")
    finally:
        signal.signal(signal.SIGINT, before)

    def load():
        with endings.kept_whole():
            through.append("thread")

    # Only the main thread may say what a signal does.
    thread = threading.Thread(target=load)
    thread.start()
    thread.join()
    assert through == ["block", "thread"]


def test_work_that_does_not_end_is_ended():
    work = subprocess.Popen([sys.executable, "-c", DEAF], stdout=subprocess.PIPE)
    work.stdout.readline()
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    begin = time.monotonic()
    try:
        assert not supervising.ended(work)
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    assert 0.9 < time.monotonic() - begin < supervising.grace() + 3.0
    assert work.poll() == -signal.SIGKILL


@pytest.mark.parametrize(("load", "seconds"), [(0.0, 1.0), (4.0, 1.0), (8.0, 1.5), (100.0, 4.0)])
def test_the_more_processes_share_a_core_the_longer_work_may_take_to_end(
    load, seconds, monkeypatch
):
    monkeypatch.setattr(os, "getloadavg", lambda: (load, load, load))
    monkeypatch.setattr(os, "cpu_count", lambda: 4)
    assert supervising.grace() == seconds


def test_work_that_is_killed_is_said_and_leaves_nothing(fabrication):
    run, work, out = fabrication
    os.kill(work, signal.SIGKILL)
    said = run.communicate(timeout=60)[1]
    assert run.returncode == 2
    assert said == "error: killed by signal 9; is there enough memory?\n"
    # The folders that it had made have gone as well.
    assert not out.parent.exists()


def test_what_killed_work_left_in_a_folder_that_was_there_is_swept(tmp_path, monkeypatch):
    staging = tmp_path / f"{leftovers.STAGING}a1b2c3d4"
    (staging / leftovers.NEW).mkdir(parents=True)
    (staging / leftovers.NEW / "parts.csv").write_text("half a file")
    (tmp_path / "kept.txt").write_text("of somebody else")
    killed_at_once(monkeypatch, ["fabricate", "net.obj", f"--out={tmp_path}"])
    assert [path.name for path in tmp_path.iterdir()] == ["kept.txt"]


def killed_at_once(monkeypatch, arguments):
    killed = [sys.executable, "-c", "import os; os.kill(os.getpid(), 9)"]
    popen = subprocess.Popen
    monkeypatch.setattr(subprocess, "Popen", lambda command: popen(killed))
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        assert supervising.supervised(arguments) == 2
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def test_a_folder_that_cannot_be_cleared_is_named(tmp_path, monkeypatch, capsys):
    def sweep(target):
        if target == tmp_path:
            raise PermissionError(13, "Permission denied")

    module = SimpleNamespace(sweep=sweep)
    monkeypatch.setattr("freecad_ortho.cli.supervising._leftovers", lambda: module)
    killed_at_once(monkeypatch, ["fabricate", f"--out={tmp_path}"])
    said = capsys.readouterr().err.splitlines()
    assert f"error: {tmp_path}: cannot be cleared (Permission denied)" in said


def test_work_ends_when_its_command_is_killed_and_the_next_run_sweeps(fabrication):
    run, work, out = fabrication
    run.kill()
    run.wait()
    waited_for(lambda: not os.path.exists(f"/proc/{work}"))
    assert list(out.iterdir())
    leftovers.sweep(out)
    assert not list(out.iterdir())


def test_what_is_done_is_not_called_stopped():
    # Python sets its own handlers aside while it ends, so the process ends without that.
    script = (
        "import atexit, os, runpy, signal\n"
        "from freecad_ortho.cli import commands\n"
        "commands.run = lambda: 0\n"
        "end = os._exit\n"
        "def stopped(code):\n"
        "    os.kill(os.getpid(), signal.SIGTERM)\n"
        "    os.kill(os.getpid(), signal.SIGINT)\n"
        "    end(code)\n"
        "os._exit = stopped\n"
        "atexit.register(lambda: print('ended by itself'))\n"
        "runpy.run_module('freecad_ortho.cli.__main__', run_name='__main__')\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, timeout=60
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_a_run_is_not_stopped_once_its_files_are_moved_into_place(tmp_path):
    mesh = tmp_path / "one.obj"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n")
    script = (
        "import os, runpy, signal\n"
        "from solver.io import atomic\n"
        "move = atomic._move_all\n"
        "def stopped(*arguments):\n"
        "    os.kill(os.getpid(), signal.SIGTERM)\n"
        "    move(*arguments)\n"
        "    os.kill(os.getpid(), signal.SIGINT)\n"
        "atomic._move_all = stopped\n"
        "runpy.run_module('freecad_ortho.cli.__main__', run_name='__main__', alter_sys=True)\n"
    )
    command = [sys.executable, "-c", script, "fabricate", str(mesh), "--unit", "m"]
    done = subprocess.run(
        [*command, "--system", "panels", "-o", str(tmp_path / "out")],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("1 panel, ")
    assert (tmp_path / "out" / "report.json").is_file()


def test_a_run_that_was_killed_while_its_files_were_moved_is_finished_and_says_so(
    tmp_path, monkeypatch, capsys
):
    staging = tmp_path / f"{leftovers.STAGING}a1b2c3d4"
    (staging / leftovers.NEW).mkdir(parents=True)
    (staging / leftovers.NEW / "parts.csv").write_text("whole")
    leftovers.begin(staging, [Path("parts.csv")], [])

    class Killed:
        returncode = -signal.SIGKILL

        def __enter__(self):
            return self

        def __exit__(self, *_):
            pass

        def wait(self):
            raise KeyboardInterrupt

    monkeypatch.setattr(subprocess, "Popen", lambda command: Killed())
    monkeypatch.setattr(supervising, "ended", lambda work: False)
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        assert supervising.supervised(["fabricate", "net.obj", f"--out={tmp_path}"]) == 1
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
    assert capsys.readouterr().err == endings.ALL_WRITTEN
    assert [path.name for path in tmp_path.iterdir()] == ["parts.csv"]


def test_a_command_that_writes_within_this_process_lets_ctrl_c_come_again(tmp_path):
    before = [signal.getsignal(number) for number in endings.ENDING_SIGNALS]
    words = ["primitive", "rectangle", "--sampling", "3x3", "-o", str(tmp_path / "net.obj")]
    assert main(words) == 0
    assert [signal.getsignal(number) for number in endings.ENDING_SIGNALS] == before


def test_a_command_that_ends_well_was_not_killed(capfd):
    assert supervising.supervised(["check", "--help"]) == 0
    assert "killed" not in capfd.readouterr().err
