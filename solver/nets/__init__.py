"""One recipe a net: the terms that must vanish."""

from __future__ import annotations

from collections.abc import Callable

from solver.nets.orthogonal import orthogonal
from solver.nets.principal import principal
from solver.problem import Problem

RECIPES: dict[str, Callable[[Problem], Problem]] = {
    "orthogonal": orthogonal,
    "principal": principal,
}
