"""What lower rooms ask for and only higher ones can do: these say so, and are found here.

So a double click on a net opens its panel, though the view that is clicked knows no panels. Loads
nothing, for FreeCAD's doors make promises here when it starts.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

_given: dict[str, Callable[..., Any]] = {}
_promised: list[str] = []


def give(what: str, answer: Callable[..., Any]) -> None:
    """Say who does something, by what is asked."""
    _given[what] = answer


def promise(module: str) -> None:
    """Name a module that gives answers once it is loaded, which is when the first is asked for."""
    if module not in _promised:
        _promised.append(module)


def ask(what: str, *arguments: Any) -> Any:
    """Have something done, and return what comes of it.

    Raises:
        LookupError: nobody said that they do it.
    """
    while what not in _given and _promised:
        import_module(_promised.pop(0))
    if what not in _given:
        raise LookupError(f"{what}: nothing that is loaded does this; choose the workbench Ortho")
    return _given[what](*arguments)
