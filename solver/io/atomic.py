"""Files that appear whole or not at all."""

from __future__ import annotations

import errno
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from solver.errors import OutputError


def write_text(path: str | os.PathLike[str], text: str) -> None:
    """Write beside the target, then rename.

    Raises:
        OutputError: the folder is missing or cannot be written.
    """
    target = Path(os.path.realpath(path))
    if target.exists() and not target.is_file():
        raise OutputError(f"{target}: is not an ordinary file; name another")
    temporary = None
    try:
        handle, temporary = tempfile.mkstemp(prefix=f".{target.name}.", dir=target.parent)
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as stream:
            stream.write(text)
        os.chmod(temporary, 0o666 & ~_umask())
        os.replace(temporary, target)
    except OSError as error:
        if temporary is not None and os.path.exists(temporary):
            os.unlink(temporary)
        raise OutputError(
            f"{target}: cannot be written ({error.strerror}); choose a folder that exists and "
            "that you may write to"
        ) from error


@contextmanager
def staged_folder(target: str | os.PathLike[str]) -> Iterator[Path]:
    """Give a temporary folder whose files move into ``target`` only when the block succeeds.

    Files already in ``target`` under other names stay.

    Raises:
        OutputError: ``target`` cannot be made or written.
    """
    folder = Path(target)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        staging = Path(tempfile.mkdtemp(prefix=".staging-", dir=folder))
    except OSError as error:
        raise OutputError(
            f"{folder}: cannot be written ({error.strerror}); choose a folder that you may write to"
        ) from error
    try:
        yield staging
        _move_all(sorted(staging.iterdir()), folder)
    except OutputError:
        raise
    except OSError as error:
        remedy = "free some space" if error.errno == errno.ENOSPC else "choose another folder"
        raise OutputError(f"{folder}: cannot be written ({error.strerror}); {remedy}") from error
    finally:
        shutil.rmtree(staging, ignore_errors=True)


def _move_all(paths: list[Path], folder: Path) -> None:
    """Move files and folders into a folder; where one cannot be moved, put all back as it was."""
    kept: list[tuple[Path, Path | None]] = []
    try:
        for path in paths:
            target = folder / path.name
            old = None
            if target.exists():
                old = path.with_name(path.name + ".before")
                os.replace(target, old)
            kept.append((target, old))
            os.replace(path, target)
    except OSError:
        for target, old in reversed(kept):
            if old is not None:
                if target.is_dir():
                    shutil.rmtree(target)
                os.replace(old, target)
            elif target.is_dir():
                shutil.rmtree(target)
            elif target.exists():
                target.unlink()
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
