"""Files that an optional library reads, in a process of its own; needs no FreeCAD."""

from __future__ import annotations

import os
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from solver.errors import InputError
from solver.isolated import Isolated, LibraryError

# A bad file may make compiled code hang.
_SECONDS = 120.0


@dataclass(frozen=True)
class FileLibrary:
    """A library that reads files of one kind.

    Attributes:
        module: what is imported of it.
        package: its name where it is installed from.
        files: what its files are called.
        instead: formats to export where it does not read a file.
        remark: about the package, behind how it is installed.
    """

    module: str
    package: str
    files: str
    instead: str
    remark: str = ""

    def call(self, reader: type, method: str, name: str) -> Any:
        """What a method of a reader finds in a file.

        Args:
            reader: of this library; made in the other process.
            method: its name; it takes the path.
            name: of the file.

        Raises:
            InputError: no such file, the library missing, or a file that it cannot read.
        """
        if not Path(name).is_file():
            raise InputError(f"{name}: no such file; check the path")
        if find_spec(self.module) is None:
            raise InputError(
                f"{name}: reading {self.files} files needs the package '{self.package}'; install "
                f"it ('pip install {self.package}'{self.remark}) or export {self.instead}"
            )
        with Isolated(reader) as library:
            try:
                return library.call(method, os.path.abspath(name), time_limit=_SECONDS)
            except LibraryError as error:
                raise InputError(
                    f"{name}: cannot be read ({error}); export {self.instead}"
                ) from None
