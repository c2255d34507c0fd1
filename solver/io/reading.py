"""Contents of files, or one line that says why there are none."""

from __future__ import annotations

import codecs
import os
from pathlib import Path

from solver.errors import InputError


def read_bytes(path: str | os.PathLike[str]) -> bytes:
    """Bytes of a file, without the byte order mark that some programs put first.

    Raises:
        InputError: no such file, or it cannot be read.
    """
    name = os.fspath(path)
    try:
        return Path(name).read_bytes().removeprefix(codecs.BOM_UTF8)
    except FileNotFoundError:
        raise InputError(f"{name}: no such file; check the path") from None
    except OSError as error:
        raise InputError(f"{name}: cannot be read ({error.strerror}); check the path") from None


def read_text(path: str | os.PathLike[str]) -> str:
    """Text of a file, lines ended by a line feed alone.

    Raises:
        InputError: no such file, or it cannot be read.
    """
    text = read_bytes(path).decode("utf-8", errors="replace")
    return text.replace("\r\n", "\n").replace("\r", "\n")
