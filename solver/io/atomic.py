"""Files that appear whole or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

from solver.errors import OutputError, cannot_be_written
from solver.io import leftovers


def write_text(path: str | os.PathLike[str], text: str) -> None:
    """Write beside the target, then rename; a file that was there gives its permissions.

    Raises:
        OutputError: the folder is missing or cannot be written.
    """
    target = Path(os.path.realpath(path))
    if target.exists() and not target.is_file():
        raise OutputError(f"{target}: is not an ordinary file; name another")
    temporary = None
    try:
        leftovers.sweep(target)
        handle, temporary = tempfile.mkstemp(
            leftovers.PART, leftovers.part_prefix(target), target.parent
        )
        with leftovers.locked(temporary):
            with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as stream:
                stream.write(text)
            os.chmod(temporary, target.stat().st_mode if target.exists() else 0o666 & ~_umask())
            os.replace(temporary, target)
        temporary = None
    except OSError as error:
        remedy = "choose a folder that exists and that you may write to"
        raise cannot_be_written(target, error, remedy) from error
    finally:
        if temporary is not None:
            Path(temporary).unlink(missing_ok=True)


@contextmanager
def staged_folder(target: str | os.PathLike[str], replaced: Iterable[str] = ()) -> Iterator[Path]:
    """Give a temporary folder whose files move into ``target`` only when the block succeeds.

    The move is one step: a run that is killed in the middle of it has it finished by the next one
    that writes here, and what one that was killed before leaves behind is removed then.

    Args:
        target: made when missing; files already in it or in its folders stay under other names.
        replaced: names of files in ``target`` that go then, written anew or not; folders that this
            leaves empty go too.

    Raises:
        OutputError: ``target`` cannot be made or written, or holds a folder where a file is to be
            or a file where a folder is to be.
    """
    folder = Path(target)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        leftovers.sweep(folder)
        staging = Path(tempfile.mkdtemp(prefix=leftovers.STAGING, dir=folder))
    except OSError as error:
        raise cannot_be_written(folder, error, "choose a folder that you may write to") from error
    try:
        with leftovers.locked(staging):
            try:
                (staging / leftovers.NEW).mkdir()
                yield staging / leftovers.NEW
                _move_all(staging, folder, replaced)
            finally:
                # Ctrl-C in the middle of the moves comes here too.
                leftovers.finish(staging, folder)
    except OutputError:
        raise
    except OSError as error:
        raise cannot_be_written(folder, error, "choose another folder") from error


@contextmanager
def no_new_folders_on_failure(target: Path) -> Iterator[None]:
    """Remove, where the block fails, what it made of a folder and those above it and left empty."""
    missing = [path for path in (target, *target.parents) if not path.exists()]
    try:
        yield
    except BaseException:
        for path in missing:
            try:
                path.rmdir()
            except OSError:
                break
        raise


def refuse_in_the_way(folder: Path, name: str | os.PathLike[str]) -> None:
    """Refuse to write a file where a folder is, or into a folder where a file is.

    Args:
        folder: that is written to.
        name: of the file, relative to it.

    Raises:
        OutputError: naming what is in the way.
    """
    path = folder / name
    if path.is_dir():
        raise OutputError(f"{path}: is a folder; remove it or choose another place")
    for above in path.parents[: len(Path(name).parts) - 1]:
        if above.is_file():
            raise OutputError(f"{above}: is a file; remove it or choose another place")


def _move_all(staging: Path, folder: Path, replaced: Iterable[str]) -> None:
    """Move all new files into a folder; where one cannot be moved, put everything back."""
    source, before = staging / leftovers.NEW, staging / "old"
    new = sorted(path.relative_to(source) for path in source.rglob("*") if path.is_file())
    old = [name for name in sorted(map(Path, replaced)) if (folder / name).is_file()]
    for name in new:
        refuse_in_the_way(folder, name)
    leftovers.begin(staging, new, old)
    moves: list[tuple[Path, Path]] = []
    made: list[Path] = []

    def move(source: Path, target: Path) -> None:
        missing = [path for path in target.parents if not path.exists()]
        for path in reversed(missing):
            path.mkdir()
            made.append(path)
        os.replace(source, target)
        moves.append((source, target))

    try:
        for name in dict.fromkeys([*old, *new]):
            if (folder / name).exists():
                move(folder / name, before / name)
        for name in new:
            move(source / name, folder / name)
    except OSError:
        for start, target in reversed(moves):
            os.replace(target, start)
        for path in reversed(made):
            path.rmdir()
        (staging / leftovers.JOURNAL).unlink()
        raise
    leftovers.remove_empty(folder, old)
    (staging / leftovers.JOURNAL).unlink()


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
