"""How functions of the macro API take keywords that they do not have."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from functools import wraps
from typing import Any

from solver.errors import refuse_unknown


def listing_keywords(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function, which refuses a keyword that it does not have by listing those that it has.

    One that takes any keywords refuses them itself.

    Raises:
        InputError: from the function made, in one line.
    """
    parameters = inspect.signature(function).parameters.values()
    if any(one.kind is inspect.Parameter.VAR_KEYWORD for one in parameters):
        return function
    known = [one.name for one in parameters if one.kind is not inspect.Parameter.POSITIONAL_ONLY]

    @wraps(function)
    def listing(*arguments: Any, **settings: Any) -> Any:
        refuse_unknown(function.__name__, settings, known)
        return function(*arguments, **settings)

    return listing


def list_keywords(names: Iterable[str], module: dict[str, Any]) -> None:
    """Make functions of a module, by their names, refuse keywords in this way."""
    for name in names:
        if inspect.isfunction(module.get(name)):
            module[name] = listing_keywords(module[name])
