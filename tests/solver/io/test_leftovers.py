"""What killed runs leave: whole or nothing, finished or swept; what is alive or foreign stays."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

import pytest

from solver.io import atomic, leftovers
from solver.io.atomic import staged_folder, write_text

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="needs processes to be killed")
OLD = {"a.txt": "old a", "gone.txt": "old gone", "lists/c.txt": "old c"}
NEW = {"a.txt": "new a", "b.txt": "new b", "sheets/d.txt": "new d"}
MINE = {"mine.txt": "mine", ".staging-notmine1/mine.txt": "mine", ".a.txt.mine.part": "mine"}


def put(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def content(folder: Path) -> dict[str, str]:
    return {
        path.relative_to(folder).as_posix(): path.read_text()
        for path in folder.rglob("*")
        if path.is_file()
    }


def killed(work, at: int) -> bool:
    """Do some work in another process that is killed before it calls os.replace once more."""
    child = os.fork()
    if child == 0:
        count, replace = [0], os.replace

        def deadly(*arguments):
            if count[0] == at:
                os.kill(os.getpid(), signal.SIGKILL)
            count[0] += 1
            replace(*arguments)

        os.replace = deadly
        try:
            work()
        finally:
            os._exit(0)
    return os.WIFSIGNALED(os.waitpid(child, 0)[1])


def test_a_swap_that_is_killed_anywhere_happens_whole_or_not_at_all(tmp_path):
    ends = []
    for at in range(20):
        folder = tmp_path / str(at)
        put(folder, {**OLD, **MINE})

        def work(folder=folder):
            with staged_folder(folder, ["gone.txt", "lists/c.txt"]) as staging:
                put(staging, NEW)

        was_killed = killed(work, at)
        leftovers.sweep(folder)
        found = content(folder)
        assert found in ({**OLD, **MINE}, {**NEW, **MINE}), f"killed before step {at}"
        assert not (folder / "lists").exists() or found == {**OLD, **MINE}
        ends.append(found == {**NEW, **MINE})
        if not was_killed:
            break
    # One step before the first move decides; three old and three new files are moved after it.
    assert ends == [False] + [True] * 7


def test_the_next_run_finishes_what_was_begun_and_takes_it_for_the_earlier_one(tmp_path):
    put(tmp_path, OLD)

    def work():
        with staged_folder(tmp_path, OLD) as staging:
            put(staging, NEW)

    assert killed(work, 3)
    with staged_folder(tmp_path, ["b.txt"]) as staging:
        assert content(tmp_path).items() >= NEW.items()
        put(staging, {"a.txt": "newer"})
    assert content(tmp_path) == {"a.txt": "newer", "sheets/d.txt": "new d"}


def test_a_file_that_was_being_written_is_swept_by_the_next_run(tmp_path):
    target = tmp_path / "mesh.obj"
    put(tmp_path, {"mesh.obj": "old", **MINE})
    assert killed(lambda: write_text(target, "new"), 0)
    assert len(content(tmp_path)) == len(MINE) + 2
    write_text(target, "newer")
    assert content(tmp_path) == {"mesh.obj": "newer", **MINE}


def test_nothing_is_swept_that_a_live_run_uses(tmp_path):
    with staged_folder(tmp_path) as staging:
        put(staging, NEW)
        with staged_folder(tmp_path) as other:
            put(other, {"e.txt": "new e"})
        leftovers.sweep(tmp_path)
        assert content(staging) == NEW
    assert content(tmp_path) == {**NEW, "e.txt": "new e"}


def test_a_file_that_is_being_written_is_left_alone(tmp_path, monkeypatch):
    target = tmp_path / "mesh.obj"

    def swept(path, mode):
        leftovers.sweep(target)
        return chmod(path, mode)

    chmod = os.chmod
    monkeypatch.setattr(atomic.os, "chmod", swept)
    write_text(target, "new")
    assert content(tmp_path) == {"mesh.obj": "new"}


def test_what_is_empty_may_belong_to_a_run_that_begins(tmp_path):
    begun = tmp_path / ".staging-abcd1234"
    begun.mkdir()
    leftovers.sweep(tmp_path)
    assert begun.is_dir()
    long_ago = time.time() - 3600
    os.utime(begun, (long_ago, long_ago))
    leftovers.sweep(tmp_path)
    assert not begun.exists()


def test_ctrl_c_in_the_middle_of_a_swap_does_not_leave_half_of_it(tmp_path, monkeypatch):
    put(tmp_path, OLD)
    replace, count = os.replace, [0]

    def interrupted(*arguments):
        replace(*arguments)
        count[0] += 1
        if count[0] == 4:
            raise KeyboardInterrupt

    monkeypatch.setattr(atomic.os, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt), staged_folder(tmp_path, OLD) as staging:
        put(staging, NEW)
    assert content(tmp_path) == NEW
