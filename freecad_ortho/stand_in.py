"""What stands for a function on documents where there is no FreeCAD: its help, and a word."""

from __future__ import annotations

import ast
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

from solver.errors import OrthoError

_FOLDER = Path(__file__).parent / "documents"


def stand_in(name: str) -> Callable[..., NoReturn]:
    """A function with the name and the help of one in ``documents``, which cannot be loaded.

    Calling it raises OrthoError.
    """

    def function(*arguments: object, **settings: object) -> NoReturn:
        raise OrthoError(
            f"{name}: works on documents of FreeCAD, which this Python has not; run it there, or "
            "with freecadcmd"
        )

    function.__name__ = function.__qualname__ = name
    function.__module__ = "freecad_ortho.documents"
    function.__doc__ = _help(name)
    return function


def _help(name: str) -> str:
    """Arguments and docstring, read from the source."""
    for path in sorted(_FOLDER.glob("*.py")):
        for item in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(item, ast.FunctionDef) and item.name == name:
                return f"{name}({ast.unparse(item.args)})\n\n{ast.get_docstring(item)}"
    raise LookupError(name)
