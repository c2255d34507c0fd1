"""What stands for a function on documents where there is no FreeCAD: its help, and a word."""

from __future__ import annotations

import ast
import inspect
from collections.abc import Callable
from pathlib import Path
from typing import Any, NoReturn

from freecad_ortho.calls import Written, spelled_out
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
    written = _written(name)
    function.__signature__ = spelled_out(_signature(written.args))  # type: ignore[attr-defined]
    function.__doc__ = ast.get_docstring(written)
    return function


def _written(name: str) -> ast.FunctionDef:
    """The function as its source has it."""
    for path in sorted(_FOLDER.glob("*.py")):
        for item in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(item, ast.FunctionDef) and item.name == name:
                return item
    raise LookupError(name)


def _signature(written: ast.arguments) -> inspect.Signature:
    """Arguments with their annotations as texts."""
    kinds = inspect.Parameter
    usual = [ast.literal_eval(item) for item in written.defaults]
    plain = [*written.posonlyargs, *written.args]
    needed = [kinds.empty] * (len(plain) - len(usual))
    found = []
    for number, (arg, default) in enumerate(zip(plain, [*needed, *usual], strict=True)):
        first = number < len(written.posonlyargs)
        kind = kinds.POSITIONAL_ONLY if first else kinds.POSITIONAL_OR_KEYWORD
        found.append(_parameter(arg, kind, default))
    for arg, given in zip(written.kwonlyargs, written.kw_defaults, strict=True):
        default = kinds.empty if given is None else ast.literal_eval(given)
        found.append(_parameter(arg, kinds.KEYWORD_ONLY, default))
    if written.kwarg is not None:
        found.append(_parameter(written.kwarg, kinds.VAR_KEYWORD, kinds.empty))
    return inspect.Signature(found)


def _parameter(arg: ast.arg, kind: Any, default: Any) -> inspect.Parameter:
    annotation = "" if arg.annotation is None else ast.unparse(arg.annotation)
    return inspect.Parameter(arg.arg, kind, default=default, annotation=Written(annotation))
