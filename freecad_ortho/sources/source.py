"""What a source of nets asks for and gives."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from solver.errors import InputError
from solver.mesh.quadmesh import FloatArray, QuadMesh
from solver.option import NUMBERS, Option


@dataclass(frozen=True, eq=False)
class Made:
    """What a source has made.

    Attributes:
        mesh: the net, in mm.
        remarks: what a user should know about it, one sentence each.
    """

    mesh: QuadMesh
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Source:
    """One way to get a net.

    Attributes:
        name: unique among all sources.
        meaning: one sentence.
        options: what it asks for, in the order of a form.
        build: from the options by name (and ``meshes`` or ``patches``) to the net.
        needs: ``""``, ``net`` (one), ``nets`` (one or more) or ``faces`` (of CAD shapes).
    """

    name: str
    meaning: str
    options: tuple[Option, ...]
    build: Callable[..., Made]
    needs: str = ""

    @property
    def defaults(self) -> dict[str, Any]:
        """All options with their defaults."""
        return {option.name: option.default for option in self.options}

    def option(self, name: str) -> Option:
        """The option of a name.

        Raises:
            InputError: there is none.
        """
        for option in self.options:
            if option.name == name:
                return option
        known = ", ".join(option.name for option in self.options) or "no options"
        raise InputError(f"{self.name}: has {known}, not '{name}'; choose one of these")

    def make(self, given: Mapping[str, Any], **inputs: Any) -> Made:
        """Make the net from given options and the defaults of the others.

        Raises:
            InputError: an unknown option, or values that make no net.
        """
        for name, value in given.items():
            self._check(self.option(name), value)
        values = {**self.defaults, **given}
        for option in self.options:
            if option.kind == "points":
                values[option.name] = _points(option.name, values[option.name])
            elif option.kind == "placement":
                rotation, origin = (np.asarray(x, dtype=float) for x in values[option.name])
                values[option.name] = (rotation, origin)
        return self.build(**values, **inputs)

    def _check(self, option: Option, value: Any) -> None:
        if option.kind == "choice" and value not in option.choices:
            raise InputError(
                f"{option.name}: expected one of {', '.join(option.choices)}, got {value!r}"
            )
        plain, words = {"flag": (bool, "True or False"), "text": (str, "a text")}.get(
            option.kind, (object, "")
        )
        if not isinstance(value, plain):
            raise InputError(f"{option.name}: expected {words}, got {value!r}")
        if option.kind not in NUMBERS:
            return
        several = isinstance(option.default, tuple)
        count = len(option.default) if several else 1
        numbers = tuple(value) if several and isinstance(value, (tuple, list)) else (value,)
        if len(numbers) != count or not all(_is_number(item) for item in numbers):
            words = f"{count} numbers" if several else "a number"
            raise InputError(f"{option.name}: expected {words}, got {value!r}")
        if option.kind == "count" and not all(item == int(item) >= 0 for item in numbers):
            raise InputError(f"{option.name}: expected whole numbers from 0 on, got {value!r}")
        if option.kind == "length" and min(numbers) < 0:
            raise InputError(f"{option.name}: expected 0 mm or more, got {value!r}")


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e300


def _points(name: str, value: Any) -> FloatArray:
    try:
        return np.asarray(value, dtype=np.float64).reshape(-1, 3)
    except (TypeError, ValueError) as error:
        raise InputError(
            f"{name}: expected points of three numbers, got {str(value)[:40]}"
        ) from error
