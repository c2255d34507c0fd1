"""The one family of errors that a user of the solver can meet."""

from __future__ import annotations

import errno
from collections.abc import Iterable

_REMEDIES = {errno.ENAMETOOLONG: "choose a shorter name", errno.ENOSPC: "free some space"}


class OrthoError(Exception):
    """Base of every error that this project raises on purpose.

    The message is one line: what is wrong, where, and what to do.
    """


class InputError(OrthoError, ValueError):
    """Data or a parameter that the user gave cannot be used as it is."""


class OutputError(OrthoError, OSError):
    """A result could not be written; nothing half-written is left behind."""


def cannot_be_written(place: object, error: OSError, remedy: str) -> OutputError:
    """The error for a file or folder that the system refuses, in the system's own words.

    Args:
        place: the file or folder.
        error: what the system said.
        remedy: what to do, where the system's words do not tell.
    """
    remedy = _REMEDIES.get(error.errno or 0, remedy)
    return OutputError(f"{place}: cannot be written ({error.strerror or error}); {remedy}")


class SingularSystemError(OrthoError):
    """A linear system could not be solved; the solver answers with more damping."""


def refuse_unknown(where: str, given: Iterable[str], known: Iterable[str]) -> None:
    """Refuse names of settings that there are not.

    Args:
        where: what was to take them: a function, a system, a source.
        given: the names.
        known: those that it takes.

    Raises:
        InputError: naming the first that is unknown, and all that are known.
    """
    right = list(known)
    for name in given:
        if name not in right:
            there = ", ".join(right) or "none"
            raise InputError(f"{where}: has no '{name}'; it has {there}")
