"""What a build has done, stage by stage, as the report in its folder tells.

A stage has a key: all that it is made from. While that stays the same, and so do the files that it
has written, it need not be made again.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from freecad_ortho import __version__
from freecad_ortho.fabrication.files import REPORT, earlier
from solver.io.atomic import staged_folder, write_text
from solver.io.reading import read_bytes

ALIGN, OPTIMISE, FABRICATE = STAGES = ("align", "optimise", "fabricate")
_PAGE = "report.html"


def key_of(*made_from: object) -> str:
    """A name of all that a stage is made from, of this version of the program."""
    text = json.dumps([__version__, *made_from], sort_keys=True, default=str)
    return hashlib.sha256(text.encode()).hexdigest()


def digest(path: str | Path) -> str:
    """What tells the bytes of a file from others.

    Raises:
        InputError: no such file, or one that cannot be read.
    """
    return hashlib.sha256(read_bytes(path)).hexdigest()


def files_among(settings: Mapping[str, Any]) -> dict[str, str]:
    """Digests of the files that settings name, as ``FILE`` or ``word:FILE@numbers``."""
    found = {}
    for value in settings.values():
        for text in value if isinstance(value, list) else [value]:
            whole = str(text).rpartition("@")[0] or str(text)
            for name in (str(text), whole, whole.partition(":")[2]):
                if name and Path(name).is_file():
                    found[name] = digest(name)
    return found


class Stages:
    """Stages of a build in a folder: those that hold as they were, and those that are made now."""

    def __init__(
        self, folder: Path, keys: Mapping[str, str], head: Mapping[str, Any], again: bool
    ) -> None:
        """Look at what the folder holds.

        Args:
            folder: of the build; it need not be there.
            keys: of the stages, by their names.
            head: what the report says of the build before its stages.
            again: hold on to nothing.
        """
        self.folder, self._keys, self._head = folder, keys, head
        self._told = _told(folder)
        self._done = {
            name: entry
            for name, entry in self._told.items()
            if not again and name in STAGES and self._holds(name, entry)
        }

    def entry(self, name: str) -> dict[str, Any] | None:
        """What is told of a stage that is done and still holds; else None."""
        return self._done.get(name)

    @contextmanager
    def made(self, name: str) -> Iterator[tuple[Path, dict[str, Any]]]:
        """Give a folder for the files of a stage, and an entry to be filled.

        Files and report appear together where the block succeeds, and with them goes whatever was
        made from what was there before.
        """
        with staged_folder(self.folder, self._outdated(name)) as staging:
            entry: dict[str, Any] = {}
            yield staging, entry
            names = sorted(path.name for path in staging.iterdir())
            self._enter(name, entry, staging, names)
            report = self._report(_read(self.folder) if FABRICATE in self._done else {})
            (staging / REPORT).write_text(_text(report), encoding="utf-8")

    def numbers(self) -> dict[str, Any]:
        """What the report tells of the stages before the parts."""
        return self._report({}, without=FABRICATE)

    def enter(self, name: str, entry: dict[str, Any], names: Iterable[str]) -> None:
        """Tell of a stage whose files, of these names, are in the folder already."""
        self._enter(name, entry, self.folder, names)
        write_text(self.folder / REPORT, _text(self._report(_read(self.folder))))

    def _holds(self, name: str, entry: Any) -> bool:
        if not isinstance(entry, dict) or entry.get("key") != self._keys[name]:
            return False
        files = entry.get("files")
        return isinstance(files, dict) and all(
            (self.folder / file).is_file() and digest(self.folder / file) == told
            for file, told in files.items()
        )

    def _outdated(self, name: str) -> Iterator[str]:
        """Files of later stages that are of something else; asked for when they are to go."""
        later = STAGES[STAGES.index(name) + 1 :]
        if OPTIMISE in later and OPTIMISE in self._told and OPTIMISE not in self._done:
            yield from ("net.json", "net.obj")
        if FABRICATE not in self._done:
            parts = list(earlier(self.folder))
            yield from [*parts, _PAGE] if parts else []

    def _enter(self, name: str, entry: dict[str, Any], where: Path, names: Iterable[str]) -> None:
        files = {file: digest(where / file) for file in names if file != REPORT}
        self._done[name] = {"key": self._keys[name], **entry, "files": files}

    def _report(self, others: dict[str, Any], without: str = "") -> dict[str, Any]:
        stages = {
            stage: self._done[stage] for stage in STAGES if stage in self._done and stage != without
        }
        return {"build": {**self._head, "stages": stages}} | {
            name: value for name, value in others.items() if name != "build"
        }


def _read(folder: Path) -> dict[str, Any]:
    """The report in a folder; nothing where there is none, or something else of that name."""
    try:
        report = json.loads((folder / REPORT).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return report if isinstance(report, dict) else {}


def _told(folder: Path) -> dict[str, Any]:
    """Entries of the stages in that report."""
    build = _read(folder).get("build")
    stages = build.get("stages") if isinstance(build, dict) else None
    return stages if isinstance(stages, dict) else {}


def _text(report: dict[str, Any]) -> str:
    return json.dumps(report, indent=2, allow_nan=False) + "\n"
