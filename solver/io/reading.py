"""Contents of files and the numbers in them, or one line that says why there are none."""

from __future__ import annotations

import codecs
import os
import re
from pathlib import Path

from solver.errors import InputError

_UTF16 = {codecs.BOM_UTF16_LE: "utf-16-le", codecs.BOM_UTF16_BE: "utf-16-be"}
_DECIMAL_COMMA = re.compile(r"[-+]?\d*,\d+(?:[eE][-+]?\d+)?")


def read_bytes(path: str | os.PathLike[str]) -> bytes:
    """Bytes of a file, without the byte order mark that some programs put first.

    Text in UTF-16 that has such a mark comes as UTF-8.

    Raises:
        InputError: no such file, or it cannot be read.
    """
    name = os.fspath(path)
    try:
        content = Path(name).read_bytes()
    except FileNotFoundError:
        raise InputError(f"{name}: no such file; check the path") from None
    except (OSError, ValueError) as error:
        # A path with a null character is no OSError.
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"{name}: cannot be read ({reason}); check the path") from None
    encoding = _UTF16.get(content[:2])
    if encoding is not None:
        return content[2:].decode(encoding, errors="replace").encode("utf-8", errors="replace")
    return content.removeprefix(codecs.BOM_UTF8)


def read_text(path: str | os.PathLike[str]) -> str:
    """Text of a file, lines ended by a line feed alone.

    Raises:
        InputError: no such file, it cannot be read, or it is no text.
    """
    content = read_bytes(path)
    if b"\0" in content[:1000]:
        raise InputError(
            f"{os.fspath(path)}: is not text (binary data, or UTF-16 without its mark); "
            "export as plain text"
        )
    text = content.decode("utf-8", errors="replace")
    return text.replace("\r\n", "\n").replace("\r", "\n")


class Decimals:
    """Turns the words of one file into numbers; decimal commas will do where all have them."""

    def __init__(self) -> None:
        self._commas = self._points = False

    def __call__(self, word: str) -> float:
        """The number.

        Raises:
            ValueError: the word is none.
        """
        if "," in word and _DECIMAL_COMMA.fullmatch(word):
            self._commas = True
            return float(word.replace(",", "."))
        self._points |= "." in word
        return float(_plain(word))

    def remarks(self, name: str) -> tuple[str, ...]:
        """What is to be said about the numbers of the file.

        Raises:
            InputError: some have decimal commas, others decimal points.
        """
        if not self._commas:
            return ()
        if self._points:
            raise InputError(
                f"{name}: some numbers have a decimal comma, others a decimal point; export again "
                "with points"
            )
        return ("the numbers have decimal commas; they were read as decimal points",)


def whole(word: str) -> int:
    """The whole number that a word is.

    Raises:
        ValueError: it is none.
    """
    return int(_plain(word))


def _plain(word: str) -> str:
    """The word, unless it is a number to Python only, such as 1_000."""
    if "_" in word:
        raise ValueError
    return word
