"""How functions of the macro API show the keywords that they take, and refuse others."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterable, Mapping
from functools import wraps
from typing import Any, ParamSpec, TypeVar

from freecad_ortho import keywords, option_keywords
from solver.errors import refuse_unknown

_P = ParamSpec("_P")
_R = TypeVar("_R")

_UNPACKED = re.compile(r"Unpack\[(\w+)\]")


class _Usual:
    """What stands for a default that is in a table."""

    def __repr__(self) -> str:
        return "..."


USUAL = _Usual()


class Written(str):
    """A type as it is written, which help shows without quotes."""

    def __repr__(self) -> str:
        return str(self)


def spelled_out(
    signature: inspect.Signature, known: Mapping[str, Any] | None = None
) -> inspect.Signature:
    """The signature, with the keywords of ``**settings: Unpack[Name]`` one by one.

    Args:
        signature: of a function whose annotations are texts.
        known: where the name may be found too.
    """
    others = list(signature.parameters.values())
    found = _UNPACKED.fullmatch(str(others[-1].annotation)) if others else None
    if found is None or others.pop().kind is not inspect.Parameter.VAR_KEYWORD:
        return signature
    places = (known or {}, vars(keywords), vars(option_keywords))
    names = next(place[found[1]] for place in places if found[1] in place)
    others = [one.replace(annotation=Written(one.annotation)) for one in others]
    single = [
        inspect.Parameter(
            name,
            inspect.Parameter.KEYWORD_ONLY,
            default=USUAL,
            annotation=Written(getattr(kind, "__forward_arg__", kind)),
        )
        for name, kind in names.__annotations__.items()
    ]
    return signature.replace(parameters=[*others, *single])


def listing_keywords(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """The function, which refuses a keyword that it does not have by listing those that it has.

    One that takes the settings of a table shows them as its own, and refuses others itself.

    Raises:
        InputError: from the function made, in one line.
    """
    signature = inspect.signature(function)
    parameters = signature.parameters.values()
    if any(one.kind is inspect.Parameter.VAR_KEYWORD for one in parameters):
        shown = spelled_out(signature, getattr(function, "__globals__", None))
        return function if shown is signature else _showing(function, shown)
    known = [one.name for one in parameters if one.kind is not inspect.Parameter.POSITIONAL_ONLY]

    @wraps(function)
    def listing(*arguments: _P.args, **settings: _P.kwargs) -> _R:
        refuse_unknown(function.__name__, settings, known)
        return function(*arguments, **settings)

    return listing


def _showing(function: Callable[_P, _R], signature: inspect.Signature) -> Callable[_P, _R]:
    """The function, with another signature in its help."""

    @wraps(function)
    def showing(*arguments: _P.args, **settings: _P.kwargs) -> _R:
        return function(*arguments, **settings)

    showing.__signature__ = signature  # type: ignore[attr-defined]
    return showing


def list_keywords(names: Iterable[str], module: dict[str, Any]) -> None:
    """Make functions of a module, by their names, refuse keywords in this way."""
    for name in names:
        if inspect.isfunction(module.get(name)):
            module[name] = listing_keywords(module[name])
