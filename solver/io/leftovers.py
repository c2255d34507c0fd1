"""What runs that were killed leave behind: told from what live runs use, finished or swept.

Temporary files and folders are locked by the run that made them, and a lock ends with its process.
Imports nothing but the standard library: it is loaded alone where there is no time for more.
"""

from __future__ import annotations

import glob
import json
import os
import re
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows has no such locks: there only age tells.
    fcntl = None  # type: ignore[assignment]

STAGING, JOURNAL, NEW = ".staging-", "journal.json", "new"
PART = ".part"
# As tempfile names them; a folder of somebody else has something else in it.
_RANDOM = re.compile(r"[a-z0-9_]{8}")
_INSIDE = {NEW, "old", JOURNAL, JOURNAL + PART}
# Seconds after which what is still empty, or where there are no locks anything, is given up.
_EMPTY, _UNLOCKED = 60.0, 86400.0


def part_prefix(target: Path) -> str:
    """How the names of files begin that are to become ``target``; they end in ``PART``."""
    return f".{target.name}."


@contextmanager
def locked(path: str | os.PathLike[str]) -> Iterator[None]:
    """Mark a temporary file or folder, still empty, as used until the block ends."""
    if fcntl is None:
        yield
        return
    handle = os.open(path, os.O_RDONLY)
    try:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            # A file system without locks: then age tells.
            pass
        yield
    finally:
        os.close(handle)


def sweep(target: str | os.PathLike[str]) -> bool:
    """Clear away what dead runs left of a file, or in a folder; finish a swap that had begun.

    Returns:
        Whether there was such a swap.

    Raises:
        OSError: the files of a swap cannot be moved.
    """
    finished = False
    path = Path(os.path.realpath(target))
    for part in _named(path.parent, part_prefix(path), PART):
        with _seized(part) as dead:
            if dead and part.is_file():
                part.unlink(missing_ok=True)
    for staging in _named(path, STAGING):
        with _seized(staging) as dead:
            if dead and staging.is_dir() and {each.name for each in staging.iterdir()} <= _INSIDE:
                finished = finish(staging, path) or finished
    return finished


def _named(folder: Path, begin: str, end: str = "") -> list[Path]:
    """What there is in a folder of a temporary name with that begin and end."""
    found = folder.glob(f"{glob.escape(begin)}*{glob.escape(end)}")
    last = -len(end) if end else None
    return [path for path in found if _RANDOM.fullmatch(path.name[len(begin) : last])]


def begin(staging: Path, new: list[Path], old: list[Path]) -> None:
    """Note what a swap is about to do, in one step: from here on it will be finished."""
    plan = {"new": [path.as_posix() for path in new], "old": [path.as_posix() for path in old]}
    draft = staging / f"{JOURNAL}{PART}"
    draft.write_text(json.dumps(plan), encoding="utf-8")
    os.replace(draft, staging / JOURNAL)


def finish(staging: Path, folder: Path) -> bool:
    """Bring a swap to its end where it has begun, and remove its staging folder.

    Returns:
        Whether it had begun.

    Raises:
        OSError: a file cannot be moved.
    """
    journal = staging / JOURNAL
    begun = journal.is_file()
    if begun:
        plan = json.loads(journal.read_text(encoding="utf-8"))
        new, old = ([Path(name) for name in plan[key]] for key in ("new", "old"))
        for name in new:
            if (staging / NEW / name).is_file():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                os.replace(staging / NEW / name, folder / name)
        for name in set(old) - set(new):
            (folder / name).unlink(missing_ok=True)
        remove_empty(folder, old)
        journal.unlink()
    shutil.rmtree(staging, ignore_errors=True)
    return begun


def remove_empty(folder: Path, names: list[Path]) -> None:
    """Remove folders that have lost the last of their files."""
    for name in names:
        for path in [folder / above for above in name.parents][:-1]:
            if path.is_dir() and not any(path.iterdir()):
                path.rmdir()


@contextmanager
def _seized(path: Path) -> Iterator[bool]:
    """Lock what a dead run left, so that no other run sweeps it too; false where one is alive."""
    try:
        empty = not (any(path.iterdir()) if path.is_dir() else path.stat().st_size)
        age = time.time() - path.stat().st_mtime
        handle = os.open(path, os.O_RDONLY) if fcntl is not None else None
    except OSError:
        # Gone meanwhile.
        yield False
        return
    if handle is None:
        yield age > _UNLOCKED
        return
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        # A run that has just made it has not locked it yet, and has put nothing into it either.
        free = not empty or age > _EMPTY
    except OSError:
        free = False
    try:
        yield free
    finally:
        os.close(handle)
